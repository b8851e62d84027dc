use super::*;
use crate::base::math;
use crate::base::rng::Stream;
use crate::base::units::mm_from_um;
use crate::blocks::cutting::milling::{Milling, MillingSetup};
use crate::models::mechanistic::{CK45, Cutter};
use crate::models::part::CutPath;
use crate::models::tool::ShippedTool;

/// Samples in a second, as in the papers' set-up.
const RATE_HZ: f64 = 28_800.0;

fn cut(tool: ShippedTool, radial_depth_mm: f64) -> RecordedCut {
    let tool = tool.tool().clone();
    let speed_rpm = tool.speed_rpm(80.0);
    let law = Kienzle::new(&CK45, 80.0, tool.rake_deg, 200.0);
    RecordedCut {
        slice_mm: 0.25,
        speed_rpm,
        feed_mm_min: tool.feed_mm_min(0.08, speed_rpm),
        axial_depth_mm: 2.0,
        radial_depth_mm,
        // Other steel: neither sizes nor exponents are known before.
        law: Kienzle {
            k_n_mm2: [1.3 * law.k_n_mm2[0], 0.6 * law.k_n_mm2[1], 1.5 * law.k_n_mm2[2]],
            exponents: [0.74, 0.7, 0.65],
        },
        held_exponents: [false; 3],
        tool,
    }
}

/// The forces of the program's own milling over seconds of a steady cut, with noise of a share of the largest; and the angle
/// at the first sample in deg. It begins behind the first turns.
fn recorded(
    cut: &RecordedCut,
    axes: &[ForceAxis],
    seconds: f64,
    noise: f64,
    seed: u64,
) -> (ForceRecording, f64) {
    let setup = MillingSetup {
        cutter: Cutter::new(&cut.tool, mm_from_um(cut.tool.runout_um), cut.slice_mm),
        steel: CK45,
        rake_deg: cut.tool.rake_deg,
        hardness_hb: 200.0,
        factor: 1.0,
        dt_s: 1.0 / RATE_HZ,
    };
    let wall_mm = setup.cutter.radius_mm(cut.axial_depth_mm) - cut.radial_depth_mm;
    let path = CutPath::open(&[[1e6, cut.axial_depth_mm, wall_mm]]);
    let mut milling = Milling::new(&setup, cut.axial_depth_mm);
    let mut forces = Vec::new();
    let mut phase_deg = 0.0;
    let before = 4321;
    for i in 0..before + (seconds * RATE_HZ) as usize {
        let x_mm = cut.feed_mm_min / 60.0 * i as f64 / RATE_HZ;
        let cutting = milling.update(cut.feed_mm_min, cut.speed_rpm, x_mm, &path, 1.0);
        if i == before {
            phase_deg = 360.0 * milling.spindle_turn();
        }
        if i >= before {
            forces.push(cutting.forces_n);
        }
    }
    let largest = forces.iter().map(|[x, y, _]| (x * x + y * y).sqrt()).fold(0.0, f64::max);
    let axis = |(k, axis): (usize, &ForceAxis)| {
        let stream = Stream::new(seed + k as u64, "recorded");
        let noisy = |(i, force): (usize, &[f64; 3])| {
            axis.of(*force) + noise * largest * stream.normal(i as u64)
        };
        (*axis, forces.iter().enumerate().map(noisy).collect())
    };
    let forces = axes.iter().enumerate().map(axis).collect();
    (ForceRecording { period_s: 1.0 / RATE_HZ, forces }, phase_deg)
}

const ALL: [ForceAxis; 3] = [ForceAxis::X, ForceAxis::Y, ForceAxis::Z];

#[track_caller]
fn comes_back(cut: &RecordedCut, axes: &[ForceAxis], laws: usize) {
    let (recording, phase_deg) = recorded(cut, axes, 2.0, 0.02, 7);
    let fit = identify_force(&recording, cut).unwrap();
    let told = format!("{:?}", ForceFit { turn: Vec::new(), ..fit.clone() });
    let truth = Kienzle::new(&CK45, 80.0, cut.tool.rake_deg, 200.0);
    for i in 0..laws {
        let (law, k, m) = (&fit.laws[i], truth.k_n_mm2[i], 1.0 - truth.exponents[i]);
        // In the cut itself, at half the feed per tooth.
        let at_reference = k * math::pow(fit.reference_mm, -m);
        let found = law.at_reference_n_mm2;
        assert!((found.value / at_reference - 1.0).abs() < 0.02, "k {i} of {at_reference}: {told}");
        assert!(found.half.unwrap() < 0.025 * at_reference, "{told}");
        // Out to a thickness of 1 mm the axial force, a tenth of the others, does not tell so well.
        let k_off = if i < 2 { 0.02 * k } else { law.k_n_mm2.half.unwrap() * 1.3 };
        let m_off = if i < 2 { 0.01 } else { law.exponent.half.unwrap() * 1.3 };
        assert!((law.k_n_mm2.value - k).abs() < k_off, "k {i} of {k}: {told}");
        assert!((law.exponent.value - m).abs() < m_off && m_off < 0.05, "m {i} of {m}: {told}");
    }
    let teeth = cut.tool.teeth as usize;
    for (j, runout) in fit.runout_um.iter().enumerate() {
        let known = cut.tool.runout_um * crate::models::tool::runout_share(j, teeth);
        assert!((runout.value - known).abs() < 1.0, "tooth {j}, {known} um: {told}");
    }
    assert!((fit.shift_um.value - cut.tool.runout_um).abs() < 0.5, "{told}");
    let off = (fit.phase_deg.value - phase_deg + 540.0) % 360.0 - 180.0;
    assert!(off.abs() < 1.0, "{phase_deg} deg: {told}");
    // In a slot four teeth make a force that hardly changes: its noise is a large part of that.
    assert!(fit.r2 > 0.8 && fit.repeated_r2 > GOOD_R2, "{told}");
    assert!(fit.not_apart.is_empty(), "{told}");
    assert_eq!(fit.speed_rpm, cut.speed_rpm, "the speed was right");
}

