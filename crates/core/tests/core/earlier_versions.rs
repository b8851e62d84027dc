//! Files, links and settings of 0.4.0 open under the names that the settings have now.

use steadycut_core::base::settings::Value;
use steadycut_core::models::structure::Variant;
use steadycut_core::models::structure::parameters::Parameters;
use steadycut_core::run::edits::Edits;
use steadycut_core::run::scenario::{RENAMED, Scenario, param, parse_value, table};
use steadycut_core::run::{scenario_file, scenario_link};

const FILE: &str = include_str!("../data/0.4.0/machine-and-wear.toml");
const LINK: &str = include_str!("../data/0.4.0/machine-and-wear.link");

#[test]
fn a_file_and_a_link_of_0_4_0_mean_what_they_meant() {
    let (scenario, edits) = scenario_file::parse(FILE).unwrap();
    assert_eq!(scenario.machine.variant, Variant::Names);
    assert_eq!(scenario.machine.parameters, Parameters::Table);
    assert_eq!(scenario.machine.specific_cutting_force_n_mm2, 2500.0);
    assert_eq!(scenario.machine.directional_factor, 0.4);
    assert_eq!(scenario.wear.tool_life_factor, 0.8);
    assert_eq!(scenario.life.tool_life_min, 200.0);
    assert_eq!(scenario.workpiece.depth_steps.len(), 2);
    let moved = scenario_file::parse("version = 1\n[plant]\nrunout_um = 7.0\n").unwrap().0;
    assert_eq!(moved.tool.runout_um, 7.0);
    let later = edits.scenario_at(&scenario, 5.0).unwrap();
    assert_eq!((later.wear.tool_life_factor, later.life.tool_life_min), (0.6, 150.0));

    let linked = scenario_link::parse(LINK.trim_end()).unwrap();
    assert_eq!(linked, (scenario.clone(), edits.clone()));

    // What is written has the new names, and is the same again.
    let file = scenario_file::write(&scenario, &edits);
    for (old, new) in RENAMED {
        let (old_key, new_key) = (old.rsplit('.').next(), new.rsplit('.').next());
        assert!(!file.contains(old), "{old}: {file}");
        // A setting that only changed its group has its key still.
        if old_key != new_key {
            assert!(!file.contains(&format!("{} =", old_key.unwrap())), "{old}: {file}");
            assert!(file.contains(new_key.unwrap()), "{old}: {file}");
        }
    }
    assert_eq!(scenario_file::parse(&file).unwrap(), (scenario.clone(), edits.clone()));
    let link = scenario_link::write(&scenario, &edits);
    assert_eq!(scenario_link::parse(&link).unwrap(), (scenario, edits));
}

#[test]
fn every_earlier_name_leads_to_a_setting_and_is_no_name_of_now() {
    for (old, new) in RENAMED {
        assert_eq!(param(old).unwrap().path, *new);
        assert!(table().iter().all(|param| param.path != *old), "{old}");
        let default = param(new).unwrap().spec.default.clone();
        let mut scenario = Scenario::default();
        scenario.set(old, parse_value(old, &default.to_string()).unwrap()).unwrap();
        scenario.set_all(&[((*old).to_owned(), default)]).unwrap();
        assert_eq!(scenario, Scenario::default());
    }
}

#[test]
fn a_setting_under_both_its_names_is_refused() {
    let text = "version = 1\n[life]\ndurability_min = 100.0\ntool_life_min = 200.0\n";
    let refused = scenario_file::parse(text).unwrap_err().to_string();
    assert!(refused.contains("life.durability_min") && refused.contains("keep"), "{refused}");
    // Refusals speak of the setting as it is called now.
    let mut scenario = Scenario::default();
    let refused = scenario.set("life.durability_min", Value::Float(1.0)).unwrap_err();
    assert!(refused.to_string().contains("`life.tool_life_min` cannot be 1 min"), "{refused}");
    assert_eq!(scenario_file::parse("version = 1\n").unwrap().1, Edits::none());
}

#[test]
fn a_link_that_is_not_packed_has_the_new_names() {
    for (old, new) in RENAMED {
        let scenario = ["0.5", "0.25", "100", "B"]
            .into_iter()
            .filter_map(|text| parse_value(new, text).ok())
            .find_map(|value| {
                let mut scenario = Scenario::default();
                let set = scenario.set(new, value).is_ok() && scenario != Scenario::default();
                set.then_some(scenario)
            })
            .unwrap_or_else(|| panic!("{new}: none of these differs from its default"));
        let link = scenario_link::write(&scenario, &Edits::none());
        assert!(link.contains(new) && !link.contains(old), "{new}: {link}");
        assert_eq!(scenario_link::parse(&link).unwrap().0, scenario);
    }
}
