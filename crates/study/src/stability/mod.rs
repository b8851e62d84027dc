//! Chatter: how deep the cut may be at which speed.
//!
//! The regenerative cut F = -w(t) kappa [u(t) - u(t - T)], kappa = K_s gamma b, T the tooth period,
//! acts on the machine's G_rel; w is the number of teeth in the cut. Three ways to its limit:
//!
//! - [`lobes`]: w replaced by its mean (zero order); exact for a cut that never stops;
//! - [`interrupted`]: w as it is, by semi-discretisation; the reference;
//! - [`simulated`]: the running cut's own recursion, and whether a disturbance grows.
//!
//! [`chart`] puts them side by side over the speed. Where the structure is given as modes at the tool's tip
//! (`machine.tip_modes`), [`tip`] has the same three ways for it.

pub mod chart;
pub mod charted;
pub mod interrupted;
pub mod lobes;
pub mod simulated;
pub mod tip;

use crate::base::language::tr;
use crate::base::math;
use crate::base::settings::SettingError;
use crate::blocks::cutting::tool_path::radial_depth_mm;
use crate::blocks::cutting::workpiece::Workpiece;
use crate::models::structure::FiveMass;
use crate::models::structure::engagement::EngagementAngles;
use crate::models::structure::reduction::Reduction;
use crate::models::tool::Tool;
use crate::run::scenario::Scenario;

/// A cut on a machine, all but its speed and depth.
#[derive(Clone, Debug, PartialEq)]
pub struct StabilityCut {
    /// The machine.
    pub machine: FiveMass,
    /// The same, reduced.
    pub reduction: Reduction,
    /// The teeth's windows.
    pub engagement: EngagementAngles,
    /// Radial depth in mm and diameter of the cutter in mm that they follow from.
    pub radial_depth_mm: f64,
    /// Diameter of the cutter, mm.
    pub diameter_mm: f64,
    /// kappa per depth, K_s gamma, N/m per mm.
    pub stiffness_per_mm: f64,
}

impl StabilityCut {
    /// The scenario's machine with its cutter at its radial depth: that of the path, or the largest of its
    /// cuts' sections.
    ///
    /// # Errors
    /// As [`Reduction::new`]; a radial depth of 0 cuts nothing.
    pub fn new(scenario: &Scenario) -> Result<Self, SettingError> {
        let machine = FiveMass::new(&scenario.machine);
        let Tool { teeth, diameter_mm, .. } = scenario.tool;
        let settings = &scenario.machine;
        let radial_depth_mm = charted_radial_mm(scenario)?;
        Ok(Self {
            machine,
            reduction: Reduction::new(&machine)?,
            engagement: EngagementAngles::side_milling(teeth, radial_depth_mm, diameter_mm),
            radial_depth_mm,
            diameter_mm,
            stiffness_per_mm: settings.regeneration_n_m_mm(),
        })
    }

    /// The engagement in words: radial depth, cutter, window.
    #[must_use]
    pub fn engagement_text(&self) -> String {
        let Self { engagement, radial_depth_mm, diameter_mm, .. } = self;
        let teeth = engagement.teeth;
        let angle = engagement.angle_rad * (180.0 / math::PI);
        tr!(
            "R_D {radial:.2} mm of a cutter of {diameter} mm with {teeth} teeth: each cuts over {angle:.1} degrees",
            radial = *radial_depth_mm,
            diameter = *diameter_mm,
            teeth = teeth,
            angle = angle
        )
    }

    /// Tooth period in s at `speed_rpm`.
    #[must_use]
    pub fn period_s(&self, speed_rpm: f64) -> f64 {
        60.0 / (f64::from(self.engagement.teeth) * speed_rpm)
    }

    /// Depth in mm at which a cut of mean stiffness `stiffness_n_m` stands; infinite where the chip
    /// does not feel the displacement.
    #[must_use]
    pub fn depth_mm(&self, stiffness_n_m: f64) -> f64 {
        stiffness_n_m / (self.stiffness_per_mm * self.engagement.mean_teeth())
    }
}

