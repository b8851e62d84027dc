//! How commands change a session: settings, undo and redo, and the playhead.

use super::{HAIR_S, MAX_UNDO, Plan, Session, TICKS_PER_FRAME};
use crate::app::command::{PlaybackCommand, SessionCommand};
use crate::app::cut::{Ghost, first_difference};
use crate::app::playback::Speed;
use crate::base::settings::{SettingError, Value};
use crate::blocks::control::ControllerKind;
use crate::models::formula_model::FormulaModel;
use crate::models::genetic::{Calibration, FormulaSettings};
use crate::models::unks::Stored;
use crate::run::constant_feed_twin;
use crate::run::edits::{Edit, Edits, Unfit};
use crate::run::scenario::{Scenario, param};
use crate::run::{presets, scenario_file};
use crate::study::unks_passes::beginning_with;

/// Values of one drag are kept at this distance of real time at least, s: a link must not grow with the frame
/// rate, nor with the speed of playing.
const DRAG_S: f64 = 0.25;

/// A plan with the scenario itself changed, and what that ends.
struct Rewritten {
    plan: Plan,
    /// The edits that no longer fit: those after a shorter run, or that break a rule with the new settings.
    unfit: Vec<Unfit>,
    /// Edits of the settings that are set again.
    set_again: usize,
}

/// A formula for the setting at `path`, or none, with the calibrations of plant and controller that it asks for, in an
/// order in which each of them keeps the rules: a formula comes before who takes it, and goes after.
fn with_calibrations(now: &Scenario, path: &str, value: Value) -> Vec<(String, Value)> {
    let given = value != Value::Text(String::new());
    let own = (path.to_owned(), value);
    if !FormulaSettings::is_model(path) {
        return vec![own];
    }
    let set = |whose: &str, calibration: Calibration| {
        (format!("{whose}.calibration"), Value::Text(calibration.id().to_owned()))
    };
    if given {
        let mut changes = vec![own, set("belief", Calibration::Formula)];
        if FormulaSettings::OF_PLANT.iter().any(|role| path.ends_with(&format!(".{role}"))) {
            changes.push(set("plant", Calibration::Formula));
        }
        return changes;
    }
    // Whoever is left without a formula has the identified models again.
    let is_left = |roles: &[&str]| {
        let others =
            roles.iter().map(|role| format!("formula.{role}")).filter(|other| other != path);
        others
            .into_iter()
            .any(|other| now.get(&other).is_ok_and(|value| value != Value::Text(String::new())))
    };
    let mut changes = Vec::new();
    for (whose, calibration, roles) in [
        ("plant", now.plant.calibration, &FormulaSettings::OF_PLANT[..]),
        ("belief", now.belief.calibration, &FormulaSettings::OF_MODELS[..]),
    ] {
        if calibration == Calibration::Formula && !is_left(roles) {
            changes.push(set(whose, Calibration::Identified));
        }
    }
    changes.push(own);
    changes
}

impl Session {
    /// Changes scenario and edits, and shows or removes messages.
    pub fn execute(&mut self, command: SessionCommand) {
        match command {
            SessionCommand::Set { path, value } => {
                if let Err(error) = self.set(&path, value) {
                    self.notify(error.to_string());
                }
            }
            SessionCommand::SetFormula { path, value } => {
                if let Err(error) = self.set_formula(&path, self.for_this_cutter(value)) {
                    self.notify(error.to_string());
                }
            }
            SessionCommand::LoadFormula { path, name, text } => {
                if let Err(error) = self.load_formula(&path, &text) {
                    self.notify(format!("{name}: {error}"));
                }
            }
            SessionCommand::SetUp(changes) => {
                if let Err(error) = self.set_up(&changes) {
                    self.notify(error.to_string());
                }
            }
            SessionCommand::LoadPreset(name) => {
                self.load(presets::load(&name).map(|s| (s, Edits::none())))
            }
            SessionCommand::LoadText { name, text } => {
                let read = scenario_file::parse(&text);
                let said = format!("{name} is open: it is cut from its start.");
                let named =
                    |e: SettingError| SettingError::Format { what: name, problem: e.to_string() };
                let opened = read.is_ok();
                self.load(read.map_err(named));
                if opened {
                    self.notify(said);
                }
            }
            SessionCommand::LoadNetworks { name, text } => {
                if let Err(error) = self.load_networks(&text) {
                    self.notify(format!("{name}: {error}"));
                }
            }
            SessionCommand::Notify(text) => self.notify(text),
            SessionCommand::Undo => {
                self.gesture = None;
                if let Some(plan) = self.undo.pop() {
                    let now = self.change(plan);
                    self.redo.push(now);
                }
            }
            SessionCommand::Redo => {
                self.gesture = None;
                if let Some(plan) = self.redo.pop() {
                    let now = self.change(plan);
                    self.undo.push(now);
                }
            }
        }
    }

