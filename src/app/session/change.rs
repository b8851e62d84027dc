//! How commands change a session: settings, undo and redo, and the playhead.

use super::foreign::brings_a_script;
use super::hand::is_for_the_hand;
use super::mishap::{BEFORE_MISHAP_S, NO_MISHAP};
use super::safe::scenario_of;
use super::{Gone, HAIR_S, MAX_UNDO, MissionLock, Plan, Session, TICKS_PER_FRAME, TwinStand};
use crate::app::command::{PlaybackCommand, SessionCommand};
use crate::app::cut::{Ghost, first_difference};
use crate::app::playback::Speed;
use crate::base::language::{text, tr};
use crate::base::settings::{Kind, SettingError, Value};
use crate::blocks::control::ControllerKind;
use crate::blocks::control::script::ScriptProgram;
use crate::models::formula_model::FormulaModel;
use crate::models::genetic::{Calibration, FormulaSettings};
use crate::models::unks::Stored;
use crate::run::constant_feed_twin;
use crate::run::edits::{Edit, Edits, Unfit};
use crate::run::scenario::{Scenario, param};
use crate::run::story::ONE_DRAG_S;
use crate::run::{presets, scenario_file};
use crate::study::library::script_changes;
use crate::study::own_file::OwnFile;
use crate::study::part::PartPath;
use crate::study::unks_passes::beginning_with;

/// Values of one drag are kept at this distance of real time at least, s: a link must not grow with the frame
/// rate, nor with the speed of playing.
const DRAG_S: f64 = 0.25;

/// Why a setting is locked.
pub const LOCKED: &str = text!("locked by the address that this was opened with");
/// Said where another scenario is asked for and something is locked.
pub const NO_OTHER_SCENARIO: &str = text!(
    "No other scenario is opened here: settings are locked by the address that this was opened with."
);

