//! One meaning of each signal on every plant: maps along one path and along sections, tooth by tooth,
//! coupled to the machine or not.

use steadycut_core::blocks::control::ControllerKind;
use steadycut_core::blocks::cutting::process::ForceModel;
use steadycut_core::run::edits::Edits;
use steadycut_core::run::one_run::{End, Run};
use steadycut_core::run::presets::load;
use steadycut_core::run::scenario::Scenario;
use steadycut_core::run::signals::{Row, flag};

/// A plant at a noise level, at constant feed, so that what is sensed moves nothing.
fn plant(force_model: ForceModel, several: bool, coupled: bool, level: f64) -> Scenario {
    let mut scenario = load("machine-dynamics").unwrap();
    scenario
        .change(|s| {
            s.controller.kind = ControllerKind::ConstantFeed;
            s.plant.force_model = force_model;
            s.machine.coupled = coupled;
            s.noise.level = level;
            s.run.duration_s = 2.5;
            s.run.steps_per_control = 20;
            if force_model.tooth_by_tooth() {
                s.run.steps_per_control = 200;
            }
            s.run.record_every = s.run.steps_per_control;
            if several {
                s.workpiece.cuts = vec![vec![[9.0, 2.0, 2.0]], vec![[30.0, 2.5, 2.0]]];
            }
        })
        .unwrap();
    scenario
}

fn rows(scenario: &Scenario) -> Vec<Row> {
    let run = Run::complete(scenario, &Edits::none());
    assert_eq!(run.end(), Some(&End::TimeLimit));
    run.recording().rows().to_vec()
}

/// Every force model, along one path and along several cuts.
fn plants() -> impl Iterator<Item = (ForceModel, bool)> {
    ForceModel::ALL.iter().flat_map(|model| [false, true].map(|several| (*model, several)))
}

fn values(rows: &[Row], get: fn(&Row) -> f64) -> Vec<f64> {
    rows.iter().map(get).collect()
}

#[test]
fn without_disturbance_the_two_forces_and_the_measured_one_are_the_same() {
    for (model, several) in plants() {
        let rows = rows(&plant(model, several, false, 0.0));
        assert!(rows.iter().any(|row| row.force_n > 50.0), "{model:?}");
        for pair in rows.windows(2) {
            assert_eq!(pair[1].force_n, pair[1].force_dyn_n, "{model:?} {several} {:?}", pair[1]);
            // The sample is that of the end of the tick before, and stands in the next row.
            let [sampled, held] = [pair[0].force_dyn_n, pair[1].force_measured_n];
            assert_eq!(sampled, held, "{model:?} {several} {:?}", pair[1]);
        }
    }
}

#[test]
fn the_disturbance_shakes_the_force_with_dynamics_and_never_the_map() {
    for (model, several) in plants() {
        for coupled in [false, true] {
            let [still, shaken] =
                [0.0, 1.0].map(|level| rows(&plant(model, several, coupled, level)));
            let case = format!("{model:?}, several cuts {several}, coupled {coupled}");
            let of = |get: fn(&Row) -> f64| [values(&still, get), values(&shaken, get)];
            let [before, after] = of(|row| row.force_dyn_n);
            assert_ne!(before, after, "{case}");
            let [before, after] = of(|row| row.force_n);
            // The teeth cut the material as it is.
            assert_eq!(before == after, model.is_map(), "{case}");
            let [before, after] = of(|row| row.position_mm);
            assert_eq!(before, after, "{case}: nothing but the force may differ");
        }
    }
}

#[test]
fn vibration_shakes_the_force_with_dynamics_alone() {
    for (model, several) in plants() {
        let [rigid, coupled] =
            [false, true].map(|coupled| rows(&plant(model, several, coupled, 0.0)));
        let case = format!("{model:?}, several cuts {several}");
        let in_cut = |rows: &[Row]| -> Vec<Row> {
            rows.iter().filter(|row| !row.has(flag::AIR)).copied().collect()
        };
        assert!(in_cut(&coupled).iter().any(|row| row.force_dyn_n != row.force_n), "{case}");
        if model.is_map() {
            assert_eq!(
                values(&rigid, |row| row.force_n),
                values(&coupled, |row| row.force_n),
                "{case}"
            );
        } else {
            // Its own compliance is taken away from the tool that a machine holds.
            let largest = |rows: &[Row]| rows.iter().map(|row| row.force_n).fold(0.0, f64::max);
            let ratio = largest(&coupled) / largest(&rigid);
            assert!((ratio - 1.0).abs() < 0.05, "{case}: {ratio}");
        }
    }
}
