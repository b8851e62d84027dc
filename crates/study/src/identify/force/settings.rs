//! The cut of a scenario, and the scenario with what was identified: its settings, with source and intervals in comments.

use std::fmt::Write as _;

use super::{ForceFit, IdentifiedLaw, RecordedCut};
use crate::base::language::tr;
use crate::base::settings::{SettingError, Value};
use crate::identify::EstimatedValue;
use crate::models::mechanistic::{CK45, Kienzle};
use crate::run::edits::Edits;
use crate::run::scenario::Scenario;
use crate::run::scenario_file;

/// The least chip thickness of the written formulas, mm: below it they go straight on.
const THINNEST_MM: f64 = 1e-9;

impl RecordedCut {
    /// The cut that a scenario programs.
    ///
    /// # Errors
    /// Its force is not simulated tooth by tooth, or its cut is not one of one depth.
    pub fn of(scenario: &Scenario) -> Result<Self, String> {
        let (plant, tool, workpiece) = (&scenario.plant, &scenario.tool, &scenario.workpiece);
        if !plant.force_model.tooth_by_tooth() {
            return Err(tr!(
                "`plant.force_model` is {id}: expected is a scenario whose force is simulated tooth by tooth, mechanistic",
                id = plant.force_model.id()
            ));
        }
        let cut = Self {
            tool: tool.clone(),
            slice_mm: plant.slice_mm,
            speed_rpm: scenario.program.spindle_rpm,
            feed_mm_min: scenario.program.feed_mm_min,
            axial_depth_mm: workpiece.axial_depth_mm,
            radial_depth_mm: workpiece.radial_depth_mm,
            law: Kienzle { k_n_mm2: [0.0; 3], exponents: [1.0; 3] },
            held_exponents: [false; 3],
        };
        let (steel, factor) = plant.material.steel(plant.hardness_hb);
        let speed_m_min = tool.cutting_speed_m_min(cut.speed_rpm);
        let law = Kienzle::new(&steel, speed_m_min, tool.rake_deg, steel.hardness_hb);
        Ok(Self { law: Kienzle { k_n_mm2: law.k_n_mm2.map(|k| k * factor), ..law }, ..cut })
    }
}

/// A value with its interval, as a comment has it.
fn told(x: EstimatedValue, unit: &str) -> String {
    let half = x.half.map_or("not told by this cut".to_owned(), |half| format!("+- {half:.4}"));
    format!("{:.4} {half} {unit}", x.value).trim_end().to_owned()
}

/// The formula of a law as the text of its model: before the corrections that the plant applies.
fn formula(law: &IdentifiedLaw, fit: &ForceFit, corrections: f64, source: &str) -> Value {
    let (k, m) = (law.k_n_mm2.value / corrections, law.exponent.value);
    let model = serde_json::json!({
        "version": 1,
        "formula": format!("{k:?}*h^{:?}", -m),
        "source": source,
        "output": { "name": format!("k_{}", law.letter), "unit": "N/mm^2" },
        "inputs": [{ "name": "h", "unit": "mm", "low": THINNEST_MM, "high": fit.thickest_mm }],
    });
    Value::Text(model.to_string())
}

/// The scenario of the cut with what was identified in the place of its laws and run-out: the settings that changed, and the
/// text of its file, with the intervals as comments. `source` says where the forces come from.
///
/// # Errors
/// A value that the program does not take, as a run-out above its range.
pub fn identified_scenario(
    scenario: &Scenario,
    edits: &Edits,
    fit: &ForceFit,
    source: &str,
) -> Result<(Vec<(String, Value)>, String), SettingError> {
    let tool = &scenario.tool;
    let speed_m_min = tool.cutting_speed_m_min(fit.speed_rpm);
    let corrections = Kienzle::corrections(&CK45, speed_m_min, tool.rake_deg, CK45.hardness_hb);
    // The laws hold for the material and the wear of the cut: nothing else is to stand on them.
    let mut changes = vec![
        ("plant.material".to_owned(), Value::Text("ck45".to_owned())),
        ("plant.hardness_hb".to_owned(), Value::Float(CK45.hardness_hb)),
        ("plant.wear_factor".to_owned(), Value::Float(1.0)),
        ("formula.material".to_owned(), Value::Text(String::new())),
        ("tool.runout_um".to_owned(), Value::Float(fit.shift_um.value.max(0.0))),
    ];
    let paths =
        ["formula.specific_force", "formula.specific_radial_force", "formula.specific_axial_force"];
    for (path, law) in paths.into_iter().zip(&fit.laws) {
        changes.push((path.to_owned(), formula(law, fit, corrections, source)));
    }
    let mut identified = scenario.clone();
    identified.set_all(&changes)?;
    let mut text = format!(
        "# Force coefficients identified by `steadycut identify force`: {source}.\n\
         # {} samples over {:.1} turns at {:.2} 1/min; the model explains {:.2} % of the forces, {:.2} N are left (rms).\n\
         # +- is half a 95 % interval; k_i is that of this cut, as k_i1.1 h^-m_i of the chip thickness h in mm.\n",
        fit.samples,
        fit.turns,
        fit.speed_rpm,
        100.0 * fit.r2,
        fit.rest_n
    );
    for law in &fit.laws {
        // Into memory: it does not fail.
        let _ = writeln!(
            text,
            "# k_{0}1.1 = {1}; m_{0} = {2}; at {3:.4} mm {4}",
            law.letter,
            told(law.k_n_mm2, "N/mm^2"),
            told(law.exponent, ""),
            fit.reference_mm,
            told(law.at_reference_n_mm2, "N/mm^2"),
        );
    }
    let teeth: Vec<String> = fit.runout_um.iter().map(|x| told(*x, "um")).collect();
    let _ = writeln!(
        text,
        "# run-out, tooth by tooth from the one furthest out: {}; as a shift of the axis {}",
        teeth.join(", "),
        told(fit.shift_um, "um")
    );
    for note in fit.notes() {
        let _ = writeln!(text, "# {note}");
    }
    text.push_str(&scenario_file::write(&identified, edits));
    Ok((changes, text))
}
