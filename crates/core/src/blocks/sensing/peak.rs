//! The peak of the force across the tool in every control period: what the milling simulator's
//! controllers see (2005: 576 samples of 28.8 kHz in 20 ms).
//!
//! ```text
//! F_m(k) = max over the window of sqrt((F_x + nu_x)^2 + (F_y + nu_y)^2)
//! ```
//!
//! The sensor samples at a rate of its own, so that the largest of its noise does not depend on the plant
//! step: of a longer step it takes several samples, of shorter ones not each.

use crate::base::rng::Stream;
use crate::base::window::WindowMax;

/// Rate at which the sensor samples, 1/s.
const RATE_HZ: f64 = 28_800.0;
/// Room for the rounding of step lengths, in samples.
const HAIR: f64 = 1e-6;

/// The largest force of a window, true and as measured, N.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Peak {
    /// Without the sensor's noise.
    pub true_n: f64,
    /// With it.
    pub measured_n: f64,
}

/// The sensor with its running window and the last whole one.
#[derive(Clone, Debug)]
pub struct PeakWindow {
    stream: Stream,
    deviation_n: f64,
    samples_per_step: f64,
    window: WindowMax<2>,
}

impl PeakWindow {
    /// Windows of `steps` steps of `dt_s`, under `seed`, with a standard deviation of the sensor's noise in N.
    #[must_use]
    pub fn new(deviation_n: f64, seed: u32, steps: u64, dt_s: f64) -> Self {
        let stream = Stream::new(u64::from(seed), "noise.dynamometer");
        let samples_per_step = RATE_HZ * dt_s;
        Self { stream, deviation_n, samples_per_step, window: WindowMax::new(steps) }
    }

    /// Takes over another standard deviation in N.
    pub fn reconfigure(&mut self, deviation_n: f64) {
        self.deviation_n = deviation_n;
    }

    /// Forgets what was measured, as a new cut begins; the windows stay those of the controller.
    pub fn restart(&mut self) {
        self.window.restart();
    }

    /// F_x and F_y in N of step number `tick`; gives the peaks of the last whole window.
    #[inline]
    pub fn push(&mut self, tick: u64, [x, y]: [f64; 2]) -> Peak {
        let across = |x: f64, y: f64| (x * x + y * y).sqrt();
        let true_n = across(x, y);
        let measured_n = if self.deviation_n > 0.0 {
            let before = |tick: u64| (tick as f64 * self.samples_per_step + HAIR) as u64;
            let noise = |draw: u64| self.deviation_n * self.stream.normal(draw);
            let taken = before(tick)..before(tick + 1);
            taken.map(|k| across(x + noise(2 * k), y + noise(2 * k + 1))).fold(0.0, f64::max)
        } else {
            true_n
        };
        let [true_n, measured_n] = self.window.push(tick, [true_n, measured_n]);
        Peak { true_n, measured_n }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const STEP_S: f64 = 1.0 / RATE_HZ;

    #[test]
    fn a_window_holds_its_largest_force_until_the_next_is_whole() {
        let mut window = PeakWindow::new(0.0, 1, 3, STEP_S);
        let forces = [[3.0, 4.0], [0.0, 1.0], [1.0, 0.0], [0.0, 2.0], [0.0, 0.0], [0.0, 0.0]];
        let held: Vec<f64> =
            forces.iter().enumerate().map(|(k, f)| window.push(k as u64, *f).true_n).collect();
        assert_eq!(held, [0.0, 0.0, 5.0, 5.0, 5.0, 2.0]);
    }

    #[test]
    fn both_axes_have_noise_of_their_own() {
        let mut window = PeakWindow::new(6.0, 1, 1, STEP_S);
        let n = 20_000_u32;
        let squares: Vec<f64> = (0..u64::from(n))
            .map(|k| window.push(k, [0.0, 0.0]).measured_n)
            .map(|measured_n| measured_n * measured_n)
            .collect();
        let mean = squares.iter().sum::<f64>() / f64::from(n);
        let fourth = squares.iter().map(|square| square * square).sum::<f64>() / f64::from(n);
        assert!((mean / 72.0 - 1.0).abs() < 0.03, "{mean}");
        // Of two independent deviates the sum of squares is exponential; of one twice it would be 3.
        assert!((fourth / (mean * mean) - 2.0).abs() < 0.1, "{}", fourth / (mean * mean));
    }

    #[test]
    fn noise_is_measured_but_not_true() {
        let mut window = PeakWindow::new(6.0, 1, 576, STEP_S);
        let last = (0..576).map(|k| window.push(k, [100.0, 0.0])).last().unwrap();
        assert_eq!(last.true_n, 100.0);
        // The largest of 576 normal deviates lies near 3 standard deviations.
        assert!(last.measured_n > 112.0 && last.measured_n < 130.0, "{last:?}");
    }

    #[test]
    fn the_largest_noise_does_not_depend_on_the_step() {
        // Under a force that stands still every step length sees the same samples.
        let peaks = [200, 288, 576].map(|steps| {
            let mut window = PeakWindow::new(6.0, 1, steps, 0.02 / steps as f64);
            (0..5 * steps).map(|k| window.push(k, [100.0, 0.0]).measured_n).last().unwrap()
        });
        assert_eq!(peaks, [peaks[0]; 3]);
        // A finer step only takes them later.
        let mut fine = PeakWindow::new(6.0, 1, 1000, 2e-5);
        let last = (0..5000).map(|k| fine.push(k, [100.0, 0.0]).measured_n).last();
        assert_eq!(last, Some(peaks[0]));
    }
}
