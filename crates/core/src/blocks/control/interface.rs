//! What passes between the loop and a controller.

pub use crate::models::feed_speed::{FeedSpeed, Limits};

use super::{Belief, ControllerSettings};
use crate::models::genetic::GeneticModels;
use crate::models::part::ProgrammedPart;
use crate::models::tool::Tool;

/// What a controller sees at the start of a control period.
#[derive(Clone, Copy, Debug)]
pub struct ControlInput<'a> {
    /// Measured force of the tick before, N.
    pub force_measured_n: f64,
    /// Desired force F_d, N (positive).
    pub force_ref_n: f64,
    /// Programmed feed and speed (100 % override).
    pub programmed: FeedSpeed,
    /// The command that was really sent in the period before, after all limits.
    pub applied: FeedSpeed,
    /// Limits of the command to come.
    pub limits: Limits,
    /// The controller's models.
    pub models: &'a GeneticModels,
    /// The cut that the machine is in, counted from 0.
    pub cut: usize,
    /// Where along it the tool's axis stands by the machine's own reading, mm from where the programmed
    /// part begins.
    pub x_mm: f64,
    /// Factor of the operator's hand on the feed, beside all commands; 1 where nobody turns it.
    pub by_hand: f64,
}

/// What a controller asks for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ControlOutput {
    /// Requested feed and speed, before limits; finite.
    pub request: FeedSpeed,
    /// The force that the models were asked for: F_s of SDNRP, F_d / gain of Tracking, N.
    pub force_setpoint_n: f64,
    /// The controller's estimate of true over modelled force (1 where it has none).
    pub gain_estimate: f64,
    /// Whether K2 was used inside its range.
    pub feed_model_valid: bool,
    /// Whether K3 was used inside its range.
    pub speed_model_valid: bool,
    /// A force that has been over the controller's own limit for too long; none with most of them.
    pub exceeded: Option<Exceeded>,
    /// Whether the controller has switched itself off, and the feed is as programmed.
    pub switched_off: bool,
}

/// A force over a controller's own limit, and what the controller wants done.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exceeded {
    /// The limit, N.
    pub limit_n: f64,
    /// What is to be done.
    pub reaction: OverloadReaction,
}

crate::choice! {
    /// What is done where a force stays over a controller's own limit.
    pub enum OverloadReaction {
        /// It is said, and the cut goes on.
        Message = "message", "message";
        /// The feed stops at once, past the dead time, for good; the tool stays in the cut.
        Stop = "stop", "stop";
        /// The feed stops for good and the tool is lifted off the work, which takes no time here, as
        /// the way back between two cuts takes none.
        RetractStop = "retract_stop", "retract and stop";
    }
}

/// The inputs to the construction of a controller.
#[derive(Clone, Copy, Debug)]
pub struct ControlSetup<'a> {
    /// Which controller, and the settings of each.
    pub settings: &'a ControllerSettings,
    /// The part as programmed.
    pub part: ProgrammedPart<'a>,
    /// The cutter that cuts it.
    pub tool: &'a Tool,
    /// The controller's beliefs.
    pub belief: &'a Belief,
    /// Control period, s.
    pub period_s: f64,
}

/// A running machine that a controller takes over.
#[derive(Clone, Copy, Debug)]
pub struct Running {
    /// Programmed feed and speed of the present cut.
    pub programmed: FeedSpeed,
    /// Feed and speed that the drives have reached.
    pub actual: FeedSpeed,
    /// The command under way.
    pub sent: FeedSpeed,
}
