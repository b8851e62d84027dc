//! The spindle drive: no paper gives one, so it is a chosen first-order lag with a rate limit.
//!
//! n' = limit((n_c - n) / tau, -rate, rate): solved exactly over a step with held command, a
//! straight ramp while the lag asks for more than the rate, then the exponential.

use crate::base::math;

/// Slowest spindle at which the force tooth by tooth and a machine coupled to the cut hold, 1/min: the slowest
/// that can be programmed. Below it both still answer, marked as outside their range.
pub const SLOWEST_RPM: f64 = 100.0;

/// A spindle drive set up for one step length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExactSpindle {
    tau_s: f64,
    rate_rpm_s: f64,
    dt_s: f64,
    /// 1 - e^{-dt / tau}.
    rise: f64,
}

impl ExactSpindle {
    /// Time constant in s (positive), rate limit in 1/min per s (positive), step in s.
    #[must_use]
    pub fn new(tau_s: f64, rate_rpm_s: f64, dt_s: f64) -> Self {
        Self { tau_s, rate_rpm_s, dt_s, rise: 1.0 - math::exp(-dt_s / tau_s) }
    }

    /// The speed in 1/min one step later with the command in 1/min held over it: the exact solution of
    /// n' = limit((n_c - n)/tau, -rate, rate).
    #[must_use]
    #[inline]
    pub fn advance(&self, speed_rpm: f64, command_rpm: f64) -> f64 {
        let error = command_rpm - speed_rpm;
        let linear_error = self.rate_rpm_s * self.tau_s;
        if error.abs() <= linear_error {
            return speed_rpm + error * self.rise;
        }
        let ramp_s = (error.abs() - linear_error) / self.rate_rpm_s;
        if ramp_s >= self.dt_s {
            return speed_rpm + (self.rate_rpm_s * self.dt_s).copysign(error);
        }
        let rest = math::exp(-(self.dt_s - ramp_s) / self.tau_s);
        command_rpm - linear_error.copysign(error) * rest
    }
}

#[cfg(test)]
#[expect(clippy::disallowed_methods, reason = "the reference is independent of base::math")]
mod tests {
    use super::*;

    #[test]
    fn the_response_does_not_depend_on_the_step_and_meets_the_analytic_one() {
        let (tau, rate): (f64, f64) = (0.2, 1000.0);
        let analytic = |t: f64| {
            // 1500 -> 2300: error 800 > rate tau = 200, ramp for 0.6 s, then exponential.
            if t <= 0.6 { 1500.0 + rate * t } else { 2300.0 - 200.0 * (-(t - 0.6) / tau).exp() }
        };
        for dt in [1e-4, 1e-3, 0.007, 0.02, 0.5] {
            let drive = ExactSpindle::new(tau, rate, dt);
            let mut speed = 1500.0;
            for k in 1..=(2.0 / dt) as u32 {
                speed = drive.advance(speed, 2300.0);
                let t = f64::from(k) * dt;
                assert!((speed - analytic(t)).abs() < 1e-9, "dt {dt}, t {t}");
            }
        }
    }
}
