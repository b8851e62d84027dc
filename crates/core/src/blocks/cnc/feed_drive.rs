//! The feed drive of the machine: one of the papers' transfer functions, discretised exactly
//! ([`crate::models::feed_drive`]).

use crate::base::math;
use crate::models::feed_drive::{DriveState, ExactDrive, FeedDriveKind};

crate::settings! {
    /// The feed drive.
    pub struct FeedDriveSettings {
        /// Transfer function of the feed drive.
        kind: FeedDriveKind = FeedDriveKind::Eq3Of2007, [], "", live, "Feed drive";
    }
}

/// The drive with its state.
#[derive(Clone, Debug)]
pub struct FeedDrive {
    exact: ExactDrive,
    kind: FeedDriveKind,
    state: DriveState,
}

impl FeedDrive {
    /// At rest at `feed_mm_min`, for steps of `dt_s`.
    #[must_use]
    pub fn new(settings: &FeedDriveSettings, dt_s: f64, feed_mm_min: f64) -> Self {
        Self {
            exact: ExactDrive::new(settings.kind, dt_s),
            kind: settings.kind,
            state: DriveState::settled(feed_mm_min),
        }
    }

    /// At rest at `feed_mm_min`, as a new cut begins.
    pub fn restart(&mut self, feed_mm_min: f64) {
        self.state = DriveState::settled(feed_mm_min);
    }

    /// Another drive takes over at the feed of the old one.
    pub fn reconfigure(&mut self, settings: &FeedDriveSettings, dt_s: f64) {
        if settings.kind != self.kind {
            *self = Self::new(settings, dt_s, self.state.feed_mm_min());
        }
    }

    /// The actual feed f_a in mm/min after one step; not below zero (a milling feed does not
    /// reverse when a drive rings).
    #[inline]
    pub fn update(&mut self, command_mm_min: f64) -> f64 {
        self.exact.advance(&mut self.state, command_mm_min);
        math::positive(self.state.feed_mm_min())
    }
}
