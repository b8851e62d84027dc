//! How a loop answers to a step: settling, overshoot, the error that remains, stability.
//!
//! Judged over the stretch from one change to the next, at control samples, against the value that the force
//! comes to rest at, its mean over the last quarter, since a loop can rest beside its reference:
//!
//! - Settling time: from the change until the force stays within a band around its value at rest for good. The
//!   band is 2 %, wider by what noise still moves the force at rest: the settling time of the textbooks, which
//!   does not jump with single samples of noise. Zero where the force never leaves the band: then the change
//!   makes no transient. None where the force or what is to be held swings by more than the band at rest: nothing
//!   settles there, whatever moves it.
//! - Overshoot: the force's furthest excursion beyond its value at rest, on the side away from where it was
//!   right after the change, percent of that value; none of what noise does at rest as well.
//! - Jump: its furthest excursion on the side where it was right after the change, percent of that value: what the
//!   change itself makes before the loop can answer, which is no overshoot.
//! - At rest: the means of the last two quarters are the same, and the force does not swing about them by more than
//!   5 % that the sensor does not add.
//! - Remaining error: mean deviation of what is to be held at rest, percent, positive above the
//!   reference: the steady-state error. Swing: the amplitude about it.
//! - Oscillation: see [`oscillation`](super::oscillation).

use serde::Serialize;

use super::super::signals::{Row, flag};
use super::means::{StretchMeans, deviation, force_error};
use super::oscillation::{ABOVE_NOISE, Oscillation, undamped};
use crate::base::stats;
use crate::base::units::percent_from_ratio;
use crate::blocks::reference::Reference;

