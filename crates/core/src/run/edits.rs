//! Edits: changes of live settings at a moment of the run. A run is a pure function of scenario
//! and edits, so a live session replays exactly.

use super::scenario::{Scenario, companion, joins, param};
use crate::base::language::tr;
use crate::base::settings::{SettingError, Value};

/// One change during a run.
#[derive(Clone, Debug, PartialEq)]
pub struct Edit {
    /// Time of the change in s; it acts from the nearest tick on.
    pub at_s: f64,
    /// Path of a live setting.
    pub path: String,
    /// The new value.
    pub value: Value,
}

/// Edits in the order of time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Edits(Vec<Edit>);

/// An edit that does not fit a base.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{}", unfit(edit.at_s, reason))]
pub struct Unfit {
    /// The edit.
    pub edit: Edit,
    /// Why it is refused.
    pub reason: SettingError,
}

fn unfit(at_s: f64, reason: &SettingError) -> String {
    tr!(
        "the change at {at} s does not fit any more: {reason}",
        at = at_s,
        reason = reason.to_string()
    )
}

/// Most edits in one run.
pub const MAX_EDITS: usize = 100_000;

impl Edits {
    /// No edits.
    #[must_use]
    pub fn none() -> Self {
        Self::default()
    }

    /// The edits in the order of time.
    #[must_use]
    pub fn list(&self) -> &[Edit] {
        &self.0
    }

    /// Adds a change; among changes of the same time the last one wins.
    ///
    /// ```
    /// use steadycut_core::base::settings::Value;
    /// use steadycut_core::run::{edits::{Edit, Edits}, one_run::Run, presets};
    ///
    /// let scenario = presets::load("table3-5").unwrap();
    /// let mut edits = Edits::none();
    /// let finer = Edit { at_s: 8.0, path: "target.ra_um".into(), value: Value::Float(0.6) };
    /// edits.push(&scenario, finer).unwrap();
    ///
    /// let run = Run::complete(&scenario, &edits);
    /// let force_n = |time_s| run.recording().rows()[run.recording().index_at(time_s)].force_n;
    /// assert!(force_n(14.0) < force_n(7.9), "a finer surface wants less force");
    /// ```
    ///
    /// # Errors
    /// The setting is unknown or belongs to the set-up, the time lies outside the run, the value is
    /// outside its range or breaks a rule with the edits of another setting, or there are too many.
    /// The edits are then unchanged.
    pub fn push(&mut self, base: &Scenario, mut edit: Edit) -> Result<(), SettingError> {
        // An edit of an earlier version may have a path of then.
        edit.path.clone_from(&param(&edit.path)?.path);
        fits_alone(base, &edit)?;
        if self.0.len() >= MAX_EDITS {
            let (value, allowed) = (tr("changed again"), tr("at most 100000 changes in a run"));
            let [value, allowed] = [value, allowed].map(str::to_owned);
            return Err(SettingError::Refused { path: edit.path, value, allowed });
        }
        Scenario::accepts(&edit.path, &edit.value)?;
        let before = joins(&edit.path).then(|| self.0.clone());
        self.insert(edit);
        if let Some(before) = before
            && let Err(error) = self.check(base)
        {
            self.0 = before;
            return Err(error);
        }
        Ok(())
    }

    fn insert(&mut self, edit: Edit) {
        let first = self.0.partition_point(|other| other.at_s < edit.at_s);
        let mut end = self.0.partition_point(|other| other.at_s <= edit.at_s);
        let companion = companion(&edit.path).map(|companion| companion.brings);
        for index in (first..end).rev() {
            let other = &self.0[index].path;
            if *other == edit.path || Some(other.as_str()) == companion {
                self.0.remove(index);
                end -= 1;
            }
        }
        self.0.insert(end, edit);
    }

    /// Forgets all edits at or after a time in s.
    pub fn truncate(&mut self, from_s: f64) {
        self.0.retain(|edit| edit.at_s < from_s);
    }

    fn check(&self, base: &Scenario) -> Result<(), SettingError> {
        let mut scenario = base.clone();
        for edit in self.0.iter().filter(|edit| joins(&edit.path)) {
            scenario.set(&edit.path, edit.value.clone())?;
        }
        Ok(())
    }

    /// Those of these edits that are wanted, unchecked: left out must be all or none of what a rule
    /// joins. A run ends at an edit that does not fit.
    #[must_use]
    pub fn only(&self, wanted: impl Fn(&Edit) -> bool) -> Self {
        Self(self.0.iter().filter(|edit| wanted(edit)).cloned().collect())
    }

    /// These edits at other times in s, in the same order, unchecked: one for each.
    #[must_use]
    pub(super) fn at_times(edits: impl IntoIterator<Item = (Edit, f64)>) -> Self {
        Self(edits.into_iter().map(|(edit, at_s)| Edit { at_s, ..edit }).collect())
    }

    /// Those of these edits that fit another base, and those that do not, with the reason.
    #[must_use]
    pub fn fitted(&self, base: &Scenario) -> (Self, Vec<Unfit>) {
        let (mut fitting, mut unfit) = (Vec::new(), Vec::new());
        // They are in the order of time, so each meets the scenario that those before it have made.
        let mut now = base.clone();
        for edit in &self.0 {
            let fits = fits_alone(base, edit);
            match fits.and_then(|()| now.set(&edit.path, edit.value.clone())) {
                Ok(()) => fitting.push(edit.clone()),
                Err(reason) => unfit.push(Unfit { edit: edit.clone(), reason }),
            }
        }
        (Self(fitting), unfit)
    }

    /// The scenario as it stands at a time in s, edits up to it applied.
    ///
    /// # Errors
    /// An edit that does not fit `base`: another one than it was pushed with.
    pub fn scenario_at(&self, base: &Scenario, time_s: f64) -> Result<Scenario, SettingError> {
        let mut scenario = base.clone();
        for edit in self.0.iter().filter(|edit| edit.at_s <= time_s) {
            scenario.set(&edit.path, edit.value.clone())?;
        }
        Ok(scenario)
    }
}

/// Whether an edit fits a base, other edits and its value aside: a live setting, a time in the run.
fn fits_alone(base: &Scenario, edit: &Edit) -> Result<(), SettingError> {
    let refused = |value: String, allowed: String| {
        Err(SettingError::Refused { path: edit.path.clone(), value, allowed })
    };
    if !param(&edit.path)?.spec.live {
        let allowed = tr("a change of the scenario itself: it belongs to the set-up");
        return refused(tr("changed during the run").to_owned(), allowed.to_owned());
    }
    if !(edit.at_s >= 0.0 && edit.at_s < base.run.duration_s) {
        let allowed = tr!("a time from 0 to before {end} s", end = base.run.duration_s);
        return refused(tr!("changed at {at} s", at = edit.at_s), allowed);
    }
    Ok(())
}
