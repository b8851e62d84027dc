//! The answer of a plan, and its way into the NC program.

use serde::Serialize;

use super::constraints::Checked;
use super::problem::Problem;
use super::score::Score;
use crate::base::equation::number;
use crate::base::language::tr;
use crate::base::settings::{SettingError, Value};
use crate::base::units::s_from_min;
use crate::run::scenario::Scenario;

steadycut_core::choice! {
    /// What a plan comes to.
    pub enum PlanVerdict {
        /// All constraints are kept.
        Feasible = "feasible", "feasible";
        /// Nothing in the range searched keeps all constraints; the point that violates them least is given.
        NotFeasible = "not_feasible", "nothing is feasible";
    }
}

/// A planned cut with everything that follows from it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Optimum {
    /// Axial depth that it is judged at, mm.
    pub axial_depth_mm: f64,
    /// Radial depth that it is judged at, mm.
    pub radial_depth_mm: f64,
    /// Programmed feed, mm/min.
    pub feed_mm_min: f64,
    /// Programmed spindle speed, 1/min.
    pub speed_rpm: f64,
    /// Cutting speed, m/min.
    pub cutting_speed_m_min: f64,
    /// Feed per tooth, mm.
    pub feed_per_tooth_mm: f64,
    /// The largest force across the tool, N.
    pub force_n: f64,
    /// Force components F_x, F_y, F_z at the instant of the largest force, N.
    pub components_n: [f64; 3],
    /// Spindle power, kW.
    pub power_kw: f64,
    /// Roughness of the feed marks, um.
    pub ra_um: f64,
    /// Deflection of the cutter's tip, mm.
    pub deflection_mm: f64,
    /// Tool life, min.
    pub tool_life_min: f64,
    /// Metal removal rate, cm^3/min.
    pub removal_rate_cm3_min: f64,
    /// Time of the cut, s.
    pub time_s: f64,
    /// Time of the cut with its share of tool changes, s.
    pub production_time_s: f64,
    /// Cost of the cut with its share of tools, in the currency of the settings.
    pub cost: f64,
    /// Value of the objective and sum of violations.
    #[serde(flatten)]
    pub score: Score,
    /// Whether the network knows material, hardness and depths; otherwise its force is continued.
    pub inside_training_data: bool,
    /// Whether all seven constraints are kept. If not, nothing feasible was found, and this is the
    /// point that violates them least.
    pub feasible: bool,
    /// The seven constraints.
    pub constraints: [Checked; 7],
}

impl Optimum {
    /// What follows from a point (cutting speed in m/min, feed per tooth in mm).
    #[must_use]
    pub fn at(problem: &Problem, point: [f64; 2]) -> Self {
        let [cutting_speed_m_min, feed_per_tooth_mm] = point;
        let cut = problem.cut(point);
        let yielded = problem.yield_of(&cut);
        let score = problem.score(point);
        let [axial_depth_mm, radial_depth_mm] = problem.depths_mm();
        Self {
            axial_depth_mm,
            radial_depth_mm,
            feed_mm_min: cut.feed_mm_min,
            speed_rpm: cut.speed_rpm,
            cutting_speed_m_min,
            feed_per_tooth_mm,
            force_n: cut.force_n,
            components_n: cut.components_n,
            power_kw: cut.power_kw,
            ra_um: cut.ra_um,
            deflection_mm: cut.deflection_mm,
            tool_life_min: cut.tool_life_min,
            removal_rate_cm3_min: yielded.removal_rate_cm3_min,
            time_s: s_from_min(yielded.cut_min),
            production_time_s: s_from_min(yielded.production_min),
            cost: yielded.cost,
            score,
            inside_training_data: problem.surface().known(),
            feasible: score.feasible(),
            constraints: problem.check(point),
        }
    }

    /// The constraints that stand at their limit; if nothing is feasible, those that are violated.
    pub fn active(&self) -> impl Iterator<Item = &Checked> {
        let feasible = self.feasible;
        let acts = move |one: &&Checked| if feasible { one.binding } else { one.violation > 0.0 };
        self.constraints.iter().filter(acts)
    }

    /// The answer.
    #[must_use]
    pub fn verdict(&self) -> PlanVerdict {
        if self.feasible { PlanVerdict::Feasible } else { PlanVerdict::NotFeasible }
    }

    /// The answer in one sentence, in the chosen language: at which depth, and by what it is judged.
    #[must_use]
    pub fn verdict_text(&self) -> String {
        let names: Vec<&str> = self.active().map(|one| tr(one.constraint.label)).collect();
        let names = names.join(", ");
        let depth = number(self.axial_depth_mm);
        match (self.feasible, names.is_empty()) {
            (true, true) => tr!(
                "feasible at {depth} mm depth by the plan's network; no constraint binds",
                depth = depth
            ),
            (true, false) => tr!(
                "feasible at {depth} mm depth by the plan's network; binding: {names}",
                depth = depth,
                names = names
            ),
            (false, _) => tr!(
                "nothing is feasible in the range searched at {depth} mm depth; least violation shown, violated: {names}",
                depth = depth,
                names = names
            ),
        }
    }

    /// The scenario with this feed and speed as its programmed values.
    ///
    /// # Errors
    /// A value lies outside the range of its setting.
    pub fn apply(&self, scenario: &Scenario) -> Result<Scenario, SettingError> {
        let mut planned = scenario.clone();
        planned.set_all(&[
            ("program.feed_mm_min".to_owned(), Value::Float(self.feed_mm_min)),
            ("program.spindle_rpm".to_owned(), Value::Float(self.speed_rpm)),
        ])?;
        Ok(planned)
    }
}
