//! Metrics of a run, defined once. Sums, extremes and means are over every plant step ([`Tally`]), whichever of
//! them are recorded.
//!
//! - Final values: means over the last second in contact, of its first control period as much as belongs to
//!   it; none without contact, or once the tool has stood still for a second. The
//!   mean of Ra leaves out where its model has ended at zero.
//! - In tolerance: fraction of the path in contact on which the produced Ra (K5) lies within the
//!   tolerance band of its target. Above the tolerance: the fraction on which it is rougher than that band,
//!   which is scrap, as smoother is not. Not judged: the fraction on which it lies outside the model.
//! - The same two with dynamics: of Ra with dynamics, where Ra is held and the machine vibrates in the cut.
//! - Settling time: from the last change (start of the run, target, depth, edit) until the force
//!   stays within 2 % of its reference for good; none if it does not at the end.
//! - Overshoot: the force's furthest excursion beyond its reference, on the side away from where
//!   it started after a change (start of the run, target, depth, edit), in percent.
//! - Normalised standard error: root of the mean of ((F - F_ref) / F_ref)^2 over all control
//!   samples in contact; beside it the form of the 2005 paper with 20 samples.
//! - Metal removed: sum of A_D R_D dx.
//! - Scrap: path in contact beyond the tolerance on the bad side; it and the cut cost what `economics` says.

mod counting;
mod tally;

pub use counting::Counting;
pub use tally::{Judged, Period, Tally};

use serde::Serialize;

use super::edits::{Edit, Edits};
use super::recording::Recording;
use super::scenario::Scenario;
use super::signals::{Row, flag};
use crate::base::stats;
use crate::base::units::{cm3_from_mm3, min_from_s, percent_from_ratio};
use crate::models::economics::Economics;
use tally::relative_error;

/// The numbers that a run is judged by. Fields are named like the keys of `run --json`.
///
/// ```
/// use steadycut_core::run::{edits::Edits, one_run::Run, presets};
///
/// let run = Run::complete(&presets::load("table3-5").unwrap(), &Edits::none());
/// let metrics = run.metrics();
/// // SDNRP 2007, Table 3, simulation 5: 177.7 N, 254.8 mm/min.
/// assert!((metrics.force_final_n.unwrap() / 177.7 - 1.0).abs() < 0.005);
/// assert!(metrics.settling_time_s.is_some_and(|settled_s| settled_s < 15.0));
/// ```
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Metrics {
    /// Produced Ra, mean over the last second in contact, um; none without contact or beyond the end
    /// of model 5.
    pub ra_final_um: Option<f64>,
    /// Deviation of the final Ra from its target, percent; none without contact.
    pub ra_deviation_percent: Option<f64>,
    /// Fraction of the cut length with Ra in tolerance, percent; none without contact.
    pub in_tolerance_percent: Option<f64>,
    /// Fraction of the cut length beyond the upper end of the tolerance, percent: rougher than allowed, or where a
    /// force is held above it; none without contact.
    pub above_tolerance_percent: Option<f64>,
    /// Fraction of the cut length with Ra with dynamics in tolerance, percent; none without contact, and where no
    /// machine vibrates in the cut or a force is held.
    pub in_tolerance_dyn_percent: Option<f64>,
    /// Fraction of the cut length on which Ra with dynamics is rougher than its tolerance allows, percent; none as
    /// before.
    pub above_tolerance_dyn_percent: Option<f64>,
    /// Fraction of the cut length that is not judged, since Ra is to be held and lies outside the model,
    /// percent; none without contact.
    pub not_judged_percent: Option<f64>,
    /// Force, mean over the last second in contact, N; none without contact.
    pub force_final_n: Option<f64>,
    /// Deviation of the final force from its reference, percent; none without contact.
    pub force_deviation_percent: Option<f64>,
    /// Largest deviation of the force from its reference in contact after the first second, percent, signed; none
    /// where there is no contact then.
    pub force_worst_percent: Option<f64>,
    /// Feed, mean over the last second in contact, mm/min; the last one without contact.
    pub feed_final_mm_min: f64,
    /// Spindle speed, mean over the last second in contact, 1/min; the last one without contact.
    pub spindle_final_rpm: f64,
    /// Root mean square of the relative force error over all control samples in contact; none
    /// without contact.
    pub normalized_standard_error: Option<f64>,
    /// The same over 20 samples, as the 2005 paper has it.
    pub normalized_standard_error_20: Option<f64>,
    /// Settling time of the force after the last change, s; none if it does not settle.
    pub settling_time_s: Option<f64>,
    /// Overshoot of the force, percent of its reference; none without contact.
    pub overshoot_percent: Option<f64>,
    /// Time of cut, s.
    pub time_of_cut_s: f64,
    /// Length of path done, mm.
    pub path_mm: f64,
    /// Largest force, N.
    pub max_force_n: f64,
    /// Metal removed, cm^3.
    pub metal_removed_cm3: f64,
    /// Length of path in contact beyond the tolerance on the bad side: too rough, or of too large a force where one is
    /// held, mm. What is smoother than asked is no scrap, and what is not judged is none either.
    pub scrap_mm: f64,
    /// What that costs, in the currency of `economics.scrap_cost_per_mm`.
    pub scrap_cost: f64,
    /// What machine and tool cost for this cut, in the currency of `economics.machine_cost_per_min`; a tool with a
    /// broken tooth costs its whole price.
    pub cut_cost: f64,
    /// Fraction of time with a command at a limit, percent.
    pub saturated_percent: f64,
    /// Fraction of time with a model outside its range, percent.
    pub outside_percent: f64,
}

