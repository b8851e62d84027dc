//! What is done with channels before anything is fitted to them, each step by itself: [`Preparation`] has them in their
//! order.
//!
//! | question | module |
//! | --- | --- |
//! | What was a dynamometer's axis, seen from the machine? | [`rotate`] |
//! | What did the charge amplifier add? | [`drift`] |
//! | What lies above the frequencies that matter? | [`low_pass`] |
//! | What does a control period see? | [`periods`] |
//! | When did the measurement begin, seen from a run, and how large is it? | [`align`] |

pub mod align;
pub mod drift;
pub mod low_pass;
pub mod periods;
mod prepare;
pub mod rotate;

pub use prepare::Preparation;

use crate::base::language::tr;
use crate::channel::MeasuredChannel;
use crate::fault::{DataFault, FaultPlace};

/// A fault of a channel.
pub(crate) fn fault(
    channel: &MeasuredChannel,
    found: String,
    expected: impl Into<String>,
) -> DataFault {
    DataFault::new(FaultPlace::Entry(channel.name.clone()), found, expected)
}

/// Samples in a second and the time of the first, s, of a channel that has them.
///
/// # Errors
/// Its samples are not even, or their times unknown.
pub(crate) fn even(channel: &MeasuredChannel) -> Result<(f64, f64), DataFault> {
    match (channel.times.rate_hz(), channel.times.at(0)) {
        (Some(rate_hz), Some(first_s)) => Ok((rate_hz, first_s)),
        (None, _) | (_, None) => {
            let found = tr("samples that are not even in time, or whose times are not known");
            Err(fault(channel, found.to_owned(), tr("a sample rate: rate_hz in the layout")))
        }
    }
}

/// The samples with what is missing filled in on the line between its neighbours, at the ends by the nearest; and how
/// many these were.
///
/// # Errors
/// There is no sample at all.
pub fn filled(channel: &MeasuredChannel) -> Result<(Vec<f64>, usize), DataFault> {
    let mut values = channel.values.clone();
    let there: Vec<usize> = (0..values.len()).filter(|i| !values[*i].is_nan()).collect();
    let (Some(first), Some(last)) = (there.first().copied(), there.last().copied()) else {
        return Err(fault(channel, tr("no samples").to_owned(), tr("at least one")));
    };
    let missing = values.len() - there.len();
    values[..first].fill(channel.values[first]);
    values[last..].fill(channel.values[last]);
    for pair in there.windows(2) {
        let &[a, b] = pair else { continue };
        let (from, to) = (channel.values[a], channel.values[b]);
        for (i, value) in values.iter_mut().enumerate().take(b).skip(a + 1) {
            *value = from + (to - from) * (i - a) as f64 / (b - a) as f64;
        }
    }
    Ok((values, missing))
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::channel::SampleTimes;

    /// A channel of even samples.
    pub(crate) fn channel(name: &str, rate_hz: f64, values: Vec<f64>) -> MeasuredChannel {
        let times = SampleTimes::Even { rate_hz, first_s: 0.0 };
        MeasuredChannel { name: name.to_owned(), unit: "N".to_owned(), times, values }
    }

    #[test]
    fn what_is_missing_lies_between_its_neighbours() {
        const NO: f64 = f64::NAN;
        let holes = channel("F", 10.0, vec![NO, 1.0, NO, NO, 4.0, NO]);
        assert_eq!(filled(&holes).unwrap(), (vec![1.0, 1.0, 2.0, 3.0, 4.0, 4.0], 4));
        assert!(
            filled(&channel("F", 1.0, vec![NO]))
                .unwrap_err()
                .to_string()
                .contains("`F`: no samples")
        );
    }
}
