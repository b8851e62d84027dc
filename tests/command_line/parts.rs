//! `steadycut part`, and `--part`: parts of one's own.

use std::fs;

use steadycut::study::part::{EXAMPLE_CSV, EXAMPLE_GCODE};

use super::program::{json, refused, steadycut, temporary};

#[test]
fn a_table_is_the_part_of_a_run_and_of_the_scenario_that_is_saved() {
    let table = temporary("part.csv");
    fs::write(&table, EXAMPLE_CSV).unwrap();
    let table = table.to_str().unwrap();
    let run = ["run", "first-cut", "--part", table, "--json"];
    let run = json(&run);
    assert!(run["path_mm"].as_f64().unwrap() >= 130.0, "{run}");
    let saved = temporary("part-of-a-table.toml");
    let saved = saved.to_str().unwrap();
    let told = json(&["part", "from-csv", table, "--save", saved, "--json"]);
    assert_eq!((&told["length_mm"], &told["air_mm"]), (&130.0.into(), &6.0.into()));
    assert_eq!(json(&["run", saved, "--json"])["digest"], run["digest"]);
    // Back to a table, and the same run again.
    let again = temporary("part-again.csv");
    let again = again.to_str().unwrap();
    assert!(steadycut(&["part", "to-csv", saved, "--out", again]).status.success());
    let repeated = json(&["run", "first-cut", "--part", again, "--json"]);
    assert_eq!(repeated["digest"], run["digest"]);
    // What is said stays.
    let short = ["run", "first-cut", "--part", table, "--json", "--set", "run.duration_s=3"];
    assert_eq!(json(&short)["end"], "time_limit");
    let twice = refused(&[&short[..4], &["--set", "workpiece.length_mm=5"]].concat());
    assert!(twice.contains("--part") && twice.contains("workpiece.length_mm"), "{twice}");
}

#[test]
fn a_program_over_a_blank_becomes_a_table_and_a_scenario() {
    let [program, table, saved] = ["part.nc", "path.csv", "part-of-a-program.toml"].map(temporary);
    fs::write(&program, EXAMPLE_GCODE).unwrap();
    let [program, table, saved] = [&program, &table, &saved].map(|path| path.to_str().unwrap());
    let into = ["--tool", "square-12-4", "--out", table, "--save", saved, "--json"];
    let make = ["part", "from-gcode", program, "--blank", "100,60,20"];
    let told = json(&[&make[..], &into].concat());
    assert_eq!((&told["axial_max_mm"], &told["radial_max_mm"]), (&3.0.into(), &12.0.into()));
    assert_eq!(told["rapids_through_material"], serde_json::json!([]));
    let remarks = told["remarks"].to_string();
    assert!(remarks.contains("M6, lines 6"), "{remarks}");
    let from_table = ["run", "first-cut", "--set", "tool.name=square-12-4", "--part", table];
    let [one, other] =
        [&["run", saved][..], &from_table].map(|run| json(&[run, &["--json"]].concat()));
    assert_eq!(one["digest"], other["digest"]);
    for (args, named) in [
        (vec!["run", "first-cut", "--part", program], "part from-gcode"),
        (vec!["part", "from-gcode", program, "--blank", "100,60"], "X,Y,Z"),
        (vec!["part", "from-gcode", program, "--blank", "100,0,5"], "along Y is 0 mm"),
        (vec!["part", "from-gcode", table, "--blank", "100,60,20"], "line 1: "),
        (vec!["part", "to-csv", "experiment-1"], "cuts"),
    ] {
        let said = refused(&args);
        assert!(said.contains(named), "{args:?}: {said}");
    }
}

#[test]
fn every_command_that_takes_a_scenario_takes_its_part_or_says_why_not() {
    let table = temporary("part-everywhere.csv");
    fs::write(&table, EXAMPLE_CSV).unwrap();
    let table = table.to_str().unwrap();
    // The same as with the scenario that has the part already.
    let saved = temporary("part-everywhere.toml");
    let saved = saved.to_str().unwrap();
    let into = ["--scenario", "experiment-2", "--save", saved];
    assert!(steadycut(&[&["part", "from-csv", table], &into[..]].concat()).status.success());
    let both = |before: &[&str], preset: &[&str], file: &[&str]| {
        let with = json(&[before, preset, &["--part", table, "--json"]].concat());
        assert_eq!(with, json(&[before, file, &["--json"]].concat()), "{before:?}");
        with
    };
    let taught = both(&["afc", "teach"], &["experiment-2"], &[saved]);
    assert_eq!(taught["references_n"].as_array().map(Vec::len), Some(1), "one way is one cut");
    let set = ["combine", "--scenario"];
    let combined = both(&set, &["experiment-2"], &[saved]);
    assert!(combined["run"]["ticks"].is_u64(), "{combined}");
    // The log is that of AFC on the part; what was taught in goes with it.
    let under = temporary("part-under-afc.toml");
    let under = under.to_str().unwrap();
    let teach = ["afc", "teach", "experiment-2", "--part", table, "--out", under];
    assert!(steadycut(&teach).status.success());
    let log = both(&["afc", "log"], &[under], &[under]);
    assert_eq!(log["cuts"].as_array().map(Vec::len), Some(1), "{log}");
    for (args, named) in [
        (vec!["experiment", "--part", table], "every cut is short, straight and of one depth"),
        (vec!["experiment", "--run", "--part", table], "every cut is short"),
        (vec!["machine", "stability", "--part", table], "is asked about one cut"),
        (vec!["machine", "wear", "--part", table], "has no use for it: the machine"),
        (vec!["combine", "--part", table, "--set", "workpiece.length_mm=5"], "workpiece.length_mm"),
    ] {
        let said = refused(&args);
        assert!(said.contains("--part") && said.contains(named), "{args:?}: {said}");
    }
}
