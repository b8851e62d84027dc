//! What a fit by least squares tells of its parameters: values with intervals of 95 %, and which of them it cannot tell
//! apart.
//!
//! ```text
//! C = s^2 (J' J)^-1,  s^2 = S/(N - p)        y +- t sqrt(g' C g),  g = dy/dx
//! ```
//!
//! of the Jacobian J of N residuals by p parameters x, with t the 97.5 % point of Student's distribution of N - p degrees
//! of freedom (Seber and Wild, Nonlinear Regression, 1989, section 5.1). The intervals take what is left for noise from
//! sample to sample; where the model does not fit, they are too narrow. How far parameters can be told apart says the
//! condition of J with columns of length one (Belsley, Kuh and Welsch, Regression Diagnostics, 1980).

use nalgebra::{DMatrix, DVector, SymmetricEigen};

use super::gp::constants::t_quantile;

/// A quantity with the half of its 95 % interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EstimatedValue {
    /// The value.
    pub value: f64,
    /// Half of the interval; none where the recording does not determine it.
    pub half: Option<f64>,
}

impl EstimatedValue {
    /// A value that is given, not estimated.
    #[must_use]
    pub fn given(value: f64) -> Self {
        Self { value, half: None }
    }
}

/// Share of the variation of samples about their mean that is not left: R^2.
pub(super) fn explained(samples: &[f64], left: &[f64]) -> f64 {
    let mean = samples.iter().sum::<f64>() / samples.len().max(1) as f64;
    let all: f64 = samples.iter().map(|x| (x - mean) * (x - mean)).sum();
    1.0 - dot(left, left) / all.max(f64::MIN_POSITIVE)
}

/// A fit, linearised where it was found.
#[derive(Clone, Debug)]
pub(super) struct LinearisedFit {
    found: Vec<f64>,
    differences: Vec<f64>,
    /// Columns of the Jacobian.
    columns: Vec<Vec<f64>>,
    covariance: Option<DMatrix<f64>>,
    quantile: f64,
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Slope of something at a place by the step of one parameter.
fn slope<T>(
    at: &[f64],
    i: usize,
    step: f64,
    of: &dyn Fn(&[f64]) -> T,
    between: impl Fn(T, T) -> T,
) -> T {
    let moved = |by: f64| {
        let mut to = at.to_vec();
        to[i] += by;
        of(&to)
    };
    between(moved(step), moved(-step))
}

impl LinearisedFit {
    /// Linearises residuals about the parameters that were found, by central differences of these steps.
    pub fn new(found: &[f64], differences: &[f64], residuals: &dyn Fn(&[f64]) -> Vec<f64>) -> Self {
        let column = |i: usize| {
            let step = differences[i];
            slope(found, i, step, residuals, |up, down| {
                up.iter().zip(&down).map(|(u, d)| (u - d) / (2.0 * step)).collect()
            })
        };
        let columns: Vec<Vec<f64>> = (0..found.len()).map(column).collect();
        let here = residuals(found);
        let freedom = here.len().saturating_sub(found.len());
        let variance = dot(&here, &here) / freedom.max(1) as f64;
        let p = columns.len();
        let normal = DMatrix::from_fn(p, p, |i, j| dot(&columns[i], &columns[j]));
        let covariance = normal.try_inverse().map(|inverse| inverse * variance);
        Self {
            found: found.to_vec(),
            differences: differences.to_vec(),
            columns,
            covariance: covariance.filter(|_| freedom > 0),
            quantile: t_quantile(freedom),
        }
    }

    /// Something that follows from the parameters, with its interval.
    pub fn estimated(&self, of: &dyn Fn(&[f64]) -> f64) -> EstimatedValue {
        let slopes = (0..self.found.len()).map(|i| {
            let step = self.differences[i];
            slope(&self.found, i, step, of, |up, down| (up - down) / (2.0 * step))
        });
        let slopes = DVector::from_iterator(self.found.len(), slopes);
        let spread = self.covariance.as_ref().map(|covariance| slopes.dot(&(covariance * &slopes)));
        let half = spread.filter(|x| x.is_finite() && *x >= 0.0).map(|x| self.quantile * x.sqrt());
        EstimatedValue { value: of(&self.found), half }
    }

    /// Lengths of the columns of the Jacobian: how much of the residuals each parameter moves.
    pub fn lengths(&self) -> Vec<f64> {
        self.columns.iter().map(|column| dot(column, column).sqrt()).collect()
    }

    /// The condition of the Jacobian, and the share of every parameter in the direction that is told worst, from 0 to 1.
    pub fn weakest(&self) -> (f64, Vec<f64>) {
        let lengths = self.lengths();
        let p = lengths.len();
        if p == 0 {
            return (1.0, Vec::new());
        }
        let scaled = DMatrix::from_fn(p, p, |i, j| {
            let size = lengths[i] * lengths[j];
            if size > 0.0 { dot(&self.columns[i], &self.columns[j]) / size } else { 0.0 }
        });
        let eigen = SymmetricEigen::new(scaled);
        let least = (0..p).min_by(|a, b| eigen.eigenvalues[*a].total_cmp(&eigen.eigenvalues[*b]));
        let least = least.unwrap_or_default();
        let most = eigen.eigenvalues.iter().fold(0.0, |most: f64, x| most.max(*x));
        let condition = (most / eigen.eigenvalues[least].max(0.0)).sqrt();
        (condition, eigen.eigenvectors.column(least).iter().map(|x| x.abs()).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A straight line by hand: y = 1, 2, 2, 4 at x = 0, 1, 2, 3 has the slope 0.9 and the intercept 0.9, s^2 = 0.35.
    #[test]
    fn a_straight_line_has_the_intervals_of_the_textbook() {
        let points = [[0.0, 1.0], [1.0, 2.0], [2.0, 2.0], [3.0, 4.0]];
        let residuals =
            |p: &[f64]| points.iter().map(|[x, y]| p[0] + p[1] * x - y).collect::<Vec<f64>>();
        let fit = LinearisedFit::new(&[0.9, 0.9], &[1e-3, 1e-3], &residuals);
        let slope = fit.estimated(&|p| p[1]);
        // s^2/Sxx = 0.35/5, t of two degrees of freedom 4.303.
        let half = 4.302_652_73 * 0.07_f64.sqrt();
        assert!((slope.value - 0.9).abs() < 1e-12, "{slope:?}");
        assert!((slope.half.unwrap() / half - 1.0).abs() < 1e-6, "{slope:?} {half}");
        let (condition, shares) = fit.weakest();
        // Columns (1, 1, 1, 1) and (0, 1, 2, 3): cosine 6/(2 sqrt 14).
        let cosine = 6.0 / (2.0 * 14.0_f64.sqrt());
        let expected = ((1.0 + cosine) / (1.0 - cosine)).sqrt();
        assert!((condition / expected - 1.0).abs() < 1e-9, "{condition} {expected}");
        assert!(shares.iter().all(|share| (share - 0.5_f64.sqrt()).abs() < 1e-9), "{shares:?}");
    }

    #[test]
    fn what_moves_nothing_has_no_interval() {
        let residuals = |p: &[f64]| vec![p[0] - 1.0, p[0] - 1.1, p[0] - 0.9];
        let fit = LinearisedFit::new(&[1.0, 5.0], &[1e-3, 1e-3], &residuals);
        assert_eq!(fit.estimated(&|p| p[1]), EstimatedValue { value: 5.0, half: None });
        assert_eq!(fit.lengths()[1], 0.0);
        assert!(fit.weakest().0 > 1e6);
    }
}
