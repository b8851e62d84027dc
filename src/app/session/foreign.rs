//! A script that came with a file or a link is shown before it is run: nobody has asked for it yet.

use super::{Plan, Session};
use crate::base::language::tr;
use crate::base::settings::{Field, Value};
use crate::blocks::control::ControllerKind;
use crate::blocks::control::script::TEMPLATES;
use crate::run::presets::PRESETS;
use crate::run::scenario::Scenario;

/// The setting that holds a script.
const CODE: &str = "controller.script.code";

/// Whether a plan runs a script that is none of the program's own.
pub(super) fn brings_a_script((scenario, edits): &Plan) -> bool {
    let chosen = |value: &Value| *value == ControllerKind::Script.to_value();
    let runs_one = scenario.controller.kind == ControllerKind::Script
        || edits.list().iter().any(|edit| edit.path == "controller.kind" && chosen(&edit.value));
    let shipped = |text: &str| {
        TEMPLATES.iter().any(|(_, template)| *template == text)
            || PRESETS.iter().any(|preset| shipped_code(preset.text).as_deref() == Some(text))
    };
    let own = |value: &Value| matches!(value, Value::Text(text) if !shipped(text));
    let codes = edits.list().iter().filter(|edit| edit.path == CODE).map(|edit| &edit.value);
    runs_one && (own(&code_of(scenario)) || codes.into_iter().any(own))
}

fn code_of(scenario: &Scenario) -> Value {
    Value::Text(scenario.controller.script.code.text().to_owned())
}

/// The script of a shipped scenario, where it runs one.
fn shipped_code(text: &str) -> Option<String> {
    if !text.contains("[controller.script]") {
        return None;
    }
    let (scenario, _) = crate::run::scenario_file::parse(text).ok()?;
    Some(scenario.controller.script.code.text().to_owned())
}

impl Session {
    /// Holds the cut where what was opened brings a script, and says so.
    pub fn wait_for_consent(&mut self) {
        self.waits = brings_a_script(&self.plan);
        if !self.waits {
            return;
        }
        self.playback.playing = false;
        let bytes = self.plan.0.controller.script.code.text().len();
        self.notify(tr!(
            "What was opened brings a controller's script of its own, {n} bytes: it is not run before you press Play. It can \
             be read under Script.",
            n = bytes
        ));
    }

    /// Whether a script that came with a file or a link waits to be run.
    #[must_use]
    pub fn waits_for_consent(&self) -> bool {
        self.waits
    }
}
