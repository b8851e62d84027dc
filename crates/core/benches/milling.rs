//! Speed of the milling simulator and of its controllers.
//!
//! The loop at 28.8 kHz with everything recorded against a straightforward baseline in the same run:
//! one fused loop over the same force model, drive, windows and noise, with the adjustable PI law
//! written out. It has no settings, no choice of blocks, no edits, no snapshots and no checks. Then
//! each controller's update against a step of the plant.

use std::hint::black_box;

use steadycut_core::blocks::control::mrac::Adapted;
use steadycut_core::blocks::control::{ControlInput, Controller, ControllerKind, FeedSpeed};
use steadycut_core::blocks::cutting::tool_path::ToolPath;
use steadycut_core::models::genetic::GeneticModels;
use steadycut_core::models::part::APPROACH_MM;
use steadycut_core::run::closed_loop::limits;
use steadycut_core::run::edits::Edits;
use steadycut_core::run::one_run::Run;
use steadycut_core::run::presets::load;
use steadycut_core::run::scenario::Scenario;
use steadycut_core::run::signals::Row;

/// The loop costs at most this many times the baseline.
const LOOP_LIMIT: f64 = 1.5;
/// An update of UNKS costs at most this many steps of the plant, one of another controller less.
const UNKS_LIMIT: f64 = 20.0;
const UPDATE_LIMIT: f64 = 5.0;
/// The same of a script, which is interpreted.
const SCRIPT_LIMIT: f64 = 25.0;

mod baseline {
    #![expect(clippy::disallowed_methods, reason = "the baseline uses std's math on purpose")]

    use super::{Row, Scenario};
    use steadycut_core::base::rng::Stream;
    use steadycut_core::blocks::sensing::peak::PeakWindow;
    use steadycut_core::models::feed_drive::{DriveState, ExactDrive, FeedDriveKind};
    use steadycut_core::models::genetic::{Calibration, GeneticModels, ModelSet};
    use steadycut_core::models::mechanistic::{CK45, Cutter, Kienzle, MAX_TEETH, Sliced};
    use steadycut_core::models::part::CutPath;

    const RING: usize = 2048;

