//! A scenario stays checked, and what was expensive to check is kept.

use super::*;
use crate::blocks::cutting::force_model::ForceModel;
use crate::models::genetic::Calibration;
use crate::models::structure::parameters::Parameters;
use crate::models::tool::EndShape;
use crate::models::unks::{Stored, UnksNetworks, UnksStart};
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

fn list(settings: &mut Settings, path: &str, rows: Vec<Vec<f64>>) {
    settings.set_param(param(path).unwrap(), &rows.into()).unwrap();
}

/// Settings that break a rule and no other one.
fn breaking(rule: &Rule) -> Settings {
    let mut s = Settings::default();
    match rule.paths[0] {
        "plant.calibration" => s.plant.calibration = Calibration::Formula,
        "belief.calibration" => s.belief.calibration = Calibration::Formula,
        "plant.force_model" => s.plant.force_model = ForceModel::Mechanistic,
        "machine.parameters" => {
            (s.machine.parameters, s.machine.coupled) = (Parameters::Printed, true);
        }
        "machine.tip_modes" => {
            list(&mut s, rule.paths[0], vec![vec![0.0, 120.0, 0.05, 10.0]]);
            s.machine.coupled = true;
        }
        "wear.adjust_speed" => s.wear.adjust_speed = true,
        "cnc.speed_min_rpm" => (s.cnc.speed_min_rpm, s.cnc.speed_max_rpm) = (2000.0, 1500.0),
        "controller.unks.networks" => {
            let origin = |i| crate::base::network::parse(crate::models::unks::FILES[i]).unwrap().1;
            let origins = [origin(0), origin(1), origin(2)];
            let stored = Stored::new(UnksStart::Cold, UnksNetworks::shipped(), origins);
            s.controller.unks.networks = stored.into();
        }
        "tool.corner_radius_mm" => {
            (s.tool.shape, s.tool.corner_radius_mm) = (EndShape::BullNose, 9.0);
        }
        "workpiece.radial_depth_mm" => s.workpiece.radial_depth_mm = 20.0,
        "noise.band_low_hz" => s.noise.band_low_hz = 50.0,
        "disturbances.broken_teeth" if rule.paths[1] == "machine.coupled" => {
            list(&mut s, rule.paths[0], vec![vec![10.0]]);
            s.machine.coupled = true;
        }
        "disturbances.broken_teeth" => list(&mut s, rule.paths[0], vec![vec![1.0], vec![2.0]]),
        "disturbances.chatter_hz" => {
            list(&mut s, "disturbances.chatter_bursts", vec![vec![10.0, 5.0, 20.0]]);
            s.disturbances.chatter_hz = 500.0;
        }
        "disturbances.depth_steps" => list(&mut s, rule.paths[0], vec![vec![10.0, 5.0, 7.0]]),
        "run.record_every" => s.run.record_every = 3,
        "run.duration_s" => (s.run.duration_s, s.run.steps_per_control) = (3600.0, 1000),
        other => panic!("no settings here break the rule on {other}"),
    }
    s
}

#[test]
fn every_rule_can_be_broken_and_names_field_value_and_what_is_allowed() {
    for rule in RULES {
        rule.paths.iter().for_each(|path| assert_eq!(param(path).unwrap().path, *path));
        let settings = breaking(rule);
        let error = Scenario::try_from(settings.clone()).unwrap_err();
        let SettingError::Refused { path, value, allowed } = &error else { panic!("{error}") };
        assert_eq!(path, rule.paths[0], "{error}");
        assert!(!value.is_empty() && !allowed.is_empty(), "{error}");
        let text = error.to_string();
        let others = &rule.paths[1..];
        assert!(others.iter().any(|path| text.contains(path)), "{text}");
        // The rule joins what breaks it.
        let changed = settings.difference(&Settings::default());
        assert!(changed.iter().all(|(param, _)| rule.paths.contains(&param.path.as_str())));
    }
}

#[test]
fn every_companion_comes_with_its_setting_unless_it_is_set_too() {
    let text = |id: &str| Value::Text(id.to_owned());
    for companion in COMPANIONS {
        let chosen = match companion.of {
            "tool.name" => "square-12-4",
            "plant.model_set" => "strategy_2013",
            "plant.force_model" => "mechanistic",
            "plant.material" => "ti6al4v",
            "feed_drive.kind" => "measured_3hz",
            other => panic!("nothing is chosen here for {other}"),
        };
        let mut scenario = Scenario::default();
        scenario.set("run.steps_per_control", Value::Int(200)).unwrap();
        let before = scenario.get(companion.brings).unwrap();
        let mut alone = scenario.clone();
        alone.set(companion.of, text(chosen)).unwrap();
        assert_ne!(alone.get(companion.brings).unwrap(), before, "{}", companion.of);
        let both = [(companion.of, text(chosen)), (companion.brings, before.clone())];
        let both = both.map(|(path, value)| (path.to_owned(), value));
        scenario.set_all(&both).unwrap();
        assert_eq!(scenario.get(companion.brings).unwrap(), before, "{}", companion.of);
    }
}

#[test]
fn an_edit_that_a_rule_forbids_is_refused_when_it_is_made() {
    let base = Scenario::default();
    let mut edits = Edits::none();
    for (path, value) in [
        ("plant.force_model", Value::Text("mechanistic".to_owned())),
        ("wear.adjust_speed", Value::Bool(true)),
    ] {
        let refused = edits.push(&base, edit(1.0, path, value)).unwrap_err().to_string();
        assert!(refused.contains(path), "{refused}");
    }
    assert_eq!(edits, Edits::none());
}
