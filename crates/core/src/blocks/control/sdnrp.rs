//! SDNRP, the controller of the 2007 paper: proportional force feedback into the feed and speed
//! models.
//!
//! ```text
//! F_s = F_d + Kp (F_d - F_measured)
//! f_c = K2(F_s)      n_c = K3(F_s)
//! ```
//!
//! The paper's figures are lost; this reading fits its text and its Table 3. Kp is chosen: the
//! table cannot tell it. Proportional feedback leaves a steady-state error, which is the paper's
//! own result (Ra off by up to 31.6 % in its Table 3).

use super::{ControlInput, ControlOutput, FeedSpeed};

/// The gain at which K2 and K3 are identified, and the default.
pub const KP_DEFAULT: f64 = 0.5;

crate::settings! {
    /// Settings of SDNRP.
    pub struct SdnrpSettings {
        /// Proportional gain of the force feedback (chosen; K2 and K3 are identified at 0.5).
        kp: f64 = KP_DEFAULT, [0.0, 5.0], "", live, "Gain Kp";
    }
}

/// The controller; it has no state.
#[derive(Clone, Debug)]
pub struct Sdnrp {
    settings: SdnrpSettings,
}

impl Sdnrp {
    pub(super) fn new(settings: &SdnrpSettings) -> Self {
        Self { settings: settings.clone() }
    }

    pub(super) fn update(&mut self, input: &ControlInput) -> ControlOutput {
        let error_n = input.force_ref_n - input.force_measured_n;
        let force_setpoint_n = input.force_ref_n + self.settings.kp * error_n;
        let feed = input.models.feed_from_force(force_setpoint_n);
        let speed = input.models.speed_from_force(force_setpoint_n);
        ControlOutput {
            request: FeedSpeed { feed_mm_min: feed.value, speed_rpm: speed.value },
            force_setpoint_n,
            gain_estimate: 1.0,
            feed_model_valid: feed.valid,
            speed_model_valid: speed.valid,
        }
    }
}
