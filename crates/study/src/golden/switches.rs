//! Every closed choice among the settings, each of its values in a digest: taken from the table of settings, so
//! that the next one cannot be forgotten.
//!
//! A controller's own choices are variants of every base preset. Any other choice is one of the first
//! base preset that takes it and in which it changes what is held.

use std::collections::BTreeMap;

use super::variants::{plan, text, tool_life, undisturbed};
use crate::base::settings::{Kind, Value};
use crate::models::structure::{FiveMass, frf};
use crate::run::digest::Digest;
use crate::run::job::Job;
use crate::run::scenario::{Param, Scenario, TwinKind, table};
use crate::safe_feed::{SafeFeedJob, SafeFeedProblem, twin_scenario};
use crate::stability::tip::window_rad;

/// The name of the variant that holds a value of a setting.
#[must_use]
pub fn named(path: &str, value: &Value) -> String {
    format!("{path} = {value}")
}

/// Every value of a closed choice; none of a setting that is a number, a text or a list.
#[must_use]
pub fn values(param: &Param) -> Vec<Value> {
    match param.spec.allowed {
        Kind::Bool => vec![Value::Bool(false), Value::Bool(true)],
        Kind::Choice { options } => options.iter().map(|option| text(option.id)).collect(),
        Kind::Float { .. } | Kind::Int { .. } | Kind::Text { .. } | Kind::Structured(_) => vec![],
    }
}

/// The values of a closed choice other than that of `base`.
pub(super) fn others(base: &Scenario, param: &Param) -> Vec<Value> {
    let now = base.get(&param.path).expect("a path of the table");
    values(param).into_iter().filter(|value| *value != now).collect()
}

/// Digests of the choices outside the controllers that no preset before holds, by name, each over the first
/// of `bases` in which it changes something, and as no other value does.
pub(super) fn switches(
    bases: &[Scenario],
    held: &mut BTreeMap<String, String>,
) -> Vec<(String, String)> {
    let mut found = Vec::new();
    // What each base shows without a switch, worked out once.
    let mut plain: Vec<BTreeMap<Seen, String>> = vec![BTreeMap::new(); bases.len()];
    for param in table().iter().filter(|param| !param.path.starts_with("controller.")) {
        let kind = Seen::of(param.group);
        for value in values(param) {
            let name = named(&param.path, &value);
            if held.contains_key(&name) {
                continue;
            }
            let switched = bases.iter().zip(&mut plain).find_map(|(base, plain)| {
                if base.get(&param.path).is_ok_and(|now| now == value) {
                    return None;
                }
                let mut scenario = base.clone();
                scenario.set(&param.path, value.clone()).ok()?;
                let digest = seen(&scenario, kind);
                let before = plain.entry(kind).or_insert_with(|| seen(base, kind));
                let new = digest != *before && held.values().all(|one| *one != digest);
                new.then_some(digest)
            });
            if let Some(digest) = switched {
                held.insert(name.clone(), digest.clone());
                found.push((name, digest));
            }
        }
    }
    found
}

/// The constant feed that stands beside a scenario's cut; tooth by tooth it is the same but takes long.
fn twin(scenario: &Scenario) -> String {
    if scenario.plant.force_model.tooth_by_tooth() {
        return undisturbed(scenario);
    }
    let safe = match scenario.twin.kind {
        TwinKind::Safe => {
            let mut search = SafeFeedJob::new(SafeFeedProblem::new(scenario, Vec::new()));
            search.to_end();
            search.partial()
        }
        TwinKind::Programmed => None,
    };
    let twin = twin_scenario(scenario, safe.as_ref());
    let mut digest = Digest::default();
    let at = [twin.program.feed_mm_min, twin.program.spindle_rpm];
    at.into_iter().for_each(|value| digest.word(value.to_bits()));
    undisturbed(&twin) + digest.hex().as_str()
}

/// What a setting acts in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Seen {
    /// A run.
    Run,
    /// A run, and the machine's frequency response and the angles in which its teeth cut.
    Machine,
    /// The plan alone.
    Plan,
    /// The tool's life and its measured profile.
    ToolLife,
    /// The constant feed beside the cut.
    Twin,
}

impl Seen {
    fn of(group: &str) -> Self {
        match group {
            "plan" => Self::Plan,
            "life" | "profile" => Self::ToolLife,
            "twin" => Self::Twin,
            "machine" => Self::Machine,
            _ => Self::Run,
        }
    }
}

/// The digest of all that a setting may act in.
fn seen(scenario: &Scenario, what: Seen) -> String {
    match what {
        Seen::Run => undisturbed(scenario),
        Seen::Plan => plan(scenario),
        Seen::ToolLife => tool_life(scenario),
        Seen::Twin => twin(scenario),
        Seen::Machine => {
            let mut digest = Digest::default();
            let response = frf::tree(&FiveMass::new(&scenario.machine), 580.0).grel;
            [response.re, response.im].into_iter().for_each(|part| digest.word(part.to_bits()));
            // Up-milling is how it always was: only the other way is seen in the angles of the teeth.
            if scenario.machine.down_milling {
                let [radial, diameter] =
                    [scenario.workpiece.radial_depth_mm, scenario.tool.diameter_mm];
                let angles = window_rad(radial, diameter, true);
                angles.into_iter().for_each(|angle| digest.word(angle.to_bits()));
            }
            undisturbed(scenario) + digest.hex().as_str()
        }
    }
}
