//! Tracking: holds Ra without steady-state error, which the paper's proportional loop cannot.
//!
//! The true force is taken as an unknown gain times the modelled one, F = g K4(f_a, n_a): material,
//! hardness, depth and wear all multiply the force. Every control period:
//!
//! ```text
//! f^, n^    = feed and spindle models driven by the commands really sent, after the assumed
//!             dead time                                              (Smith predictor)
//! g^       += (1 - e^{-T/lambda}) (F_measured / K4(f^, n^) - g^)     (integral action)
//! u         = F_d / g^                                               (model force to ask for)
//! n_c       = K3(s) with s from K4(K2(s), K3(s)) = u                 (the paper's feed-speed line)
//! f_c       = f from K4(f, n^+) = u                                  (n^+: predicted without dead time)
//! lambda    = response + share * assumed dead time                   (the one gain rule)
//! ```
//!
//! This is internal model control with a multiplicative disturbance. At rest K4(f^, n^) = u and
//! g^ = F_measured / u, so F_measured = F_d exactly: integral action. The predictor sees the limited commands, so
//! nothing winds up while they saturate. lambda grows with the dead time, so that a dead time
//! wrong by half either way keeps the loop stable. The feed takes over what the slower spindle
//! has not yet done.
//!
//! Where overrides are whole percents, what rounding took away is added to the next request
//! (error feedback): the command then alternates between neighbouring percents, and its mean is the
//! one that was asked for.

use super::law::{AtRest, ControlLaw, ControlMoment, Explained, Held};
use super::{ControlInput, ControlOutput, ControlSetup, FeedSpeed, Limits, Running};
use crate::base::equation::{Live, number};
use crate::base::language::{text, tr};
use crate::base::math::{self, limit};
use crate::base::units::ratio_from_percent;
use crate::models::feed_drive::{DEAD_TIME_MAX_S, DriveState, ExactDrive};
use crate::models::genetic::{GeneticModels, ModelSet};
use crate::models::part::AIR_FRACTION;
use crate::models::printed::Printed;
use crate::models::spindle::ExactSpindle;

crate::settings! {
    /// Settings of Tracking.
    pub struct TrackingSettings {
        /// Time constant of the gain estimate at zero dead time: shorter is faster and noisier.
        response_s: f64 = 0.1, [0.02, 5.0], "s", live, "Response time";
        /// How many assumed dead times are added to the response time: robustness against a wrong
        /// dead time.
        dead_time_share: f64 = 1.0, [0.0, 5.0], "", live, "Dead-time share";
        /// Measured force below which the tool counts as in the air, in percent of the desired
        /// force: the estimate is held there.
        air_percent: f64 = 100.0 * AIR_FRACTION, [0.0, 50.0], "%", live, "Air threshold";
    }
}

/// Bounds of the gain estimate: a factor of ten either way.
const GAIN_RANGE: [f64; 2] = [0.1, 10.0];

/// The part of a control period that follows one command.
#[derive(Clone, Debug)]
struct SubStep {
    feed: ExactDrive,
    spindle: ExactSpindle,
    length_s: f64,
}

/// The controller with its state.
#[derive(Clone, Debug)]
pub struct Tracking {
    settings: TrackingSettings,
    weight: f64,
    /// Whole control periods in the assumed dead time.
    whole_periods: usize,
    /// The parts of a control period under the older and under the newer command: the assumed dead time
    /// need not be whole periods.
    older: SubStep,
    newer: SubStep,
    whole: ExactSpindle,
    /// Commands sent, newest last; a ring indexed by `newest`.
    sent: Vec<FeedSpeed>,
    newest: usize,
    /// State: delayed feed, delayed speed, speed without dead time, gain estimate, setpoint s.
    feed: DriveState,
    speed_rpm: f64,
    speed_undelayed_rpm: f64,
    gain: f64,
    setpoint_n: f64,
    /// Whether a command has been sent already that the predictor must follow.
    started: bool,
    /// Whether the first command must equal the one being sent (bumpless transfer).
    bumpless: bool,
    /// Last request, including the quantisation error carried over from the period before it.
    asked: FeedSpeed,
}

