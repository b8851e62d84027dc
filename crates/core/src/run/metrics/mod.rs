//! Metrics of a run, defined once.
//!
//! - Final values: means over the last second in contact.
//! - In tolerance: fraction of the path in contact on which the produced Ra (K5) lies within the
//!   tolerance band of its target.
//! - Settling time: from the last change (start of the run, target, depth, edit) until the force
//!   stays within 2 % of its reference for good; none if it does not at the end.
//! - Overshoot: the force's furthest excursion beyond its reference, on the side away from where
//!   it started after a change (start of the run, target, depth, edit), in percent.
//! - Normalised standard error: root of the mean of ((F - F_ref) / F_ref)^2 over all control
//!   samples in contact; beside it the form of the 2005 paper with 20 samples.
//! - Metal removed: sum of A_D R_D dx.

use serde::Serialize;

use super::edits::Edits;
use super::recording::Recording;
use super::scenario::Scenario;
use super::signals::{Row, flag};
use crate::base::stats;
use crate::base::units::{cm3_from_mm3, percent_from_ratio, ratio_from_percent};
use crate::blocks::reference::Reference;

/// The numbers that a run is judged by. Fields are named like the keys of `run --json`.
///
/// ```
/// use steadycut_core::run::{edits::Edits, one_run::Run, presets};
///
/// let run = Run::complete(&presets::load("table3-5").unwrap(), &Edits::none());
/// let metrics = run.metrics();
/// // SDNRP 2007, Table 3, simulation 5: 177.7 N, 254.8 mm/min.
/// assert!((metrics.force_final_n / 177.7 - 1.0).abs() < 0.005);
/// assert!(metrics.settling_time_s.is_some_and(|settled_s| settled_s < 15.0));
/// ```
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Metrics {
    /// Produced Ra, mean over the last second, um.
    pub ra_final_um: f64,
    /// Deviation of the final Ra from its target, percent.
    pub ra_deviation_percent: f64,
    /// Fraction of the cut length with Ra in tolerance, percent; none without contact.
    pub in_tolerance_percent: Option<f64>,
    /// Force, mean over the last second, N.
    pub force_final_n: f64,
    /// Deviation of the final force from its reference, percent.
    pub force_deviation_percent: f64,
    /// Largest deviation of the force from its reference after the first second, percent, signed.
    pub force_worst_percent: f64,
    /// Feed, mean over the last second, mm/min.
    pub feed_final_mm_min: f64,
    /// Spindle speed, mean over the last second, 1/min.
    pub spindle_final_rpm: f64,
    /// Root mean square of the relative force error over all control samples in contact; none
    /// without contact.
    pub normalized_standard_error: Option<f64>,
    /// The same over 20 samples, as the 2005 paper has it.
    pub normalized_standard_error_20: Option<f64>,
    /// Settling time of the force after the last change, s; none if it does not settle.
    pub settling_time_s: Option<f64>,
    /// Overshoot of the force, percent of its reference.
    pub overshoot_percent: f64,
    /// Time of cut, s.
    pub time_of_cut_s: f64,
    /// Length of path done, mm.
    pub path_mm: f64,
    /// Largest force, N.
    pub max_force_n: f64,
    /// Metal removed, cm^3.
    pub metal_removed_cm3: f64,
    /// Fraction of rows with a command at a limit, percent.
    pub saturated_percent: f64,
    /// Fraction of rows with a model outside its range, percent.
    pub outside_percent: f64,
}

/// Force counts as settled within this fraction of its reference.
const SETTLED: f64 = 0.02;

fn relative_error(row: &Row) -> f64 {
    // The reference is at least FORCE_REF_MIN_N, never zero.
    (row.force_n - row.force_ref_n) / row.force_ref_n
}

