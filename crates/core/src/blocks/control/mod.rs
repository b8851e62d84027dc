//! Controllers: from the desired and the measured force to feed and speed requests, every control
//! period (20 ms by default). A new controller is one file here and a line in each of the two
//! lists below marked `register`.

pub mod adjustable_pi;
pub mod constant_feed;
pub mod division;
pub mod mrac;
pub mod override_loop;
pub mod preview;
pub mod proportional;
pub mod sdnrp;
pub mod tracking;
pub mod unks;

use crate::models::feed_drive::FeedDriveKind;
use crate::models::genetic::{Calibration, GeneticModels, ModelSet};
use crate::models::part::ProgrammedPart;

crate::choice! {
    /// A controller.
    pub enum ControllerKind {
        /// Programmed feed and speed at fixed overrides: conventional milling without control.
        ConstantFeed = "constant_feed", "Constant feed";
        /// The 2007 paper's controller: proportional force feedback into K2 and K3.
        Sdnrp = "sdnrp", "SDNRP";
        /// Model inverse with integral action, anti-windup and a Smith predictor.
        Tracking = "tracking", "Tracking";
        /// The divisional controller of 2005: programmed feed over normalised force.
        Division = "division", "Division";
        /// Proportional force control (2005), integral part optional.
        Proportional = "p", "P";
        /// PI force control whose gain follows the estimated force gain (2005).
        AdjustablePi = "adjustable_pi", "Adjustable PI";
        /// Model-reference adaptive control (2005).
        Mrac = "mrac", "MRAC";
        /// The neural control scheme of 2005, its networks learning in the cut.
        Unks = "unks", "UNKS";
        /// Looks ahead in the programmed part: the feed that the force allows where the command will act.
        Preview = "preview", "Preview";
    }
}

impl ControllerKind {
    /// Whether it is one of the force controllers of 2005, which compute without force models.
    #[must_use]
    pub fn is_force_controller(self) -> bool {
        !matches!(self, Self::ConstantFeed | Self::Sdnrp | Self::Tracking)
    }
}

crate::settings! {
    /// Which controller closes the loop.
    pub struct ControllerChoice {
        /// The controller that moves feed and spindle speed.
        kind: ControllerKind = ControllerKind::Sdnrp, [], "", live, "Controller";
    }
}

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
        dead_time_s: f64 = 0.08, [0.0, 0.5], "s", live, "Assumed dead time";
        /// Spindle time constant that the controller's predictor assumes.
        spindle_time_constant_s: f64 = 0.2, [0.01, 5.0], "s", live, "Assumed spindle lag";
        /// Spindle rate limit that the controller's predictor assumes.
        spindle_rate_rpm_s: f64 = 1000.0, [50.0, 100000.0], "rpm/s", live, "Assumed spindle rate";
        /// Error of the depths that a controller with preview believes in: it takes the programmed
        /// part for so much deeper.
        depth_error_percent: f64 = 0.0, [-30.0, 30.0], "%", live, "Depth error";
        /// Error of the place where it believes the part to be: so much further along the cut.
        position_error_mm: f64 = 0.0, [-5.0, 5.0], "mm", live, "Position error";
    }
}

/// Limits of the commands, from the override limits and the force model's lower end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Feed range, mm/min.
    pub feed_mm_min: [f64; 2],
    /// Spindle speed range, 1/min.
    pub speed_rpm: [f64; 2],
    /// Steps in which commands are sent: a percent of the programmed values where overrides are
    /// whole percents, 0 where they are continuous.
    pub resolution: FeedSpeed,
}

/// A pair of feed and spindle speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FeedSpeed {
    /// Feed, mm/min.
    pub feed_mm_min: f64,
    /// Spindle speed, 1/min.
    pub speed_rpm: f64,
}

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
}

