//! Links: those of older versions still open, long ones are packed, and nothing that is packed
//! takes more memory than a plain link may.

use base64::Engine;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;
use steadycut_core::base::math::sin;
use steadycut_core::base::settings::Value;
use steadycut_core::run::edits::{Edit, Edits};
use steadycut_core::run::presets::{PRESETS, load};
use steadycut_core::run::scenario::Scenario;
use steadycut_core::run::scenario_link::{parse, write};

const OF_0_4_0: &str = include_str!("../data/links_0.4.0.txt");

/// The preset whose depth steps come sooner since 0.4.0; its links keep the old ones.
const STEPS_MOVED: &str = "first-cut";

/// The links of 0.4.0 with their names.
fn old_links() -> impl Iterator<Item = (&'static str, &'static str)> {
    let lines = OF_0_4_0.lines().filter(|line| !line.starts_with('#'));
    lines.map(|line| line.split_once(' ').expect("a name and a link"))
}

fn packed(text: &str) -> String {
    let bytes = miniz_oxide::deflate::compress_to_vec_zlib(text.as_bytes(), 10);
    format!("v=1&z={}", URL_SAFE_NO_PAD.encode(bytes))
}

#[test]
fn links_of_0_4_0_open_to_the_same_scenario() {
    let mut presets = 0;
    for (name, link) in old_links() {
        let (scenario, edits) = parse(link).unwrap_or_else(|error| panic!("{name}: {error}"));
        if PRESETS.iter().any(|preset| preset.name == name) {
            presets += 1;
            let now = load(name).unwrap();
            let moved = scenario.difference(&now).into_iter().map(|(param, _)| param.path.as_str());
            // The description of a preset may be improved.
            let moved: Vec<&str> = moved.filter(|path| *path != "description").collect();
            let meant: &[&str] = if name == STEPS_MOVED { &["workpiece.depth_steps"] } else { &[] };
            assert_eq!(moved, meant, "{name}");
            assert_eq!(edits, Edits::none());
        }
    }
    assert_eq!(presets, 33);
}

#[test]
fn a_mangled_link_is_read_and_a_wrong_one_keeps_its_error() {
    let wanted = parse("v=1&target.ra_um=0.6&plant.hardness_hb=220").unwrap();
    for mangled in [
        "https://example.org/steadycut/#v=1&target.ra_um=0.6&plant.hardness_hb=220",
        "#v=1&amp;target.ra_um=0.6&amp;plant.hardness_hb=220",
        "v=1&target.ra_um=0.6&plant.hardness_hb=220)",
        "v=1&target.ra_um=0.6&plant.hardness_hb=220.",
        "<v=1&target.ra_um=0.6&plant.hardness_hb=220>,\n",
    ] {
        assert_eq!(parse(mangled).unwrap(), wanted, "{mangled}");
    }
    let long = write(&load("experiment-2").unwrap(), &Edits::none());
    assert_eq!(parse(&format!("({long}).")).unwrap(), parse(&long).unwrap());
    // A full stop that belongs to a text stays.
    let text = "v=1&description=One%20cut.";
    assert_eq!(parse(text).unwrap().0.info.description, "One cut.");
    for wrong in ["v=1&target.ra_um=9)", "v=1&target.ra=0.6.", ""] {
        let [error, plain] = [parse(wrong), parse(wrong.trim_end_matches([')', '.']))]
            .map(|read| read.unwrap_err().to_string());
        assert!(!error.is_empty() && !plain.is_empty());
        if wrong.contains("ra_um") {
            assert!(error.contains("target.ra_um"), "{error}");
        }
    }
}

#[test]
fn edits_and_every_setting_of_a_link_of_0_4_0_are_read() {
    let of = |wanted: &str| old_links().find(|(name, _)| *name == wanted).unwrap().1;
    let (scenario, edits) = parse(of("edited")).unwrap();
    let times: Vec<f64> = edits.list().iter().map(|edit| edit.at_s).collect();
    assert_eq!(times, [1e-7, 0.25, 33.333]);
    assert_eq!(edits.list()[1].value, Value::Float(0.6));
    assert_eq!(scenario.get("controller.kind").unwrap(), Value::Text("tracking".to_owned()));
    let everything = of("everything");
    let (scenario, _) = parse(everything).unwrap();
    // The settings that the link names, without those that came with a choice.
    let moved = scenario.difference(&Scenario::default()).len();
    assert!(moved + 4 >= everything.split('&').count(), "{moved}");
    assert!(moved > 140, "{moved}");
    assert_eq!(scenario.get("target.ra_um").unwrap(), Value::Float(0.8181));
}

