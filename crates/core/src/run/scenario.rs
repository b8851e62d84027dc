//! A scenario: everything a run depends on besides its edits, as settings groups with one table.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use crate::base::settings::{Group, Kind, SettingError, Spec, Value};
use crate::blocks::cnc::feed_drive::FeedDriveSettings;
use crate::blocks::cnc::feed_override::{Cnc, Program};
use crate::blocks::cnc::spindle_drive::SpindleDriveSettings;
use crate::blocks::control::adjustable_pi::AdjustablePiSettings;
use crate::blocks::control::constant_feed::ConstantFeedSettings;
use crate::blocks::control::division::DivisionSettings;
use crate::blocks::control::mrac::MracSettings;
use crate::blocks::control::preview::PreviewSettings;
use crate::blocks::control::proportional::ProportionalSettings;
use crate::blocks::control::sdnrp::SdnrpSettings;
use crate::blocks::control::tracking::TrackingSettings;
use crate::blocks::control::unks::UnksSettings;
use crate::blocks::control::{Belief, ControlSetup, ControllerChoice, FeedSpeed};
use crate::blocks::cutting::disturbance::NoiseSettings;
use crate::blocks::cutting::process::Plant;
use crate::blocks::cutting::workpiece::Workpiece;
use crate::blocks::reference::Target;
use crate::models::genetic::ModelSet;
use crate::models::machine_trend::LifeSettings;
use crate::models::part::ProgrammedPart;
use crate::models::plan::PlanSettings;
use crate::models::roughness_profile::ProfileSettings;
use crate::models::structure::FiveMass;
use crate::models::structure::MachineSettings;
use crate::models::structure::reduction::Reduction;
use crate::models::unks::Stored;
use crate::models::wear::WearSettings;