    /// Moves the playhead, or says how it moves and what the plots show of it.
    pub fn play(&mut self, command: PlaybackCommand) {
        let (end_s, over) = (self.chosen.simulated_s(), self.chosen.is_over());
        let playback = &mut self.playback;
        let playhead_s = playback.playhead_s;
        match command {
            PlaybackCommand::TogglePlay if playback.playing => playback.playing = false,
            PlaybackCommand::TogglePlay if !playback.at_end || !over => {
                (playback.playing, playback.at_end) = (true, false);
            }
            PlaybackCommand::TogglePlay | PlaybackCommand::Restart => playback.restart(),
            PlaybackCommand::Step(samples) => {
                playback.playing = false;
                let period_s = self.plan.0.control_period_s();
                // On the grid of control samples, with room for the rounding of its times.
                let sample = (playhead_s / period_s + 1e-6).floor() + samples as f64;
                self.seek(sample * period_s);
            }
            PlaybackCommand::SeekBy(by_s) => self.seek(playhead_s + by_s),
            PlaybackCommand::SeekTo(to_s) => self.seek(to_s),
            // And on with it, while it is still being simulated.
            PlaybackCommand::SeekToEnd => {
                (playback.playhead_s, playback.playing, playback.at_end) = (end_s, false, true);
            }
            PlaybackCommand::Speed(speed) => playback.speed = speed,
            PlaybackCommand::Follow(follow) => playback.follow = follow,
        }
        self.refresh();
    }

    fn seek(&mut self, to_s: f64) {
        if to_s.is_finite() {
            let end_s = self.chosen.simulated_s();
            self.playback.at_end = self.chosen.is_over() && to_s >= end_s;
            self.playback.playing &= !self.playback.at_end;
            self.playback.playhead_s = to_s.clamp(0.0, end_s);
        }
    }

    fn load(&mut self, plan: Result<Plan, SettingError>) {
        match plan {
            Ok(plan) => {
                self.remember(None);
                self.change(plan);
                self.ghost = None;
                self.playback.restart();
                self.refresh();
                self.compare();
            }
            Err(error) => self.notify(error.to_string()),
        }
    }

    /// Keeps the present plan for undo, unless the gesture on `path` is still going on.
    fn remember(&mut self, path: Option<&str>) {
        if path.is_some() && self.gesture.as_deref() == path {
            return;
        }
        self.gesture = path.map(str::to_owned);
        self.redo.clear();
        self.undo.push(self.plan.clone());
        if self.undo.len() > MAX_UNDO {
            self.undo.remove(0);
        }
        self.ghost = None;
    }

    fn set(&mut self, path: &str, value: Value) -> Result<(), SettingError> {
        let found = param(path)?;
        if found.spec.live && self.playback.playhead_s > 0.0 && !self.playback.at_end {
            let (plan, later) = self.edited(path, value)?;
            self.take(plan, path);
            self.report_gone(later, "after the playhead");
            return Ok(());
        }
        let Rewritten { plan, unfit, set_again } = self.rewritten(&[(path.to_owned(), value)])?;
        self.take(plan, path);
        self.report(&unfit);
        self.report_gone(set_again, "of what is set for the whole cut now");
        Ok(())
    }

    fn set_up(&mut self, changes: &[(String, Value)]) -> Result<(), SettingError> {
        let Rewritten { plan, unfit, set_again } = self.rewritten(changes)?;
        let paths: Vec<&str> = changes.iter().map(|(path, _)| path.as_str()).collect();
        // Another gesture than one on the same setting at the playhead.
        self.take(plan, &format!("set up {}", paths.join(" ")));
        self.report(&unfit);
        self.report_gone(set_again, "of what is set for the whole cut now");
        Ok(())
    }

    /// Sets a formula of one's own, or takes it away, with the calibrations that ask for it.
    fn set_formula(&mut self, path: &str, value: Value) -> Result<(), SettingError> {
        let gesture = format!("formula {path}");
        let changes = with_calibrations(&self.current, path, value);
        if self.playback.playhead_s > 0.0 && !self.playback.at_end {
            let (plan, later) = self.edited_together(&changes)?;
            self.take(plan, &gesture);
            self.report_gone(later, "after the playhead");
        } else {
            let Rewritten { plan, unfit, set_again } = self.rewritten(&changes)?;
            self.take(plan, &gesture);
            self.report(&unfit);
            self.report_gone(set_again, "of what is set for the whole cut now");
        }
        self.gesture = None;
        Ok(())
    }

    /// A formula that is typed or found here, and names no cutter, is taken for one of the present cutter; a file that
    /// names none is of the papers'.
    fn for_this_cutter(&self, value: Value) -> Value {
        let tool = &self.current.tool;
        let Value::Text(text) = &value else { return value };
        match FormulaModel::parse(text) {
            Ok(model) if model.tool().is_none() && !tool.cuts_as_in_the_papers() => {
                Value::Text(model.found_on(tool.shipped_alike()).write_line())
            }
            Ok(_) | Err(_) => value,
        }
    }

