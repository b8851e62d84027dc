//! Forces across the spindle's axis, from the axes of a dynamometer to those of the machine.
//!
//! ```text
//! X = x cos a - y sin a
//! Y = x sin a + y cos a
//! ```
//!
//! a is the angle from the machine's X to the dynamometer's x, about the spindle's axis from X towards Y.

use crate::base::math;

/// The two forces in the axes of the machine, of dynamometer axes that are turned by an angle in degrees.
///
/// ```
/// use steadycut_measured::signal::rotate::rotated;
///
/// // Turned by a quarter, the dynamometer's x looks along the machine's Y.
/// let (x, y) = rotated(&[3.0], &[0.0], 90.0);
/// assert!(x[0].abs() < 1e-12 && (y[0] - 3.0).abs() < 1e-12);
/// ```
#[must_use]
pub fn rotated(x: &[f64], y: &[f64], angle_deg: f64) -> (Vec<f64>, Vec<f64>) {
    let angle = angle_deg * (math::PI / 180.0);
    let (cos, sin) = (math::cos(angle), math::sin(angle));
    x.iter().zip(y).map(|(x, y)| (x * cos - y * sin, x * sin + y * cos)).unzip()
}
