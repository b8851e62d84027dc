//! `steadycut mission`: what a trainer does without a window.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::Value;
use steadycut::run::job::Job;
use steadycut::study::mission::{Marking, MissionAnswer, MissionResult, shipped};

const RIGHT: &str =
    include_str!("../../crates/study/tests/data/missions/depth-step-at-constant-feed.right.toml");
const WRONG: &str =
    include_str!("../../crates/study/tests/data/missions/depth-step-at-constant-feed.wrong.toml");

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("missions").join(name);
    fs::create_dir_all(&folder).unwrap();
    folder
}

fn steadycut(folder: &Path, args: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_steadycut"));
    command.arg("mission").args(args).current_dir(folder).output().unwrap()
}

fn json(output: &Output) -> Value {
    serde_json::from_slice(&output.stdout).unwrap()
}

#[test]
fn missions_are_listed_in_order_with_what_they_are() {
    let output = steadycut(&folder("list"), &["list", "--json"]);
    assert!(output.status.success());
    let report = json(&output);
    let missions = report["missions"].as_array().unwrap();
    assert!(missions.len() >= 14, "{}", missions.len());
    assert_eq!(missions[0]["id"], "depth-step-at-constant-feed");
    for mission in missions {
        assert!(mission["title"].as_str().unwrap().len() > 5, "{mission}");
        assert!(mission["minutes"].as_u64().unwrap() > 0, "{mission}");
        assert!(mission["predictions"].as_u64().unwrap() > 0, "{mission}");
    }
}

#[test]
fn an_answer_is_marked_and_the_exit_code_tells() {
    let folder = folder("answer");
    fs::write(folder.join("right.toml"), RIGHT).unwrap();
    fs::write(folder.join("wrong.toml"), WRONG).unwrap();
    let id = "depth-step-at-constant-feed";
    let right = steadycut(&folder, &["check", id, "--answer", "right.toml", "--json"]);
    assert_eq!(right.status.code(), Some(0));
    let verdict = json(&right);
    assert_eq!((&verdict["passed"], &verdict["stars"]), (&Value::Bool(true), &Value::from(3)));
    // The digest is that of the cut itself, which anybody can repeat.
    let run = Command::new(env!("CARGO_BIN_EXE_steadycut"))
        .args(["run", "depth-step", "--set", "program.feed_mm_min=300", "--json"])
        .output()
        .unwrap();
    assert_eq!(json(&run)["digest"], verdict["digest"]);
    let wrong = steadycut(&folder, &["check", id, "--answer", "wrong.toml"]);
    assert_eq!(wrong.status.code(), Some(1));
    let said = String::from_utf8(wrong.stdout).unwrap();
    assert!(said.contains("NOT passed") && said.contains("does NOT hold"), "{said}");
    assert!(said.contains("out of its tolerance"), "{said}");
}

#[test]
fn a_mission_of_ones_own_is_begun_checked_and_answered() {
    let folder = folder("own");
    let new = steadycut(&folder, &["new", "--out", "my.toml"]);
    assert!(new.status.success());
    let check = steadycut(&folder, &["check", "my.toml"]);
    assert!(check.status.success(), "{}", String::from_utf8_lossy(&check.stderr));
    let text = fs::read_to_string(folder.join("my.toml")).unwrap();
    fs::write(
        folder.join("bad.toml"),
        text.replace("in_tolerance_percent >= 95", "in_tolerance >= 95"),
    )
    .unwrap();
    let bad = steadycut(&folder, &["check", "bad.toml"]);
    assert_eq!(bad.status.code(), Some(2));
    let said = String::from_utf8(bad.stderr).unwrap();
    for word in ["bad.toml", "checks[2].when", "line", "in_tolerance", "did you mean"] {
        assert!(said.contains(word), "{said} lacks {word}");
    }
    // Who does nothing must not pass.
    fs::write(
        folder.join("idle.toml"),
        text.replace("in_tolerance_percent >= 95", "in_tolerance_percent >= 0"),
    )
    .unwrap();
    let idle = steadycut(&folder, &["check", "idle.toml"]);
    assert_eq!(idle.status.code(), Some(1));
    assert!(String::from_utf8(idle.stdout).unwrap().contains("does nothing passes"));
}

#[test]
fn what_is_not_there_is_told_with_what_is() {
    let folder = folder("missing");
    let output = steadycut(&folder, &["show", "quite-speed"]);
    assert_eq!(output.status.code(), Some(2));
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(said.contains("quite-speed") && said.contains("quiet-speed"), "{said}");
    let output = steadycut(&folder, &["check", "quiet-speed", "--answer", "none.toml"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8(output.stderr).unwrap().contains("none.toml"));
}

/// The result that a learner saves is marked again by the same code, and found out where it was edited.
#[test]
fn a_saved_result_is_verified() {
    let folder = folder("result");
    let id = "depth-step-at-constant-feed";
    let mission = shipped::load(id).unwrap();
    let answer = MissionAnswer::read(RIGHT, &mission).unwrap();
    let mut marking = Marking::new(&mission, answer.clone()).unwrap();
    marking.to_end();
    let verdict = marking.partial().unwrap();
    let time = "2026-01-02T03:04:05Z".to_owned();
    let result = MissionResult::new(&mission, &answer, verdict, 1, time).named("Ada");
    fs::write(folder.join("result.json"), result.write()).unwrap();
    for args in [&["check", "result.json"][..], &["check", id, "--answer", "result.json"]] {
        let output = steadycut(&folder, args);
        let said = String::from_utf8(output.stdout).unwrap();
        assert_eq!(output.status.code(), Some(0), "{said}");
        assert!(said.contains("the result is true") && said.contains("of Ada"), "{said}");
    }
    let answer = MissionAnswer::read(WRONG, &mission).unwrap();
    let mut marking = Marking::new(&mission, answer.clone()).unwrap();
    marking.to_end();
    let mut verdict = marking.partial().unwrap();
    (verdict.passed, verdict.stars) = (true, 3);
    let forged = MissionResult::new(&mission, &answer, verdict, 0, String::new());
    fs::write(folder.join("forged.json"), forged.write()).unwrap();
    let output = steadycut(&folder, &["check", "forged.json", "--json"]);
    assert_eq!(output.status.code(), Some(1));
    let report = json(&output);
    assert_eq!((&report["true"], &report["verdict"]["stars"]), (&false.into(), &0.into()));
    assert!(report["untrue"].to_string().contains("`verdict.stars` says 3: the answer gives 0"));
    let output = steadycut(&folder, &["check", "quiet-speed", "--answer", "result.json"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8(output.stderr).unwrap().contains("this mission is `quiet-speed`"));
}

#[test]
fn a_mission_in_a_link_is_told_from_a_cut() {
    let run = |link: &str| {
        Command::new(env!("CARGO_BIN_EXE_steadycut"))
            .args(["run", link, "--json"])
            .output()
            .unwrap()
    };
    let output = run("https://a.org/?embed=hide:bar#embed=lock:all&v=1&target.ra_um=0.6");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let output = run("#mission=quiet-speed");
    assert_eq!(output.status.code(), Some(2));
    let said = String::from_utf8(output.stderr).unwrap();
    assert!(said.contains("`quiet-speed`") && said.contains("mission check"), "{said}");
    let embed = |flags: &str| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_steadycut"));
        let output =
            command.args(["--embed", flags]).env_remove("DISPLAY").env_remove("WAYLAND_DISPLAY");
        String::from_utf8(output.output().unwrap().stderr).unwrap()
    };
    assert!(embed("lock:targt").contains("--embed: `lock:targt`"), "{}", embed("lock:targt"));
}
