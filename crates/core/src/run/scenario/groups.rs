//! The groups of settings: everything a run depends on besides its edits, as plain data.

use super::compared::TwinSettings;
use super::table::Param;
use crate::base::settings::{Group, Spec, Value};
use crate::blocks::cnc::feed_drive::FeedDriveSettings;
use crate::blocks::cnc::feed_override::{Cnc, Program};
use crate::blocks::cnc::spindle_drive::SpindleDriveSettings;
use crate::blocks::control::{Belief, ControlSetup, ControllerSettings, FeedSpeed};
use crate::blocks::cutting::disturbance::NoiseSettings;
use crate::blocks::cutting::process::PlantSettings;
use crate::blocks::cutting::workpiece::Workpiece;
use crate::blocks::reference::Target;
use crate::models::disturbances::Disturbances;
use crate::models::economics::Economics;
use crate::models::genetic::{FormulaSettings, GeneticModels};
use crate::models::machine_trend::LifeSettings;
use crate::models::part::ProgrammedPart;
use crate::models::plan::PlanSettings;
use crate::models::roughness_profile::ProfileSettings;
use crate::models::structure::MachineSettings;
use crate::models::tool::Tool;
use crate::models::wear::WearSettings;

crate::settings! {
    /// What people read about a scenario.
    pub struct Info {
        /// Name of the scenario.
        name: String = "unnamed".to_owned(), [0.0, 80.0], "", setup, "Name";
        /// What it shows.
        description: String = String::new(), [0.0, 600.0], "", setup, "Description";
    }
}

crate::settings! {
    /// Time and randomness.
    pub struct RunSettings {
        /// The run ends after this time at the latest, or when the path is done.
        duration_s: f64 = 15.0, [0.1, 3600.0], "s", setup, "Time limit";
        /// Control period: sampling of the controller.
        control_period_ms: f64 = 20.0, [1.0, 100.0], "ms", setup, "Control period";
        /// Plant steps per control period: 20 give a plant step of 1 ms.
        steps_per_control: u32 = 20, [1.0, 1000.0], "", setup, "Plant steps per period";
        /// Every how many plant steps a row is recorded: a divisor of the steps per control period.
        record_every: u32 = 1, [1.0, 1000.0], "", setup, "Record every";
        /// Seed of all random streams.
        seed: u32 = 1, [0.0, 4_294_967_295.0], "", setup, "Seed";
    }
}

macro_rules! scenario {
    ($( $prefix:literal, $field:ident: $ty:ty; )+) => {
        /// Everything a run depends on besides its edits. Nothing takes it unchecked: it becomes a
        /// [`Scenario`](super::Scenario) by [`TryFrom`].
        #[derive(Clone, Debug, Default, PartialEq)]
        pub struct Settings {
            $( #[doc = concat!("Settings under `", $prefix, "`.")] pub $field: $ty, )+
        }

        pub(super) fn build_table() -> Vec<Param> {
            let mut table = Vec::new();
            $( for spec in <$ty as Group>::specs() {
                let path = if $prefix.is_empty() {
                    spec.key.to_owned()
                } else {
                    format!("{}.{}", $prefix, spec.key)
                };
                table.push(Param { path, group: $prefix, spec });
            }
            for (group, specs) in <$ty as Group>::parts() {
                let param = |spec: Spec| Param { path: format!("{group}.{}", spec.key), group, spec };
                table.extend(specs.into_iter().map(param));
            } )+
            table
        }

        impl Settings {
            pub(super) fn get_param(&self, param: &Param) -> Value {
                let found = match param.group {
                    $( $prefix => self.$field.get(param.spec.key), )+
                    path => {
                        let part = None$( .or_else(|| self.$field.part(path)) )+;
                        part.and_then(|part| part.get(param.spec.key))
                    }
                };
                found.expect("every table entry names a field of its group")
            }

            pub(super) fn set_param(&mut self, param: &Param, value: &Value) -> Option<()> {
                let Spec { key, allowed, .. } = &param.spec;
                match param.group {
                    $( $prefix => self.$field.set(key, value, allowed), )+
                    path => {
                        $( if let Some(part) = self.$field.part_mut(path) {
                            return part.set(key, value, allowed);
                        } )+
                        None
                    }
                }
            }
        }
    };
}

// The order is that of files, editors and `steadycut list`, and the order in which several
// changes are applied: what sets a companion (see `companion`) stands before it.
scenario! {
    "", info: Info;
    "target", target: Target;
    "tool", tool: Tool;
    "plant", plant: PlantSettings;
    "formula", formula: FormulaSettings;
    "noise", noise: NoiseSettings;
    "controller", controller: ControllerSettings;
    "belief", belief: Belief;
    "feed_drive", feed_drive: FeedDriveSettings;
    "spindle_drive", spindle_drive: SpindleDriveSettings;
    "cnc", cnc: Cnc;
    "program", program: Program;
    "plan", plan: PlanSettings;
    "workpiece", workpiece: Workpiece;
    "disturbances", disturbances: Disturbances;
    "economics", economics: Economics;
    "run", run: RunSettings;
    "machine", machine: MachineSettings;
    "wear", wear: WearSettings;
    "life", life: LifeSettings;
    "profile", profile: ProfileSettings;
    "twin", twin: TwinSettings;
}

impl Settings {
    /// Plant step in s.
    #[must_use]
    pub fn dt_s(&self) -> f64 {
        self.control_period_s() / f64::from(self.run.steps_per_control)
    }

    /// Control period in s.
    #[must_use]
    pub fn control_period_s(&self) -> f64 {
        crate::base::units::s_from_ms(self.run.control_period_ms)
    }

    /// A time in s as the nearest whole number of plant steps.
    #[must_use]
    pub fn ticks(&self, time_s: f64) -> u64 {
        (time_s / self.dt_s()).round() as u64
    }

    /// Programmed feed and speed of a cut, counted from 0.
    #[must_use]
    pub fn programmed(&self, cut: usize) -> FeedSpeed {
        // A path without cuts is programmed with one feed.
        let cut = if self.workpiece.cuts.is_empty() { usize::MAX } else { cut };
        FeedSpeed {
            feed_mm_min: self.program.feed_of_cut_mm_min(cut),
            speed_rpm: self.program.spindle_rpm,
        }
    }

    /// The models that the controller believes in, for the cutter.
    #[must_use]
    pub fn believed(&self) -> GeneticModels {
        let Belief { model_set, calibration, .. } = self.belief;
        GeneticModels::with_formulas(model_set, calibration, &self.formula).for_tool(&self.tool)
    }

    /// The models of what really is cut, for the cutter.
    #[must_use]
    pub fn of_plant(&self) -> GeneticModels {
        let PlantSettings { model_set, calibration, .. } = self.plant;
        GeneticModels::with_formulas(model_set, calibration, &self.formula).for_tool(&self.tool)
    }

    /// What the controller is set up from.
    #[must_use]
    pub fn control_setup(&self) -> ControlSetup<'_> {
        ControlSetup {
            settings: &self.controller,
            part: ProgrammedPart {
                cuts: &self.workpiece.cuts,
                axial_depth_mm: self.workpiece.axial_depth_mm,
                radial_depth_mm: self.workpiece.radial_depth_mm,
                depth_steps: &self.workpiece.depth_steps,
                radial_steps: &self.workpiece.radial_steps,
            },
            tool: &self.tool,
            belief: &self.belief,
            period_s: self.control_period_s(),
        }
    }
}
