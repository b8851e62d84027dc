//! The closed loop as a whole: Table 3, Tracking's promises, edits, slicing, branching.

use steadycut_core::base::math;
use steadycut_core::base::settings::Value;
use steadycut_core::blocks::control::ControllerKind;
use steadycut_core::blocks::cutting::material::Material;
use steadycut_core::blocks::cutting::process::ForceModel;
use steadycut_core::models::feed_drive::FeedDriveKind;
use steadycut_core::models::genetic::{Calibration, GeneticModels, ModelSet};
use steadycut_core::run::edits::{Edit, Edits};
use steadycut_core::run::one_run::{End, Run};
use steadycut_core::run::presets::{PRESETS, load};
use steadycut_core::run::scenario::{Scenario, Settings};
use steadycut_core::run::signals::{Row, flag};
use steadycut_study::papers::{self, PaperTable};
use steadycut_study::plan::PlanJob;
use steadycut_study::published::PaperId;

fn table(paper: PaperId, calibration: Calibration) -> PaperTable {
    papers::table(paper, calibration, ForceModel::Formula)
}

fn tracking(sim: u32) -> Scenario {
    let mut scenario = load(&format!("table3-{sim}")).unwrap();
    scenario.change(|s| s.controller.kind = ControllerKind::Tracking).unwrap();
    scenario
}

fn edit(at_s: f64, path: &str, value: f64) -> Edit {
    Edit { at_s, path: path.to_owned(), value: Value::Float(value) }
}

fn error(row: &Row) -> f64 {
    (row.force_n - row.force_ref_n) / row.force_ref_n
}

#[test]
fn table_3_is_met_in_all_cells_by_runs_in_time() {
    let paper = table(PaperId::Sdnrp2007, Calibration::Identified);
    assert_eq!(paper.rows.len(), 10);
    for row in &paper.rows {
        assert!(row.force_final_n.residual_percent.abs() <= 0.5, "{row:?}");
        assert!(row.feed_final_mm_min.residual_percent.abs() <= 3.0, "{row:?}");
        assert!(row.spindle_final_rpm.residual_percent.abs() <= 1.5, "{row:?}");
        assert!(row.ra_produced_um.residual.abs() <= 0.03, "{row:?}");
    }
    assert!(paper.all_met());
    let last = &paper.rows[9];
    assert_eq!((last.force_final_n.printed, last.force_final_n.reference), (195.2, 190.2));
}

#[test]
fn the_check_of_table_3_fails_when_k4_is_moved_by_2_n() {
    for offset_n in [-2.0, 2.0] {
        let moved = PaperId::Sdnrp2007.rows().iter().any(|printed| {
            let moved = |settings: &mut Settings| settings.plant.force_offset_n = offset_n;
            let (paper, calibration) = (PaperId::Sdnrp2007, Calibration::Identified);
            let row = papers::row(paper, printed, calibration, ForceModel::Formula, moved);
            row.force_final_n.residual_percent.abs() > 0.5
        });
        assert!(moved, "{offset_n} N must show");
    }
}

#[test]
fn table_1_of_2013_is_met_in_all_cells_by_runs_in_time() {
    let paper = table(PaperId::Strategy2013, Calibration::Identified);
    assert_eq!(paper.rows.len(), 8);
    for row in &paper.rows {
        assert!(row.force_final_n.residual_percent.abs() <= 2.0, "{row:?}");
        assert!(row.feed_final_mm_min.residual_percent.abs() <= 3.5, "{row:?}");
        assert!(row.spindle_final_rpm.residual_percent.abs() <= 3.5, "{row:?}");
        assert!(row.ra_produced_um.residual.abs() <= 0.08, "{row:?}");
        assert!(row.out_of_range.is_empty(), "{row:?}");
    }
    assert!(paper.all_met());
}

#[test]
fn the_check_of_table_1_fails_when_m4_is_moved_by_10_n() {
    for offset_n in [-10.0, 10.0] {
        let moved = |settings: &mut Settings| settings.plant.force_offset_n = offset_n;
        let missed = PaperId::Strategy2013.rows().iter().any(|printed| {
            let (paper, calibration) = (PaperId::Strategy2013, Calibration::Identified);
            let row = papers::row(paper, printed, calibration, ForceModel::Formula, moved);
            row.force_final_n.residual_percent.abs() > 2.0
        });
        assert!(missed, "{offset_n} N must show");
    }
}

