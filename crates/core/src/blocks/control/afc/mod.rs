//! Adaptive feed control (AFC) as a CNC has it, after Heidenhain's dialogue: the first part is cut at the
//! programmed feed and its peak force is kept (teach-in); from then on the feed follows the force.
//!
//! ```text
//! teach-in  u = 1                                        F_1 = largest F_m of the cut
//! control   u goes to limit(F_1 / F_m, FMIN, FMAX)       down at 5 r, up at r
//! air       u = u_air                                    while F_m < exit threshold · F_1
//! entry     u = u_entry                                  the first sample back in contact
//! overload  F_m > limit · F_1 for more than 1 s while u stands at FMIN: message, stop, retract and stop
//! ```
//!
//! One reference F_1 belongs to each cut of the part, whatever depths it goes through: the program knows
//! where a cut begins and ends, and a deeper stretch within it is what the control is for. A part that is
//! one path has one reference. A cut without a reference is taught in: its feed stays as programmed.
//! With FMIN = FMAX = 100 % the feed stays as programmed too, in the air as well, and the force is only
//! watched.
//!
//! The quotient multiplies the programmed feed, as static division does: a force above the reference is
//! lowered, not brought back onto it. FMIN, air and entry feed cannot be set below 30 %. The rates, all
//! percentages and the way back into the cut are chosen. Where the operator turns the override down by more than
//! a tenth (`disturbances.operator_overrides`), it is off for the rest of the cut: the feed is as programmed, times
//! the operator's hand, and nothing is watched.

use crate::base::language::{text, tr};

#[cfg(test)]
mod tests;

use super::law::{AtRest, ControlLaw, ControlMoment, Explained, Held};
use super::{
    ControlInput, ControlOutput, ControlSetup, Exceeded, FeedSpeed, Limits, OverloadReaction,
    Running,
};
use crate::base::equation::{Live, number};
use crate::base::math::limit;
use crate::base::units::{percent_from_ratio, ratio_from_percent};
use crate::models::genetic::ModelSet;
use crate::models::printed::Printed;

/// Least feed that can be set for control, air and entry, percent of the programmed one.
pub const FLOOR_PERCENT: f64 = 30.0;
/// Factor of the operator's hand below which it switches itself off.
pub const OFF_BELOW: f64 = 0.9;
/// How much faster the feed goes down than up.
pub const RETREAT: f64 = 5.0;

crate::settings! {
    /// Settings of adaptive feed control.
    pub struct AfcSettings {
        /// FMIN: least feed of the control, of the programmed one.
        f_min_percent: f64 = 50.0, [FLOOR_PERCENT, 100.0], "%", live, "FMIN";
        /// FMAX: largest feed of the control, of the programmed one. FMIN and FMAX at 100 % only watch.
        f_max_percent: f64 = 120.0, [100.0, 250.0], "%", live, "FMAX";
        /// Exit threshold: below this share of the reference the tool counts as out of the cut.
        exit_percent: f64 = 8.0, [1.0, 50.0], "%", live, "Exit threshold";
        /// Feed in the air, of the programmed one.
        air_percent: f64 = 150.0, [FLOOR_PERCENT, 250.0], "%", live, "Feed in the air";
        /// Feed from the first contact on, of the programmed one: where the control begins.
        entry_percent: f64 = 80.0, [FLOOR_PERCENT, 250.0], "%", live, "Entry feed";
        /// How fast the feed recovers; it retreats five times as fast.
        recovery_percent_s: f64 = 20.0, [1.0, 500.0], "%/s", live, "Recovery rate";
        /// Limit of the force, of the reference.
        overload_percent: f64 = 130.0, [100.0, 500.0], "%", live, "Overload limit";
        /// How long the force has to stay over the limit, with the feed at FMIN, to count as an overload.
        overload_s: f64 = 1.0, [0.1, 10.0], "s", live, "Overload time";
        /// What an overload does.
        reaction: OverloadReaction = OverloadReaction::Stop, [], "", live, "Overload reaction";
        /// Reference force of each cut, as teach-in finds it (`steadycut afc teach`, or the console's window
        /// AFC); a cut without one is taught in, and its feed stays as programmed.
        references_n: Vec<f64> = Vec::new(), [1.0, 20000.0], "N", live, "Reference forces";
    }
}

