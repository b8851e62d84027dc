//! Where nothing turns, feeds or cuts, and at the ends of every range: without a chip there is no force and no
//! roughness, what only grows never falls, and what lies outside a model is marked.

use steadycut_core::blocks::control::ControllerKind;
use steadycut_core::blocks::cutting::process::ForceModel;
use steadycut_core::models::feed_drive::FeedDriveKind;
use steadycut_core::models::feed_speed::STANDSTILL_MM_MIN;
use steadycut_core::models::genetic::force_formula::{FEED_MIN_MM_MIN, SPEED_MIN_RPM};
use steadycut_core::models::genetic::{Calibration, GeneticModels, ModelSet};
use steadycut_core::models::wear::{WearCut, WearModel, WearSettings};
use steadycut_core::run::edits::Edits;
use steadycut_core::run::one_run::{End, Run};
use steadycut_core::run::presets::load;
use steadycut_core::run::scenario::{Scenario, Settings};
use steadycut_core::run::signals::{Row, flag, signal};

/// Every plant: each force model along one path and along several cuts, coupled to the machine or not.
fn plants() -> Vec<(String, Scenario)> {
    let mut plants = Vec::new();
    for model in ForceModel::ALL {
        for (several, coupled) in [(false, false), (true, false), (false, true)] {
            let mut scenario = load("table3-5").unwrap();
            scenario
                .change(|s| {
                    s.plant.force_model = *model;
                    s.controller.kind = ControllerKind::ConstantFeed;
                    s.machine.coupled = coupled;
                    s.wear.model = WearModel::Life;
                    s.wear.time_scale = 100.0;
                    s.wear.used_life = 0.5;
                    s.run.duration_s = 3.0;
                    s.run.record_every = 20;
                    if model.tooth_by_tooth() {
                        s.run.steps_per_control = 200;
                        s.run.record_every = 200;
                    }
                    if several {
                        s.workpiece.cuts = vec![vec![[4.0, 2.0, 2.0]], vec![[30.0, 2.5, 2.0]]];
                    }
                })
                .unwrap();
            plants.push((format!("{model:?}, several {several}, coupled {coupled}"), scenario));
        }
    }
    plants
}

/// A finished run of a scenario that holds what every run must hold.
fn run(case: &str, scenario: &Scenario) -> Run {
    let run = Run::complete(scenario, &Edits::none());
    let rows = run.recording().rows();
    let grows: [fn(&Row) -> f64; 3] = [|r| r.time_s, |r| r.position_mm, |r| r.used_life];
    for pair in rows.windows(2) {
        for (i, get) in grows.iter().enumerate() {
            let [before, after] = [&pair[0], &pair[1]].map(get);
            assert!(after >= before, "{case}: {i} falls from {before} to {after}");
        }
        let row = &pair[1];
        assert!(row.force_n >= 0.0 && row.force_dyn_n >= 0.0, "{case}: {row:?}");
        assert!(row.axial_depth_mm * row.radial_depth_mm >= 0.0, "{case}: {row:?}");
        let ra = (signal("ra_um").unwrap().value)(row);
        if row.has(flag::AIR) {
            assert_eq!(ra, None, "{case}: {row:?}");
        } else {
            assert!(ra.is_none_or(|ra| ra > 0.0), "{case}: {row:?}");
        }
        if scenario.plant.force_model.is_map() && row.feed_mm_min < STANDSTILL_MM_MIN {
            assert_eq!((row.force_n, row.force_dyn_n), (0.0, 0.0), "{case}: {row:?}");
            assert!(row.has(flag::AIR), "{case}: {row:?}");
        }
        // K4 was fitted above half of the least speed of its table, and turns round at 69.7 mm/min.
        let known = row.feed_mm_min >= FEED_MIN_MM_MIN && row.spindle_rpm >= SPEED_MIN_RPM;
        if scenario.plant.force_model.is_formula() && !row.has(flag::AIR) && !known {
            assert!(row.has(flag::K4_OUTSIDE), "{case}: {row:?}");
        }
    }
    assert!(!matches!(run.end(), Some(End::Fault(_) | End::Refused(_))), "{case}: {:?}", run.end());
    let metrics = run.metrics();
    assert!(metrics.metal_removed_cm3 >= 0.0 && metrics.max_force_n >= 0.0, "{case}: {metrics:?}");
    run
}

fn with(scenario: &Scenario, change: impl FnOnce(&mut Settings)) -> Scenario {
    scenario.with(change).unwrap()
}

