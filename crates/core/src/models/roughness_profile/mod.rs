//! The profile Y(x) that the teeth leave along the feed, and its roughness by the standards.
//!
//! ```text
//! tooth k at x_k, its lowest point at z_k:   y_k(x) = z_k + s(x - x_k),  Y(x) = min over k of y_k(x)
//! s(d) = d^2/(R + sqrt(R^2 - d^2)) for a ball; the same of a corner's radius beyond a flat
//! primary profile: Gaussian filter lambda_s;  waviness w: Gaussian filter lambda_c;  r = z - w
//! weight s(x) = exp(-pi (x/(alpha lambda))^2)/(alpha lambda),  alpha = sqrt(ln 2/pi)
//! Ra = mean |r|,  Rq = sqrt(mean r^2),  Rz = mean over the sampling lengths of peak to valley
//! ```
//!
//! ISO 16610-21 for the filters, ISO 4287 for the parameters. A vibration exactly at a harmonic of
//! the tooth passing frequency gives every tooth the same z_k: no roughness, only an error of size.

mod filter;

use filter::{gaussian, step_mm};

use super::tool::Outline;

crate::settings! {
    /// The roughness profile and how it is filtered.
    pub struct ProfileSettings {
        /// Cut-off of the filter against short waves. What vibration adds to Ra in the running cut is filtered
        /// at 50 um, finer than teeth stand apart, and the profile has at most 8000 points per long cut-off.
        short_um: f64 = 2.5, [0.5, 25.0], "um", live, "Short-wave cut-off";
        /// Cut-off of the filter against long waves, one sampling length; five are evaluated. 0.25 mm
        /// for Ra up to 0.1 um, 0.8 mm up to 2 um, 2.5 mm up to 10 um.
        long_mm: f64 = 0.8, [0.08, 8.0], "mm", live, "Long-wave cut-off";
        /// Fraction of the vibration between tooth and work that is normal to the surface.
        normal_share: f64 = 1.0, [0.0, 1.0], "", live, "Share normal to the surface";
    }
}

/// Sampling lengths in an evaluation length.
pub const SAMPLING_LENGTHS: usize = 5;
/// Teeth on each side that are looked at for one point; lower marks than these reach further only
/// on surfaces where nothing of the profile is left to measure.
const REACH: usize = 4096;

/// Where a tooth left its lowest point.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct ProfileMark {
    /// Along the feed, mm.
    pub x_mm: f64,
    /// Height above the ideal surface, mm.
    pub z_mm: f64,
}

/// Y in mm at `count` points from `from_mm` on, `step_mm` apart, of marks in ascending order of x;
/// infinite where no tooth has been.
#[must_use]
pub fn envelope(
    marks: &[ProfileMark],
    outline: &Outline,
    from_mm: f64,
    step_mm: f64,
    count: usize,
) -> Vec<f64> {
    let lowest_mm = marks.iter().fold(f64::INFINITY, |low, mark| low.min(mark.z_mm));
    let height = |x_mm: f64| {
        let right = marks.partition_point(|mark| mark.x_mm < x_mm);
        let mut y_mm = f64::INFINITY;
        // Outwards to both sides, until even the lowest mark could not cut deeper.
        let mut cut = |mark: &ProfileMark| {
            let rise = outline.rise_mm(x_mm - mark.x_mm, 0.0);
            y_mm = y_mm.min(mark.z_mm + rise);
            lowest_mm + rise < y_mm
        };
        let _ = marks[right..].iter().take(REACH).all(&mut cut);
        let _ = marks[..right].iter().rev().take(REACH).all(&mut cut);
        y_mm
    };
    (0..count).map(|i| height(from_mm + i as f64 * step_mm)).collect()
}