/// What teach-in leaves out.
const CONTROL: &[&str] = &[
    "f_min_percent",
    "f_max_percent",
    "exit_percent",
    "air_percent",
    "entry_percent",
    "recovery_percent_s",
    "overload_percent",
    "overload_s",
    "reaction",
];
/// What watching leaves out.
const MOTION: &[&str] = &["exit_percent", "air_percent", "entry_percent", "recovery_percent_s"];

impl AfcSettings {
    /// Reference force of a cut in N, counted from 0; none where it is taught in.
    #[must_use]
    pub fn reference_n(&self, cut: usize) -> Option<f64> {
        self.references_n.get(cut).copied()
    }

    /// Whether the feed stays as programmed while the force is watched.
    #[must_use]
    pub fn only_watches(&self) -> bool {
        self.f_min_percent == 100.0 && self.f_max_percent == 100.0
    }
}

/// The controller with its state.
#[derive(Clone, Debug)]
pub struct Afc {
    settings: AfcSettings,
    period_s: f64,
    /// Feed asked for, of the programmed one.
    factor: f64,
    in_contact: bool,
    /// Control periods since the force is over its limit with the feed at FMIN; none while it is not.
    over: Option<u32>,
    /// Whether the operator has turned the override down in this cut.
    off: bool,
}

impl Afc {
    /// The least and the largest feed factor of the control, within what the override can be.
    fn bounds(&self, [low, high]: [f64; 2]) -> [f64; 2] {
        let AfcSettings { f_min_percent, f_max_percent, .. } = self.settings;
        [ratio_from_percent(f_min_percent).max(low), ratio_from_percent(f_max_percent).min(high)]
    }

    /// The feed factor from a measured and a reference force in N.
    fn control(&mut self, measured_n: f64, reference_n: f64, range: [f64; 2]) {
        let of_range = |percent: f64| limit(ratio_from_percent(percent), range[0], range[1]);
        let AfcSettings { exit_percent, air_percent, entry_percent, .. } = self.settings;
        let was_in_contact = self.in_contact;
        self.in_contact = measured_n >= ratio_from_percent(exit_percent) * reference_n;
        if !self.in_contact {
            self.factor = of_range(air_percent);
        } else if !was_in_contact {
            self.factor = of_range(entry_percent);
        } else {
            let [least, most] = self.bounds(range);
            let wanted = limit(reference_n / measured_n, least, most);
            let up = ratio_from_percent(self.settings.recovery_percent_s) * self.period_s;
            self.factor = limit(wanted, self.factor - RETREAT * up, self.factor + up);
        }
    }

    /// Whether the force has been over its limit for too long while the feed stood at FMIN.
    fn exceeded(&mut self, measured_n: f64, reference_n: f64, least: f64) -> Option<Exceeded> {
        let limit_n = ratio_from_percent(self.settings.overload_percent) * reference_n;
        if measured_n <= limit_n || self.factor > least {
            self.over = None;
            return None;
        }
        let periods = self.over.map_or(0, |periods| periods.saturating_add(1));
        self.over = Some(periods);
        let long = f64::from(periods) * self.period_s > self.settings.overload_s;
        long.then_some(Exceeded { limit_n, reaction: self.settings.reaction })
    }
}

impl ControlLaw for Afc {
    type Settings = AfcSettings;
    const ABOUT: &'static str = "Adaptive feed control as a CNC has it: taught in on the first part, feed by force after it.";
    const HELD: Held = Held::Force;

    fn new(settings: &AfcSettings, setup: &ControlSetup, _: FeedSpeed) -> Self {
        Self {
            settings: settings.clone(),
            period_s: setup.period_s,
            factor: 1.0,
            in_contact: false,
            over: None,
            off: false,
        }
    }

