//! Wear over the tool's life: flank wear in three stages, and what it does to force and tooth.
//!
//! ```text
//! dx/dt = 1/T(vc, fz, ap)                                      fraction x of the life used
//! T     = T15 (vc/vc15)^(-1/n) (fz/fz0)^(-pf) (ap/ap0)^(-pa)   Taylor, extended
//! r(x)  = a_b (1 - exp(-x/x_b)) + a_s x + a_f (exp((x-1)/x_f) - exp(-1/x_f))
//! w(x)  = r(x)/r(1),  VB = VB_T w                              break-in, steady, accelerated
//! P     = P0 (1 + kappa w),  k3 = k30 (1 - alpha w)            force, stiffness of the tooth
//! c_pd  = rho_e K_sp b VB^2/(2 vc)                             process damping, off by default
//! ```
//!
//! The 2019 paper gives no law of wear. The form in three stages follows Zhu and Zhang, MSSP 115
//! (2019) 147; the 15-minute speed is the middle of a maker's range for milling steel with coated
//! inserts (130 to 190 m/min), n = 0.25 a usual value for carbide. All other numbers are chosen.
//!
//! Each of the four curves, w(x), P/P0 over w, k3/k30 over w, and T, can be a formula of one's own; VB = VB_T w is
//! a proportion, and process damping follows from it.

use super::Valued;
use super::formula_model::OwnFormula;
use crate::base::math;
use crate::models::formula_model::role;

role!(
    /// Wear over the fraction of the life that is used.
    WearOfLife, "formula_wear", &[""], "the fraction of the life used", "",
    r#"{"version":1,"formula":"0.4*x^0.5 + 0.6*x^4","output":{"name":"w","unit":""},"inputs":[{"name":"x","unit":"","low":0.001,"high":1.1}]}"#
);
role!(
    /// Factor of the wear on the force.
    ForceOfWear, "formula_wear_force", &[""], "the wear, 0 to 2", "",
    r#"{"version":1,"formula":"1 + 0.4*w + 0.3*w^2","output":{"name":"k","unit":""},"inputs":[{"name":"w","unit":"","low":0,"high":2}]}"#
);
role!(
    /// Factor of the wear on the stiffness of the tooth.
    StiffnessOfWear, "formula_wear_stiffness", &[""], "the wear, 0 to 2", "",
    r#"{"version":1,"formula":"1 - 0.1*w^2","output":{"name":"k","unit":""},"inputs":[{"name":"w","unit":"","low":0,"high":2}]}"#
);
role!(
    /// Life of the tool.
    LifeOfCut, "formula_tool_life", &["m/min", "mm", "mm"],
    "the cutting speed in m/min, feed per tooth in mm and axial depth in mm, in this order", "min",
    r#"{"version":1,"formula":"12*(v/160)^-3*(fz/0.1)^-0.5*(ap/2)^-0.2","output":{"name":"T","unit":"min"},"inputs":[{"name":"v","unit":"m/min","low":20,"high":300},{"name":"fz","unit":"mm","low":0.02,"high":0.4},{"name":"ap","unit":"mm","low":0.1,"high":8}]}"#
);

crate::choice! {
    /// What wears the tool in a run.
    pub enum WearModel {
        /// Nothing: the plant's wear factor holds throughout.
        Fixed = "fixed", "Fixed factor";
        /// The life of the tool passes while it cuts; multiplies the plant's wear factor.
        Life = "life", "Over the tool's life";
    }
}

