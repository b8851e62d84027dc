//! No output destroys an input or an older result: whatever a command writes is whole or not there, and what
//! stood there stays until then.
#![cfg(unix)]

use std::fs::{self, OpenOptions};
use std::os::unix::fs::{MetadataExt, PermissionsExt, symlink};
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::time::Duration;

use steadycut::run::edits::Edits;
use steadycut::run::{presets, scenario_file};

/// What stands in a file before a command writes it.
const OLD: &str = "what was there";

/// An empty folder.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("writing").join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

fn program(folder: &Path, args: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_steadycut"));
    command.args(args).current_dir(folder).stdin(Stdio::null());
    command
}

fn steadycut(folder: &Path, args: &[&str]) -> Output {
    program(folder, args).output().unwrap()
}

/// What is said by a command that must be refused.
fn refused(mut command: Command) -> String {
    let output = command.output().unwrap();
    assert_eq!(output.status.code(), Some(2), "{command:?}");
    String::from_utf8(output.stderr).unwrap()
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name());
    let mut names: Vec<String> = entries.map(|name| name.into_string().unwrap()).collect();
    names.sort();
    names
}

/// A folder with an input of every kind, and each of their other names.
fn inputs(name: &str) -> PathBuf {
    let folder = folder(name);
    let scenario = presets::load("experiment-2").unwrap();
    let text = scenario_file::write(&scenario, &Edits::none());
    let machine = include_str!("../../assets/machines/heller_bea_01.toml");
    for (name, text) in [
        ("s.toml", text.as_str()),
        ("machine.toml", machine),
        ("table.csv", include_str!("../../assets/data/table3_2007.csv")),
        ("data.csv", include_str!("../../assets/data/cutting_data_2005.csv")),
        ("networks.json", "{}"),
    ] {
        fs::write(folder.join(name), text).unwrap();
        symlink(name, folder.join(format!("link-{name}"))).unwrap();
        fs::hard_link(folder.join(name), folder.join(format!("hard-{name}"))).unwrap();
    }
    folder
}

#[test]
fn nothing_is_written_over_what_is_read() {
    let folder = inputs("over-inputs");
    // The command, the argument that reads, its file, the argument that writes.
    let commands: [(&[&str], &str, &str, &str); 11] = [
        (&["run", "s.toml"], "PRESET|FILE|LINK", "s.toml", "--out"),
        (&["run", "s.toml", "--networks", "networks.json"], "--networks", "networks.json", "--out"),
        (&["plan", "s.toml"], "PRESET|FILE|LINK", "s.toml", "--out"),
        (&["plan", "first-cut", "--machine", "machine.toml"], "--machine", "machine.toml", "--out"),
        (&["combine", "--scenario", "s.toml"], "--scenario", "s.toml", "--out"),
        (&["combine", "--machine", "machine.toml"], "--machine", "machine.toml", "--out"),
        (&["combine", "--table", "data.csv"], "--table", "data.csv", "--out"),
        (&["unks", "s.toml"], "PRESET|FILE|LINK", "s.toml", "--save"),
        (&["unks", "--load", "networks.json"], "--load", "networks.json", "--save"),
        (&["identify", "tables", "--table", "table.csv"], "--table", "table.csv", "--out"),
        (&["plan", "link-s.toml"], "PRESET|FILE|LINK", "link-s.toml", "--out"),
    ];
    for (command, input, read, output) in commands {
        let plain = read.trim_start_matches("link-");
        let before = fs::read(folder.join(read)).unwrap();
        for written in ["", "./", "../over-inputs/", "link-", "hard-"] {
            let written = format!("{written}{plain}");
            let said = refused(program(&folder, &[command, &[output, written.as_str()]].concat()));
            for part in [format!("{input} {read}"), format!("{output} {written}")] {
                assert!(said.contains(&part), "{part}: {said}");
            }
            assert!(said.contains("same file"), "{said}");
            assert_eq!(fs::read(folder.join(read)).unwrap(), before);
        }
    }
    assert_eq!(names(&folder).len(), 15);
}

