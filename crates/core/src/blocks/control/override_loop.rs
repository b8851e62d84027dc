//! The force controllers of the 2005 comparison: each moves the feed override u alone and sees the
//! normalised force y = F_m / F_ref once in a control period; the spindle stays as programmed.
//!
//! What they share stands here: the model of the actual override, contact with the part, the air
//! feed, and the Smith predictor that any of them can be given. Thresholds and gains are relative,
//! so every controller runs on every plant.
//!
//! ```text
//! u_a(k)  override that the feed drive has reached, from the commands really sent
//! u_0(k)  the same without dead time
//! y*      = y u_0 / u_a            multiplicative Smith predictor, with u_0 in the place of u_a
//! ```
//!
//! In the air (y below 0.06: 40 of 665 N) the override goes to its upper limit and every state is
//! held: low loads raise the feed above the programmed one (2005, section 1).

use super::adjustable_pi::AdjustablePi;
use super::division::Division;
use super::mrac::Mrac;
use super::preview::Preview;
use super::proportional::Proportional;
use super::unks::{Learning, Unks};
use super::{ControlInput, ControlOutput, ControlSetup, ControllerKind, FeedSpeed};
use crate::base::math::limit;
use crate::models::feed_drive::{DriveState, ExactDrive};
use crate::models::unks::HORIZON_BEYOND;

/// Normalised force below which the tool is in the air: 40 of 665 N (2005 simulator, chosen).
const AIR: f64 = 0.06;
/// Least actual override that anything is divided by.
pub(super) const LEAST: f64 = 0.02;
/// Control periods after which every drive has settled: a second at 1 ms.
const LAG_PERIODS: usize = 1000;
/// Longest dead time that can be predicted, s; the range of `belief.dead_time_s`.
const DEAD_TIME_MAX_S: f64 = 0.5;

/// What a force controller sees in a control period.
#[derive(Clone, Copy, Debug)]
pub struct ForceSample<'a> {
    /// Normalised force y, or y* with the Smith predictor.
    pub y: f64,
    /// Actual override u_a, or u_0 with the Smith predictor; at least 0.02.
    pub actual: f64,
    /// Override that was really sent in the period before.
    pub sent: f64,
    /// Whether this is the first sample in contact.
    pub entered: bool,
    /// Whether it is also the first after another controller: the new override should equal `sent`.
    pub taken_over: bool,
    /// Least and largest override.
    pub range: [f64; 2],
    /// Everything that the controller was given.
    pub input: &'a ControlInput<'a>,
    /// The shared part, which knows the commands on their way.
    pub override_loop: &'a OverrideLoop,
}

/// One of the laws: from a sample in contact to the new override.
pub trait ForceLaw {
    /// The new override, before limits.
    fn update(&mut self, sample: &ForceSample) -> f64;
    /// The override in the air.
    fn in_air(&mut self, sample: &ForceSample) -> f64 {
        sample.range[1]
    }
    /// The law's estimate of the force at 100 % override relative to the reference; 1 where it has
    /// none.
    fn gain(&self) -> f64 {
        1.0
    }
}

/// The shared part with its state.
#[derive(Clone, Debug)]
pub struct OverrideLoop {
    drive: ExactDrive,
    pub(super) period_s: f64,
    /// How far the drive lags behind a ramp, in control periods.
    lag: f64,
    /// Whole control periods of dead time.
    periods: usize,
    smith: bool,
    /// Overrides sent, a ring; `newest` is the last one.
    sent: Vec<f64>,
    newest: usize,
    delayed: DriveState,
    undelayed: DriveState,
    in_contact: bool,
    started: bool,
    /// Whether a running machine was taken over and nothing has been sent to it yet.
    taking_over: bool,
}

impl OverrideLoop {
    pub(super) fn new(setup: &ControlSetup, smith: bool) -> Self {
        let capacity = (DEAD_TIME_MAX_S / setup.period_s).ceil() as usize + 2;
        let mut this = Self {
            drive: ExactDrive::new(setup.belief.feed_drive, setup.period_s),
            period_s: setup.period_s,
            lag: 0.0,
            periods: 0,
            smith,
            sent: vec![1.0; capacity],
            newest: 0,
            delayed: DriveState::settled(1.0),
            undelayed: DriveState::settled(1.0),
            in_contact: false,
            started: false,
            taking_over: false,
        };
        this.configure(setup, smith);
        this
    }

