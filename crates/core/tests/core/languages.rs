//! What people read is asked for in their language, and what programs read is not.

use steadycut_core::base::formula::Formula;
use steadycut_core::base::language::{Catalogue, Language, choose, use_catalogue};
use steadycut_core::base::settings::Value;
use steadycut_core::base::text::decode;
use steadycut_core::blocks::cnc::overload::Overload;
use steadycut_core::blocks::cutting::crash::Crash;
use steadycut_core::models::formula_model::FormulaModel;
use steadycut_core::models::unks::Stored;
use steadycut_core::run::edits::Edits;
use steadycut_core::run::end::End;
use steadycut_core::run::one_run::Run;
use steadycut_core::run::scenario::{Scenario, table};
use steadycut_core::run::story::Story;
use steadycut_core::run::{constant_feed_twin, presets, scenario_file, scenario_link};

/// A choice of language that ends with it.
struct Chosen;

impl Chosen {
    /// Marks every text that the catalogue has.
    fn marked() -> Self {
        use_catalogue(Some(Catalogue::padded()));
        Self
    }

    fn of(language: Language) -> Self {
        choose(language);
        Self
    }
}

impl Drop for Chosen {
    fn drop(&mut self) {
        use_catalogue(None);
    }
}

/// Errors of settings, files, links and formulas.
fn errors() -> Vec<String> {
    let mut scenario = Scenario::default();
    let mut errors: Vec<String> = Vec::new();
    for (path, value) in [
        ("target.ra_um", Value::Float(-1.0)),
        ("target.ra_mm", Value::Float(1.0)),
        ("run.seed", Value::Float(0.5)),
        ("cnc.force_stop", Value::Int(1)),
        ("controller.kind", Value::Text("none".to_owned())),
        ("info.name", Value::Text("x".repeat(100))),
        ("workpiece.cuts", Value::Int(1)),
        ("workpiece.depth_steps", Value::Int(1)),
        ("program.cut_feeds_mm_min", Value::Int(1)),
        ("disturbances.hard_spots", Value::Int(1)),
        ("formula.force", Value::Text("{".to_owned())),
        ("controller.unks.networks", Value::Text("{}".to_owned())),
        ("noise.band_low_hz", Value::Float(90.0)),
    ] {
        errors.push(scenario.set(path, value).unwrap_err().to_string());
    }
    for text in ["a + ", "a b", "ln a", "1e999", "a + log(b)", "a $ b", "(a", "b"] {
        errors.push(Formula::parse(text, &["a"]).unwrap_err().to_string());
    }
    for text in
        ["", "version = 9", "version = 1\n[target]\nra_um = \"x\"", "version = 1\nedits = 1"]
    {
        errors.push(scenario_file::parse(text).unwrap_err().to_string());
    }
    for link in ["v=9", "v=1&x", "v=1&at.x=1", "v=1&z=*", "v=1&series.target.ra_um=1"] {
        errors.push(scenario_link::parse(link).unwrap_err().to_string());
    }
    for text in ["{}", "{\"version\": 1, \"more\": 2}", "{\"version\": \"x\"}", "["] {
        errors.push(FormulaModel::parse(text).unwrap_err());
        errors.push(Stored::parse(text).unwrap_err());
    }
    errors.push(decode(b"Fr\xe4sen").unwrap_err());
    errors.push(presets::load("none").unwrap_err().to_string());
    errors
}

#[test]
fn errors_are_told_in_the_chosen_language() {
    let english = errors();
    let _chosen = Chosen::marked();
    for (error, english) in errors().iter().zip(english) {
        assert!(error.contains('«'), "not asked for in a language: {error}");
        assert!(!english.contains('«'), "{english}");
    }
}

#[test]
fn what_a_setting_allows_is_told_in_the_chosen_language() {
    let _chosen = Chosen::marked();
    for param in table() {
        let allowed = param.spec.allowed.allowed(param.spec.unit);
        assert!(allowed.contains('«'), "{}: {allowed}", param.path);
    }
}

#[test]
fn ends_are_told_in_the_chosen_language() {
    let stop = Overload {
        force_n: 800.0,
        limit_n: 500.0,
        position_mm: 12.5,
        time_s: 1.25,
        retracted: true,
    };
    let crash = Crash {
        feed_mm_min: 5000.0,
        speed_rpm: 100.5,
        radius_mm: 8.0,
        position_mm: 12.5,
        time_s: 1.25,
    };
    let ends = [End::PathDone, End::TimeLimit, End::Overload(stop), End::Crash(crash)];
    {
        let _chosen = Chosen::marked();
        for end in &ends {
            assert!(end.to_string().contains('«'), "{end}");
        }
    }
    let _chosen = Chosen::of(Language::German);
    assert!(ends[2].to_string().contains("12,5 mm"), "{}", ends[2]);
}

#[test]
fn files_and_links_are_english_whatever_is_chosen() {
    let scenario = presets::load("depth-step").unwrap();
    let written = || {
        let none = Edits::none();
        [scenario_file::write(&scenario, &none), scenario_link::write(&scenario, &none)]
    };
    let english = written();
    {
        let _chosen = Chosen::marked();
        assert_eq!(written(), english);
    }
    let _chosen = Chosen::of(Language::German);
    assert_eq!(written(), english);
}

#[test]
fn a_run_is_told_in_the_chosen_language() {
    let _chosen = Chosen::marked();
    for name in ["depth-step", "disturbed-cut", "experiment-2", "tool-life", "chatter"] {
        let run = Run::complete(&presets::load(name).unwrap(), &Edits::none());
        let twin = constant_feed_twin::beside(&run);
        for event in Story::of(&run, Some(&twin)).events {
            let told = event.sentence.trim();
            assert!(told.starts_with('«') || told.contains(": «"), "{name}: {told}");
        }
    }
}
