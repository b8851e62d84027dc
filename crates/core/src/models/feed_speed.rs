//! Feed and speed as controllers ask for them and machines limit them.

use super::genetic::force_formula::{FEED_MIN_MM_MIN, SPEED_MIN_RPM};

/// Feed below which a tool counts as standing, mm/min: a drive comes to rest exponentially and never quite
/// (chosen; at 400 1/min it is 0.6 um for a tooth of two, less than any edge can lift).
pub const STANDSTILL_MM_MIN: f64 = 0.5;

/// A pair of feed and spindle speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FeedSpeed {
    /// Feed, mm/min.
    pub feed_mm_min: f64,
    /// Spindle speed, 1/min.
    pub speed_rpm: f64,
}

impl FeedSpeed {
    /// Whether the tool is fed at all: a standing tool lifts no chip, however the spindle turns.
    #[must_use]
    #[inline]
    pub fn feeds(&self) -> bool {
        self.feed_mm_min >= STANDSTILL_MM_MIN
    }
}

/// Limits of the commands, from those of overrides and machine and the controller's own.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Feed range, mm/min.
    pub feed_mm_min: [f64; 2],
    /// Spindle speed range, 1/min.
    pub speed_rpm: [f64; 2],
    /// Steps in which commands are sent: a percent of the programmed values where overrides are
    /// whole percents, 0 where they are continuous.
    pub resolution: FeedSpeed,
}

impl Limits {
    /// The same, but where the force model holds: below [`FEED_MIN_MM_MIN`] the force no longer falls
    /// with the feed, and below [`SPEED_MIN_RPM`] the spindle would be stopped to raise the force.
    #[must_use]
    pub fn within_force_model(mut self) -> Self {
        let from = |[low, high]: [f64; 2], least: f64| [low.max(least).min(high), high];
        self.feed_mm_min = from(self.feed_mm_min, FEED_MIN_MM_MIN);
        self.speed_rpm = from(self.speed_rpm, SPEED_MIN_RPM);
        self
    }
}