    /// Takes the formula of a file.
    fn load_formula(&mut self, path: &str, text: &str) -> Result<(), String> {
        let model = FormulaModel::parse(text)?;
        let value = Value::Text(model.write_line());
        self.set_formula(path, value).map_err(|error| error.to_string())
    }

    /// Begins with the networks of a file, with the controller that has networks.
    fn load_networks(&mut self, text: &str) -> Result<(), String> {
        let mut changes = beginning_with(&Stored::parse(text)?);
        let unks = Value::Text(ControllerKind::Unks.id().to_owned());
        changes.push(("controller.kind".to_owned(), unks));
        self.set_up(&changes).map_err(|error| error.to_string())
    }

    /// Replaces the plan, as a part of the gesture of this name.
    fn take(&mut self, plan: Plan, gesture: &str) {
        if plan != self.plan {
            self.remember(Some(gesture));
            self.change(plan);
        }
    }

    /// The plan with changes at the playhead, all or none, and how many later edits they end.
    fn edited_together(&self, changes: &[(String, Value)]) -> Result<(Plan, usize), SettingError> {
        let (scenario, mut edits) = self.plan.clone();
        let at_s = self.playhead_tick_s();
        let before = edits.list().len();
        edits.truncate(at_s + 0.5 * scenario.dt_s());
        let later = before - edits.list().len();
        for (path, value) in changes {
            if self.current.get(path)? != *value {
                let edit = Edit { at_s, path: path.clone(), value: value.clone() };
                edits.push(&scenario, edit)?;
            }
        }
        Ok(((scenario, edits), later))
    }

    /// The tick at or before the playhead, s, in digits that people can read.
    fn playhead_tick_s(&self) -> f64 {
        let dt_s = self.plan.0.dt_s();
        let tick = ((self.playback.playhead_s + HAIR_S) / dt_s).floor();
        (tick * dt_s * 1e6).round() / 1e6
    }

    /// The plan with a change at the playhead, and how many later edits it ends.
    fn edited(&self, path: &str, value: Value) -> Result<(Plan, usize), SettingError> {
        let (scenario, mut edits) = self.plan.clone();
        if self.current.get(path)? == value {
            return Ok(((scenario, edits), 0));
        }
        let dt_s = scenario.dt_s();
        let at_s = self.playhead_tick_s();
        let before = edits.list().len();
        edits.truncate(at_s + 0.5 * dt_s);
        let later = before - edits.list().len();
        // A drag sends a value every frame: within a short time only the last one is kept.
        let apart_s = match self.playback.speed {
            Speed::Times(factor) => DRAG_S * factor.max(1.0),
            Speed::Max => DRAG_S,
        };
        let dragged = |edit: &&Edit| {
            self.gesture.as_deref() == Some(path) && edit.path == path && at_s - edit.at_s < apart_s
        };
        let at_s = edits.list().last().filter(dragged).map_or(at_s, |edit| edit.at_s);
        edits.push(&scenario, Edit { at_s, path: path.to_owned(), value })?;
        Ok(((scenario, edits), later))
    }

    /// The plan with the scenario itself changed. A setting that is set again loses its edits.
    fn rewritten(&self, changes: &[(String, Value)]) -> Result<Rewritten, SettingError> {
        let (mut scenario, old) = self.plan.clone();
        scenario.set_all(changes)?;
        let kept = old.only(|edit| changes.iter().all(|(path, _)| edit.path != *path));
        let set_again = old.list().len() - kept.list().len();
        let (edits, unfit) = kept.fitted(&scenario);
        Ok(Rewritten { plan: (scenario, edits), unfit, set_again })
    }

    /// Takes over a plan and gives back the one before; the old future becomes the ghost.
    fn change(&mut self, plan: Plan) -> Plan {
        let from_s =
            if plan.0 == self.plan.0 { first_difference(&self.plan.1, &plan.1) } else { Some(0.0) };
        let Some(from_s) = from_s else { return self.plan.clone() };
        if self.ghost.is_none() || self.gesture.is_none() {
            self.ghost = Some(Ghost { from_s, traces: self.chosen.traces().clone() });
        }
        self.chosen.change(&plan.0, &plan.1);
        // Places after the change are others; the twin meets them anew.
        self.shared.truncate(from_s);
        self.twin.change(&constant_feed_twin::scenario(&plan.0), &self.shared.edits());
        let before = std::mem::replace(&mut self.plan, plan);
        self.changes += 1;
        // The picture of this frame shall already show what the change does at the playhead.
        for cut in [&mut self.chosen, &mut self.twin] {
            cut.advance(TICKS_PER_FRAME);
        }
        self.meet();
        let end_s = self.chosen.simulated_s();
        if self.playback.at_end {
            self.playback.playhead_s = end_s;
        } else if self.chosen.is_over() {
            self.playback.playhead_s = self.playback.playhead_s.min(end_s);
        }
        self.refresh();
        before
    }
}