#[test]
fn standard_input_and_output_are_files_too() {
    let folder = inputs("standard");
    let open = |name: &str| fs::File::open(folder.join(name)).unwrap();
    let append = |name: &str| OpenOptions::new().append(true).open(folder.join(name)).unwrap();
    let mut command = program(&folder, &["run", "-", "--out", "s.toml"]);
    command.stdin(open("s.toml"));
    let said = refused(command);
    assert!(said.contains("standard input") && said.contains("--out s.toml"), "{said}");
    for args in [&["check", "s.toml"][..], &["run", "hard-s.toml", "--json"]] {
        let mut command = program(&folder, args);
        command.stdout(append("s.toml"));
        let said = refused(command);
        assert!(said.contains("s.toml and standard output are the same file"), "{said}");
    }
    fs::write(folder.join("r.csv"), OLD).unwrap();
    let mut command = program(&folder, &["run", "first-cut", "--out", "r.csv"]);
    command.stdout(append("r.csv"));
    let said = refused(command);
    assert!(
        said.contains("--out r.csv and standard output") && said.contains("two files"),
        "{said}"
    );
    assert_eq!(fs::read_to_string(folder.join("r.csv")).unwrap(), OLD);
    let text = fs::read_to_string(folder.join("s.toml")).unwrap();
    assert!(scenario_file::parse(&text).is_ok());
}

#[test]
fn two_results_do_not_go_into_one_file() {
    let folder = folder("twice");
    fs::write(folder.join("both.1"), OLD).unwrap();
    for name in ["steadycut-run.1", "steadycut-plan.1"] {
        symlink("both.1", folder.join(name)).unwrap();
    }
    let said = refused(program(&folder, &["man", "--out", "."]));
    for part in ["steadycut-run.1", "steadycut-plan.1", "two files"] {
        assert!(said.contains(part), "{part}: {said}");
    }
    assert_eq!(names(&folder), ["both.1", "steadycut-plan.1", "steadycut-run.1"]);
    assert_eq!(fs::read_to_string(folder.join("both.1")).unwrap(), OLD);
}

/// Every command that writes a file, as it is asked for quickly.
fn writers() -> [(&'static [&'static str], &'static str); 10] {
    const SHORT: &str = "workpiece.cuts=[[[4.0, 3.0, 2.0]]]";
    [
        (&["run", "first-cut"], "--out"),
        (&["plan", "strategy-2013"], "--out"),
        (&["plan", "experiment-2", "--per-cut", "lightest"], "--out"),
        (&["combine", "--set", SHORT], "--out"),
        (&["unks", "--passes", "1", "--set", SHORT], "--save"),
        (&["identify", "tables"], "--out"),
        (&["recommend", "table"], "--out"),
        (&["train", "force", "--rows", "100", "--epochs", "1"], "--out"),
        (&["machine", "modes"], "--out"),
        (&["completions", "bash"], "--out"),
    ]
}

#[test]
fn a_full_disk_leaves_the_older_result_whole() {
    let folder = folder("full");
    let file = folder.join("old");
    fs::write(&file, OLD).unwrap();
    for (command, output) in writers() {
        // No file may grow beyond 512 bytes: the write that would is refused, as on a full disk.
        let limited = "trap '' XFSZ; ulimit -f 1; exec \"$0\" \"$@\"";
        let ended = Command::new("sh")
            .args(["-c", limited, env!("CARGO_BIN_EXE_steadycut")])
            .args([command, &[output, "old"]].concat())
            .current_dir(&folder)
            .output()
            .unwrap();
        let said = String::from_utf8(ended.stderr).unwrap();
        assert_eq!(ended.status.code(), Some(2), "{command:?}: {said}");
        assert!(said.contains("error: old: ") && said.lines().count() == 1, "{command:?}: {said}");
        assert_eq!(fs::read_to_string(&file).unwrap(), OLD, "{command:?}");
        assert_eq!(names(&folder), ["old"], "{command:?}");
        // A device that is full takes nothing either.
        let said = refused(program(&folder, &[command, &[output, "/dev/full"]].concat()));
        assert!(said.contains("error: /dev/full: "), "{command:?}: {said}");
        let said = refused(program(&folder, &[command, &[output, "no/such"]].concat()));
        let problem = "error: no/such: no file can be made in no: No such file or directory";
        assert!(said.contains(problem) && !said.contains(".part"), "{said}");
        let said = refused(program(&folder, &[command, &[output, "."]].concat()));
        assert!(said.contains("error: .: is a directory"), "{said}");
    }
    let mut command = program(&folder, &["list"]);
    command.stdout(OpenOptions::new().write(true).open("/dev/full").unwrap());
    let said = refused(command);
    assert!(said.contains("error: standard output: No space left"), "{said}");
}

