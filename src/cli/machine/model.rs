//! The machine that the arguments describe, and where its results go.

use std::io::Write as _;

use super::args::MachineModel;
use crate::cli::scenarios::apply;
use crate::cli::{given, own, part};
use crate::models::tip_modes::TipMode;
use crate::run::edits::Edits;
use crate::run::scenario::Scenario;
use crate::study::uses::Reader;

/// Why a way of changing depths is no part of it.
const ONE_CUT: &str = "the machine is asked about one cut, of `workpiece.axial_depth_mm` and `workpiece.radial_depth_mm` at most";

/// The scenario that `--set` and `--parameters` describe.
pub(super) fn scenario(
    model: &MachineModel,
    reader: Reader,
) -> Result<Scenario, Box<dyn std::error::Error>> {
    let mut scenario = Scenario::default();
    let brought = own::take(&mut scenario, Some(&model.own_cut), None, Some(&model.own_structure))?;
    apply(&mut scenario, &model.set)?;
    if let Some(parameters) = model.parameters {
        given::once("--parameters", &["machine.parameters"], &model.set)?;
        scenario.change(|settings| settings.machine.parameters = parameters)?;
    }
    part::refuse(reader, model.part.as_ref(), ONE_CUT)?;
    own::all_used(reader, &scenario, &Edits::none(), &model.set, &brought)?;
    Ok(scenario)
}

/// Prints `text`, or writes it where `--out` says.
pub(super) fn deliver(model: &MachineModel, text: &str) -> Result<(), Box<dyn std::error::Error>> {
    match &model.out {
        Some(path) => path.write(text)?,
        None => std::io::stdout().lock().write_all(text.as_bytes())?,
    }
    Ok(())
}

pub(super) fn name(scenario: &Scenario) -> String {
    let machine = &scenario.machine;
    format!(
        "five-mass machine, variant {}, parameters {}, spindle quality {}",
        machine.variant.id(),
        machine.parameters.id(),
        machine.spindle_quality
    )
}

/// The structure of the stability chart in words.
pub(super) fn charted_name(scenario: &Scenario) -> String {
    let modes = &scenario.machine.tip_modes;
    if modes.is_empty() {
        return name(scenario);
    }
    let told = |mode: &TipMode| {
        let TipMode { axis, frequency_hz, damping_ratio, mass_kg } = mode;
        format!("{} {frequency_hz} Hz, damping {damping_ratio}, {mass_kg} kg", axis.id())
    };
    let told: Vec<String> = modes.all().iter().map(told).collect();
    format!("measured modes at the tool's tip: {}", told.join("; "))
}
