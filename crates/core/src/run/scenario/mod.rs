//! A scenario: everything a run depends on besides its edits, checked.
//!
//! [`Settings`] are plain data, one field a group. A [`Scenario`] is settings whose values lie within
//! their ranges and meet the rules between them, together with what was expensive to check. Whoever
//! takes a scenario need not check anything again; it can be changed only through [`Scenario::set`],
//! [`Scenario::set_all`] and [`Scenario::change`], all of which check.

mod companions;
mod compared;
mod groups;
mod renamed;
mod rules;
mod table;
#[cfg(test)]
mod tests;
mod unused;

use std::ops::Deref;
use std::sync::Arc;

pub(super) use companions::companion;
pub use companions::{COMPANIONS, Companion};
pub use compared::{TwinKind, TwinSettings};
pub use groups::{Info, RunSettings, Settings};
pub use renamed::RENAMED;
pub(super) use rules::joins;
pub use rules::{MAX_ROWS, RULES, Rule};
pub(super) use table::is_group;
pub use table::{Param, param, parse_value, table};
pub use unused::{ANOTHER_CONTROLLER, BY_CURVES, LEFT_OUT, NOT_BELIEVED, UNUSED, Unused};

use crate::base::settings::{SettingError, Value};
use crate::models::structure::FiveMass;
use crate::models::structure::reduction::Reduction;
use crate::models::tip_modes::TipModes;
use rules::Candidate;
use table::{TABLE, index_of, refused};

/// Version of the scenario format, in files and links.
pub const FORMAT_VERSION: i64 = 1;

/// Checked settings; reads like [`Settings`]. See the head of this file.
#[derive(Clone, Debug, Default)]
pub struct Scenario {
    settings: Settings,
    /// The machine, where it is coupled to the cut: the default settings leave it out.
    machine: Option<Arc<CoupledMachine>>,
}

/// A machine and its reduction, which takes an eigenproblem.
#[derive(Debug)]
struct CoupledMachine {
    of: FiveMass,
    tip_modes: TipModes,
    reduction: Reduction,
}

impl Deref for Scenario {
    type Target = Settings;

    fn deref(&self) -> &Settings {
        &self.settings
    }
}

/// Equal settings are checked equally.
impl PartialEq for Scenario {
    fn eq(&self, other: &Self) -> bool {
        self.settings == other.settings
    }
}

impl TryFrom<Settings> for Scenario {
    type Error = SettingError;

    /// Checks settings.
    ///
    /// # Errors
    /// The first setting outside its range, or that does not fit another one.
    fn try_from(settings: Settings) -> Result<Self, SettingError> {
        let mut scenario = Self::default();
        scenario.take(settings)?;
        Ok(scenario)
    }
}

impl Scenario {
    /// Sets one setting; see [`Self::set_all`]. A long session replays thousands of edits, so this
    /// works in place.
    ///
    /// ```
    /// use steadycut_core::base::settings::Value;
    /// use steadycut_core::run::presets;
    ///
    /// let mut scenario = presets::load("table3-5").unwrap();
    /// scenario.set("belief.dead_time_s", Value::Float(0.16)).unwrap();
    /// assert_eq!(scenario.belief.dead_time_s, 0.16);
    ///
    /// let error = scenario.set("target.ra_um", Value::Float(-1.0)).unwrap_err().to_string();
    /// assert!(error.contains("target.ra_um") && error.contains("-1"), "{error}");
    /// assert_eq!(scenario.target.ra_um, 0.81, "a refused value changes nothing");
    /// ```
    ///
    /// # Errors
    /// As [`Self::set_all`].
    pub fn set(&mut self, path: &str, value: Value) -> Result<(), SettingError> {
        let param = param(path)?;
        if companion(&param.path).is_some() {
            return self.set_all(&[(path.to_owned(), value)]);
        }
        let before = self.settings.get_param(param);
        self.settings.set_param(param, &value).ok_or_else(|| refused(param, &value))?;
        match self.approve(&self.settings) {
            Ok(machine) => self.machine = machine,
            Err(error) => {
                self.settings.set_param(param, &before).expect("it was allowed before");
                return Err(error);
            }
        }
        Ok(())
    }

