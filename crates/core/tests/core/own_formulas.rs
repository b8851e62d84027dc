//! Formulas of a user's own in the loop: plant, controller, cards and files have them at once.

use steadycut_core::base::settings::Value;
use steadycut_core::models::formula_model::{FormulaModel, FormulaRole};
use steadycut_core::models::genetic::{Calibration, FeedOfForce, FormulaSettings};
use steadycut_core::run::edits::{Edit, Edits};
use steadycut_core::run::explanation::explain_force;
use steadycut_core::run::one_run::Run;
use steadycut_core::run::presets::load;
use steadycut_core::run::scenario::{Scenario, Settings};
use steadycut_core::run::signals::{Row, flag};
use steadycut_core::run::{scenario_file, scenario_link};

fn quiet() -> Scenario {
    load("own-formula").unwrap().with(|s| s.noise.level = 0.0).unwrap()
}

/// No formula, and nobody who asks for one.
fn without(s: &mut Settings) {
    s.formula = FormulaSettings::default();
    (s.plant.calibration, s.belief.calibration) =
        (Calibration::Identified, Calibration::Identified);
}

fn model(scenario: &Scenario) -> FormulaModel {
    FormulaModel::clone(scenario.formula.force.get().unwrap())
}

fn rows(scenario: &Scenario) -> Vec<Row> {
    Run::complete(scenario, &Edits::none()).recording().rows().to_vec()
}

#[test]
fn the_plant_cuts_by_the_formula_and_the_controller_believes_it() {
    let scenario = quiet();
    let model = model(&scenario);
    let rows = rows(&scenario);
    let mut outside = 0;
    for row in rows.iter().filter(|row| row.axial_depth_mm == 2.0) {
        let found = model.at(&[row.feed_mm_min, row.spindle_rpm]);
        assert!((row.force_n - found.value).abs() < 1e-9, "{row:?}");
        assert_eq!(row.has(flag::K4_OUTSIDE), !found.valid);
        outside += usize::from(!found.valid);
    }
    // Plant and belief agree, so the controller finds a gain of 1 before the part gets deeper.
    let before = rows.iter().rfind(|row| row.axial_depth_mm == 2.0).unwrap();
    assert!((before.gain_estimate - 1.0).abs() < 1e-6, "{before:?}");
    assert!((before.force_n - before.force_ref_n).abs() < 0.05, "{before:?}");
    let deeper = rows.last().unwrap();
    assert!((deeper.gain_estimate - 1.1).abs() < 1e-3 && outside < rows.len() / 4, "{deeper:?}");
    // With the built-in one believed, the gain takes up the difference.
    let other = scenario.with(|s| s.belief.calibration = Calibration::Identified).unwrap();
    let rows = self::rows(&other);
    let before = rows.iter().rfind(|row| row.axial_depth_mm == 2.0).unwrap();
    assert!((before.gain_estimate - 1.0).abs() > 1e-5, "{before:?}");
}

#[test]
fn the_card_shows_the_formula_with_the_values_of_the_row() {
    let scenario = quiet();
    let mut row = *rows(&scenario).last().unwrap();
    (row.feed_mm_min, row.spindle_rpm) = (300.0, 1500.0);
    let card = &explain_force(&scenario, &row)[0];
    assert_eq!(card.formula, "K4 = 354.9 - 182 · (f / 256)^{-0.245} - 0.572 · (n / 1024)^{3.11}");
    assert!(
        card.values.starts_with(
            "K4 = 354.9 - 182 · (300 / 256)^{-0.245} - 0.572 · (1500 / 1024)^{3.11} = "
        )
    );
    assert!(card.valid && card.range.starts_with("f 150 to 600 mm/min, n 800 to 3000 1/min"));
    row.feed_mm_min = 700.0;
    let card = &explain_force(&scenario, &row)[0];
    assert!(!card.valid && card.values.contains(" · (700 - 600)"), "{card:?}");
}