    /// The whole run, fused; Experiment 2 with the adjustable PI controller.
    pub fn run(scenario: &Scenario, rows: &mut Vec<Row>) {
        let dt = scenario.dt_s();
        let steps = u64::from(scenario.run.steps_per_control);
        let every = u64::from(scenario.run.record_every);
        let (programmed, speed) = (scenario.program.feed_mm_min, scenario.program.spindle_rpm);
        let reference = scenario.target.force_n;
        let cuts: Vec<CutPath> =
            scenario.workpiece.cuts.iter().map(|sections| CutPath::new(sections)).collect();
        let deepest = cuts.iter().map(CutPath::depth_max_mm).fold(0.0, f64::max);
        let cutter = Cutter::two_teeth(16.0, 0.003, 0.25);
        let (sliced, compliance) = (Sliced::new(&cutter, deepest), cutter.compliance_mm_n);
        let law = Kienzle::new(&CK45, 80.0, 12.0, 200.0);
        let tooth_steps = 30.0 / speed / dt;
        let per_tooth = 1.0 / (2.0 * speed);
        let turn_step = speed / 60.0 * dt;
        let drive = ExactDrive::new(FeedDriveKind::SecondOrder2013, dt);
        let believed = ExactDrive::new(FeedDriveKind::SecondOrder2013, scenario.control_period_s());
        let surface = GeneticModels::new(ModelSet::Sdnrp2007, Calibration::Identified);

        let field = Stream::new(u64::from(scenario.run.seed), "noise.inhomogeneity");
        let field_gain = scenario.noise.level * scenario.noise.inhomogeneity_percent / 100.0;
        let field_pole = (-0.1 / scenario.noise.correlation_mm).exp();
        let field_drive = (1.0 - field_pole * field_pole).sqrt();
        let (mut cell, mut here) = (0_u64, field.normal(0));
        let mut next = field_pole * here + field_drive * field.normal(1);

        let sensor_n = scenario.noise.sensor_deviation_n();
        let mut peak = PeakWindow::new(sensor_n, scenario.run.seed, steps, dt);
        let mut queue = vec![programmed; scenario.ticks(scenario.cnc.dead_time_s) as usize];
        let mut head = 0;
        // Place and last forces of every sample; before the first one a steady feed without force.
        let before = |x_mm: f64, feed: f64| -> Vec<[f64; 3]> {
            let back = |i: usize| [x_mm - (RING - i) as f64 * feed / 60.0 * dt, 0.0, 0.0];
            (0..RING).map(back).collect()
        };
        let mut history = before(-7.6, programmed);
        let (mut newest, mut last) = (RING - 1, [0.0_f64; 2]);
        let (mut turn, mut position, mut began, mut cut) = (0.0_f64, 0.0, 0.0, 0);
        let mut state = DriveState::settled(programmed);
        // The PI law and what it knows of the override.
        let (mut delayed, mut sent) = (DriveState::settled(1.0), [1.0; 3]);
        let (mut in_contact, mut started) = (false, false);
        let (mut gain, mut covariance, mut error_before) = (1.0_f64, 1.0, 0.0);
        let mut sensed = 0.0;

        let mut row = Row {
            feed_command_mm_min: programmed,
            feed_override_percent: 100.0,
            spindle_command_rpm: speed,
            spindle_override_percent: 100.0,
            gain_estimate: 1.0,
            force_setpoint_n: reference,
            force_ref_n: reference,
            spindle_rpm: speed,
            ra_target_um: surface.ra_from_force(reference).value,
            ..Row::default()
        };
        let end = scenario.ticks(scenario.run.duration_s);
        for tick in 0..=end {
            let mut feed = programmed;
            if tick > 0 {
                if (tick - 1) % steps == 0 {
                    let before = row.feed_command_mm_min / programmed;
                    if started {
                        sent = [before, sent[0], sent[1]];
                        believed.advance(&mut delayed, sent[2]);
                    }
                    started = true;
                    let y = sensed / reference;
                    let mut u = 1.5;
                    if y >= 0.06 {
                        let a = delayed.feed_mm_min().max(0.02);
                        let error = 1.0 - y;
                        if !in_contact {
                            (gain, covariance, error_before) = (y / a, 1.0, error);
                        }
                        covariance /= 0.8 + a * a * covariance;
                        gain = (gain + covariance * a * (y - gain * a)).max(0.15);
                        u = before + (0.35 * (error - error_before) + 0.12 * error) / gain;
                        error_before = error;
                    }
                    in_contact = y >= 0.06;
                    let least = 69.7 / programmed;
                    let percent = (100.0 * u.clamp(least, 1.5)).round();
                    row.force_measured_n = sensed;
                    row.gain_estimate = gain;
                    row.feed_override_percent = percent;
                    row.feed_command_mm_min = programmed * percent / 100.0;
                }
                let command = std::mem::replace(&mut queue[head], row.feed_command_mm_min);
                head = (head + 1) % queue.len();
                drive.advance(&mut state, command);
                feed = state.feed_mm_min().max(0.0);
                position += feed / 60.0 * dt;
                if position - began - 7.6 >= cuts[cut].length_mm() && cut + 1 < cuts.len() {
                    began += 7.6 + cuts[cut].length_mm();
                    position = began;
                    cut += 1;
                    queue.fill(programmed);
                    state = DriveState::settled(programmed);
                    (delayed, sent) = (DriveState::settled(1.0), [1.0; 3]);
                    (in_contact, started) = (false, false);
                    (history, newest, last) = (before(-7.6, feed), RING - 1, [0.0; 2]);
                    peak.restart();
                    row.feed_command_mm_min = programmed;
                    row.feed_override_percent = 100.0;
                }
            }
            let x_mm = position - began - 7.6;
            let place = position * 10.0;
            while place >= (cell + 1) as f64 {
                cell += 1;
                here = next;
                next = field_pole * here + field_drive * field.normal(cell + 1);
            }
            let factor = 1.0 + field_gain * (here + (place - cell as f64) * (next - here));
            newest = (newest + 1) % RING;
            history[newest] = [x_mm, last[0], last[1]];
            let mut advances = [[0.0; 2]; MAX_TEETH];
            for (k, advance) in advances[..2].iter_mut().enumerate() {
                let steps = (k + 1) as f64 * tooth_steps;
                let (whole, part) = (steps.ceil() as usize, steps.ceil() - steps);
                let low = history[(newest + RING - whole) % RING];
                let high = history[(newest + RING + 1 - whole) % RING];
                let near = if part < 0.5 { low } else { high };
                let bent = |axis: usize| compliance * (last[axis] - near[axis + 1]);
                let gone = x_mm - (low[0] + part * (high[0] - low[0]));
                let fed = if k == 0 { feed * per_tooth } else { gone };
                *advance = [fed + bent(0), bent(1)];
            }
            let part = &cuts[cut];
            let angle = turn * std::f64::consts::TAU;
            let depth_at = |x: f64, y: f64| part.depth_at(x_mm + x, y);
            let cutting = sliced.forces(&law, angle, &advances, depth_at);
            let [x, y, _] = cutting.forces_n.map(|force| force * factor);
            last = [x, y];
            turn += turn_step;
            turn -= turn.floor();
            let held = peak.push(tick, [x, y]);
            sensed = held.measured_n;
            row.time_s = tick as f64 * dt;
            row.position_mm = position;
            let [depth, wall] = part.section_at(x_mm);
            row.axial_depth_mm = depth;
            row.radial_depth_mm = ((depth * (16.0 - depth)).max(0.0).sqrt() - wall).max(0.0);
            row.feed_mm_min = feed;
            row.force_n = held.true_n;
            row.force_dyn_n = held.true_n;
            let air = held.true_n < 0.06 * reference;
            row.ra_um = if air { 0.0 } else { surface.ra_from_force(held.true_n).value };
            row.ra_dyn_um = row.ra_um;
            if tick == 0 {
                row.force_measured_n = row.force_dyn_n;
            }
            if tick % every == 0 {
                rows.push(row);
            }
        }
    }
}

