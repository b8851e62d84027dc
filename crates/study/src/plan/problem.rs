//! What is optimised: the force surface of the network over cutting speed and feed per tooth, cut
//! off by the seven constraints, and the weighted objective on it.
//!
//! ```text
//! J = (w_F (F/F_max + 0.1 Q/Q_0) + w_Q Q/Q_0 + w_t t_0/t_p + w_C C_0/C) / sum w    -> max
//! Q = A_D R_D f    t_m = L / f    t_p = t_m (1 + t_ch/T)    C = t_m C_m + (t_m/T)(C_m t_ch + C_t)
//! ```
//!
//! Every term is a gain relative to a stated reference: the force to its limit, the others to the
//! same cut at the 2005 paper's 80 m/min and 0.08 mm per tooth (index 0). The tenth of Q breaks a
//! tie (chosen): for the force alone, all cutting speeds at which it reaches its limit are equal.

use super::constraints::{Bounds, Checked, bounds, check};
use super::cut::{CutAtPoint, Economy, REFERENCE, TABLE_2005, Yield};
use super::machine::MachineLimits;
use super::score::Score;
use super::surface::ForceSurface;
use crate::base::language::tr;
use crate::base::math;
use crate::base::settings::SettingError;
use crate::blocks::reference::desired_force;
use crate::models::plan::{ForceLimit, PlanSettings, PlannedSection};
use crate::models::tool::Tool;
use crate::run::scenario::Scenario;

/// Range of the cutting speed, m/min: the network's training range.
pub const CUTTING_SPEED_M_MIN: [f64; 2] = [40.0, 150.0];
/// Range of the feed per tooth, mm: the network's training range.
pub const FEED_PER_TOOTH_MM: [f64; 2] = [0.02, 0.2];
/// Fraction of the weight of force that goes to the removal rate, to break ties (chosen).
const TIE_BREAK: f64 = 0.1;
/// Least depth of cut that can be planned, mm: below it nothing is cut.
pub(super) const LEAST_DEPTH_MM: f64 = 0.01;

/// The optimisation problem of a scenario.
#[derive(Clone, Debug)]
pub struct Problem {
    tool: Tool,
    teeth: f64,
    surface: ForceSurface,
    axial_depth_mm: f64,
    radial_depth_mm: f64,
    economy: Economy,
    force_max_n: f64,
    bounds: [Bounds; 7],
    range: [[f64; 2]; 2],
    /// Spindle speed in 1/min at a cutting speed of 1 m/min.
    rpm_per_m_min: f64,
    /// Factor of (z f_z)^2 in the roughness.
    ra_factor: f64,
    /// Factor of 1 / (v_c^4 f_z^0.8) in the tool life.
    life_factor: f64,
    /// Factor of |F_y| v_c in the power.
    power_factor: f64,
    compliance_mm_n: f64,
    /// Weights divided by the references: of F, f (for Q, which is in proportion), 1/t_p and 1/C.
    weights: [f64; 4],
}

fn refused(path: &str, value: String, allowed: String) -> SettingError {
    SettingError::Refused { path: path.to_owned(), value, allowed }
}

/// Axial and radial depth in mm that the plan is made for: of the heaviest or the lightest cross-section.
fn planned_depths_mm(scenario: &Scenario) -> [f64; 2] {
    let workpiece = &scenario.workpiece;
    let none = [0.0, workpiece.radial_depth_mm];
    // Where only one of the depths changes it decides, whatever the other one is.
    let heavier = |a: &[f64; 2], b: &[f64; 2]| {
        (a[0] * a[1]).total_cmp(&(b[0] * b[1])).then(a[0].total_cmp(&b[0]))
    };
    let places = workpiece.places_mm().into_iter();
    let found = match scenario.plan.section {
        PlannedSection::Heaviest => places.max_by(heavier),
        PlannedSection::Lightest => places.filter(|place| place[0] > 0.0).min_by(heavier),
    };
    found.unwrap_or(none)
}

