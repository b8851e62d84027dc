//! Nonlinear least squares: Gauss-Newton steps with Levenberg's damping, on a few parameters.

use nalgebra::allocator::Allocator;
use nalgebra::{DefaultAllocator, Dim, OMatrix, OVector, SVector};

/// Step of the central differences, relative to parameters of size one.
const DIFFERENCE: f64 = 1e-5;
/// Most steps, and the share of the sum that a step must gain.
const USUAL: Patience = Patience { steps: 500, gain: 1e-12 };

/// How long a minimum is searched for.
#[derive(Clone, Copy, Debug)]
pub(super) struct Patience {
    /// Most steps.
    pub steps: usize,
    /// The search ends when no damping makes a step that improves the sum by more than this share.
    pub gain: f64,
}

/// Minimises the sum of squared residuals from `start`; parameters should be of size one. Ends when
/// no damping makes a step that improves the sum by more than one part in 10^12.
pub(super) fn minimise<const N: usize>(
    start: SVector<f64, N>,
    residuals: impl Fn(&SVector<f64, N>) -> Vec<f64>,
) -> SVector<f64, N> {
    minimise_by(start, &[DIFFERENCE; N], USUAL, residuals)
}

/// The same for any number of parameters, each with the step of its central differences.
pub(super) fn minimise_by<D: Dim>(
    start: OVector<f64, D>,
    differences: &[f64],
    patience: Patience,
    residuals: impl Fn(&OVector<f64, D>) -> Vec<f64>,
) -> OVector<f64, D>
where
    DefaultAllocator: Allocator<D> + Allocator<D, D>,
{
    let sum = |r: &[f64]| r.iter().map(|x| x * x).sum::<f64>();
    let (dim, _) = start.shape_generic();
    let mut at = start;
    let mut here = residuals(&at);
    let mut damping = 1e-3;
    for _ in 0..patience.steps {
        let columns: Vec<Vec<f64>> = (0..at.len())
            .map(|i| {
                let moved = |by: f64| {
                    let mut to = at.clone();
                    to[i] += by;
                    residuals(&to)
                };
                let (up, down) = (moved(differences[i]), moved(-differences[i]));
                up.iter().zip(&down).map(|(u, d)| (u - d) / (2.0 * differences[i])).collect()
            })
            .collect();
        let mut normal = OMatrix::<f64, D, D>::zeros_generic(dim, dim);
        let mut right = OVector::<f64, D>::zeros_generic(dim, nalgebra::Const::<1>);
        for (k, residual) in here.iter().enumerate() {
            for i in 0..columns.len() {
                for j in 0..columns.len() {
                    normal[(i, j)] += columns[i][k] * columns[j][k];
                }
                right[i] -= columns[i][k] * *residual;
            }
        }
        let mut improved = false;
        while damping < 1e9 {
            let mut damped = normal.clone();
            for i in 0..columns.len() {
                damped[(i, i)] += damping;
            }
            if let Some(step) = damped.cholesky().map(|factor| factor.solve(&right)) {
                let next_at = &at + step;
                let next = residuals(&next_at);
                if sum(&next) < sum(&here) * (1.0 - patience.gain) {
                    at = next_at;
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
