//! `steadycut afc`: teach-in and log.

use steadycut::blocks::control::ControllerKind;
use steadycut::run::{presets, scenario_file};

use super::program::{json, refused, steadycut, temporary};

#[test]
fn what_is_taught_in_is_written_and_its_log_read() {
    let file = temporary("taught.toml");
    let path = file.to_str().unwrap();
    let report = json(&["afc", "teach", "experiment-2-neural", "--out", path, "--json"]);
    let found: Vec<f64> =
        report["references_n"].as_array().unwrap().iter().map(|n| n.as_f64().unwrap()).collect();
    assert_eq!((found.len(), report["whole_part"].as_bool()), (5, Some(true)));
    let (scenario, edits) = scenario_file::parse(&std::fs::read_to_string(&file).unwrap()).unwrap();
    assert!(edits.list().is_empty());
    assert_eq!(scenario.controller.kind, ControllerKind::Afc);
    assert_eq!(scenario.controller.afc.references_n, found);
    let before = presets::load("experiment-2-neural").unwrap();
    let changed: Vec<&str> =
        scenario.difference(&before).iter().map(|(param, _)| param.path.as_str()).collect();
    assert_eq!(changed, ["controller.kind", "controller.afc.references_n"]);

    let table = temporary("afc-log.csv");
    let log = json(&["afc", "log", path, "--out", table.to_str().unwrap(), "--json"]);
    assert_eq!(log["end"], "path_done");
    let cuts = log["cuts"].as_array().unwrap();
    assert_eq!(cuts.len(), 5);
    for (cut, reference_n) in cuts.iter().zip(&found) {
        assert_eq!(cut["reference_n"].as_f64(), Some(*reference_n));
        assert!(cut["least_factor_percent"].as_f64().unwrap() >= 50.0, "{cut}");
    }
    // Light stretches and the air are gone through faster.
    assert!(log["sum"]["difference_percent"].as_f64().unwrap() < 0.0, "{log}");
    assert_eq!(std::fs::read_to_string(table).unwrap().lines().count(), 6);
    let text = String::from_utf8(steadycut(&["afc", "log", path]).stdout).unwrap();
    assert!(text.contains("least feed %") && text.contains("all"), "{text}");
}

#[test]
fn what_no_log_is_of_is_refused() {
    let error = refused(&["afc", "log", "first-cut"]);
    assert!(error.contains("`controller.kind` is sdnrp") && error.contains("afc teach"), "{error}");
    let error = refused(&["afc", "teach", "no-such-preset"]);
    assert!(error.contains("no-such-preset"), "{error}");
}
