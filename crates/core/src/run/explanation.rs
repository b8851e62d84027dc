//! The controller's law and the plant's force model with the values of a recorded row.

use super::closed_loop::limits;
use super::scenario::Scenario;
use super::signals::{Row, flag};
use crate::base::equation::Live;
use crate::blocks::control::FeedSpeed;
use crate::blocks::control::law::{ControlMoment, Explained};
use crate::blocks::cutting::force_model::law::ForceMoment;
use crate::blocks::cutting::tool_path::{Engagement, ToolPath};

/// The law of the scenario's controller, with the values of `row`.
#[must_use]
pub fn explain_controller(scenario: &Scenario, row: &Row) -> Explained {
    let cut = ToolPath::cut_of(&scenario.workpiece, row.position_mm);
    let belief = &scenario.belief;
    scenario.controller.explain(&ControlMoment {
        force_ref_n: row.force_ref_n,
        force_measured_n: row.force_measured_n,
        gain_estimate: row.gain_estimate,
        command: FeedSpeed {
            feed_mm_min: row.feed_command_mm_min,
            speed_rpm: row.spindle_command_rpm,
        },
        feed_override_percent: row.feed_override_percent,
        programmed: scenario.programmed(cut),
        limits: limits(scenario, cut),
        models_valid: !row.has(flag::K2_OUTSIDE | flag::K3_OUTSIDE),
        models: &scenario.believed(),
        belief,
    })
}

/// The force model of the scenario's plant, with the values of `row`.
#[must_use]
pub fn explain_force(scenario: &Scenario, row: &Row) -> Vec<Live> {
    scenario.plant.force_model.explain(&ForceMoment {
        plant: &scenario.plant,
        formulas: &scenario.formula,
        tool: &scenario.tool,
        feed_mm_min: row.feed_mm_min,
        speed_rpm: row.spindle_rpm,
        place: Engagement {
            axial_depth_mm: row.axial_depth_mm,
            radial_depth_mm: row.radial_depth_mm,
        },
        force_n: row.force_n,
        force_dyn_n: row.force_dyn_n,
    })
}
