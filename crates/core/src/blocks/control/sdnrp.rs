//! SDNRP, the controller of the 2007 paper: proportional force feedback into the feed and speed
//! models.
//!
//! ```text
//! F_s = F_d + Kp (F_d - F_measured)
//! f_c = K2(F_s)      n_c = K3(F_s)
//! ```
//!
//! The paper's figures are lost; this reading fits its text and its Table 3. Kp is chosen: the
//! table does not determine it. Proportional feedback leaves a steady-state error, which is the paper's
//! own result (Ra off by up to 31.6 % in its Table 3).

use super::law::{AtRest, ControlLaw, ControlMoment, Explained, Held};
use super::{ControlInput, ControlOutput, ControlSetup, FeedSpeed};
use crate::base::equation::{Live, number};
use crate::base::language::text;
use crate::models::genetic::ModelSet;
use crate::models::printed::Printed;

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

impl ControlLaw for Sdnrp {
    type Settings = SdnrpSettings;
    const ABOUT: &'static str =
        "The 2007 paper's controller: proportional force feedback into K2 and K3.";
    const HELD: Held = Held::Roughness;

    fn new(settings: &SdnrpSettings, _: &ControlSetup, _: FeedSpeed) -> Self {
        Self { settings: settings.clone() }
    }

    fn configure(&mut self, settings: &SdnrpSettings, _: &ControlSetup) {
        self.settings = settings.clone();
    }

    fn restart(&mut self, _: FeedSpeed) {}

    fn update(&mut self, input: &ControlInput) -> ControlOutput {
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
            exceeded: None,
            switched_off: false,
        }
    }

    fn at_rest(_: &SdnrpSettings) -> AtRest {
        AtRest::WhereTheLawMeetsThePlant
    }

    fn printed(_: &SdnrpSettings, set: ModelSet) -> Vec<Printed> {
        let source = match set {
            // That of the milling simulator has the form of 2007.
            ModelSet::Sdnrp2007 | ModelSet::Milling2005 => {
                text!("SDNRP 2007, figures lost: the reading that fits text and Table 3")
            }
            ModelSet::Strategy2013 => {
                text!("Control strategy 2013, steps 5 to 7, in words only: read as in SDNRP 2007")
            }
        };
        vec![Printed::new("F_s = F_d + Kp (F_d - F_m)", source)]
    }

    fn explain(settings: &SdnrpSettings, moment: &ControlMoment) -> Explained {
        let (desired, measured) = (moment.force_ref_n, moment.force_measured_n);
        let kp = number(settings.kp);
        let setpoint = desired + settings.kp * (desired - measured);
        let law = Live::everywhere(
            format!("F_s = F_d + {kp} (F_d - F_m)"),
            format!(
                "F_s = {d} + {kp} ({d} - {}) = {} N",
                number(measured),
                number(setpoint),
                d = number(desired),
            ),
        );
        Explained { lines: vec![law], models_at_n: Some(setpoint), beside_name: format!("Kp {kp}") }
    }
}