#[test]
fn the_printed_models_of_2013_run_and_name_their_states() {
    for calibration in [Calibration::Printed, Calibration::Restored] {
        let paper = table(PaperId::Strategy2013, calibration);
        assert!(!paper.all_met());
        for row in &paper.rows {
            assert!(row.compared().iter().all(|cell| cell.reproduced.is_finite()));
            assert!(!row.out_of_range.is_empty(), "{row:?}");
        }
    }
    // M2 as printed asks for negative feeds: the command stands at its least value.
    let printed = table(PaperId::Strategy2013, Calibration::Printed);
    assert!(printed.rows.iter().all(|row| row.out_of_range.contains(&"k2_outside")));
    assert!(printed.rows.iter().all(|row| row.out_of_range.contains(&"feed_saturated")));
}

#[test]
fn tracking_holds_the_mean_ra_within_1_percent_with_overrides_as_a_cnc_has_them() {
    for paper in PaperId::ALL {
        for printed in paper.rows() {
            for rate_limited in [false, true] {
                let mut scenario = load(&paper.preset(printed.sim)).unwrap();
                scenario
                    .change(|s| {
                        s.controller.kind = ControllerKind::Tracking;
                        s.cnc.override_quantised = true;
                        s.cnc.override_rate_limited = rate_limited;
                    })
                    .unwrap();
                // Final values are means over the last second.
                let run = Run::complete(&scenario, &Edits::none());
                let metrics = run.metrics();
                assert!(metrics.ra_deviation_percent.unwrap().abs() < 1.0, "{paper:?} {metrics:?}");
                for row in run.recording().rows() {
                    let percent = row.feed_override_percent;
                    assert_eq!(percent, percent.round(), "whole percents at {} s", row.time_s);
                }
            }
        }
    }
}

#[test]
fn printed_and_restored_calibrations_run_and_name_their_states() {
    let printed = table(PaperId::Sdnrp2007, Calibration::Printed);
    assert!(!printed.all_met());
    for calibration in [Calibration::Printed, Calibration::Restored] {
        let paper = table(PaperId::Sdnrp2007, calibration);
        // K1(0.38 um) = 139.7 N is below 177.07 N, where K2 as printed asks for a negative feed.
        assert!(paper.rows[0].out_of_range.contains(&"k2_outside"), "{:?}", paper.rows[0]);
        for row in &paper.rows {
            assert!(row.compared().iter().all(|cell| cell.reproduced.is_finite()));
        }
    }
}

#[test]
fn tracking_holds_ra_within_1_percent_in_all_ten_rows() {
    for sim in 1..=10 {
        let metrics = Run::complete(&tracking(sim), &Edits::none()).metrics();
        assert!(metrics.ra_deviation_percent.unwrap().abs() < 1.0, "row {sim}: {metrics:?}");
    }
}

#[test]
fn the_strategy_preset_goes_its_eight_steps() {
    let scenario = load("strategy-2013").unwrap();
    // 1, 2: what is programmed is the swarm's optimum over the neural force surface.
    let optimum = PlanJob::complete(&scenario).unwrap().optimum();
    assert!(optimum.feasible);
    assert!((optimum.feed_mm_min - scenario.program.feed_mm_min).abs() < 0.01, "{optimum:?}");
    assert!((optimum.speed_rpm - scenario.program.spindle_rpm).abs() < 0.1, "{optimum:?}");
    // 3, 4: the target Ra sets the reference force, which is also the plan's limit.
    let run = Run::complete(&scenario, &Edits::none());
    let rows = run.recording().rows();
    let models = GeneticModels::new(ModelSet::Strategy2013, Calibration::Identified);
    assert_eq!(rows[0].force_ref_n, models.force_from_ra(scenario.target.ra_um).value);
    assert!((rows[0].force_n / rows[0].force_ref_n - 1.0).abs() < 0.002, "planned at the limit");
    // 5 to 8: commands by overrides in whole percents, the force measured and held to the end.
    assert!(rows.iter().all(|row| row.feed_override_percent.fract() == 0.0));
    assert!(run.metrics().ra_deviation_percent.unwrap().abs() < 1.0, "{:?}", run.metrics());
    assert_eq!(run.end(), Some(&End::PathDone));
}