#[test]
fn a_folder_is_looked_at_before_the_work_for_its_files() {
    let folder = folder("folders");
    fs::write(folder.join("file"), OLD).unwrap();
    for command in [&["train", "unks"][..], &["man"]] {
        for (name, problem) in [
            ("no", "no: no file can be made in no: No such file or directory"),
            ("file", "file: no file can be made in file: Not a directory"),
            ("-", "--out -: several files do not go to standard output: name a folder"),
        ] {
            let said = refused(program(&folder, &[command, &["--out", name]].concat()));
            assert!(said.contains(problem), "{command:?}: {said}");
        }
    }
    assert_eq!(names(&folder), ["file"]);
}

#[test]
fn an_end_from_outside_leaves_the_older_result_and_nothing_beside_it() {
    // Some 60 MB: long enough to write that the end comes in between.
    let long = ["--set", "run.duration_s=10", "--set", "run.record_every=1"];
    let args = [&["run", "experiment-2", "--out", "old"], &long[..]].concat();
    for signal in ["INT", "TERM", "HUP"] {
        let folder = folder(&format!("ended-{signal}"));
        fs::write(folder.join("old"), OLD).unwrap();
        let mut child = program(&folder, &args);
        let mut child = child.stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
        let grows = || {
            let entries = fs::read_dir(&folder).unwrap().filter_map(Result::ok);
            let mut others = entries.filter(|entry| entry.file_name() != "old");
            others.any(|entry| entry.metadata().is_ok_and(|found| found.len() > 0))
        };
        while !grows() {
            assert!(child.try_wait().unwrap().is_none(), "it was over before it was seen to write");
            std::thread::sleep(Duration::from_millis(1));
        }
        let sent = Command::new("kill").args(["-s", signal, &child.id().to_string()]).status();
        assert!(sent.unwrap().success());
        assert_eq!(child.wait().unwrap().code(), Some(130), "{signal}");
        assert_eq!(names(&folder), ["old"], "{signal}");
        assert_eq!(fs::read_to_string(folder.join("old")).unwrap(), OLD, "{signal}");
    }
}

