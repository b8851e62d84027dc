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

/// A folder of this test's own.
fn folder(name: &str) -> std::path::PathBuf {
    let folder = temporary(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    folder
}

#[test]
fn a_folder_is_listed_by_kind_with_what_is_broken() {
    let folder = folder("own-folder");
    let tool = OwnFileKind::Tool.template();
    std::fs::create_dir(folder.join("shop")).unwrap();
    std::fs::write(folder.join("shop/mill.toml"), tool).unwrap();
    std::fs::write(folder.join("bad.toml"), tool.replacen("teeth = 3", "teeth = 30", 1)).unwrap();
    std::fs::write(folder.join("latin.toml"), b"title = \"Fr\xe4ser\"").unwrap();
    std::fs::write(folder.join("c60.toml"), OwnFileKind::Material.template()).unwrap();
    std::fs::write(folder.join("notes.pdf"), "x").unwrap();
    let place = folder.to_str().unwrap();
    let told = json(&["own", "list", place, "--json"]);
    let files = told["files"].as_array().unwrap();
    let named = |name: &str| files.iter().find(|file| file["name"] == name).unwrap();
    assert_eq!((files.len(), &told["others"]), (4, &1.into()));
    let mill = named("shop/mill.toml");
    assert_eq!((&mill["kind"], &mill["fault"]), (&"tool".into(), &serde_json::Value::Null));
    assert_eq!(mill["facts"], "Square end, 3 teeth, 10 mm");
    assert_eq!(mill["settings"]["tool.teeth"], 3);
    let fault = named("bad.toml")["fault"].as_str().unwrap();
    assert!(fault.contains("line 9") && fault.contains("1 to 8"), "{fault}");
    assert!(named("latin.toml")["fault"].as_str().unwrap().contains("Latin-1"));
    let text = String::from_utf8(steadycut(&["own", "list", place]).stdout).unwrap();
    for part in ["Cutters", "shop/mill.toml", "faulty: ", "Materials", "1 other file", place] {
        assert!(text.contains(part), "{part}: {text}");
    }
    assert!(text.find("Cutters") < text.find("Materials"), "{text}");
    assert!(refused(&["own", "list", &format!("{place}/none")]).contains("no such folder"));
    assert!(refused(&["own", "list", &format!("{place}/bad.toml")]).contains("no folder"));
}

#[test]
fn without_a_folder_the_one_that_was_chosen_is_listed() {
    let home = folder("own-home");
    let list = || {
        let output = std::process::Command::new(env!("CARGO_BIN_EXE_steadycut"))
            .args(["own", "list", "--json"])
            .env("XDG_DATA_HOME", &home)
            .env("APPDATA", &home)
            .env("HOME", &home)
            .output()
            .unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        serde_json::from_slice::<serde_json::Value>(&output.stdout).unwrap()
    };
    let told = list();
    assert!(told["folder"].as_str().unwrap().ends_with("files"), "{told}");
    assert_eq!(told["files"].as_array().unwrap().len(), 0, "it need not be there");
    let base = std::path::PathBuf::from(told["folder"].as_str().unwrap());
    let base = base.parent().unwrap();
    let other = folder("own-chosen");
    std::fs::write(other.join("a.toml"), OwnFileKind::Tool.template()).unwrap();
    std::fs::create_dir_all(base).unwrap();
    steadycut::disk::own_folder::OwnFolder::with_home(base.to_owned()).choose(&other).unwrap();
    assert_eq!(list()["files"][0]["name"], "a.toml");
}
