//! The peak of the force across the tool in every control period: what the milling simulator's
//! controllers see (2005: 576 samples of 28.8 kHz in 20 ms).
//!
//! ```text
//! F_m(k) = max over the window of sqrt((F_x + nu_x)^2 + (F_y + nu_y)^2)
//! ```

use crate::base::rng::Stream;
use crate::base::window::WindowMax;

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
    window: WindowMax<2>,
}

impl PeakWindow {
    /// Windows of `samples`, under `seed`, with a standard deviation of the sensor's noise in N.
    #[must_use]
    pub fn new(deviation_n: f64, seed: u32, samples: u64) -> Self {
        let stream = Stream::new(u64::from(seed), "noise.dynamometer");
        Self { stream, deviation_n, window: WindowMax::new(samples) }
    }

    /// Takes over another standard deviation in N.
    pub fn reconfigure(&mut self, deviation_n: f64) {
        self.deviation_n = deviation_n;
    }

    /// Forgets what was measured, as a new cut begins; the windows stay those of the controller.
    pub fn restart(&mut self) {
        self.window.restart();
    }

    /// Sample number `tick` of F_x and F_y in N; gives the peaks of the last whole window.
    #[inline]
    pub fn push(&mut self, tick: u64, [x, y]: [f64; 2]) -> Peak {
        let across = |x: f64, y: f64| (x * x + y * y).sqrt();
        let true_n = across(x, y);
        let measured_n = if self.deviation_n > 0.0 {
            let noise = |draw: u64| self.deviation_n * self.stream.normal(2 * tick + draw);
            across(x + noise(0), y + noise(1))
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

    #[test]
    fn a_window_holds_its_largest_force_until_the_next_is_whole() {
        let mut window = PeakWindow::new(0.0, 1, 3);
        let forces = [[3.0, 4.0], [0.0, 1.0], [1.0, 0.0], [0.0, 2.0], [0.0, 0.0], [0.0, 0.0]];
        let held: Vec<f64> =
            forces.iter().enumerate().map(|(k, f)| window.push(k as u64, *f).true_n).collect();
        assert_eq!(held, [0.0, 0.0, 5.0, 5.0, 5.0, 2.0]);
    }

    #[test]
    fn both_axes_have_noise_of_their_own() {
        let mut window = PeakWindow::new(6.0, 1, 1);
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
        let mut window = PeakWindow::new(6.0, 1, 576);
        let last = (0..576).map(|k| window.push(k, [100.0, 0.0])).last().unwrap();
        assert_eq!(last.true_n, 100.0);
        // The largest of 576 normal deviates lies near 3 standard deviations.
        assert!(last.measured_n > 112.0 && last.measured_n < 130.0, "{last:?}");
    }
}
