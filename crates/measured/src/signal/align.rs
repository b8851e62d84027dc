//! When a measurement began, seen from a run, and how large it is against it: the shift at which both go together most,
//! and there the scale and offset by least squares.
//!
//! ```text
//! measured(t) = offset + scale reference(t - shift) + rest
//! ```
//!
//! The shift is that of the largest correlation over the part that both have, at least half of the shorter one; between
//! two samples by the parabola through three.

use nalgebra::Complex;

use crate::base::fft::synthesise;
use crate::base::language::tr;
use crate::base::stats;
use crate::fault::DataFault;

/// How two series lie to each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Alignment {
    /// So much later the measured one is, s.
    pub shift_s: f64,
    /// What the reference is to be multiplied by.
    pub scale: f64,
    /// And what is added then.
    pub offset: f64,
    /// Their correlation at that shift.
    pub correlation: f64,
    /// Root mean square of what is left.
    pub rest: f64,
    /// Samples that both have there.
    pub samples: usize,
}

/// Sums over the part that both series have at every lag of the measured one.
struct Overlap {
    measured: [Vec<f64>; 2],
    reference: [Vec<f64>; 2],
    /// sum measured(i + lag) reference(i), lag from -(reference's length - 1) on.
    products: Vec<f64>,
}

/// Sums of the values before every place, and of their squares.
fn sums(values: &[f64]) -> [Vec<f64>; 2] {
    let running = |of: fn(f64) -> f64| {
        let mut sum = 0.0;
        std::iter::once(0.0)
            .chain(values.iter().map(|x| {
                sum += of(*x);
                sum
            }))
            .collect()
    };
    [running(|x| x), running(|x| x * x)]
}

impl Overlap {
    fn new(measured: &[f64], reference: &[f64]) -> Self {
        let length = (measured.len() + reference.len()).next_power_of_two();
        let at = |values: &[f64], i: usize| values.get(i).copied().unwrap_or(0.0);
        // Two real series in one transform; the second one backwards, so that their convolution is the correlation.
        let turned = |i: usize| reference.len().checked_sub(i + 1).map_or(0.0, |i| reference[i]);
        let mut both: Vec<Complex<f64>> =
            (0..length).map(|i| Complex::new(at(measured, i), turned(i))).collect();
        synthesise(&mut both);
        let product = |i: usize| {
            let (z, mirrored) = (both[i], both[(length - i) % length].conj());
            ((z + mirrored) * (z - mirrored) * Complex::new(0.0, -0.25)).conj()
        };
        let mut result: Vec<Complex<f64>> = (0..length).map(product).collect();
        synthesise(&mut result);
        let count = measured.len() + reference.len() - 1;
        let products = result[..count].iter().map(|x| x.re / length as f64).collect();
        Self { measured: sums(measured), reference: sums(reference), products }
    }

    /// How many samples both have with the measured one `place` - (reference's length - 1) later, and their correlation.
    fn at(&self, place: usize) -> (usize, f64) {
        let (n, m) = (self.measured[0].len() - 1, self.reference[0].len() - 1);
        // Of the reference, sample i lies at i + lag of the measured one.
        let (from_measured, from_reference) =
            ((place + 1).saturating_sub(m), (m - 1).saturating_sub(place));
        let count = (n - from_measured).min(m - from_reference);
        let over = |sums: &[f64], from: usize| sums[from + count] - sums[from];
        let [a, aa] = [0, 1].map(|k| over(&self.measured[k], from_measured));
        let [b, bb] = [0, 1].map(|k| over(&self.reference[k], from_reference));
        let n = count as f64;
        let (covariance, squares) =
            (self.products[place] - a * b / n, (aa - a * a / n) * (bb - b * b / n));
        (count, if squares > 0.0 { covariance / squares.sqrt() } else { 0.0 })
    }
}

/// Finds shift, scale and offset of two series with the same sample rate in Hz; the shift is at most `most_s` either way.
///
/// # Errors
/// One of them is too short, or nowhere do both vary.
pub fn align(
    measured: &[f64],
    reference: &[f64],
    rate_hz: f64,
    most_s: f64,
) -> Result<Alignment, DataFault> {
    const LEAST: usize = 8;
    let shorter = measured.len().min(reference.len());
    if shorter < LEAST {
        let found = tr!("{count} samples to align", count = shorter);
        return Err(DataFault::of_file(found, tr!("at least {least}", least = LEAST)));
    }
    // Without their means, so that sums of squares keep their digits.
    let centred = |values: &[f64]| {
        let mean = stats::mean(values.iter().copied()).unwrap_or(0.0);
        values.iter().map(|x| x - mean).collect::<Vec<f64>>()
    };
    let overlap = Overlap::new(&centred(measured), &centred(reference));
    let middle = reference.len() - 1;
    let most = (most_s * rate_hz).clamp(0.0, 1e9) as usize;
    let places = middle.saturating_sub(most)..=(middle + most).min(measured.len() + middle - 1);
    let judged = places.filter_map(|place| {
        let (count, correlation) = overlap.at(place);
        (count >= (shorter / 2).max(LEAST)).then_some((place, correlation))
    });
    let best =
        judged.max_by(|a, b| a.1.total_cmp(&b.1)).filter(|(_, correlation)| *correlation > 0.0);
    let Some((place, peak)) = best else {
        let found = tr("two series that nowhere go together").to_owned();
        return Err(DataFault::of_file(
            found,
            tr("some shift at which one rises where the other does"),
        ));
    };
    // The top of the parabola through the peak and its neighbours.
    let beside = |place: Option<usize>| {
        let place = place.filter(|place| *place < overlap.products.len())?;
        let (count, correlation) = overlap.at(place);
        (count >= LEAST).then_some(correlation)
    };
    let between = match (beside(place.checked_sub(1)), beside(Some(place + 1))) {
        (Some(before), Some(behind)) if before + behind < 2.0 * peak => {
            (0.5 * (before - behind) / (before - 2.0 * peak + behind)).clamp(-0.5, 0.5)
        }
        (Some(_) | None, _) => 0.0,
    };
    let lag = place as f64 - middle as f64 + between;
    Ok(fitted(measured, reference, lag, rate_hz))
}

