//! What the CNC leaves of a command: the range of the overrides as far as the machine goes, and the steps in which
//! overrides are sent.

use super::feed_override::Cnc;
use crate::base::units::ratio_from_percent;
use crate::models::feed_speed::{FeedSpeed, Limits};

/// Limits of the commands around what is programmed, by overrides and machine, without a controller's own.
#[must_use]
pub fn of_machine(cnc: &Cnc, programmed: FeedSpeed) -> Limits {
    let percent = if cnc.override_quantised { ratio_from_percent(1.0) } else { 0.0 };
    Limits {
        feed_mm_min: cnc.range(programmed.feed_mm_min).map(|feed| cnc.feed_within(feed)),
        speed_rpm: cnc.range(programmed.speed_rpm).map(|speed| cnc.speed_within(speed)),
        resolution: FeedSpeed {
            feed_mm_min: programmed.feed_mm_min * percent,
            speed_rpm: programmed.speed_rpm * percent,
        },
    }
}
