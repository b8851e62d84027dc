//! The spread of a measure over the seeds.

use serde::Serialize;

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
        let mut sorted = values.to_vec();
        sorted.sort_by(f64::total_cmp);
        let (least, largest) = (*sorted.first()?, *sorted.last()?);
        let n = sorted.len() as f64;
        let mean = sorted.iter().sum::<f64>() / n;
        let squares: f64 = sorted.iter().map(|x| (x - mean) * (x - mean)).sum();
        // Between two values the quantile is drawn as a line.
        let quantile = |share: f64| {
            let place = share * (n - 1.0);
            let below = sorted[place as usize];
            let above = sorted[(place as usize + 1).min(sorted.len() - 1)];
            below + (place - place.floor()) * (above - below)
        };
        Some(Self {
            runs: sorted.len(),
            mean,
            deviation: (squares / (n - 1.0).max(1.0)).sqrt(),
            least,
            lower_quartile: quantile(0.25),
            median: quantile(0.5),
            upper_quartile: quantile(0.75),
            largest,
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
