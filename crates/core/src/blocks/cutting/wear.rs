//! The tool wears while it cuts: the fraction of its life that is used, a state.
//!
//! ```text
//! x += time_scale dt / T(vc, fz, ap)      in the cut;  factor on the force = 1 + kappa w(x)
//! ```

use crate::base::math;
use crate::base::units::s_from_min;
use crate::models::tool::Tool;
use crate::models::wear::{WEAR_MAX, WearCut, WearModel, WearSettings};

/// The tool with the fraction of its life that is used.
#[derive(Clone, Debug)]
pub struct ToolWear {
    settings: WearSettings,
    tool: Tool,
    used_life: f64,
    /// Wear land that jumps have added, mm.
    jumped_mm: f64,
    /// Whether the life at the present cut is one that its curve knows.
    life_is_known: bool,
}

impl ToolWear {
    /// The tool as it is at the start of the run.
    #[must_use]
    pub fn new(settings: &WearSettings, tool: &Tool) -> Self {
        let used_life = settings.used_life;
        Self {
            settings: settings.clone(),
            tool: tool.clone(),
            used_life,
            jumped_mm: 0.0,
            life_is_known: true,
        }
    }

    /// Takes the wear land in mm that jumps have added so far.
    pub fn jump(&mut self, jumped_mm: f64) {
        self.jumped_mm = jumped_mm;
    }

    /// Takes over changed settings; the tool stays as worn as it is.
    pub fn reconfigure(&mut self, settings: &WearSettings) {
        self.settings = settings.clone();
    }

    /// Fraction of the life that is used: 1 at its end.
    #[must_use]
    pub fn used_life(&self) -> f64 {
        self.used_life
    }

    /// Whether the tool wears in the run.
    fn wears(&self) -> bool {
        self.settings.model == WearModel::Life
    }

    /// Whether its wear counts: it wears in the run, or has jumped.
    fn is_worn(&self) -> bool {
        self.wears() || self.jumped_mm > 0.0
    }

    /// Wear w, what has jumped included; 0 where the tool neither wears in the run nor has jumped.
    fn wear(&self) -> f64 {
        let passed = if self.wears() { self.settings.wear(self.used_life) } else { 0.0 };
        if self.jumped_mm > 0.0 {
            math::limit(passed + self.jumped_mm / self.settings.flank_end_mm, 0.0, WEAR_MAX)
        } else {
            passed
        }
    }

    /// Whether wear, force and life are such as their curves know: beyond
    /// [`WEAR_MAX`] the edge is gone, and nobody has measured what is left.
    #[must_use]
    pub fn is_known(&self) -> bool {
        let wear = || self.settings.wear_valued(self.used_life);
        let force = || self.settings.force_valued(self.wear());
        let jumped = self.jumped_mm > 0.0;
        (!self.wears() || (self.life_is_known && wear().valid && force().valid))
            && (!jumped || (self.wear() < WEAR_MAX && force().valid))
    }

    /// Factor on the force; 1 where the tool neither wears in the run nor has jumped.
    #[must_use]
    pub fn force_factor(&self) -> f64 {
        if self.is_worn() { self.settings.force_factor(self.wear()) } else { 1.0 }
    }

    /// Factor on the stiffness of the tooth; 1 where the tool neither wears in the run nor has jumped.
    #[must_use]
    pub fn stiffness_factor(&self) -> f64 {
        if self.is_worn() { self.settings.stiffness_factor(self.wear()) } else { 1.0 }
    }

    /// Process damping in N s/m of a tooth in the cut at an axial depth in mm and a speed in 1/min.
    #[must_use]
    pub fn damping_n_s_m(&self, axial_depth_mm: f64, speed_rpm: f64) -> f64 {
        let speed_m_min = self.tool.cutting_speed_m_min(speed_rpm);
        self.settings.process_damping_n_s_m(self.wear(), 1.0, axial_depth_mm, speed_m_min)
    }