impl Tracking {
    /// The command sent `ago` periods before the newest one.
    fn sent(&self, ago: usize) -> FeedSpeed {
        let n = self.sent.len();
        self.sent[(self.newest + n - ago.min(n - 1)) % n]
    }

    /// Advances the predictor over the period that has just passed.
    fn predict(&mut self, applied: FeedSpeed) {
        self.newest = (self.newest + 1) % self.sent.len();
        self.sent[self.newest] = applied;
        let parts = [
            (&self.older, self.sent(self.whole_periods + 1)),
            (&self.newer, self.sent(self.whole_periods)),
        ];
        let (mut feed, mut speed_rpm) = (self.feed, self.speed_rpm);
        for (part, command) in parts {
            if part.length_s > 0.0 {
                part.feed.advance(&mut feed, command.feed_mm_min);
                speed_rpm = part.spindle.advance(speed_rpm, command.speed_rpm);
            }
        }
        self.feed = feed;
        self.speed_rpm = speed_rpm;
        self.speed_undelayed_rpm = self.whole.advance(self.speed_undelayed_rpm, applied.speed_rpm);
    }
}

impl ControlLaw for Tracking {
    type Settings = TrackingSettings;
    const ABOUT: &'static str =
        "Model inverse with integral action, anti-windup and a Smith predictor.";
    const HELD: Held = Held::Roughness;

    fn new(settings: &TrackingSettings, setup: &ControlSetup, current: FeedSpeed) -> Self {
        let capacity = (DEAD_TIME_MAX_S / setup.period_s).ceil() as usize + 3;
        let step = |length_s: f64| SubStep {
            feed: ExactDrive::new(setup.belief.feed_drive, length_s),
            spindle: ExactSpindle::new(1.0, 1.0, length_s),
            length_s,
        };
        let mut tracking = Self {
            settings: settings.clone(),
            weight: 0.0,
            whole_periods: 0,
            older: step(0.0),
            newer: step(setup.period_s),
            whole: ExactSpindle::new(1.0, 1.0, setup.period_s),
            sent: vec![current; capacity],
            newest: 0,
            feed: DriveState::settled(current.feed_mm_min),
            speed_rpm: current.speed_rpm,
            speed_undelayed_rpm: current.speed_rpm,
            gain: 1.0,
            setpoint_n: 200.0,
            started: false,
            bumpless: false,
            asked: current,
        };
        tracking.configure(settings, setup);
        tracking
    }

    /// Takes over a running machine: the predictor starts from its feed and speed and from the
    /// command under way, the gain from the value at which the present command is right; from
    /// there it goes to the true one with its own time constant.
    fn take_over(settings: &TrackingSettings, setup: &ControlSetup, running: &Running) -> Self {
        let mut tracking = Self::new(settings, setup, running.actual);
        tracking.sent.fill(running.sent);
        tracking.bumpless = true;
        tracking.asked = running.sent;
        tracking
    }

    /// A new cut begins at rest at `current`: the gain stays, the predictor starts again.
    fn restart(&mut self, current: FeedSpeed) {
        self.sent.fill(current);
        self.feed = DriveState::settled(current.feed_mm_min);
        (self.speed_rpm, self.speed_undelayed_rpm) = (current.speed_rpm, current.speed_rpm);
        self.asked = current;
        self.started = false;
    }

    fn configure(&mut self, settings: &TrackingSettings, setup: &ControlSetup) {
        let belief = setup.belief;
        self.settings = settings.clone();
        let lambda_s = lambda_s(&self.settings, belief.dead_time_s);
        self.weight = 1.0 - math::exp(-setup.period_s / lambda_s);
        // The dead time need not be a whole number of control periods: the older command still
        // acts during its fraction. 1e-9: a dead time of 4 periods must not become 3.999..
        self.whole_periods = (belief.dead_time_s / setup.period_s + 1e-9).floor() as usize;
        let fraction_s = (belief.dead_time_s - self.whole_periods as f64 * setup.period_s).max(0.0);
        let spindle = |length_s: f64| {
            let (tau_s, rate) = (belief.spindle_time_constant_s, belief.spindle_rate_rpm_s);
            ExactSpindle::new(tau_s, rate, length_s)
        };
        let step = |length_s: f64| SubStep {
            feed: ExactDrive::new(belief.feed_drive, length_s),
            spindle: spindle(length_s),
            length_s,
        };
        self.older = step(fraction_s);
        self.newer = step(setup.period_s - fraction_s);
        self.whole = spindle(setup.period_s);
    }

