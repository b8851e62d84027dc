//! The spindle drive: a first-order lag with a rate limit (chosen: no paper gives one;
//! [`crate::models::spindle`]). The defaults are those of a machine of this class.

use crate::models::spindle::ExactSpindle;

crate::settings! {
    /// The spindle drive.
    pub struct SpindleDriveSettings {
        /// Time constant of the speed control loop (chosen).
        time_constant_s: f64 = 0.2, [0.01, 5.0], "s", live, "Spindle lag";
        /// Largest rate of change of the speed (chosen).
        rate_rpm_s: f64 = 1000.0, [50.0, 100000.0], "1/min/s", live, "Spindle rate limit";
    }
}

/// The spindle with its state.
#[derive(Clone, Debug)]
pub struct SpindleDrive {
    exact: ExactSpindle,
    speed_rpm: f64,
}

impl SpindleDrive {
    /// Turning at `speed_rpm`, for steps of `dt_s`.
    #[must_use]
    pub fn new(settings: &SpindleDriveSettings, dt_s: f64, speed_rpm: f64) -> Self {
        let exact = ExactSpindle::new(settings.time_constant_s, settings.rate_rpm_s, dt_s);
        Self { exact, speed_rpm }
    }

    /// Takes over changed settings at the present speed.
    pub fn reconfigure(&mut self, settings: &SpindleDriveSettings, dt_s: f64) {
        *self = Self::new(settings, dt_s, self.speed_rpm);
    }

    /// The actual speed n_a in 1/min after one step.
    #[inline]
    pub fn update(&mut self, command_rpm: f64) -> f64 {
        self.speed_rpm = self.exact.advance(self.speed_rpm, command_rpm);
        self.speed_rpm
    }
}
