//! Nonlinear least squares: Gauss-Newton steps with Levenberg's damping, on a few parameters.

use nalgebra::{SMatrix, SVector};

/// Step of the central differences, relative to parameters of size one.
const DIFFERENCE: f64 = 1e-5;
const MAX_STEPS: usize = 500;

/// Minimises the sum of squared residuals from `start`; parameters should be of size one. Ends when
/// no damping makes a step that improves the sum by more than one part in 10^12.
pub(super) fn minimise<const N: usize>(
    start: SVector<f64, N>,
    residuals: impl Fn(&SVector<f64, N>) -> Vec<f64>,
) -> SVector<f64, N> {
    let sum = |r: &[f64]| r.iter().map(|x| x * x).sum::<f64>();
    let mut at = start;
    let mut here = residuals(&at);
    let mut damping = 1e-3;
    for _ in 0..MAX_STEPS {
        let columns: Vec<Vec<f64>> = (0..N)
            .map(|i| {
                let mut step = SVector::zeros();
                step[i] = DIFFERENCE;
                let (up, down) = (residuals(&(at + step)), residuals(&(at - step)));
                up.iter().zip(&down).map(|(u, d)| (u - d) / (2.0 * DIFFERENCE)).collect()
            })
            .collect();
        let mut normal = SMatrix::<f64, N, N>::zeros();
        let mut right = SVector::<f64, N>::zeros();
        for (k, residual) in here.iter().enumerate() {
            let row = SVector::<f64, N>::from_fn(|i, _| columns[i][k]);
            normal += row * row.transpose();
            right -= row * *residual;
        }
        let mut improved = false;
        while damping < 1e9 {
            let damped = normal + SMatrix::<f64, N, N>::identity() * damping;
            if let Some(step) = damped.cholesky().map(|factor| factor.solve(&right)) {
                let next = residuals(&(at + step));
                if sum(&next) < sum(&here) * (1.0 - 1e-12) {
                    at += step;
                    here = next;
                    damping *= 0.2;
                    improved = true;
                    break;
                }
            }
            damping *= 5.0;
        }
        if !improved {
            break;
        }
    }
    at
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector2;

    #[test]
    fn it_finds_the_minimum_of_rosenbrock_s_valley() {
        let residuals = |p: &Vector2<f64>| vec![10.0 * (p[1] - p[0] * p[0]), 1.0 - p[0]];
        let found = minimise(Vector2::new(-1.2, 1.0), residuals);
        assert!((found - Vector2::new(1.0, 1.0)).norm() < 1e-6, "{found}");
    }
}
