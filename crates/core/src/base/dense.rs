//! Small dense matrices, row by row in a list: product and exponential. Our own, with one order of the sums, so that the
//! bits are the same everywhere.

/// Largest norm that the Taylor series is summed for; its 12 terms then miss 2e-14 of it.
const SERIES_NORM: f64 = 0.5;
/// Terms of the series.
const TERMS: u32 = 12;

/// The product of two `size` x `size` matrices.
#[must_use]
pub fn product(a: &[f64], b: &[f64], size: usize) -> Vec<f64> {
    let mut out = vec![0.0; size * size];
    for (row, out) in a.chunks_exact(size).zip(out.chunks_exact_mut(size)) {
        for (factor, other) in row.iter().zip(b.chunks_exact(size)) {
            for (sum, x) in out.iter_mut().zip(other) {
                *sum += factor * x;
            }
        }
    }
    out
}

/// The exponential of a `size` x `size` matrix: scaled, summed, squared back.
#[must_use]
pub fn exponential(matrix: &[f64], size: usize) -> Vec<f64> {
    let rows = matrix.chunks_exact(size).map(|row| row.iter().map(|x| x.abs()).sum::<f64>());
    let mut norm = rows.fold(0.0, f64::max);
    let mut squarings = 0_u32;
    let mut scale = 1.0;
    while norm > SERIES_NORM && squarings < 64 {
        norm *= 0.5;
        scale *= 0.5;
        squarings += 1;
    }
    let scaled: Vec<f64> = matrix.iter().map(|x| x * scale).collect();
    let identity = |i: usize| if i.is_multiple_of(size + 1) { 1.0 } else { 0.0 };
    let mut sum: Vec<f64> = (0..size * size).map(identity).collect();
    let mut term = sum.clone();
    for k in 1..=TERMS {
        term = product(&term, &scaled, size);
        term.iter_mut().for_each(|x| *x /= f64::from(k));
        sum.iter_mut().zip(&term).for_each(|(sum, x)| *sum += x);
    }
    for _ in 0..squarings {
        sum = product(&sum, &sum, size);
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::math::{cos, exp, sin};

    #[test]
    fn the_exponential_of_a_damped_rotation_is_known() {
        for length in [1e-3, 0.3, 7.0, 60.0] {
            let matrix = [-0.1 * length, length, -length, -0.1 * length];
            let found = exponential(&matrix, 2);
            let size = exp(-0.1 * length);
            let (cos, sin) = (size * cos(length), size * sin(length));
            for (found, known) in found.iter().zip([cos, sin, -sin, cos]) {
                assert!((found - known).abs() < 1e-12, "{length}: {found} {known}");
            }
        }
    }
}
