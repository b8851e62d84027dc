//! The chip comes from the surface that the last teeth have left: for any run-out, number of teeth and feed,
//! after a stop of the feed, at any speed.

use proptest::prelude::*;
use steadycut_core::base::math;
use steadycut_core::base::settings::Value;
use steadycut_core::blocks::cutting::milling::{Milling, MillingSetup};
use steadycut_core::models::mechanistic::{
    CK45, Cutter, Kienzle, MAX_TEETH, Sliced, StaticCut, Steel, static_peak, steady,
};
use steadycut_core::models::part::CutPath;
use steadycut_core::models::tool::{EndShape, Tool};
use steadycut_core::run::edits::{Edit, Edits};
use steadycut_core::run::one_run::Run;
use steadycut_core::run::presets::load;
use steadycut_core::run::revolution::revolution;
use steadycut_core::run::scenario::Scenario;
use steadycut_core::run::signals::flag;

const K_N_MM2: f64 = 2000.0;
/// Tangential force alone, k h b: the size of the force is the section of the chips, whatever their direction.
const LINEAR: Kienzle = Kienzle { k_n_mm2: [K_N_MM2, 0.0, 0.0], exponents: [1.0; 3] };

/// A square end 1 mm deep in one slice without helix, its teeth standing out as given.
fn slice(teeth: usize, runout_mm: [f64; MAX_TEETH]) -> Cutter {
    let tool = Tool {
        shape: EndShape::Square,
        teeth: teeth as u32,
        helix_deg: 0.0,
        compliance_um_n: 0.0,
        ..Tool::default()
    };
    Cutter { runout_mm, ..Cutter::new(&tool, 0.0, 1.0) }
}

/// Chip thickness of every tooth at the angle phi of the feed, mm.
fn chips_mm(cutter: &Cutter, feed_per_tooth_mm: f64, phi: f64) -> Vec<f64> {
    let sliced = Sliced::new(cutter, 1.0);
    let radius = cutter.radius_mm(1.0);
    let (x_mm, y_mm) = (radius * math::sin(phi), radius * math::cos(phi));
    let here = |x: f64, y: f64| if (x - x_mm).abs() + (y - y_mm).abs() < 1e-6 { 1.0 } else { 0.0 };
    let chip_mm = |tooth: usize| {
        let angle = phi + math::TAU * tooth as f64 / cutter.teeth as f64;
        let [x, y, _] = sliced.forces(&LINEAR, angle, &steady(feed_per_tooth_mm), here).forces_n;
        (x * x + y * y).sqrt() / K_N_MM2
    };
    (0..cutter.teeth).map(chip_mm).collect()
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 300,
        rng_seed: proptest::test_runner::RngSeed::Fixed(2005),
        failure_persistence: None,
        ..ProptestConfig::default()
    })]

    /// At every angle the teeth of a turn take away what the tool was fed in it, however they stand out.
    #[test]
    fn the_chips_of_a_turn_add_up_to_its_feed(
        teeth in 1..=MAX_TEETH,
        runout_mm in prop::array::uniform8(-0.1_f64..0.1),
        feed_per_tooth_mm in 0.0_f64..0.4,
        phi in 0.01_f64..3.1,
    ) {
        let chips = chips_mm(&slice(teeth, runout_mm), feed_per_tooth_mm, phi);
        let turn = teeth as f64 * feed_per_tooth_mm * math::sin(phi);
        prop_assert!((chips.iter().sum::<f64>() - turn).abs() < 1e-9, "{chips:?} {turn}");
        prop_assert!(chips.iter().all(|chip| (0.0..=turn + 1e-9).contains(chip)), "{chips:?}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 40,
        rng_seed: proptest::test_runner::RngSeed::Fixed(2005),
        failure_persistence: None,
        ..ProptestConfig::default()
    })]

    /// Whatever feed and speed were before: a turn later the teeth take away in a turn what it feeds.
    #[test]
    fn the_volume_of_a_turn_is_its_feed_whatever_came_before(
        teeth in 1..=4_usize,
        runout_um in 0.0_f64..50.0,
        stretches in prop::collection::vec((
            prop::sample::select(vec![0.0, 60.0, 250.0, 900.0]),
            // Whole samples to a turn.
            prop::sample::select(vec![400.0, 1500.0, 4000.0]),
        ), 1..6),
    ) {
        let mut runout_mm = [0.0; MAX_TEETH];
        for (j, out) in runout_mm[..teeth].iter_mut().enumerate() {
            *out = 1e-3 * runout_um * math::cos(math::TAU * j as f64 / teeth as f64);
        }
        let none = [0.0, 0.0];
        let steel = Steel { tangential: [1.0, 0.0], radial: none, axial: none, hardness_hb: 1.0 };
        let (cutter, dt_s) = (slice(teeth, runout_mm), 2.5e-5);
        let setup =
            MillingSetup { cutter, steel, rake_deg: 6.0, hardness_hb: 1.0, factor: 1.0, dt_s };
        // A quarter of a turn in the cut, so no two of four teeth at once: radial depth 8 mm, axial 1 mm.
        let (cut, mut milling) = (CutPath::open(&[[1e6, 1.0, 0.0]]), Milling::new(&setup, 1.0));
        let mut x_mm = 0.0;
        for (feed_mm_min, rpm) in &stretches {
            let law = Kienzle::new(&steel, math::PI * 16.0 * rpm / 1000.0, 6.0, 1.0).k_n_mm2[0];
            let samples = (60.0 / rpm / dt_s).round() as usize;
            let arc_mm = 8.0 * math::TAU / samples as f64;
            for turn in 0..4 {
                let mut volume_mm3 = 0.0;
                for _ in 0..samples {
                    x_mm += feed_mm_min / 60.0 * dt_s;
                    let [x, y, _] = milling.update(*feed_mm_min, *rpm, x_mm, &cut, 1.0).forces_n;
                    volume_mm3 += (x * x + y * y).sqrt() / law * arc_mm;
                }
                let fed_mm3 = 8.0 * feed_mm_min / rpm;
                let off = (volume_mm3 - fed_mm3).abs();
                prop_assert!(turn < 2 || off <= 6e-3 * fed_mm3 + 1e-9, "{volume_mm3} {fed_mm3}");
            }
        }
    }
}