#[test]
fn a_ball_end_s_coefficients_and_run_out_come_back_from_two_percent_of_noise() {
    // Three millimetres, and the full width of the ball at its depth.
    for radial_depth_mm in [3.0, 2.0 * 28.0_f64.sqrt()] {
        comes_back(&cut(ShippedTool::R21616B20, radial_depth_mm), &ALL, 3);
    }
}

#[test]
fn a_square_end_s_coefficients_and_run_out_come_back_from_two_percent_of_noise() {
    for radial_depth_mm in [4.0, 12.0] {
        comes_back(&cut(ShippedTool::Square12, radial_depth_mm), &ALL, 3);
    }
}

#[test]
fn two_components_of_a_square_end_tell_two_laws_and_say_so_of_the_third() {
    let cut = cut(ShippedTool::Square12, 4.0);
    let axes = [ForceAxis::X, ForceAxis::Y];
    comes_back(&cut, &axes, 2);
    let (recording, _) = recorded(&cut, &axes, 0.5, 0.02, 1);
    let fit = identify_force(&recording, &cut).unwrap();
    assert!(fit.laws[0].seen && fit.laws[1].seen && !fit.laws[2].seen);
    assert_eq!(fit.laws[2].k_n_mm2.half, None);
    let notes = fit.notes().join("\n");
    assert!(notes.contains("tell nothing of k_a and m_a"), "{notes}");
}

#[test]
fn the_force_across_a_ball_end_alone_tells_no_axial_law_apart() {
    let cut = cut(ShippedTool::R21616B20, 3.0);
    let (recording, _) = recorded(&cut, &[ForceAxis::Across], 1.0, 0.02, 3);
    let fit = identify_force(&recording, &cut).unwrap();
    assert!(fit.r2 > 0.97, "{}", fit.r2);
    let wide = |i: usize| {
        fit.laws[i].k_n_mm2.half.is_none_or(|half| half > 0.2 * fit.laws[i].k_n_mm2.value)
    };
    assert!(!fit.not_apart.is_empty() || wide(2), "{:?}", fit.laws);
}

#[test]
fn a_spindle_that_is_slower_than_told_is_found() {
    let right = cut(ShippedTool::Square12, 4.0);
    let (recording, _) = recorded(&right, &ALL, 2.0, 0.02, 5);
    let told = RecordedCut { speed_rpm: 1.002 * right.speed_rpm, ..right.clone() };
    let fit = identify_force(&recording, &told).unwrap();
    assert!((fit.speed_rpm / right.speed_rpm - 1.0).abs() < 3e-5, "{}", fit.speed_rpm);
    let truth = Kienzle::new(&CK45, 80.0, right.tool.rake_deg, 200.0);
    assert!((fit.laws[0].k_n_mm2.value / truth.k_n_mm2[0] - 1.0).abs() < 0.02);
}

#[test]
fn what_is_no_recording_of_the_cut_is_refused_with_what_was_expected() {
    let cut = cut(ShippedTool::Square12, 4.0);
    let (sound, _) = recorded(&cut, &ALL[..1], 0.2, 0.02, 1);
    let with = |samples: Vec<f64>| ForceRecording {
        forces: vec![(ForceAxis::X, samples)],
        ..sound.clone()
    };
    let samples = &sound.forces[0].1;
    let mut holed = samples.clone();
    holed[9] = f64::NAN;
    let stream = Stream::new(1, "noise");
    let noise: Vec<f64> = (0..samples.len() as u64).map(|i| stream.normal(i)).collect();
    for (recording, part) in [
        (with(samples[..59].to_vec()), "59 samples: allowed are 60"),
        (with(samples[..200].to_vec()), "turns of the spindle: expected is at least one"),
        (with(holed), "Fx: sample 10 is no number"),
        (with(vec![0.0; 5760]), "no cut was recorded"),
        (with(noise), "do not repeat"),
        // As on the workpiece: no tooth of an up-cut draws the tool forwards.
        (with(samples.iter().map(|x| -x).collect()), "expected are forces on the tool in N"),
        (ForceRecording { period_s: 0.0, ..sound.clone() }, "a period of 0 s"),
    ] {
        let error = identify_force(&recording, &cut).unwrap_err();
        assert!(error.contains(part), "{part}: {error}");
    }
    let air = RecordedCut { axial_depth_mm: 0.0, ..cut };
    let error = identify_force(&sound, &air).unwrap_err();
    assert!(error.contains("the axial depth is 0 mm"), "{error}");
}