impl Problem {
    /// The problem of a scenario on a machine.
    ///
    /// # Errors
    /// The cut has no depth, all weights are zero, or cost is sought where nothing costs.
    pub fn new(scenario: &Scenario, machine: &MachineLimits) -> Result<Self, SettingError> {
        Self::at_depths(scenario, machine, planned_depths_mm(scenario))
    }

    /// The same at an axial and a radial depth in mm.
    ///
    /// # Errors
    /// See [`Self::new`].
    pub fn at_depths(
        scenario: &Scenario,
        machine: &MachineLimits,
        [axial_depth_mm, radial_depth_mm]: [f64; 2],
    ) -> Result<Self, SettingError> {
        let (plan, tool) = (&scenario.plan, &scenario.tool);
        for (path, depth) in [
            ("workpiece.axial_depth_mm", axial_depth_mm),
            ("workpiece.radial_depth_mm", radial_depth_mm),
        ] {
            if depth < LEAST_DEPTH_MM {
                let allowed = tr!("at least {least} mm for a plan", least = LEAST_DEPTH_MM);
                return Err(refused(path, format!("{depth} mm"), allowed));
            }
        }
        let force_max_n = match plan.force_limit {
            ForceLimit::Fixed => plan.force_max_n,
            ForceLimit::TargetRa => desired_force(&scenario.target, &scenario.believed()).value,
        };
        let speeds = match plan.free_speed {
            true => CUTTING_SPEED_M_MIN,
            false => [plan.cutting_speed_m_min; 2],
        };
        let mut problem = Self {
            tool: tool.clone(),
            teeth: f64::from(tool.teeth),
            surface: ForceSurface::new(scenario, [axial_depth_mm, radial_depth_mm]),
            axial_depth_mm,
            radial_depth_mm,
            economy: Economy {
                length_mm: scenario.workpiece.length_mm,
                section_mm2: axial_depth_mm * radial_depth_mm,
                machine_cost_per_min: plan.machine_cost_per_min,
                tool_cost: plan.tool_cost,
                tool_change_min: plan.tool_change_min,
            },
            force_max_n,
            bounds: bounds(&machine.within(&scenario.cnc), force_max_n),
            range: [speeds, FEED_PER_TOOTH_MM],
            rpm_per_m_min: tool.speed_rpm(1.0),
            ra_factor: 5.0 * 318.0 / (4.0 * tool.diameter_mm),
            life_factor: TABLE_2005.factor(axial_depth_mm),
            power_factor: 1.0 / (60_000.0 * machine.spindle_efficiency.value),
            compliance_mm_n: tool.bar_compliance_mm_n(),
            weights: [0.0; 4],
        };
        problem.weights = problem.weigh(plan)?;
        Ok(problem)
    }

    /// The weights divided by their references.
    fn weigh(&self, plan: &PlanSettings) -> Result<[f64; 4], SettingError> {
        let sum =
            plan.weight_force + plan.weight_removal_rate + plan.weight_time + plan.weight_cost;
        // A sum of subnormal weights has no reciprocal.
        if !(1.0 / sum).is_finite() {
            let allowed = tr(
                "above 0 for at least one of weight_force, weight_removal_rate, weight_time and weight_cost",
            );
            return Err(refused("plan.weight_force", sum.to_string(), allowed.to_owned()));
        }
        let cut = self.cut(REFERENCE);
        let reference = self.yield_of(&cut);
        if plan.weight_cost > 0.0 && !(1.0 / reference.cost).is_finite() {
            let allowed = tr("above 0, or `plan.tool_cost` above 0, where cost is sought");
            let value = plan.machine_cost_per_min.to_string();
            return Err(refused("plan.machine_cost_per_min", value, allowed.to_owned()));
        }
        Ok([
            plan.weight_force / sum / self.force_max_n,
            (plan.weight_removal_rate + TIE_BREAK * plan.weight_force) / sum / cut.feed_mm_min,
            plan.weight_time / sum * reference.production_min,
            plan.weight_cost / sum * reference.cost,
        ])
    }

