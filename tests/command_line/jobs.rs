//! Long work on the command line: on any number of cores the same, without a word on stderr where that is
//! no terminal, and ended by Ctrl+C without half a file.

use std::process::{Command, Output, Stdio};

fn steadycut(args: &[&str], threads: &str) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_steadycut"));
    command.args(args).env("RAYON_NUM_THREADS", threads).output().unwrap()
}

#[test]
fn every_number_of_cores_gives_the_same_text_and_no_bar_without_a_terminal() {
    let cut = "workpiece.cuts=[[[4.0, 3.0, 2.0]]]";
    let commands: [&[&str]; 8] = [
        &["experiment", "--design", "latin", "--run"],
        &["experiment", "way", "--cuts", "30", "--batches", "1"],
        &["robust", "--runs", "5", "--set", cut],
        &["unks", "experiment-2", "--passes", "2", "--set", cut],
        &["plan", "experiment-2", "--per-cut", "lightest"],
        &["machine", "stability", "--speeds", "5"],
        &["machine", "life", "--tools", "6", "--json"],
        &["train", "force", "--rows", "120", "--epochs", "3", "--hidden", "4"],
    ];
    for args in commands {
        let [one, four] = ["1", "4"].map(|threads| steadycut(args, threads));
        let error = String::from_utf8_lossy(&one.stderr);
        assert!(one.stderr.is_empty() && four.stderr.is_empty(), "{args:?}: {error}");
        assert!(one.stdout.len() > 100, "{args:?}");
        assert_eq!(one.stdout, four.stdout, "{args:?}");
        assert_eq!(one.status, four.status, "{args:?}");
    }
}

#[cfg(unix)]
#[test]
fn ctrl_c_ends_the_work_and_leaves_the_file_before_whole() {
    let folder = std::path::PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("interrupted");
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    let file = folder.join("signals.csv");
    std::fs::write(&file, "what was there").unwrap();
    // An hour of cutting, tooth by tooth.
    let child = Command::new(env!("CARGO_BIN_EXE_steadycut"))
        .args(["run", "experiment-2", "--set", "run.duration_s=3600", "--set"])
        .args(["workpiece.cuts=[[[2000.0, 3.0, 2.0]]]", "--set", "run.record_every=576", "--out"])
        .arg(&file)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // By then it is at work, and it stays there for long.
    std::thread::sleep(std::time::Duration::from_millis(1500));
    let pid = child.id().to_string();
    assert!(Command::new("kill").args(["-INT", &pid]).status().unwrap().success());
    let output = child.wait_with_output().unwrap();
    let said = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(130), "{said}");
    assert!(said.contains("interrupted: run, ") && said.contains(" steps done"), "{said}");
    assert!(output.stdout.is_empty());
    assert_eq!(std::fs::read_to_string(&file).unwrap(), "what was there");
    assert_eq!(std::fs::read_dir(&folder).unwrap().count(), 1, "nothing is left beside it");
}
