//! The force within a revolution: the samples are those of the run, at the rate of its steps.

use steadycut_core::base::settings::Value;
use steadycut_core::run::edits::{Edit, Edits};
use steadycut_core::run::job::Job;
use steadycut_core::run::one_run::Run;
use steadycut_core::run::presets::load;
use steadycut_core::run::revolution::{RevolutionJob, revolution};
use steadycut_core::run::scenario::Scenario;

/// Some seconds of a cut at constant feed, with the noise of the preset.
fn short_cut() -> Scenario {
    let mut scenario = load("experiment-2").unwrap();
    scenario.set("controller.kind", Value::Text("constant_feed".to_owned())).unwrap();
    scenario
        .change(|s| {
            s.workpiece.cuts = vec![vec![[6.0, 2.0, 2.0]], vec![[30.0, 3.0, 2.0]]];
            s.run.duration_s = 6.5;
        })
        .unwrap();
    scenario
}

fn edited(scenario: &Scenario) -> Edits {
    let mut edits = Edits::none();
    let value = Value::Float(1.5);
    edits.push(scenario, Edit { at_s: 5.99, path: "plant.wear_factor".to_owned(), value }).unwrap();
    edits
}

#[test]
fn the_largest_sample_of_a_control_period_is_the_force_of_its_row() {
    let scenario = short_cut();
    let run = Run::complete(&scenario, &edited(&scenario));
    let recording = run.recording();
    let mut largest = 0.0_f64;
    // In the air, in the first cut, over the change of cuts, at the edit, at the end.
    for at_s in [0.02, 0.5, 1.9, 2.345, 3.21, 3.23, 5.999, 6.2, 6.5] {
        for turns in [1, 2] {
            let found = revolution(&run, at_s, turns).unwrap();
            let row = &recording.rows()[recording.index_at(at_s)];
            let peak_n = found.samples[found.peak.unwrap()].fxy_n();
            assert_eq!(peak_n, row.force_n, "at {at_s} s");
            largest = largest.max(peak_n);
            // So it is with every whole control period among the samples.
            let control = scenario.run.steps_per_control as usize;
            let skipped = found.window_from.unwrap() % control;
            for window in found.samples[skipped..].chunks_exact(control) {
                let end_s = window[control - 1].time_s;
                let held = &recording.rows()[recording.index_at(end_s + scenario.dt_s())];
                let peak_n = window.iter().map(|sample| sample.fxy_n()).fold(0.0, f64::max);
                assert_eq!(peak_n, held.force_n, "at {end_s} s");
            }
        }
    }
    assert!(largest > 500.0, "{largest} N");
}

#[test]
fn a_revolution_has_two_teeth_18_85_ms_apart() {
    let mut scenario = short_cut();
    scenario
        .change(|s| {
            s.noise.level = 0.0;
            s.tool.runout_um = 0.0;
            s.run.duration_s = 4.0;
            s.workpiece.cuts = vec![vec![[60.0, 3.0, 2.0]]];
        })
        .unwrap();
    let run = Run::complete(&scenario, &Edits::none());
    let found = revolution(&run, 4.0, 2).unwrap();
    let span_s = found.samples.last().unwrap().time_s - found.samples[0].time_s;
    assert!((span_s - 2.0 * 60.0 / 1591.5494).abs() < 1e-4, "{span_s} s");
    // One tooth at a time, with air between: the middles of the cuts are a tooth period apart.
    let in_cut: Vec<bool> = found.samples.iter().map(|sample| sample.fxy_n() > 1.0).collect();
    let enters = |i: &usize| in_cut[*i] && !in_cut[*i - 1];
    let entries: Vec<f64> =
        (1..in_cut.len()).filter(enters).map(|i| found.samples[i].time_s).collect();
    assert!(entries.len() >= 3, "{entries:?}");
    for pair in entries.windows(2) {
        let period_ms = 1000.0 * (pair[1] - pair[0]);
        assert!((period_ms - 18.85).abs() < 0.05, "{period_ms} ms");
    }
    // The angle goes round with the time.
    for pair in found.samples.windows(2) {
        let step = (pair[1].angle_deg - pair[0].angle_deg).rem_euclid(360.0);
        assert!((step - 360.0 * 1591.5494 / 60.0 * scenario.dt_s()).abs() < 1e-6, "{step} deg");
    }
}

#[test]
fn what_is_not_tooth_by_tooth_has_no_revolution_and_no_time_is_too_odd() {
    let run = Run::complete(&load("table3-5").unwrap(), &Edits::none());
    assert_eq!(revolution(&run, 5.0, 1), None);
    let mut scenario = short_cut();
    scenario.change(|s| s.run.duration_s = 0.1).unwrap();
    let run = Run::complete(&scenario, &Edits::none());
    for at_s in [f64::NAN, f64::NEG_INFINITY, -1.0, 0.0, 1e-3] {
        let found = revolution(&run, at_s, 0).unwrap();
        assert!(found.peak.is_none() && !found.samples.is_empty(), "{at_s}: {found:?}");
    }
    let found = revolution(&run, f64::INFINITY, u32::MAX).unwrap();
    assert_eq!(found.samples.first().unwrap().time_s, 0.0);
}

#[test]
fn slices_and_going_on_from_the_last_picture_change_nothing() {
    let scenario = short_cut();
    let run = Run::complete(&scenario, &edited(&scenario));
    let mut before = None;
    for at_s in [3.0, 3.01, 3.3, 2.0, 6.1] {
        let mut job = RevolutionJob::new(&run, at_s, 2, before.take());
        while !job.advance_by(777) {}
        assert!(job.advance_by(777), "done stays done");
        let (found, repeat) = job.finish();
        assert_eq!(found, revolution(&run, at_s, 2), "at {at_s} s");
        before = Some(repeat);
    }
}