/// The radial depth in mm of a scenario's cut: that of the path, or the largest of its cuts' sections.
///
/// # Errors
/// A radial depth of 0 cuts nothing.
fn charted_radial_mm(scenario: &Scenario) -> Result<f64, SettingError> {
    let (workpiece, outline) = (&scenario.workpiece, scenario.tool.outline());
    let radial_mm = if workpiece.cuts.is_empty() {
        widest_mm(workpiece)
    } else {
        let sections = workpiece.cuts.iter().flatten();
        let radial = sections.map(|[_, axial, wall]| radial_depth_mm(&outline, *axial, *wall));
        radial.fold(0.0, f64::max).min(outline.diameter_mm)
    };
    if radial_mm <= 0.0 {
        return Err(SettingError::Refused {
            path: "workpiece.radial_depth_mm".to_owned(),
            value: format!("{radial_mm} mm"),
            allowed: tr("above 0 mm for a stability chart").to_owned(),
        });
    }
    Ok(radial_mm)
}

/// The largest radial depth of the one path, mm.
fn widest_mm(workpiece: &Workpiece) -> f64 {
    // A step at the very start of the path replaces the first depth.
    let first = match workpiece.radial_steps.first() {
        Some([position_mm, _]) if *position_mm == 0.0 => 0.0,
        _ => workpiece.radial_depth_mm,
    };
    workpiece.radial_steps.iter().map(|step| step[1]).fold(first, f64::max)
}

/// Steps in which depths are tried upwards, as a factor.
const STEP: f64 = 1.1;
/// Evaluations that look for the top between two steps.
const TOP_EVALUATIONS: u32 = 14;

/// The least depth in mm whose `multiplier` exceeds 1, up to `highest_mm`, to 0.05 %: upwards from
/// a third of `start_mm`, then by bisection. Where the multiplier passes a maximum below 1, the top
/// is looked for between the steps: an interrupted cut has islands of instability.
fn least_unstable(
    start_mm: f64,
    highest_mm: f64,
    mut multiplier: impl FnMut(f64) -> f64,
) -> Option<f64> {
    let (mut earlier, mut last) = ((0.0, 0.0), (0.0, 0.0));
    let mut depth = start_mm / 3.0;
    // NaN and infinite depths end the search too.
    while depth > 0.0 && depth < highest_mm {
        let next = (depth, multiplier(depth));
        if next.1 > 1.0 {
            return Some(bisect(last.0, depth, multiplier));
        }
        if last.1 > earlier.1 && last.1 > next.1 {
            let top = unstable_top(earlier.0, next.0, &mut multiplier);
            if let Some(inside) = top {
                return Some(bisect(earlier.0, inside, multiplier));
            }
        }
        (earlier, last) = (last, next);
        depth *= STEP;
    }
    None
}

/// A depth between `low` and `high` with a multiplier above 1, if golden sections meet one.
fn unstable_top(
    mut low: f64,
    mut high: f64,
    multiplier: &mut impl FnMut(f64) -> f64,
) -> Option<f64> {
    const SECTION: f64 = 0.618_033_988_749_894_8;
    let mut evaluate = |depth: f64| (depth, multiplier(depth));
    let mut left = evaluate(high - SECTION * (high - low));
    let mut right = evaluate(low + SECTION * (high - low));
    for _ in 0..TOP_EVALUATIONS {
        if left.1.max(right.1) > 1.0 {
            return Some(if left.1 > 1.0 { left.0 } else { right.0 });
        }
        if left.1 > right.1 {
            (high, right) = (right.0, left);
            left = evaluate(high - SECTION * (high - low));
        } else {
            (low, left) = (left.0, right);
            right = evaluate(low + SECTION * (high - low));
        }
    }
    None
}