/// Experiment 2 under a controller, the first 24 s: its first cut, and the second with the heaviest
/// section.
fn experiment(kind: ControllerKind, record_every: u32) -> Scenario {
    let mut scenario = load("experiment-2").expect("a shipped preset");
    scenario
        .change(|s| {
            s.controller.kind = kind;
            s.run.record_every = record_every;
            s.run.duration_s = 24.0;
        })
        .unwrap();
    scenario
}

/// The baseline must compute the same thing, or the comparison means nothing.
fn check_baseline() {
    let scenario = experiment(ControllerKind::AdjustablePi, 96);
    let mut rows = Vec::new();
    baseline::run(&scenario, &mut rows);
    let run = Run::complete(&scenario, &Edits::none());
    assert_eq!(rows.len(), run.recording().rows().len());
    for (a, b) in rows.iter().zip(run.recording().rows()) {
        let (a, b) = (a.values(), b.values());
        // The last signal holds flags, which the baseline does not compute.
        for (a, b) in a.iter().zip(&b).take(a.len() - 1) {
            assert!((a - b).abs() <= 1e-6 * b.abs().max(1.0), "{a:?} against {b:?}");
        }
    }
}

/// Seconds that `work` takes.
#[expect(clippy::disallowed_methods, reason = "a bench needs a clock")]
fn seconds(work: impl FnOnce()) -> f64 {
    let start = std::time::Instant::now();
    work();
    start.elapsed().as_secs_f64()
}

