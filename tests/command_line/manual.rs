//! Completions and manual pages: every command stands in them, and the programs that use them take them.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

fn steadycut(args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_steadycut")).args(args).output().unwrap()
}

fn printed(args: &[&str]) -> String {
    let output = steadycut(args);
    assert!(output.status.success(), "{args:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap()
}

/// The commands that the program's help lists.
fn commands() -> Vec<String> {
    let help = printed(&["--help"]);
    let lines = help.lines().skip_while(|line| *line != "Commands:").skip(1);
    let names = lines.map_while(|line| line.split_whitespace().next()).map(str::to_owned);
    let names: Vec<String> = names.filter(|name| name != "help").collect();
    assert!(names.len() >= 15, "{names:?}");
    names
}

/// Whether a program is there to ask.
fn has(program: &str) -> bool {
    let mut version = Command::new(program);
    version.arg("--version").stdout(Stdio::null()).stderr(Stdio::null());
    version.status().is_ok()
}

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

#[test]
fn every_shell_completes_every_command() {
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let script = printed(&["completions", shell]);
        for name in commands().iter().map(String::as_str).chain(["stability", "--networks"]) {
            let name = if shell == "fish" { name.trim_start_matches('-') } else { name };
            assert!(script.contains(name), "{shell}: {name}");
        }
    }
    let output = steadycut(&["completions", "tcsh"]);
    assert!(!output.status.success());
    assert!(String::from_utf8_lossy(&output.stderr).contains("bash"));
}

#[test]
fn the_shells_that_are_here_take_their_scripts() {
    let folder = folder("completions");
    for shell in ["bash", "zsh", "fish"].into_iter().filter(|shell| has(shell)) {
        let file = folder.join(shell);
        printed(&["completions", shell, "--out", file.to_str().unwrap()]);
        assert!(Command::new(shell).arg("-n").arg(&file).status().unwrap().success(), "{shell}");
    }
    if !has("bash") {
        return;
    }
    let ask = |words: &str, current: &str| {
        let index = words.split_whitespace().count();
        let previous = words.rsplit(' ').next().unwrap();
        let script = format!(
            "source '{}'; COMP_WORDS=({words} '{current}'); COMP_CWORD={index}; \
             _steadycut steadycut '{current}' '{previous}'; echo \"${{COMPREPLY[@]}}\"",
            folder.join("bash").display()
        );
        let output =
            Command::new("bash").args(["-c", &script]).current_dir(&folder).output().unwrap();
        String::from_utf8(output.stdout).unwrap()
    };
    let all = ask("steadycut", "");
    for name in commands() {
        assert!(all.split_whitespace().any(|word| word == name), "{name}: {all}");
    }
    assert_eq!(ask("steadycut", "rec").trim(), "recommend");
    assert_eq!(ask("steadycut machine", "st").trim(), "stability");
    assert_eq!(ask("steadycut run", "--net").trim(), "--networks");
    assert_eq!(ask("steadycut robust --controller", "prev").trim(), "preview");
    fs::write(folder.join("my-scenario.toml"), "").unwrap();
    assert_eq!(ask("steadycut plan x --machine", "my-").trim(), "my-scenario.toml");
}

#[test]
fn every_command_has_its_page() {
    let folder = folder("man");
    printed(&["man", "--out", folder.to_str().unwrap()]);
    let page = |name: &str| fs::read_to_string(folder.join(name)).unwrap();
    let top = page("steadycut.1");
    assert_eq!(top, printed(&["man"]));
    assert!(top.contains(concat!("steadycut ", env!("CARGO_PKG_VERSION"))), "{top}");
    for name in commands() {
        assert!(top.contains(&format!("steadycut\\-{name}(1)")), "{name}");
        let page = page(&format!("steadycut-{name}.1"));
        assert_eq!(page, printed(&["man", &name]), "{name}");
        assert!(page.contains(&format!("steadycut\\-{name}")), "{name}: {page}");
    }
    assert_eq!(page("steadycut-machine-stability.1"), printed(&["man", "machine", "stability"]));
    let error = String::from_utf8(steadycut(&["man", "machine", "stabilty"]).stderr).unwrap();
    assert!(error.contains("stabilty") && error.contains("modes, frf, stability"), "{error}");
    // A page that is named is there.
    for (i, _) in top.match_indices("(1)") {
        let name = top[..i].rsplit(|c: char| c.is_whitespace()).next().unwrap().replace("\\-", "-");
        assert!(folder.join(format!("{name}.1")).is_file(), "{name}");
    }
    if !has("groff") {
        return;
    }
    for entry in fs::read_dir(&folder).unwrap() {
        let text = fs::read(entry.unwrap().path()).unwrap();
        let mut groff = Command::new("groff")
            .args(["-man", "-Tutf8", "-ww", "-P-cbou"])
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        groff.stdin.take().unwrap().write_all(&text).unwrap();
        let shown = groff.wait_with_output().unwrap();
        assert!(shown.status.success() && shown.stderr.is_empty(), "{shown:?}");
        let shown = String::from_utf8(shown.stdout).unwrap();
        assert!(shown.contains("SYNOPSIS") && shown.contains("DESCRIPTION"), "{shown}");
    }
}
