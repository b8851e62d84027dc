//! Metrics on rows made by hand, every value known beforehand.

use steadycut_core::base::settings::Value;
use steadycut_core::run::edits::{Edit, Edits};
use steadycut_core::run::metrics::{Metrics, metrics};
use steadycut_core::run::recording::Recording;
use steadycut_core::run::scenario::Scenario;
use steadycut_core::run::signals::{Row, flag, signal};

/// Rows of 10 ms, control samples every 20 ms; `change` sets what differs.
fn rows(n: u64, change: impl Fn(f64, &mut Row)) -> Recording {
    let mut recording = Recording::new(n, 1, 0.01, 2);
    for k in 0..=n {
        let time_s = k as f64 * 0.01;
        let mut row = Row {
            time_s,
            position_mm: 5.0 * time_s,
            axial_depth_mm: 2.0,
            radial_depth_mm: 3.0,
            ra_target_um: 1.0,
            ra_um: 1.0,
            force_ref_n: 100.0,
            force_n: 100.0,
            feed_mm_min: 300.0,
            spindle_rpm: 2000.0,
            ..Row::default()
        };
        change(time_s, &mut row);
        recording.push(k, &row);
    }
    recording
}

fn judge(recording: &Recording) -> Metrics {
    metrics(recording, usize::MAX, &Scenario::default(), &Edits::none())
}

#[test]
fn settling_counts_from_the_change_to_the_first_row_inside_for_good() {
    // The depth changes with the row at 3.00 s (so the change came with 2.99 s); the force is out
    // by 5 % up to and with 3.49 s, dips back once before, and settles at 3.50 s.
    let recording = rows(1000, |t, row| {
        if t > 2.995 {
            row.axial_depth_mm = 2.2;
            let outside = t < 3.495 && !(3.195..3.205).contains(&t);
            row.force_n = if outside { 105.0 } else { 101.9 };
        }
    });
    let settling = judge(&recording).settling_time_s.unwrap();
    assert!((settling - 0.51).abs() < 1e-9, "{settling}");
    let never = rows(1000, |t, row| row.force_n = if t > 9.985 { 103.0 } else { 100.0 });
    assert_eq!(judge(&never).settling_time_s, None);
    assert_eq!(judge(&rows(1000, |_, _| {})).settling_time_s, Some(0.0));
}

#[test]
fn overshoot_is_the_excursion_to_the_other_side() {
    // Starts 20 % high, falls through the reference to 7 % low, ends on it.
    let falling = rows(1000, |t, row| {
        row.force_n = if t < 1.0 {
            120.0
        } else if t < 2.0 {
            93.0
        } else {
            100.0
        };
    });
    assert!((judge(&falling).overshoot_percent.unwrap() - 7.0).abs() < 1e-9);
    let approaching = rows(1000, |t, row| row.force_n = if t < 1.0 { 120.0 } else { 100.0 });
    assert_eq!(judge(&approaching).overshoot_percent, Some(0.0));
}

#[test]
fn shares_and_errors_count_contact_only() {
    // 10 s at 5 mm/s: 4 s in tolerance, 4 s 11 % off, 2 s in the air.
    let recording = rows(1000, |t, row| {
        if t > 8.0 {
            row.state_flags = f64::from(flag::AIR);
            (row.force_n, row.ra_um, row.axial_depth_mm) = (0.0, 0.0, 0.0);
        } else if t > 4.0 {
            (row.ra_um, row.force_n) = (1.11, 110.0);
        }
    });
    let m = judge(&recording);
    assert!((m.in_tolerance_percent.unwrap() - 50.0).abs() < 1e-9);
    // Half of the 401 control samples in contact (200) are off by 10 %.
    let expected = (200.0 / 401.0_f64).sqrt() * 0.1;
    assert!((m.normalized_standard_error.unwrap() - expected).abs() < 1e-12);
    assert!((m.normalized_standard_error_20.unwrap() - 0.5_f64.sqrt() * 0.1).abs() < 1e-12);
    assert!((m.metal_removed_cm3 - 8.0 * 5.0 * 2.0 * 3.0 / 1000.0).abs() < 1e-9);
    // Final values are those of the last second in contact.
    assert!((m.ra_final_um.unwrap() - 1.11).abs() < 1e-9);
    assert!((m.force_deviation_percent.unwrap() - 10.0).abs() < 1e-9);
    assert_eq!((m.max_force_n, m.time_of_cut_s, m.path_mm), (110.0, 10.0, 50.0));
}

