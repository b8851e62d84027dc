//! The spectral radius of a linear map, by sums of our own in one order, so that the bits are the same everywhere.

use crate::base::dense::product;
use crate::base::math;

/// Vectors of the Krylov space that are made before its radius is looked at, and between looks.
const LOOK_EVERY: usize = 20;
/// Most vectors of the Krylov space.
const MOST_VECTORS: usize = 160;
/// Change of the radius between two looks that ends the search.
const SETTLED: f64 = 2e-6;
/// Squarings of the small matrix: the radius is that of 2^SQUARINGS applications.
const SQUARINGS: u32 = 22;

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// Spectral radius of a `size` x `size` matrix A: |A^2n| / |A^n| is its n-th power.
#[must_use]
pub fn radius_of(matrix: &[f64], size: usize) -> f64 {
    let mut matrix = matrix.to_vec();
    let (mut before, mut last, mut factored) = (0.0, 0.0, 0.0);
    for squaring in 0..=SQUARINGS {
        let norm = dot(&matrix, &matrix).sqrt();
        if norm == 0.0 || !norm.is_finite() {
            return norm;
        }
        (before, last) = (last, factored + math::ln(norm));
        if squaring < SQUARINGS {
            matrix.iter_mut().for_each(|x| *x /= norm);
            factored = 2.0 * last;
            matrix = product(&matrix, &matrix, size);
        }
    }
    math::exp((last - before) / f64::from(1_u32 << (SQUARINGS - 1)))
}

/// Spectral radius of a linear map of `size` numbers, by Arnoldi's method: the map on the space that a vector and its
/// images span, which grows until the radius no longer changes.
pub fn radius(size: usize, mut apply: impl FnMut(&[f64]) -> Vec<f64>) -> f64 {
    // Any vector that lies in no special direction.
    let start = |i: usize| 0.5 + (0.618_033_988_749_894_8 * (i + 1) as f64).fract();
    let first: Vec<f64> = (0..size).map(start).collect();
    let norm = dot(&first, &first).sqrt();
    let mut basis = vec![first.into_iter().map(|x| x / norm).collect::<Vec<_>>()];
    // Column by column.
    let mut columns: Vec<Vec<f64>> = Vec::new();
    let mut found = f64::NAN;
    loop {
        let mut next = apply(&basis[columns.len()]);
        let size_before = dot(&next, &next).sqrt();
        let mut column = vec![0.0; basis.len()];
        // Twice, so that rounding leaves nothing of the others in it.
        for _ in 0..2 {
            for (known, entry) in basis.iter().zip(&mut column) {
                let share = dot(known, &next);
                *entry += share;
                next.iter_mut().zip(known).for_each(|(x, y)| *x -= share * y);
            }
        }
        let rest = dot(&next, &next).sqrt();
        column.push(rest);
        columns.push(column);
        let count = columns.len();
        let whole = count >= size.min(MOST_VECTORS) || rest <= 1e-13 * size_before;
        if whole || count.is_multiple_of(LOOK_EVERY) {
            let entry = |i: usize| columns[i % count].get(i / count).copied().unwrap_or(0.0);
            let small: Vec<f64> = (0..count * count).map(entry).collect();
            let now = radius_of(&small, count);
            let settled = (now - found).abs() <= SETTLED * now;
            if whole || settled || !now.is_finite() {
                return now;
            }
            found = now;
        }
        next.iter_mut().for_each(|x| *x /= rest);
        basis.push(next);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::math::{cos, sin};

    #[test]
    fn the_radius_of_a_map_is_its_largest_eigenvalue() {
        // A rotation times 0.98, a Jordan block of 0.9, and a crowd from 0 to 0.97 beside it.
        let (c, s) = (0.98 * cos(0.3), 0.98 * sin(0.3));
        let size = 120;
        let apply = |x: &[f64]| {
            let mut out =
                vec![c * x[0] - s * x[1], s * x[0] + c * x[1], 0.9 * x[2] + 5.0 * x[3], 0.9 * x[3]];
            out.extend((4..size).map(|i| 0.97 * (i - 4) as f64 / size as f64 * x[i]));
            out
        };
        let found = radius(size, apply);
        assert!((found / 0.98 - 1.0).abs() < 1e-6, "{found}");
        assert!((radius(2, |x| vec![2.0 * x[0] + x[1], 3.0 * x[1]]) - 3.0).abs() < 1e-6);
        assert_eq!(radius(3, |x| vec![0.0; x.len()]), 0.0);
    }
}