    fn update(&mut self, input: &ControlInput) -> ControlOutput {
        if self.started {
            self.predict(input.applied);
        }
        self.started = true;

        let model_n = input.models.force(self.feed.feed_mm_min(), self.speed_rpm).value;
        let air_n = ratio_from_percent(self.settings.air_percent) * input.force_ref_n;
        if self.bumpless && model_n > 1.0 {
            // The feed that is being sent, which the drive may not have reached yet.
            let sent_n = input.models.force(input.applied.feed_mm_min, self.speed_rpm).value;
            self.gain = limit(input.force_ref_n / sent_n.max(1.0), GAIN_RANGE[0], GAIN_RANGE[1]);
            self.bumpless = false;
        } else if input.force_measured_n > air_n && model_n > 1.0 {
            let observed = limit(input.force_measured_n / model_n, GAIN_RANGE[0], GAIN_RANGE[1]);
            self.gain += self.weight * (observed - self.gain);
        }
        let asked_n = input.force_ref_n / self.gain;

        let most = SETPOINT_LEAST_MAX_N.max(SETPOINT_MAX * input.force_ref_n);
        self.setpoint_n = setpoint_for(asked_n, most, self.setpoint_n, input.models, &input.limits);
        let speed = input.models.speed_from_force(self.setpoint_n);
        let (feed_max, near) = (input.limits.feed_mm_min[1], input.applied.feed_mm_min);
        let feed = input.models.feed_for_force(asked_n, self.speed_undelayed_rpm, feed_max, near);
        let FeedSpeed { feed_mm_min, speed_rpm } = input.limits.resolution;
        let (asked, applied) = (self.asked, input.applied);
        let feed_owed = owed(asked.feed_mm_min, applied.feed_mm_min, feed_mm_min);
        let speed_owed = owed(asked.speed_rpm, applied.speed_rpm, speed_rpm);
        self.asked =
            FeedSpeed { feed_mm_min: feed.value + feed_owed, speed_rpm: speed.value + speed_owed };
        ControlOutput {
            request: self.asked,
            force_setpoint_n: asked_n,
            gain_estimate: self.gain,
            feed_model_valid: feed.valid,
            speed_model_valid: speed.valid,
            exceeded: None,
            switched_off: false,
        }
    }

    fn at_rest(_: &TrackingSettings) -> AtRest {
        AtRest::OnReference
    }