/// Best of alternating runs, the loop against the baseline; gives a plant step's time in s.
fn ratio(record_every: u32, repeats: u32) -> f64 {
    let scenario = experiment(ControllerKind::AdjustablePi, record_every);
    let steps = scenario.ticks(scenario.run.duration_s);
    let mut rows = Vec::with_capacity((steps / u64::from(record_every)) as usize + 1);
    let mut run = Run::new(&scenario, &Edits::none());
    let (mut fused, mut whole) = (f64::INFINITY, f64::INFINITY);
    for _ in 0..repeats {
        fused = fused.min(seconds(|| {
            rows.clear();
            baseline::run(black_box(&scenario), &mut rows);
            black_box(rows.len());
        }));
        whole = whole.min(seconds(|| {
            run.branch(0.0, &Edits::none());
            run.advance(u64::MAX);
            black_box(run.ticks());
        }));
    }
    let (ratio, ns) = (whole / fused, 1e9 / steps as f64);
    println!(
        "a row every {record_every} steps: {:.0} ns per step, baseline {:.0} ns, ratio {ratio:.2} \
         (limit {LOOP_LIMIT})",
        whole * ns,
        fused * ns
    );
    assert!(ratio <= LOOP_LIMIT, "the loop costs {ratio:.2} times the baseline");
    whole / steps as f64
}

/// What a controller's update costs, in steps of the plant, over what it saw in a run.
fn updates(kind: ControllerKind, adapted: Adapted, step_s: f64, repeats: u32) {
    let mut scenario = experiment(kind, 576);
    scenario.change(|s| s.controller.mrac.adapted = adapted).unwrap();
    let run = Run::complete(&scenario, &Edits::none());
    let rows = run.recording().rows();
    let models = GeneticModels::new(scenario.belief.model_set, scenario.belief.calibration);
    let programmed = FeedSpeed {
        feed_mm_min: scenario.program.feed_mm_min,
        speed_rpm: scenario.program.spindle_rpm,
    };
    let limits = limits(&scenario, 0);
    let workpiece = &scenario.workpiece;
    let begins_mm = ToolPath::begins_of(workpiece);
    let place = |row: &Row| {
        let cut = ToolPath::cut_of(workpiece, row.position_mm);
        (cut, row.position_mm - begins_mm[cut] - APPROACH_MM)
    };
    let places: Vec<(usize, f64)> = rows.iter().map(place).collect();
    let mut best = f64::INFINITY;
    for _ in 0..repeats {
        let mut controller = Controller::new(&scenario.control_setup(), programmed);
        best = best.min(seconds(|| {
            for (row, (cut, x_mm)) in rows.iter().zip(&places) {
                black_box(controller.update(&ControlInput {
                    force_measured_n: row.force_measured_n,
                    force_ref_n: row.force_ref_n,
                    programmed,
                    applied: FeedSpeed {
                        feed_mm_min: row.feed_command_mm_min,
                        speed_rpm: row.spindle_command_rpm,
                    },
                    limits,
                    models: &models,
                    cut: *cut,
                    x_mm: *x_mm,
                    by_hand: 1.0,
                }));
            }
        }));
    }
    let steps = best / rows.len() as f64 / step_s;
    let limit = if kind == ControllerKind::Unks {
        UNKS_LIMIT
    } else if kind == ControllerKind::Script {
        SCRIPT_LIMIT
    } else {
        UPDATE_LIMIT
    };
    let form = if kind == ControllerKind::Mrac { adapted.label() } else { "" };
    println!("{} {form}: {steps:.2} plant steps (limit {limit})", kind.label());
    assert!(steps <= limit, "an update of {} costs {steps:.2} plant steps", kind.label());
}

fn main() {
    // `-- --test` checks the limits with few repeats.
    let repeats = if std::env::args().any(|argument| argument == "--test") { 4 } else { 20 };
    check_baseline();
    let step_s = ratio(96, repeats);
    ratio(1, repeats);
    for kind in ControllerKind::ALL {
        updates(*kind, Adapted::Landau, step_s, 5 * repeats);
    }
    updates(ControllerKind::Mrac, Adapted::Gain, step_s, 5 * repeats);
}
