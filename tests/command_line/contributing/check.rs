//! Asks a core that has the controller of CONTRIBUTING.md for all that the guide promises of it.

use steadycut_core::base::settings::Value;
use steadycut_core::blocks::control::ControllerKind;
use steadycut_core::blocks::control::law::{AtRest, Held};
use steadycut_core::models::genetic::ModelSet;
use steadycut_core::run::edits::{Edit, Edits};
use steadycut_core::run::explanation::explain_controller;
use steadycut_core::run::one_run::{End, Run};
use steadycut_core::run::presets::load;
use steadycut_core::run::scenario::{Scenario, table};
use steadycut_core::run::scenario_file;

fn main() {
    let kind = ControllerKind::from_id("integral").expect("in the list");
    assert_eq!(ControllerKind::ALL.last(), Some(&kind));
    assert_eq!(
        (kind.label(), kind.group(), kind.held()),
        ("Integral", "controller.integral", Held::Force)
    );

    // Its settings: in the table, behind those of the other controllers, and in a file.
    let paths: Vec<&str> = table().iter().map(|param| param.path.as_str()).collect();
    let at = paths.iter().position(|path| *path == "controller.integral.ki").expect("in the table");
    assert!(paths[at - 1].starts_with("controller.") && !paths[at + 1].starts_with("controller."));
    let mut scenario = load("table3-5").expect("shipped");
    scenario.set("controller.kind", Value::Text("integral".to_owned())).expect("a controller");
    scenario.set("controller.integral.ki", Value::Float(0.04)).expect("within its range");
    let refused = scenario.set("controller.integral.ki", Value::Float(2.0)).expect_err("beyond it");
    assert!(refused.to_string().contains("a number from 0 to 1"), "{refused}");
    let file = scenario_file::write(&scenario, &Edits::none());
    assert!(file.contains("[controller.integral]"), "{file}");

    // It runs as itself, and comes to rest where it says.
    assert_eq!(scenario.controller.at_rest(), AtRest::OnReference);
    let run = Run::complete(&scenario, &Edits::none());
    assert_eq!(run.end(), Some(&End::TimeLimit));
    let last = run.recording().rows().last().expect("a row");
    assert!((last.force_n / last.force_ref_n - 1.0).abs() < 0.005, "{last:?}");
    for other in ControllerKind::ALL.iter().filter(|other| **other != kind) {
        let mut others: Scenario = scenario.clone();
        others.set("controller.kind", Value::Text(other.id().to_owned())).expect("a controller");
        let digest = Run::complete(&others, &Edits::none()).recording().digest();
        assert_ne!(digest, run.recording().digest(), "it runs as {}", other.label());
    }

    // It takes over a cut that another controller has brought to rest, without a bump.
    let mut before = scenario.clone();
    before.set("controller.kind", Value::Text("tracking".to_owned())).expect("a controller");
    let (path, value) = ("controller.kind".to_owned(), Value::Text("integral".to_owned()));
    let mut edits = Edits::none();
    edits.push(&before, Edit { at_s: 8.0, path, value }).expect("a live setting");
    let switched = Run::complete(&before, &edits);
    let index = switched.recording().index_at(8.0);
    let [rest, taken] =
        [0, 1].map(|i| switched.recording().rows()[index + i].feed_override_percent);
    assert!((taken - rest).abs() < 0.5, "{rest} % to {taken} %");

    // Its law, with its source and with values.
    let printed = scenario.controller.printed(ModelSet::Sdnrp2007);
    assert!(printed[0].formula.contains("Ki") && printed[0].source.contains("textbook"));
    let lines = explain_controller(&scenario, last).lines;
    assert_eq!(lines[1].formula, "u grows by 0.04 (1 - y)");
    assert!(lines[1].values.starts_with("u = "), "{lines:?}");
}