/// Version of the scenario format, in files and links.
pub const FORMAT_VERSION: i64 = 1;
/// Most rows that a run may record: a row takes 184 bytes, a console holds up to four recordings,
/// and a page in the browser has 4 GiB at most.
pub const MAX_ROWS: f64 = if cfg!(target_arch = "wasm32") { 1_000_000.0 } else { 4_000_000.0 };

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
        /// Everything a run depends on besides its edits.
        #[derive(Clone, Debug, Default, PartialEq)]
        pub struct Scenario {
            $( #[doc = concat!("Settings under `", $prefix, "`.")] pub $field: $ty, )+
        }

        fn build_table() -> Vec<Param> {
            let mut table = Vec::new();
            $( for spec in <$ty as Group>::specs() {
                let path = if $prefix.is_empty() {
                    spec.key.to_owned()
                } else {
                    format!("{}.{}", $prefix, spec.key)
                };
                table.push(Param { path, group: $prefix, spec });
            } )+
            table
        }

        impl Scenario {
            fn get_param(&self, param: &Param) -> Value {
                let found = match param.group {
                    $( $prefix => self.$field.get(param.spec.key), )+
                    _ => None,
                };
                found.expect("every table entry names a field of its group")
            }

            fn set_param(&mut self, param: &Param, value: &Value) -> Option<()> {
                match param.group {
                    $( $prefix => self.$field.set(param.spec.key, value, &param.spec.allowed), )+
                    _ => None,
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
    "plant", plant: Plant;
    "noise", noise: NoiseSettings;
    "controller", controller: ControllerChoice;
    "controller.constant_feed", constant_feed: ConstantFeedSettings;
    "controller.sdnrp", sdnrp: SdnrpSettings;
    "controller.tracking", tracking: TrackingSettings;
    "controller.division", division: DivisionSettings;
    "controller.p", proportional: ProportionalSettings;
    "controller.adjustable_pi", adjustable_pi: AdjustablePiSettings;
    "controller.mrac", mrac: MracSettings;
    "controller.unks", unks: UnksSettings;
    "controller.preview", preview: PreviewSettings;
    "belief", belief: Belief;
    "feed_drive", feed_drive: FeedDriveSettings;
    "spindle_drive", spindle_drive: SpindleDriveSettings;
    "cnc", cnc: Cnc;
    "program", program: Program;
    "plan", plan: PlanSettings;
    "workpiece", workpiece: Workpiece;
    "run", run: RunSettings;
    "machine", machine: MachineSettings;
    "wear", wear: WearSettings;
    "life", life: LifeSettings;
    "profile", profile: ProfileSettings;
}

/// One entry of the table of settings.
#[derive(Clone, Debug)]
pub struct Param {
    /// Full path, for example `controller.sdnrp.kp`.
    pub path: String,
    /// Path of its group, for example `controller.sdnrp`; empty for the top level.
    pub group: &'static str,
    /// Label, unit, range, default, documentation.
    pub spec: Spec,
}

static TABLE: LazyLock<Vec<Param>> = LazyLock::new(build_table);
static INDEX: LazyLock<BTreeMap<&'static str, usize>> =
    LazyLock::new(|| TABLE.iter().enumerate().map(|(i, param)| (param.path.as_str(), i)).collect());

/// All settings, in order.
#[must_use]
pub fn table() -> &'static [Param] {
    &TABLE
}

fn index_of(path: &str) -> Result<usize, SettingError> {
    INDEX.get(path).copied().ok_or_else(|| {
        // A long or binary path is cut: the message must stay readable, and the search short.
        let path: String = path.chars().take(80).collect();
        let near = TABLE
            .iter()
            .map(|param| (strsim::jaro_winkler(&path, &param.path), &param.path))
            .max_by(|a, b| a.0.total_cmp(&b.0))
            .filter(|(likeness, _)| *likeness > 0.8);
        SettingError::Unknown { path, suggestion: near.map(|(_, path)| path.clone()) }
    })
}

/// The table entry of a path.
///
/// # Errors
/// [`SettingError::Unknown`] with the nearest known path.
pub fn param(path: &str) -> Result<&'static Param, SettingError> {
    index_of(path).map(|i| &TABLE[i])
}

/// Settings that bring a companion with them.
pub(super) const COMPANIONED: [&str; 4] =
    ["plant.model_set", "plant.force_model", "plant.material", "feed_drive.kind"];
/// Their companions, in the same order.
pub(super) const COMPANIONS: [&str; 4] =
    ["belief.model_set", "belief.model_set", "plant.hardness_hb", "cnc.dead_time_s"];

fn refused(param: &Param, value: &Value) -> SettingError {
    let text = match value {
        Value::Text(text) if param.spec.allowed == Kind::Networks => {
            Stored::parse(text).err().unwrap_or_default()
        }
        Value::Text(text) => format!("{:?}", text.chars().take(60).collect::<String>()),
        // Written out, 1e300 would be cut to another number.
        Value::Float(x) if x.abs() >= 1e15 => format!("{x:e}"),
        other => {
            let unit = param.spec.unit;
            let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
            format!("{}{unit}", other.to_string().chars().take(60).collect::<String>())
        }
    };
    let allowed = param.spec.allowed.allowed(param.spec.unit);
    SettingError::Refused { path: param.path.clone(), value: text, allowed }
}

impl Scenario {
    /// The value at `path`.
    ///
    /// # Errors
    /// [`SettingError::Unknown`].
    pub fn get(&self, path: &str) -> Result<Value, SettingError> {
        Ok(self.get_param(param(path)?))
    }

    /// Sets one setting; see [`Self::set_all`]. A long session replays thousands of edits, so this
    /// works in place.
    ///
    /// # Errors
    /// As [`Self::set_all`].
    pub fn set(&mut self, path: &str, value: Value) -> Result<(), SettingError> {
        let param = param(path)?;
        if COMPANIONED.contains(&path) {
            return self.set_all(&[(path.to_owned(), value)]);
        }
        let before = self.get_param(param);
        self.set_param(param, &value).ok_or_else(|| refused(param, &value))?;
        self.check().inspect_err(|_| {
            self.set_param(param, &before).expect("it was allowed before");
        })
    }

    /// Sets several settings, all or none. Choosing a material, a feed drive, the plant's model set
    /// or its force tooth by tooth also sets its reference hardness, its published dead time or the
    /// controller's model set, unless that is among the changes.
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
        let mut next = self.clone();
        for (index, value) in ordered {
            let param = &TABLE[index];
            let before = next.get_param(param);
            next.set_param(param, value).ok_or_else(|| refused(param, value))?;
            if next.get_param(param) != before {
                next.set_companion(&param.path);
            }
        }
        next.check()?;
        *self = next;
        Ok(())
    }

    /// This scenario's choices, all else at its default, companions included: what a link leaves
    /// out.
    pub(super) fn default_for_choices(&self) -> Self {
        let mut base = Self::default();
        for path in COMPANIONED {
            let param = param(path).expect("a known path");
            let value = self.get_param(param);
            if base.get_param(param) != value {
                // Rules between settings do not matter to a base.
                base.set_param(param, &value).expect("it is allowed here, so it is there");
                base.set_companion(path);
            }
        }
        base
    }

    /// A material comes with its hardness, a feed drive with its published dead time, a model set
    /// with the controller that was built for it.
    fn set_companion(&mut self, path: &str) {
        match path {
            "plant.model_set" => self.belief.model_set = self.plant.model_set,
            // The papers' formulas know nothing of the milling simulator's cut.
            "plant.force_model" => match self.plant.force_model.identified_set() {
                Some(set) => self.belief.model_set = set,
                None if self.belief.model_set == ModelSet::Milling2005 => {
                    self.belief.model_set = self.plant.model_set;
                }
                None => {}
            },
            "plant.material" => self.plant.hardness_hb = self.plant.material.hardness_hb(),
            "feed_drive.kind" => {
                self.cnc.dead_time_s = self.feed_drive.kind.published_dead_time_s();
            }
            _ => {}
        }
    }

    /// Rules between settings.
    fn check(&self) -> Result<(), SettingError> {
        let longest_s = self.plant.force_model.longest_step_s();
        if self.dt_s() > longest_s {
            let steps = (self.control_period_s() / longest_s).ceil();
            return Err(SettingError::Refused {
                path: "plant.force_model".to_owned(),
                value: format!(
                    "{} with plant steps of {} s",
                    self.plant.force_model.id(),
                    self.dt_s()
                ),
                allowed: format!(
                    "plant steps of at most {longest_s} s: `run.steps_per_control` from \
                     {steps} on (576 give 28.8 kHz)"
                ),
            });
        }
        if self.machine.coupled && Reduction::new(&FiveMass::new(&self.machine)).is_err() {
            return Err(SettingError::Refused {
                path: "machine.parameters".to_owned(),
                value: format!(
                    "{} with `machine.coupled` = true (overdamped modes)",
                    self.machine.parameters.id()
                ),
                allowed: "D or T in a coupled run".to_owned(),
            });
        }
        if self.wear.adjust_speed && !self.machine.coupled {
            return Err(SettingError::Refused {
                path: "wear.adjust_speed".to_owned(),
                value: "true without the machine's sound".to_owned(),
                allowed: "true with `machine.coupled` = true".to_owned(),
            });
        }
        if let Some(stored) = self.unks.networks.get()
            && stored.start != self.unks.start
        {
            return Err(SettingError::Refused {
                path: "controller.unks.networks".to_owned(),
                value: format!("networks of the start `{}`", stored.start.id()),
                allowed: format!(
                    "networks of `controller.unks.start`, {}, or none; set both together",
                    self.unks.start.id()
                ),
            });
        }
        let refuse = |path: &str, value: f64, unit: &str, allowed: String| {
            let value = format!("{value}{unit}");
            Err(SettingError::Refused { path: path.to_owned(), value, allowed })
        };
        if self.noise.band_low_hz >= self.noise.band_high_hz {
            let high = self.noise.band_high_hz;
            let allowed = format!("below `noise.band_high_hz`, {high} Hz");
            return refuse("noise.band_low_hz", self.noise.band_low_hz, " Hz", allowed);
        }
        let RunSettings { record_every, steps_per_control, .. } = self.run;
        if !steps_per_control.is_multiple_of(record_every) {
            let allowed = format!(
                "a divisor of `run.steps_per_control`, {steps_per_control}: every control sample \
                 is recorded"
            );
            return refuse("run.record_every", f64::from(record_every), "", allowed);
        }
        let row_s = self.dt_s() * f64::from(self.run.record_every);
        if self.run.duration_s / row_s > MAX_ROWS {
            let longest = MAX_ROWS * row_s;
            let allowed = format!(
                "at most {longest} s with a row every {row_s} s ({MAX_ROWS} rows); record less \
                 often with `run.record_every`"
            );
            return refuse("run.duration_s", self.run.duration_s, " s", allowed);
        }
        Ok(())
    }

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

    /// What the controller is set up from.
    #[must_use]
    pub fn control_setup(&self) -> ControlSetup<'_> {
        ControlSetup {
            kind: self.controller.kind,
            constant_feed: &self.constant_feed,
            sdnrp: &self.sdnrp,
            tracking: &self.tracking,
            division: &self.division,
            proportional: &self.proportional,
            adjustable_pi: &self.adjustable_pi,
            mrac: &self.mrac,
            unks: &self.unks,
            preview: &self.preview,
            part: ProgrammedPart {
                cuts: &self.workpiece.cuts,
                axial_depth_mm: self.workpiece.axial_depth_mm,
                radial_depth_mm: self.workpiece.radial_depth_mm,
                depth_steps: &self.workpiece.depth_steps,
            },
            belief: &self.belief,
            period_s: self.control_period_s(),
        }
    }

    /// Whether the setting at `path` takes this value, rules between settings aside.
    ///
    /// # Errors
    /// An unknown path, or a value outside its range.
    pub fn accepts(path: &str, value: &Value) -> Result<(), SettingError> {
        let param = param(path)?;
        Self::default().set_param(param, value).ok_or_else(|| refused(param, value))
    }

    /// The settings that differ from `other`, with this scenario's values, in table order.
    #[must_use]
    pub fn difference(&self, other: &Self) -> Vec<(&'static Param, Value)> {
        let all = TABLE.iter().map(|param| (param, self.get_param(param)));
        all.filter(|(param, value)| *value != other.get_param(param)).collect()
    }
}