    /// Everything that follows from a point (cutting speed in m/min, feed per tooth in mm).
    #[must_use]
    #[inline]
    pub fn cut(&self, [cutting_speed_m_min, feed_per_tooth_mm]: [f64; 2]) -> CutAtPoint {
        // (v_c^5 f_z)^(-4/5) is v_c^-4 f_z^-0.8, from one root.
        let squared = cutting_speed_m_min * cutting_speed_m_min;
        let root =
            math::inverse_fifth_root(squared * squared * cutting_speed_m_min * feed_per_tooth_mm);
        let root_squared = root * root;
        let speed_rpm = self.rpm_per_m_min * cutting_speed_m_min;
        let turn_mm = self.teeth * feed_per_tooth_mm;
        let feed_mm_min = turn_mm * speed_rpm;
        let components_n = self.surface.components_n(feed_mm_min, speed_rpm);
        let [x, y, _] = components_n;
        let force_n = (x * x + y * y).sqrt();
        CutAtPoint {
            speed_rpm,
            feed_mm_min,
            components_n,
            force_n,
            power_kw: y.abs() * cutting_speed_m_min * self.power_factor,
            ra_um: self.ra_factor * turn_mm * turn_mm,
            deflection_mm: force_n * self.compliance_mm_n,
            tool_life_min: self.life_factor * root_squared * root_squared,
        }
    }

    /// What a cut yields.
    #[must_use]
    #[inline]
    pub fn yield_of(&self, cut: &CutAtPoint) -> Yield {
        self.economy.yield_of(cut)
    }

    /// The score of a point: objective and sum of relative violations.
    #[must_use]
    #[inline]
    pub fn score(&self, point: [f64; 2]) -> Score {
        let cut = self.cut(point);
        let [force, feed, time, cost] = self.weights;
        let mut value = force * cut.force_n + feed * cut.feed_mm_min;
        if time > 0.0 || cost > 0.0 {
            let yielded = self.yield_of(&cut);
            value += time / yielded.production_min;
            // Where cost has no weight there may be none, and 0 / 0.
            value += if cost > 0.0 { cost / yielded.cost } else { 0.0 };
        }
        let values = cut.values();
        let v = |i: usize| self.bounds[i].violation(values[i]);
        // What does not wait for the force first, in short chains.
        let violation = ((v(0) + v(1)) + (v(4) + v(6))) + (v(2) + (v(3) + v(5)));
        Score { value, violation }
    }

    /// All seven constraints at a point.
    #[must_use]
    pub fn check(&self, point: [f64; 2]) -> [Checked; 7] {
        check(&self.bounds, &self.cut(point).values())
    }

    /// The limits of the seven constraints.
    #[must_use]
    pub fn bounds(&self) -> &[Bounds; 7] {
        &self.bounds
    }

    /// The ranges searched: cutting speed in m/min (one value where it is fixed), feed per tooth
    /// in mm.
    #[must_use]
    pub fn range(&self) -> [[f64; 2]; 2] {
        self.range
    }

    /// Takes the upper ends of the ranges searched down to `high`, not below their lower ends.
    pub(super) fn narrow(&mut self, high: [f64; 2]) {
        for (range, high) in self.range.iter_mut().zip(high) {
            range[1] = math::limit(high, range[0], range[1]);
        }
    }

    /// The force surface.
    #[must_use]
    pub fn surface(&self) -> &ForceSurface {
        &self.surface
    }

    /// The tool.
    #[must_use]
    pub fn tool(&self) -> &Tool {
        &self.tool
    }

    /// Axial and radial depth of the planned section, mm.
    #[must_use]
    pub fn depths_mm(&self) -> [f64; 2] {
        [self.axial_depth_mm, self.radial_depth_mm]
    }
}
