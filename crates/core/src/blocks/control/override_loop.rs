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

use std::fmt::Debug;

use super::law::{AtRest, ControlLaw, ControlMoment, Explained, Held};
use super::unks::Learning;
use super::{ControlInput, ControlOutput, ControlSetup, FeedSpeed, Running};
use crate::base::equation::{Live, number};
use crate::base::math::limit;
use crate::base::settings::Group;
use crate::models::feed_drive::{DEAD_TIME_MAX_S, DriveState, ExactDrive};
use crate::models::genetic::ModelSet;
use crate::models::part::AIR_FRACTION;
use crate::models::printed::Printed;

/// Beliefs about the path of the command.
pub(super) const COMMAND_PATH: &[&str] = &["feed_drive", "dead_time_s"];
/// Least actual override that anything is divided by.
pub(super) const LEAST: f64 = 0.02;
/// Control periods after which every drive has settled: a second at 1 ms.
const LAG_PERIODS: usize = 1000;

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
    /// The complete input of the controller.
    pub input: &'a ControlInput<'a>,
    /// The shared part, which knows the commands on their way.
    pub override_loop: &'a OverrideLoop,
}

/// The law of a force controller: from a sample in contact to the new override. [`ForceController`]
/// makes a controller of it.
pub trait ForceLaw: Sized {
    /// Its settings, those under `controller.<id>`.
    type Settings: Group + Clone + Debug + Default + PartialEq;
    /// What it is, with its source, in a sentence.
    const ABOUT: &'static str;
    /// Whether networks learn in it; [`Self::learning`] then shows them.
    const LEARNS: bool = false;

    /// The law before its first sample.
    fn new(settings: &Self::Settings, setup: &ControlSetup) -> Self;
    /// Takes over changed settings and keeps its state.
    fn configure(&mut self, settings: &Self::Settings, setup: &ControlSetup);
    /// Whether it wants the measured force corrected for the dead time (Smith predictor).
    fn smith(settings: &Self::Settings) -> bool;
    /// A new cut begins: what was learned stays, dynamic state goes.
    fn restart(&mut self) {}
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
    /// Its networks that learn in the cut, for display.
    fn learning(&self) -> Option<Learning<'_>> {
        None
    }
    /// Where the force comes to rest in a cut that does not change.
    fn at_rest(settings: &Self::Settings) -> AtRest;
    /// Keys of the beliefs that it asks for, as it is set: the path of its command, which tells the
    /// override that was reached.
    #[must_use]
    fn believes(_: &Self::Settings) -> &'static [&'static str] {
        COMMAND_PATH
    }
    /// See [`ControlLaw::left_out`].
    #[must_use]
    fn left_out(_: &Self::Settings) -> &'static [&'static str] {
        &[]
    }
    /// The law as its source prints it.
    fn printed(settings: &Self::Settings) -> Printed;
    /// The law with the values of a moment: its formula, and what stands beside the override that was
    /// sent; empty where nothing does.
    fn explain(settings: &Self::Settings, moment: &ControlMoment) -> (String, String);
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
    fn update<L: ForceLaw>(&mut self, law: &mut L, input: &ControlInput) -> ControlOutput {
        let programmed = input.programmed.feed_mm_min;
        let sent = input.applied.feed_mm_min / programmed;
        if self.started {
            self.follow(sent);
        }
        self.started = true;
        let range = input.limits.feed_mm_min.map(|feed| feed / programmed);
        let mut y = input.force_measured_n / input.force_ref_n;
        let contact = y >= AIR_FRACTION;
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
            exceeded: None,
            switched_off: false,
        }
    }
}

