//! The shipped scenarios. A new one is a file in `assets/scenarios` and a line here, with its
//! group and title.

use std::sync::LazyLock;

use super::scenario::Scenario;
use super::scenario_file;
use crate::base::language::tr;
use crate::base::settings::SettingError;

crate::choice! {
    /// Groups of the shipped scenarios, in the order in which they are shown.
    pub enum PresetGroup {
        /// The first ones to open.
        Start = "start", "Start here";
        /// For lessons: what goes wrong in a cut, and how a control of the trade meets it.
        Training = "training", "Training";
        /// Models, cutters and materials of one's own.
        Own = "own", "Own models, cutters, materials";
        /// The machine, its vibration and its tool's life.
        Machine2019 = "machine_2019", "Machine: vibration, chatter, tool life";
        /// Table 3 of the 2007 paper.
        Sdnrp2007 = "sdnrp_2007", "Papers: SDNRP 2007";
        /// The 2013 control strategy.
        Strategy2013 = "strategy_2013", "Papers: control strategy 2013";
        /// The 2005 combined system.
        Combined2005 = "combined_2005", "Papers: combined system 2005";
    }
}

/// A shipped scenario.
#[derive(Clone, Copy, Debug)]
pub struct Preset {
    /// Name, as on the command line.
    pub name: &'static str,
    /// Where it belongs.
    pub group: PresetGroup,
    /// What it shows, in a few words.
    pub title: &'static str,
    /// The scenario file's text.
    pub text: &'static str,
}

macro_rules! presets {
    ($($name:literal, $group:ident, $title:literal;)+) => {
        /// All shipped scenarios, the console's first one first.
        pub const PRESETS: &[Preset] = &[
            $( Preset {
                name: $name,
                group: PresetGroup::$group,
                title: $title,
                text: include_str!(concat!("../../../../assets/scenarios/", $name, ".toml")),
            }, )+
        ];
    };
}

presets! {
    "depth-step", Start, "A deeper stretch: what control buys";
    "first-cut", Start, "Drag the target roughness";
    "table3-1", Sdnrp2007, "Table 3, simulation 1";
    "table3-2", Sdnrp2007, "Table 3, simulation 2";
    "table3-3", Sdnrp2007, "Table 3, simulation 3";
    "table3-4", Sdnrp2007, "Table 3, simulation 4";
    "table3-5", Sdnrp2007, "Table 3, simulation 5";
    "table3-6", Sdnrp2007, "Table 3, simulation 6";
    "table3-7", Sdnrp2007, "Table 3, simulation 7";
    "table3-8", Sdnrp2007, "Table 3, simulation 8";
    "table3-9", Sdnrp2007, "Table 3, simulation 9";
    "table3-10", Sdnrp2007, "Table 3, simulation 10";
    "strategy-2013", Strategy2013, "Plan, program, hold: the whole strategy";
    "strategy-table1-1", Strategy2013, "Table 1, simulation 1";
    "strategy-table1-2", Strategy2013, "Table 1, simulation 2";
    "strategy-table1-3", Strategy2013, "Table 1, simulation 3";
    "strategy-table1-4", Strategy2013, "Table 1, simulation 4";
    "strategy-table1-5", Strategy2013, "Table 1, simulation 5";
    "strategy-table1-6", Strategy2013, "Table 1, simulation 6";
    "strategy-table1-7", Strategy2013, "Table 1, simulation 7";
    "strategy-table1-8", Strategy2013, "Table 1, simulation 8";
    "experiment-1", Combined2005, "Experiment 1: two depth steps";
    "experiment-2", Combined2005, "Experiment 2: five cuts";
    "table3-5-noise", Start, "Noise in the force and in the sensor";
    "disturbed-cut", Training, "One disturbance after the other";
    "material-change", Own, "Another material than the model knows";
    "afc", Training, "Adaptive feed control, taught in";
    "own-formula", Own, "A formula of one's own for the force";
    "square-12-4-42crmo4", Own, "Models found for another cutter and steel";
    "own-controller", Own, "A controller of one's own, as a script";
    "own-curves", Own, "Material and wear as formulas";
    "own-shop", Own, "Cutter, steel and machine of one's own";
    "own-part", Own, "A part of one's own, from a program";
    "own-structure", Own, "Measured modes at the cutter's tip";
    "experiment-2-per-cut", Combined2005, "Experiment 2, a planned feed for every cut";
    "combined-2005", Combined2005, "Recommended, planned, controlled";
    "experiment-2-neural", Combined2005, "Experiment 2, force from the neural model";
    "experiment-1-sl", Combined2005, "Experiment 1 with the Slovene text's figures";
    "tool-life", Machine2019, "A tool wears through its life";
    "machine-dynamics", Machine2019, "The cut shakes the machine";
    "chatter", Machine2019, "A deeper stretch brings chatter";
    "machine-life", Machine2019, "Wear, sound and roughness over a tool's life";
}

/// The scenarios of a group, in their order.
pub fn of_group(group: PresetGroup) -> impl Iterator<Item = &'static Preset> {
    PRESETS.iter().filter(move |preset| preset.group == group)
}

/// The title of the shipped scenario with this name.
#[must_use]
pub fn title(name: &str) -> Option<&'static str> {
    PRESETS.iter().find(|preset| preset.name == name).map(|preset| preset.title)
}

/// Whether a scenario that has a preset's name is not what that preset is.
#[must_use]
pub fn is_changed(scenario: &Scenario) -> bool {
    static SHIPPED: LazyLock<Vec<(&'static str, Scenario)>> = LazyLock::new(|| {
        PRESETS.iter().filter_map(|one| Some((one.name, load(one.name).ok()?))).collect()
    });
    let name = &scenario.info.name;
    SHIPPED.iter().any(|(shipped, its)| shipped == name && its != scenario)
}

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
            what: tr!("preset `{name}`", name = name.chars().take(60).collect::<String>()),
            problem: tr!("there is none of this name; there are {names}", names = names.join(", ")),
        }
    })?;
    scenario_file::parse(preset.text).map(|(scenario, _)| scenario)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_titles_are_told_apart_and_no_group_is_empty() {
        for (i, one) in PRESETS.iter().enumerate() {
            for other in &PRESETS[..i] {
                assert!(one.name != other.name && one.title != other.title, "{}", one.name);
            }
            assert!(one.title.len() <= 48, "`{}` is cut off in a list", one.title);
        }
        assert!(PresetGroup::ALL.iter().all(|group| of_group(*group).count() > 0));
        assert_eq!(title("chatter"), Some("A deeper stretch brings chatter"));
        assert_eq!(title("not shipped"), None);
    }
}