#[test]
fn without_feed_there_is_no_chip_no_force_and_no_roughness() {
    for (case, scenario) in plants() {
        let still = with(&scenario, |s| s.controller.constant_feed.feed_percent = 0.0);
        let run = run(&case, &still);
        let last = run.recording().rows().last().unwrap();
        assert!(last.has(flag::AIR) && last.force_n == 0.0, "{case}: {last:?}");
        let metrics = run.metrics();
        assert_eq!((metrics.ra_final_um, metrics.force_final_n), (None, None), "{case}");
        assert_eq!(run.end(), Some(&End::TimeLimit), "{case}");
        let worn = run.recording().rows().iter().rev().take(50).map(|row| row.used_life);
        assert!(worn.clone().all(|x| x == last.used_life), "{case}: a standing tool does not wear");
    }
}

#[test]
fn feeding_a_standing_spindle_into_the_work_is_a_crash() {
    for (case, scenario) in plants() {
        let still = with(&scenario, |s| {
            s.controller.constant_feed.speed_percent = 0.0;
            // One that stands any load: others break before.
            (s.tool.chip_max_mm, s.tool.force_max_n) = (0.0, 0.0);
        });
        let run = run(&case, &still);
        let Some(End::Crash(crash)) = run.end() else { panic!("{case}: {:?}", run.end()) };
        assert!(crash.feed_mm_min > STANDSTILL_MM_MIN && crash.speed_rpm < 30.0, "{case}: {crash}");
        assert!(crash.time_s < 3.0 && crash.position_mm > 0.0, "{case}: {crash}");
        assert!(crash.to_string().contains("crashed at"), "{crash}");
        // The row of the crash itself is not recorded, and that before it always is.
        let last = run.recording().rows().last().unwrap();
        let step_s = still.dt_s();
        assert!((crash.time_s - last.time_s - step_s).abs() < 1e-9, "{case}: {}", last.time_s);
    }
}

#[test]
fn in_the_air_nothing_crashes_and_nothing_is_claimed() {
    for (case, scenario) in plants() {
        for depths in [[0.0, 3.0], [2.0, 0.0]] {
            let air = with(&scenario, |s| {
                s.controller.constant_feed.speed_percent = 0.0;
                [s.workpiece.axial_depth_mm, s.workpiece.radial_depth_mm] = depths;
                s.workpiece.cuts.iter_mut().flatten().for_each(|[_, axial_mm, _]| *axial_mm = 0.0);
            });
            let run = run(&case, &air);
            assert_eq!(run.end(), Some(&End::TimeLimit), "{case}");
            let metrics = run.metrics();
            assert_eq!((metrics.ra_final_um, metrics.ra_deviation_percent), (None, None), "{case}");
            assert_eq!(
                (metrics.force_final_n, metrics.force_worst_percent),
                (None, None),
                "{case}"
            );
            assert_eq!(
                (metrics.overshoot_percent, metrics.settling_time_s),
                (None, None),
                "{case}"
            );
            assert_eq!((metrics.max_force_n, metrics.metal_removed_cm3), (0.0, 0.0), "{case}");
            assert_eq!(run.recording().rows().last().unwrap().used_life, 0.5, "{case}");
        }
    }
}

#[test]
fn wear_never_falls_as_the_spindle_comes_to_rest() {
    let mut scenario = load("tool-life").unwrap();
    scenario
        .change(|s| {
            s.wear.used_life = 0.5;
            s.controller.constant_feed.speed_percent = 0.0;
            // One that stands any load: others break before.
            (s.tool.chip_max_mm, s.tool.force_max_n) = (0.0, 0.0);
            s.workpiece.length_mm = 2000.0;
            s.run.duration_s = 200.0;
        })
        .unwrap();
    let crashed = run("tool-life", &scenario);
    assert!(matches!(crashed.end(), Some(End::Crash(_))), "{:?}", crashed.end());
    // The law itself, down to speeds at which its powers overflow.
    let extremes = [0.0, 1e-300, 1e-80, 1e-9, 1.0, 1e9, 1e80, 1e300];
    for taylor_exponent in [0.1, 0.25, 0.6] {
        for feed_exponent in [0.0, 0.8, 2.0] {
            let wear = WearSettings { taylor_exponent, feed_exponent, ..WearSettings::default() };
            for cutting_speed_m_min in extremes {
                for feed_per_tooth_mm in extremes {
                    let cut =
                        WearCut { cutting_speed_m_min, feed_per_tooth_mm, axial_depth_mm: 2.0 };
                    let life_min = wear.life_min(&cut);
                    assert!(life_min >= 0.0, "{cut:?}: {life_min}");
                    let nothing = cutting_speed_m_min == 0.0 || feed_per_tooth_mm == 0.0;
                    assert!(!nothing || life_min == f64::INFINITY, "{cut:?}: {life_min}");
                }
            }
        }
    }
}

