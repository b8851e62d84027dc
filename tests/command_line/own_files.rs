//! Files of a user's own on the command line: begun, checked, taken, refused.

use steadycut::study::own_file::OwnFileKind;

use super::program::{json, refused, steadycut, temporary};

/// A file with a text, under a name of this test's own.
fn written(name: &str, text: &str) -> String {
    let path = temporary(name);
    std::fs::write(&path, text).unwrap();
    path.to_str().unwrap().to_owned()
}

#[test]
fn what_is_begun_is_checked_and_a_run_takes_it() {
    let plain = json(&["run", "first-cut", "--json"])["digest"].clone();
    for (kind, option) in [("tool", "--tool"), ("material", "--material"), ("machine", "--machine")]
    {
        let begun = steadycut(&["own", "new", kind]);
        let file = written(&format!("own-{kind}.toml"), &String::from_utf8(begun.stdout).unwrap());
        let told = json(&["own", "check", &file, "--json"]);
        assert_eq!(told["kind"], kind);
        assert!(!told["settings"].as_object().unwrap().is_empty(), "{told}");
        let run = json(&["run", "first-cut", option, &file, "--json"]);
        assert_ne!(run["digest"], plain, "{kind}");
    }
}

#[test]
fn set_comes_after_a_file() {
    let file = written("own-later.toml", OwnFileKind::Tool.template());
    let of =
        |args: &[&str]| json(&[&["run", "first-cut", "--json"], args].concat())["digest"].clone();
    let own = of(&["--tool", &file]);
    assert_ne!(of(&["--tool", &file, "--set", "tool.teeth=2"]), own);
    assert_eq!(of(&["--tool", &file, "--set", "tool.teeth=3"]), own);
    // A shipped cutter beside it would be the one or the other.
    let both = ["run", "first-cut", "--tool", &file, "--set", "tool.name=r216-16b20-040"];
    assert!(
        refused(&both).contains("--tool and --set tool.name say the same"),
        "{}",
        refused(&both)
    );
}

#[test]
fn the_chart_of_measured_modes_is_printed_and_agrees_with_its_simulation() {
    let file = written("own-tip.toml", OwnFileKind::Structure.template());
    let speeds = ["--from", "12000", "--to", "17000", "--speeds", "2"];
    let args = [&["machine", "stability", "--structure", &file, "--json", "--check"], &speeds[..]];
    // Two speeds are fewer than the check wants, so that its answer is 1.
    let output = steadycut(&args.concat());
    let told: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!((&told["tip_modes"], &told["check"]["mean"]), (&2.into(), &serde_json::Value::Null));
    for point in told["points"].as_array().unwrap() {
        let number = |key: &str| point[key].as_f64().unwrap();
        let (chart, simulated) = (number("interrupted_mm"), number("simulated_interrupted_mm"));
        assert!((simulated / chart - 1.0).abs() < 0.03, "{point}");
        assert!(number("mean_mm") > 0.0 && point["simulated_mean_mm"].is_null());
    }
    let text = steadycut(&[&["machine", "stability", "--structure", &file], &speeds[..]].concat());
    let text = String::from_utf8(text.stdout).unwrap();
    assert!(text.contains("x 922 Hz") && text.contains("up-milling"), "{text}");
}

#[test]
fn faults_name_the_file_and_what_a_command_has_no_use_for_is_refused() {
    let bad = OwnFileKind::Tool.template().replacen("teeth = 3", "teeth = 30", 1);
    let bad = written("own-bad.toml", &bad);
    let error = refused(&["run", "first-cut", "--tool", &bad]);
    assert!(
        error.contains(&bad) && error.contains("line 9") && error.contains("1 to 8"),
        "{error}"
    );
    let tip = written("own-unused.toml", OwnFileKind::Structure.template());
    let error = refused(&["run", "first-cut", "--structure", &tip]);
    assert!(error.contains("--structure") && error.contains("machine.coupled"), "{error}");
    let error = refused(&["machine", "modes", "--structure", &tip]);
    assert!(error.contains("--structure") && error.contains("no use"), "{error}");
    let none = written("own-none.toml", "a = 1\n");
    assert!(refused(&["own", "check", &none]).contains("kc11_n_mm2"));
}

#[test]
fn a_measured_response_becomes_a_structure_that_the_chart_takes() {
    let data = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/data/tip_response_example.csv");
    let file = temporary("own-identified.toml");
    let file = file.to_str().unwrap();
    let told = json(&["identify", "structure", "--x", data, "--out", file, "--json"]);
    let fit = &told["fits"][0];
    let modes = fit["modes"].as_array().unwrap();
    assert_eq!(modes.len(), 2, "{fit}");
    for (mode, [hz, damping, kg]) in
        modes.iter().zip([[922.0, 0.011, 0.03993], [1740.0, 0.02, 0.11]])
    {
        let near = |key: &str, known: f64, share: f64| {
            let found = mode[key].as_f64().unwrap();
            assert!((found / known - 1.0).abs() < share, "{key}: {found} {known}");
        };
        near("frequency_hz", hz, 1e-4);
        near("damping_ratio", damping, 1e-2);
        near("mass_kg", kg, 1e-2);
    }
    assert!(fit["rest"].as_f64().unwrap() < 1e-3, "{fit}");
    assert_eq!(json(&["own", "check", file, "--json"])["kind"], "structure");
    let chart =
        ["machine", "stability", "--structure", file, "--speeds", "1", "--from", "9000", "--json"];
    assert!(json(&chart)["points"][0]["interrupted_mm"].as_f64().unwrap() > 0.0);
}
