//! The worked examples of CONTRIBUTING.md: their files and their lines are added to a copy of the core, which
//! is built and run there. Nothing else is, so a controller or a force model that needed a second line would
//! fail here.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const GUIDE: &str = include_str!("../../CONTRIBUTING.md");
/// What is added: the section of the guide, the folder, its file and its list.
struct Addition {
    section: &'static str,
    folder: &'static str,
    file: &'static str,
    list: &'static str,
}

const CONTROLLER: Addition = Addition {
    section: "Add a controller",
    folder: "crates/core/src/blocks/control",
    file: "integral.rs",
    list: "controllers!",
};
const FORCE_MODEL: Addition = Addition {
    section: "Add a force model",
    folder: "crates/core/src/blocks/cutting/force_model",
    file: "power.rs",
    list: "force_models!",
};
/// What the copy is asked once both are in it.
const CHECKS: [(&str, &str); 2] = [
    ("check", include_str!("contributing/check.rs")),
    ("check_force", include_str!("contributing/check_force.rs")),
];

/// The code blocks of the section, in order.
fn blocks(section: &str) -> Vec<String> {
    let start = GUIDE.find(&format!("## {section}\n")).expect("the section");
    let text = &GUIDE[start + 3..];
    let text = &text[..text.find("\n## ").unwrap_or(text.len())];
    let blocks = text.split("```rust\n").skip(1);
    blocks.map(|rest| rest.split("```").next().unwrap_or_default().to_owned()).collect()
}

/// Writes a file if its text is another one: what is unchanged is not compiled again.
fn write(path: &Path, text: &str) {
    if fs::read_to_string(path).is_ok_and(|old| old == text) {
        return;
    }
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(path, text).unwrap();
}

/// Copies a folder, and leaves nothing else in its place.
fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    let names = |folder: &Path| -> Vec<std::ffi::OsString> {
        fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name()).collect()
    };
    let wanted = names(from);
    for name in names(to).into_iter().filter(|name| !wanted.contains(name)) {
        let stale = to.join(name);
        if stale.is_dir() { fs::remove_dir_all(stale) } else { fs::remove_file(stale) }.unwrap();
    }
    for name in wanted {
        let (from, to) = (from.join(&name), to.join(&name));
        if from.is_dir() {
            copy(&from, &to);
        } else if fs::read(&to).ok() != fs::read(&from).ok() {
            fs::copy(&from, &to).unwrap();
        }
    }
}

/// A workspace of the core alone, without what only its tests and benches need.
struct Workspace {
    root: PathBuf,
}

impl Workspace {
    fn new(name: &str) -> Self {
        let here = Path::new(env!("CARGO_MANIFEST_DIR"));
        let root = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        copy(&here.join("crates/core/src"), &root.join("crates/core/src"));
        copy(&here.join("assets"), &root.join("assets"));
        let manifest = |path: &str| -> toml::Table {
            fs::read_to_string(here.join(path)).unwrap().parse().unwrap()
        };
        let mut whole = manifest("Cargo.toml");
        whole.retain(|key, _| key == "workspace");
        let workspace = whole["workspace"].as_table_mut().unwrap();
        workspace.remove("default-members");
        workspace.insert("members".to_owned(), vec!["crates/core"].into());
        let profile = "[dev]\nopt-level = 0\ndebug = false\n[dev.package.\"*\"]\nopt-level = 0\n";
        whole.insert("profile".to_owned(), profile.parse::<toml::Table>().unwrap().into());
        write(&root.join("Cargo.toml"), &whole.to_string());
        let mut core = manifest("crates/core/Cargo.toml");
        core.retain(|key, _| key != "dev-dependencies" && key != "bench");
        write(&root.join("crates/core/Cargo.toml"), &core.to_string());
        if !root.join("Cargo.lock").exists() {
            fs::copy(here.join("Cargo.lock"), root.join("Cargo.lock")).unwrap();
        }
        for (name, check) in CHECKS {
            write(&root.join(format!("crates/core/examples/{name}.rs")), check);
        }
        Self { root }
    }

    /// Adds what a section of the guide shows: its file, and its line at the end of the list. Gives the
    /// file's place and text.
    fn add(&self, addition: &Addition) -> (PathBuf, String) {
        let [file, line] = &blocks(addition.section)[..] else { panic!("a file and a line") };
        assert_eq!(line.lines().count(), 1, "{line}");
        let folder = self.root.join(addition.folder);
        write(&folder.join(addition.file), file);
        let list = folder.join("mod.rs");
        let text = fs::read_to_string(&list).unwrap();
        let start = text.find(&format!("\n{} {{\n", addition.list)).expect("the list");
        let end = start + text[start..].find("\n}").expect("its end") + 1;
        fs::write(list, format!("{}{line}{}", &text[..end], &text[end..])).unwrap();
        (folder.join(addition.file), file.clone())
    }

    /// cargo, as a user would start it there: without what the cargo of this test has set.
    fn cargo(&self, arguments: &[&str]) -> Output {
        let mut command = Command::new(env!("CARGO"));
        for (name, _) in std::env::vars_os() {
            let text = name.to_string_lossy();
            if text.starts_with("CARGO") && text != "CARGO_HOME" || text.starts_with("RUSTFLAGS") {
                command.env_remove(&name);
            }
        }
        command.current_dir(&self.root).args(arguments).arg("--offline").output().unwrap()
    }
}

#[test]
fn what_the_guide_adds_is_one_file_and_one_line() {
    let copy = Workspace::new("contributing");
    let (place, file) = copy.add(&CONTROLLER);
    copy.add(&FORCE_MODEL);
    for (name, _) in CHECKS {
        let output = copy.cargo(&["run", "--quiet", "-p", "steadycut-core", "--example", name]);
        let told = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{name}: {told}");
    }

    // The compiler names what is left out. Built, not checked: what it stands on is compiled once.
    let (left_out, method) = (file.replace("fn printed(", "fn print("), "printed");
    assert_ne!(left_out, file);
    write(&place, &left_out);
    let output = copy.cargo(&["build", "--quiet", "-p", "steadycut-core", "--lib"]);
    let told = String::from_utf8_lossy(&output.stderr);
    let named = told.contains("not all trait items implemented") && told.contains(method);
    assert!(!output.status.success() && named, "{told}");
    write(&place, &file);
}
