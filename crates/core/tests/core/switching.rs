//! Controllers changed in the running cut, and controllers freed from a limit.

use steadycut_core::base::settings::Value;
use steadycut_core::blocks::control::ControllerKind;
use steadycut_core::blocks::control::law::AtRest;
use steadycut_core::blocks::control::mrac::Adapted;
use steadycut_core::blocks::cutting::process::ForceModel;
use steadycut_core::run::edits::{Edit, Edits};
use steadycut_core::run::one_run::{End, Run};
use steadycut_core::run::presets::load;
use steadycut_core::run::scenario::Scenario;

/// Goes at once where the part ahead allows, whatever was sent before: its state is a gain, not an override.
const LOOKS_AHEAD: ControllerKind = ControllerKind::Preview;

/// The controllers whose state is set to the override that they find, from the registry: all but the one that
/// looks ahead and those that are static laws with these settings.
fn stateful(scenario: &Scenario) -> Vec<ControllerKind> {
    let mut found = Vec::new();
    for kind in ControllerKind::ALL {
        let chosen = scenario.with(|s| s.controller.kind = *kind).unwrap();
        // A script begins with a static law.
        let is_static = match chosen.controller.at_rest() {
            AtRest::WhereTheLawMeetsThePlant | AtRest::Unknown => true,
            AtRest::OnReference | AtRest::NearReference => false,
        };
        if !is_static && *kind != LOOKS_AHEAD {
            found.push(*kind);
        }
    }
    found
}

#[test]
fn what_has_a_state_is_known_to_have_one() {
    // P has an integral part here.
    let found = stateful(&calm("table3-5", Adapted::Gain));
    for kind in [ControllerKind::Proportional, ControllerKind::Mrac, ControllerKind::Unks] {
        assert!(found.contains(&kind), "{kind:?}");
    }
    for kind in [ControllerKind::ConstantFeed, ControllerKind::Sdnrp, ControllerKind::Division] {
        assert!(!found.contains(&kind), "{kind:?}");
    }
}

#[test]
fn what_looks_ahead_goes_at_once_where_the_part_allows() {
    let mut scenario = calm("table3-5", Adapted::Gain);
    scenario.change(|s| s.controller.kind = ControllerKind::ConstantFeed).unwrap();
    let found = bump(&scenario, LOOKS_AHEAD, 4.0, &[]);
    assert!(found > BUMP_PERCENT, "{found} percent: it belongs to the others now");
}

/// Most change of the feed override at the switch, percent.
const BUMP_PERCENT: f64 = 0.5;

fn calm(preset: &str, adapted: Adapted) -> Scenario {
    let mut scenario = load(preset).unwrap();
    scenario
        .change(|s| {
            s.noise.level = 0.0;
            s.controller.mrac.adapted = adapted;
            s.controller.proportional.ki = 0.05;
            s.controller.proportional.kp = 0.5;
        })
        .unwrap();
    scenario
}

/// How far the feed override goes in the control period after a switch, percent.
fn bump(scenario: &Scenario, to: ControllerKind, at_s: f64, edits: &[(f64, &str, f64)]) -> f64 {
    let mut scenario = scenario.clone();
    scenario.change(|s| s.run.duration_s = at_s + 1.0).unwrap();
    let mut all = Edits::none();
    for (at_s, path, value) in edits {
        let (path, value) = ((*path).to_owned(), Value::Float(*value));
        all.push(&scenario, Edit { at_s: *at_s, path, value }).unwrap();
    }
    let (path, value) = ("controller.kind".to_owned(), Value::Text(to.id().to_owned()));
    all.push(&scenario, Edit { at_s, path, value }).unwrap();
    let run = Run::complete(&scenario, &all);
    assert_eq!(run.end(), Some(&End::TimeLimit), "{to:?}");
    let rows = run.recording().rows();
    let index = run.recording().index_at(at_s);
    // The command of the period that begins at the switch stands in the next row.
    (rows[index + 1].feed_override_percent - rows[index].feed_override_percent).abs()
}

