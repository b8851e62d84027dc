//! What the overrides leave of a command: their range, and the steps in which they are sent.

use super::feed_override::Cnc;
use crate::base::units::ratio_from_percent;
use crate::models::feed_speed::{FeedSpeed, Limits};

/// Limits of the commands around what is programmed, by the overrides alone.
#[must_use]
pub fn of_overrides(cnc: &Cnc, programmed: FeedSpeed) -> Limits {
    let percent = if cnc.override_quantised { ratio_from_percent(1.0) } else { 0.0 };
    Limits {
        feed_mm_min: cnc.range(programmed.feed_mm_min),
        speed_rpm: cnc.range(programmed.speed_rpm),
        resolution: FeedSpeed {
            feed_mm_min: programmed.feed_mm_min * percent,
            speed_rpm: programmed.speed_rpm * percent,
        },
    }
}
