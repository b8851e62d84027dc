//! Programmed feeds of the single cuts: files and links, limits and overrides, and the plan's schedule.

use steadycut_core::base::settings::Value;
use steadycut_core::models::plan::PlannedSection;
use steadycut_core::run::edits::Edits;
use steadycut_core::run::job::Job;
use steadycut_core::run::one_run::{End, Run};
use steadycut_core::run::presets::load;
use steadycut_core::run::scenario::{Scenario, parse_value};
use steadycut_core::run::{scenario_file, scenario_link};
use steadycut_study::plan::machine::MachineLimits;
use steadycut_study::plan::schedule::ScheduleJob;

/// Three cuts on the formula's plant: fast, and the force of a row needs no teeth.
fn three_cuts(controller: &str) -> Scenario {
    let mut scenario = load("first-cut").unwrap();
    for (path, text) in [
        ("controller.kind", controller),
        ("workpiece.cuts", "[[[10.0, 2.0, 2.0]], [[10.0, 2.5, 2.0]], [[10.0, 1.5, 2.0]]]"),
        ("program.cut_feeds_mm_min", "[300.0, 200]"),
        ("program.feed_mm_min", "400"),
        ("run.duration_s", "60"),
    ] {
        scenario.set(path, parse_value(path, text).unwrap()).unwrap();
    }
    scenario
}

#[test]
fn every_cut_runs_at_its_own_programmed_feed_and_the_last_at_the_common_one() {
    let run = Run::complete(&three_cuts("constant_feed"), &Edits::none());
    assert_eq!(run.end(), Some(&End::PathDone));
    for (x_mm, feed_mm_min) in [(10.0, 300.0), (27.0, 200.0), (45.0, 400.0)] {
        let row = run.recording().rows().iter().find(|row| row.position_mm > x_mm).unwrap();
        assert!((row.feed_mm_min - feed_mm_min).abs() < 1e-6, "{row:?}");
        assert_eq!((row.feed_command_mm_min, row.feed_override_percent), (feed_mm_min, 100.0));
    }
    // 17.6 mm at each of the three feeds.
    let expected_s = 17.6 * 60.0 * (1.0 / 300.0 + 1.0 / 200.0 + 1.0 / 400.0);
    assert!((run.metrics().time_of_cut_s - expected_s).abs() < 0.05, "{expected_s}");
}

#[test]
fn overrides_and_limits_are_relative_to_the_present_cut() {
    for controller in ["division", "tracking", "adjustable_pi"] {
        let mut scenario = three_cuts(controller);
        scenario.change(|s| s.cnc.override_max_percent = 120.0).unwrap();
        let run = Run::complete(&scenario, &Edits::none());
        let mut at_limit = [false; 3];
        for row in run.recording().rows() {
            let cut = (row.position_mm / 17.6) as usize;
            let programmed = [300.0, 200.0, 400.0][cut.min(2)];
            let command = programmed * row.feed_override_percent / 100.0;
            assert!((row.feed_command_mm_min - command).abs() < 1e-9, "{controller} {row:?}");
            assert!(row.feed_override_percent <= 120.0 + 1e-9, "{controller} {row:?}");
            at_limit[cut.min(2)] |= row.feed_override_percent > 119.9;
        }
        assert!(at_limit.contains(&true), "{controller}: some limit acts");
    }
}

#[test]
fn feeds_per_cut_survive_file_and_link_and_wrong_ones_are_named() {
    let scenario = three_cuts("unks");
    let text = scenario_file::write(&scenario, &Edits::none());
    assert!(text.contains("cut_feeds_mm_min = [300.0, 200.0]"), "{text}");
    assert_eq!(scenario_file::parse(&text).unwrap().0, scenario);
    let link = scenario_link::write(&scenario, &Edits::none());
    assert_eq!(scenario_link::parse(&link).unwrap().0, scenario);
    let path = "program.cut_feeds_mm_min";
    for text in [
        "[9.0]",
        "[300.0, 5001.0]",
        "[100, 100, 100, 100, 100, 100, 100, 100, 100, 100, 100, 100, 100, 100, 100, 100, 100]",
    ] {
        let error = scenario.clone().set(path, parse_value(path, text).unwrap()).unwrap_err();
        assert!(error.to_string().contains("from 10 to 5000 mm/min"), "{error}");
    }
    let mut scenario = scenario;
    for text in ["300", "[\"a\"]", "[300", "a"] {
        let set = parse_value(path, text).and_then(|value| scenario.set(path, value));
        assert!(set.unwrap_err().to_string().contains("from 10 to 5000 mm/min"), "{text}");
    }
    scenario.set(path, Value::List(vec![])).unwrap();
    assert_eq!(scenario.programmed(0).feed_mm_min, 400.0);
}

fn schedule(scenario: &Scenario, sized_by: PlannedSection) -> ScheduleJob {
    let mut job = ScheduleJob::on(scenario, &MachineLimits::heller_bea_01(), sized_by).unwrap();
    job.to_end();
    assert_eq!(job.refusal(), None);
    job
}

#[test]
fn the_shipped_schedule_is_what_the_plan_finds() {
    let job = schedule(&load("experiment-2").unwrap(), PlannedSection::Lightest);
    let shipped = load("experiment-2-per-cut").unwrap();
    assert_eq!(job.feeds_mm_min(), shipped.program.cut_feeds_mm_min);
    assert!(job.planned().iter().all(|cut| cut.optimum.feasible));
    // An independent swarm over the mechanistic model found these feeds per tooth.
    for (cut, feed_mm) in job.planned().iter().zip([0.1191, 0.1086, 0.1726, 0.1199, 0.1191]) {
        let found = cut.optimum.feed_per_tooth_mm;
        assert!((found / feed_mm - 1.0).abs() < 0.05, "{found} against {feed_mm}");
    }
    let applied = job.apply(&load("experiment-2").unwrap()).unwrap();
    assert_eq!(applied.program, shipped.program);
}

#[test]
fn the_heaviest_section_gives_the_slower_schedule() {
    let scenario = load("experiment-2").unwrap();
    let heavy = schedule(&scenario, PlannedSection::Heaviest);
    let light = schedule(&scenario, PlannedSection::Lightest);
    for (heavy, light) in heavy.planned().iter().zip(light.planned()) {
        assert!(heavy.optimum.feed_mm_min < light.optimum.feed_mm_min);
    }
    assert_eq!(heavy.planned()[1].section, 1, "4.75 mm deep");
}

#[test]
fn a_schedule_needs_cuts_that_cut_and_a_spindle_within_the_plan() {
    let refusal = |path: &str, text: &str| {
        let mut scenario = load("experiment-2").unwrap();
        scenario.set(path, parse_value(path, text).unwrap()).unwrap();
        let job =
            ScheduleJob::on(&scenario, &MachineLimits::heller_bea_01(), PlannedSection::Lightest);
        let ended = job.map(|mut job| {
            job.to_end();
            job.refusal().map(str::to_owned)
        });
        ended.map_or_else(|error| error.to_string(), |refusal| refusal.expect("it is refused"))
    };
    assert!(refusal("workpiece.cuts", "[]").contains("at least one cut"));
    assert!(refusal("program.spindle_rpm", "200").contains("796 to 2984 1/min"));
    assert!(refusal("workpiece.cuts", "[[[10.0, 0.0, 0.0]]]").contains("axial_depth_mm"));
}
