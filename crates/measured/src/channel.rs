//! Channels: what was measured, with its unit and the times of its samples.

use std::sync::Arc;

/// How far a step between two samples may be from the others, as a share of a step, for them to count as even.
const EVEN: f64 = 0.05;

/// When the samples of a channel were taken.
#[derive(Clone, Debug, PartialEq)]
pub enum SampleTimes {
    /// The file does not tell.
    Unknown,
    /// One after the other at the same distance.
    Even {
        /// Samples in a second.
        rate_hz: f64,
        /// Time of the first, s.
        first_s: f64,
    },
    /// At these times, s.
    Given(Arc<[f64]>),
}

impl SampleTimes {
    /// What a column of times in s says: even where no sample is further off than a twentieth of a step, so that times
    /// that were rounded as they were written count as even.
    #[must_use]
    pub fn of(times_s: &[f64]) -> Self {
        let (Some(first_s), Some(last_s)) = (times_s.first(), times_s.last()) else {
            return Self::Unknown;
        };
        let step_s = (last_s - first_s) / times_s.len().saturating_sub(1).max(1) as f64;
        let even = |(i, time_s): (usize, &f64)| {
            (time_s - (first_s + i as f64 * step_s)).abs() <= EVEN * step_s
        };
        if step_s > 0.0 && step_s.is_finite() && times_s.iter().enumerate().all(even) {
            return Self::Even { rate_hz: rounded(1.0 / step_s), first_s: *first_s };
        }
        Self::Given(times_s.into())
    }

    /// The time of a sample, s.
    #[must_use]
    pub fn at(&self, sample: usize) -> Option<f64> {
        match self {
            Self::Unknown => None,
            Self::Even { rate_hz, first_s } => Some(first_s + sample as f64 / rate_hz),
            Self::Given(times) => times.get(sample).copied(),
        }
    }

    /// Samples in a second; none where they are not even.
    #[must_use]
    pub fn rate_hz(&self) -> Option<f64> {
        match self {
            Self::Even { rate_hz, .. } => Some(*rate_hz),
            Self::Unknown | Self::Given(_) => None,
        }
    }
}

/// A rate without the dust that times written in decimals leave on it: the nearest whole one where that is as good.
fn rounded(rate_hz: f64) -> f64 {
    let whole = rate_hz.round();
    if (rate_hz - whole).abs() < 1e-6 * rate_hz { whole } else { rate_hz }
}

/// What one sensor has measured.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredChannel {
    /// Its name.
    pub name: String,
    /// Its unit as the file has it; empty where none is told.
    pub unit: String,
    /// When its samples were taken.
    pub times: SampleTimes,
    /// Its samples; not a number where one is missing.
    pub values: Vec<f64>,
}

/// Least, mean and largest of a channel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChannelSummary {
    /// Samples with a value.
    pub count: usize,
    /// Samples without one.
    pub missing: usize,
    /// The least value; not a number without any.
    pub min: f64,
    /// Their mean; not a number without any.
    pub mean: f64,
    /// The largest value; not a number without any.
    pub max: f64,
}

impl MeasuredChannel {
    /// Least, mean and largest value.
    #[must_use]
    pub fn summary(&self) -> ChannelSummary {
        let there = || self.values.iter().copied().filter(|x| !x.is_nan());
        let count = there().count();
        let sum: f64 = there().sum();
        ChannelSummary {
            count,
            missing: self.values.len() - count,
            min: there().fold(f64::NAN, f64::min),
            mean: if count == 0 { f64::NAN } else { sum / count as f64 },
            max: there().fold(f64::NAN, f64::max),
        }
    }

    /// Name and unit as a header has them: `Fx [N]`.
    #[must_use]
    pub fn title(&self) -> String {
        if self.unit.is_empty() {
            self.name.clone()
        } else {
            format!("{} [{}]", self.name, self.unit)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_that_were_rounded_are_even_and_others_are_kept() {
        let written: Vec<f64> = (0..2000).map(|i| (i as f64 * 4e-5 * 1e6).round() / 1e6).collect();
        let times = SampleTimes::of(&written);
        assert_eq!(times, SampleTimes::Even { rate_hz: 25_000.0, first_s: 0.0 });
        assert_eq!(times.at(5), Some(5.0 / 25_000.0));
        let uneven = SampleTimes::of(&[0.0, 1.0, 3.0]);
        assert_eq!((uneven.at(2), uneven.rate_hz()), (Some(3.0), None));
        assert_eq!(SampleTimes::of(&[]), SampleTimes::Unknown);
        assert!(matches!(SampleTimes::of(&[2.0, 1.0]), SampleTimes::Given(_)));
        assert!(matches!(SampleTimes::of(&[0.0, f64::NAN, 2.0]), SampleTimes::Given(_)));
    }

    #[test]
    fn a_summary_leaves_missing_samples_out() {
        let channel = |values: &[f64]| MeasuredChannel {
            name: "F".to_owned(),
            unit: "N".to_owned(),
            times: SampleTimes::Unknown,
            values: values.to_vec(),
        };
        let told = channel(&[1.0, f64::NAN, 3.0]).summary();
        assert_eq!((told.count, told.missing), (2, 1));
        assert_eq!([told.min, told.mean, told.max], [1.0, 2.0, 3.0]);
        assert!(channel(&[]).summary().mean.is_nan());
        assert_eq!(channel(&[]).title(), "F [N]");
    }
}
