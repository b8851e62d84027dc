//! The outer loop around the controller: the programmed speed is adjusted so that the tool reaches the
//! desired life (2019, the adaptive use of the prediction).
//!
//! ```text
//! v_new = v [ R/R_des ]^n_Taylor,   R = (T_hat - a) T(now)/T(programmed),   R_des = T_des - t
//! ```
//!
//! R is the remaining life predicted at the present speed, R_des the one wanted; every ten minutes of the
//! tool's life. The feed per tooth stays, so the programmed feed goes with the speed. It is felt where a
//! controller holds the programmed speed: at constant feed and under the force controllers.

use super::FeedSpeed;
use crate::base::math;
use crate::models::machine_trend::LifeSettings;
use crate::models::wear::WearSettings;

/// Minutes of the tool's life between two adjustments (chosen).
pub const PERIOD_MIN: u32 = 10;
/// The speed stays between these ratios to the programmed one (chosen: the range of the overrides).
pub const SPEED_RATIOS: [f64; 2] = [0.5, 1.5];
/// No adjustment in the last minutes: the remaining life wanted is too short to divide by.
pub const LAST_MIN: f64 = 10.0;

/// The speed in place of `speed`, in the unit of `programmed`, that makes of a remaining life in minutes
/// the one wanted; `None` in the last minutes.
#[must_use]
pub fn adjusted(
    speed: f64,
    programmed: f64,
    [remaining_min, wanted_min]: [f64; 2],
    taylor_exponent: f64,
) -> Option<f64> {
    if wanted_min < LAST_MIN {
        return None;
    }
    let ratio = math::pow(remaining_min / wanted_min, taylor_exponent);
    let [low, high] = SPEED_RATIOS.map(|share| share * programmed);
    Some(math::limit(speed * ratio, low, high))
}

/// The supervisor with its state.
#[derive(Clone, Debug)]
pub struct SpeedSupervisor {
    desired_min: f64,
    taylor_exponent: f64,
    time_scale: f64,
    /// Minutes in cut; the next adjustment.
    time_min: f64,
    next_min: f64,
    /// Speed over the programmed one.
    ratio: f64,
}

impl SpeedSupervisor {
    /// At the programmed speed, with a tool that has cut for `age_min`.
    #[must_use]
    pub fn new(wear: &WearSettings, life: &LifeSettings, age_min: f64) -> Self {
        Self {
            desired_min: life.tool_life_min,
            taylor_exponent: wear.taylor_exponent,
            time_scale: wear.time_scale,
            time_min: age_min,
            next_min: age_min + f64::from(PERIOD_MIN),
            ratio: 1.0,
        }
    }

    /// Takes over changed settings; time and speed stay.
    pub fn reconfigure(&mut self, wear: &WearSettings, life: &LifeSettings) {
        self.desired_min = life.tool_life_min;
        self.taylor_exponent = wear.taylor_exponent;
        self.time_scale = wear.time_scale;
    }

    /// Feed and speed in place of the programmed ones.
    #[must_use]
    pub fn adjust(&self, programmed: FeedSpeed) -> FeedSpeed {
        FeedSpeed {
            feed_mm_min: self.ratio * programmed.feed_mm_min,
            speed_rpm: self.ratio * programmed.speed_rpm,
        }
    }

    /// Lets `dt_s` of the run pass in the cut; `wear.time_scale` times as much of the tool's life does.
    pub fn pass(&mut self, dt_s: f64) {
        self.time_min += self.time_scale * dt_s / 60.0;
    }

    /// Takes a remaining life in minutes as predicted at the present speed.
    pub fn predict(&mut self, remaining_min: f64) {
        let wanted_min = self.desired_min - self.time_min;
        if self.time_min < self.next_min {
            return;
        }
        let lives_min = [remaining_min, wanted_min];
        if let Some(ratio) = adjusted(self.ratio, 1.0, lives_min, self.taylor_exponent) {
            self.next_min = self.time_min + f64::from(PERIOD_MIN);
            self.ratio = ratio;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_speed_follows_taylor_within_its_limits_and_stays_in_the_last_minutes() {
        let speed = adjusted(1.0, 1.0, [120.0, 100.0], 0.25).unwrap();
        assert!((speed - math::pow(1.2, 0.25)).abs() < 1e-12, "{speed}");
        let [low, high] = SPEED_RATIOS;
        assert_eq!(adjusted(1.0, 1.0, [1e6, 100.0], 0.25), Some(high));
        assert_eq!(adjusted(1.0, 1.0, [1e-6, 100.0], 0.25), Some(low));
        assert_eq!(adjusted(90.0, 80.0, [1e6, 100.0], 0.25), Some(80.0 * high));
        assert_eq!(adjusted(1.0, 1.0, [100.0, 0.99 * LAST_MIN], 0.25), None);
    }
}
