//! The feed override in the learner's hand, as on a machine's panel. A turn becomes edits of the run at its control
//! samples, far enough apart that a link stays short, none of them before the playhead; it is one step of undo. The
//! last cut that was driven by hand to its end is kept, to be drawn beside a controller's.

mod drive;

use super::{HAIR_S, Plan, Session};
use crate::app::playback::Speed;
use crate::app::trace::Traces;
use crate::base::settings::Value;
use crate::blocks::control::ControllerKind;
use crate::blocks::control::script::ScriptSettings;
use crate::run::constant_feed_twin::is_of_controller;
use crate::run::recording::Recording;
use crate::run::scenario::Scenario;
use crate::study::compare::by_hand::{HAND, is_by_hand};

/// A click of the knob, percent (chosen: a tolerance of 10 % of Ra is met within some 2 % of the override, and
/// panels click by 5 or 10 %).
pub const CLICK_PERCENT: f64 = 2.0;
/// Where the scale of a machine's panel ends, percent (Fagor 8055: 0 to 120 %).
pub const PANEL_PERCENT: f64 = 120.0;
/// Edits of one turn lie so far apart at least, s of real time: a hand is no faster, and a link stays short.
const APART_S: f64 = 0.1;
/// The setting that says who has the feed.
const KIND: &str = "controller.kind";

steadycut_core::choice! {
    /// How far the knob goes.
    pub enum KnobScale {
        /// To 120 %, as on a machine's panel.
        Panel = "panel", "0 to 120 %, as on a panel";
        /// As far as the override of the CNC goes, which controllers may use.
        Whole = "whole", "as far as controllers may";
    }
}

/// A cut that was driven by hand to its end.
#[derive(Clone, Debug)]
pub struct HandTrace {
    plan: Plan,
    /// Its signals.
    pub traces: Traces,
    /// Its rows.
    pub recording: Recording,
}

/// The state of driving by hand.
#[derive(Clone, Debug)]
pub struct Driving {
    on: bool,
    scale: KnobScale,
    refused: Option<String>,
    kept: Option<HandTrace>,
    /// The change of the session after which that was kept.
    kept_at: Option<u64>,
    /// Whether it belongs to the part that is cut now, and is not that cut itself.
    is_shown: bool,
    /// The script that had the feed before the hand took it, with the scenario that it ran in.
    script: Option<Box<(Scenario, ScriptSettings)>>,
    /// Whether that scenario's part is cut now.
    script_takes_part: bool,
}

impl Default for Driving {
    fn default() -> Self {
        Self {
            on: false,
            scale: KnobScale::Panel,
            refused: None,
            kept: None,
            kept_at: None,
            is_shown: false,
            script: None,
            script_takes_part: false,
        }
    }
}

impl Driving {
    /// Whether the operator mode is on: the knob is in sight, and its keys act.
    #[must_use]
    pub fn is_on(&self) -> bool {
        self.on
    }

    /// How far the knob goes.
    #[must_use]
    pub fn scale(&self) -> KnobScale {
        self.scale
    }

    /// Why the last turn did not go as far as it was meant to, if it did not.
    #[must_use]
    pub fn refused(&self) -> Option<&str> {
        self.refused.as_deref()
    }

    /// Switches the operator mode.
    pub(super) fn switch(&mut self, on: bool) {
        (self.on, self.refused) = (on, None);
    }

    /// Whether the kept cut is of the same part as this plan, and another one.
    pub(super) fn follow(&mut self, plan: &Plan) {
        let beside = |kept: &HandTrace| kept.plan != *plan && is_same_part(&kept.plan.0, &plan.0);
        self.is_shown = self.kept.as_ref().is_some_and(beside);
        self.script_takes_part =
            self.script.as_ref().is_some_and(|script| is_same_part(&script.0, &plan.0));
    }
}

/// Whether a mission that opens these settings is one for the hand: the override is open, and no controller is.
#[must_use]
pub fn is_for_the_hand(open: &[String]) -> bool {
    let opens = |wanted: &str| open.iter().any(|path| path == wanted);
    opens(HAND) && !opens(KIND)
}

/// Whether two scenarios differ in nothing but who controls, what is compared with, and their names.
fn is_same_part(a: &Scenario, b: &Scenario) -> bool {
    let apart = a.difference(b);
    apart
        .iter()
        .all(|(param, _)| is_of_controller(&param.path) || ["", "twin"].contains(&param.group))
}

/// Where the knob stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KnobStand {
    /// Whether the hand has the feed; otherwise a controller has it, and the override is the one that it sends.
    pub by_hand: bool,
    /// The override, percent.
    pub percent: f64,
}

impl Session {
    /// Driving by hand.
    #[must_use]
    pub fn hand(&self) -> &Driving {
        &self.hand
    }

    /// The last cut driven by hand, where it is to be drawn beside the present one.
    #[must_use]
    pub fn hand_trace(&self) -> Option<&HandTrace> {
        self.hand.kept.as_ref().filter(|_| self.hand.is_shown)
    }