/// A target counts as held where its tolerance is kept on at least this share of the cut length, percent (chosen).
pub const HELD_PERCENT: f64 = 90.0;

/// Whether a target is held that is within its tolerance on a share of the length and not judged on another one,
/// percent; none where what is not judged could decide it.
fn is_held(inside: f64, unknown: f64) -> Option<bool> {
    match (inside >= HELD_PERCENT, inside + unknown >= HELD_PERCENT) {
        (true, _) => Some(true),
        (false, true) => None,
        (false, false) => Some(false),
    }
}

/// A metric's name in JSON, and what reads it; none where a run has none.
pub type NamedMetric = (&'static str, fn(&Metrics) -> Option<f64>);

/// The metrics by their names: what a mission's conditions read.
pub const METRICS: &[NamedMetric] = &[
    ("ra_final_um", |metrics| metrics.ra_final_um),
    ("ra_deviation_percent", |metrics| metrics.ra_deviation_percent),
    ("in_tolerance_percent", |metrics| metrics.in_tolerance_percent),
    ("above_tolerance_percent", |metrics| metrics.above_tolerance_percent),
    ("in_tolerance_dyn_percent", |metrics| metrics.in_tolerance_dyn_percent),
    ("above_tolerance_dyn_percent", |metrics| metrics.above_tolerance_dyn_percent),
    ("not_judged_percent", |metrics| metrics.not_judged_percent),
    ("force_final_n", |metrics| metrics.force_final_n),
    ("force_deviation_percent", |metrics| metrics.force_deviation_percent),
    ("force_worst_percent", |metrics| metrics.force_worst_percent),
    ("feed_final_mm_min", |metrics| Some(metrics.feed_final_mm_min)),
    ("spindle_final_rpm", |metrics| Some(metrics.spindle_final_rpm)),
    ("normalized_standard_error", |metrics| metrics.normalized_standard_error),
    ("normalized_standard_error_20", |metrics| metrics.normalized_standard_error_20),
    ("settling_time_s", |metrics| metrics.settling_time_s),
    ("overshoot_percent", |metrics| metrics.overshoot_percent),
    ("time_of_cut_s", |metrics| Some(metrics.time_of_cut_s)),
    ("path_mm", |metrics| Some(metrics.path_mm)),
    ("max_force_n", |metrics| Some(metrics.max_force_n)),
    ("metal_removed_cm3", |metrics| Some(metrics.metal_removed_cm3)),
    ("scrap_mm", |metrics| Some(metrics.scrap_mm)),
    ("scrap_cost", |metrics| Some(metrics.scrap_cost)),
    ("cut_cost", |metrics| Some(metrics.cut_cost)),
    ("saturated_percent", |metrics| Some(metrics.saturated_percent)),
    ("outside_percent", |metrics| Some(metrics.outside_percent)),
];

/// Force counts as settled within this fraction of its reference.
const SETTLED: f64 = 0.02;

/// Time that a standing tool still counts as in the cut that it made, s.
const STANDING_S: f64 = 1.0;

/// Metrics over the first `rows` rows of a recording.
#[must_use]
pub fn metrics(recording: &Recording, rows: usize, scenario: &Scenario, edits: &Edits) -> Metrics {
    Counting::default().metrics(recording, rows, scenario, edits)
}

/// The metrics at the last of the first `rows` rows, with what was counted up to it.
fn counted(recording: &Recording, rows: usize, tally: &Tally, economics: &Economics) -> Metrics {
    let Some(last) = rows.checked_sub(1).and_then(|last| recording.rows().get(last)) else {
        return Metrics::empty();
    };
    let ending = ending(recording, tally);
    let means = ending.and_then(|ending| ending.means());
    let of = |i: usize| means.map(|means| means[i]);
    let [_, ra_target, force, force_ref, feed, speed] = std::array::from_fn(of);
    let ra = ending.and_then(|ending| ending.mean_ra_um());
    let deviation = |value: Option<f64>, target: Option<f64>| {
        let (value, target) = value.zip(target)?;
        Some(percent_from_ratio((value - target) / target))
    };
    let fraction = |count: u64| percent_from_ratio(count as f64 / tally.steps.max(1) as f64);

    let of_length = |part_mm: f64| {
        (tally.in_contact_mm > 0.0).then(|| percent_from_ratio(part_mm / tally.in_contact_mm))
    };

    let shaken = |part_mm: f64| tally.judged().shakes().then(|| of_length(part_mm)).flatten();

    let samples: Vec<&Row> = recording.samples(rows).filter(|row| !row.has(flag::AIR)).collect();
    let rms = |samples: &[&Row]| stats::rms(samples.iter().map(|row| relative_error(row)));
    let twenty: Vec<&Row> =
        (1..=20).filter_map(|k| samples.get(samples.len() * (2 * k - 1) / 40).copied()).collect();

    Metrics {
        ra_final_um: ra,
        ra_deviation_percent: deviation(ra, ra_target),
        in_tolerance_percent: of_length(tally.good_mm),
        above_tolerance_percent: of_length(tally.above_mm),
        in_tolerance_dyn_percent: shaken(tally.shaken_good_mm),
        above_tolerance_dyn_percent: shaken(tally.shaken_above_mm),
        not_judged_percent: of_length(tally.unknown_mm),
        force_final_n: force,
        force_deviation_percent: deviation(force, force_ref),
        force_worst_percent: tally.worst.map(percent_from_ratio),
        feed_final_mm_min: feed.unwrap_or(last.feed_mm_min),
        spindle_final_rpm: speed.unwrap_or(last.spindle_rpm),
        normalized_standard_error: rms(&samples),
        normalized_standard_error_20: rms(&twenty),
        settling_time_s: tally.settling_s(),
        overshoot_percent: tally.overshoot().map(percent_from_ratio),
        time_of_cut_s: last.time_s,
        path_mm: last.position_mm,
        max_force_n: tally.max_force_n,
        metal_removed_cm3: cm3_from_mm3(tally.removed_mm3),
        scrap_mm: tally.above_mm,
        scrap_cost: economics.scrap_cost_per_mm * tally.above_mm,
        cut_cost: economics.machine_cost_per_min * min_from_s(last.time_s)
            + economics.tool_cost
                * match last.has(flag::TOOTH_BROKEN) {
                    // A cutter with a broken tooth is not used again.
                    true => 1.0,
                    false => last.used_life - recording.rows()[0].used_life,
                },
        saturated_percent: fraction(tally.saturated),
        outside_percent: fraction(tally.outside),
    }
}

/// Whether an edit may move the loop: a tolerance only judges.
#[must_use]
pub fn moves(edit: &Edit) -> bool {
    edit.path != "target.tolerance_percent"
}

/// Sums over the last second in contact.
fn ending(recording: &Recording, tally: &Tally) -> Option<Period> {
    if tally.standing >= recording.tick_of(STANDING_S) {
        return None;
    }
    let second = recording.tick_of(1.0).max(1) as f64;
    let mut period = tally.period;
    for number in (0..tally.periods_before()).rev() {
        if period.contact >= second {
            break;
        }
        period = period.with(&recording.period(number), second);
    }
    Some(period)
}

impl Metrics {
    /// Whether the target is held, its tolerance kept on [`HELD_PERCENT`] of the length; none where what is not
    /// judged could decide it, and without contact.
    #[must_use]
    pub fn held(&self) -> Option<bool> {
        let (inside, unknown) = self.in_tolerance_percent.zip(self.not_judged_percent)?;
        is_held(inside, unknown)
    }

    /// The same of Ra with dynamics; none as well where that is not judged.
    #[must_use]
    pub fn held_with_dynamics(&self) -> Option<bool> {
        let (inside, unknown) = self.in_tolerance_dyn_percent.zip(self.not_judged_percent)?;
        is_held(inside, unknown)
    }

    /// Share of the cut length within the tolerance, percent: of Ra with dynamics where the machine vibrates in the
    /// cut, which is what is left on the part.
    #[must_use]
    pub fn judged_in_tolerance_percent(&self) -> Option<f64> {
        self.in_tolerance_dyn_percent.or(self.in_tolerance_percent)
    }

    /// The same beyond the upper end of the tolerance.
    #[must_use]
    pub fn judged_above_tolerance_percent(&self) -> Option<f64> {
        self.above_tolerance_dyn_percent.or(self.above_tolerance_percent)
    }

    /// Whether the cut is nowhere beyond the upper end of its tolerance but on what may be missed of a target that
    /// counts as held, as [`Self::held`] has it: a surface that is smoother than asked is no scrap. Where the machine
    /// vibrates in the cut it is not with dynamics either. None where what is not judged could decide it, and without
    /// contact.
    #[must_use]
    pub fn not_above(&self) -> Option<bool> {
        let (above, unknown) = self.above_tolerance_percent.zip(self.not_judged_percent)?;
        let above = self.above_tolerance_dyn_percent.map_or(above, |shaken| above.max(shaken));
        let allowed = 100.0 - HELD_PERCENT;
        match (above > allowed, above + unknown > allowed) {
            (true, _) => Some(false),
            (false, true) => None,
            (false, false) => Some(true),
        }
    }

    fn empty() -> Self {
        Self {
            ra_final_um: None,
            ra_deviation_percent: None,
            in_tolerance_percent: None,
            above_tolerance_percent: None,
            in_tolerance_dyn_percent: None,
            above_tolerance_dyn_percent: None,
            not_judged_percent: None,
            force_final_n: None,
            force_deviation_percent: None,
            force_worst_percent: None,
            feed_final_mm_min: 0.0,
            spindle_final_rpm: 0.0,
            normalized_standard_error: None,
            normalized_standard_error_20: None,
            settling_time_s: None,
            overshoot_percent: None,
            time_of_cut_s: 0.0,
            path_mm: 0.0,
            max_force_n: 0.0,
            metal_removed_cm3: 0.0,
            scrap_mm: 0.0,
            scrap_cost: 0.0,
            cut_cost: 0.0,
            saturated_percent: 0.0,
            outside_percent: 0.0,
        }
    }
}
