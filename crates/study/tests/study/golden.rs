//! Golden digests: the bits of every preset, here and (through `web/test`) in wasm.

use std::collections::BTreeMap;

use serde_json::Value;
use steadycut_core::blocks::control::ControllerKind;
use steadycut_core::run::presets::{PRESETS, load};
use steadycut_core::run::scenario::{Scenario, table};
use steadycut_study::golden::{self, BASES, named, values};

const FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/golden.json");

#[test]
fn every_preset_has_its_golden_digest() {
    let now = golden::to_json();
    if std::env::var_os("STEADYCUT_WRITE_GOLDEN").is_some() {
        std::fs::write(FILE, &now).unwrap();
        // A run that rewrites what it is to hold shows nothing.
        panic!("tests/golden.json is written again: look at what moved, then test without");
    }
    let golden = std::fs::read_to_string(FILE).unwrap();
    assert_eq!(now, golden, "write it again with STEADYCUT_WRITE_GOLDEN=1 if the change is meant");
}

/// The variants of every base in the file, by base.
fn variants() -> BTreeMap<String, BTreeMap<String, String>> {
    let all: Value = serde_json::from_str(&std::fs::read_to_string(FILE).unwrap()).unwrap();
    let of = |base: &&str| serde_json::from_value(all[*base]["variants"].clone()).unwrap();
    BASES.iter().map(|base| ((*base).to_owned(), of(base))).collect()
}

/// Variants that give the same digest hold nothing: the run ended before they differed.
#[test]
fn every_variant_is_a_run_of_its_own() {
    // The script that a controller begins with is the law of 2007, and moves the machine as the built-in one does.
    let [script, built_in] = ["script", "sdnrp"].map(|kind| format!("controller.kind = {kind}"));
    for (base, mut digests) in variants() {
        let law = digests.remove(&script).expect("the script is a controller");
        if let Some(built_in) = digests.get(&built_in) {
            assert_eq!(&law, built_in, "{base}");
        }
        let mut seen = BTreeMap::new();
        for (name, digest) in digests {
            let twin = seen.insert(digest, name.clone());
            assert_eq!(twin, None, "{base}: {name}");
        }
    }
}

/// From the tables of settings and controllers, so that the next one is missed here until it is held.
#[test]
fn every_controller_and_every_switch_is_in_a_golden() {
    let variants = variants();
    for kind in ControllerKind::ALL {
        let name = format!("controller.kind = {}", kind.id());
        for (base, held) in &variants {
            assert!(held.contains_key(&name), "{name} is not among the variants of {base}");
        }
    }
    let (mut switches, mut missing) = (0, Vec::new());
    let presets: Vec<Scenario> = PRESETS.iter().map(|preset| load(preset.name).unwrap()).collect();
    for param in table() {
        for value in values(param) {
            let name = named(&param.path, &value);
            let held = variants.values().any(|variants| variants.contains_key(&name))
                || presets.iter().any(|preset| preset.get(&param.path).unwrap() == value);
            missing.extend((!held).then_some(name));
            switches += 1;
        }
    }
    // There must be a base preset in which it changes something.
    assert!(missing.is_empty(), "in no golden: {missing:#?}");
    assert!(switches > 90, "{switches}");
}
