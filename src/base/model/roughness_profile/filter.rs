//! The Gaussian profile filter of ISO 16610-21.

use super::ProfileSettings;
use crate::base::fft::convolve_valid;
use crate::base::math;

/// sqrt(ln 2/pi): half of the amplitude passes at the cut-off.
const ALPHA: f64 = 0.469_718_639_349_825_7;
/// Points of the finest profile per cut-off against short waves.
const POINTS_PER_SHORT: f64 = 5.0;
/// Most points per cut-off against long waves.
const POINTS_PER_LONG: f64 = 8000.0;

/// Distance of the points in mm: a fifth of the short cut-off, which divides the long one.
pub fn step_mm(settings: &ProfileSettings) -> f64 {
    let finest_mm = 0.001 * settings.short_um / POINTS_PER_SHORT;
    let points = (settings.long_mm / finest_mm).round().clamp(1.0, POINTS_PER_LONG);
    settings.long_mm / points
}

/// The mean line of `heights` for a cut-off, with the weights cut off at `reach` points to each
/// side; shorter than `heights` by twice the reach. With no reach the heights pass as they are.
pub fn gaussian(heights: &[f64], cutoff_mm: f64, step_mm: f64, reach: usize) -> Vec<f64> {
    let weight = |i: usize| {
        let x = (i as f64 - reach as f64) * step_mm / (ALPHA * cutoff_mm);
        math::exp(-math::PI * (x * x))
    };
    let weights: Vec<f64> = (0..=2 * reach).map(weight).collect();
    let total: f64 = weights.iter().sum();
    let weights: Vec<f64> = weights.into_iter().map(|weight| weight / total).collect();
    // The mean passes unchanged; without it nothing is lost to rounding.
    let mean = heights.iter().sum::<f64>() / heights.len().max(1) as f64;
    let centred: Vec<f64> = heights.iter().map(|z| z - mean).collect();
    convolve_valid(&centred, &weights).into_iter().map(|z| z + mean).collect()
}
