//! A result does not depend on the step of time, nor on how many of the steps are recorded.

use steadycut_core::base::settings::Value;
use steadycut_core::base::stats;
use steadycut_core::blocks::control::ControllerKind;
use steadycut_core::blocks::cutting::process::ForceModel;
use steadycut_core::run::edits::{Edit, Edits};
use steadycut_core::run::metrics::Metrics;
use steadycut_core::run::one_run::Run;
use steadycut_core::run::presets::load;
use steadycut_core::run::scenario::{Scenario, Settings};
use steadycut_core::run::signals::flag;

/// Plant steps in a control period of 20 ms, from one to far more than are needed.
const MAP_STEPS: [u32; 4] = [1, 4, 20, 100];
/// The same tooth by tooth, from the longest step that is allowed.
const TEETH_STEPS: [u32; 4] = [200, 288, 576, 960];

fn with(scenario: &Scenario, change: impl FnOnce(&mut Settings)) -> Scenario {
    scenario.with(change).unwrap()
}

/// Every plant under the noise of all sources.
fn plants() -> Vec<(String, Scenario)> {
    let mut plants = Vec::new();
    for model in ForceModel::ALL {
        for (several, coupled) in [(false, false), (true, false), (false, true)] {
            let scenario = with(&load("table3-5-noise").unwrap(), |s| {
                s.run.steps_per_control = if model.tooth_by_tooth() { 200 } else { 20 };
                s.plant.force_model = *model;
                s.machine.coupled = coupled;
                s.program.spindle_rpm = 1500.0;
                s.noise.correlation_mm = 0.5;
                // Ra is steep in the force: a narrow band would judge noise.
                s.target.tolerance_percent = 50.0;
                s.run.duration_s = if model.tooth_by_tooth() { 4.0 } else { 12.0 };
                if several {
                    s.workpiece.cuts = vec![vec![[12.0, 2.0, 2.0]], vec![[80.0, 2.5, 2.0]]];
                }
            });
            plants.push((format!("{model:?}, several {several}, coupled {coupled}"), scenario));
        }
    }
    plants
}

/// Mean and deviation of the dynamic component over all plant steps after a second, and the metrics.
fn measured(scenario: &Scenario) -> (f64, f64, Metrics) {
    let run = Run::complete(scenario, &Edits::none());
    let rows = run.recording().rows().iter().filter(|row| row.time_s > 1.0 && !row.has(flag::AIR));
    let shares: Vec<f64> = rows.map(|row| row.force_dyn_n / row.force_n).collect();
    let mean = stats::mean(shares.iter().copied()).unwrap();
    (mean, stats::deviation(&shares).unwrap(), run.metrics())
}

#[test]
fn the_ripple_has_its_mean_and_size_at_any_step() {
    // At 1500 1/min a tooth passes in exactly 20 ms.
    for steps in MAP_STEPS {
        let scenario = with(&load("table3-5-noise").unwrap(), |s| {
            s.controller.kind = ControllerKind::ConstantFeed;
            s.program.spindle_rpm = 1500.0;
            s.noise.band_percent = 0.0;
            s.noise.inhomogeneity_percent = 0.0;
            s.run.steps_per_control = steps;
        });
        let (mean, deviation, _) = measured(&scenario);
        let size = 0.015 / 2.0_f64.sqrt();
        assert!((mean - 1.0).abs() < 1e-3, "{steps} steps: mean {mean}");
        assert!((deviation / size - 1.0).abs() < 0.05, "{steps} steps: {deviation}, {size}");
    }
}

#[test]
fn every_plant_gives_the_same_at_four_steps() {
    // At constant feed under all noise, and in closed loop without it: noise of another draw moves a loop.
    for (kind, level) in [(ControllerKind::ConstantFeed, 1.0), (ControllerKind::Tracking, 0.0)] {
        for (plant, scenario) in plants() {
            let by_teeth = scenario.plant.force_model.tooth_by_tooth();
            let steps = if by_teeth { TEETH_STEPS } else { MAP_STEPS };
            let found = steps.map(|steps| {
                measured(&with(&scenario, |s| {
                    s.controller.kind = kind;
                    s.noise.level = level;
                    s.run.steps_per_control = steps;
                    s.run.record_every = if by_teeth { steps / 4 } else { 1 };
                }))
            });
            // A machine that vibrates is another draw of its phases.
            let (share, size) = if scenario.machine.coupled { (0.012, 0.25) } else { (2e-3, 0.05) };
            // Against the finest step.
            let (mean, deviation, metrics) = &found[3];
            for (steps, (mean_then, deviation_then, then)) in steps.iter().zip(&found) {
                let case = format!("{plant}, {kind:?}, {steps} steps");
                assert!((mean_then - mean).abs() < share, "{case}: mean {mean_then}, {mean}");
                let off = (deviation_then - deviation).abs();
                assert!(off < size * deviation + 1e-3, "{case}: {deviation_then}, {deviation}");
                // Tooth by tooth a control period holds one tooth or the other of those that run out, by the
                // angle at which the steps began: the loop then goes another way to the same place.
                let slack = if by_teeth && kind == ControllerKind::Tracking { 5.0 } else { 1.0 };
                agree(&case, then, metrics, slack);
            }
        }
    }
}