/// What is held is said to swing about its mean from this amplitude on, percent (chosen).
const SWINGS_PERCENT: f64 = 2.0;
/// Force counts as settled within this fraction of its value at rest.
const SETTLED: f64 = 0.02;
/// Excursions up to so many times the largest one at rest are the noise's (chosen).
const OF_NOISE: f64 = 1.25;
/// Means of the last two quarters of a stretch that differ by less than this fraction, and the scatter within
/// them, are at rest (chosen).
const AT_REST: f64 = 0.01;
/// A force that still swings by more than this fraction of its value is not at rest, if it is not what is sensed
/// that moves it (chosen).
const STILL_SWINGS: f64 = 0.05;
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
    /// Settling time, s: 0 where the change makes no transient; none if it does not come to rest, or swings by more
    /// than the band.
    pub settling_time_s: Option<f64>,
    /// Half-width of the band that the settling time is judged by, percent of the force at rest.
    pub settling_band_percent: Option<f64>,
    /// Overshoot of the force, percent of its value at rest; none as before.
    pub overshoot_percent: Option<f64>,
    /// Jump of the force, percent of its value at rest, negative below it; none as before.
    pub jump_percent: Option<f64>,
    /// Remaining error of what is to be held, percent; none if it does not come to rest, or lies outside
    /// the model.
    pub remaining_error_percent: Option<f64>,
    /// Amplitude of what is to be held about that, percent of its reference: what noise moves it by.
    pub swing_percent: Option<f64>,
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
        let errors: Vec<f64> = samples.iter().map(|row| force_error(row)).collect();
        if errors.is_empty() {
            return None;
        }
        let mut found = Self::TOO_SHORT;
        if samples.len() < LEAST_SAMPLES {
            return Some(found);
        }
        let from = (errors.len() / 3).max(errors.len().saturating_sub(MOST_SAMPLES));
        found.oscillation =
            oscillation(&samples[from..], &errors[from..], stride as f64 * sampling.row_s);
        if found.oscillation.is_some() {
            found.ends = ResponseEnd::Unstable;
            return Some(found);
        }
        let quarter = errors.len() / 4;
        let late = &errors[errors.len() - 2 * quarter..];
        let (before, end) = late.split_at(quarter);
        let mean = |of: &[f64]| stats::mean(of.iter().copied());
        let (mean_before, rest) = (mean(before)?, mean(end)?);
        // From here on relative to the value at rest, which is that fraction above the reference.
        let off = |error: &f64| (error - rest) / (1.0 + rest);
        let scatter = |of: &[f64], mean: f64| stats::rms(of.iter().map(|error| error - mean));
        let scatter = 0.5 * (scatter(before, mean_before)? + scatter(end, rest)?);
        // A slow swing that is not known to last yet would pass for rest, being about its own mean.
        let swing = 2.0_f64.sqrt() * scatter / (1.0 + rest);
        let sensed = noise_of(&samples[samples.len() - 2 * quarter..]);
        let sensed = 2.0_f64.sqrt() * stats::deviation(&sensed).unwrap_or(0.0);
        let swings = swing > STILL_SWINGS && swing > ABOVE_NOISE * sensed;
        if swings || (rest - mean_before).abs() > AT_REST + scatter {
            found.ends = ResponseEnd::Moving;
            return Some(found);
        }
        found.ends = ResponseEnd::AtRest;
        let noise = late.iter().map(off).fold(0.0, |most: f64, off| most.max(off.abs()));
        let band = SETTLED + OF_NOISE * noise;
        found.settling_band_percent = Some(percent_from_ratio(band));
        found.settling_time_s = match errors.iter().rposition(|error| off(error).abs() > band) {
            None => Some(0.0),
            Some(i) => samples.get(i + 1).map(|row| row.time_s - changed_s),
        };
        let side = off(&errors[0]).signum();
        let beyond = errors.iter().fold(0.0, |most: f64, error| most.max(-side * off(error)));
        let overshoot = if beyond > OF_NOISE * noise { beyond } else { 0.0 };
        found.overshoot_percent = Some(percent_from_ratio(overshoot));
        let jump = errors.iter().fold(0.0, |most: f64, error| most.max(side * off(error)));
        found.jump_percent = Some(percent_from_ratio(side * jump));
        found.remaining_force_error_percent = Some(percent_from_ratio(rest));
        let of_end = samples[samples.len() - quarter..].iter();
        let of_end: Vec<f64> = of_end.filter_map(|row| deviation(row, held)).collect();
        if 2 * of_end.len() > quarter {
            let error = mean(&of_end)?;
            found.remaining_error_percent = Some(percent_from_ratio(error));
            let scatter = stats::rms(of_end.iter().map(|of| of - error))?;
            found.swing_percent = Some(percent_from_ratio(2.0_f64.sqrt() * scatter));
        }
        let largest = found.swing_percent.unwrap_or(0.0).max(percent_from_ratio(swing));
        if largest > percent_from_ratio(band) {
            found.settling_time_s = None;
            (found.overshoot_percent, found.jump_percent) = (None, None);
        }
        Some(found)
    }

    /// Before anything can be said.
    pub(super) const TOO_SHORT: Self = Self {
        ends: ResponseEnd::TooShort,
        settling_time_s: None,
        settling_band_percent: None,
        overshoot_percent: None,
        jump_percent: None,
        remaining_error_percent: None,
        swing_percent: None,
        remaining_force_error_percent: None,
        oscillation: None,
    };

    /// Whether it ends in an oscillation that does not die down.
    #[must_use]
    pub fn is_unstable(&self) -> bool {
        self.ends == ResponseEnd::Unstable
    }

    /// The amplitude of what is to be held about its mean, where it is large enough to be told, percent.
    #[must_use]
    pub fn told_swing_percent(&self) -> Option<f64> {
        self.swing_percent.filter(|swing| *swing >= SWINGS_PERCENT)
    }

    /// Whether it is at rest in the mean alone, and swings about that by more than the band of its settling.
    #[must_use]
    pub fn swings_on(&self) -> bool {
        self.ends == ResponseEnd::AtRest && self.settling_time_s.is_none()
    }

    /// What noise adds to the half-width of the band that the settling time is judged by, percent: the rest is the
    /// 2 % of the textbooks.
    #[must_use]
    pub fn band_of_noise_percent(&self) -> Option<f64> {
        self.settling_band_percent.map(|band| (band - percent_from_ratio(SETTLED)).max(0.0))
    }

    /// Whether the change makes no transient: the force never leaves the band around its value at rest.
    #[must_use]
    pub fn is_without_transient(&self) -> bool {
        self.settling_time_s == Some(0.0)
    }
}

/// An oscillation in control samples with their force errors, `sample_s` apart.
fn oscillation(samples: &[&Row], errors: &[f64], sample_s: f64) -> Option<Oscillation> {
    let feed: Vec<f64> = samples.iter().map(|row| row.feed_mm_min).collect();
    undamped(errors, &feed, &noise_of(samples), sample_s)
}

/// What the sensor adds to the force at each control sample, a fraction of the reference.
fn noise_of(samples: &[&Row]) -> Vec<f64> {
    // The controller reads at the end of one sample's row what the next one records.
    let read = samples.windows(2);
    read.map(|pair| (pair[1].force_measured_n - pair[0].force_n) / pair[0].force_ref_n).collect()
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