    pub(super) fn configure(&mut self, setup: &ControlSetup, smith: bool) {
        self.drive = ExactDrive::new(setup.belief.feed_drive, setup.period_s);
        self.period_s = setup.period_s;
        self.lag = lag(&self.drive);
        self.periods = periods(setup);
        self.smith = smith;
    }

    /// The machine runs at the override `actual` under the command `sent`.
    pub(super) fn restart(&mut self, actual: f64, sent: f64) {
        self.sent.fill(sent);
        (self.delayed, self.undelayed) = (DriveState::settled(actual), DriveState::settled(actual));
        (self.in_contact, self.started) = (false, false);
    }

    fn follow(&mut self, sent: f64) {
        let n = self.sent.len();
        self.newest = (self.newest + 1) % n;
        self.sent[self.newest] = sent;
        let older = self.sent[(self.newest + n - self.periods.min(n - 1)) % n];
        self.drive.advance(&mut self.delayed, older);
        self.drive.advance(&mut self.undelayed, sent);
    }

    /// How far the tool will have gone when a command sent now has its effect, in control periods at
    /// 100 %: through the commands that are still on their way, and the drive's lag behind the new one.
    pub(super) fn ahead(&self) -> f64 {
        let (mut state, mut sum, n) = (self.delayed, 0.0, self.sent.len());
        for back in (0..self.periods.min(n - 1)).rev() {
            self.drive.advance(&mut state, self.sent[(self.newest + n - back) % n]);
            sum += state.feed_mm_min();
        }
        sum + self.lag * state.feed_mm_min()
    }

    /// One control period of `law`.
    pub(super) fn update(&mut self, law: &mut dyn ForceLaw, input: &ControlInput) -> ControlOutput {
        let programmed = input.programmed.feed_mm_min;
        let sent = input.applied.feed_mm_min / programmed;
        if self.started {
            self.follow(sent);
        }
        self.started = true;
        let range = input.limits.feed_mm_min.map(|feed| feed / programmed);
        let mut y = input.force_measured_n / input.force_ref_n;
        let contact = y >= AIR;
        let delayed = self.delayed.feed_mm_min().max(LEAST);
        let mut actual = delayed;
        if self.smith {
            actual = self.undelayed.feed_mm_min().max(LEAST);
            y *= actual / delayed;
        }
        let entered = contact && !self.in_contact;
        let taken_over = std::mem::take(&mut self.taking_over);
        let sample =
            ForceSample { y, actual, sent, entered, taken_over, range, input, override_loop: self };
        let override_now = if contact { law.update(&sample) } else { law.in_air(&sample) };
        self.in_contact = contact;
        ControlOutput {
            request: FeedSpeed {
                feed_mm_min: limit(override_now, range[0], range[1]) * programmed,
                speed_rpm: input.programmed.speed_rpm,
            },
            force_setpoint_n: input.force_ref_n,
            gain_estimate: law.gain(),
            feed_model_valid: true,
            speed_model_valid: true,
        }
    }
}

/// The laws that can be chosen.
#[derive(Clone, Debug)]
enum AnyLaw {
    Division(Division),
    Proportional(Proportional),
    AdjustablePi(AdjustablePi),
    Mrac(Box<Mrac>),
    Unks(Box<Unks>),
    Preview(Box<Preview>),
}

impl AnyLaw {
    fn new(setup: &ControlSetup) -> Self {
        match setup.kind {
            // register: law
            ControllerKind::Proportional => {
                Self::Proportional(Proportional { settings: setup.proportional.clone(), sum: 0.0 })
            }
            ControllerKind::AdjustablePi => Self::AdjustablePi(AdjustablePi {
                settings: setup.adjustable_pi.clone(),
                gain: 1.0,
                covariance: 1.0,
                error_before: 0.0,
            }),
            ControllerKind::Mrac => Self::Mrac(Box::new(Mrac::new(setup.mrac))),
            ControllerKind::Unks => Self::Unks(Box::new(Unks::new(setup.unks, horizon(setup)))),
            ControllerKind::Preview => Self::Preview(Box::new(Preview::new(setup))),
            _ => Self::Division(Division { settings: setup.division.clone() }),
        }
    }

