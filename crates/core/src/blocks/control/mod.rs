//! Controllers: from the desired and the measured force to feed and speed requests, every control
//! period (20 ms by default).
//!
//! A controller is one file here and one line in the list below (CONTRIBUTING.md shows how). Its file
//! says all that the program knows of it ([`law::ControlLaw`]): settings, construction, take-over,
//! restart, law, limits, and the law in words.

#[macro_use]
mod registry;

mod belief;
mod interface;
pub mod law;
pub mod override_loop;
pub mod speed_supervisor;

pub use belief::Belief;
pub use interface::{
    ControlInput, ControlOutput, ControlSetup, Exceeded, FeedSpeed, Limits, OverloadReaction,
    Running,
};

use crate::base::settings::{Field, Group, Kind, Spec, Value};
use crate::models::genetic::ModelSet;
use crate::models::printed::Printed;
use law::{AtRest, ControlLaw, ControlMoment, Explained, Held};

/// The controller of a scenario that names none.
const DEFAULT: ControllerKind = ControllerKind::Sdnrp;

// Module, type, id in files and on the command line, name for people; in the order of files and lists.
controllers! {
    constant_feed::ConstantFeed = "constant_feed", "Conventional (constant feed)";
    sdnrp::Sdnrp = "sdnrp", "SDNRP";
    tracking::Tracking = "tracking", "Tracking";
    division::Division = "division", "Division";
    proportional::Proportional = "p", "P";
    adjustable_pi::AdjustablePi = "adjustable_pi", "Adjustable PI";
    mrac::Mrac = "mrac", "MRAC";
    unks::Unks = "unks", "UNKS";
    preview::Preview = "preview", "Preview";
    afc::Afc = "afc", "AFC";
    script::Script = "script", "Script";
}