#[test]
fn where_ra_lies_outside_the_model_it_is_not_judged_and_counts_apart() {
    // 10 s: 5 s in tolerance, 2 s outside the model, 3 s 11 % off.
    let recording = rows(1000, |t, row| {
        if t > 7.0 {
            row.ra_um = 1.11;
        } else if t > 5.0 {
            (row.ra_um, row.ra_dyn_um) = (0.0, 0.4);
            row.state_flags = f64::from(flag::K5_OUTSIDE | flag::K6_OUTSIDE);
        }
    });
    let m = judge(&recording);
    let shares = [m.in_tolerance_percent, m.not_judged_percent].map(Option::unwrap);
    assert!((shares[0] - 50.0).abs() < 1e-6 && (shares[1] - 20.0).abs() < 1e-6, "{shares:?}");
    // What vibration adds to nothing is no roughness either.
    let dynamic = signal("ra_dyn_um").unwrap();
    let outside = recording.rows().iter().filter(|row| row.has(flag::K5_OUTSIDE));
    assert!(outside.clone().count() > 0);
    assert!(outside.map(|row| (dynamic.value)(row)).all(|value| value.is_none()));
}

#[test]
fn a_cut_in_the_air_alone_has_no_error_and_no_share() {
    let m = judge(&rows(100, |_, row| row.state_flags = f64::from(flag::AIR)));
    assert_eq!((m.normalized_standard_error, m.in_tolerance_percent), (None, None));
    assert_eq!((m.ra_final_um, m.ra_deviation_percent), (None, None));
    assert_eq!((m.force_final_n, m.force_deviation_percent), (None, None));
    assert_eq!((m.force_worst_percent, m.overshoot_percent), (None, None));
    assert_eq!((m.settling_time_s, m.feed_final_mm_min), (None, 300.0));
}

#[test]
fn a_tool_that_stands_has_no_final_values_after_a_second() {
    let stopped = |n: u64| {
        rows(n, |t, row| {
            if t > 3.0 {
                row.state_flags = f64::from(flag::AIR);
                (row.force_n, row.ra_um, row.feed_mm_min) = (0.0, 0.0, 0.1);
            }
        })
    };
    assert_eq!(judge(&stopped(399)).ra_final_um, Some(1.0));
    let m = judge(&stopped(401));
    assert_eq!((m.ra_final_um, m.force_final_n, m.feed_final_mm_min), (None, None, 0.1));
}

#[test]
fn a_roughness_beyond_the_end_of_its_model_is_none() {
    let m = judge(&rows(200, |t, row| {
        if t > 0.5 {
            (row.ra_um, row.state_flags) = (0.0, f64::from(flag::K5_OUTSIDE));
        }
    }));
    assert_eq!((m.ra_final_um, m.ra_deviation_percent, m.force_final_n), (None, None, Some(100.0)));
    let m = judge(&rows(200, |t, row| {
        if t > 1.5 {
            (row.ra_um, row.state_flags) = (0.0, f64::from(flag::K5_OUTSIDE));
        }
    }));
    assert_eq!(m.ra_final_um, Some(1.0), "the mean where it is known");
}

#[test]
fn an_edit_starts_a_new_settling_but_a_tolerance_does_not() {
    let recording = rows(1000, |t, row| row.force_n = if t < 2.495 { 105.0 } else { 100.0 });
    let settling = |path: &str, value: f64| {
        let scenario = Scenario::default();
        let mut edits = Edits::none();
        let edit = Edit { at_s: 2.0, path: path.to_owned(), value: Value::Float(value) };
        edits.push(&scenario, edit).unwrap();
        metrics(&recording, usize::MAX, &scenario, &edits).settling_time_s.unwrap()
    };
    assert!((settling("plant.wear_factor", 1.1) - 0.5).abs() < 1e-9);
    assert!((settling("target.tolerance_percent", 5.0) - 2.5).abs() < 1e-9);
}

#[test]
fn the_twenty_samples_stand_in_the_middles_of_their_twentieths() {
    let recording = rows(1000, |t, row| row.force_n = 100.0 * (1.0 + 0.05 * t));
    let squares = (1..=20).map(|k| {
        let error = 0.05 * 10.0 * (f64::from(k) - 0.5) / 20.0;
        error * error
    });
    let expected = (squares.sum::<f64>() / 20.0).sqrt();
    let found = judge(&recording).normalized_standard_error_20.unwrap();
    assert!((found / expected - 1.0).abs() < 0.005, "{found} {expected}");
}

#[test]
fn the_worst_error_leaves_out_the_first_second_and_parts_are_of_the_steps() {
    let recording = rows(1000, |t, row| {
        row.force_n = if t < 0.5 {
            150.0
        } else if (4.0..5.0).contains(&t) {
            88.0
        } else {
            100.0
        };
        if t > 8.001 {
            row.state_flags = f64::from(flag::FEED_SATURATED);
        } else if t > 7.001 {
            row.state_flags = f64::from(flag::K4_OUTSIDE);
        }
    });
    let m = judge(&recording);
    assert!((m.force_worst_percent.unwrap() + 12.0).abs() < 1e-9, "{m:?}");
    assert!((m.saturated_percent - 20.0).abs() < 0.11, "{m:?}");
    assert!((m.outside_percent - 10.0).abs() < 0.11, "{m:?}");
}