crate::settings! {
    /// Wear over the life of the tool.
    pub struct WearSettings {
        /// Whether the tool wears in the run.
        model: WearModel = WearModel::Fixed, [], "", live, "Wear in the run";
        /// Fraction of its life that the tool has behind it when the run begins.
        used_life: f64 = 0.0, [0.0, 1.0], "", setup, "Life used at the start";
        /// Rate at which the tool's life passes, relative to the time of the run.
        time_scale: f64 = 1.0, [1.0, 100_000.0], "", live, "Wear speed-up";
        /// Life of the tool at the reference speed.
        taylor_life_min: f64 = 15.0, [1.0, 600.0], "min", live, "Life at reference speed";
        /// Cutting speed of the reference life.
        taylor_speed_m_min: f64 = 160.0, [20.0, 600.0], "m/min", live, "Reference speed";
        /// Exponent n of Taylor's equation v T^n = constant.
        taylor_exponent: f64 = 0.25, [0.1, 0.6], "", live, "Taylor exponent";
        /// Feed per tooth of the reference life.
        reference_feed_mm: f64 = 0.135, [0.01, 1.0], "mm", live, "Reference feed per tooth";
        /// The life falls with this power of the feed per tooth.
        feed_exponent: f64 = 0.8, [0.0, 2.0], "", live, "Exponent of feed";
        /// Axial depth of the reference life.
        reference_depth_mm: f64 = 2.0, [0.1, 10.0], "mm", live, "Reference depth";
        /// The life falls with this power of the axial depth.
        depth_exponent: f64 = 0.3, [0.0, 2.0], "", live, "Exponent of depth";
        /// Tool-life factor: life of this very tool over what Taylor's equation promises.
        tool_life_factor: f64 = 1.0, [0.2, 5.0], "", live, "Tool-life factor";
        /// Break-in: its part of the wear, before scaling.
        break_in_share: f64 = 0.25, [0.0, 2.0], "", live, "Break-in wear";
        /// Break-in: fraction of the life in which it fades.
        break_in_span: f64 = 0.04, [0.005, 0.5], "", live, "Break-in span";
        /// Steady wear: its part of the wear, before scaling.
        steady_share: f64 = 0.40, [0.01, 2.0], "", live, "Steady wear";
        /// Accelerated wear: its part of the wear, before scaling.
        failure_share: f64 = 0.35, [0.0, 2.0], "", live, "Accelerated wear";
        /// Accelerated wear: fraction of the life in which it grows by e.
        failure_span: f64 = 0.06, [0.01, 0.5], "", live, "Accelerated span";
        /// Width of the flank wear land at the end of life.
        flank_end_mm: f64 = 0.3, [0.05, 1.0], "mm", live, "Wear land at the end";
        /// Growth of the force over the life.
        force_growth: f64 = 0.6, [0.0, 3.0], "", live, "Force growth";
        /// Loss of the tooth's stiffness over the life.
        tooth_softening: f64 = 0.15, [0.0, 0.9], "", live, "Tooth softening";
        /// Indentation force of the wear land per volume, for process damping; 0 switches it off.
        indentation_n_mm3: f64 = 0.0, [0.0, 200_000.0], "N/mm3", live, "Process damping";
        /// Wear over the life as a formula of one's own, in place of the three stages: w, 0 for a new tool and 1 at
        /// the end of its life, over the fraction of the life used.
        curve: OwnFormula<WearOfLife> = OwnFormula::default(), [], "", live, "Wear over the life";
        /// Factor of the wear on the force as a formula of one's own over w, in place of the growth of the force.
        force_curve: OwnFormula<ForceOfWear> = OwnFormula::default(), [], "", live, "Force over the wear";
        /// Factor of the wear on the tooth's stiffness as a formula of one's own over w, in place of its loss.
        stiffness_curve: OwnFormula<StiffnessOfWear> = OwnFormula::default(), [], "", live, "Stiffness over the wear";
        /// Life of the tool in min as a formula of one's own of cutting speed, feed per tooth and axial depth, in
        /// place of Taylor's equation.
        life_curve: OwnFormula<LifeOfCut> = OwnFormula::default(), [], "", live, "Life over the cut";
        /// Adjusts the programmed speed, feed per tooth held, so that the tool reaches `life.tool_life_min`;
        /// the tool's life is predicted from the sound of the coupled machine.
        adjust_speed: bool = false, [], "", live, "Speed for the tool life";
    }
}

/// Wear beyond the end of life stops here: the edge is gone (chosen).
pub const WEAR_MAX: f64 = 2.0;

/// Least factor of the wear on the stiffness of a tooth: softer than that it is none (chosen).
const STIFFNESS_MIN: f64 = 0.01;
/// Least life that a formula of one's own is taken for, min (chosen).
const LIFE_MIN_MIN: f64 = 0.01;

/// Conditions of a cut, as far as they wear the tool.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WearCut {
    /// Cutting speed at the full diameter, m/min.
    pub cutting_speed_m_min: f64,
    /// Feed per tooth, mm.
    pub feed_per_tooth_mm: f64,
    /// Axial depth of cut, mm.
    pub axial_depth_mm: f64,
}

impl WearSettings {
    /// Wear before scaling, r(x); rises with x. Three stages after Zhu and Zhang (2019).
    fn raw(&self, x: f64) -> f64 {
        self.break_in_share * (1.0 - math::exp(-x / self.break_in_span))
            + self.steady_share * x
            + self.failure_share
                * (math::exp((x - 1.0) / self.failure_span) - math::exp(-1.0 / self.failure_span))
    }

    /// Wear w at the fraction `x` of the life: 0 for a new tool, 1 at its end, at most [`WEAR_MAX`].
    #[must_use]
    pub fn wear(&self, x: f64) -> f64 {
        self.wear_valued(x).value
    }