    /// In a running cut it begins with the feed that is being sent, and in contact.
    fn take_over(settings: &AfcSettings, setup: &ControlSetup, running: &Running) -> Self {
        let factor = running.sent.feed_mm_min / running.programmed.feed_mm_min;
        Self { factor, in_contact: true, ..Self::new(settings, setup, running.actual) }
    }

    fn configure(&mut self, settings: &AfcSettings, setup: &ControlSetup) {
        self.settings = settings.clone();
        self.period_s = setup.period_s;
    }

    fn restart(&mut self, _: FeedSpeed) {
        (self.factor, self.in_contact, self.over, self.off) = (1.0, false, None, false);
    }

    fn update(&mut self, input: &ControlInput) -> ControlOutput {
        let FeedSpeed { feed_mm_min, speed_rpm } = input.programmed;
        let mut exceeded = None;
        let reference_n = self.settings.reference_n(input.cut);
        self.off |= reference_n.is_some() && input.by_hand < OFF_BELOW;
        if let Some(reference_n) = reference_n.filter(|_| !self.off) {
            let range = input.limits.feed_mm_min.map(|feed| feed / feed_mm_min);
            let least = if self.settings.only_watches() { 1.0 } else { self.bounds(range)[0] };
            exceeded = self.exceeded(input.force_measured_n, reference_n, least);
            if !self.settings.only_watches() {
                self.control(input.force_measured_n, reference_n, range);
            }
        }
        if reference_n.is_none() || self.off || self.settings.only_watches() {
            self.factor = 1.0;
        }
        ControlOutput {
            request: FeedSpeed { feed_mm_min: self.factor * feed_mm_min, speed_rpm },
            force_setpoint_n: reference_n.unwrap_or(input.force_ref_n),
            gain_estimate: 1.0,
            feed_model_valid: true,
            speed_model_valid: true,
            exceeded,
            switched_off: self.off,
        }
    }

    /// It knows no force model.
    fn limits(overrides: Limits) -> Limits {
        overrides
    }

    fn at_rest(_: &AfcSettings) -> AtRest {
        AtRest::WhereTheLawMeetsThePlant
    }

    fn left_out(settings: &AfcSettings) -> &'static [&'static str] {
        if settings.references_n.is_empty() {
            CONTROL
        } else if settings.only_watches() {
            MOTION
        } else {
            &[]
        }
    }

    fn printed(_: &AfcSettings, _: ModelSet) -> Vec<Printed> {
        vec![Printed::new(
            "u = limit(F_1 / F_m, FMIN, FMAX)",
            text!(
                "after Heidenhain's adaptive feed control (AFC), in words only; F_1 by teach-in, rates, air \
                 and entry feed chosen"
            ),
        )]
    }

    fn explain(settings: &AfcSettings, moment: &ControlMoment) -> Explained {
        let measured_n = moment.force_measured_n;
        let measured = number(measured_n);
        let asked = format!("u = {} %", number(moment.feed_override_percent));
        let Some(reference_n) = settings.reference_n(moment.cut) else {
            let peak = tr!(
                "F_m = {measured} N; no reference for cut {cut}",
                measured = measured,
                cut = moment.cut + 1
            );
            return Explained {
                lines: vec![
                    Live::everywhere("F_1 = max F_m", peak),
                    Live::everywhere("u = 100 %", asked),
                ],
                models_at_n: None,
                beside_name: tr("teach-in").to_owned(),
            };
        };
        let share = number(percent_from_ratio(measured_n / reference_n));
        let load = format!("F_m / F_1 = {measured} / {} = {share} %", number(reference_n));
        let [low, high] = [settings.f_min_percent, settings.f_max_percent].map(number);
        let (law, beside_name) = if settings.only_watches() {
            ("u = 100 %".to_owned(), tr("watching").to_owned())
        } else {
            let law = tr!("u goes to limit(F_1 / F_m, {low} %, {high} %)", low = low, high = high);
            (law, String::new())
        };
        Explained {
            lines: vec![Live::everywhere("load = F_m / F_1", load), Live::everywhere(law, asked)],
            models_at_n: None,
            beside_name,
        }
    }
}