fn bisect(mut low: f64, mut high: f64, mut multiplier: impl FnMut(f64) -> f64) -> f64 {
    while high - low > 5e-4 * high {
        let middle = 0.5 * (low + high);
        if multiplier(middle) > 1.0 { high = middle } else { low = middle }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::settings::Value;

    fn cut(changes: &[(&str, Value)]) -> Result<StabilityCut, SettingError> {
        let mut scenario = Scenario::default();
        let changes = changes.iter().map(|(path, value)| ((*path).to_owned(), value.clone()));
        scenario.set_all(&changes.collect::<Vec<_>>())?;
        StabilityCut::new(&scenario)
    }

    #[test]
    fn the_chart_follows_radial_depth_and_cutter() {
        let any_mm = |cut: &StabilityCut| cut.depth_mm(lobes::at_any_speed(cut).stiffness_n_m);
        let papers = cut(&[]).unwrap();
        assert_eq!((papers.radial_depth_mm, papers.diameter_mm), (3.0, 16.0));
        assert!(papers.engagement_text().contains("51.3 degrees"), "{}", papers.engagement_text());
        let slot = cut(&[("workpiece.radial_depth_mm", Value::Float(16.0))]).unwrap();
        // The depth that never chatters falls as the mean number of teeth in the cut grows.
        let teeth = slot.engagement.mean_teeth() / papers.engagement.mean_teeth();
        assert!((teeth - 180.0 / 51.317_8).abs() < 1e-3, "{teeth}");
        assert!((any_mm(&papers) / any_mm(&slot) / teeth - 1.0).abs() < 1e-9);
        let square = cut(&[("tool.name", Value::Text("square-12-4".to_owned()))]).unwrap();
        assert_eq!((square.engagement.teeth, square.diameter_mm), (4, 12.0));
        // Twice the teeth, each over arccos(1 - 6/12) = 60 degrees.
        let teeth = square.engagement.mean_teeth() / papers.engagement.mean_teeth();
        assert!((teeth - 2.0 * 60.0 / 51.317_8).abs() < 1e-3, "{teeth}");
        assert!((any_mm(&papers) / any_mm(&square) / teeth - 1.0).abs() < 1e-9);
        assert_eq!(square.period_s(1000.0), 0.5 * papers.period_s(1000.0));
        let [slow, fast] = [papers, square].map(|cut| interrupted::limit_mm(&cut, 1500.0, 60.0));
        assert!((slow.unwrap() / fast.unwrap() - 1.0).abs() > 0.1, "{slow:?} {fast:?}");
    }

    #[test]
    fn the_depth_that_is_stable_at_every_speed_follows_the_radial_depth() {
        for (radial_mm, teeth, at_5_mm, at_17_mm) in
            [(3.0, 0.2851, 4.290, 1.151), (8.0, 0.5, 2.446, 0.656), (16.0, 1.0, 1.223, 0.328)]
        {
            for (quality, wanted_mm) in [(5.0, at_5_mm), (17.0, at_17_mm)] {
                let cut = cut(&[
                    ("workpiece.radial_depth_mm", Value::Float(radial_mm)),
                    ("machine.spindle_quality", Value::Float(quality)),
                ]);
                let cut = cut.unwrap();
                assert!((cut.engagement.mean_teeth() - teeth).abs() < 5e-5, "{radial_mm}");
                let found_mm = cut.depth_mm(lobes::at_any_speed(&cut).stiffness_n_m);
                // The published depths are rounded, and were found on a grid of frequencies.
                let near_mm = 5e-4 + 3e-4 * wanted_mm;
                assert!(
                    (found_mm - wanted_mm).abs() < near_mm,
                    "{radial_mm} Q {quality}: {found_mm}"
                );
                let said = cut.engagement_text();
                assert!(said.contains(&format!("R_D {radial_mm:.2} mm")), "{said}");
            }
        }
    }

    #[test]
    fn several_cuts_are_charted_for_their_widest_section_and_none_for_no_width() {
        let sections = vec![vec![[30.0, 2.0, 2.0], [30.0, 3.0, 1.0]]];
        let wide = cut(&[("workpiece.cuts", Value::from(sections))]).unwrap();
        assert!((wide.radial_depth_mm - (39.0_f64.sqrt() - 1.0)).abs() < 1e-12);
        let none = cut(&[("workpiece.radial_depth_mm", Value::Float(0.0))]).unwrap_err();
        assert!(none.to_string().contains("workpiece.radial_depth_mm"), "{none}");
    }

    #[test]
    fn the_least_unstable_depth_is_found_islands_included() {
        let plain = |depth: f64| depth / 7.3;
        assert!((least_unstable(3.0, 100.0, plain).unwrap() / 7.3 - 1.0).abs() < 1e-3);
        // An island from 4.98 to 5.02 mm, thinner than a step, before the shore at 20 mm.
        let island = |depth: f64| (1.02 - (depth - 5.0).abs()).max(depth / 20.0);
        assert!((least_unstable(3.0, 100.0, island).unwrap() / 4.98 - 1.0).abs() < 1e-3);
        let flat = |depth: f64| (0.99 - (depth - 5.0).abs()).max(depth / 20.0);
        assert!((least_unstable(3.0, 100.0, flat).unwrap() / 20.0 - 1.0).abs() < 1e-3);
        assert_eq!(least_unstable(3.0, 15.0, flat), None);
        assert_eq!(least_unstable(f64::INFINITY, 15.0, plain), None);
        assert_eq!(least_unstable(f64::NAN, 15.0, plain), None);
    }
}
