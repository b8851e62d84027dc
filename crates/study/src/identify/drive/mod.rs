//! A feed drive from a recording: dead time, order and lag from what it was told and what it did
//! (`steadycut identify drive`).
//!
//! ```text
//! f_a(s)/f_c(s) = K e^{-L s} a0 / (s^n + .. + a1 s + a0)
//! ```
//!
//! Several structures are fitted to the same recording by least squares, the drive discretised exactly as the loop's own
//! ([`crate::models::feed_drive`]), the dead time of any length. Which of them to take says Schwarz's criterion (G. Schwarz,
//! Estimating the dimension of a model, 1978); Akaike's stands beside it:
//!
//! ```text
//! BIC = N ln(S/N) + p ln N        AIC = N ln(S/N) + 2 p
//! ```
//!
//! of N samples, p parameters, sum of squares S. Intervals are those of 95 % from the linearised fit. They take the rest
//! for noise from sample to sample; where a structure does not fit, they are too narrow.

mod file;
mod fit;
mod structure;

pub use file::drive_file;
pub use structure::DriveStructure;

use super::estimate::EstimatedValue;
use crate::base::language::tr;
use fit::fitted;

/// Fewest and most samples of a recording.
const SAMPLES: [usize; 2] = [20, 20_000];

/// What a drive was told and what it did, one sample after the other: what it is told in a sample holds from the sample
/// before on, as in the rows of a run.
#[derive(Clone, Debug, PartialEq)]
pub struct DriveRecording {
    /// Distance of two samples, s.
    pub period_s: f64,
    /// Feed that was asked for, in any unit.
    pub command: Vec<f64>,
    /// Feed that was measured, in the same unit.
    pub feed: Vec<f64>,
}

/// A structure fitted to a recording.
#[derive(Clone, Debug, PartialEq)]
pub struct DriveFit {
    /// The structure.
    pub structure: DriveStructure,
    /// Dead time L, s.
    pub dead_time_s: EstimatedValue,
    /// Lag: the area between a unit step and the drive's answer to it without dead time, s.
    pub lag_s: EstimatedValue,
    /// Gain K.
    pub gain: EstimatedValue,
    /// The structure's own parameters by their names and units.
    pub parameters: Vec<(&'static str, &'static str, EstimatedValue)>,
    /// Poles, real and imaginary parts in rad/s.
    pub poles: Vec<[f64; 2]>,
    /// Root mean square of the rest, in the unit of the feed: the size of the noise, if the structure is right.
    pub rest: f64,
    /// Akaike's criterion.
    pub aic: f64,
    /// Schwarz's criterion.
    pub bic: f64,
    /// Measured minus fitted, sample by sample.
    pub residuals: Vec<f64>,
}

impl DriveRecording {
    /// Checks that something can be learned from it.
    fn check(&self) -> Result<(), String> {
        let count = self.command.len().min(self.feed.len());
        let [least, most] = SAMPLES;
        if !(least..=most).contains(&count) || self.command.len() != self.feed.len() {
            return Err(tr!(
                "the recording has {count} samples: allowed are {least} to {most}",
                count = count,
                least = least,
                most = most
            ));
        }
        if !(self.period_s > 0.0 && self.period_s.is_finite()) {
            return Err(tr!("a period of {period} s", period = self.period_s));
        }
        if self.command.iter().chain(&self.feed).any(|x| !x.is_finite()) {
            return Err(tr("the recording has samples that are no numbers").to_owned());
        }
        if self.command.iter().all(|x| *x == self.command[0]) {
            return Err(tr("the command never changes: record a step").to_owned());
        }
        Ok(())
    }
}

/// The fits of all structures, one after the other.
#[derive(Clone, Debug)]
pub struct DriveSearch {
    recording: DriveRecording,
    fits: Vec<DriveFit>,
}

impl DriveSearch {
    /// Begins.
    ///
    /// # Errors
    /// The recording is too short or too long, has samples that are no numbers, or its command never changes.
    pub fn new(recording: DriveRecording) -> Result<Self, String> {
        recording.check()?;
        Ok(Self { recording, fits: Vec::new() })
    }

    /// The recording.
    #[must_use]
    pub fn recording(&self) -> &DriveRecording {
        &self.recording
    }

    /// Fits the next structure; `true` while there are more.
    pub fn step(&mut self) -> bool {
        let next = DriveStructure::ALL.get(self.fits.len());
        self.fits.extend(next.map(|structure| fitted(*structure, &self.recording)));
        self.fits.len() < DriveStructure::ALL.len()
    }

    /// What was fitted; the one to take comes first.
    #[must_use]
    pub fn fits(&self) -> Vec<DriveFit> {
        let mut fits = self.fits.clone();
        fits.sort_by(|a, b| a.bic.total_cmp(&b.bic));
        fits
    }
}

/// Fits all structures; the one to take comes first.
///
/// # Errors
/// As [`DriveSearch::new`].
pub fn identify_drive(recording: &DriveRecording) -> Result<Vec<DriveFit>, String> {
    let mut search = DriveSearch::new(recording.clone())?;
    while search.step() {}
    Ok(search.fits())
}

#[cfg(test)]
mod tests;
