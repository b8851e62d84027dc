//! The scenario that a command is given: preset or file, `--set`, networks.

use super::files::{InPath, ScenarioPath};
use crate::base::settings::SettingError;
use crate::models::unks::Stored;
use crate::run::edits::Edits;
use crate::run::scenario::{Scenario, parse_value};
use crate::run::{presets, scenario_file};
use crate::study::opening::Opening;
use crate::study::unks_passes::beginning_with;

/// Loads a preset or a scenario file.
pub fn load(path: &ScenarioPath) -> Result<(Scenario, Edits), Box<dyn std::error::Error>> {
    if let Some(link) = path.link() {
        let opening = linked(link)?;
        if let Some(linked) = &opening.mission {
            let (id, link) = (&linked.mission.id, linked.mission.link());
            return Err(format!(
                "the link is one to the mission `{id}`: steadycut mission check marks an answer to it, and \
                 steadycut --scenario '#{link}' opens it"
            )
            .into());
        }
        return Ok((opening.start.scenario, opening.start.edits));
    }
    match path.source() {
        Ok(file) => {
            let read = scenario_file::parse(&file.text()?);
            Ok(read.map_err(|error| format!("{file}: {error}"))?)
        }
        Err(name) => Ok((presets::load(name)?, Edits::none())),
    }
}

/// What a link opens, all of it.
fn linked(link: &str) -> Result<Opening, Box<dyn std::error::Error>> {
    let opening = Opening::of_link(link);
    match opening.unread.as_ref().or(opening.problems.first()) {
        None => Ok(opening),
        Some(problem) => Err(problem.clone().into()),
    }
}

/// What the console opens with: a preset, a scenario file or a link, with flags.
pub fn opening(
    scenario: Option<ScenarioPath>,
    embed: &str,
) -> Result<Opening, Box<dyn std::error::Error>> {
    let mut opening = match &scenario {
        None => Opening::usual(),
        Some(path) => match path.link() {
            Some(link) => linked(link)?,
            None => load(path).map(|(scenario, edits)| Opening::of_cut(scenario, edits))?,
        },
    };
    match opening.frame.take(embed).into_iter().next() {
        None => Ok(opening),
        Some(problem) => Err(format!("--{problem}").into()),
    }
}

/// Applies `--set path=value` arguments, all or none.
pub fn apply(scenario: &mut Scenario, sets: &[String]) -> Result<(), SettingError> {
    let mut changes = Vec::with_capacity(sets.len());
    for set in sets {
        let (path, value) = set.split_once('=').ok_or_else(|| SettingError::Format {
            what: format!("--set {set}"),
            problem: "expected PATH=VALUE, for example target.ra_um=0.6".to_owned(),
        })?;
        changes.push((path.to_owned(), parse_value(path, value)?));
    }
    scenario.set_all(&changes)
}

/// Puts the networks of a file into a scenario.
pub fn load_networks(
    scenario: &mut Scenario,
    path: &InPath,
) -> Result<(), Box<dyn std::error::Error>> {
    let stored = Stored::parse(&path.text()?).map_err(|problem| format!("{path}: {problem}"))?;
    Ok(scenario.set_all(&beginning_with(&stored))?)
}
