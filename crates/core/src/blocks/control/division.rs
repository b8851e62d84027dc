//! The divisional controller (2005, "delilni krmilnik"): the programmed feed divided by the
//! normalised force.
//!
//! ```text
//! static   u = F_ref / F_m
//! actual   u = u_a F_ref / F_m
//! command  u = u(k-1) (F_ref / F_m)^gamma
//! ```
//!
//! The paper calls it the quickest and simplest; the static reading alone is stable and poor in
//! accuracy as its Table 1 says: it is proportional control of gain 1 in the logarithm and leaves
//! an offset. The actual form has none; the command form is integral control in the logarithm and
//! needs gamma below 0.48 at a dead time of 40 ms.

use super::ControlSetup;
use super::law::{AtRest, ControlMoment};
use super::override_loop::{COMMAND_PATH, ForceController, ForceLaw, ForceSample};
use crate::base::equation::number;
use crate::base::language::text;
use crate::base::math::{self, limit};
use crate::models::printed::Printed;

crate::choice! {
    /// What the quotient multiplies.
    pub enum Divided {
        /// The programmed feed: the paper's reading.
        Programmed = "static", "programmed feed";
        /// The feed that the drive has reached.
        Actual = "actual", "actual feed";
        /// The command of the period before.
        Command = "command", "last command";
    }
}

crate::settings! {
    /// Settings of the divisional controller.
    pub struct DivisionSettings {
        /// What the quotient multiplies.
        divided: Divided = Divided::Programmed, [], "", live, "Divided";
        /// Exponent gamma of the quotient where the last command is divided.
        exponent: f64 = 0.15, [0.01, 1.0], "", live, "Exponent";
        /// Whether the force is corrected for the dead time (Smith predictor).
        smith: bool = false, [], "", live, "Smith predictor";
    }
}

/// Limits of the quotient.
const QUOTIENT: [f64; 2] = [0.2, 3.0];

/// The controller.
pub type Division = ForceController<DivisionLaw>;

/// The law; it has no state.
#[derive(Clone, Debug)]
pub struct DivisionLaw {
    settings: DivisionSettings,
}

impl ForceLaw for DivisionLaw {
    type Settings = DivisionSettings;
    const ABOUT: &'static str =
        "The divisional controller of 2005: programmed feed over normalised force.";

    fn new(settings: &DivisionSettings, _: &ControlSetup) -> Self {
        Self { settings: settings.clone() }
    }

    fn configure(&mut self, settings: &DivisionSettings, _: &ControlSetup) {
        self.settings = settings.clone();
    }

    fn smith(settings: &DivisionSettings) -> bool {
        settings.smith
    }

    fn update(&mut self, sample: &ForceSample) -> f64 {
        let quotient = limit(1.0 / sample.y, QUOTIENT[0], QUOTIENT[1]);
        match self.settings.divided {
            Divided::Programmed => quotient,
            Divided::Actual => sample.actual * quotient,
            Divided::Command => sample.sent * math::pow(quotient, self.settings.exponent),
        }
    }

    fn at_rest(settings: &DivisionSettings) -> AtRest {
        match settings.divided {
            Divided::Programmed => AtRest::WhereTheLawMeetsThePlant,
            Divided::Actual | Divided::Command => AtRest::OnReference,
        }
    }

    /// What was reached is asked for where it is divided, and by the Smith predictor.
    fn believes(settings: &DivisionSettings) -> &'static [&'static str] {
        if settings.smith || settings.divided == Divided::Actual { COMMAND_PATH } else { &[] }
    }

    fn left_out(settings: &DivisionSettings) -> &'static [&'static str] {
        if settings.divided == Divided::Command { &[] } else { &["exponent"] }
    }

    fn printed(settings: &DivisionSettings) -> Printed {
        match settings.divided {
            Divided::Programmed => Printed::new(
                "u = F_{ref} / F_m",
                text!(
                    "Combined system 2005, divisional controller, in words only: the reading that is \
                 stable and as poor in accuracy as its Table 1"
                ),
            ),
            Divided::Actual => Printed::new(
                "u = u_a F_{ref} / F_m",
                text!("chosen: the divisional controller of 2005 over the feed that was reached"),
            ),
            Divided::Command => Printed::new(
                "u = u_{before} (F_{ref} / F_m)^γ",
                text!("chosen: the divisional controller of 2005 over its last command"),
            ),
        }
    }

    fn explain(settings: &DivisionSettings, _: &ControlMoment) -> (String, String) {
        let formula = match settings.divided {
            Divided::Programmed => "u = 1 / y".to_owned(),
            Divided::Actual => "u = u_a / y".to_owned(),
            Divided::Command => format!("u = u_{{before}} y^{{-{}}}", number(settings.exponent)),
        };
        (formula, String::new())
    }
}
