//! The PI controller with adjustable gain (Stute and Goetz, cited in 2005): its gain is divided by
//! the estimated force at 100 % override.
//!
//! ```text
//! F_m = K u_a        K by recursive least squares with forgetting, in units of F_ref:
//! P   = P / (lambda + u_a^2 P)      K += P u_a (y - K u_a)      K >= 0.15
//! u  += [Kp (e - e_before) + Ki e] / K      e = 1 - y
//! ```
//!
//! The velocity form needs no other anti-windup: u is the override that was really sent.

use super::ControlSetup;
use super::law::{AtRest, ControlMoment};
use super::override_loop::{ForceController, ForceLaw, ForceSample};
use crate::base::equation::number;
use crate::base::language::text;
use crate::models::printed::Printed;

crate::settings! {
    /// Settings of the adjustable PI controller.
    pub struct AdjustablePiSettings {
        /// Proportional gain (chosen).
        kp: f64 = 0.35, [0.0, 5.0], "", live, "Gain Kp";
        /// Integral gain per control period (chosen).
        ki: f64 = 0.12, [0.0, 1.0], "", live, "Integral gain Ki";
        /// Forgetting factor lambda of the estimate (chosen).
        forgetting: f64 = 0.8, [0.5, 1.0], "", live, "Forgetting";
        /// Whether the force is corrected for the dead time (Smith predictor).
        smith: bool = false, [], "", live, "Smith predictor";
    }
}

/// Least estimate: a lighter cut does not raise the gain any more.
const GAIN_MIN: f64 = 0.15;

/// The controller.
pub type AdjustablePi = ForceController<AdjustablePiLaw>;

/// The law with its estimate.
#[derive(Clone, Debug)]
pub struct AdjustablePiLaw {
    settings: AdjustablePiSettings,
    gain: f64,
    covariance: f64,
    error_before: f64,
}

impl ForceLaw for AdjustablePiLaw {
    type Settings = AdjustablePiSettings;
    const ABOUT: &'static str =
        "PI force control whose gain follows the estimated force gain (2005).";

    fn new(settings: &AdjustablePiSettings, _: &ControlSetup) -> Self {
        Self { settings: settings.clone(), gain: 1.0, covariance: 1.0, error_before: 0.0 }
    }

    fn configure(&mut self, settings: &AdjustablePiSettings, _: &ControlSetup) {
        self.settings = settings.clone();
    }

    fn smith(settings: &AdjustablePiSettings) -> bool {
        settings.smith
    }

    fn update(&mut self, sample: &ForceSample) -> f64 {
        let (y, a) = (sample.y, sample.actual);
        let error = 1.0 - y;
        if sample.entered {
            (self.gain, self.covariance, self.error_before) = (y / a, 1.0, error);
        }
        self.covariance /= self.settings.forgetting + a * a * self.covariance;
        self.gain += self.covariance * a * (y - self.gain * a);
        self.gain = self.gain.max(GAIN_MIN);
        let AdjustablePiSettings { kp, ki, .. } = self.settings;
        let step = (kp * (error - self.error_before) + ki * error) / self.gain;
        self.error_before = error;
        // After another controller the first override is the one that is being sent.
        if sample.taken_over { sample.sent } else { sample.sent + step }
    }

    fn gain(&self) -> f64 {
        self.gain
    }

    fn at_rest(_: &AdjustablePiSettings) -> AtRest {
        AtRest::OnReference
    }

    fn printed(_: &AdjustablePiSettings) -> Printed {
        Printed::new(
            "u = u_{before} + [Kp (e - e_{before}) + Ki e] / K,  e = 1 - F_m / F_{ref}",
            text!(
                "Stute and Goetz, cited in Combined system 2005; gains chosen, K by recursive least \
             squares with forgetting"
            ),
        )
    }

    fn explain(settings: &AdjustablePiSettings, moment: &ControlMoment) -> (String, String) {
        let [kp, ki] = [settings.kp, settings.ki].map(number);
        let formula = format!("u grows by [{kp} (e - e_{{before}}) + {ki} e] / K,  e = 1 - y");
        (formula, format!("K = {}", number(moment.gain_estimate)))
    }
}
