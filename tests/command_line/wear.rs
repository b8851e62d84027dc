//! Wear over the tool's life in the closed loop: one wear for every plant.

use std::process::Command;

use steadycut::base::settings::Value;
use steadycut::blocks::control::ControllerKind;
use steadycut::blocks::cutting::process::ForceModel;
use steadycut::run::edits::{Edit, Edits};
use steadycut::run::one_run::Run;
use steadycut::run::presets::load;
use steadycut::run::scenario::Scenario;
use steadycut::run::signals::flag;

/// Constant feed and speed without noise, so that only wear moves the force.
fn steady(force_model: ForceModel) -> Scenario {
    let mut scenario = load("first-cut").unwrap();
    scenario
        .change(|s| {
            s.controller.kind = ControllerKind::ConstantFeed;
            s.noise.level = 0.0;
            s.plant.force_model = force_model;
            s.run.duration_s = 0.6;
            if force_model.tooth_by_tooth() {
                s.run.steps_per_control = 576;
                s.run.record_every = 576;
            }
        })
        .unwrap();
    scenario
}

fn with(mut scenario: Scenario, settings: &[(&str, Value)]) -> Scenario {
    for (path, value) in settings {
        scenario.set(path, value.clone()).unwrap();
    }
    scenario
}

fn life(extra: &[(&str, Value)], scenario: Scenario) -> Scenario {
    let scenario = with(scenario, &[("wear.model", Value::Text("life".to_owned()))]);
    with(scenario, extra)
}

#[test]
fn a_tool_at_the_end_of_its_life_takes_1_6_times_the_force_of_every_plant() {
    for model in ForceModel::ALL {
        let worn = life(&[("wear.used_life", Value::Float(1.0))], steady(*model));
        let same = with(steady(*model), &[("plant.wear_factor", Value::Float(1.6))]);
        let [worn, same] = [worn, same].map(|scenario| Run::complete(&scenario, &Edits::none()));
        assert!(worn.recording().rows().iter().any(|row| row.force_n > 50.0));
        for (a, b) in worn.recording().rows().iter().zip(same.recording().rows()) {
            // The life goes on in these 0.6 s: 4e-5 of it.
            assert!((a.force_n - b.force_n).abs() <= 1e-3 * b.force_n, "{model:?} {a:?} {b:?}");
        }
    }
}

#[test]
fn force_and_roughness_rise_as_the_life_passes_and_stay_what_they_are_in_the_air() {
    // Ten seconds of the cut are two thirds of a life.
    let mut scenario =
        life(&[("wear.time_scale", Value::Float(960.0))], steady(ForceModel::Formula));
    scenario
        .change(|s| {
            s.run.duration_s = 10.0;
            s.workpiece.depth_steps = vec![[0.0, 2.0], [30.0, 0.0]];
        })
        .unwrap();
    let run = Run::complete(&scenario, &Edits::none());
    let cut: Vec<_> = run.recording().rows().iter().filter(|row| row.force_n > 0.0).collect();
    assert!(cut.windows(2).skip(100).all(|pair| pair[0].force_n <= pair[1].force_n + 1e-9));
    let (first, last) = (cut[200], cut[cut.len() - 1]);
    assert!(last.force_n > 1.1 * first.force_n && last.ra_um > first.ra_um);
    // Constant feed and depth: the growth of the force is that of the wear.
    let settings = &scenario.wear;
    let (feed, x) = (last.feed_mm_min, run.closed_loop().used_life());
    assert!((first.feed_mm_min - feed).abs() < 1e-3 * feed);
    let expected = settings.force_factor(settings.wear(x));
    let fresh = Run::complete(&steady(ForceModel::Formula), &Edits::none());
    let sharp = fresh.recording().rows().last().unwrap().force_n;
    assert!((last.force_n / sharp - expected).abs() < 2e-3, "{x} {} {sharp}", last.force_n);
    let cutting_s = last.time_s;
    assert!(cutting_s < 9.0 && x * 14_400.0 < 960.0 * 9.0 * 1.3, "no wear in the air: {x}");
}

