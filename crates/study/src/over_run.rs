//! A measured channel laid over a signal of a run, as the command `measured` and the console's plots have it:
//!
//! ```text
//! measured(t) = offset + scale run(t - shift) + rest
//! ```

use crate::base::stats;
use crate::measured::channel::{MeasuredChannel, SampleTimes};
use crate::measured::fault::DataFault;
use crate::measured::signal::align::align;
use crate::measured::signal::filled;
use crate::run::recording::Recording;
use crate::run::signals::SignalInfo;

/// How a measured channel lies over a signal of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OverRun {
    /// So much later the measurement is, s.
    pub shift_s: f64,
    /// What the signal is multiplied by; not 0.
    pub scale: f64,
    /// What is added then, in the channel's unit.
    pub offset: f64,
}

impl Default for OverRun {
    /// As it was measured.
    fn default() -> Self {
        Self { shift_s: 0.0, scale: 1.0, offset: 0.0 }
    }
}

impl OverRun {
    /// A time of the measurement in that of the run, both in s.
    #[must_use]
    pub fn run_s(&self, measured_s: f64) -> f64 {
        measured_s - self.shift_s
    }

    /// A time of the run in that of the measurement, both in s.
    #[must_use]
    pub fn measured_s(&self, run_s: f64) -> f64 {
        run_s + self.shift_s
    }

    /// A measured value as the run's signal has it.
    #[must_use]
    pub fn value(&self, measured: f64) -> f64 {
        (measured - self.offset) / self.scale
    }
}

/// How well it lies there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OverRunFit {
    /// How it lies.
    pub place: OverRun,
    /// Correlation of both over what they have in common, from -1 to 1.
    pub correlation: f64,
    /// Root mean square of what is left, in the channel's unit.
    pub rest: f64,
    /// Samples that both have there, one in every row of the run.
    pub samples: usize,
}

/// A signal of a run as a channel; a row without a value has a sample that is not a number.
#[must_use]
pub fn channel_of(recording: &Recording, signal: &SignalInfo) -> MeasuredChannel {
    let values = recording.rows().iter().map(|row| (signal.value)(row).unwrap_or(f64::NAN));
    MeasuredChannel {
        name: signal.id.to_owned(),
        unit: signal.unit.to_owned(),
        times: SampleTimes::Even { rate_hz: 1.0 / recording.row_s(), first_s: 0.0 },
        values: values.collect(),
    }
}

/// The values of a signal in the rows of a run, filled in where it has none.
///
/// # Errors
/// It has none in any row.
pub fn reference(recording: &Recording, signal: &SignalInfo) -> Result<Vec<f64>, DataFault> {
    Ok(filled(&channel_of(recording, signal))?.0)
}

/// The time of the first sample of a channel, s; 0 where it has none.
fn first_s(channel: &MeasuredChannel) -> f64 {
    channel.times.at(0).unwrap_or(0.0)
}

/// Lays a channel with one sample in every row of a run over a signal, at the shift at which both go together most.
///
/// # Errors
/// One of them is too short, or nowhere do they go together.
pub fn aligned(
    channel: &MeasuredChannel,
    reference: &[f64],
    row_s: f64,
) -> Result<OverRunFit, DataFault> {
    let most_s = (channel.values.len() + reference.len()) as f64 * row_s;
    let found = align(&channel.values, reference, 1.0 / row_s, most_s)?;
    let place = OverRun {
        // Counted from the run's first row, not from the channel's first sample.
        shift_s: found.shift_s + first_s(channel),
        scale: found.scale,
        offset: found.offset,
    };
    Ok(OverRunFit {
        place,
        correlation: found.correlation,
        rest: found.rest,
        samples: found.samples,
    })
}

/// How well a channel with one sample in every row of a run lies over a signal at a place; none where they have nothing
/// in common there.
#[must_use]
pub fn judged(
    channel: &MeasuredChannel,
    reference: &[f64],
    row_s: f64,
    place: OverRun,
) -> Option<OverRunFit> {
    let lag = (place.shift_s - first_s(channel)) / row_s;
    let at = |sample: usize| {
        let row = sample as f64 - lag;
        let before = row.floor();
        let inside = before >= 0.0 && before + 1.0 < reference.len() as f64;
        inside.then(|| {
            let (i, share) = (before as usize, row - before);
            reference[i] + share * (reference[i + 1] - reference[i])
        })
    };
    let samples = channel.values.iter().enumerate();
    let (xs, ys): (Vec<f64>, Vec<f64>) =
        samples.filter_map(|(sample, y)| Some((at(sample)?, *y))).unzip();
    let left = xs.iter().zip(&ys).map(|(x, y)| y - place.offset - place.scale * x);
    let rest = stats::rms(left)?;
    let correlation = stats::correlation(&xs, &ys).unwrap_or(0.0);
    Some(OverRunFit { place, correlation, rest, samples: xs.len() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measured::signal::periods::resampled;
    use crate::run::edits::Edits;
    use crate::run::job::Job as _;
    use crate::run::one_run::Run;
    use crate::run::presets;
    use crate::run::signals::signal;

    #[test]
    fn what_was_found_is_judged_as_it_was_found_and_any_other_place_is_worse() {
        let mut run = Run::new(&presets::load("depth-step").unwrap(), &Edits::none());
        run.to_end();
        let recording = run.recording();
        let row_s = recording.row_s();
        let force = signal("force_n").unwrap();
        let reference = reference(recording, force).unwrap();
        // At another rate, later, larger, and as if it had begun before the clock.
        let known = OverRun { shift_s: -0.85, scale: 1.3, offset: 12.0 };
        let step_s = 0.4 * row_s;
        let value = |i: usize| {
            let row = (i as f64 * step_s / row_s).min((reference.len() - 2) as f64);
            let (before, share) = (row as usize, row - row.floor());
            let x = reference[before] + share * (reference[before + 1] - reference[before]);
            known.offset + known.scale * x
        };
        let count = (reference.len() as f64 / 0.4) as usize;
        let measured = MeasuredChannel {
            name: "Fx".to_owned(),
            unit: "N".to_owned(),
            times: SampleTimes::Even { rate_hz: 1.0 / step_s, first_s: known.shift_s },
            values: (0..count).map(value).collect(),
        };
        let channel = resampled(&measured, row_s).unwrap();
        let found = aligned(&channel, &reference, row_s).unwrap();
        assert!((found.place.shift_s - known.shift_s).abs() < 0.5 * row_s, "{found:?}");
        assert!((found.place.scale - known.scale).abs() < 0.02, "{found:?}");
        let again = judged(&channel, &reference, row_s, found.place).unwrap();
        assert_eq!(again.samples, found.samples);
        for (again, found) in [(again.rest, found.rest), (again.correlation, found.correlation)] {
            assert!((again - found).abs() < 1e-6 * (1.0 + found.abs()), "{again} {found}");
        }
        let moved = OverRun { shift_s: found.place.shift_s + 1.0, ..found.place };
        assert!(judged(&channel, &reference, row_s, moved).unwrap().rest > 2.0 * found.rest);
        let far = OverRun { shift_s: 1e6, ..found.place };
        assert_eq!(judged(&channel, &reference, row_s, far), None);
        let y = known.offset + known.scale * 100.0;
        assert!((known.value(y) - 100.0).abs() < 1e-12);
        assert!((known.run_s(known.measured_s(3.0)) - 3.0).abs() < 1e-12);
    }
}