fn switches_smoothly(scenario: &Scenario, at_s: f64, edits: &[(f64, &str, f64)]) {
    for from in ControllerKind::ALL {
        for to in stateful(scenario) {
            if *from == to {
                continue;
            }
            let mut scenario = scenario.clone();
            scenario.change(|s| s.controller.kind = *from).unwrap();
            let found = bump(&scenario, to, at_s, edits);
            assert!(found <= BUMP_PERCENT, "{from:?} to {to:?} at {at_s} s: {found} percent");
        }
    }
}

#[test]
fn controllers_take_over_a_cut_at_rest_without_a_bump() {
    for adapted in [Adapted::Landau, Adapted::Gain] {
        for force_model in [ForceModel::Formula, ForceModel::Neural] {
            let mut scenario = calm("table3-5", adapted);
            scenario.change(|s| s.plant.force_model = force_model).unwrap();
            switches_smoothly(&scenario, 4.0, &[]);
        }
    }
}

#[test]
fn controllers_take_over_in_a_transient_without_a_bump() {
    let scenario = calm("table3-5", Adapted::Gain);
    switches_smoothly(&scenario, 3.1, &[(3.0, "workpiece.axial_depth_mm", 2.4)]);
}

#[test]
fn controllers_take_over_tooth_by_tooth_without_a_bump() {
    let mut scenario = calm("experiment-1", Adapted::Gain);
    scenario.change(|s| s.run.record_every = s.run.steps_per_control).unwrap();
    for from in [ControllerKind::Division, ControllerKind::Unks] {
        scenario.change(|s| s.controller.kind = from).unwrap();
        for to in stateful(&scenario).into_iter().filter(|to| *to != from) {
            let found = bump(&scenario, to, 4.0, &[]);
            // Here the override is rounded to whole percents.
            assert!(found <= 1.0 + 1e-9, "{from:?} to {to:?}: {found} percent");
        }
    }
}

/// A light section in which the largest override is too little, for more than 3 s, and then one in
/// which the reference is in reach, all at once.
fn freed(kind: ControllerKind) -> Scenario {
    let mut scenario = calm("experiment-2-neural", Adapted::Gain);
    scenario.change(|s| s.controller.kind = kind).unwrap();
    scenario
        .change(|s| {
            s.workpiece.cuts.clear();
            s.workpiece.axial_depth_mm = 1.2;
            s.workpiece.radial_depth_mm = 3.9;
            s.workpiece.depth_steps = vec![[30.0, 4.0]];
            s.workpiece.length_mm = 80.0;
            s.run.record_every = s.run.steps_per_control;
        })
        .unwrap();
    scenario
}

#[test]
fn nothing_winds_up_at_the_largest_override() {
    // Control periods until the force is back within 10 % for good.
    const BACK: usize = 25;
    const SOONER: [(ControllerKind, usize); 4] = [
        (ControllerKind::Tracking, 20),
        (ControllerKind::AdjustablePi, 10),
        (ControllerKind::Mrac, 15),
        (ControllerKind::Unks, 10),
    ];
    for kind in stateful(&calm("experiment-2-neural", Adapted::Gain)) {
        let limit = SOONER.iter().find(|(sooner, _)| *sooner == kind).map_or(BACK, |one| one.1);
        let run = Run::complete(&freed(kind), &Edits::none());
        let rows = run.recording().rows();
        let step = rows.iter().position(|row| row.axial_depth_mm == 4.0).unwrap();
        let (light, heavy) = rows.split_at(step);
        // The last 3 s of the light section stand at the limit, with too little force.
        for row in &light[light.len() - 150..] {
            // The sum of P stands still one step before the limit.
            assert!(row.feed_override_percent >= 148.0, "{kind:?} {row:?}");
            assert!(row.force_n < 0.9 * row.force_ref_n, "{kind:?} {row:?}");
        }
        let outside = |row: &steadycut_core::run::signals::Row| {
            (row.force_n / row.force_ref_n - 1.0).abs() > 0.1
        };
        assert!(heavy.iter().any(outside), "{kind:?}: there must be something to come back from");
        let back = heavy.iter().rposition(outside).unwrap() + 1;
        assert!(back <= limit, "{kind:?}: back after {back} periods");
    }
}