#[test]
fn tracking_is_back_within_1_s_after_a_depth_step_of_15_percent() {
    let mut scenario = tracking(5);
    scenario
        .change(|s| {
            s.spindle_drive.time_constant_s = 0.2;
            s.spindle_drive.rate_rpm_s = 1000.0;
            s.cnc.dead_time_s = 0.08;
        })
        .unwrap();
    let mut edits = Edits::none();
    edits.push(&scenario, edit(8.0, "workpiece.axial_depth_mm", 2.0 * 1.15)).unwrap();
    let run = Run::complete(&scenario, &edits);
    let rows = run.recording().rows();
    let (before, after) = rows.split_at(run.recording().index_at(8.0) + 1);
    assert!(error(before.last().unwrap()).abs() < 1e-3, "at rest before the step");
    let last_outside = after.iter().rev().find(|row| error(row).abs() > 0.02).unwrap();
    assert!(last_outside.time_s - 8.0 <= 1.0, "back after {} s", last_outside.time_s - 8.0);
    let peak = after[0].force_n;
    let highest = after.iter().map(|row| row.force_n).fold(0.0, f64::max);
    assert!(highest <= 1.02 * peak, "{highest} N after a step to {peak} N");
    let lowest = after.iter().map(error).fold(0.0, f64::min);
    assert!(lowest > -0.05, "the recovery undershoots by {lowest}");
}

#[test]
fn larger_depth_steps_saturate_and_show_it() {
    let scenario = tracking(5);
    for factor in [1.3, 1.6, 2.0, 3.5] {
        let mut edits = Edits::none();
        let depth_mm = 2.0 * factor;
        edits.push(&scenario, edit(8.0, "workpiece.axial_depth_mm", depth_mm)).unwrap();
        let run = Run::complete(&scenario, &edits);
        let last = *run.recording().rows().last().unwrap();
        let saturated = last.has(flag::FEED_SATURATED | flag::SPEED_SATURATED);
        // 90 N at the least feed and the largest speed: beyond a factor of 2 nothing helps.
        assert!(error(&last).abs() < 0.005 || saturated, "x{factor}: {last:?}");
        assert_eq!(saturated, factor > 1.9, "x{factor}: {last:?}");
    }
}

#[test]
fn tracking_stays_within_half_a_percent_for_every_drive_and_dead_time() {
    for drive in FeedDriveKind::ALL {
        for (k, dead_time_ms) in [0, 1, 10, 35, 40, 80, 100, 150, 200].into_iter().enumerate() {
            for believed in [0.5, 1.0, 1.5] {
                let mut scenario = tracking([5, 1, 10][k % 3]);
                scenario
                    .change(|s| {
                        s.feed_drive.kind = *drive;
                        s.belief.feed_drive = *drive;
                        s.cnc.dead_time_s = f64::from(dead_time_ms) / 1000.0;
                        s.belief.dead_time_s = s.cnc.dead_time_s * believed;
                    })
                    .unwrap();
                let run = Run::complete(&scenario, &Edits::none());
                let late = run.recording().rows().iter().filter(|row| row.time_s >= 5.0);
                let worst = late.map(|row| error(row).abs()).fold(0.0, f64::max);
                let case = format!("{} {dead_time_ms} ms x{believed}", drive.id());
                assert!(worst <= 0.005, "{case}: {worst}");
            }
        }
    }
}

#[test]
fn tracking_does_not_need_to_know_the_drive() {
    for drive in FeedDriveKind::ALL {
        let mut scenario = tracking(5);
        scenario.change(|s| s.feed_drive.kind = *drive).unwrap();
        let run = Run::complete(&scenario, &Edits::none());
        let late = run.recording().rows().iter().filter(|row| row.time_s >= 5.0);
        let worst = late.map(|row| error(row).abs()).fold(0.0, f64::max);
        assert!(worst <= 0.005, "{}: {worst}", drive.id());
    }
}

#[test]
fn the_dead_time_is_exact_to_the_tick() {
    for ticks in [0_u32, 1, 37, 80] {
        let mut scenario = load("table3-5").unwrap();
        scenario.change(|s| s.cnc.dead_time_s = f64::from(ticks) * 1e-3).unwrap();
        let run = Run::complete(&scenario, &Edits::none());
        let rows = run.recording().rows();
        // The command changes at tick 0; the feed moves in the step after the dead time.
        let moved = rows.iter().position(|row| row.feed_mm_min != rows[0].feed_mm_min);
        assert_eq!(moved, Some(ticks as usize + 1));
    }
}