/// Settings at the ends of their ranges, some beyond what any model knows.
type Edge = fn(&mut Settings);

const EDGES: &[(&str, Edge)] = &[
    ("slow feed", |s| s.controller.constant_feed.feed_percent = 0.5),
    ("fast feed", |s| s.controller.constant_feed.feed_percent = 250.0),
    ("slow spindle", |s| s.controller.constant_feed.speed_percent = 5.0),
    ("fast spindle", |s| s.controller.constant_feed.speed_percent = 250.0),
    ("least program", |s| (s.program.feed_mm_min, s.program.spindle_rpm) = (10.0, 100.0)),
    ("fast program", |s| (s.program.feed_mm_min, s.program.spindle_rpm) = (5000.0, 20_000.0)),
    ("thin", |s| (s.workpiece.axial_depth_mm, s.workpiece.radial_depth_mm) = (1e-3, 1e-3)),
    ("slot", |s| (s.workpiece.axial_depth_mm, s.workpiece.radial_depth_mm) = (8.0, 16.0)),
    ("soft", |s| (s.plant.hardness_hb, s.plant.force_offset_n) = (60.0, -100.0)),
    ("hard", |s| (s.plant.hardness_hb, s.plant.wear_factor) = (500.0, 2.0)),
    ("loud", |s| (s.noise.level, s.noise.band_percent) = (5.0, 20.0)),
    ("worn", |s| (s.wear.used_life, s.wear.time_scale) = (1.0, 1e5)),
    ("coarse", |s| s.target.ra_um = 4.0),
    ("fine", |s| s.target.ra_um = 0.05),
];

#[test]
fn every_plant_holds_at_the_ends_of_every_range() {
    for (plant, scenario) in plants() {
        for (edge, change) in EDGES {
            let at_edge = with(&scenario, |s| {
                s.run.duration_s = if s.plant.force_model.is_map() { 3.0 } else { 1.0 };
                change(s);
            });
            run(&format!("{plant}, {edge}"), &at_edge);
        }
    }
}

#[test]
fn every_controller_and_drive_holds_where_nothing_feeds_turns_or_cuts() {
    let edges: [(&str, Edge); 4] = [
        ("no override", |s| {
            (s.cnc.override_min_percent, s.cnc.override_max_percent) = (0.0, 100.0)
        }),
        ("air from 2 mm on", |s| s.workpiece.depth_steps = vec![[2.0, 0.0]]),
        ("no depth", |s| s.workpiece.axial_depth_mm = 0.0),
        ("hardest", |s| (s.plant.hardness_hb, s.target.ra_um) = (500.0, 0.05)),
    ];
    for (plant, scenario) in plants().into_iter().filter(|(_, s)| s.workpiece.cuts.is_empty()) {
        for kind in ControllerKind::ALL {
            for (edge, change) in edges {
                for drive in FeedDriveKind::ALL {
                    let by_teeth = scenario.plant.force_model.tooth_by_tooth();
                    if (by_teeth || scenario.machine.coupled) && *drive != FeedDriveKind::Eq1Of2007
                    {
                        continue;
                    }
                    let case = with(&scenario, |s| {
                        s.controller.kind = *kind;
                        s.feed_drive.kind = *drive;
                        s.run.duration_s = if by_teeth { 0.6 } else { 2.0 };
                        change(s);
                    });
                    run(&format!("{plant}, {kind:?}, {drive:?}, {edge}"), &case);
                }
            }
        }
    }
}

#[test]
fn every_formula_answers_at_nothing_and_beyond_its_range() {
    let extremes = [0.0, 1e-300, 1e-9, 0.5, 69.7, 412.5, 1e3, 1e5, 1e9, 1e100];
    for set in ModelSet::ALL {
        for calibration in Calibration::ALL {
            let models = GeneticModels::new(*set, *calibration);
            for x in extremes {
                let case = format!("{set:?} {calibration:?} at {x}");
                let ra = models.ra_from_force(x);
                assert!(ra.value >= 0.0 && ra.value.is_finite(), "{case}: {ra:?}");
                assert!(models.force_from_ra(x).value > 0.0, "{case}");
                for y in extremes {
                    let force = models.force(x, y);
                    assert!(
                        force.value >= 0.0 && force.value.is_finite(),
                        "{case}, {y}: {force:?}"
                    );
                    assert!(!force.valid || (x >= 69.7 && y >= 412.5), "{case}, {y}: {force:?}");
                }
            }
        }
    }
}
