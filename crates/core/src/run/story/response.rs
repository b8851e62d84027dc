//! How a loop answers to a step: settling, overshoot, the error that remains, stability.
//!
//! Judged over the stretch from one change to the next, at control samples:
//!
//! - Settling time: from the change until the force stays within 2 % of its reference for good, as in
//!   [`metrics`](crate::run::metrics).
//! - At rest after: the same around the force's own final mean, wider by its scatter at rest, since a
//!   loop can come to rest beside its reference.
//! - Overshoot: the force's furthest excursion beyond its reference, on the side away from where it
//!   was right after the change, percent of the reference.
//! - Remaining error: mean deviation of what is to be held at rest, percent, positive above the
//!   reference: the steady-state error.
//! - Oscillation: see [`oscillation`](super::oscillation).

use serde::Serialize;

use super::super::signals::{Row, flag};
use super::means::{StretchMeans, deviation, force_error};
use super::oscillation::{Oscillation, undamped};
use crate::base::stats;
use crate::base::units::percent_from_ratio;
use crate::blocks::reference::Reference;

/// Force counts as settled within this fraction of its reference.
const SETTLED: f64 = 0.02;
/// Means of two quarters of a stretch that differ by less than this fraction are at rest (chosen).
const AT_REST: f64 = 0.01;
/// Fewest control samples that say anything about a response.
const LEAST_SAMPLES: usize = 8;
/// Most control samples, the last ones, that are looked at for an oscillation.
const MOST_SAMPLES: usize = 1500;

/// How a recording is sampled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sampling {
    /// Rows between control samples.
    pub stride: usize,
    /// Time between rows, s.
    pub row_s: f64,
}

/// How a stretch ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum ResponseEnd {
    /// At rest.
    AtRest,
    /// Still on its way.
    Moving,
    /// In an oscillation that does not die down: unstable, bounded by limits.
    Unstable,
    /// The next change came too soon to tell.
    TooShort,
}

/// See the head of this file.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct StepResponse {
    /// How it ends.
    pub ends: ResponseEnd,
    /// Settling time, s; none if the force is not within 2 % of its reference at the end.
    pub settling_time_s: Option<f64>,
    /// Time until the force stays where it comes to rest, s; none if it does not.
    pub at_rest_after_s: Option<f64>,
    /// Overshoot of the force, percent of its reference.
    pub overshoot_percent: f64,
    /// Remaining error of what is to be held, percent; none if it does not come to rest.
    pub remaining_error_percent: Option<f64>,
    /// Remaining error of the force, percent; none if it does not come to rest.
    pub remaining_force_error_percent: Option<f64>,
    /// The oscillation, if there is one.
    pub oscillation: Option<Oscillation>,
}

impl StepResponse {
    /// The response in `rows`, which begin with the first one after the change at `changed_s`, with what
    /// is to be held. None without contact.
    #[must_use]
    pub fn of(rows: &[Row], changed_s: f64, held: Reference, sampling: Sampling) -> Option<Self> {
        let stride = sampling.stride.max(1);
        let samples: Vec<&Row> =
            rows.iter().step_by(stride).filter(|row| !row.has(flag::AIR)).collect();
        let first = samples.first()?;
        let errors: Vec<f64> = samples.iter().map(|row| force_error(row)).collect();
        let side = force_error(first).signum();
        let overshoot = errors.iter().fold(0.0, |most: f64, error| most.max(-side * error));
        let stays_from = |outside: &dyn Fn(f64) -> bool| match errors
            .iter()
            .rposition(|error| outside(*error))
        {
            None => Some(0.0),
            Some(i) => samples.get(i + 1).map(|row| row.time_s - changed_s),
        };
        let mut found = Self {
            ends: ResponseEnd::TooShort,
            settling_time_s: stays_from(&|error| error.abs() > SETTLED),
            at_rest_after_s: None,
            overshoot_percent: percent_from_ratio(overshoot),
            remaining_error_percent: None,
            remaining_force_error_percent: None,
            oscillation: None,
        };
        if samples.len() < LEAST_SAMPLES {
            return Some(found);
        }
        let feed: Vec<f64> = samples.iter().map(|row| row.feed_mm_min).collect();
        let from = (errors.len() / 3).max(errors.len().saturating_sub(MOST_SAMPLES));
        found.oscillation =
            undamped(&errors[from..], &feed[from..], stride as f64 * sampling.row_s);
        if found.oscillation.is_some() {
            found.ends = ResponseEnd::Unstable;
            return Some(found);
        }
        let quarter = errors.len() / 4;
        let (before, end) = errors[errors.len() - 2 * quarter..].split_at(quarter);
        let mean = |of: &[f64]| stats::mean(of.iter().copied());
        let (mean_before, rest) = (mean(before)?, mean(end)?);
        if (rest - mean_before).abs() > AT_REST {
            found.ends = ResponseEnd::Moving;
            return Some(found);
        }
        found.ends = ResponseEnd::AtRest;
        let scatter = end.iter().fold(0.0, |most: f64, error| most.max((error - rest).abs()));
        found.at_rest_after_s = stays_from(&|error| (error - rest).abs() > SETTLED + scatter);
        found.remaining_force_error_percent = Some(percent_from_ratio(rest));
        let of_end = samples[samples.len() - quarter..].iter();
        let of_end: Vec<f64> = of_end.filter_map(|row| deviation(row, held)).collect();
        if 2 * of_end.len() > quarter {
            found.remaining_error_percent = mean(&of_end).map(percent_from_ratio);
        }
        Some(found)
    }
}

/// The means at the end of a stretch: over its last second, at most its second half.
#[must_use]
pub fn at_the_end(
    rows: &[Row],
    row_s: f64,
    held: Reference,
    tolerance_percent: f64,
) -> Option<StretchMeans> {
    let second = ((1.0 / row_s) as usize).max(1);
    let taken = second.min(rows.len().div_ceil(2));
    StretchMeans::of(&rows[rows.len() - taken..], held, tolerance_percent)
}