    /// The same, and whether the curve knows it: beyond [`WEAR_MAX`] the edge is gone, and nobody has measured
    /// what is left.
    #[must_use]
    pub fn wear_valued(&self, x: f64) -> Valued {
        let x = math::positive(x);
        let found = match self.curve.get() {
            Some(own) => own.at(&[x]),
            None => Valued::new(self.raw(x) / self.raw(1.0), true),
        };
        let wear = math::limit(found.value, 0.0, WEAR_MAX);
        Valued::new(wear, found.valid && wear < WEAR_MAX)
    }

    /// Width of the flank wear land in mm at wear `w`: VB = VB_T w (chosen).
    #[must_use]
    pub fn flank_mm(&self, w: f64) -> f64 {
        self.flank_end_mm * w
    }

    /// Factor of wear `w` on the force: 1 + kappa w (chosen; 2019 gives no law).
    #[must_use]
    pub fn force_factor(&self, w: f64) -> f64 {
        self.force_valued(w).value
    }

    /// The same, and whether the curve knows it; never negative.
    #[must_use]
    pub fn force_valued(&self, w: f64) -> Valued {
        match self.force_curve.get() {
            Some(own) => {
                let found = own.at(&[w]);
                Valued::new(math::positive(found.value), found.valid && found.value >= 0.0)
            }
            None => Valued::new(1.0 + self.force_growth * w, true),
        }
    }

    /// Factor of wear `w` on the stiffness of the tooth: 1 - alpha w, at least 0.01 (chosen): a tooth softer than
    /// that is none, and only alpha beyond 0.5 with wear beyond the end of life comes to it.
    #[must_use]
    pub fn stiffness_factor(&self, w: f64) -> f64 {
        self.stiffness_valued(w).value
    }

    /// The same, and whether the curve knows it.
    #[must_use]
    pub fn stiffness_valued(&self, w: f64) -> Valued {
        let found = match self.stiffness_curve.get() {
            Some(own) => own.at(&[w]),
            None => Valued::new(1.0 - self.tooth_softening * w, true),
        };
        Valued::new(found.value.max(STIFFNESS_MIN), found.valid)
    }

    /// Process damping between tooth and workpiece in N s/m at wear `w`: `engaged` is the mean
    /// number of engaged teeth, `width_mm` the width of cut. The form of Wu, Chiou and Liang; it grows as the
    /// speed falls, and a tool that stands cuts nothing that could damp.
    #[must_use]
    pub fn process_damping_n_s_m(
        &self,
        w: f64,
        engaged: f64,
        width_mm: f64,
        speed_m_min: f64,
    ) -> f64 {
        let volume_mm2 = width_mm * self.flank_mm(w) * self.flank_mm(w);
        if speed_m_min <= 0.0 {
            return 0.0;
        }
        let speed_m_s = speed_m_min / 60.0;
        // N/mm3 times mm3 is N; over m/s.
        engaged * self.indentation_n_mm3 * volume_mm2 / (2.0 * speed_m_s)
    }

    /// Life T in min that is usual for a tool at `cut`: by Taylor's equation, extended by feed and depth, or by the
    /// formula in its place; infinite where nothing is cut.
    #[must_use]
    pub fn usual_life_min(&self, cut: &WearCut) -> f64 {
        self.usual_life_valued(cut).value
    }

    fn taylor_min(&self, cut: &WearCut) -> f64 {
        let speed = math::positive(cut.cutting_speed_m_min) / self.taylor_speed_m_min;
        let feed = math::positive(cut.feed_per_tooth_mm) / self.reference_feed_mm;
        let depth = math::positive(cut.axial_depth_mm) / self.reference_depth_mm;
        if [speed, feed, depth].contains(&0.0) {
            return f64::INFINITY;
        }
        let factors = [
            math::pow(speed, -1.0 / self.taylor_exponent),
            math::pow(feed, -self.feed_exponent),
            math::pow(depth, -self.depth_exponent),
        ];
        let [by_speed, by_feed, by_depth] = factors;
        let life_min = self.taylor_life_min * by_speed * by_feed * by_depth;
        // As a spindle comes to rest the feed per tooth grows without bound while the speed vanishes: one
        // factor is then infinite and another nothing, and only their logarithms can be set off.
        if life_min.is_finite() && life_min > 0.0 {
            return life_min;
        }
        self.taylor_life_min
            * math::exp(
                -math::ln(speed) / self.taylor_exponent
                    - self.feed_exponent * math::ln(feed)
                    - self.depth_exponent * math::ln(depth),
            )
    }

    /// Life T in min of this very tool at `cut`.
    #[must_use]
    pub fn life_min(&self, cut: &WearCut) -> f64 {
        self.life_valued(cut).value
    }

