//! A scenario stays checked, and what was expensive to check is kept.

use super::*;
use crate::models::structure::parameters::Parameters;
use crate::run::edits::{Edit, Edits};
use crate::run::one_run::{End, Run};

fn coupled() -> Scenario {
    let mut scenario = Scenario::default();
    scenario.change(|settings| settings.machine.coupled = true).unwrap();
    scenario
}

fn edit(at_s: f64, path: &str, value: Value) -> Edit {
    Edit { at_s, path: path.to_owned(), value }
}

#[test]
fn the_default_settings_pass_their_own_check() {
    assert_eq!(Scenario::try_from(Settings::default()).unwrap(), Scenario::default());
    assert!(Scenario::default().coupled_machine().is_none());
}

#[test]
fn a_typed_change_is_checked_like_any_other() {
    let mut scenario = Scenario::default();
    let before = scenario.clone();
    for (change, words) in [
        ((|s| s.target.ra_um = 50.0) as fn(&mut Settings), "target.ra_um"),
        (|s| s.target.ra_um = f64::NAN, "NaN"),
        (|s| s.run.record_every = 3, "run.record_every"),
        (|s| s.info.name = "x".repeat(81), "80 characters"),
        (
            |s| (s.machine.coupled, s.machine.parameters) = (true, Parameters::Printed),
            "machine.parameters",
        ),
    ] {
        let refused = scenario.change(change).unwrap_err().to_string();
        assert!(refused.contains(words), "{refused}");
        assert_eq!(scenario, before, "{words}: refused as a whole");
    }
}

#[test]
fn the_eigenproblem_is_solved_only_for_another_machine() {
    let base = coupled();
    let solved = Reduction::solved();
    let mut edits = Edits::none();
    for k in 0..200 {
        let at_s = 0.01 * f64::from(k);
        let value = Value::Float(0.8 + 1e-3 * f64::from(k));
        edits.push(&base, edit(at_s, "target.ra_um", value)).unwrap();
    }
    // As a session does every frame and with every change.
    for k in 0..20 {
        assert!(edits.scenario_at(&base, 0.1 * f64::from(k)).unwrap().coupled_machine().is_some());
    }
    assert!(edits.fitted(&base).1.is_empty());
    let short = base.with(|settings| settings.run.duration_s = 3.0).unwrap();
    assert!(matches!(Run::complete(&short, &edits).end(), Some(End::TimeLimit)));
    let mut other = base.clone();
    other.set("machine.specific_cutting_force_n_mm2", Value::Float(4000.0)).unwrap();
    other.set("machine.coupled", Value::Bool(true)).unwrap();
    assert_eq!(Reduction::solved(), solved);
    other.set("machine.spindle_quality", Value::Float(17.0)).unwrap();
    assert_eq!(Reduction::solved(), solved + 1);
    assert_ne!(other.coupled_machine(), base.coupled_machine());
}

#[test]
fn edits_that_do_not_fit_another_base_are_told_and_never_dropped_in_a_run() {
    let base = Scenario::default();
    let mut edits = Edits::none();
    edits.push(&base, edit(1.0, "target.ra_um", Value::Float(0.9))).unwrap();
    edits.push(&base, edit(2.0, "noise.band_high_hz", Value::Float(30.0))).unwrap();
    edits.push(&base, edit(14.0, "target.ra_um", Value::Float(1.0))).unwrap();
    let other = base
        .with(|settings| {
            settings.noise.band_low_hz = 35.0;
            settings.run.duration_s = 10.0;
        })
        .unwrap();
    let (fitting, unfit) = edits.fitted(&other);
    assert_eq!(fitting.list().len(), 1);
    let words: Vec<String> = unfit.iter().map(ToString::to_string).collect();
    assert!(words[0].contains("2 s") && words[0].contains("noise.band_low_hz"), "{words:?}");
    assert!(words[1].contains("14 s") && words[1].contains("before 10 s"), "{words:?}");

    assert!(edits.scenario_at(&other, 5.0).is_err());
    let run = Run::complete(&other, &edits);
    assert!(matches!(run.end(), Some(End::Refused(_))), "{:?}", run.end());
    let end_s = run.recording().rows().last().unwrap().time_s;
    assert!((1.9..=2.0).contains(&end_s), "{end_s}");
}
