//! The spread of a measure over the seeds.

use serde::Serialize;

use crate::base::stats::{self, Sorted};

/// The spread of values over the seeds, as a box plot shows it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Spread {
    /// Number of values.
    pub runs: usize,
    /// Mean.
    pub mean: f64,
    /// Standard deviation of the sample; 0 for a single value.
    pub deviation: f64,
    /// Least value.
    pub least: f64,
    /// A quarter of the values lie below it.
    pub lower_quartile: f64,
    /// Half of the values lie below it.
    pub median: f64,
    /// Three quarters of the values lie below it.
    pub upper_quartile: f64,
    /// Largest value.
    pub largest: f64,
}

impl Spread {
    /// The spread of finite values; none without any.
    #[must_use]
    pub fn of(values: &[f64]) -> Option<Self> {
        let sorted = Sorted::new(values.iter().copied());
        Some(Self {
            runs: values.len(),
            mean: stats::mean(sorted.values().iter().copied())?,
            deviation: stats::deviation(sorted.values())?,
            least: sorted.quantile(0.0)?,
            lower_quartile: sorted.quantile(0.25)?,
            median: sorted.quantile(0.5)?,
            upper_quartile: sorted.quantile(0.75)?,
            largest: sorted.quantile(1.0)?,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_spread_is_that_of_its_values() {
        let spread = Spread::of(&[4.0, 1.0, 2.0, 3.0, 5.0]).unwrap();
        assert_eq!((spread.least, spread.median, spread.largest), (1.0, 3.0, 5.0));
        assert_eq!((spread.lower_quartile, spread.upper_quartile), (2.0, 4.0));
        assert_eq!((spread.mean, spread.runs), (3.0, 5));
        assert!((spread.deviation - 2.5_f64.sqrt()).abs() < 1e-15);
        assert_eq!(Spread::of(&[7.0]).unwrap().deviation, 0.0);
        assert_eq!(Spread::of(&[1.0, 2.0]).unwrap().lower_quartile, 1.25);
        assert_eq!(Spread::of(&[]), None);
    }
}
