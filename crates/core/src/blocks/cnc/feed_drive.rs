//! The feed drive of the machine: one of the papers' transfer functions, discretised exactly
//! ([`crate::models::feed_drive`]), or one of a user's own ([`crate::models::transfer`]).

use crate::base::math;
use crate::models::drive_curve::{DriveCurve, FeedReached};
use crate::models::feed_drive::{DriveState, ExactDrive, FeedDriveKind};
use crate::models::formula_model::OwnFormula;
use crate::models::transfer::{TransferDrive, TransferPoles};

crate::settings! {
    /// The feed drive.
    pub struct FeedDriveSettings {
        /// Transfer function of the feed drive.
        kind: FeedDriveKind = FeedDriveKind::Eq3Of2007, [], "", live, "Feed drive";
        /// Feed that is reached at rest as a formula of one's own over the feed that is asked for.
        curve: OwnFormula<FeedReached> = OwnFormula::default(), [], "", live, "Feed reached";
        /// Poles of a drive of one's own, in the place of the papers': up to order 8, stable; a pair by the pole with positive imaginary part.
        poles: TransferPoles = TransferPoles::default(), [], "", live, "Own feed drive";
        /// Feed over the feed that is asked for at rest, of a drive of one's own.
        gain: f64 = 1.0, [0.1, 10.0], "", live, "Own gain";
    }
}

/// The drive with its state.
#[derive(Clone, Debug)]
pub struct FeedDrive {
    exact: ExactDrive,
    kind: FeedDriveKind,
    curve: DriveCurve,
    state: DriveState,
    /// A drive of one's own, which then stands in the place of the other one.
    own: Option<TransferDrive>,
}

impl FeedDrive {
    /// At rest where it is asked for `feed_mm_min`, for steps of `dt_s`.
    #[must_use]
    pub fn new(settings: &FeedDriveSettings, dt_s: f64, feed_mm_min: f64) -> Self {
        let mut this = Self {
            exact: ExactDrive::new(settings.kind, dt_s),
            kind: settings.kind,
            curve: DriveCurve::new(&settings.curve),
            state: DriveState::settled(feed_mm_min),
            own: TransferDrive::new(&settings.poles, settings.gain, dt_s, feed_mm_min),
        };
        this.restart(feed_mm_min);
        this
    }

    /// At rest where it is asked for `feed_mm_min`, as a new cut begins.
    pub fn restart(&mut self, feed_mm_min: f64) {
        let reached_mm_min = self.curve.reached(feed_mm_min);
        self.state = DriveState::settled(reached_mm_min);
        if let Some(own) = &mut self.own {
            own.settle(reached_mm_min);
        }
    }

    /// Another drive takes over at the feed of the old one.
    pub fn reconfigure(&mut self, settings: &FeedDriveSettings, dt_s: f64) {
        self.curve = DriveCurve::new(&settings.curve);
        let feed_mm_min = self.feed_mm_min();
        let own = TransferDrive::new(&settings.poles, settings.gain, dt_s, feed_mm_min);
        if own.is_none() && self.own.is_some() {
            self.state = DriveState::settled(feed_mm_min);
        }
        self.own = own.map(|own| own.going_on(self.own));
        if settings.kind != self.kind {
            self.exact = ExactDrive::new(settings.kind, dt_s);
            self.kind = settings.kind;
            self.state = DriveState::settled(self.state.feed_mm_min());
        }
    }

    /// The actual feed f_a in mm/min after one step; not below zero (a milling feed does not
    /// reverse when a drive rings).
    #[inline]
    pub fn update(&mut self, command_mm_min: f64) -> f64 {
        let reached_mm_min = self.curve.reached(command_mm_min);
        if let Some(own) = &mut self.own {
            return math::positive(own.advance(reached_mm_min));
        }
        self.exact.advance(&mut self.state, reached_mm_min);
        math::positive(self.state.feed_mm_min())
    }

    /// The output of the drive that stands, mm/min.
    fn feed_mm_min(&self) -> f64 {
        self.own.map_or(self.state.feed_mm_min(), |own| own.output())
    }

    /// The actual feed, mm/min.
    #[must_use]
    pub fn actual(&self) -> f64 {
        math::positive(self.feed_mm_min())
    }

    /// Whether the last command lay within the range of a formula of one's own.
    #[must_use]
    #[inline]
    pub fn is_known(&self) -> bool {
        self.curve.is_known()
    }
}
