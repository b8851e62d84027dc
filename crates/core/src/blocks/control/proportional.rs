//! The P controller, with an integral part if wanted (Tlusty and Elbestawi, cited in 2005).
//!
//! ```text
//! u = 1 + Kp (1 - y) + Ki sum(1 - y)
//! ```
//!
//! Kp = 1.1 is the stability limit at the heaviest section of Experiment 2 with 40 ms of dead time
//! (gain margin 2.04 of drive and dead time over a loop gain of 1.86 Kp); with the Smith predictor
//! 1.6 keeps its damping. The sum stands still while the override stands at a limit, and starts after
//! another controller where it asks for the override that is being sent.

use super::ControlSetup;
use super::law::{AtRest, ControlMoment};
use super::override_loop::{COMMAND_PATH, ForceController, ForceLaw, ForceSample};
use crate::base::equation::number;
use crate::base::language::text;
use crate::models::printed::Printed;

crate::settings! {
    /// Settings of the P controller.
    pub struct ProportionalSettings {
        /// Proportional gain on the relative force error (chosen by its stability limit).
        kp: f64 = 1.1, [0.0, 5.0], "", live, "Gain Kp";
        /// Integral gain per control period; 0 for pure P.
        ki: f64 = 0.0, [0.0, 1.0], "", live, "Integral gain Ki";
        /// Whether the force is corrected for the dead time (Smith predictor).
        smith: bool = false, [], "", live, "Smith predictor";
    }
}

/// The controller.
pub type Proportional = ForceController<ProportionalLaw>;

/// The law with its sum.
#[derive(Clone, Debug)]
pub struct ProportionalLaw {
    settings: ProportionalSettings,
    sum: f64,
}

impl ForceLaw for ProportionalLaw {
    type Settings = ProportionalSettings;
    const ABOUT: &'static str = "Proportional force control (2005), integral part optional.";

    fn new(settings: &ProportionalSettings, _: &ControlSetup) -> Self {
        Self { settings: settings.clone(), sum: 0.0 }
    }

    fn configure(&mut self, settings: &ProportionalSettings, _: &ControlSetup) {
        self.settings = settings.clone();
    }

    fn smith(settings: &ProportionalSettings) -> bool {
        settings.smith
    }

    fn restart(&mut self) {
        self.sum = 0.0;
    }

    fn update(&mut self, sample: &ForceSample) -> f64 {
        let error = 1.0 - sample.y;
        let [low, high] = sample.range;
        let kp = self.settings.kp;
        if sample.taken_over && self.settings.ki > 0.0 {
            self.sum = (sample.sent - 1.0 - kp * error) / self.settings.ki;
            return sample.sent;
        }
        let asked = 1.0 + kp * error + self.settings.ki * (self.sum + error);
        let winds_up = (asked > high && error > 0.0) || (asked < low && error < 0.0);
        if !winds_up {
            self.sum += error;
        }
        1.0 + kp * error + self.settings.ki * self.sum
    }

    fn at_rest(settings: &ProportionalSettings) -> AtRest {
        if settings.ki > 0.0 { AtRest::OnReference } else { AtRest::WhereTheLawMeetsThePlant }
    }

    /// What was reached has no part in it; the Smith predictor asks for it.
    fn believes(settings: &ProportionalSettings) -> &'static [&'static str] {
        if settings.smith { COMMAND_PATH } else { &[] }
    }

    fn printed(_: &ProportionalSettings) -> Printed {
        Printed::new(
            "u = 1 + Kp (1 - y) + Ki Σ(1 - y),  y = F_m / F_{ref}",
            text!("Tlusty and Elbestawi, cited in Combined system 2005; gains chosen"),
        )
    }

    fn explain(settings: &ProportionalSettings, _: &ControlMoment) -> (String, String) {
        let kp = number(settings.kp);
        (format!("u = 1 + {kp} (1 - y) + Ki Σ(1 - y)"), String::new())
    }
}
