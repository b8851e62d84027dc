//! Whether a loop swings without damping: a limit cycle, or a growing oscillation on its way into one.
//!
//! A feedback loop with dead time that overreacts swings at one period, and its limits bound the
//! swing. Noise in a damped loop also makes waves, but these forget their phase after a few
//! periods. So the feed's autocorrelation tells them apart: that of an undamped swing is still high
//! after four periods, that of noise through a loop with the damping ratio D has fallen to about
//! exp(-8 pi D). And it is the loop that swings if the force follows the feed; a force that comes from
//! outside is answered by the feed, later and the other way round.
//!
//! In few periods noise stays in step by chance. So the swing has to be larger than what the noise drives:
//! through loops of SDNRP up to eight tenths of their critical gain the amplitude is at most 1.5 times the
//! root mean square of what the sensor adds (measured over gains, dead times, seeds and noise levels), and
//! a limit cycle is bounded by limits and models, not by the noise.

use serde::Serialize;

use crate::base::stats;

/// An oscillation that does not die down.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Oscillation {
    /// Its period, s.
    pub period_s: f64,
    /// Amplitude of the force, percent of its reference.
    pub force_percent: f64,
    /// Amplitude of the feed, percent of its mean.
    pub feed_percent: f64,
}

/// Amplitude over the root mean square of the noise from which on noise alone does not explain it (measured).
pub(super) const ABOVE_NOISE: f64 = 1.6;
/// Amplitudes below this fraction are no oscillation that anybody would call one (chosen).
const LEAST_AMPLITUDE: f64 = 0.01;
/// Periods after which the autocorrelation is looked at, and what it must still be: a damping ratio
/// below some 0.02 (chosen).
const PERIODS: usize = 4;
const STILL_CORRELATED: f64 = 0.6;
/// A place of the autocorrelation counts as high from this fraction of the highest on (chosen).
const NEARLY: f64 = 0.9;
/// Least number of periods, so that six of them are compared with others (chosen).
const LEAST_PERIODS: usize = PERIODS + 2;
/// Root mean square of the second half over that of the first from which on it does not die down.
const NOT_DYING: f64 = 0.8;
/// Correlation of force and feed from which on the force follows the feed (chosen).
const FOLLOWS: f64 = 0.5;
/// Fewest samples that are judged.
const LEAST_SAMPLES: usize = 40;

/// Looks for an undamped oscillation. `force` and `noise`, which the sensor adds to it, are relative to its
/// reference, `feed` in any unit, all in samples `sample_s` seconds apart, after the loop has had time to
/// come to rest.
#[must_use]
pub fn undamped(force: &[f64], feed: &[f64], noise: &[f64], sample_s: f64) -> Option<Oscillation> {
    let count = force.len().min(feed.len());
    if count < LEAST_SAMPLES {
        return None;
    }
    let feed_mean = stats::mean(feed[..count].iter().copied()).filter(|mean| *mean > 0.0)?;
    let force = without_trend(&force[..count]);
    let feed = without_trend(&feed[..count]);
    let amplitude = |of: &[f64]| stats::rms(of.iter().copied()).map(|rms| 2.0_f64.sqrt() * rms);
    let (force_size, feed_size) = (amplitude(&force)?, amplitude(&feed)? / feed_mean);
    if force_size < LEAST_AMPLITUDE || feed_size < LEAST_AMPLITUDE {
        return None;
    }
    let noise_mean = stats::mean(noise.iter().copied()).unwrap_or(0.0);
    let noise_size = stats::rms(noise.iter().map(|x| x - noise_mean)).unwrap_or(0.0);
    if force_size < ABOVE_NOISE * noise_size {
        return None;
    }
    // Noise makes the amplitude wander by about its own size.
    let halves = force.split_at(count / 2);
    if amplitude(halves.1)? < NOT_DYING * amplitude(halves.0)? - noise_size {
        return None;
    }
    if stats::correlation(&force, &feed)? < FOLLOWS {
        return None;
    }
    let period = period(&feed)?;
    Some(Oscillation {
        period_s: period * sample_s,
        force_percent: 100.0 * force_size,
        feed_percent: 100.0 * feed_size,
    })
}

/// The period in samples at which a series stays correlated with itself.
fn period(series: &[f64]) -> Option<f64> {
    let longest = series.len() / LEAST_PERIODS;
    let at = |lag: usize| {
        let kept = series.len() - lag;
        stats::correlation(&series[..kept], &series[lag..]).unwrap_or(0.0)
    };
    // Beyond its first fall below zero, the first period is the first of its high places: those of a steady
    // swing are as high as each other.
    let zero = (1..=longest).find(|lag| at(*lag) < 0.0)?;
    let high = NEARLY * at(highest(zero..longest + 1, &at)?);
    let rises = (zero..=longest).find(|lag| at(*lag) >= high)?;
    let first = highest(rises..rises + rises / 4 + 1, &at)?;
    let later = highest(PERIODS * first - first / 2..PERIODS * first + first / 2 + 1, &at)?;
    (at(first) >= STILL_CORRELATED && at(later) >= STILL_CORRELATED)
        .then(|| later as f64 / PERIODS as f64)
}

