//! What the documents say is true: every command of README.md and CONTRIBUTING.md runs, every file that
//! they and ARCHITECTURE.md name is there, and versions agree.
//!
//! A command that is too slow for every `cargo test` is shortened by its own options or watched for
//! its first seconds ([`SHORTER`], [`WATCHED`]); `STEADYCUT_DOCUMENTS=whole cargo test --release
//! documents` runs all as they stand, to their ends.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

use steadycut::run::edits::Edits;
use steadycut::run::job::Job;
use steadycut::run::{presets, scenario_file};
use steadycut::study::mission::{Marking, MissionAnswer, MissionResult, shipped};
use steadycut::study::part::{EXAMPLE_CSV, EXAMPLE_GCODE};

use crate::packing;

/// Start of a command, and an option that is given this value in place of the one it has.
const SHORTER: [(&str, &str, &str); 7] = [
    ("machine stability", "--speeds", "2"),
    ("experiment way", "--batches", "2"),
    ("robust", "--runs", "2"),
    ("unks", "--passes", "1"),
    ("machine life", "--tools", "5"),
    ("train force", "--rows", "400"),
    ("train force", "--epochs", "2"),
];

/// Commands that no option makes short: they must start and not fail in their first seconds. `.ci/run` runs those
/// that train to their ends.
const WATCHED: [&str; 4] = ["papers --paper 2005", "train --study", "train unks", "train genetic"];
/// How long such a command is watched. Arguments, files and settings are refused within some 0.1 s.
const WATCH: Duration = Duration::from_secs(3);

fn top() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn document(name: &str) -> String {
    fs::read_to_string(top().join(name)).unwrap()
}

fn both() -> String {
    document("README.md") + "\n" + document("CONTRIBUTING.md").as_str()
}

/// The lines of the fenced blocks marked `sh`, comments left out.
fn commands(text: &str) -> Vec<String> {
    let (mut commands, mut fenced) = (Vec::new(), false);
    for line in text.lines().map(str::trim) {
        match line.strip_prefix("```") {
            Some(language) => fenced = language == "sh",
            None if fenced => commands.push(line.split(" #").next().unwrap().trim().to_owned()),
            None => {}
        }
    }
    commands.retain(|command| !command.is_empty() && !command.starts_with('#'));
    commands
}

/// The arguments of a command of the program, shortened unless `whole`.
fn arguments(command: &str, whole: bool) -> Vec<String> {
    // What a shell leaves of it: quoted parts stay together.
    let parts = command.split('\'').enumerate().flat_map(|(index, part)| match index % 2 {
        1 => vec![part.to_owned()],
        _ => part.split_whitespace().map(str::to_owned).collect(),
    });
    let mut arguments: Vec<String> = parts.collect();
    for (start, option, value) in SHORTER {
        if whole || !command.starts_with(start) {
            continue;
        }
        match arguments.iter().position(|argument| argument == option) {
            Some(at) => arguments[at + 1] = value.to_owned(),
            None => arguments.extend([option.to_owned(), value.to_owned()]),
        }
    }
    arguments
}

fn start(command: &str, whole: bool, folder: &Path) -> Child {
    Command::new(env!("CARGO_BIN_EXE_steadycut"))
        .args(arguments(command, whole))
        .current_dir(folder)
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

/// Waits for the end, which must be a success.
fn succeeds(command: &str, child: Child) {
    let output = child.wait_with_output().unwrap();
    let error = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "`steadycut {command}`: {error}");
}

/// What the console saves of this answer to the mission `quiet-speed`.
fn saved_result(answer: &str) -> String {
    let mission = shipped::load("quiet-speed").unwrap();
    let answer = MissionAnswer::read(answer, &mission).unwrap();
    let mut marking = Marking::new(&mission, answer.clone()).unwrap();
    marking.to_end();
    let verdict = marking.partial().unwrap();
    MissionResult::new(&mission, &answer, verdict, 0, "2026-01-02T03:04:05Z".to_owned()).write()
}