/// Scale and offset at a lag in samples.
fn fitted(measured: &[f64], reference: &[f64], lag: f64, rate_hz: f64) -> Alignment {
    let at = |i: usize| {
        let place = i as f64 - lag;
        let before = place.floor();
        if before < 0.0 || before as usize + 1 >= reference.len() {
            return None;
        }
        let before = before as usize;
        Some(
            reference[before]
                + (place - place.floor()) * (reference[before + 1] - reference[before]),
        )
    };
    let pairs: Vec<(f64, f64)> =
        measured.iter().enumerate().filter_map(|(i, y)| Some((at(i)?, *y))).collect();
    let (xs, ys): (Vec<f64>, Vec<f64>) = pairs.iter().copied().unzip();
    let [x, y] = [&xs, &ys].map(|values| stats::mean(values.iter().copied()).unwrap_or(0.0));
    let sum =
        |of: &dyn Fn(f64, f64) -> f64| pairs.iter().map(|(a, b)| of(a - x, b - y)).sum::<f64>();
    let (xy, xx) = (sum(&|a, b| a * b), sum(&|a, _| a * a));
    let scale = if xx > 0.0 { xy / xx } else { 0.0 };
    let offset = y - scale * x;
    let rest = stats::rms(pairs.iter().map(|(x, y)| y - offset - scale * x)).unwrap_or(0.0);
    Alignment {
        shift_s: lag / rate_hz,
        scale,
        offset,
        correlation: stats::correlation(&xs, &ys).unwrap_or(0.0),
        rest,
        samples: pairs.len(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::math;
    use crate::base::rng::Stream;

    /// Something that is nowhere like itself: a step, a hump and a wave.
    fn shape(time_s: f64) -> f64 {
        let hump = math::exp(-(time_s - 3.0) * (time_s - 3.0) * 4.0);
        100.0 / (1.0 + math::exp(-20.0 * (time_s - 1.0)))
            + 40.0 * hump
            + 5.0 * math::sin(7.0 * time_s)
    }

    #[test]
    fn shift_scale_and_offset_are_found_under_noise() {
        let rate_hz = 50.0;
        let noise = Stream::new(3, "align");
        for shift_s in [-0.73, 0.0, 0.315, 1.2] {
            let reference: Vec<f64> = (0..250).map(|i| shape(f64::from(i) / rate_hz)).collect();
            let measured: Vec<f64> = (0..300)
                .map(|i| {
                    12.0 + 0.8 * shape(f64::from(i) / rate_hz - shift_s)
                        + 0.8 * noise.normal(i as u64)
                })
                .collect();
            let found = align(&measured, &reference, rate_hz, 2.0).unwrap();
            assert!((found.shift_s - shift_s).abs() < 0.2 / rate_hz, "{shift_s}: {found:?}");
            assert!((found.scale - 0.8).abs() < 0.01, "{found:?}");
            assert!((found.offset - 12.0).abs() < 1.0, "{found:?}");
            assert!((0.6..1.0).contains(&found.rest) && found.correlation > 0.99, "{found:?}");
            assert!(found.samples >= 200);
        }
    }

    #[test]
    fn the_sums_by_transform_are_the_direct_ones() {
        let noise = Stream::new(1, "sums");
        let series =
            |n: u64, k: u64| (0..n).map(|i| noise.normal(i + 1000 * k)).collect::<Vec<f64>>();
        for (n, m) in [(20, 20), (31, 9), (8, 40)] {
            let (a, b) = (series(n, 1), series(m, 2));
            let overlap = Overlap::new(&a, &b);
            for place in 0..(n + m - 1) as usize {
                let lag = place as i64 - (m as i64 - 1);
                let pairs: Vec<(f64, f64)> = (0..m as i64)
                    .filter(|i| (0..n as i64).contains(&(i + lag)))
                    .map(|i| (a[(i + lag) as usize], b[i as usize]))
                    .collect();
                let (x, y): (Vec<f64>, Vec<f64>) = pairs.iter().copied().unzip();
                let (count, correlation) = overlap.at(place);
                assert_eq!(count, pairs.len());
                if count > 2 {
                    let known = stats::correlation(&x, &y).unwrap();
                    assert!(
                        (correlation - known).abs() < 1e-9,
                        "{n} {m} {place}: {correlation} {known}"
                    );
                }
            }
        }
    }

    #[test]
    fn what_cannot_be_aligned_is_told() {
        let flat = align(&[1.0; 20], &[2.0; 20], 50.0, 1.0).unwrap_err().to_string();
        assert!(flat.contains("nowhere go together"), "{flat}");
        let short = align(&[1.0; 4], &[2.0; 20], 50.0, 1.0).unwrap_err().to_string();
        assert!(short.contains("4 samples") && short.contains("at least 8"), "{short}");
    }
}