/// Metrics of two steps of time agree, within `slack` times as much as those of maps.
fn agree(case: &str, a: &Metrics, b: &Metrics, slack: f64) {
    let near = |name: &str, [a, b]: [Option<f64>; 2], within: f64| match (a, b) {
        (Some(a), Some(b)) => {
            assert!((a - b).abs() <= slack * within, "{case}: {name} {a}, {b}");
        }
        (a, b) => assert_eq!(a, b, "{case}: {name}"),
    };
    let relative = |name: &str, get: fn(&Metrics) -> f64, within: f64| {
        near(name, [Some(get(a)), Some(get(b))], within * get(b).abs());
    };
    relative("time", |m| m.time_of_cut_s, 0.002);
    // The way is summed up by the feed at the end of each step.
    relative("path", |m| m.path_mm, 0.006);
    relative("metal", |m| m.metal_removed_cm3, 0.01);
    relative("feed", |m| m.feed_final_mm_min, 0.008);
    relative("speed", |m| m.spindle_final_rpm, 0.003);
    relative("largest force", |m| m.max_force_n, 0.04);
    let force = b.force_final_n.unwrap_or(0.0);
    near("force", [a.force_final_n, b.force_final_n], 0.012 * force);
    // Ra follows from the force and is some five times as steep.
    let ra = b.ra_final_um.unwrap_or(0.0);
    near("Ra", [a.ra_final_um, b.ra_final_um], 0.06 * ra);
    near("in tolerance", [a.in_tolerance_percent, b.in_tolerance_percent], 3.0);
    let error = b.normalized_standard_error.unwrap_or(0.0);
    let errors = [a.normalized_standard_error, b.normalized_standard_error];
    near("error", errors, 0.03 * error + 0.001);
    near("outside", [Some(a.outside_percent), Some(b.outside_percent)], 2.0);
    near("saturated", [Some(a.saturated_percent), Some(b.saturated_percent)], 1.0);
}

#[test]
fn metrics_do_not_depend_on_which_steps_are_recorded() {
    for (plant, scenario) in plants() {
        let scenario = with(&scenario, |s| {
            s.controller.kind = ControllerKind::Tracking;
            s.run.duration_s = if s.plant.force_model.is_map() { 6.0 } else { 1.5 };
            s.workpiece.depth_steps = vec![[7.03, 2.4]];
        });
        let run = |every: u32| {
            let scenario = with(&scenario, |s| s.run.record_every = every);
            let mut edits = Edits::none();
            for (at_s, path, value) in
                [(1.203, "target.ra_um", 0.9), (1.301, "target.tolerance_percent", 5.0)]
            {
                let edit = Edit { at_s, path: path.to_owned(), value: Value::Float(value) };
                edits.push(&scenario, edit).unwrap();
            }
            Run::complete(&scenario, &edits)
        };
        let steps = scenario.run.steps_per_control;
        let every_step = run(1).metrics();
        for every in [2, steps / 4, steps] {
            assert_eq!(run(every).metrics(), every_step, "{plant}, every {every}");
        }
    }
}

#[test]
fn a_run_that_ends_between_rows_and_one_that_branches_count_every_step() {
    let scenario = |every: u32| {
        with(&load("depth-step").unwrap(), |s| {
            s.workpiece.length_mm = 41.7;
            s.run.record_every = every;
        })
    };
    let edit = |scenario: &Scenario, value: f64| {
        let mut edits = Edits::none();
        let path = "target.ra_um".to_owned();
        edits.push(scenario, Edit { at_s: 3.01, path, value: Value::Float(value) }).unwrap();
        edits
    };
    let [all, some] = [1, 20].map(|every| {
        let scenario = scenario(every);
        let mut run = Run::complete(&scenario, &edit(&scenario, 1.0));
        run.branch(3.01, &edit(&scenario, 0.7));
        run.advance(u64::MAX);
        (run.ticks(), run.metrics(), Run::complete(&scenario, &edit(&scenario, 0.7)).metrics())
    });
    assert_ne!(all.0 % 20, 0, "it ends between two rows");
    assert_eq!(all, some);
    assert_eq!(all.1, all.2);
}