#[test]
fn file_link_and_edit_carry_the_formula() {
    let scenario = quiet();
    let written = scenario_file::write(&scenario, &Edits::none());
    let (read, _) = scenario_file::parse(&written).unwrap();
    assert_eq!(read, scenario);
    let link = scenario_link::write(&scenario, &Edits::none());
    assert_eq!(scenario_link::parse(&link).unwrap().0, scenario);
    // In the running cut, at once: first the formula, then who is to take it.
    let plain = quiet().with(without).unwrap();
    let mut edits = Edits::none();
    for path in ["formula.force", "plant.calibration", "belief.calibration"] {
        let value = scenario.get(path).unwrap();
        edits.push(&plain, Edit { at_s: 2.0, path: path.to_owned(), value }).unwrap();
    }
    let run = Run::complete(&plain, &edits);
    let rows = run.recording().rows();
    let model = model(&scenario);
    let [before, after] =
        [1.9, 3.0].map(|at_s| rows.iter().find(|row| row.time_s >= at_s).unwrap());
    let at = |row: &Row| model.at(&[row.feed_mm_min, row.spindle_rpm]).value;
    assert!((before.force_n - at(before)).abs() > 1e-3 && (after.force_n - at(after)).abs() < 1e-9);
}

#[test]
fn a_formula_that_may_have_no_value_is_refused_with_the_reason() {
    let mut scenario = quiet();
    for (text, part) in [
        (
            scenario.get("formula.force").unwrap().to_string().replace("f / 256", "f / 256 - 1"),
            "may",
        ),
        ("x".to_owned(), "not TOML"),
    ] {
        let refused = scenario.set("formula.force", Value::Text(text)).unwrap_err().to_string();
        assert!(refused.contains("formula.force"), "{refused}");
        assert!(refused.contains(part) || refused.contains("not certain"), "{refused}");
    }
}

#[test]
fn the_calibration_of_formulas_is_refused_without_one() {
    let none = || ("formula.force".to_owned(), Value::Text(String::new()));
    let mut scenario = quiet();
    let refused = scenario.set_all(&[none()]).unwrap_err().to_string();
    assert!(refused.contains("plant.calibration") && refused.contains("formula.ra"), "{refused}");
    let identified = Value::Text("identified".to_owned());
    let of = |path: &str, value: &Value| (path.to_owned(), value.clone());
    // The plant's alone: the controller still has nothing to believe in.
    let refused = scenario.set_all(&[none(), of("plant.calibration", &identified)]).unwrap_err();
    assert!(refused.to_string().contains("belief.calibration"), "{refused}");
    scenario
        .set_all(&[
            none(),
            of("plant.calibration", &identified),
            of("belief.calibration", &identified),
        ])
        .unwrap();
    assert!(scenario.formula.force.get().is_none());
    let formula = Value::Text("formula".to_owned());
    for path in ["plant.calibration", "belief.calibration"] {
        let refused = scenario.set(path, formula.clone()).unwrap_err().to_string();
        for part in [path, "formula.force", "first the formula"] {
            assert!(refused.contains(part), "{path}: {part}: {refused}");
        }
        let edit = Edit { at_s: 1.0, path: path.to_owned(), value: formula.clone() };
        assert!(Edits::none().push(&scenario, edit).is_err(), "{path}");
    }
    // A formula of the controller's alone does nothing to the plant.
    let feed = Value::Text(FeedOfForce::EXAMPLE.to_owned());
    let believed = [of("formula.feed", &feed), of("belief.calibration", &formula)];
    scenario.set_all(&believed).unwrap();
    assert!(scenario.set("plant.calibration", formula.clone()).is_err());
    // The milling simulator has one set of models, whatever is asked for.
    let milling = Value::Text("milling_2005".to_owned());
    let set = [of("plant.model_set", &milling), of("plant.calibration", &formula)];
    scenario.set_all(&set).unwrap();
}
