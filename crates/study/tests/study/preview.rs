//! The controller with preview, and the study of its robustness.

use steadycut_core::base::settings::{Kind, Value};
use steadycut_core::blocks::control::ControllerKind;
use steadycut_core::run::edits::Edits;
use steadycut_core::run::job::Job;
use steadycut_core::run::metrics::Metrics;
use steadycut_core::run::one_run::{End, Run};
use steadycut_core::run::presets::load;
use steadycut_core::run::scenario::{Scenario, parse_value, table};
use steadycut_study::robust::{DRAWN, Robustness};

fn scenario(preset: &str, changes: &[(&str, &str)]) -> Scenario {
    let mut scenario = load(preset).unwrap();
    scenario.change(|s| s.run.record_every = s.run.steps_per_control).unwrap();
    for (path, text) in changes {
        scenario.set(path, parse_value(path, text).unwrap()).unwrap();
    }
    scenario
}

fn run(scenario: &Scenario) -> Metrics {
    let run = Run::complete(scenario, &Edits::none());
    assert_eq!(run.end(), Some(&End::PathDone));
    run.metrics()
}

/// One cut over a step to nearly three times the force.
const HEAVY: (&str, &str) =
    ("workpiece.cuts", "[[[20.0, 3.0, 2.0], [9.0, 4.75, 0.0], [10.0, 2.75, 2.0]]]");
const LATE: [(&str, &str); 2] = [("cnc.dead_time_s", "0.08"), ("belief.dead_time_s", "0.08")];

#[test]
fn at_a_long_dead_time_preview_beats_unks_in_error_force_and_time() {
    // The first two cuts: with and without a heavy section.
    let with = |kind: &str| {
        let changes = [&LATE[..], &[("controller.kind", kind)]].concat();
        let mut scenario = scenario("experiment-2-per-cut", &changes);
        scenario.change(|s| s.workpiece.cuts.truncate(2)).unwrap();
        run(&scenario)
    };
    let (preview, unks) = (with("preview"), with("unks"));
    assert!(preview.normalized_standard_error < unks.normalized_standard_error, "{preview:?}");
    assert!(preview.max_force_n < 0.9 * unks.max_force_n, "{preview:?}");
    assert!(preview.time_of_cut_s < unks.time_of_cut_s, "{preview:?}");
}

#[test]
fn the_feed_falls_before_the_heavy_section_and_not_after_it() {
    let heavy = scenario("experiment-2", &[HEAVY, ("controller.kind", "preview")]);
    let run = Run::complete(&heavy, &Edits::none());
    let rows = run.recording().rows();
    // The step begins at 7.6 + 20 mm; the ball's contact points meet it some 6 mm before.
    let at = |x_mm: f64| rows.iter().find(|row| row.position_mm >= x_mm).unwrap();
    assert!(at(26.0).feed_override_percent < 0.8 * at(18.0).feed_override_percent);
    assert!(run.metrics().max_force_n < 1.35 * 665.0, "{:?}", run.metrics());
    // Without preview of it, where the part is believed to be even, the same step is met too late.
    let mut blind = heavy.clone();
    blind.change(|s| s.belief.position_error_mm = 5.0).unwrap();
    assert!(run.metrics().max_force_n + 50.0 < self::run(&blind).max_force_n);
}

#[test]
fn the_gain_is_what_the_belief_does_not_know() {
    let cut = [("workpiece.cuts", "[[[40.0, 3.0, 2.0]]]"), ("controller.kind", "preview")];
    let gain = |more: &[(&str, &str)]| {
        let mut scenario = scenario("experiment-2", &[&cut[..], more].concat());
        scenario.change(|s| s.noise.level = 0.0).unwrap();
        let run = Run::complete(&scenario, &Edits::none());
        let row = run.recording().rows().iter().find(|row| row.position_mm > 35.0).unwrap();
        row.gain_estimate
    };
    let sharp = gain(&[]);
    assert!((sharp - 1.0).abs() < 0.12, "run-out and slices aside the belief is right: {sharp}");
    let worn = gain(&[("plant.wear_factor", "1.3")]) / sharp;
    assert!((worn / 1.3 - 1.0).abs() < 0.05, "{worn}");
    let hard = gain(&[("plant.hardness_hb", "240")]) / sharp;
    assert!((hard / 1.2_f64.sqrt() - 1.0).abs() < 0.05, "1.2^0.4 is 1.076: {hard}");
    // What is believed too deep weighs less than believed.
    assert!(gain(&[("belief.depth_error_percent", "10")]) < 0.95 * sharp);
}