#[test]
fn the_feed_follows_the_analytic_response_of_equation_3() {
    let mut scenario = load("table3-5").unwrap();
    scenario
        .change(|s| {
            s.controller.kind = ControllerKind::ConstantFeed;
            s.controller.constant_feed.feed_percent = 50.0;
        })
        .unwrap();
    let run = Run::complete(&scenario, &Edits::none());
    let start = scenario.program.feed_mm_min;
    for row in run.recording().rows() {
        let t = (row.time_s - 0.08).max(0.0);
        let expected = start * (0.5 + 0.5 * math::exp(-14.0 * t));
        assert!((row.feed_mm_min - expected).abs() < 1e-9 * start, "{} s", row.time_s);
    }
}

#[test]
fn slices_change_nothing() {
    for preset in PRESETS {
        let mut scenario = load(preset.name).unwrap();
        scenario.change(|s| s.run.duration_s = s.run.duration_s.min(12.0)).unwrap();
        let whole = Run::complete(&scenario, &Edits::none()).recording().digest();
        let mut sliced = Run::new(&scenario, &Edits::none());
        let mut slice = 1;
        while !sliced.advance(slice) {
            slice = slice % 977 + 13;
        }
        assert_eq!(sliced.recording().digest(), whole, "{}", preset.name);
    }
}

#[test]
fn a_live_session_equals_its_replay() {
    let mut scenario = load("first-cut").unwrap();
    scenario.change(|s| s.run.duration_s = 40.0).unwrap();
    let edits = [
        edit(3.0, "target.ra_um", 1.1),
        edit(3.5, "plant.wear_factor", 1.2),
        edit(12.34, "cnc.dead_time_s", 0.15),
        edit(20.0, "noise.level", 2.0),
        edit(25.0, "workpiece.axial_depth_mm", 1.5),
    ];
    let mut so_far = Edits::none();
    let mut live = Run::new(&scenario, &so_far);
    live.advance(u64::MAX);
    for edit in edits {
        so_far.push(&scenario, edit.clone()).unwrap();
        live.branch(edit.at_s, &so_far);
        live.advance(u64::MAX);
        let replay = Run::complete(&scenario, &so_far);
        assert_eq!(live.recording(), replay.recording(), "after {edit:?}");
    }
    // Undo: back to no edits.
    live.branch(3.0, &Edits::none());
    live.advance(u64::MAX);
    let replay = Run::complete(&scenario, &Edits::none());
    assert_eq!(live.recording(), replay.recording());
}

#[test]
fn tracking_takes_over_without_a_bump() {
    // SDNRP leaves an error at a worn tool, so there is something to bump over.
    for kind in ["sdnrp", "constant_feed"] {
        let mut scenario = load("table3-5").unwrap();
        scenario
            .change(|s| {
                s.run.duration_s = 20.0;
                s.plant.wear_factor = 1.3;
            })
            .unwrap();
        scenario.set("controller.kind", Value::Text(kind.to_owned())).unwrap();
        let mut edits = Edits::none();
        let (path, value) = ("controller.kind".to_owned(), Value::Text("tracking".to_owned()));
        edits.push(&scenario, Edit { at_s: 8.0, path, value }).unwrap();
        let run = Run::complete(&scenario, &edits);
        let rows = run.recording().rows();
        let change = run.recording().index_at(8.0);
        let [before, after] = [rows[change], rows[change + 1]];
        let jump = (after.feed_command_mm_min - before.feed_command_mm_min).abs();
        assert!(jump < 0.02 * before.feed_command_mm_min, "{kind}: jump of {jump} mm/min");
        let highest = rows[change..].iter().map(|row| row.force_n).fold(0.0, f64::max);
        assert!(highest < 1.005 * before.force_n, "{kind}: the force must only fall");
        assert!(error(rows.last().unwrap()).abs() < 0.005, "{kind}");
    }
}

#[test]
fn no_material_stops_the_spindle_and_what_is_out_of_reach_is_saturation() {
    for material in Material::ALL {
        for kind in [ControllerKind::Sdnrp, ControllerKind::Tracking] {
            let mut scenario = load("table3-5").unwrap();
            scenario.change(|s| s.controller.kind = kind).unwrap();
            scenario.set("plant.material", Value::Text(material.id().to_owned())).unwrap();
            let run = Run::complete(&scenario, &Edits::none());
            let last = run.recording().rows().last().unwrap();
            let case = format!("{} {}", material.id(), kind.id());
            assert!(last.spindle_rpm > 400.0 && last.feed_mm_min > 60.0, "{case}: {last:?}");
            if kind == ControllerKind::Tracking {
                let saturated = last.has(flag::FEED_SATURATED | flag::SPEED_SATURATED);
                assert!(saturated || error(last).abs() < 0.005, "{case}: {last:?}");
            }
        }
    }
}