fn highest(lags: std::ops::Range<usize>, at: &impl Fn(usize) -> f64) -> Option<usize> {
    let (mut best, mut found) = (f64::NEG_INFINITY, None);
    for lag in lags {
        let here = at(lag);
        if here > best {
            (best, found) = (here, Some(lag));
        }
    }
    found
}

/// The series without the straight line that fits it best.
fn without_trend(series: &[f64]) -> Vec<f64> {
    let middle = 0.5 * (series.len() - 1) as f64;
    let mean = series.iter().sum::<f64>() / series.len() as f64;
    let (mut product, mut square) = (0.0, 0.0);
    for (i, value) in series.iter().enumerate() {
        let x = i as f64 - middle;
        product += x * (value - mean);
        square += x * x;
    }
    let slope = if square > 0.0 { product / square } else { 0.0 };
    let level = |i: usize| mean + slope * (i as f64 - middle);
    series.iter().enumerate().map(|(i, value)| value - level(i)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::math::{TAU, exp, sin};
    use crate::base::rng::Stream;

    /// 30 s of control samples, 20 ms apart.
    fn series(of: impl FnMut(f64) -> f64) -> Vec<f64> {
        (0..1500).map(|i| f64::from(i) * 0.02).map(of).collect()
    }

    fn swing(t: f64) -> f64 {
        sin(TAU * t / 1.2)
    }

    #[test]
    fn a_steady_and_a_growing_swing_are_undamped_with_their_period_and_amplitude() {
        let feed = series(|t| 300.0 * (1.0 + 0.2 * swing(t)));
        let found = undamped(&series(|t| 0.1 * swing(t)), &feed, &[], 0.02).unwrap();
        assert!((found.period_s - 1.2).abs() < 0.01, "{found:?}");
        assert!((found.force_percent - 10.0).abs() < 0.2, "{found:?}");
        assert!((found.feed_percent - 20.0).abs() < 0.4, "{found:?}");
        let growing = |t: f64| 0.02 * exp(t / 20.0) * swing(t);
        assert!(undamped(&series(growing), &series(|t| 300.0 + growing(t)), &[], 0.02).is_none());
        assert!(undamped(&series(growing), &series(|t| 3.0 + growing(t)), &[], 0.02).is_some());
    }

    #[test]
    fn what_dies_down_or_is_small_or_comes_from_outside_is_not() {
        let damped = |t: f64| exp(-t / 8.0) * swing(t);
        assert_eq!(undamped(&series(damped), &series(|t| 3.0 + damped(t)), &[], 0.02), None);
        let small = |t: f64| 0.005 * swing(t);
        assert_eq!(undamped(&series(small), &series(|t| 1.0 + small(t)), &[], 0.02), None);
        // The force swings, the feed answers a quarter of a period later, the other way round.
        let feed = series(|t| 1.0 - 0.2 * swing(t - 0.3));
        assert_eq!(undamped(&series(|t| 0.1 * swing(t)), &feed, &[], 0.02), None);
        let still = series(|_| 300.0);
        assert_eq!(undamped(&series(|t| 0.1 * swing(t)), &still, &[], 0.02), None);
    }

    /// A resonance of damping ratio `damping` at a period of 1.2 s, driven by noise.
    fn noisy(seed: u64, damping: f64) -> Vec<f64> {
        let noise = Stream::new(seed, "story");
        let (rate, step) = (TAU / 1.2, 0.002);
        let (mut x, mut v) = (0.0, 0.0);
        let mut driven = 0.0;
        (0..15_000)
            .filter_map(|i| {
                if i % 10 == 0 {
                    driven = noise.normal(i / 10);
                }
                v += step * (rate * rate * (driven - x) - 2.0 * damping * rate * v);
                x += step * v;
                (i % 10 == 0).then_some(0.1 * x)
            })
            .collect()
    }

    #[test]
    fn noise_is_never_called_an_oscillation_even_through_a_lightly_damped_loop() {
        for seed in 0..200 {
            for damping in [0.1, 0.3, 1.0] {
                let force = noisy(seed, damping);
                let feed: Vec<f64> = force.iter().map(|x| 1.0 + x).collect();
                assert_eq!(
                    undamped(&force, &feed, &[], 0.02),
                    None,
                    "seed {seed}, damping {damping}"
                );
            }
        }
    }

    #[test]
    fn a_swing_no_larger_than_the_noise_that_drives_it_is_not_told_apart() {
        let noise = Stream::new(7, "story");
        let noise: Vec<f64> = (0..1500).map(|i| 0.1 * noise.normal(i)).collect();
        let feed = series(|t| 1.0 + 0.2 * swing(t));
        let told = |size: f64| undamped(&series(|t| size * swing(t)), &feed, &noise, 0.02);
        assert_eq!(told(0.12), None);
        assert!(told(0.25).is_some());
    }
}