    /// Sets several settings, all or none. Choosing a cutter, a material, a feed drive, the plant's
    /// model set or its force tooth by tooth also sets its dimensions and run-out, its reference
    /// hardness, its published dead time or the controller's model set, unless that is among the
    /// changes.
    ///
    /// # Errors
    /// The first setting that is unknown, outside its range, of the wrong type, or that does not
    /// fit another one; the scenario is then unchanged.
    pub fn set_all(&mut self, changes: &[(String, Value)]) -> Result<(), SettingError> {
        let mut ordered = Vec::with_capacity(changes.len());
        for (path, value) in changes {
            ordered.push((index_of(path)?, value));
        }
        ordered.sort_by_key(|(index, _)| *index);
        let mut next = self.settings.clone();
        for (index, value) in ordered {
            let param = &TABLE[index];
            let before = next.get_param(param);
            next.set_param(param, value).ok_or_else(|| refused(param, value))?;
            if next.get_param(param) != before {
                next.set_companion(&param.path);
            }
        }
        self.machine = self.approve(&next)?;
        self.settings = next;
        Ok(())
    }

    /// Changes settings by their fields, all or none. Companions stay as they are.
    ///
    /// # Errors
    /// The first changed setting outside its range, or that does not fit another one; the scenario is
    /// then unchanged.
    pub fn change(&mut self, change: impl FnOnce(&mut Settings)) -> Result<(), SettingError> {
        let mut next = self.settings.clone();
        change(&mut next);
        self.take(next)
    }

    /// This scenario with settings changed by their fields; see [`Self::change`].
    ///
    /// # Errors
    /// As [`Self::change`].
    pub fn with(&self, change: impl FnOnce(&mut Settings)) -> Result<Self, SettingError> {
        let mut next = self.clone();
        next.change(change)?;
        Ok(next)
    }

    /// Takes over settings; those that differ have yet to be checked.
    fn take(&mut self, mut next: Settings) -> Result<(), SettingError> {
        for param in table() {
            let value = next.get_param(param);
            // What is not a number differs from itself.
            if value != self.settings.get_param(param) {
                next.set_param(param, &value).ok_or_else(|| refused(param, &value))?;
            }
        }
        self.machine = self.approve(&next)?;
        self.settings = next;
        Ok(())
    }

    /// Checks the rules between settings; gives what the running cut needs of the machine.
    fn approve(&self, next: &Settings) -> Result<Option<Arc<CoupledMachine>>, SettingError> {
        let machine = self.machine_for(next);
        Candidate { settings: next, overdamped: machine.is_err() }.check()?;
        machine
    }

    /// What the running cut needs of the machine; the eigenproblem is solved only for another machine
    /// than the present one.
    fn machine_for(&self, next: &Settings) -> Result<Option<Arc<CoupledMachine>>, SettingError> {
        if !next.machine.coupled {
            return Ok(None);
        }
        let of = FiveMass::new(&next.machine);
        let tip_modes = &next.machine.tip_modes;
        let alike = |known: &&Arc<CoupledMachine>| known.of == of && known.tip_modes == *tip_modes;
        if let Some(known) = self.machine.as_ref().filter(alike) {
            return Ok(Some(known.clone()));
        }
        let reduction = match tip_modes.is_empty() {
            true => Reduction::new(&of)?,
            false => Reduction::of_tip(tip_modes)?,
        };
        Ok(Some(Arc::new(CoupledMachine { of, tip_modes: tip_modes.clone(), reduction })))
    }

    /// The machine in the running cut, where `machine.coupled` is on.
    #[must_use]
    pub fn coupled_machine(&self) -> Option<&Reduction> {
        self.machine.as_ref().map(|machine| &machine.reduction)
    }

    /// Whether the setting at `path` takes this value, rules between settings aside.
    ///
    /// # Errors
    /// An unknown path, or a value outside its range.
    pub fn accepts(path: &str, value: &Value) -> Result<(), SettingError> {
        let param = param(path)?;
        Settings::default().set_param(param, value).ok_or_else(|| refused(param, value))
    }
}

impl Settings {
    /// The value at `path`.
    ///
    /// # Errors
    /// [`SettingError::Unknown`].
    pub fn get(&self, path: &str) -> Result<Value, SettingError> {
        Ok(self.get_param(param(path)?))
    }

    /// The settings that differ from `other`, with the values of these, in table order.
    #[must_use]
    pub fn difference(&self, other: &Self) -> Vec<(&'static Param, Value)> {
        let all = table().iter().map(|param| (param, self.get_param(param)));
        all.filter(|(param, value)| *value != other.get_param(param)).collect()
    }
}
