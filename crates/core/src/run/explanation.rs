//! The controller's law and the plant's force model with the values of a recorded row.

use std::sync::Arc;

use super::closed_loop::limits;
use super::scenario::Scenario;
use super::signals::{Row, flag};
use crate::base::equation::{Live, number};
use crate::base::language::tr;
use crate::blocks::control::FeedSpeed;
use crate::blocks::control::law::{ControlMoment, Explained};
use crate::blocks::cutting::force_model::law::ForceMoment;
use crate::blocks::cutting::tool_path::{Engagement, ToolPath};
use crate::models::Valued;
use crate::models::formula_model::FormulaModel;
use crate::models::wear::{WearCut, WearModel};

/// The law of the scenario's controller, with the values of `row`.
#[must_use]
pub fn explain_controller(scenario: &Scenario, row: &Row) -> Explained {
    let cut = ToolPath::cut_of(&scenario.workpiece, row.position_mm);
    let belief = &scenario.belief;
    scenario.controller.explain(&ControlMoment {
        force_ref_n: row.force_ref_n,
        force_measured_n: row.force_measured_n,
        cut,
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
    let mut lines = scenario.plant.force_model.explain(&ForceMoment {
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
    });
    lines.extend(curves(scenario, row));
    lines
}

/// A formula of one's own with its live values: the symbol of what it gives, its inputs by name with their values, and
/// what it gives.
#[must_use]
pub fn of_own(model: &FormulaModel, symbol: &str, inputs: &[(&str, f64)], found: Valued) -> Live {
    let names: Vec<&str> = inputs.iter().map(|(name, _)| *name).collect();
    let values: Vec<f64> = inputs.iter().map(|(_, value)| *value).collect();
    let [formula, with] = model.shown(&names, &values);
    let ranges: Vec<String> = names
        .iter()
        .zip(model.inputs())
        .map(|(name, input)| {
            let [low, high] = [input.range.low, input.range.high].map(number);
            let unit = input.unit.to_string();
            tr!("{name} {low} to {high} {unit}", name = *name, low = low, high = high, unit = unit)
                .trim_end()
                .to_owned()
        })
        .collect();
    let unit = format!(" {}", model.output().unit);
    Live {
        formula: format!("{symbol} = {formula}"),
        values: format!("{symbol} = {with} = {}{}", number(found.value), unit.trim_end()),
        range: format!("{}; {}", ranges.join(", "), tr("straight on beyond")),
        valid: found.valid,
    }
}

/// The formulas of one's own for material and wear that the run computes with.
fn curves(scenario: &Scenario, row: &Row) -> Vec<Live> {
    let (wear, tool) = (&scenario.wear, &scenario.tool);
    let mut lines = Vec::new();
    let mut line =
        |model: Option<&Arc<FormulaModel>>, symbol: &str, inputs: &[(&str, f64)], found: Valued| {
            lines.extend(model.map(|model| of_own(model, symbol, inputs, found)));
        };
    let hardness_hb = scenario.plant.hardness_hb;
    if let Some(material) = scenario.formula.material_factor(hardness_hb) {
        line(scenario.formula.material.get(), "material", &[("HB", hardness_hb)], material);
    }
    if scenario.plant.force_model.tooth_by_tooth() {
        // At the thickest chip.
        let thickness_mm = tool.feed_per_tooth_mm(row.feed_mm_min, row.spindle_rpm.max(1.0));
        let forces = scenario.formula.specific_forces().into_iter().zip(["k_c", "k_r", "k_a"]);
        for (own, symbol) in forces.filter_map(|(own, symbol)| Some((own?, symbol))) {
            line(Some(own), symbol, &[("h", thickness_mm)], own.at(&[thickness_mm]));
        }
    }
    if wear.model == WearModel::Life {
        let worn = wear.wear_valued(row.used_life);
        line(wear.curve.get(), "w", &[("x", row.used_life)], worn);
        line(wear.force_curve.get(), "P/P_0", &[("w", worn.value)], wear.force_valued(worn.value));
        if scenario.machine.coupled {
            let stiffness = wear.stiffness_valued(worn.value);
            line(wear.stiffness_curve.get(), "k_3/k_{30}", &[("w", worn.value)], stiffness);
        }
        let cut = WearCut {
            cutting_speed_m_min: tool.cutting_speed_m_min(row.spindle_rpm),
            feed_per_tooth_mm: tool.feed_per_tooth_mm(row.feed_mm_min, row.spindle_rpm.max(1.0)),
            axial_depth_mm: row.axial_depth_mm,
        };
        let inputs = [
            ("v_c", cut.cutting_speed_m_min),
            ("f_z", cut.feed_per_tooth_mm),
            ("A_D", cut.axial_depth_mm),
        ];
        // Nothing wears in the air.
        if !row.has(flag::AIR) {
            line(wear.life_curve.get(), "T", &inputs, wear.usual_life_valued(&cut));
        }
    }
    lines
}