    /// The same, and whether the curve knows it; infinite where nothing is cut.
    #[must_use]
    pub fn life_valued(&self, cut: &WearCut) -> Valued {
        let usual = self.usual_life_valued(cut);
        Valued { value: self.tool_life_factor * usual.value, ..usual }
    }

    /// [`Self::usual_life_min`], and whether the curve knows it.
    #[must_use]
    pub fn usual_life_valued(&self, cut: &WearCut) -> Valued {
        let WearCut { cutting_speed_m_min, feed_per_tooth_mm, axial_depth_mm } = *cut;
        let inputs = [cutting_speed_m_min, feed_per_tooth_mm, axial_depth_mm].map(math::positive);
        match self.life_curve.get() {
            Some(own) if !inputs.contains(&0.0) => {
                let found = own.at(&inputs);
                let enough = found.value >= LIFE_MIN_MIN;
                // Far beyond its range, where a spindle comes to rest, even a straight line has no end.
                let life_min = if enough { found.value } else { LIFE_MIN_MIN };
                Valued::new(life_min, found.valid && enough)
            }
            Some(_) | None => Valued::new(self.taylor_min(cut), true),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_curve_meets_the_reference_table() {
        let wear = WearSettings::default();
        for (x, w, flank_mm, force_n) in [
            (0.0, 0.0, 0.0, 107.0),
            (0.02, 0.106367345223, 0.0319, 113.829),
            (0.05, 0.198373831106, 0.0595, 119.736),
            (0.1, 0.269478842638, 0.0808, 124.301),
            (0.25, 0.349518677642, 0.1049, 129.439),
            (0.5, 0.450083186535, 0.1350, 135.895),
            (0.75, 0.555426337973, 0.1666, 142.658),
            (0.9, 0.676106454403, 0.2028, 150.406),
            (0.95, 0.782109368562, 0.2346, 157.211),
            (1.0, 1.0, 0.3, 171.2),
        ] {
            let now = wear.wear(x);
            assert!((now - w).abs() < 1e-12, "w({x}) = {now}");
            assert!((wear.flank_mm(now) - flank_mm).abs() < 5.1e-5);
            assert!((107.0 * wear.force_factor(now) - force_n).abs() < 5.1e-4);
        }
    }

    #[test]
    fn process_damping_grows_as_the_speed_falls_and_a_standing_tool_has_none() {
        let wear = WearSettings { indentation_n_mm3: 5e4, ..WearSettings::default() };
        let damping = |speed_m_min| wear.process_damping_n_s_m(0.5, 1.0, 2.0, speed_m_min);
        for speed_m_min in [0.1, 0.5, 1.0, 80.0] {
            let ratio = damping(speed_m_min) / damping(2.0 * speed_m_min);
            assert!((ratio - 2.0).abs() < 1e-12, "{speed_m_min}: {ratio}");
        }
        assert_eq!(damping(0.0), 0.0);
    }

    #[test]
    fn wear_only_grows_and_stops_once_the_edge_is_gone() {
        let wear = WearSettings::default();
        let curve: Vec<f64> = (0..=1500).map(|i| wear.wear(f64::from(i) / 1000.0)).collect();
        assert!(curve.windows(2).all(|pair| pair[0] <= pair[1]));
        assert_eq!(curve[1500], WEAR_MAX);
        assert_eq!(wear.wear(f64::NAN), 0.0);
        assert_eq!(wear.wear(f64::INFINITY), WEAR_MAX);
    }

    #[test]
    fn the_life_at_the_papers_cut_is_four_hours() {
        let wear = WearSettings::default();
        let cut =
            WearCut { cutting_speed_m_min: 80.0, feed_per_tooth_mm: 0.135, axial_depth_mm: 2.0 };
        assert!((wear.taylor_min(&cut) - 240.0).abs() < 1e-10);
        let half = WearCut { cutting_speed_m_min: 160.0, ..cut };
        assert!((wear.taylor_min(&half) - 15.0).abs() < 1e-12);
        let air = WearCut { axial_depth_mm: 0.0, ..cut };
        assert_eq!(wear.taylor_min(&air), f64::INFINITY);
        let better = WearSettings { tool_life_factor: 1.5, ..wear };
        assert!((better.life_min(&cut) - 360.0).abs() < 1e-10);
    }

    #[test]
    fn process_damping_has_the_reference_size() {
        // K_sp = 4e13 N/m3, two teeth over 51.3 degrees: 770 N s/m at the end of life.
        let wear = WearSettings { indentation_n_mm3: 4e4, ..WearSettings::default() };
        let damping = wear.process_damping_n_s_m(1.0, 0.285, 2.0, 80.0);
        assert!((damping - 770.0).abs() < 1.0, "{damping}");
    }
}