    /// Takes over changed settings of the same law; `false` if it is another one.
    fn configure(&mut self, setup: &ControlSetup) -> bool {
        match (self, setup.kind) {
            (Self::Division(law), ControllerKind::Division) => {
                law.settings = setup.division.clone();
            }
            (Self::Proportional(law), ControllerKind::Proportional) => {
                law.settings = setup.proportional.clone();
            }
            (Self::AdjustablePi(law), ControllerKind::AdjustablePi) => {
                law.settings = setup.adjustable_pi.clone();
            }
            (Self::Mrac(law), ControllerKind::Mrac) => law.settings = setup.mrac.clone(),
            (Self::Unks(law), ControllerKind::Unks) => {
                law.settings = setup.unks.clone();
                law.set_horizon(horizon(setup));
            }
            (Self::Preview(law), ControllerKind::Preview) => law.configure(setup),
            _ => return false,
        }
        true
    }

    fn learning(&self) -> Option<Learning<'_>> {
        match self {
            Self::Unks(law) => Some(law.learning()),
            _ => None,
        }
    }

    fn as_law(&mut self) -> &mut dyn ForceLaw {
        match self {
            Self::Division(law) => law,
            Self::Proportional(law) => law,
            Self::AdjustablePi(law) => law,
            Self::Mrac(law) => law.as_mut(),
            Self::Unks(law) => law.as_mut(),
            Self::Preview(law) => law.as_mut(),
        }
    }
}

/// Whole control periods of the believed dead time.
fn periods(setup: &ControlSetup) -> usize {
    (setup.belief.dead_time_s / setup.period_s).round() as usize
}

/// How far a drive lags behind a ramp of its command, in periods of the command: the area between a
/// step and its answer, and half a period that a command is held before and after its middle.
fn lag(drive: &ExactDrive) -> f64 {
    let mut state = DriveState::settled(0.0);
    let mut area = 1.0;
    for _ in 0..LAG_PERIODS {
        drive.advance(&mut state, 1.0);
        area += 1.0 - state.feed_mm_min();
    }
    area
}

/// How far UNKS looks ahead, in control periods.
fn horizon(setup: &ControlSetup) -> usize {
    periods(setup) + HORIZON_BEYOND
}

fn smith(setup: &ControlSetup) -> bool {
    match setup.kind {
        ControllerKind::Proportional => setup.proportional.smith,
        ControllerKind::AdjustablePi => setup.adjustable_pi.smith,
        ControllerKind::Mrac => setup.mrac.smith,
        ControllerKind::Unks => setup.unks.smith,
        // It looks ahead by itself.
        ControllerKind::Preview => false,
        _ => setup.division.smith,
    }
}

/// A force controller: the shared part and its law.
#[derive(Clone, Debug)]
pub struct ForceController {
    override_loop: OverrideLoop,
    law: AnyLaw,
}

impl ForceController {
    /// The controller at the start of a run, the machine at the programmed feed.
    pub(super) fn new(setup: &ControlSetup) -> Self {
        Self { override_loop: OverrideLoop::new(setup, smith(setup)), law: AnyLaw::new(setup) }
    }

    /// The controller that takes over a machine which runs at the override `actual` under the command
    /// `sent`. A law with a state starts from the one that asks for `sent`; static division and P
    /// have none, and the override goes where they say.
    pub(super) fn take_over(setup: &ControlSetup, actual: f64, sent: f64) -> Self {
        let mut this = Self::new(setup);
        this.override_loop.restart(actual, sent);
        this.override_loop.taking_over = true;
        this
    }

    /// Takes over changed settings and keeps its state; `false` if another law is chosen.
    pub(super) fn configure(&mut self, setup: &ControlSetup) -> bool {
        self.override_loop.configure(setup, smith(setup));
        self.law.configure(setup)
    }

    /// A new cut begins at the programmed feed: what was learned stays.
    pub(super) fn restart(&mut self) {
        self.override_loop.restart(1.0, 1.0);
        if let AnyLaw::Proportional(law) = &mut self.law {
            law.sum = 0.0;
        }
    }

    pub(super) fn learning(&self) -> Option<Learning<'_>> {
        self.law.learning()
    }

    pub(super) fn update(&mut self, input: &ControlInput) -> ControlOutput {
        self.override_loop.update(self.law.as_law(), input)
    }
}
