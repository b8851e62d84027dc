//! The machine that the arguments describe, and where its results go.

use std::io::Write as _;

use super::args::MachineModel;
use crate::cli::given;
use crate::cli::scenarios::apply;
use crate::run::edits::Edits;
use crate::run::scenario::Scenario;
use crate::study::uses::Reader;

/// The scenario that `--set` and `--parameters` describe.
pub(super) fn scenario(
    model: &MachineModel,
    reader: Reader,
) -> Result<Scenario, Box<dyn std::error::Error>> {
    let mut scenario = Scenario::default();
    apply(&mut scenario, &model.set)?;
    if let Some(parameters) = model.parameters {
        given::once("--parameters", &["machine.parameters"], &model.set)?;
        scenario.change(|settings| settings.machine.parameters = parameters)?;
    }
    given::all_used(reader, &scenario, &Edits::none(), &model.set)?;
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