/// Said where a cut is asked for that is to be predicted.
pub const PREDICT_FIRST: &str = text!(
    "Predict first: the cut begins as soon as you have said what you expect, or gone on without a prediction."
);

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
            SessionCommand::CutAgain if self.hides_the_cut() => self.notify(tr(PREDICT_FIRST)),
            SessionCommand::CutAgain => self.cut_again(),
            SessionCommand::Disturb(command) => self.disturb(command),
            SessionCommand::Hand(command) => self.by_hand(command),
            SessionCommand::BeginMission { scenario, edits, lock } => {
                self.end_mission();
                let plan = (*scenario, edits);
                self.waits = brings_a_script(&plan);
                self.load(Ok(plan));
                self.wait_for_consent();
                // Nothing before the mission is a way back within it; it is one again when the mission is left.
                self.undo_before_mission = std::mem::take(&mut self.undo);
                self.hand.switch(is_for_the_hand(&lock.open));
                self.playback.playing = !lock.hides;
                self.mission = Some(*lock);
                self.missions += 1;
            }
            SessionCommand::EndMission => {
                self.end_mission();
            }
            SessionCommand::HideCut(hide) => self.hide_cut(hide),
            SessionCommand::LoadPreset(_) | SessionCommand::LoadText { .. } if self.has_locks() => {
                self.notify(tr(NO_OTHER_SCENARIO));
            }
            SessionCommand::LoadPreset(name) => {
                self.leave_mission();
                self.load(presets::load(&name).map(|s| (s, Edits::none())))
            }
            SessionCommand::LoadText { name, text } => {
                let read = scenario_file::parse(&text);
                let said = tr!("{name} is open: it is cut from its start.", name = name);
                let named =
                    |e: SettingError| SettingError::Format { what: name, problem: e.to_string() };
                let opened = read.is_ok();
                if opened {
                    self.leave_mission();
                }
                if let Ok(plan) = &read {
                    self.waits = brings_a_script(plan);
                }
                self.load(read.map_err(named));
                if opened {
                    self.notify(said);
                    self.wait_for_consent();
                }
            }
            SessionCommand::TakePart { name, path } => {
                if let Err(error) = self.take_part(&name, &path) {
                    self.notify(format!("{name}: {error}"));
                }
            }
            SessionCommand::LoadOwn { name, text } => match self.load_own(&text) {
                Ok(told) => self.notify(format!("{name}: {told}")),
                Err(error) => self.notify(format!("{name}: {error}")),
            },
            SessionCommand::LoadScript { name, text } => match self.load_script(&text) {
                Ok(()) => self.notify(tr!("{name} controls this cut now.", name = name)),
                Err(error) => self.notify(format!("{name}: {error}")),
            },
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
        let moves = !matches!(command, PlaybackCommand::Speed(_) | PlaybackCommand::Follow(_));
        if moves && self.hides_the_cut() {
            self.notify(tr(PREDICT_FIRST));
            return;
        }
        let (end_s, over) = (self.chosen.simulated_s(), self.chosen.is_over());
        self.waits &= match command {
            PlaybackCommand::Speed(_) | PlaybackCommand::Follow(_) => true,
            // Whoever asks for the cut asks for what controls it.
            PlaybackCommand::TogglePlay
            | PlaybackCommand::Restart
            | PlaybackCommand::Step(_)
            | PlaybackCommand::SeekBy(_)
            | PlaybackCommand::SeekTo(_)
            | PlaybackCommand::SeekToEnd
            | PlaybackCommand::TryAgain => false,
        };
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
            PlaybackCommand::TryAgain => {
                playback.playing = false;
                match self.mishap_s() {
                    Some(mishap_s) => self.seek(mishap_s - BEFORE_MISHAP_S),
                    None => self.notify(tr(NO_MISHAP)),
                }
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
                // The feed of another part says nothing of this one.
                if matches!(self.stand, TwinStand::Finding(Some(_))) {
                    self.stand = TwinStand::Finding(None);
                }
                self.playback.restart();
                self.refresh();
                self.compare();
            }
            Err(error) => self.notify(error.to_string()),
        }
    }

    /// Makes the settings at the playhead those of the scenario, without edits, and cuts from the start.
    fn cut_again(&mut self) {
        // What a mission changes during its cut stays where it is.
        let given = self.mission.as_ref().map_or_else(Edits::none, |lock| lock.given.clone());
        let own = self.plan.1.only(|edit| !given.list().contains(edit));
        let edits = own.list().len();
        let now_s = self.playback.playhead_s + HAIR_S;
        if edits > 0
            && let Ok(now) = own.scenario_at(&self.plan.0, now_s)
        {
            let changed = now.difference(&self.plan.0);
            let names: Vec<&str> = changed.iter().map(|(param, _)| tr(param.spec.label)).collect();
            let names = match &names[..] {
                [] => String::new(),
                [first, second, third, _, ..] => tr!(
                    " Set for the whole cut now: {first}, {second}, {third}, {more} more.",
                    first = *first,
                    second = *second,
                    third = *third,
                    more = names.len() - 3
                ),
                some => tr!(" Set for the whole cut now: {list}.", list = some.join(", ")),
            };
            let of_edits = match edits {
                1 => tr("The change made during the cut is not repeated; Undo brings it back.")
                    .to_owned(),
                n => tr!(
                    "The {n} changes made during the cut are not repeated; Undo brings them back.",
                    n = n
                ),
            };
            self.remember(None);
            self.change((now, given));
            self.notify(tr!(
                "Cut from its start.{names} {of_edits}",
                names = names,
                of_edits = of_edits
            ));
        }
        self.playback.restart();
        self.refresh();
        self.compare();
    }

    /// Keeps the present plan for undo, unless the gesture on `path` is still going on.
    pub(super) fn remember(&mut self, path: Option<&str>) {
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

    /// Refuses to change what is locked, or what a mission does not open.
    pub(super) fn is_open(&self, path: &str) -> Result<(), SettingError> {
        let found = param(path)?;
        let path = &found.path;
        if self.locked.contains(path) {
            let because = tr!(
                "\u{201c}{setting}\u{201d} cannot be changed: it is {why}.",
                setting = tr(found.spec.label),
                why = tr(LOCKED)
            );
            return Err(SettingError::Closed { path: path.clone(), because });
        }
        let Some(lock) = &self.mission else { return Ok(()) };
        if lock.open.contains(path) {
            return Ok(());
        }
        let MissionLock { title, open, .. } = lock;
        let (title, setting) = (tr(title), tr(found.spec.label));
        let labels = open.iter().filter_map(|path| Some(tr(param(path).ok()?.spec.label)));
        let labels: Vec<&str> = labels.collect();
        let because = if labels.is_empty() {
            tr!(
                "The mission \u{201c}{title}\u{201d} is open: it locks all settings, and so \u{201c}{setting}\u{201d}. \
                 Leave the mission to change it.",
                title = title,
                setting = setting
            )
        } else {
            tr!(
                "The mission \u{201c}{title}\u{201d} is open and locks \u{201c}{setting}\u{201d}. It lets you change: \
                 {open}. Leave the mission to change anything else.",
                title = title,
                setting = setting,
                open = labels.join(", ")
            )
        };
        Err(SettingError::Closed { path: path.clone(), because })
    }

    /// Ends the mission under way, if there is one, and opens the way back to before it.
    fn end_mission(&mut self) -> Option<MissionLock> {
        let mut undo = std::mem::take(&mut self.undo_before_mission);
        undo.append(&mut self.undo);
        let over = undo.len().saturating_sub(MAX_UNDO);
        undo.drain(..over);
        self.undo = undo;
        let mission = self.mission.take();
        // What stood still to be predicted is a cut like any other now.
        self.playback.playing |= mission.as_ref().is_some_and(|lock| lock.hides);
        self.missions += u64::from(mission.is_some());
        if mission.as_ref().is_some_and(|lock| is_for_the_hand(&lock.open)) {
            self.hand.switch(false);
        }
        mission
    }

    /// Hides the cut of the mission under way at its start, or shows it from there.
    fn hide_cut(&mut self, hide: bool) {
        let Some(lock) = self.mission.as_mut().filter(|lock| lock.hides != hide) else { return };
        lock.hides = hide;
        self.playback.restart();
        self.playback.playing = !hide;
        self.refresh();
        self.compare();
    }

    /// Another cut is opened: a mission does not go on with it.
    fn leave_mission(&mut self) {
        if let Some(lock) = self.end_mission() {
            self.notify(tr!(
                "The mission \u{201c}{title}\u{201d} is left.",
                title = tr(&lock.title)
            ));
        }
    }

    /// Puts the changes back that are part of a mission; gives how many.
    pub(super) fn keep_given(
        &self,
        scenario: &Scenario,
        edits: &mut Edits,
    ) -> Result<usize, SettingError> {
        let mut kept = 0;
        for edit in self.mission.iter().flat_map(|lock| lock.given.list()) {
            if !edits.list().contains(edit) {
                edits.push(scenario, edit.clone())?;
                kept += 1;
            }
        }
        Ok(kept)
    }

    /// Refuses an option that the mission under way does not offer.
    fn is_offered(&self, path: &str, value: &Value) -> Result<(), SettingError> {
        let found = param(path)?;
        let Some(lock) = &self.mission else { return Ok(()) };
        let (Some(offered), Kind::Choice { options }, Value::Text(id)) =
            (lock.options.get(&found.path), &found.spec.allowed, value)
        else {
            return Ok(());
        };
        if offered.contains(id) {
            return Ok(());
        }
        let labels = options.iter().filter(|option| offered.iter().any(|id| id == option.id));
        let labels: Vec<&str> = labels.map(|option| tr(option.label)).collect();
        let because = tr!(
            "The mission \u{201c}{title}\u{201d} is open. Of \u{201c}{setting}\u{201d} it offers: {list}. Leave the \
             mission to choose anything else.",
            title = tr(&lock.title),
            setting = tr(found.spec.label),
            list = labels.join(", ")
        );
        Err(SettingError::Closed { path: found.path.clone(), because })
    }

    pub(super) fn set(&mut self, path: &str, value: Value) -> Result<(), SettingError> {
        self.is_open(path)?;
        self.is_offered(path, &value)?;
        let found = param(path)?;
        if found.spec.live && self.playback.playhead_s > 0.0 && !self.playback.at_end {
            let (plan, later) = self.edited(path, value)?;
            self.take(plan, path);
            self.report_gone(later, Gone::AfterPlayhead);
            return Ok(());
        }
        let Rewritten { plan, unfit, set_again } = self.rewritten(&[(path.to_owned(), value)])?;
        let over = self.playback.at_end && self.chosen.is_over();
        let changes = self.changes;
        self.take(plan, path);
        // During the cut it would have acted from the playhead on alone.
        if over && self.changes > changes && found.spec.live {
            self.notify(tr!(
                "The cut is over: {setting} is set for the whole part, which is cut anew from its start. Undo brings the cut \
                 of before back; a change while it is cut acts from there on.",
                setting = tr(found.spec.label),
            ));
        }
        self.report(&unfit);
        self.report_gone(set_again, Gone::SetAgain);
        Ok(())
    }

    pub(super) fn set_up(&mut self, changes: &[(String, Value)]) -> Result<(), SettingError> {
        changes.iter().try_for_each(|(path, value)| {
            self.is_open(path)?;
            self.is_offered(path, value)
        })?;
        let Rewritten { plan, unfit, set_again } = self.rewritten(changes)?;
        let paths: Vec<&str> = changes.iter().map(|(path, _)| path.as_str()).collect();
        // Another gesture than one on the same setting at the playhead.
        self.take(plan, &format!("set up {}", paths.join(" ")));
        self.report(&unfit);
        self.report_gone(set_again, Gone::SetAgain);
        Ok(())
    }

    /// Sets a formula of one's own, or takes it away, with the calibrations that ask for it.
    fn set_formula(&mut self, path: &str, value: Value) -> Result<(), SettingError> {
        self.is_open(path)?;
        let gesture = format!("formula {path}");
        let changes = with_calibrations(&self.current, path, value);
        if self.playback.playhead_s > 0.0 && !self.playback.at_end {
            let (plan, later) = self.edited_together(&changes)?;
            self.take(plan, &gesture);
            self.report_gone(later, Gone::AfterPlayhead);
        } else {
            let Rewritten { plan, unfit, set_again } = self.rewritten(&changes)?;
            self.take(plan, &gesture);
            self.report(&unfit);
            self.report_gone(set_again, Gone::SetAgain);
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

    /// Makes a path the part of the scenario, and says what came with it.
    fn take_part(&mut self, name: &str, path: &PartPath) -> Result<(), String> {
        let part = path.to_scenario(&self.plan.0)?;
        self.set_up(&part.changes).map_err(|error| error.to_string())?;
        let is_now = tr!(
            "{name} is the part now: {length:.1} mm long, {air:.1} mm of it air.",
            name = name,
            length = path.length_mm,
            air = path.air_mm()
        );
        self.notify([vec![is_now], part.told].concat().join(" "));
        Ok(())
    }

    /// Takes the settings of a file of one's own, and says what it was.
    fn load_own(&mut self, text: &str) -> Result<String, SettingError> {
        let file = OwnFile::read(text)?;
        self.set_up(&file.changes)?;
        Ok(tr!(
            "{title} is taken as the {kind} of this cut",
            title = &file.title,
            kind = tr(file.kind.label())
        ))
    }

    /// Controls the cut by the script of a file.
    fn load_script(&mut self, text: &str) -> Result<(), String> {
        // Its own words name the line.
        ScriptProgram::read(text).map_err(|problem| problem.to_string())?;
        self.set_up(&script_changes(text)).map_err(|error| error.to_string())
    }

    /// Begins with the networks of a file, with the controller that has networks.
    fn load_networks(&mut self, text: &str) -> Result<(), String> {
        let mut changes = beginning_with(&Stored::parse(text)?);
        let unks = Value::Text(ControllerKind::Unks.id().to_owned());
        changes.push(("controller.kind".to_owned(), unks));
        self.set_up(&changes).map_err(|error| error.to_string())
    }

    /// Replaces the plan, as a part of the gesture of this name.
    pub(super) fn take(&mut self, plan: Plan, gesture: &str) {
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
        let kept = self.keep_given(&scenario, &mut edits)?;
        Ok(((scenario, edits), later - kept))
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
            // Farther apart than a story tells of as one drag, they are one.
            Speed::Times(factor) if DRAG_S * factor < 0.6 * ONE_DRAG_S => DRAG_S * factor.max(1.0),
            Speed::Times(_) | Speed::Max => f64::INFINITY,
        };
        let dragged = |edit: &&Edit| {
            self.gesture.as_deref() == Some(path) && edit.path == path && at_s - edit.at_s < apart_s
        };
        let at_s = edits.list().last().filter(dragged).map_or(at_s, |edit| edit.at_s);
        edits.push(&scenario, Edit { at_s, path: path.to_owned(), value })?;
        let kept = self.keep_given(&scenario, &mut edits)?;
        Ok(((scenario, edits), later - kept))
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
    pub(super) fn change(&mut self, plan: Plan) -> Plan {
        let from_s =
            if plan.0 == self.plan.0 { first_difference(&self.plan.1, &plan.1) } else { Some(0.0) };
        let Some(from_s) = from_s else { return self.plan.clone() };
        // The cut is the same where it is only compared with another one.
        let same_cut = plan.0.with(|settings| settings.twin = self.plan.0.twin.clone());
        let same_cut = same_cut.is_ok_and(|cut| cut == self.plan.0) && plan.1 == self.plan.1;
        if !same_cut && (self.ghost.is_none() || self.gesture.is_none()) {
            self.ghost = Some(Ghost { from_s, traces: self.chosen.traces().clone() });
        }
        self.chosen.change(&plan.0, &plan.1);
        // Places after the change are others; the twin meets them anew.
        self.shared.truncate(from_s);
        let shared = !constant_feed_twin::edits(&plan.1).list().is_empty();
        let twin_before = scenario_of(&self.plan.0, &self.stand);
        self.stand_beside(&plan.0, shared);
        let twin = scenario_of(&plan.0, &self.stand);
        if twin != twin_before {
            self.shared.truncate(0.0);
        }
        self.twin.change(&twin, &self.shared.edits());
        let before = std::mem::replace(&mut self.plan, plan);
        self.hand.follow(&self.plan);
        self.changes += 1;
        // The picture of this frame shall already show what the change does at the playhead.
        self.waits &= brings_a_script(&self.plan);
        if !self.waits {
            self.chosen.advance(TICKS_PER_FRAME);
        }
        if !self.twin_is_done() {
            self.twin.advance(TICKS_PER_FRAME);
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
