//! A low-pass filter that shifts nothing in time: Butterworth's of second order, forwards and backwards.
//!
//! Twice through it, the gain is 1/sqrt(2) at the cut-off that is asked for: each pass has one that is
//! (sqrt(2) - 1)^(-1/4) times higher (D. A. Winter, Biomechanics and Motor Control of Human Movement, 1990), in the
//! frequencies that the bilinear transform bends. At its ends
//! the series goes on turned about its last point (as scipy's `filtfilt`), by three periods of the cut-off.

use super::{even, fault, filled};
use crate::base::language::tr;
use crate::base::math;
use crate::channel::MeasuredChannel;
use crate::fault::DataFault;

/// The fourth root of sqrt(2) - 1, by which a pass's cut-off is higher.
const TWO_PASSES: f64 = 0.802_243_262_923_150_2;
/// Periods of the cut-off that the series goes on at its ends.
const PERIODS_BEYOND: f64 = 3.0;

/// A filter of second order: numerator and denominator, a0 = 1.
struct SecondOrder {
    b: [f64; 3],
    a: [f64; 2],
}

impl SecondOrder {
    /// Butterworth's low-pass filter by the bilinear transform, a pass of two; `ratio` is the cut-off of both over the
    /// sample rate.
    fn butterworth(ratio: f64) -> Self {
        let angle = math::PI * ratio;
        let k = math::sin(angle) / math::cos(angle) / TWO_PASSES;
        let norm = 1.0 / (1.0 + std::f64::consts::SQRT_2 * k + k * k);
        let b0 = k * k * norm;
        let a = [2.0 * (k * k - 1.0) * norm, (1.0 - std::f64::consts::SQRT_2 * k + k * k) * norm];
        Self { b: [b0, 2.0 * b0, b0], a }
    }

    /// A pass over a series that has stood at its first value for ever.
    fn pass(&self, values: &mut [f64]) {
        let [b0, b1, b2] = self.b;
        let [a1, a2] = self.a;
        let first = values.first().copied().unwrap_or(0.0);
        let mut z = [(1.0 - b0) * first, (b2 - a2) * first];
        for x in values {
            let y = b0 * *x + z[0];
            z = [b1 * *x - a1 * y + z[1], b2 * *x - a2 * y];
            *x = y;
        }
    }
}

/// The samples without what lies above a cut-off in Hz; missing ones are filled in before.
///
/// # Errors
/// Its samples are not even, or the cut-off is not below 0.4 of the sample rate.
pub fn low_passed(channel: &MeasuredChannel, cut_off_hz: f64) -> Result<Vec<f64>, DataFault> {
    let (rate_hz, _) = even(channel)?;
    if !(cut_off_hz > 0.0 && cut_off_hz < 0.4 * rate_hz) {
        let found = tr!("a cut-off of {cut_off} Hz", cut_off = cut_off_hz);
        return Err(fault(
            channel,
            found,
            tr!("above 0 and below {most} Hz", most = 0.4 * rate_hz),
        ));
    }
    let (values, _) = filled(channel)?;
    let n = values.len();
    let beyond =
        (PERIODS_BEYOND * rate_hz / cut_off_hz).ceil().max(9.0).min((n - 1) as f64) as usize;
    let (first, last) = (values[0], values[n - 1]);
    let before = (1..=beyond).rev().map(|i| 2.0 * first - values[i]);
    let behind = (1..=beyond).map(|i| 2.0 * last - values[n - 1 - i]);
    let mut long: Vec<f64> = before.chain(values.iter().copied()).chain(behind).collect();
    let filter = SecondOrder::butterworth(cut_off_hz / rate_hz);
    for _ in 0..2 {
        filter.pass(&mut long);
        long.reverse();
    }
    Ok(long[beyond..beyond + n].to_vec())
}

#[cfg(test)]
mod tests {
    use super::super::tests::channel;
    use super::*;

    #[test]
    fn it_is_the_filter_of_another_program() {
        let series =
            channel("F", 1000.0, (0..40).map(|i| f64::from((i * 37) % 101) / 10.0 - 5.0).collect());
        let found = low_passed(&series, 100.0).unwrap();
        // scipy: filtfilt(*butter(2, 2 / pi * arctan(tan(pi 100 / 1000) / 0.8022..)), x, padlen=30).
        let scipy = [
            (0, -5.000000165804217),
            (1, -2.858043435449486),
            (5, 0.4126932538236767),
            (20, 0.4884675940745666),
            (38, -0.6523087409843141),
            (39, -2.0999999259743207),
        ];
        for (at, known) in scipy {
            assert!((found[at] - known).abs() < 1e-9, "{at}: {} {known}", found[at]);
        }
    }

    #[test]
    fn slow_waves_stay_where_they_are_and_fast_ones_go() {
        let wave = |hz: f64| {
            (0..2000)
                .map(|i| math::sin(math::TAU * hz * f64::from(i) / 1000.0))
                .collect::<Vec<f64>>()
        };
        let size = |hz: f64| {
            let found = low_passed(&channel("F", 1000.0, wave(hz)), 50.0).unwrap();
            // The share of the wave in it, in phase.
            let sum = |a: &[f64], b: &[f64]| {
                a[500..1500].iter().zip(&b[500..1500]).map(|(a, b)| a * b).sum::<f64>()
            };
            sum(&found, &wave(hz)) / sum(&wave(hz), &wave(hz))
        };
        assert!((size(2.0) - 1.0).abs() < 1e-3, "{}", size(2.0));
        assert!((size(50.0) - std::f64::consts::FRAC_1_SQRT_2).abs() < 1e-3, "{}", size(50.0));
        assert!(size(300.0).abs() < 1e-3, "{}", size(300.0));
        let error = low_passed(&channel("F", 1000.0, wave(1.0)), 450.0).unwrap_err().to_string();
        assert!(error.contains("450 Hz") && error.contains("below 400 Hz"), "{error}");
    }
}