/// A folder with the files that the documents take as given.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    fs::create_dir_all(&folder).unwrap();
    let scenario = presets::load("table3-5").unwrap();
    let text = scenario_file::write(&scenario, &Edits::none());
    fs::write(folder.join("my-scenario.toml"), text).unwrap();
    let table = include_str!("../../assets/data/table3_2007.csv");
    fs::write(folder.join("my-table.csv"), table).unwrap();
    let tip = include_str!("../../assets/structures/slender-cutter.toml");
    fs::write(folder.join("my-tip.toml"), tip).unwrap();
    let cut = include_str!("../../crates/measured/tests/data/excel.csv");
    fs::write(folder.join("my-cut.csv"), cut).unwrap();
    fs::write(folder.join("my-part.nc"), EXAMPLE_GCODE).unwrap();
    fs::write(folder.join("my-part.csv"), EXAMPLE_CSV).unwrap();
    let readings = "speed_m_min,time_min,vb_mm\n130,20,0.2\n130,35,0.35\n200,4,0.2\n200,7,0.36\n";
    fs::write(folder.join("my-readings.csv"), readings).unwrap();
    let turn = ["run", "square-12-4-42crmo4", "--set", "controller.kind=constant_feed"];
    let turn = Command::new(env!("CARGO_BIN_EXE_steadycut"))
        .args(turn)
        .args(["--revolution", "2"])
        .output();
    fs::write(folder.join("my-forces.csv"), turn.unwrap().stdout).unwrap();
    let answer = include_str!("../../crates/study/tests/data/missions/quiet-speed.right.toml");
    fs::write(folder.join("my-answer.toml"), answer).unwrap();
    fs::write(folder.join("quiet-speed-result.json"), saved_result(answer)).unwrap();
    packing::page(&folder.join("web").join("dist"));
    folder
}

/// Commands of the program, as they stand behind its name.
fn of_the_program() -> Vec<String> {
    let all = commands(&both()).into_iter();
    all.filter_map(|command| command.strip_prefix("steadycut ").map(str::to_owned)).collect()
}

#[test]
fn every_command_of_the_documents_runs() {
    let whole = std::env::var("STEADYCUT_DOCUMENTS").is_ok_and(|how| how == "whole");
    let folder = folder("documents");
    let all = of_the_program();
    assert!(all.len() >= 25, "only {} commands found", all.len());
    let is_watched =
        |command: &&String| !whole && WATCHED.iter().any(|start| command.starts_with(start));
    let watched: Vec<(&String, Child)> = all
        .iter()
        .filter(is_watched)
        .map(|command| (command, start(command, whole, &folder)))
        .collect();
    if !watched.is_empty() {
        sleep(WATCH);
    }
    for (command, mut child) in watched {
        match child.try_wait().unwrap() {
            Some(_) => succeeds(command, child),
            None => {
                child.kill().unwrap();
                child.wait().unwrap();
            }
        }
    }
    for command in all.iter().filter(|command| !is_watched(command)) {
        succeeds(command, start(command, whole, &folder));
    }
}

#[test]
fn every_shortening_belongs_to_a_command() {
    let all = of_the_program();
    for start in SHORTER.iter().map(|(start, ..)| start).chain(&WATCHED) {
        assert!(all.iter().any(|command| command.starts_with(start)), "{start}");
    }
}

#[test]
fn a_command_that_does_not_exist_is_found_out() {
    for wrong in ["papers --paper 2005 --sneeds 1", "run table3-55", "trian force"] {
        let output = start(wrong, true, &folder("documents-wrong")).wait_with_output().unwrap();
        assert!(!output.status.success(), "{wrong}");
    }
}

/// What is not the program: Cargo's own, and scripts of this folder.
#[test]
fn every_script_of_the_documents_is_there() {
    let others = commands(&both()).into_iter().filter(|command| !command.starts_with("steadycut "));
    let mut scripts = 0;
    for command in others {
        let program = command.split_whitespace().next().unwrap();
        if ["cargo", "git", "rustup"].contains(&program) {
            continue;
        }
        assert!(top().join(program).is_file(), "`{command}`: there is no {program}");
        scripts += 1;
    }
    assert!(scripts >= 2, "README.md names web/build and web/serve");
}

