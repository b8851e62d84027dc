//! What is given on the command line is obeyed, or refused with the reason.

use crate::run::edits::Edits;
use crate::run::scenario::{Scenario, param};
use crate::study::uses::Reader;

/// What a file of networks sets.
pub const LEARNED: [&str; 2] = ["controller.unks.networks", "controller.unks.start"];

/// The path of a `--set PATH=VALUE`.
fn path_of(set: &str) -> &str {
    set.split_once('=').map_or(set, |(path, _)| path)
}

/// Refuses `--set`s that a command has no use for; `scenario` has them already.
pub fn all_used(
    reader: Reader,
    scenario: &Scenario,
    edits: &Edits,
    sets: &[String],
) -> Result<(), Box<dyn std::error::Error>> {
    for set in sets {
        let path = path_of(set);
        if let Some(because) = reader.unused_throughout(scenario, edits, path)? {
            let command = reader.label();
            return Err(format!("--set {path}: `{command}` has no use for it: {because}").into());
        }
    }
    Ok(())
}

/// Refuses `--set`s of what another option says too.
pub fn once(
    option: &str,
    paths: &[&str],
    sets: &[String],
) -> Result<(), Box<dyn std::error::Error>> {
    for set in sets {
        let path = &param(path_of(set))?.path;
        if paths.contains(&path.as_str()) {
            return Err(format!("{option} and --set {path} say the same: leave one out").into());
        }
    }
    Ok(())
}

/// Refuses the edits of a scenario file where a command cannot follow them.
pub fn no_edits(
    reader: Reader,
    name: &str,
    edits: &Edits,
) -> Result<(), Box<dyn std::error::Error>> {
    let Some(edit) = edits.list().first() else { return Ok(()) };
    Err(format!(
        "{name}: `{}` has no use for changes during the run, as of `{}` at {} s: leave them out",
        reader.label(),
        edit.path,
        edit.at_s
    )
    .into())
}
