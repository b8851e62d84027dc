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

use super::override_loop::{ForceLaw, ForceSample};
use crate::base::math::{self, limit};

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

/// The law; it has no state.
#[derive(Clone, Debug)]
pub struct Division {
    pub(super) settings: DivisionSettings,
}

impl ForceLaw for Division {
    fn update(&mut self, sample: &ForceSample) -> f64 {
        let quotient = limit(1.0 / sample.y, QUOTIENT[0], QUOTIENT[1]);
        match self.settings.divided {
            Divided::Programmed => quotient,
            Divided::Actual => sample.actual * quotient,
            Divided::Command => sample.sent * math::pow(quotient, self.settings.exponent),
        }
    }
}