#[test]
fn links_stay_and_rights_are_kept() {
    let folder = folder("links");
    let write = |name: &str| {
        let output = steadycut(&folder, &["recommend", "table", "--out", name]);
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        output.status.success().then_some(()).ok_or(said)
    };
    let new = include_str!("../../assets/data/cutting_data_2005.csv");
    let is_new = |name: &str| fs::read_to_string(folder.join(name)).unwrap() == new;
    let is_link = |name: &str| fs::symlink_metadata(folder.join(name)).unwrap().is_symlink();
    let mode = |name: &str| fs::metadata(folder.join(name)).unwrap().permissions().mode() & 0o7777;
    fs::create_dir(folder.join("far")).unwrap();
    fs::write(folder.join("far/old"), OLD).unwrap();
    fs::set_permissions(folder.join("far/old"), PermissionsExt::from_mode(0o640)).unwrap();
    fs::hard_link(folder.join("far/old"), folder.join("kept")).unwrap();
    symlink("old", folder.join("far/link")).unwrap();
    symlink("far/link", folder.join("link")).unwrap();
    write("link").unwrap();
    assert!(is_link("link") && is_link("far/link") && is_new("far/old"));
    assert_eq!(mode("far/old"), 0o640);
    assert_eq!(fs::read_to_string(folder.join("kept")).unwrap(), OLD, "a name of its own");
    symlink("far/new", folder.join("to-nothing")).unwrap();
    write("to-nothing").unwrap();
    assert!(is_link("to-nothing") && is_new("far/new"));
    // A new file has the rights that any new file has.
    fs::write(folder.join("any"), "").unwrap();
    assert_eq!(mode("far/new"), mode("any"));
    let owner =
        |name: &str| fs::metadata(folder.join(name)).map(|found| (found.uid(), found.gid()));
    assert_eq!(owner("far/old").unwrap(), owner("any").unwrap());
    symlink("circle", folder.join("circle")).unwrap();
    assert!(write("circle").unwrap_err().contains("lead back to themselves"));
    assert!(write("new/").unwrap_err().contains("is a directory"));
    assert_eq!(names(&folder.join("far")), ["link", "new", "old"]);

    let protected = folder.join("protected");
    fs::write(&protected, OLD).unwrap();
    fs::set_permissions(&protected, PermissionsExt::from_mode(0o440)).unwrap();
    // The superuser may write anything.
    if OpenOptions::new().write(true).open(&protected).is_err() {
        assert!(write("protected").unwrap_err().contains("protected: Permission denied"));
        assert_eq!(fs::read_to_string(&protected).unwrap(), OLD);
    }
}

#[test]
fn pipes_and_standard_output_are_written_to_as_they_are() {
    let folder = folder("pipes");
    let table = include_str!("../../assets/data/cutting_data_2005.csv");
    assert!(Command::new("mkfifo").arg(folder.join("pipe")).status().unwrap().success());
    let reader =
        Command::new("cat").arg(folder.join("pipe")).stdout(Stdio::piped()).spawn().unwrap();
    assert!(steadycut(&folder, &["recommend", "table", "--out", "pipe"]).status.success());
    assert_eq!(reader.wait_with_output().unwrap().stdout, table.as_bytes());
    assert_eq!(names(&folder), ["pipe"]);
    for name in ["-", "/dev/stdout", "/dev/fd/1"] {
        let output = steadycut(&folder, &["recommend", "table", "--out", name]);
        assert_eq!(output.stdout, table.as_bytes(), "{name}");
        // The same into a file that the shell has opened.
        let file = fs::File::create(folder.join("shell")).unwrap();
        let mut command = program(&folder, &["recommend", "table", "--out", name]);
        assert!(command.stdout(file).status().unwrap().success());
        assert_eq!(fs::read_to_string(folder.join("shell")).unwrap(), table, "{name}");
    }
    assert!(steadycut(&folder, &["recommend", "table", "--out", "/dev/null"]).status.success());
}

#[test]
fn a_dash_is_standard_output_and_the_file_stands_there_alone() {
    let folder = folder("dash");
    for (command, output) in writers() {
        let [file, dash] = ["file", "-"].map(|name| {
            let ended = steadycut(&folder, &[command, &[output, name]].concat());
            assert!(
                ended.status.success(),
                "{command:?}: {}",
                String::from_utf8_lossy(&ended.stderr)
            );
            ended.stdout
        });
        let written = fs::read(folder.join("file")).unwrap();
        assert!(!written.is_empty() && file != dash, "{command:?}");
        assert!(written == dash, "{command:?}: {}", String::from_utf8_lossy(&dash));
        let has_json = !["recommend", "machine", "completions"].contains(&command[0]);
        if has_json {
            let said = refused(program(&folder, &[command, &[output, "-", "--json"]].concat()));
            assert!(said.contains("--json") && said.contains("standard output"), "{said}");
        }
    }
    assert_eq!(names(&folder), ["file"]);
}