/// Points of a measurement over `lengths` sampling lengths, with what lies on both sides.
#[must_use]
pub fn points_over(settings: &ProfileSettings, lengths: usize) -> usize {
    let points = |length_mm: f64| (length_mm / step_mm(settings)).round() as usize;
    let margin = points(settings.long_mm) + points(0.001 * settings.short_um);
    lengths * points(settings.long_mm) + 1 + 2 * margin
}

/// Length in mm that must lie on each side of an evaluation length.
#[must_use]
pub fn run_up_mm(settings: &ProfileSettings) -> f64 {
    settings.long_mm + 0.001 * settings.short_um
}

/// Evaluation length in mm.
#[must_use]
pub fn evaluation_mm(settings: &ProfileSettings) -> f64 {
    SAMPLING_LENGTHS as f64 * settings.long_mm
}

/// A roughness profile and its parameters.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Roughness {
    /// Distance of the points, mm.
    pub step_mm: f64,
    /// The profile as the teeth left it over the evaluation length, mm.
    pub total_mm: Vec<f64>,
    /// The roughness profile r over the evaluation length, mm.
    pub profile_mm: Vec<f64>,
    /// Ra, um.
    pub ra_um: f64,
    /// Rq, um.
    pub rq_um: f64,
    /// Rz, um.
    pub rz_um: f64,
}

/// The roughness over the evaluation length from `from_mm` on (ISO 16610-21, ISO 4287); `None` where the marks do not cover
/// it and its run-up.
#[must_use]
pub fn measure(
    marks: &[ProfileMark],
    outline: &Outline,
    from_mm: f64,
    settings: &ProfileSettings,
) -> Option<Roughness> {
    evaluate(settings, |start_mm, step_mm, count| {
        envelope(marks, outline, from_mm + start_mm, step_mm, count)
    })
}

/// The roughness of the heights that `sample(start, step, count)` gives in mm, 0 being the start of
/// the evaluation length; `None` where one is not finite.
pub fn evaluate(
    settings: &ProfileSettings,
    sample: impl FnOnce(f64, f64, usize) -> Vec<f64>,
) -> Option<Roughness> {
    evaluate_over(settings, SAMPLING_LENGTHS, sample)
}

/// The same over `lengths` sampling lengths, at least one.
pub fn evaluate_over(
    settings: &ProfileSettings,
    lengths: usize,
    sample: impl FnOnce(f64, f64, usize) -> Vec<f64>,
) -> Option<Roughness> {
    let lengths = lengths.max(1);
    let step_mm = step_mm(settings);
    let points = |length_mm: f64| (length_mm / step_mm).round() as usize;
    let (short, long) = (points(0.001 * settings.short_um), points(settings.long_mm));
    let evaluated = lengths * long;
    let margin = short + long;
    let count = evaluated + 1 + 2 * margin;
    let heights = sample(-(margin as f64) * step_mm, step_mm, count);
    if heights.len() != count || heights.iter().any(|z| !z.is_finite()) {
        return None;
    }
    let primary = gaussian(&heights, 0.001 * settings.short_um, step_mm, short);
    let waviness = gaussian(&primary, settings.long_mm, step_mm, long);
    let rough = |(i, wave): (usize, &f64)| primary[i + long] - wave;
    let profile_mm: Vec<f64> = waviness.iter().enumerate().map(rough).take(evaluated).collect();
    let n = profile_mm.len() as f64;
    let mean_of = |of: fn(f64) -> f64| profile_mm.iter().map(|r| of(*r)).sum::<f64>() / n;
    let heights_of = profile_mm.chunks_exact(long).map(|section| {
        let [low, high] = crate::base::math::extent(section.iter().copied());
        high - low
    });
    Some(Roughness {
        step_mm,
        ra_um: 1000.0 * mean_of(f64::abs),
        rq_um: 1000.0 * mean_of(|r| r * r).sqrt(),
        rz_um: 1000.0 * heights_of.sum::<f64>() / lengths as f64,
        total_mm: heights[margin..margin + evaluated].to_vec(),
        profile_mm,
    })
}

#[cfg(test)]
mod tests;
