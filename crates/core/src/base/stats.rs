//! Statistics of samples, one convention for each:
//!
//! ```text
//! mean                 m = sum x / n
//! root mean square     sqrt(sum x^2 / n)
//! standard deviation   s = sqrt(sum (x - m)^2 / (n - 1)), that of a sample; 0 for a single value
//! correlation          r = sum (x - m_x)(y - m_y) / sqrt(sum (x - m_x)^2 sum (y - m_y)^2) (Pearson)
//! quantile of share p  x_(k) + (h - k)(x_(k+1) - x_(k)), h = (n - 1) p + 1, k = floor h
//! ```
//!
//! The quantile is that of type 7 of R. J. Hyndman and Y. Fan, Sample quantiles in statistical
//! packages, The American Statistician 50 (1996): between two values of the ascending sample it lies
//! on the line through both, as in R, NumPy and spreadsheets. The median is that of share 1/2.
//! Nothing is known of an empty sample: `None`.

/// The mean.
#[must_use]
pub fn mean(values: impl IntoIterator<Item = f64>) -> Option<f64> {
    let mut count = 0_usize;
    let sum: f64 = values.into_iter().inspect(|_| count += 1).sum();
    (count > 0).then(|| sum / count as f64)
}

/// The root mean square.
#[must_use]
pub fn rms(values: impl IntoIterator<Item = f64>) -> Option<f64> {
    mean(values.into_iter().map(|x| x * x)).map(f64::sqrt)
}

/// The standard deviation of a sample; 0 for a single value.
#[must_use]
pub fn deviation(values: &[f64]) -> Option<f64> {
    let mean = mean(values.iter().copied())?;
    let squares: f64 = values.iter().map(|x| (x - mean) * (x - mean)).sum();
    Some((squares / (values.len() - 1).max(1) as f64).sqrt())
}

/// The correlation coefficient of two series of one length; `None` where one does not vary.
#[must_use]
pub fn correlation(a: &[f64], b: &[f64]) -> Option<f64> {
    let n = a.len().min(b.len());
    let (a, b) = (&a[..n], &b[..n]);
    let (mean_a, mean_b) = (mean(a.iter().copied())?, mean(b.iter().copied())?);
    let sum = |of: fn(f64, f64) -> f64| {
        a.iter().zip(b).map(|(x, y)| of(x - mean_a, y - mean_b)).sum::<f64>()
    };
    let squares = sum(|x, _| x * x) * sum(|_, y| y * y);
    (squares > 0.0).then(|| sum(|x, y| x * y) / squares.sqrt())
}

/// The median of values in any order.
#[must_use]
pub fn median(values: impl IntoIterator<Item = f64>) -> Option<f64> {
    Sorted::new(values).quantile(0.5)
}

/// A sample in ascending order, sorted once for all its quantiles.
#[derive(Clone, Debug, PartialEq)]
pub struct Sorted(Vec<f64>);

impl Sorted {
    /// Sorts a sample.
    #[must_use]
    pub fn new(values: impl IntoIterator<Item = f64>) -> Self {
        let mut values: Vec<f64> = values.into_iter().collect();
        values.sort_by(f64::total_cmp);
        Self(values)
    }

    /// The values, the least first.
    #[must_use]
    pub fn values(&self) -> &[f64] {
        &self.0
    }

    /// The value below which `share` of the sample lies, from 0 (the least) to 1 (the largest).
    #[must_use]
    pub fn quantile(&self, fraction: f64) -> Option<f64> {
        let last = self.0.len().checked_sub(1)?;
        let place = fraction.clamp(0.0, 1.0) * last as f64;
        let below = self.0[place as usize];
        let above = self.0[(place as usize + 1).min(last)];
        let weight = place - place.floor();
        // On a value, and between equal ones (which may be infinite), there is nothing to draw.
        Some(if weight == 0.0 || below == above { below } else { below + weight * (above - below) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_are_those_of_type_7() {
        // R: quantile(c(15, 20, 35, 40, 50), c(.05, .3, .4, .5, 1)), type 7 by default.
        let sorted = Sorted::new([40.0, 15.0, 50.0, 20.0, 35.0]);
        for (fraction, expected) in
            [(0.0, 15.0), (0.05, 16.0), (0.3, 23.0), (0.4, 29.0), (1.0, 50.0)]
        {
            let found = sorted.quantile(fraction).unwrap();
            assert!((found - expected).abs() < 1e-12, "{fraction}: {found}");
        }
        assert_eq!(sorted.quantile(0.5), Some(35.0));
        assert_eq!(median([4.0, 1.0, 3.0, 2.0]), Some(2.5));
        assert_eq!(Sorted::new([7.0]).quantile(0.95), Some(7.0));
        assert_eq!(median([]), None);
        // Runs without a result count as infinitely bad.
        let bad = Sorted::new([1.0, f64::INFINITY, 2.0, f64::INFINITY]);
        assert_eq!(
            (bad.quantile(1.0), bad.quantile(0.9)),
            (Some(f64::INFINITY), Some(f64::INFINITY))
        );
        assert_eq!(bad.quantile(1.0 / 3.0), Some(2.0));
    }

    #[test]
    fn moments_are_those_of_a_sample() {
        let values = [2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0];
        assert_eq!(mean(values), Some(5.0));
        assert_eq!(rms([3.0, -4.0, 0.0, 0.0]), Some(2.5));
        assert!((deviation(&values).unwrap() - (32.0_f64 / 7.0).sqrt()).abs() < 1e-15);
        assert_eq!((deviation(&[3.0]), deviation(&[])), (Some(0.0), None));
        assert_eq!((mean([]), rms([])), (None, None));
    }

    #[test]
    fn correlation_is_pearson_s() {
        let a = [1.0, 2.0, 3.0, 5.0];
        assert!((correlation(&a, &a.map(|x| 3.0 - 2.0 * x)).unwrap() + 1.0).abs() < 1e-15);
        // By hand: sums of products 5.5, of squares 8.75 and 5.
        let found = correlation(&a, &[1.0, 3.0, 2.0, 4.0]).unwrap();
        assert!((found - 5.5 / (8.75_f64 * 5.0).sqrt()).abs() < 1e-15, "{found}");
        assert_eq!(correlation(&a, &[2.0; 4]), None);
        assert_eq!(correlation(&[], &[]), None);
    }
}