/// The files of the worked examples in CONTRIBUTING.md, which are not there until somebody follows it.
const TO_BE_WRITTEN: [&str; 3] = [
    "crates/core/src/blocks/control/integral.rs",
    "crates/core/src/blocks/cutting/force_model/power.rs",
    "src/app/panels/signals.rs",
];

/// Every file and folder below the top, as `/path/from/the/top`, folders with a `/` behind too.
fn tree() -> Vec<String> {
    let (mut found, mut open) = (Vec::new(), vec![top().to_owned()]);
    while let Some(folder) = open.pop() {
        for entry in fs::read_dir(&folder).unwrap().map(Result::unwrap) {
            let name = entry.file_name().into_string().unwrap();
            if [".git", "target", "node_modules", "dist"].contains(&name.as_str()) {
                continue;
            }
            let path = entry.path();
            let from_top = path.strip_prefix(top()).unwrap().to_str().unwrap().replace('\\', "/");
            if path.is_dir() {
                found.push(format!("/{from_top}/"));
                open.push(path);
            } else {
                found.push(format!("/{from_top}"));
            }
        }
    }
    found
}

/// Whether a name in a document is there: a path from the top, or the end of one; a module without
/// its ending; `study/` is the source of the crate of studies.
fn is_there(tree: &[String], name: &str) -> bool {
    let name = name.trim_end_matches('/');
    let in_study = name.strip_prefix("study/").map(|rest| format!("study/src/{rest}"));
    [Some(name.to_owned()), in_study].into_iter().flatten().any(|name| {
        let ends = [format!("/{name}"), format!("/{name}/"), format!("/{name}.rs")];
        tree.iter().any(|path| ends.iter().any(|end| path.ends_with(end)))
    })
}

#[test]
fn every_file_that_the_documents_name_is_there() {
    let tree = tree();
    let text = ["README.md", "ARCHITECTURE.md", "CONTRIBUTING.md"].map(document).join("\n");
    let is_path = |name: &&str| {
        name.chars().all(|c| c.is_ascii_alphanumeric() || "_./-".contains(c))
            && (name.contains('/') || [".rs", ".toml", ".md"].iter().any(|end| name.ends_with(end)))
    };
    // Every second piece between backticks stands inside a pair; a fence makes an empty one.
    let names: Vec<&str> =
        text.lines().flat_map(|line| line.split('`').skip(1).step_by(2)).collect();
    let paths: Vec<&str> = names.into_iter().filter(is_path).collect();
    assert!(paths.len() > 60, "only {} paths found", paths.len());
    for path in paths {
        assert!(TO_BE_WRITTEN.contains(&path) || is_there(&tree, path), "there is no {path}");
    }
    assert!(!is_there(&tree, "run/closed_loops.rs") && !is_there(&tree, "base/model"));
}

#[test]
fn the_citation_has_the_version_and_the_four_papers() {
    let citation = document("CITATION.cff");
    assert!(citation.contains(concat!("\nversion: ", env!("CARGO_PKG_VERSION"), "\n")));
    for year in [2005, 2007, 2013, 2019] {
        assert!(citation.contains(&format!("    year: {year}\n")), "{year}");
    }
}

/// What is not released stands on top, every version has its day, and this one is among them.
#[test]
fn the_changelog_is_dated() {
    let text = document("CHANGELOG.md");
    let headings: Vec<&str> = text.lines().filter_map(|line| line.strip_prefix("## ")).collect();
    assert_eq!(headings[0], "Unreleased");
    for heading in &headings[1..] {
        let (version, day) = heading.split_once(" (").expect("a version and its day");
        assert!(version.split('.').all(|part| part.parse::<u32>().is_ok()), "{heading}");
        let day: Vec<&str> =
            day.strip_suffix(')').expect("the day in brackets").split('-').collect();
        assert!(
            matches!(day[..], [year, month, day] if year.len() == 4 && month.len() == 2 && day.len() == 2)
        );
    }
    let this = concat!(env!("CARGO_PKG_VERSION"), " (");
    assert!(headings.iter().any(|heading| heading.starts_with(this)), "{this}");
}
