//! What the hand does: it turns the knob, takes the feed and gives it back, and begins a cut anew.

use super::super::{Gone, HAIR_S, Plan, Session};
use super::{CLICK_PERCENT, KIND, readable_s};
use crate::app::command::HandCommand;
use crate::base::equation::number;
use crate::base::language::{decimal, tr};
use crate::base::settings::{SettingError, Value};
use crate::blocks::control::ControllerKind;
use crate::run::constant_feed_twin::is_of_controller;
use crate::run::edits::{Edit, Edits};
use crate::run::scenario::Scenario;
use crate::study::compare::by_hand::{ByHandJob, HAND};

/// The gesture that one turn is.
const TURN: &str = "by hand";

impl Session {
    /// Carries out what is done by hand.
    pub(in crate::app::session) fn by_hand(&mut self, command: HandCommand) {
        match command {
            HandCommand::Mode(on) => self.hand.switch(on),
            HandCommand::Toggle => self.hand.switch(!self.hand.on),
            HandCommand::Scale(scale) => (self.hand.scale, self.hand.refused) = (scale, None),
            HandCommand::Turn(clicks) => self.turn_to(self.clicked(clicks)),
            HandCommand::To(percent) => {
                self.turn_to((percent / CLICK_PERCENT).round() * CLICK_PERCENT);
            }
            // What is sent now goes on, in the whole percents of a panel.
            HandCommand::Take => self.turn_to(self.knob().percent.round()),
            HandCommand::GiveBack => self.give_back(),
            HandCommand::CutByHand => {
                self.note_script();
                let scenario = ByHandJob::without_control(&self.plan.0);
                self.cut_from_the_start(scenario);
            }
            HandCommand::CutBy(id) => {
                match ByHandJob::entrant(&self.plan.0, self.script_beside_hand(), id) {
                    Some(entrant) => self.cut_from_the_start(entrant.scenario),
                    None => self.notify(tr!("There is no way of control `{id}`.", id = id)),
                }
            }
        }
    }

    /// Where so many clicks lead from where the knob stands: from click to click.
    fn clicked(&self, clicks: i32) -> f64 {
        /// What an override may be off by and still stand at a click.
        const NEAR: f64 = 1e-6;
        let at = self.knob().percent / CLICK_PERCENT;
        let from = if clicks > 0 { (at + NEAR).floor() } else { (at - NEAR).ceil() };
        (from + f64::from(clicks)) * CLICK_PERCENT
    }

    /// Turns the knob as far as it goes, and says where it could not.
    fn turn_to(&mut self, wanted: f64) {
        let [low, high] = self.knob_range();
        // A range narrower than a click is none to turn in; its upper end counts.
        let percent = wanted.max(low).min(high);
        self.hand.refused =
            (percent != wanted).then(|| self.refused_text(decimal(number(wanted)), percent));
        if let Err(refused) = self.drive(percent) {
            self.hand.refused = Some(refused.clone());
            self.notify(refused);
        }
    }

    /// That an override is refused, and what ends the way of the knob at `percent`, with its name in files.
    fn refused_text(&self, wanted: String, percent: f64) -> String {
        let (cnc, end) = (&self.current.cnc, decimal(number(percent)));
        if percent == cnc.override_min_percent {
            tr!(
                "{wanted} % is refused: the override (cnc.override_min_percent) ends at {end} %.",
                wanted = wanted,
                end = end
            )
        } else if percent == cnc.override_max_percent {
            tr!(
                "{wanted} % is refused: the override (cnc.override_max_percent) ends at {end} %.",
                wanted = wanted,
                end = end
            )
        } else {
            tr!(
                "{wanted} % is refused: the scale of the panel ends at {end} %.",
                wanted = wanted,
                end = end
            )
        }
    }

