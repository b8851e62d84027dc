//! The layer rule: base <- models <- blocks <- run <- study <- { cli | app }. A layer names only layers
//! to its left; cli and app never see each other; only app names the GUI. Both front ends share `disk`, which
//! names nothing but base; so does `measured`, which study and both front ends may name.

use std::fs;
use std::path::{Path, PathBuf};

const LAYERS: [&str; 5] = ["base", "models", "blocks", "run", "study"];
/// What stands beside them, and the front ends.
const BESIDE: [&str; 4] = ["measured", "disk", "cli", "app"];

/// Where the sources of a layer stand.
fn folder(layer: &str) -> PathBuf {
    match layer {
        "study" => PathBuf::from("crates/study/src"),
        "measured" => PathBuf::from("crates/measured/src"),
        "cli" | "app" | "disk" => Path::new("src").join(layer),
        _ => Path::new("crates/core/src").join(layer),
    }
}

fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            found.push(path);
        }
    }
}

/// Code without comments: documentation may name anything.
fn code(path: &Path) -> String {
    let text = fs::read_to_string(path).unwrap();
    let lines = text.lines().map(|line| line.split("//").next().unwrap_or(""));
    lines.collect::<Vec<_>>().join("\n")
}

fn allowed(layer: &str) -> Vec<&str> {
    match LAYERS.iter().position(|name| *name == layer) {
        Some(_) if layer == "study" => LAYERS.into_iter().chain(["measured"]).collect(),
        Some(index) => LAYERS[..=index].to_vec(),
        None if ["disk", "measured"].contains(&layer) => vec!["base", layer],
        None => LAYERS.into_iter().chain([layer, "disk", "measured"]).collect(),
    }
}

#[test]
fn layers_name_only_layers_to_their_left() {
    let mut faults = Vec::new();
    for layer in LAYERS.into_iter().chain(BESIDE) {
        let mut files = Vec::new();
        sources(&folder(layer), &mut files);
        assert!(!files.is_empty(), "{layer} has no sources");
        for file in files {
            let code = code(&file);
            for other in LAYERS.into_iter().chain(BESIDE) {
                assert!(!code.contains("crate::{"), "{}: one path per use", file.display());
                let names = code.contains(&format!("crate::{other}"));
                if names && !allowed(layer).contains(&other) {
                    faults.push(format!("{} names `{other}`", file.display()));
                }
            }
            let gui = ["egui", "eframe", "wgpu"].iter().any(|name| code.contains(name));
            if gui && layer != "app" {
                faults.push(format!("{} names the GUI", file.display()));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn blocks_do_not_name_other_blocks() {
    let boxes = ["reference", "control", "cnc", "cutting", "machine", "sensing", "surface"];
    let mut files = Vec::new();
    sources(&folder("blocks"), &mut files);
    let mut faults = Vec::new();
    for file in files {
        let code = code(&file);
        for name in boxes {
            let own = file.components().any(|part| part.as_os_str() == name);
            // Out of a block's folder by `super::super` would pass the names below.
            if code.contains("super::super") {
                faults.push(format!("{} climbs out of its folder", file.display()));
            }
            if !own && code.contains(&format!("crate::blocks::{name}")) {
                faults.push(format!("{} names the block `{name}`", file.display()));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn pure_layers_have_no_clock_thread_file_or_environment() {
    let mut files = Vec::new();
    for layer in LAYERS.into_iter().chain(["measured"]) {
        sources(&folder(layer), &mut files);
    }
    for file in files {
        let code = code(&file);
        for name in ["std::fs", "std::env", "std::thread", "std::time", "println!", "eprintln!"] {
            assert!(!code.contains(name), "{} names `{name}`", file.display());
        }
    }
}

/// Files are read and written in one place, which loses none of them.
#[test]
fn nothing_but_the_disk_opens_a_file() {
    let opens =
        ["fs::{", "fs::File", "OpenOptions", "fs::read", "fs::write", "fs::copy", "fs::rename"];
    let opens = |file: &PathBuf| {
        let code = code(file);
        let program = code.split("#[cfg(test)]").next().unwrap_or_default();
        opens.iter().any(|name| program.contains(name))
    };
    for (layer, may) in [("cli", false), ("app", false), ("disk", true)] {
        let mut files = Vec::new();
        sources(&folder(layer), &mut files);
        let found: Vec<&PathBuf> = files.iter().filter(|file| opens(file)).collect();
        assert_eq!(!found.is_empty(), may, "{layer}: {found:?}");
    }
}

/// A search for a public type finds one: no two modules have one of the same name. The loudspeaker is
/// another one on each platform, so its name is the platform's choice.
#[test]
fn public_types_have_names_of_their_own() {
    let mut all = Vec::new();
    for root in ["crates/core/src", "crates/measured/src", "crates/study/src", "src"] {
        sources(Path::new(root), &mut all);
    }
    let mut names = Vec::new();
    for file in &all {
        for line in code(file).lines().map(str::trim_start) {
            let kinds = ["pub struct ", "pub enum ", "pub trait "];
            let Some(rest) = kinds.iter().find_map(|kind| line.strip_prefix(kind)) else {
                continue;
            };
            let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len());
            names.push((rest[..end].to_owned(), file.display().to_string()));
        }
    }
    assert!(names.len() > 300, "only {} public types found", names.len());
    names.retain(|(name, file)| {
        let by_platform = name == "Speaker" && file.contains("speaker");
        !by_platform && !name.is_empty()
    });
    names.sort();
    let twice: Vec<_> = names.windows(2).filter(|pair| pair[0].0 == pair[1].0).collect();
    assert!(twice.is_empty(), "{twice:#?}");
}

#[test]
fn the_lowest_layer_names_nothing_of_milling() {
    let trade = [
        "cut",
        "cuts",
        "cutting",
        "cutter",
        "mill",
        "milling",
        "tool",
        "tooth",
        "teeth",
        "wall",
        "axial",
        "section",
        "sections",
        "spindle",
        "workpiece",
        "force",
        "roughness",
        "unks",
        "steadycut",
    ];
    let mut files = Vec::new();
    sources(&folder("base"), &mut files);
    for file in files {
        let code = code(&file).to_lowercase();
        for word in code.split(|c: char| !c.is_alphabetic()) {
            assert!(!trade.contains(&word), "{} names `{word}`", file.display());
        }
    }
}

/// Whether a controller stands in a pattern: `ControllerKind::Name` before `=>`, `|` or `if`.
fn matches_a_controller(code: &str) -> bool {
    code.split("ControllerKind::").skip(1).any(|rest| {
        let rest = rest.trim_start_matches(|c: char| c.is_alphanumeric() || c == '_');
        ["=>", "| ", "if "].iter().any(|next| rest.trim_start().starts_with(next))
    })
}

#[test]
fn only_a_controllers_own_file_tells_it_from_the_others() {
    assert!(matches_a_controller("match kind { ControllerKind::Mrac => 1, _ => 2 }"));
    assert!(matches_a_controller("matches!(kind, ControllerKind::Mrac\n | ControllerKind::Unks)"));
    assert!(!matches_a_controller("settings.kind = ControllerKind::Mrac;"));
    let mut files = Vec::new();
    for layer in LAYERS.into_iter().chain(["cli", "app"]) {
        sources(&folder(layer), &mut files);
    }
    let own = folder("blocks").join("control");
    for file in files.iter().filter(|file| !file.starts_with(&own)) {
        assert!(!matches_a_controller(&code(file)), "{} lists controllers", file.display());
    }
}
