//! Beliefs: what a controller takes for true of machine and cut.

use crate::models::feed_drive::{DEAD_TIME_MAX_S, FeedDriveKind};
use crate::models::genetic::{Calibration, ModelSet};

crate::settings! {
    /// What the controller believes about machine and cut; it may differ from the truth.
    pub struct Belief {
        /// Set of models that the controller computes with.
        model_set: ModelSet = ModelSet::Sdnrp2007, [], "", live, "Controller's model set";
        /// Calibration of the models that the controller computes with.
        calibration: Calibration = Calibration::Identified, [], "", live, "Model calibration";
        /// Feed drive that the controller's predictor assumes.
        feed_drive: FeedDriveKind = FeedDriveKind::Eq3Of2007, [], "", live, "Assumed feed drive";
        /// Dead time that the controller's predictor assumes.
        dead_time_s: f64 = 0.08, [0.0, DEAD_TIME_MAX_S], "s", live, "Assumed dead time";
        /// Spindle time constant that the controller's predictor assumes.
        spindle_time_constant_s: f64 = 0.2, [0.01, 5.0], "s", live, "Assumed spindle lag";
        /// Spindle rate limit that the controller's predictor assumes.
        spindle_rate_rpm_s: f64 = 1000.0, [50.0, 100000.0], "1/min/s", live, "Assumed spindle rate";
        /// Error of the depths that a controller with preview believes in: by this the believed part is
        /// deeper than the programmed one.
        depth_error_percent: f64 = 0.0, [-30.0, 30.0], "%", live, "Depth error";
        /// Error of the place where it believes the part to be; positive is further along the cut.
        position_error_mm: f64 = 0.0, [-5.0, 5.0], "mm", live, "Position error";
    }
}