#[test]
fn long_links_are_packed_and_short_ones_stay_readable() {
    let mut scenario = load("experiment-2").unwrap();
    let long = write(&scenario, &Edits::none());
    assert!(long.starts_with("v=1&z="), "{long}");
    let plain = old_links().find(|(name, _)| *name == "experiment-2").unwrap().1;
    assert!(long.len() < plain.len() * 7 / 10, "{} of {}", long.len(), plain.len());
    assert_eq!(parse(&long).unwrap().0, scenario);
    // What is added by hand wins over what is packed.
    scenario.set("target.force_n", Value::Float(700.0)).unwrap();
    assert_eq!(parse(&format!("{long}&target.force_n=700")).unwrap().0, scenario);
    let mut short = Scenario::default();
    short.set("target.ra_um", Value::Float(0.6)).unwrap();
    assert_eq!(write(&short, &Edits::none()), "v=1&target.ra_um=0.6");
    assert_eq!(write(&Scenario::default(), &Edits::none()), "v=1");
    let edit = Edit { at_s: 1.5, path: "target.ra_um".to_owned(), value: Value::Float(1.0) };
    let mut edits = Edits::none();
    edits.push(&load("experiment-2").unwrap(), edit).unwrap();
    let link = write(&load("experiment-2").unwrap(), &edits);
    assert_eq!(parse(&link).unwrap().1, edits);
}

#[test]
fn what_is_packed_wrongly_is_refused_with_a_reason() {
    let message = |link: &str| parse(link).unwrap_err().to_string();
    let bomb = packed(&"a".repeat(100_000_000));
    assert!(bomb.len() < 200_000, "{}", bomb.len());
    assert!(message(&bomb).contains("more than 2000000 bytes"), "{}", message(&bomb));
    let good = packed("target.ra_um=0.6&program.feed_mm_min=400");
    assert_eq!(parse(&good).unwrap().0.get("target.ra_um").unwrap(), Value::Float(0.6));
    assert!(message(&good[..good.len() - 3]).contains("link"));
    assert!(message("v=1&z=!!").contains("Base64"));
    assert!(message(&format!("{good}&{}", &good[4..])).contains("twice"));
    assert!(message(&packed("target.ra_um=abc")).contains("abc"));
    assert!(message(&packed(&packed("target.ra_um=0.6")[4..])).contains("twice"));
    assert!(message(&packed("target.ra_um=0.6").replace("v=1&", "")).contains("v=1"));
}

/// A slider dragged to and fro for 40 s as the console keeps it: a value each quarter of a second and up to a
/// frame more, with the slider's three decimals.
#[test]
fn a_storm_of_edits_is_some_hundred_characters() {
    let scenario = load("first-cut").unwrap();
    let mut edits = Edits::none();
    let mut at_us = 1_000_000_u64;
    for i in 0..160_u64 {
        let wave = sin(i as f64 * 0.37) + sin(i as f64 * 0.113 + 1.5);
        let value = Value::Float(((1.4 + 0.6 * wave) * 1000.0).round() / 1000.0);
        edits
            .push(&scenario, Edit { at_s: at_us as f64 / 1e6, path: "target.ra_um".into(), value })
            .unwrap();
        at_us += 250_000 + 1000 * ((i * 7919) % 17);
    }
    let link = write(&scenario, &edits);
    assert!(link.len() < 900, "{} characters", link.len());
    assert_eq!(parse(&link).unwrap(), (scenario.clone(), edits));
    // The program of before wrote them one by one; that still opens, and so do both in one link.
    let mixed = "v=1&at.3.target.ra_um=0.7&series.target.ra_um=0:5,1,1,1:1:5,1,1,1&at.6.5.plant.wear_factor=1.2";
    let (base, mixed) = parse(mixed).unwrap();
    let times: Vec<f64> = mixed.list().iter().map(|edit| edit.at_s).collect();
    assert_eq!(times, [3.0, 5.0, 6.0, 6.5, 7.0, 8.0]);
    assert_eq!(parse(&write(&base, &mixed)).unwrap().1, mixed);
    // A series obeys the range and the kind of its setting.
    let outside = parse("v=1&series.target.ra_um=0:5,1,1,1:0:1,1,1,90").unwrap_err().to_string();
    assert!(outside.contains("target.ra_um") && outside.contains("93"), "{outside}");
    let kind = parse("v=1&series.controller.kind=0:5,1,1,1:0:1,1,1,1").unwrap_err().to_string();
    assert!(kind.contains("controller.kind"), "{kind}");
}