/// Everything that a controller is set up from.
#[derive(Clone, Copy, Debug)]
pub struct ControlSetup<'a> {
    /// Which controller.
    pub kind: ControllerKind,
    /// Settings of constant feed.
    pub constant_feed: &'a constant_feed::ConstantFeedSettings,
    /// Settings of SDNRP.
    pub sdnrp: &'a sdnrp::SdnrpSettings,
    /// Settings of Tracking.
    pub tracking: &'a tracking::TrackingSettings,
    /// Settings of the divisional controller.
    pub division: &'a division::DivisionSettings,
    /// Settings of the P controller.
    pub proportional: &'a proportional::ProportionalSettings,
    /// Settings of the adjustable PI controller.
    pub adjustable_pi: &'a adjustable_pi::AdjustablePiSettings,
    /// Settings of the model-reference adaptive controller.
    pub mrac: &'a mrac::MracSettings,
    /// Settings of the neural control scheme.
    pub unks: &'a unks::UnksSettings,
    /// Settings of the controller with preview.
    pub preview: &'a preview::PreviewSettings,
    /// The part as programmed.
    pub part: ProgrammedPart<'a>,
    /// The controller's beliefs.
    pub belief: &'a Belief,
    /// Control period, s.
    pub period_s: f64,
}

/// A controller with its state.
#[derive(Clone, Debug)]
pub enum Controller {
    /// See [`constant_feed`].
    ConstantFeed(constant_feed::ConstantFeed),
    /// See [`sdnrp`].
    Sdnrp(sdnrp::Sdnrp),
    /// See [`tracking`].
    Tracking(Box<tracking::Tracking>),
    /// See [`override_loop`].
    Force(Box<override_loop::ForceController>),
}

impl Controller {
    /// A controller at the start of a run, the machine at rest at the programmed values.
    #[must_use]
    pub fn new(setup: &ControlSetup, programmed: FeedSpeed) -> Self {
        match setup.kind {
            // register: construction
            ControllerKind::ConstantFeed => {
                Self::ConstantFeed(constant_feed::ConstantFeed::new(setup.constant_feed))
            }
            ControllerKind::Sdnrp => Self::Sdnrp(sdnrp::Sdnrp::new(setup.sdnrp)),
            ControllerKind::Tracking => {
                Self::Tracking(Box::new(tracking::Tracking::new(setup, programmed)))
            }
            _ => Self::Force(Box::new(override_loop::ForceController::new(setup))),
        }
    }

    /// Takes over changed settings and keeps its state if it is still the same kind; otherwise a
    /// new controller takes over a machine that runs at `current` under the command `sent`.
    /// What has a state does so without a bump of the feed; constant feed, SDNRP, static division
    /// and P are static laws and have none to match.
    pub fn reconfigure(
        &mut self,
        setup: &ControlSetup,
        programmed: FeedSpeed,
        current: FeedSpeed,
        sent: FeedSpeed,
    ) {
        if let Self::Force(controller) = self
            && controller.configure(setup)
        {
            return;
        }
        match (&mut *self, setup.kind) {
            (Self::Tracking(tracking), ControllerKind::Tracking) => tracking.configure(setup),
            (_, ControllerKind::Tracking) => {
                *self =
                    Self::Tracking(Box::new(tracking::Tracking::take_over(setup, current, sent)));
            }
            (_, ControllerKind::ConstantFeed | ControllerKind::Sdnrp) => {
                *self = Self::new(setup, current);
            }
            _ => {
                let of = |feed: f64| feed / programmed.feed_mm_min;
                let (actual, sent) = (of(current.feed_mm_min), of(sent.feed_mm_min));
                *self = Self::Force(Box::new(override_loop::ForceController::take_over(
                    setup, actual, sent,
                )));
            }
        }
    }

    /// A new cut begins at the programmed values: what was learned stays, dynamic state goes.
    pub fn restart(&mut self, programmed: FeedSpeed) {
        match self {
            Self::ConstantFeed(_) | Self::Sdnrp(_) => {}
            Self::Tracking(tracking) => tracking.restart(programmed),
            Self::Force(controller) => controller.restart(),
        }
    }

    /// What can be seen of the networks that learn in the cut; none where there are none.
    #[must_use]
    pub fn learning(&self) -> Option<unks::Learning<'_>> {
        match self {
            Self::Force(controller) => controller.learning(),
            _ => None,
        }
    }

    /// One control period.
    pub fn update(&mut self, input: &ControlInput) -> ControlOutput {
        match self {
            // register: update
            Self::ConstantFeed(controller) => controller.update(input),
            Self::Sdnrp(controller) => controller.update(input),
            Self::Tracking(controller) => controller.update(input),
            Self::Force(controller) => controller.update(input),
        }
    }
}
