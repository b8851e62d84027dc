//! The P controller, with an integral part if wanted (Tlusty and Elbestawi, cited in 2005).
//!
//! ```text
//! u = 1 + Kp (1 - y) + Ki sum(1 - y)
//! ```
//!
//! Kp = 1.1 is the stability limit at the heaviest section of Experiment 2 with 40 ms of dead time
//! (gain margin 2.04 of drive and dead time over a loop gain of 1.86 Kp); with the Smith predictor
//! 1.6 keeps its damping. The sum stands still while the override stands at a limit, and starts after
//! another controller where it asks for the override that is being sent.

use super::override_loop::{ForceLaw, ForceSample};

crate::settings! {
    /// Settings of the P controller.
    pub struct ProportionalSettings {
        /// Proportional gain on the relative force error (chosen by its stability limit).
        kp: f64 = 1.1, [0.0, 5.0], "", live, "Gain Kp";
        /// Integral gain per control period; 0 for pure P.
        ki: f64 = 0.0, [0.0, 1.0], "", live, "Integral gain";
        /// Whether the force is corrected for the dead time (Smith predictor).
        smith: bool = false, [], "", live, "Smith predictor";
    }
}

/// The law with its sum.
#[derive(Clone, Debug)]
pub struct Proportional {
    pub(super) settings: ProportionalSettings,
    pub(super) sum: f64,
}

impl ForceLaw for Proportional {
    fn update(&mut self, sample: &ForceSample) -> f64 {
        let error = 1.0 - sample.y;
        let [low, high] = sample.range;
        let kp = self.settings.kp;
        if sample.taken_over && self.settings.ki > 0.0 {
            self.sum = (sample.sent - 1.0 - kp * error) / self.settings.ki;
            return sample.sent;
        }
        let asked = 1.0 + kp * error + self.settings.ki * (self.sum + error);
        let winds_up = (asked > high && error > 0.0) || (asked < low && error < 0.0);
        if !winds_up {
            self.sum += error;
        }
        1.0 + kp * error + self.settings.ki * self.sum
    }
}