    /// The script of one's own that the hand is scored against: the one that has the feed in this cut, or had it before the
    /// hand cut the same part. One that came with a file or a link and was not allowed to run takes no part.
    #[must_use]
    pub fn script_beside_hand(&self) -> Option<&ScriptSettings> {
        let noted = self.hand.script.as_ref().filter(|_| self.hand.script_takes_part);
        noted.map(|noted| &noted.1).or_else(|| self.running_script())
    }

    /// The script that has the feed at the playhead or at the start of the cut, if it may run.
    fn running_script(&self) -> Option<&ScriptSettings> {
        let runs = |scenario: &Scenario| scenario.controller.kind == ControllerKind::Script;
        let running = [&self.current, &self.plan.0].into_iter().find(|scenario| runs(scenario));
        running.filter(|_| !self.waits).map(|scenario| &scenario.controller.script)
    }

    /// Keeps the script that has the feed, before the hand takes it.
    fn note_script(&mut self) {
        let noted = self.running_script().map(|script| (self.plan.0.clone(), script.clone()));
        if let Some(noted) = noted {
            (self.hand.script, self.hand.script_takes_part) = (Some(Box::new(noted)), true);
        }
    }

    /// Whether the present cut is driven by hand.
    #[must_use]
    pub fn is_by_hand(&self) -> bool {
        is_by_hand(&self.plan.1)
    }

    /// Where the knob stands at the playhead, turned or not.
    #[must_use]
    pub fn knob(&self) -> KnobStand {
        let at_s = self.next_sample_s() + self.apart_s() + HAIR_S;
        let (mut kind, mut percent) =
            (self.plan.0.controller.kind, self.plan.0.controller.constant_feed.feed_percent);
        for edit in self.plan.1.list().iter().take_while(|edit| edit.at_s <= at_s) {
            match &edit.value {
                Value::Float(value) if edit.path == HAND => percent = *value,
                Value::Text(id) if edit.path == KIND => {
                    kind = ControllerKind::ALL
                        .iter()
                        .copied()
                        .find(|kind| kind.id() == id)
                        .unwrap_or(kind);
                }
                Value::Float(_)
                | Value::Text(_)
                | Value::Int(_)
                | Value::Bool(_)
                | Value::List(_) => {}
            }
        }
        match kind == ControllerKind::ConstantFeed {
            true => KnobStand { by_hand: true, percent },
            false => KnobStand { by_hand: false, percent: self.row().feed_override_percent },
        }
    }

    /// The overrides that the knob reaches, percent: its scale, as far as the CNC lets an override go.
    #[must_use]
    pub fn knob_range(&self) -> [f64; 2] {
        let cnc = &self.current.cnc;
        let end = match self.hand.scale {
            KnobScale::Panel => PANEL_PERCENT,
            KnobScale::Whole => cnc.override_max_percent,
        };
        [cnc.override_min_percent, end.min(cnc.override_max_percent)]
    }

    /// Who had the feed before the hand took it, if somebody had.
    #[must_use]
    pub fn had_the_feed(&self) -> Option<ControllerKind> {
        let now_s = self.playback.playhead_s + HAIR_S;
        let edits = self.plan.1.list().iter().take_while(|edit| edit.at_s <= now_s);
        let chosen = edits.filter(|edit| edit.path == KIND).filter_map(|edit| match &edit.value {
            Value::Text(id) => ControllerKind::ALL.iter().copied().find(|kind| kind.id() == id),
            Value::Float(_) | Value::Int(_) | Value::Bool(_) | Value::List(_) => None,
        });
        let all: Vec<_> = std::iter::once(self.plan.0.controller.kind).chain(chosen).collect();
        all.into_iter().rfind(|kind| *kind != ControllerKind::ConstantFeed)
    }

    /// The first control sample at or after the playhead, s, in digits that people can read.
    fn next_sample_s(&self) -> f64 {
        let period_s = self.plan.0.control_period_s();
        let sample = ((self.playback.playhead_s - HAIR_S) / period_s).ceil();
        // No negative zero: a link could not write it.
        if sample > 0.0 { readable_s(sample * period_s) } else { 0.0 }
    }

    /// How far apart the edits of a turn lie, s of the run: whole control periods.
    fn apart_s(&self) -> f64 {
        let period_s = self.plan.0.control_period_s();
        let slow = match self.playback.speed {
            Speed::Times(factor) => factor.min(1.0),
            Speed::Max => 1.0,
        };
        (APART_S * slow / period_s).round().max(1.0) * period_s
    }

    /// Keeps a cut driven by hand once it is over and seen to its end.
    pub(super) fn keep_hand(&mut self) {
        if self.finished().is_none()
            || self.hand.kept_at == Some(self.changes)
            || !is_by_hand(&self.plan.1)
        {
            return;
        }
        let kept = HandTrace {
            plan: self.plan.clone(),
            traces: self.chosen.traces().clone(),
            recording: self.chosen.run().recording().clone(),
        };
        (self.hand.kept, self.hand.kept_at) = (Some(kept), Some(self.changes));
        self.hand.follow(&self.plan);
    }
}

/// A time in digits that people can read: to the microsecond.
fn readable_s(time_s: f64) -> f64 {
    (time_s * 1e6).round() / 1e6
}