/// Whole control periods of the believed dead time.
pub(super) fn periods(setup: &ControlSetup) -> usize {
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

/// A force controller: the shared part and its law.
#[derive(Clone, Debug)]
pub struct ForceController<L> {
    override_loop: OverrideLoop,
    law: L,
}

impl<L: ForceLaw> ControlLaw for ForceController<L> {
    type Settings = L::Settings;
    const ABOUT: &'static str = L::ABOUT;
    const HELD: Held = Held::Force;
    const LEARNS: bool = L::LEARNS;

    fn new(settings: &L::Settings, setup: &ControlSetup, _: FeedSpeed) -> Self {
        let override_loop = OverrideLoop::new(setup, L::smith(settings));
        Self { override_loop, law: L::new(settings, setup) }
    }

    /// A law with a state starts from the one that asks for the override that is being sent; static
    /// division and P have none, and the override goes where they say.
    fn take_over(settings: &L::Settings, setup: &ControlSetup, running: &Running) -> Self {
        let Running { programmed, actual, sent } = running;
        let of_programmed = |feed_mm_min: f64| feed_mm_min / programmed.feed_mm_min;
        let mut this = Self::new(settings, setup, *programmed);
        this.override_loop
            .restart(of_programmed(actual.feed_mm_min), of_programmed(sent.feed_mm_min));
        this.override_loop.taking_over = true;
        this
    }

    fn configure(&mut self, settings: &L::Settings, setup: &ControlSetup) {
        self.override_loop.configure(setup, L::smith(settings));
        self.law.configure(settings, setup);
    }

    fn restart(&mut self, _: FeedSpeed) {
        self.override_loop.restart(1.0, 1.0);
        self.law.restart();
    }

    fn update(&mut self, input: &ControlInput) -> ControlOutput {
        self.override_loop.update(&mut self.law, input)
    }

    fn learning(&self) -> Option<Learning<'_>> {
        self.law.learning()
    }

    fn at_rest(settings: &L::Settings) -> AtRest {
        L::at_rest(settings)
    }

    fn believes(settings: &L::Settings) -> &'static [&'static str] {
        L::believes(settings)
    }

    fn left_out(settings: &L::Settings) -> &'static [&'static str] {
        L::left_out(settings)
    }

    fn printed(settings: &L::Settings, _: ModelSet) -> Vec<Printed> {
        vec![L::printed(settings)]
    }

    fn explain(settings: &L::Settings, moment: &ControlMoment) -> Explained {
        let [desired, measured] = [moment.force_ref_n, moment.force_measured_n];
        let seen = Live::everywhere(
            "y = F_m / F_{ref}",
            format!(
                "y = {} / {} = {}",
                number(measured),
                number(desired),
                number(measured / desired)
            ),
        );
        let (formula, beside) = L::explain(settings, moment);
        let comma = if beside.is_empty() { "" } else { ", " };
        let sent = format!("u = {} %{comma}{beside}", number(moment.feed_override_percent));
        Explained {
            lines: vec![seen, Live::everywhere(formula, sent)],
            models_at_n: None,
            beside_name: String::new(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blocks::control::{Belief, ControllerSettings};
    use crate::models::feed_drive::FeedDriveKind;
    use crate::models::part::ProgrammedPart;
    use crate::models::tool::Tool;

    #[test]
    fn a_drive_lags_by_its_time_constant_and_half_a_period() {
        // 1 / 14 s, and the middle of the period over which a command is held.
        let lag = lag(&ExactDrive::new(FeedDriveKind::Eq3Of2007, 0.02));
        assert!((lag - (1.0 / 14.0 / 0.02 + 0.5)).abs() < 0.05, "{lag}");
    }

    #[test]
    fn the_dead_time_is_the_nearest_number_of_periods() {
        let (settings, tool) = (ControllerSettings::default(), Tool::default());
        for (dead_time_s, expected) in [(0.0, 0), (0.029, 1), (0.031, 2), (0.04, 2), (0.08, 4)] {
            let belief = Belief { dead_time_s, ..Belief::default() };
            let part = ProgrammedPart {
                cuts: &[],
                axial_depth_mm: 2.0,
                radial_depth_mm: 3.0,
                depth_steps: &[],
                radial_steps: &[],
            };
            let setup = ControlSetup {
                settings: &settings,
                part,
                tool: &tool,
                belief: &belief,
                period_s: 0.02,
            };
            assert_eq!(periods(&setup), expected, "{dead_time_s} s");
        }
    }
}
