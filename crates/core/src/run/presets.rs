//! The shipped scenarios. A new one is a file in `assets/scenarios` and a line here.

use super::scenario::Scenario;
use super::scenario_file;
use crate::base::settings::SettingError;

/// A shipped scenario: its name and its TOML text.
#[derive(Clone, Copy, Debug)]
pub struct Preset {
    /// Name, as on the command line.
    pub name: &'static str,
    /// The scenario file's text.
    pub text: &'static str,
}

macro_rules! presets {
    ($($name:literal),+ $(,)?) => {
        /// All shipped scenarios, the console's first one first.
        pub const PRESETS: &[Preset] = &[
            $( Preset {
                name: $name,
                text: include_str!(concat!("../../../../assets/scenarios/", $name, ".toml")),
            }, )+
        ];
    };
}

presets![
    "first-cut",
    "table3-1",
    "table3-2",
    "table3-3",
    "table3-4",
    "table3-5",
    "table3-6",
    "table3-7",
    "table3-8",
    "table3-9",
    "table3-10",
    "strategy-2013",
    "strategy-table1-1",
    "strategy-table1-2",
    "strategy-table1-3",
    "strategy-table1-4",
    "strategy-table1-5",
    "strategy-table1-6",
    "strategy-table1-7",
    "strategy-table1-8",
    "experiment-1",
    "experiment-2",
    "table3-5-noise",
    "depth-step",
    "material-change",
    "experiment-2-per-cut",
    "combined-2005",
    "experiment-2-neural",
    "experiment-1-sl",
    "tool-life",
    "machine-dynamics",
    "chatter",
    "machine-life",
];

/// The scenario of a preset.
///
/// ```
/// use steadycut_core::run::presets;
///
/// assert_eq!(presets::load("table3-5").unwrap().target.ra_um, 0.81);
/// let error = presets::load("table3-55").unwrap_err();
/// assert!(error.to_string().contains("table3-5"), "{error}");
/// ```
///
/// # Errors
/// No preset has this name; the message lists all.
pub fn load(name: &str) -> Result<Scenario, SettingError> {
    let preset = PRESETS.iter().find(|preset| preset.name == name).ok_or_else(|| {
        let names: Vec<&str> = PRESETS.iter().map(|preset| preset.name).collect();
        SettingError::Format {
            what: format!("preset `{}`", name.chars().take(60).collect::<String>()),
            problem: format!("there is none of this name; there are {}", names.join(", ")),
        }
    })?;
    scenario_file::parse(preset.text).map(|(scenario, _)| scenario)
}
