//! Symmetric positive definite systems by Cholesky's factors, A = L L'.
//!
//! By hand, since what it solves must have the same bits natively and in wasm: a library's kernels
//! for matrices whose size is known at run time only may be chosen by the processor.

/// Solves A x = b for A given by its lower half; `None` where a pivot does not exceed
/// `least_pivot`, that is, where A is not positive definite or its columns all but depend on each
/// other.
#[must_use]
pub fn solve(mut lower: Vec<Vec<f64>>, mut b: Vec<f64>, least_pivot: f64) -> Option<Vec<f64>> {
    let n = b.len();
    for i in 0..n {
        for j in 0..=i {
            let product: f64 = (0..j).map(|k| lower[i][k] * lower[j][k]).sum();
            let rest = lower[i][j] - product;
            lower[i][j] = if i > j {
                rest / lower[j][j]
            } else if rest > least_pivot {
                rest.sqrt()
            } else {
                return None;
            };
        }
        let known: f64 = (0..i).map(|k| lower[i][k] * b[k]).sum();
        b[i] = (b[i] - known) / lower[i][i];
    }
    for i in (0..n).rev() {
        let known: f64 = (i + 1..n).map(|k| lower[k][i] * b[k]).sum();
        b[i] = (b[i] - known) / lower[i][i];
    }
    Some(b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_solves_what_a_library_solves() {
        use nalgebra::{SMatrix, SVector};
        let a = SMatrix::<f64, 5, 5>::from_fn(|i, j| 1.0 / (i as f64 + j as f64 + 1.0));
        let a = a + SMatrix::identity() * 0.1;
        let b = SVector::<f64, 5>::from_fn(|i, _| i as f64 - 1.5);
        let expected = a.cholesky().unwrap().solve(&b);
        let lower = (0..5).map(|i| (0..=i).map(|j| a[(i, j)]).collect()).collect();
        let found = solve(lower, b.iter().copied().collect(), 0.0).unwrap();
        for (x, y) in found.iter().zip(expected.iter()) {
            assert!((x - y).abs() < 1e-13, "{x} {y}");
        }
    }

    #[test]
    fn what_is_not_positive_definite_has_no_solution() {
        let twice = vec![vec![1.0], vec![2.0, 4.0]];
        assert_eq!(solve(twice.clone(), vec![1.0, 2.0], 0.0), None);
        assert_eq!(solve(vec![vec![-1.0]], vec![1.0], 0.0), None);
        let nearly = vec![vec![1.0], vec![1.0, 1.0 + 1e-11]];
        assert_eq!(solve(nearly, vec![1.0, 1.0], 1e-10), None);
    }
}
