//! The inhomogeneity of the material: a field along the path, so that every controller meets the same.
//!
//! ```text
//! w(c + 1) = p w(c) + sqrt(1 - p^2) e(c + 1)      AR(1) of unit variance on cells of 0.1 mm
//! p        = exp(-cell / correlation length)      e: normal deviates of a stream of its own
//! ```
//!
//! Between cells it is interpolated linearly.

use crate::base::math;
use crate::base::rng::Stream;

/// Cells of the field per millimetre.
const CELLS_PER_MM: f64 = 10.0;

/// The field with its place.
#[derive(Clone, Debug)]
pub struct MaterialField {
    stream: Stream,
    pole: f64,
    drive: f64,
    cell: u64,
    here: f64,
    next: f64,
}

impl MaterialField {
    /// The field under `seed` with a correlation length in mm, at the start of the path.
    #[must_use]
    pub fn new(seed: u32, correlation_mm: f64) -> Self {
        let stream = Stream::new(u64::from(seed), "noise.inhomogeneity");
        let here = stream.normal(0);
        let mut field = Self { stream, pole: 0.0, drive: 0.0, cell: 0, here, next: 0.0 };
        field.reconfigure(correlation_mm);
        field.next = field.after(1, here);
        field
    }

    /// Takes over another correlation length from the next cell but one on.
    pub fn reconfigure(&mut self, correlation_mm: f64) {
        self.pole = math::exp(-1.0 / (CELLS_PER_MM * correlation_mm));
        self.drive = (1.0 - self.pole * self.pole).sqrt();
    }

    fn after(&self, cell: u64, before: f64) -> f64 {
        self.pole * before + self.drive * self.stream.normal(cell)
    }

    /// The field at a position in mm, in standard deviations; positions must not fall between calls.
    #[inline]
    pub fn at(&mut self, position_mm: f64) -> f64 {
        let place = position_mm * CELLS_PER_MM;
        while place >= (self.cell + 1) as f64 {
            self.cell += 1;
            self.here = self.next;
            self.next = self.after(self.cell + 1, self.here);
        }
        let fraction = place - self.cell as f64;
        self.here + fraction * (self.next - self.here)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbours_are_alike_over_the_correlation_length() {
        let mut field = MaterialField::new(1, 3.0);
        let values: Vec<f64> = (0..200_000).map(|cell| field.at(f64::from(cell) * 0.1)).collect();
        let product = |lag: usize| {
            let pairs = values.iter().zip(&values[lag..]);
            pairs.map(|(a, b)| a * b).sum::<f64>() / (values.len() - lag) as f64
        };
        assert!((product(0) - 1.0).abs() < 0.05, "{}", product(0));
        // One correlation length on: exp(-1).
        assert!((product(30) / product(0) - 0.368).abs() < 0.04, "{}", product(30));
        // It is the same however it is walked, and another under another seed.
        let mut strides = MaterialField::new(1, 3.0);
        assert_eq!(strides.at(1234.0), values[12340]);
        assert_ne!(MaterialField::new(2, 3.0).at(1234.0), values[12340]);
    }
}