#[test]
fn a_tooth_alone_cuts_as_a_cutter_with_one_tooth_and_the_feed_of_the_turn() {
    let law = Kienzle::new(&CK45, 80.0, 12.0, 200.0);
    let tool = |teeth| Tool { teeth, ..Tool::default() };
    let cut = |feed_per_tooth_mm| StaticCut {
        feed_per_tooth_mm,
        axial_depth_mm: 2.0,
        radial_depth_mm: 3.0,
    };
    for runout_mm in [0.02, 0.05] {
        let two = static_peak(&Cutter::new(&tool(2), runout_mm, 0.25), &law, &cut(0.02));
        let one = static_peak(&Cutter::new(&tool(1), runout_mm, 0.25), &law, &cut(0.04));
        assert!((two.fxy_n / one.fxy_n - 1.0).abs() < 1e-6, "{two:?} {one:?}");
        assert!((two.mean_fxy_n / one.mean_fxy_n - 1.0).abs() < 1e-6, "{two:?} {one:?}");
    }
    // Four teeth, the axis shifted so far that the first one cuts alone.
    let chips = chips_mm(&slice(4, [0.1, 0.0, -0.1, 0.0, 0.0, 0.0, 0.0, 0.0]), 0.02, 1.2);
    assert!(
        (chips[0] - 0.08 * math::sin(1.2)).abs() < 1e-12 && chips[1..] == [0.0; 3],
        "{chips:?}"
    );
}

/// Experiment 1 at constant feed without noise, by `edits`.
fn experiment(edits: &[(&str, f64)]) -> Scenario {
    let mut scenario = load("experiment-1").unwrap();
    scenario.set("controller.kind", Value::Text("constant_feed".to_owned())).unwrap();
    scenario
        .change(|s| {
            s.noise.level = 0.0;
            s.cnc.force_stop = false;
        })
        .unwrap();
    for (path, value) in edits {
        scenario.set(path, Value::Float(*value)).unwrap();
    }
    scenario
}

/// Largest force across the tool in the turn before `at_s`, N.
fn peak_n(run: &Run, at_s: f64) -> f64 {
    let samples = revolution(run, at_s, 1).unwrap().samples;
    samples.iter().map(|sample| sample.fxy_n()).fold(0.0, f64::max)
}