/// Reads the text of a value as the setting at `path` expects it (command line, link).
///
/// # Errors
/// An unknown path, or text that is no value of the setting's type.
pub fn parse_value(path: &str, text: &str) -> Result<Value, SettingError> {
    let param = param(path)?;
    if let Kind::Text { .. } | Kind::Networks = param.spec.allowed {
        return Ok(Value::Text(text.to_owned()));
    }
    let text = text.trim();
    let bad = || refused(param, &Value::Text(text.to_owned()));
    Ok(match &param.spec.allowed {
        Kind::Float { .. } => Value::Float(text.parse().map_err(|_| bad())?),
        Kind::Int { .. } => Value::Int(text.parse().map_err(|_| bad())?),
        Kind::Bool => Value::Bool(text.parse().map_err(|_| bad())?),
        Kind::Choice { .. } | Kind::Text { .. } | Kind::Networks => Value::Text(text.to_owned()),
        Kind::Steps { .. } => {
            let steps: Vec<[f64; 2]> = serde_json::from_str(text).map_err(|_| bad())?;
            Value::Steps(steps)
        }
        Kind::Cuts { .. } => Value::Cuts(serde_json::from_str(text).map_err(|_| bad())?),
        Kind::Numbers { .. } => Value::Numbers(serde_json::from_str(text).map_err(|_| bad())?),
    })
}
