//! Which command and which screen uses which setting, and why another does not: nothing that is given
//! is dropped in silence. `steadycut list --uses` prints it; the commands refuse by it, the screens grey by
//! it, and tests hold it against what commands print.
//!
//! What a run leaves out, and while which other setting stands how, is the run's own
//! ([`UNUSED`]); here stands what the commands read besides or instead.

mod reads;
mod screens;

pub use screens::{LEARNING_OFFERS, PLAN_OFFERS, Screen};

use crate::base::language::tr;
use crate::base::settings::SettingError;
use crate::blocks::control::ControllerKind;
use crate::run::edits::Edits;
use crate::run::scenario::{
    ANOTHER_CONTROLLER, LEFT_OUT, NOT_BELIEVED, Param, Scenario, UNUSED, Unused, param,
};

steadycut_core::choice! {
    /// A command that is given settings.
    pub enum Reader {
        /// A run: its metrics and signals.
        Run = "run", "run";
        /// A run, and the same cut at constant feed beside it.
        RunTwin = "run_twin", "run --twin";
        /// A run, and its machined surface along a line.
        RunProfile = "run_profile", "run --profile";
        /// A run, and its forces within a revolution.
        RunRevolution = "run_revolution", "run --revolution";
        /// Many runs with plant and belief drawn at random.
        Robust = "robust", "robust";
        /// The plan of an experiment's cuts.
        Experiment = "experiment", "experiment";
        /// The cuts of an experiment on the simulator.
        ExperimentRun = "experiment_run", "experiment --run";
        /// Passes over the same part with UNKS.
        Unks = "unks", "unks";
        /// The five steps of the combined system.
        Combine = "combine", "combine";
        /// The off-line plan of one cut.
        Plan = "plan", "plan";
        /// The off-line plan of the feed of every cut.
        PlanPerCut = "plan_per_cut", "plan --per-cut";
        /// Modes of the machine.
        MachineModes = "machine_modes", "machine modes";
        /// Its frequency response.
        MachineFrf = "machine_frf", "machine frf";
        /// Its stability chart.
        MachineStability = "machine_stability", "machine stability";
        /// Trends over the tool's life.
        MachineWear = "machine_wear", "machine wear";
        /// Tool life predicted from the sound.
        MachineLife = "machine_life", "machine life";
        /// What vibration says about Ra.
        MachineRoughness = "machine_roughness", "machine roughness";
    }
}

/// What a command does with a setting.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SettingUse {
    /// It reads it, unless one of these reasons holds.
    Used {
        /// Reasons not to.
        unless: Vec<&'static str>,
    },
    /// It never reads it.
    Refused {
        /// Why.
        because: String,
    },
}

/// Whether a list of paths and groups names a path.
fn named(list: &[&str], path: &str) -> bool {
    list.iter().any(|one| path == *one || (one.ends_with('.') && path.starts_with(*one)))
}

impl Reader {
    /// What it does with a setting, whatever the others are.
    #[must_use]
    pub fn uses(self, Param { path, group, .. }: &Param) -> SettingUse {
        let reads = self.reads();
        let refused = |because: &str| SettingUse::Refused { because: because.to_owned() };
        if let Some((_, because)) = reads.but.iter().find(|(paths, _)| named(paths, path)) {
            return refused(because);
        }
        let also = named(reads.also, path);
        if !also && !reads.as_run {
            return SettingUse::Refused { because: self.only(reads.also) };
        }
        let about = |rows: &'static [Unused]| rows.iter().filter(|row| row.names(path));
        let mut unless: Vec<&'static str> = about(reads.unused).map(|row| row.because).collect();
        if !also {
            if let Some(row) = about(UNUSED).find(|row| row.when.is_none()) {
                return refused(row.because);
            }
            unless.extend(about(UNUSED).map(|row| row.because));
            let models = ["belief.model_set", "belief.calibration"].contains(&path.as_str());
            if group.starts_with("controller.") {
                if self.kind().is_some_and(|kind| kind.group() != *group) {
                    return refused(ANOTHER_CONTROLLER);
                }
                unless.extend([ANOTHER_CONTROLLER, LEFT_OUT]);
            } else if *group == "belief" && !models {
                unless.push(NOT_BELIEVED);
            }
        }
        SettingUse::Used { unless }
    }

    /// Why it has no use for the setting at `path` in this scenario; none where it reads it.
    ///
    /// # Errors
    /// [`SettingError::Unknown`]; a controller that does not go with the scenario.
    pub fn unused(self, scenario: &Scenario, path: &str) -> Result<Option<String>, SettingError> {
        let param = param(path)?;
        let path = param.path.as_str();
        if let SettingUse::Refused { because } = self.uses(param) {
            return Ok(Some(because));
        }
        let reads = self.reads();
        let row = reads.unused.iter().find(|row| row.names(path) && row.holds(scenario));
        if let Some(row) = row {
            return Ok(Some(row.because.to_owned()));
        }
        if named(reads.also, path) {
            return Ok(None);
        }
        let unused = match self.kind() {
            Some(kind) if kind != scenario.controller.kind => {
                scenario.with(|settings| settings.controller.kind = kind)?.unused(path)?
            }
            _ => scenario.unused(path)?,
        };
        Ok(unused.map(str::to_owned))
    }

    /// The same over a run with edits: used is what is used before or after any of them.
    ///
    /// # Errors
    /// As [`Self::unused`]; an edit that does not fit.
    pub fn unused_throughout(
        self,
        scenario: &Scenario,
        edits: &Edits,
        path: &str,
    ) -> Result<Option<String>, SettingError> {
        let mut now = scenario.clone();
        let mut why = self.unused(&now, path)?;
        for edit in edits.list() {
            if why.is_none() {
                break;
            }
            now.set(&edit.path, edit.value.clone())?;
            if self.unused(&now, path)?.is_none() {
                why = None;
            }
        }
        Ok(why)
    }

    /// The controller that it always takes.
    fn kind(self) -> Option<ControllerKind> {
        match self {
            Self::Unks | Self::Combine => Some(ControllerKind::Unks),
            Self::Run
            | Self::RunTwin
            | Self::RunProfile
            | Self::RunRevolution
            | Self::Robust
            | Self::Experiment
            | Self::ExperimentRun
            | Self::Plan
            | Self::PlanPerCut
            | Self::MachineModes
            | Self::MachineFrf
            | Self::MachineStability
            | Self::MachineWear
            | Self::MachineLife
            | Self::MachineRoughness => None,
        }
    }

    fn only(self, reads: &[&str]) -> String {
        let list: Vec<String> = reads
            .iter()
            .map(|one| if one.ends_with('.') { format!("{one}*") } else { (*one).to_owned() })
            .collect();
        tr!("it reads {list}", list = list.join(", "))
    }
}