#[test]
fn a_chip_is_no_thicker_than_what_a_turn_feeds() {
    let peak = |runout_um: f64| {
        let scenario = experiment(&[
            ("program.feed_mm_min", 63.66),
            ("tool.runout_um", runout_um),
            ("run.duration_s", 20.0),
        ]);
        peak_n(&Run::complete(&scenario, &Edits::none()), 20.0)
    };
    // Feed per tooth 20 um: from a run-out of 10 um on the second tooth is left out, at 51 degrees from 7.8.
    // 246 N at 10 um by the difference to the tooth before alone, which does not see the second one back.
    for (runout_um, expected) in [(0.0, 136.0), (5.0, 194.0), (10.0, 239.1)] {
        let found = peak(runout_um);
        assert!((found / expected - 1.0).abs() < 0.01, "{runout_um} um: {found} N");
    }
    let alone = peak(10.0);
    for runout_um in [12.0, 20.0, 50.0] {
        let found = peak(runout_um);
        assert!((found / alone - 1.0).abs() < 0.02, "{runout_um} um: {found} N after {alone} N");
    }
}

#[test]
fn a_slow_spindle_cuts_the_same_chip_with_the_force_of_its_speed() {
    // Feed per tooth 0.08 mm at every speed; k ~ v_c^-0.153.
    let peak = |rpm: f64| {
        let scenario = experiment(&[
            ("program.feed_mm_min", 0.16 * rpm),
            ("program.spindle_rpm", rpm),
            ("run.duration_s", 15.0 * 400.0 / rpm),
        ]);
        let run = Run::complete(&scenario, &Edits::none());
        let rows = run.recording().rows();
        assert!(rows.iter().all(|row| !row.has(flag::K4_OUTSIDE)), "{rpm} 1/min");
        peak_n(&run, scenario.run.duration_s)
    };
    let at_400 = peak(400.0);
    for (rpm, expected) in [(200.0, 1.112), (100.0, 1.236)] {
        let ratio = peak(rpm) / at_400;
        assert!((ratio / expected - 1.0).abs() < 0.01, "{rpm}: {ratio}");
    }
}

#[test]
fn a_spindle_slower_than_any_that_is_programmed_is_marked() {
    let mut scenario = experiment(&[
        ("program.feed_mm_min", 50.0),
        ("program.spindle_rpm", 100.0),
        ("run.duration_s", 12.0),
    ]);
    scenario.set("cnc.override_min_percent", Value::Float(0.0)).unwrap();
    scenario.set("controller.constant_feed.speed_percent", Value::Float(50.0)).unwrap();
    let run = Run::complete(&scenario, &Edits::none());
    let last = run.recording().rows().last().unwrap();
    assert!(last.spindle_rpm < 60.0 && last.has(flag::K4_OUTSIDE), "{last:?}");
}

#[test]
fn a_stopped_feed_leaves_no_chip_within_a_turn_and_a_new_one_begins_thin() {
    let mut scenario = experiment(&[("tool.runout_um", 20.0), ("run.duration_s", 12.0)]);
    scenario.set("cnc.override_min_percent", Value::Float(0.0)).unwrap();
    scenario.change(|s| s.run.record_every = s.run.steps_per_control).unwrap();
    let mut edits = Edits::none();
    for (at_s, percent) in [(6.0, 0.0), (9.0, 100.0)] {
        let path = "controller.constant_feed.feed_percent".to_owned();
        edits.push(&scenario, Edit { at_s, path, value: Value::Float(percent) }).unwrap();
    }
    let run = Run::complete(&scenario, &edits);
    let rows = run.recording().rows();
    let between = |from_s: f64, to_s: f64| {
        rows.iter().filter(move |row| row.time_s > from_s && row.time_s < to_s)
    };
    let largest_n = |from_s, to_s| between(from_s, to_s).map(|row| row.force_n).fold(0.0, f64::max);
    let before_n = largest_n(5.0, 6.0);
    assert!(before_n > 300.0 && between(7.0, 9.0).count() > 90, "{before_n}");
    // It brakes by time constants; then nothing is left to cut.
    assert_eq!(largest_n(7.0, 9.0), 0.0);
    // It starts again from nothing, and is no larger than before on the way.
    let first = between(9.0, 12.0).find(|row| row.feed_mm_min > 1.0).unwrap();
    assert!(first.force_n < 0.5 * before_n, "{first:?} after {before_n} N");
    let again = largest_n(9.0, 12.0);
    assert!((again / before_n - 1.0).abs() < 0.02, "{again} N after {before_n} N");
}
