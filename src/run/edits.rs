//! Edits: changes of live settings at a moment of the run. A run is a pure function of scenario
//! and edits, so a live session replays exactly.

use super::scenario::{Scenario, param};
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
    /// # Errors
    /// The setting is unknown or belongs to the set-up, the time is not finite or negative, the
    /// value is refused by the scenario with all earlier edits applied, or there are too many.
    pub fn push(&mut self, base: &Scenario, edit: Edit) -> Result<(), SettingError> {
        let found = param(&edit.path)?;
        let refused = |value: String, allowed: &str| {
            let allowed = allowed.to_owned();
            Err(SettingError::Refused { path: edit.path.clone(), value, allowed })
        };
        if !found.spec.live {
            let allowed = "a change of the scenario itself: it belongs to the set-up";
            return refused("changed during the run".to_owned(), allowed);
        }
        if !(edit.at_s >= 0.0 && edit.at_s <= base.run.duration_s) {
            let allowed = format!("a time from 0 to {} s", base.run.duration_s);
            return refused(format!("changed at {} s", edit.at_s), &allowed);
        }
        if self.0.len() >= MAX_EDITS {
            return refused("changed again".to_owned(), "at most 100000 changes in a run");
        }
        self.0.retain(|other| other.at_s != edit.at_s || other.path != edit.path);
        let place = self.0.partition_point(|other| other.at_s <= edit.at_s);
        self.0.insert(place, edit);
        if let Err(error) = self.check(base) {
            self.0.remove(place);
            return Err(error);
        }
        Ok(())
    }

    /// Forgets all edits at or after a time in s.
    pub fn truncate(&mut self, from_s: f64) {
        self.0.retain(|edit| edit.at_s < from_s);
    }

    fn check(&self, base: &Scenario) -> Result<(), SettingError> {
        let mut scenario = base.clone();
        for edit in &self.0 {
            scenario.set(&edit.path, edit.value.clone())?;
        }
        Ok(())
    }

    /// The scenario as it stands at a time in s, edits up to it applied.
    #[must_use]
    pub fn scenario_at(&self, base: &Scenario, time_s: f64) -> Scenario {
        let mut scenario = base.clone();
        for edit in self.0.iter().filter(|edit| edit.at_s <= time_s) {
            // Checked when it was added; an edit that no longer fits a changed base is skipped.
            let _ = scenario.set(&edit.path, edit.value.clone());
        }
        scenario
    }
}