    /// Lets `dt_s` of cutting pass at feed in mm/min, speed in 1/min and axial depth in mm; in the
    /// air the depth is 0, and nothing wears.
    pub fn update(&mut self, feed_mm_min: f64, speed_rpm: f64, axial_depth_mm: f64, dt_s: f64) {
        if self.settings.model == WearModel::Fixed || speed_rpm <= 0.0 {
            return;
        }
        let cut = WearCut {
            cutting_speed_m_min: self.tool.cutting_speed_m_min(speed_rpm),
            feed_per_tooth_mm: self.tool.feed_per_tooth_mm(feed_mm_min, speed_rpm),
            axial_depth_mm,
        };
        let life = self.settings.life_valued(&cut);
        self.life_is_known = life.valid;
        let life_s = s_from_min(life.value);
        let used = self.used_life + self.settings.time_scale * dt_s / life_s;
        // What is worn stays worn, whatever is asked of the law.
        if used > self.used_life {
            self.used_life = used;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Feed for 0.135 mm per tooth at 80 m/min, and that speed.
    const SPEED_RPM: f64 = 80_000.0 / (math::PI * 16.0);
    const FEED_MM_MIN: f64 = 2.0 * 0.135 * SPEED_RPM;

    fn worn(settings: &WearSettings, minutes: u32) -> ToolWear {
        let mut tool = ToolWear::new(settings, &Tool::default());
        (0..minutes * 60).for_each(|_| tool.update(FEED_MM_MIN, SPEED_RPM, 2.0, 1.0));
        tool
    }

    #[test]
    fn a_life_passes_in_its_time_or_as_much_faster_as_wanted() {
        let life = WearSettings { model: WearModel::Life, ..WearSettings::default() };
        let tool = worn(&life, 120);
        assert!((tool.used_life() - 0.5).abs() < 1e-9);
        assert!((tool.force_factor() - 1.0 - 0.6 * 0.450083186535).abs() < 1e-8);
        let fast = WearSettings { time_scale: 240.0, ..life };
        assert!((worn(&fast, 1).force_factor() - 1.6).abs() < 1e-8);
    }

    #[test]
    fn a_tool_without_an_edge_is_beyond_the_curve_and_its_time_still_counts() {
        let life = WearSettings { model: WearModel::Life, ..WearSettings::default() };
        let ended = WearSettings { used_life: 1.0, ..life.clone() };
        assert!(ToolWear::new(&ended, &Tool::default()).is_known());
        let fast = WearSettings { time_scale: 240.0 * 5.0, ..life };
        let tool = worn(&fast, 1);
        assert!((tool.used_life() - 5.0).abs() < 1e-6, "{}", tool.used_life());
        assert!(!tool.is_known());
        let fixed = WearSettings { model: WearModel::Fixed, ..fast };
        assert!(worn(&fixed, 1).is_known());
    }

    #[test]
    fn a_jump_of_the_wear_land_counts_whether_the_tool_wears_or_not() {
        // 0.15 of 0.3 mm are half of the wear, and half of the growth of the force.
        let fixed = WearSettings::default();
        let mut tool = ToolWear::new(&fixed, &Tool::default());
        tool.jump(0.15);
        assert!((tool.force_factor() - 1.3).abs() < 1e-12);
        assert!(tool.is_known() && tool.used_life() == 0.0);
        let life = WearSettings { model: WearModel::Life, used_life: 0.5, ..fixed };
        let mut worn = ToolWear::new(&life, &Tool::default());
        let before = worn.force_factor();
        worn.jump(0.15);
        assert!((worn.force_factor() - before - 0.3).abs() < 1e-12);
        worn.jump(5.0);
        assert!((worn.force_factor() - 2.2).abs() < 1e-12, "no more than an edge that is gone");
        assert!(!worn.is_known());
    }

    #[test]
    fn nothing_wears_in_the_air_or_with_a_fixed_factor() {
        let life =
            WearSettings { model: WearModel::Life, used_life: 0.3, ..WearSettings::default() };
        let mut tool = ToolWear::new(&life, &Tool::default());
        tool.update(FEED_MM_MIN, SPEED_RPM, 0.0, 600.0);
        tool.update(FEED_MM_MIN, 0.0, 2.0, 600.0);
        tool.update(0.0, SPEED_RPM, 2.0, 600.0);
        assert_eq!(tool.used_life(), 0.3);
        let fixed = worn(&WearSettings::default(), 60);
        assert_eq!((fixed.used_life(), fixed.force_factor()), (0.0, 1.0));
    }
}
