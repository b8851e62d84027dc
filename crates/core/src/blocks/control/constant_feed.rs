//! Constant feed: f_c and n_c stay at fixed overrides of the programmed values. The reference that
//! every adaptive controller is compared with; with the override sliders it is also the manual
//! mode of a machine.

use super::{ControlInput, ControlOutput, FeedSpeed};
use crate::base::units::ratio_from_percent;

crate::settings! {
    /// Settings of constant feed.
    pub struct ConstantFeedSettings {
        /// Feed override, in percent of the programmed feed.
        feed_percent: f64 = 100.0, [0.0, 250.0], "%", live, "Feed override";
        /// Spindle override, in percent of the programmed speed.
        speed_percent: f64 = 100.0, [0.0, 250.0], "%", live, "Spindle override";
    }
}

/// The controller; it has no state.
#[derive(Clone, Debug)]
pub struct ConstantFeed {
    settings: ConstantFeedSettings,
}

impl ConstantFeed {
    pub(super) fn new(settings: &ConstantFeedSettings) -> Self {
        Self { settings: settings.clone() }
    }

    pub(super) fn update(&mut self, input: &ControlInput) -> ControlOutput {
        let feed = ratio_from_percent(self.settings.feed_percent);
        let speed = ratio_from_percent(self.settings.speed_percent);
        ControlOutput {
            request: FeedSpeed {
                feed_mm_min: input.programmed.feed_mm_min * feed,
                speed_rpm: input.programmed.speed_rpm * speed,
            },
            force_setpoint_n: input.force_ref_n,
            gain_estimate: 1.0,
            feed_model_valid: true,
            speed_model_valid: true,
        }
    }
}