#[test]
fn on_one_path_it_holds_the_force_and_uses_the_depth_profile() {
    for preset in ["depth-step", "table3-5", "strategy-2013"] {
        let run =
            Run::complete(&scenario(preset, &[("controller.kind", "preview")]), &Edits::none());
        let last = run.recording().rows().last().unwrap();
        let error = (last.force_n / last.force_ref_n - 1.0).abs();
        assert!(error < 0.01, "{preset}: {last:?}");
    }
}

#[test]
fn belief_and_truth_are_apart() {
    let base = scenario("experiment-2", &[HEAVY, ("controller.kind", "preview")]);
    let digest = |scenario: &Scenario| Run::complete(scenario, &Edits::none()).recording().digest();
    let mut other = base.clone();
    other.change(|s| s.belief.depth_error_percent = 5.0).unwrap();
    assert_ne!(digest(&base), digest(&other), "preview reads the belief");
    for kind in ["unks", "division"] {
        let [mut base, mut other] = [base.clone(), other.clone()];
        for scenario in [&mut base, &mut other] {
            scenario.set("controller.kind", parse_value("controller.kind", kind).unwrap()).unwrap();
        }
        assert_eq!(digest(&base), digest(&other), "{kind} does not");
    }
}

#[test]
fn a_study_draws_everything_first_and_slices_change_nothing() {
    let short = scenario("experiment-2", &[("workpiece.cuts", "[[[10.0, 3.0, 2.0]]]")]);
    let study = Robustness::new(&short, ControllerKind::Preview, 3, 7);
    let mut sliced = study.clone();
    while !sliced.advance_by(10_007) {}
    let mut whole = study.clone();
    whole.to_end();
    assert_eq!(sliced.outcomes(), whole.outcomes());
    assert_eq!(sliced.outcomes().len(), 3);
    let findings = sliced.findings();
    assert!(findings.passed && findings.unfinished == 0, "{findings:?}");
    // The first runs of a longer study are the same runs.
    let longer = Robustness::new(&short, ControllerKind::Preview, 500, 7);
    for i in 0..3 {
        assert_eq!(study.scenario(i).unwrap(), longer.scenario(i).unwrap());
    }
    for (i, drawn) in DRAWN.iter().enumerate() {
        let values = (0..500).map(|run| longer.scenario(run).unwrap());
        let of = |scenario: &Scenario| match scenario.get(drawn.path).unwrap() {
            Value::Float(x) => x,
            other => panic!("{other}"),
        };
        let values: Vec<f64> = values.map(|scenario| of(&scenario)).collect();
        let [low, high] = drawn.range.map(|x| if drawn.relative { 200.0 * x } else { x });
        assert!(values.iter().all(|x| (low..=high).contains(x)), "{}", drawn.path);
        let mean = values.iter().sum::<f64>() / 500.0;
        assert!((mean - 0.5 * (low + high)).abs() < 0.06 * (high - low), "{i}: {mean}");
    }
    let stopped = scenario("experiment-2", &[HEAVY, ("cnc.force_stop_n", "300")]);
    let mut study = Robustness::new(&stopped, ControllerKind::Preview, 1, 1);
    study.to_end();
    assert!(!study.findings().passed && study.findings().unfinished == 1);
}

#[test]
fn no_setting_at_its_ends_makes_it_fail() {
    let cuts = ("workpiece.cuts", "[[[2.0, 3.0, 2.0], [1.0, 0.0, 0.0]], [[2.0, 5.0, -8.0]]]");
    let on_path = scenario("depth-step", &[("controller.kind", "preview")]);
    let on_cuts = scenario("first-cut", &[("controller.kind", "preview"), cuts]);
    for base in [on_path, on_cuts] {
        for param in table() {
            let ends = match &param.spec.allowed {
                Kind::Float { min, max } => [*min, *max].map(Value::Float),
                Kind::Int { min, max } => [*min, *max].map(Value::Int),
                // Cuts and profile are those of the base.
                Kind::Structured(shape) if shape.id() == "numbers" => {
                    [0.0, 1.0].map(|share| shape.example(share, 2))
                }
                _ => continue,
            };
            for value in ends {
                let mut extreme = base.clone();
                if extreme.set(&param.path, value).is_err() {
                    continue;
                }
                let mut run = Run::new(&extreme, &Edits::none());
                run.advance(3000);
                assert!(
                    !matches!(run.end(), Some(End::Fault(_))),
                    "{}: {:?}",
                    param.path,
                    run.end()
                );
            }
        }
    }
}
