//! The Gaussian profile filter of ISO 16610-21.

use super::ProfileSettings;
use crate::base::fft::convolve_valid;
use crate::base::math;
use crate::base::stats;

/// sqrt(ln 2/pi): half of the amplitude passes at the cut-off.
const ALPHA: f64 = 0.469_718_639_349_825_7;
/// Points of the finest profile per cut-off against short waves.
const POINTS_PER_SHORT: f64 = 5.0;
/// Most points per cut-off against long waves: a short cut-off below a 1600th of the long one (5 um of 8 mm) has
/// fewer than five points, and below an 8000th none, so there the points take its place.
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
    let mean = stats::mean(heights.iter().copied()).unwrap_or(0.0);
    let centred: Vec<f64> = heights.iter().map(|z| z - mean).collect();
    convolve_valid(&centred, &weights).into_iter().map(|z| z + mean).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn waves_pass_both_cut_offs_as_the_standard_says() {
        // What is left of a wave after the long cut-off of 0.8 mm: 1 - 2^-((0.8/length)^2).
        for (length_mm, left) in [
            (0.25, 0.999173100280896),
            (0.5, 0.830424459069041),
            (0.8, 0.5),
            (1.0, 0.3582870512185479),
            (2.5, 0.0685178681865712),
            (8.0, 0.006907504562964098),
        ] {
            // One point in the middle, where the wave has its crest.
            let (step_mm, reach) = (0.001, 800);
            let wave =
                |i: usize| math::cos(math::TAU * (i as f64 - reach as f64) * step_mm / length_mm);
            let heights: Vec<f64> = (0..=2 * reach).map(wave).collect();
            let mean_line = gaussian(&heights, 0.8, step_mm, reach);
            assert_eq!(mean_line.len(), 1);
            assert!((1.0 - mean_line[0] - left).abs() < 1e-6, "{length_mm}: {}", mean_line[0]);
        }
        // Half of the amplitude passes the short cut-off at its length.
        let heights: Vec<f64> =
            (0..=10).map(|i| math::cos(math::TAU * (f64::from(i) - 5.0) / 5.0)).collect();
        let passed = gaussian(&heights, 0.0025, 0.0005, 5)[0];
        assert!((passed - 0.5).abs() < 1e-3, "{passed}");
    }

    #[test]
    fn the_points_divide_the_long_cut_off_and_are_never_too_many() {
        for (short_um, long_mm) in [(2.5, 0.8), (25.0, 0.08), (0.5, 8.0), (3.3, 0.25)] {
            let settings = ProfileSettings { short_um, long_mm, ..ProfileSettings::default() };
            let points = long_mm / step_mm(&settings);
            assert!((points - points.round()).abs() < 1e-9 && points <= POINTS_PER_LONG);
        }
        assert!((step_mm(&ProfileSettings::default()) - 0.0005).abs() < 1e-15);
    }
}