/// Metrics over the first `rows` rows of a recording.
#[must_use]
pub fn metrics(recording: &Recording, rows: usize, scenario: &Scenario, edits: &Edits) -> Metrics {
    let all = recording.rows();
    let rows = &all[..rows.min(all.len())];
    let (Some(first), Some(last)) = (rows.first(), rows.last()) else {
        return Metrics::empty();
    };

    let tail = Recording::last_second(rows, recording.row_s());
    let mean = |get: fn(&Row) -> f64| stats::mean(tail.iter().map(get)).unwrap_or(f64::NAN);
    let (ra_final_um, force_final_n) = (mean(|r| r.ra_um), mean(|r| r.force_n));
    let deviation = |value: f64, target: f64| percent_from_ratio((value - target) / target);

    let tolerance = ratio_from_percent(scenario.target.tolerance_percent);
    let (mut in_contact_mm, mut good_mm, mut removed_mm3) = (0.0, 0.0, 0.0);
    let (mut max_force_n, mut worst) = (first.force_n, 0.0_f64);
    let (mut saturated, mut outside) = (0_usize, 0_usize);
    for pair in rows.windows(2) {
        let row = &pair[1];
        let step_mm = row.position_mm - pair[0].position_mm;
        if !row.has(flag::AIR) {
            in_contact_mm += step_mm;
            let good = match scenario.target.reference {
                Reference::Ra => {
                    (row.ra_um - row.ra_target_um).abs() <= tolerance * row.ra_target_um
                }
                Reference::Force => relative_error(row).abs() <= tolerance,
            };
            if good {
                good_mm += step_mm;
            }
        }
        removed_mm3 += row.axial_depth_mm * row.radial_depth_mm * step_mm;
        max_force_n = max_force_n.max(row.force_n);
        if row.time_s >= 1.0 && !row.has(flag::AIR) && relative_error(row).abs() > worst.abs() {
            worst = relative_error(row);
        }
        saturated += usize::from(row.has(flag::SATURATED));
        outside += usize::from(row.has(flag::OUTSIDE));
    }
    let fraction = |count: usize| percent_from_ratio(count as f64 / (rows.len() - 1).max(1) as f64);

    let samples: Vec<&Row> =
        rows.iter().step_by(recording.control_stride()).filter(|row| !row.has(flag::AIR)).collect();
    let rms = |samples: &[&Row]| stats::rms(samples.iter().map(|row| relative_error(row)));
    let twenty: Vec<&Row> =
        (1..=20).filter_map(|k| samples.get(samples.len() * (2 * k - 1) / 40).copied()).collect();

    let changes = changes(recording, rows, edits);
    Metrics {
        ra_final_um,
        ra_deviation_percent: deviation(ra_final_um, mean(|r| r.ra_target_um)),
        in_tolerance_percent: (in_contact_mm > 0.0)
            .then(|| percent_from_ratio(good_mm / in_contact_mm)),
        force_final_n,
        force_deviation_percent: deviation(force_final_n, mean(|r| r.force_ref_n)),
        force_worst_percent: percent_from_ratio(worst),
        feed_final_mm_min: mean(|r| r.feed_mm_min),
        spindle_final_rpm: mean(|r| r.spindle_rpm),
        normalized_standard_error: rms(&samples),
        normalized_standard_error_20: rms(&twenty),
        settling_time_s: settling(rows, changes.last().copied().unwrap_or(0)),
        overshoot_percent: percent_from_ratio(overshoot(rows, &changes)),
        time_of_cut_s: last.time_s,
        path_mm: last.position_mm,
        max_force_n,
        metal_removed_cm3: cm3_from_mm3(removed_mm3),
        saturated_percent: fraction(saturated),
        outside_percent: fraction(outside),
    }
}

/// Indices of rows at which something changed: the start, a target, a depth, an edit.
fn changes(recording: &Recording, rows: &[Row], edits: &Edits) -> Vec<usize> {
    let mut found = vec![0];
    for (i, pair) in rows.windows(2).enumerate() {
        if pair[0].force_ref_n != pair[1].force_ref_n
            || pair[0].axial_depth_mm != pair[1].axial_depth_mm
        {
            found.push(i + 1);
        }
    }
    // A tolerance only judges; every other edit may move the loop.
    let moving = edits.list().iter().filter(|edit| edit.path != "target.tolerance_percent");
    let edited = moving.map(|edit| recording.index_at(edit.at_s) + 1);
    found.extend(edited.filter(|index| *index < rows.len()));
    found.sort_unstable();
    found.dedup();
    found
}

fn settling(rows: &[Row], change: usize) -> Option<f64> {
    // `change` is the first row after the change, which came with the row before it.
    let start_s = rows[change.saturating_sub(1)].time_s;
    let outside = rows[change..].iter().rposition(|row| relative_error(row).abs() > SETTLED);
    match outside {
        None => Some(0.0),
        Some(i) if change + i + 1 >= rows.len() => None,
        Some(i) => Some(rows[change + i + 1].time_s - start_s),
    }
}

fn overshoot(rows: &[Row], changes: &[usize]) -> f64 {
    let mut worst = 0.0_f64;
    for (k, start) in changes.iter().enumerate() {
        let end = changes.get(k + 1).copied().unwrap_or(rows.len());
        let side = relative_error(&rows[*start]).signum();
        for row in &rows[*start..end] {
            if !row.has(flag::AIR) {
                worst = worst.max(-side * relative_error(row));
            }
        }
    }
    worst
}

impl Metrics {
    fn empty() -> Self {
        Self {
            ra_final_um: 0.0,
            ra_deviation_percent: 0.0,
            in_tolerance_percent: None,
            force_final_n: 0.0,
            force_deviation_percent: 0.0,
            force_worst_percent: 0.0,
            feed_final_mm_min: 0.0,
            spindle_final_rpm: 0.0,
            normalized_standard_error: None,
            normalized_standard_error_20: None,
            settling_time_s: None,
            overshoot_percent: 0.0,
            time_of_cut_s: 0.0,
            path_mm: 0.0,
            max_force_n: 0.0,
            metal_removed_cm3: 0.0,
            saturated_percent: 0.0,
            outside_percent: 0.0,
        }
    }
}