    fn believes(_: &TrackingSettings) -> &'static [&'static str] {
        &["feed_drive", "dead_time_s", "spindle_time_constant_s", "spindle_rate_rpm_s"]
    }

    fn printed(_: &TrackingSettings, set: ModelSet) -> Vec<Printed> {
        let law = match set {
            ModelSet::Sdnrp2007 | ModelSet::Milling2005 => {
                "g' = (F_m / K4(f, n) - g) / λ,  K4(f_c, n_c) = F_d / g"
            }
            ModelSet::Strategy2013 => "g' = (F_m / M4(f, n) - g) / λ,  M4(f_c, n_c) = F_d / g",
        };
        vec![Printed::new(
            law,
            text!("chosen: internal model control with a Smith predictor; no paper prints it"),
        )]
    }

    fn explain(settings: &TrackingSettings, moment: &ControlMoment) -> Explained {
        let ControlMoment { force_ref_n: desired, gain_estimate: gain, command, .. } = *moment;
        let (k, resolution) = (moment.models.set.letter(), moment.limits.resolution);
        let lambda_s = lambda_s(settings, moment.belief.dead_time_s);
        let mut lines = vec![
            Live::everywhere(
                tr!(
                    "g follows F_m / {model}(predicted f, n) with a time constant of {time} s",
                    model = format!("{k}4"),
                    time = number(lambda_s)
                ),
                format!("g = {}  (F_m = {} N)", number(gain), number(moment.force_measured_n)),
            ),
            Live::everywhere(
                "u = F_d / g",
                format!(
                    "u = {} / {} = {} N",
                    number(desired),
                    number(gain),
                    number(desired / gain)
                ),
            ),
            Live {
                formula: tr!(
                    "f_c, n_c from {model_4}(f_c, n_c) = u on the line of {model_2} and {model_3}",
                    model_4 = format!("{k}4"),
                    model_2 = format!("{k}2"),
                    model_3 = format!("{k}3")
                ),
                values: format!(
                    "f_c = {} mm/min, n_c = {} 1/min",
                    number(command.feed_mm_min),
                    number(command.speed_rpm)
                ),
                range: tr!(
                    "{model_3} and the inverse of {model_4} within their ranges",
                    model_3 = format!("{k}3"),
                    model_4 = format!("{k}4")
                ),
                valid: moment.models_valid,
            },
        ];
        if resolution.feed_mm_min > 0.0 {
            lines.push(Live::everywhere(
                tr("what rounding to whole % takes is added to the next request: the mean is as asked"),
                tr!(
                    "1 % is {feed} mm/min and {speed} 1/min",
                    feed = number(resolution.feed_mm_min),
                    speed = number(resolution.speed_rpm)
                ),
            ));
        }
        let beside_name = tr!("gain {gain}", gain = number(gain));
        Explained { lines, models_at_n: None, beside_name }
    }
}

/// Time constant of the gain estimate.
fn lambda_s(settings: &TrackingSettings, dead_time_s: f64) -> f64 {
    settings.response_s + settings.dead_time_share * dead_time_s
}

/// Quantisation error of a request rounded to steps of `resolution`: at most half a step. What limits
/// or a rate took is not carried over.
fn owed(asked: f64, applied: f64, resolution: f64) -> f64 {
    let half = 0.5 * resolution;
    limit(asked - applied, -half, half)
}

/// The setpoint s is searched from 0 to this, N, and to `SETPOINT_MAX` times the reference force
/// where that is more: what overrides up to 250 % can need.
const SETPOINT_LEAST_MAX_N: f64 = 500.0;
const SETPOINT_MAX: f64 = 2.5;

/// The s with K4(K2(s), K3(s)) = `asked_n`, at most `most`, commands limited; `near` is where it was last. The
/// limited line is monotone but not smooth: false position (Illinois) in a bracket that grows from
/// `near`, to a thousandth of a newton: s only chooses the speed, the feed is solved for exactly.
fn setpoint_for(
    asked_n: f64,
    most: f64,
    near: f64,
    models: &GeneticModels,
    limits: &Limits,
) -> f64 {
    let error = |s: f64| {
        let feed = models.feed_from_force(s).value;
        let speed = models.speed_from_force(s).value;
        let force = models.force(
            limit(feed, limits.feed_mm_min[0], limits.feed_mm_min[1]),
            limit(speed, limits.speed_rpm[0], limits.speed_rpm[1]),
        );
        force.value - asked_n
    };
    let least = 0.0;
    let mut low = limit(near, least, most);
    let mut at_low = error(low);
    if at_low.abs() < 1e-3 {
        return low;
    }
    // Grow the bracket away from `near` to the side where the root is.
    let rising = at_low < 0.0;
    let (mut high, mut at_high) = (low, at_low);
    let mut stride = 1.0;
    while (at_high < 0.0) == rising {
        (low, at_low) = (high, at_high);
        let end = if rising { most } else { least };
        if high == end {
            return end;
        }
        high = limit(if rising { high + stride } else { high - stride }, least, most);
        at_high = error(high);
        stride *= 4.0;
    }
    for _ in 0..60 {
        let middle = low - at_low * (high - low) / (at_high - at_low);
        let at_middle = error(middle);
        if at_middle.abs() < 1e-3 || (high - low).abs() < 1e-6 {
            return middle;
        }
        if (at_middle < 0.0) == (at_high < 0.0) {
            at_low *= 0.5;
        } else {
            (low, at_low) = (high, at_high);
        }
        (high, at_high) = (middle, at_middle);
    }
    0.5 * (low + high)
}
