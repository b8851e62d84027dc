//! The fit of one structure: simulated exactly, with a dead time of any length, and least squares from several starts.

use nalgebra::SVector;

use super::{DriveFit, DriveRecording, DriveStructure};
use crate::base::math;
use crate::identify::estimate::LinearisedFit;
use crate::identify::least_squares::minimise;
use crate::models::feed_drive::{DriveState, ExactDrive};

/// How far parameters may go from where they begin: by a factor of e^6.
const FARTHEST: f64 = 6.0;
/// Step of the central differences of the Jacobian, of parameters of size one.
const DIFFERENCE: f64 = 1e-4;
/// Shares of the time to the first movement that the dead time begins with.
const STARTS: [f64; 3] = [0.95, 0.6, 0.2];

/// The drive's answer to a recording's command, with gain 1.
fn answer(
    recording: &DriveRecording,
    dead_time_s: f64,
    structure: DriveStructure,
    parameters: &[f64],
) -> Vec<f64> {
    let samples = (dead_time_s / recording.period_s).max(0.0);
    let whole = samples.floor();
    let part = samples - whole;
    let (a, order) = structure.denominator(parameters);
    // What a sample commands reaches the drive within another one: the older command acts first.
    let older = ExactDrive::of(a, order, part * recording.period_s);
    let newer = ExactDrive::of(a, order, (1.0 - part) * recording.period_s);
    let command = |k: usize, back: usize| recording.command[k.saturating_sub(back)];
    let back = whole.min(1e9) as usize;
    let mut state = DriveState::settled(recording.command[0]);
    let mut feeds = vec![recording.command[0]];
    for k in 1..recording.command.len() {
        if part > 0.0 {
            older.advance(&mut state, command(k, back + 1));
        }
        newer.advance(&mut state, command(k, back));
        feeds.push(state.feed_mm_min());
    }
    feeds
}

/// Time of the first change of the command, and times from it on until the feed has moved by 5 % and by 63 %, s.
fn moved(recording: &DriveRecording) -> [f64; 2] {
    let first = recording.command[0];
    let changed = recording.command.iter().position(|x| *x != first).unwrap_or(0);
    let range = recording
        .feed
        .iter()
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(*x), high.max(*x)]);
    let size = range[1] - range[0];
    // A mean over some samples, so that noise does not move.
    let mean = |at: usize| {
        let about = &recording.feed[at.saturating_sub(2)..(at + 3).min(recording.feed.len())];
        about.iter().sum::<f64>() / about.len() as f64
    };
    let base = mean(changed.saturating_sub(1));
    let until = |share: f64| {
        let at = (changed..recording.feed.len()).find(|k| (mean(*k) - base).abs() > share * size);
        (at.unwrap_or(recording.feed.len() - 1) - changed) as f64 * recording.period_s
    };
    [until(0.1), until(0.6).max(until(0.1) + 2.0 * recording.period_s)]
}

/// Parameters of size one around a start: dead time, gain, the structure's own.
struct Scaled<'a> {
    recording: &'a DriveRecording,
    structure: DriveStructure,
    dead_time_s: f64,
    lag_s: f64,
    gain: f64,
    start: Vec<f64>,
    size: f64,
}

impl Scaled<'_> {
    fn dead_time_s(&self, x: &[f64]) -> f64 {
        (self.dead_time_s + x[0] * self.lag_s).max(0.0)
    }

    fn gain(&self, x: &[f64]) -> f64 {
        self.gain + x[1]
    }

    fn own(&self, x: &[f64]) -> Vec<f64> {
        let far = |x: &f64| math::exp(x.clamp(-FARTHEST, FARTHEST));
        self.start.iter().zip(&x[2..]).map(|(start, x)| start * far(x)).collect()
    }

    fn residuals(&self, x: &[f64]) -> Vec<f64> {
        let own = self.own(x);
        let answer = answer(self.recording, self.dead_time_s(x), self.structure, &own);
        let gain = self.gain(x);
        self.recording
            .feed
            .iter()
            .zip(answer)
            .map(|(feed, answer)| (feed - gain * answer) / self.size)
            .collect()
    }
}

/// Fits a structure.
pub(super) fn fitted(structure: DriveStructure, recording: &DriveRecording) -> DriveFit {
    match structure {
        DriveStructure::First | DriveStructure::Critical => of::<3>(structure, recording),
        DriveStructure::Second => of::<4>(structure, recording),
        DriveStructure::Third => of::<5>(structure, recording),
    }
}

fn of<const N: usize>(structure: DriveStructure, recording: &DriveRecording) -> DriveFit {
    let [first_s, most_s] = moved(recording);
    let lag_s = most_s - first_s;
    let last = |values: &[f64]| values[values.len() - 1];
    let (told, did) = (last(&recording.command), last(&recording.feed));
    let gain = if told == 0.0 { 1.0 } else { did / told };
    let largest = |values: &[f64]| values.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    let size = largest(&recording.feed).max(f64::MIN_POSITIVE);
    let squares = |r: &[f64]| r.iter().map(|x| x * x).sum::<f64>();
    let mut best: Option<(Scaled<'_>, SVector<f64, N>, f64)> = None;
    for share in STARTS {
        let scaled = Scaled {
            recording,
            structure,
            dead_time_s: share * first_s,
            lag_s,
            gain,
            start: structure.start(lag_s + (1.0 - share) * first_s),
            size,
        };
        let found = minimise(SVector::<f64, N>::zeros(), |x| scaled.residuals(x.as_slice()));
        let sum = squares(&scaled.residuals(found.as_slice()));
        if best.as_ref().is_none_or(|(_, _, least)| sum < *least) {
            best = Some((scaled, found, sum));
        }
    }
    let Some((scaled, found, sum)) = best else { unreachable!("there are starts") };
    told_of(&scaled, &found, sum)
}

/// The fit with its intervals and criteria.
fn told_of<const N: usize>(scaled: &Scaled<'_>, found: &SVector<f64, N>, sum: f64) -> DriveFit {
    let x = found.as_slice();
    let residuals = scaled.residuals(x);
    let n = residuals.len() as f64;
    let fit = LinearisedFit::new(x, &[DIFFERENCE; N], &|x| scaled.residuals(x));
    let estimated = |of: &dyn Fn(&[f64]) -> f64| fit.estimated(of);
    let own = scaled.own(x);
    let structure = scaled.structure;
    let parameters = structure.parameters().iter().enumerate();
    let parameters =
        parameters.map(|(i, (name, unit))| (*name, *unit, estimated(&|x| scaled.own(x)[i])));
    // Nothing is left of a recording that was made by the structure itself.
    let log = math::ln((sum / n).max(f64::MIN_POSITIVE));
    DriveFit {
        structure,
        dead_time_s: estimated(&|x| scaled.dead_time_s(x)),
        lag_s: estimated(&|x| structure.lag_s(&scaled.own(x))),
        gain: estimated(&|x| scaled.gain(x)),
        parameters: parameters.collect(),
        poles: structure.poles(&own),
        rest: (sum / n).sqrt() * scaled.size,
        aic: n * log + 2.0 * N as f64,
        bic: n * log + N as f64 * math::ln(n),
        residuals: residuals.iter().map(|r| r * scaled.size).collect(),
    }
}