#[test]
fn a_change_of_settings_leaves_the_tool_as_worn_as_it_is() {
    let scenario = life(
        &[("wear.time_scale", Value::Float(5000.0)), ("wear.used_life", Value::Float(0.2))],
        steady(ForceModel::Formula),
    );
    let edited = |path: &str, value: f64| {
        let mut edits = Edits::none();
        let edit = Edit { at_s: 0.3, path: path.to_owned(), value: Value::Float(value) };
        edits.push(&scenario, edit).unwrap();
        Run::complete(&scenario, &edits).closed_loop().used_life()
    };
    let plain = Run::complete(&scenario, &Edits::none());
    let used = plain.closed_loop().used_life();
    assert!(used > 0.3 && (edited("noise.ripple_percent", 0.5) - used).abs() < 1e-9);
    let slower = edited("wear.time_scale", 1.0);
    assert!(slower > 0.25 && slower < 0.5 * (0.2 + used) + 0.01, "{slower}");
}

fn machine(args: &[&str]) -> serde_json::Value {
    let program = env!("CARGO_BIN_EXE_steadycut");
    let output = Command::new(program).arg("machine").args(args).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap()
}

#[test]
fn machine_wear_prints_the_trends_beside_the_papers_claims() {
    // A short life, to be quick: the trends are those of every life.
    let report = machine(&[
        "wear",
        "--json",
        "--set",
        "wear.taylor_life_min=1",
        "--set",
        "machine.variant=B",
    ]);
    assert_eq!(report["rows"].as_array().unwrap().len(), 10);
    let findings = &report["findings"];
    // Reading B moves the ratios by some 1e-4 only.
    assert!((findings["sound_ratio"].as_f64().unwrap() - 1.8442).abs() < 5e-4);
    assert!((findings["vibration_ratio"].as_f64().unwrap() - 1.6017).abs() < 5e-4);
    assert!(findings["sound_roughness_r"].as_f64().unwrap() > 0.998);
    assert_eq!(findings["first_spectrum"].as_array().unwrap().len(), 300);
    assert!(report["measurement"]["trend_r"].as_f64().unwrap() > 0.98);
    assert_eq!(report["surface"].as_array().unwrap().len(), 3);
    assert_eq!(report["claims_of_the_paper"].as_array().unwrap().len(), 3);
}

#[test]
fn machine_life_judges_the_predictions_and_reaches_the_desired_tool_life() {
    let tool = ["--set", "wear.tool_life_factor=0.6", "--set", "life.tool_life_min=200"];
    let report = machine(&[&["life", "--json", "--tools", "2"], &tool[..]].concat());
    assert_eq!(report["groups"].as_array().unwrap().len(), 4);
    let tool_life = &report["tool_life"];
    let reached = |key: &str| tool_life[key].as_f64().unwrap();
    assert!(reached("reached_fixed_min") < 160.0);
    assert!((reached("reached_adjusted_min") / 200.0 - 1.0).abs() < 0.05);
}

#[test]
fn the_preset_shows_a_whole_life_and_that_tracking_pays_for_ra_with_the_tool() {
    let scenario = load("tool-life").unwrap();
    let constant = Run::complete(&scenario, &Edits::none());
    assert!((constant.closed_loop().used_life() - 1.0).abs() < 0.02);
    let used = constant.recording().rows().iter().map(|row| row.used_life);
    assert!(used.is_sorted());
    let at = |run: &Run, at_s: f64| run.recording().rows()[run.recording().index_at(at_s)];
    let growth = at(&constant, 50.5).force_n / at(&constant, 0.0).force_n;
    assert!((1.4..1.7).contains(&growth), "{growth}");
    let mut tracking = scenario.clone();
    tracking
        .change(|s| {
            s.controller.kind = ControllerKind::Tracking;
            s.run.duration_s = 20.0;
        })
        .unwrap();
    let tracking = Run::complete(&tracking, &Edits::none());
    let (held, drifted) = (at(&tracking, 8.0), at(&constant, 8.0));
    assert!((held.force_n / held.force_ref_n - 1.0).abs() < 0.02, "{held:?}");
    assert!(drifted.ra_um > 2.0 * held.ra_um && held.spindle_rpm > 1.5 * drifted.spindle_rpm);
    assert!(tracking.closed_loop().used_life() > 1.0, "worn out within twenty seconds");
    assert!(at(&tracking, 19.0).has(flag::SATURATED));
}