#[test]
fn snapshots_stay_bounded_and_branches_exact_in_long_runs() {
    let mut scenario = load("first-cut").unwrap();
    scenario.set("run.control_period_ms", Value::Float(4.0)).unwrap();
    scenario.set("workpiece.length_mm", Value::Float(20_000.0)).unwrap();
    scenario.set("run.record_every", Value::Int(20)).unwrap();
    scenario.set("run.duration_s", Value::Float(600.0)).unwrap();
    let mut run = Run::complete(&scenario, &Edits::none());
    assert_eq!(run.ticks(), 3_000_000);
    let mut edits = Edits::none();
    edits.push(&scenario, edit(590.0, "target.ra_um", 1.0)).unwrap();
    run.branch(590.0, &edits);
    assert!(run.ticks() > 2_800_000, "a rewind repeats little, not {} ticks", run.ticks());
    run.advance(u64::MAX);
    assert_eq!(run.recording(), Run::complete(&scenario, &edits).recording());
}

#[test]
fn an_air_cut_is_air_and_the_estimate_is_held() {
    let mut scenario = tracking(5);
    scenario.change(|s| s.workpiece.depth_steps = vec![[30.0, 0.0], [45.0, 2.0]]).unwrap();
    let run = Run::complete(&scenario, &Edits::none());
    let rows = run.recording().rows();
    let in_air: Vec<&Row> = rows.iter().filter(|row| row.has(flag::AIR)).collect();
    assert!(in_air.len() > 1000);
    assert!(in_air.iter().all(|row| row.force_n == 0.0 && row.ra_um == 0.0));
    let held = in_air[100].gain_estimate;
    assert!(in_air[100..].iter().all(|row| (row.gain_estimate - held).abs() < 1e-9));
    assert!(error(rows.last().unwrap()).abs() < 0.005, "back on the reference after the gap");
}

#[test]
fn air_is_no_cut_outside_the_range_of_a_force_model() {
    for force_model in ForceModel::ALL {
        let mut scenario = tracking(5);
        scenario
            .change(|s| {
                s.plant.force_model = *force_model;
                s.workpiece.depth_steps = vec![[10.0, 0.0], [25.0, 2.0]];
                if *force_model == ForceModel::Mechanistic {
                    (s.run.steps_per_control, s.run.record_every) = (200, 10);
                }
            })
            .unwrap();
        let run = Run::complete(&scenario, &Edits::none());
        let in_air = run.recording().rows().iter().filter(|row| row.has(flag::AIR));
        assert!(in_air.clone().count() > 500);
        assert!(in_air.into_iter().all(|row| !row.has(flag::K4_OUTSIDE)), "{force_model:?}");
    }
}

#[test]
fn metrics_meet_hand_computed_values() {
    // Constant feed without noise: everything is constant, so every metric is known.
    let mut scenario = load("table3-5").unwrap();
    scenario
        .change(|s| {
            s.controller.kind = ControllerKind::ConstantFeed;
            s.workpiece.length_mm = 50.0;
        })
        .unwrap();
    let run = Run::complete(&scenario, &Edits::none());
    let m = run.metrics();
    let feed = scenario.program.feed_mm_min;
    let speed = scenario.program.spindle_rpm;
    let force = 253.66 - 5.82e-10 * speed * speed * speed - 8973.0 * math::ln(0.039 * feed) / feed;
    assert!((m.force_final_n.unwrap() - force).abs() < 1e-9);
    let reference = 142.733_769_853 + 0.81 * (53.572_402_961 - 0.81 * 11.889_205_151);
    let relative = force / reference - 1.0;
    assert!((m.normalized_standard_error.unwrap() - relative).abs() < 1e-9);
    assert!((m.normalized_standard_error_20.unwrap() - relative).abs() < 1e-9);
    assert!((m.force_deviation_percent.unwrap() - 100.0 * relative).abs() < 1e-6);
    assert!((m.time_of_cut_s - 50.0 / (feed / 60.0)).abs() < 2e-3);
    assert!((m.metal_removed_cm3 - 0.3).abs() < 1e-4, "2 mm x 3 mm x 50 mm");
    assert_eq!(m.settling_time_s, None);
    assert_eq!(m.overshoot_percent, Some(0.0));
    assert_eq!(m.in_tolerance_percent, Some(0.0));
    assert_eq!(run.end(), Some(&End::PathDone));
}