    fn drive(&mut self, percent: f64) -> Result<(), String> {
        if self.finished().is_some() {
            return Err(
                tr("The cut is over: \u{201c}Cut by hand\u{201d} begins it again.").to_owned()
            );
        }
        let changes = [
            (KIND, Value::Text(ControllerKind::ConstantFeed.id().to_owned())),
            (HAND, Value::Float(percent)),
        ];
        let taken = !self.knob().by_hand;
        let changes = &changes[usize::from(!taken)..];
        let before = self.knob_owner();
        if taken {
            self.note_script();
        }
        let done = changes.iter().try_for_each(|(path, _)| self.is_open(path));
        let turned = done.and_then(|()| self.turned(changes));
        let (plan, later) = turned.map_err(|error| error.to_string())?;
        self.take(plan, TURN);
        self.report_gone(later, Gone::AfterPlayhead);
        if taken {
            self.notify(tr!(
                "You have the feed. Undo gives it back to {before}.",
                before = tr(before)
            ));
        }
        Ok(())
    }

    /// Name of who has the feed now.
    fn knob_owner(&self) -> &'static str {
        self.current.controller.kind.label()
    }

    /// Gives the feed back to who had it before.
    fn give_back(&mut self) {
        let Some(kind) = self.had_the_feed() else {
            return self.notify(tr("No controller had the feed in this cut."));
        };
        self.gesture = None;
        if let Err(error) = self.set(KIND, Value::Text(kind.id().to_owned())) {
            self.notify(error.to_string());
        }
        self.gesture = None;
    }

    /// The plan with changes by hand, and how many later edits they end. What the turn has set ahead of the playhead
    /// is replaced; nothing that is cut already changes.
    fn turned(&self, changes: &[(&str, Value)]) -> Result<(Plan, usize), SettingError> {
        let (scenario, mut edits) = self.plan.clone();
        let turning = self.gesture.as_deref() == Some(TURN);
        let now_s = self.next_sample_s();
        let cut = |edit: &Edit| edit.at_s < now_s - 0.5 * scenario.dt_s();
        let own = |edit: &Edit| turning && [HAND, KIND].contains(&edit.path.as_str());
        let later = edits.list().iter().filter(|edit| !cut(edit) && !own(edit)).count();
        // Whoever was to have the feed from a pending edit on has it now.
        let pending = edits.list().iter().any(|edit| !cut(edit) && own(edit) && edit.path == KIND);
        edits.truncate(now_s - 0.5 * scenario.dt_s());
        let last = edits.list().iter().rfind(|edit| turning && edit.path == HAND);
        let at_s = last.map_or(now_s, |edit| now_s.max(readable_s(edit.at_s + self.apart_s())));
        let by_hand = Value::Text(ControllerKind::ConstantFeed.id().to_owned());
        let taken = pending.then_some((KIND, by_hand));
        let then = edits.scenario_at(&scenario, at_s + HAIR_S)?;
        for (path, value) in taken.iter().chain(changes) {
            if then.get(path)? != *value {
                let (path, value) = ((*path).to_owned(), value.clone());
                edits.push(&scenario, Edit { at_s, path, value })?;
            }
        }
        let kept = self.keep_given(&scenario, &mut edits)?;
        Ok(((scenario, edits), later.saturating_sub(kept)))
    }

    /// Cuts the part of this scenario from its start, with what was changed in the running cut but for its control.
    fn cut_from_the_start(&mut self, scenario: Scenario) {
        let closed = scenario
            .difference(&self.plan.0)
            .into_iter()
            .find_map(|(param, _)| self.is_open(&param.path).err());
        if let Some(refused) = closed {
            return self.notify(refused.to_string());
        }
        let given = self.mission.as_ref().map_or_else(Edits::none, |lock| lock.given.clone());
        let others =
            self.plan.1.only(|edit| !is_of_controller(&edit.path) || given.list().contains(edit));
        let (edits, unfit) = others.fitted(&scenario);
        let plan = (scenario, edits);
        self.hand.refused = None;
        if plan != self.plan {
            self.remember(None);
            self.change(plan);
            // It is another cut, not this one before a change.
            self.ghost = None;
            self.report(&unfit);
        }
        self.playback.restart();
        self.refresh();
        self.compare();
    }
}
