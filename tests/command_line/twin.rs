//! `steadycut run --twin`: what a cut is compared with.

use std::process::{Command, Output};

use serde_json::Value;

fn run(args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_steadycut")).arg("run").args(args).output().unwrap()
}

fn json(args: &[&str]) -> Value {
    let output = run(&[args, &["--json"]].concat());
    let error = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "{error}");
    serde_json::from_slice(&output.stdout).unwrap()
}

#[test]
fn the_safe_feed_is_found_and_told_with_what_control_buys() {
    let report = json(&["depth-step", "--twin", "safe"]);
    let twin = &report["twin"];
    assert_eq!(twin["kind"], "safe");
    assert_eq!(twin["above_tolerance_percent"], 0.0);
    assert_eq!((&twin["run_holds"], &twin["twin_holds"]), (&Value::Bool(true), &Value::Bool(true)));
    let (feed, saved) =
        (twin["feed_mm_min"].as_f64().unwrap(), twin["time_saved_percent"].as_f64().unwrap());
    assert!(feed < 430.0 && saved > 10.0, "{twin}");
    let [run_s, twin_s] = [&report, twin].map(|of| of["time_of_cut_s"].as_f64().unwrap());
    assert!((saved - 100.0 * (1.0 - run_s / twin_s)).abs() < 0.2, "{run_s} {twin_s} {saved}");
    // The run itself is the same.
    assert_eq!(report["digest"], json(&["depth-step"])["digest"]);
    assert!(json(&["depth-step"]).get("twin").is_none());
    let text = run(&["depth-step", "--twin", "safe"]);
    let text = String::from_utf8(text.stdout).unwrap();
    assert!(
        text.contains(&format!("safe constant feed: {feed:.0} mm/min at 1571 1/min")),
        "{text}"
    );
    let most = report["above_tolerance_percent"].as_f64().unwrap();
    let equal = format!("at most {most:.1} % above the tolerance");
    assert!(text.contains("% of the time") && text.contains(&equal), "{text}");
    // One step more is not safe: as programmed feed of a run of its own.
    let more = format!("program.feed_mm_min={}", feed + 1.0);
    let more = json(&["depth-step", "--set", &more, "--set", "controller.kind=constant_feed"]);
    assert!(more["above_tolerance_percent"].as_f64().unwrap() > 1.0, "{more}");
}

#[test]
fn as_programmed_it_is_the_program_s_feed_and_who_holds_is_told() {
    let twin = json(&["depth-step", "--twin", "programmed"])["twin"].clone();
    assert_eq!((&twin["kind"], &twin["feed_mm_min"]), (&"programmed".into(), &430.41.into()));
    assert_eq!((&twin["run_holds"], &twin["twin_holds"]), (&true.into(), &false.into()));
    assert!(twin["time_saved_percent"].is_null(), "{twin}");
    let none = json(&["table3-5", "--twin", "safe", "--set", "workpiece.axial_depth_mm=4"]);
    let twin = &none["twin"];
    assert_eq!(twin["kind"], "programmed", "{twin}");
    assert!(twin["no_safe_feed"].as_str().unwrap().contains("no constant feed is safe"), "{twin}");
}

#[test]
fn the_choice_is_a_setting_of_what_compares() {
    let story = |args: &[&str]| json(args)["story"].to_string();
    assert!(story(&["depth-step", "--story"]).contains("safe constant feed"));
    let programmed = story(&["depth-step", "--story", "--set", "twin.kind=programmed"]);
    assert!(!programmed.contains("safe") && programmed.contains("constant feed stays outside"));
    assert_eq!(programmed, story(&["depth-step", "--story", "--twin", "programmed"]));
    for (args, said) in [
        (&["depth-step", "--set", "twin.kind=safe"][..], "moves none"),
        (&["depth-step", "--twin", "safe", "--set", "twin.kind=safe"], "say the same"),
        (&["depth-step", "--twin", "fast"], "safe or programmed"),
        (
            &["depth-step", "--twin", "programmed", "--set", "twin.free_speed=true"],
            "`twin.kind` is programmed",
        ),
    ] {
        let output = run(args);
        let error = String::from_utf8(output.stderr).unwrap();
        assert!(!output.status.success() && error.contains(said), "{args:?}: {error}");
    }
}

/// A person reads the titles first, in their groups; the name that the command line takes stands beside.
#[test]
fn scenarios_are_listed_by_title_in_groups() {
    let output = Command::new(env!("CARGO_BIN_EXE_steadycut")).arg("list").output().unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines[0], "Start here");
    assert!(lines[1].starts_with("  A deeper stretch") && lines[1].ends_with("run depth-step"));
    for group in ["Own models", "Machine: vibration, chatter, tool life", "Papers: SDNRP 2007"] {
        assert!(lines.iter().any(|line| line.starts_with(group)), "{group}");
    }
}
