//! The figures of each kind of event: what its sentence is made of, as fields.

use serde::Serialize;

use super::changes::Cause;
use super::means::StretchMeans;
use super::oscillation::Oscillation;
use super::response::StepResponse;
use super::verdict::CutVerdict;

/// A change and what it does, measured in the run and in the constant-feed twin.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ChangeEffect {
    /// What changes.
    pub causes: Vec<Cause>,
    /// The run at the end of the stretch before; at the start, its first row.
    pub before: Option<StretchMeans>,
    /// The run at the end of the stretch after.
    pub after: Option<StretchMeans>,
    /// The twin on the same place before.
    pub twin_before: Option<StretchMeans>,
    /// The twin on the same place after.
    pub twin_after: Option<StretchMeans>,
    /// How the loop answers.
    pub response: Option<StepResponse>,
    /// How far what is judged was out of the tolerance on the way; none where it never was.
    pub excursion: Option<Excursion>,
}

/// What is judged, out of its tolerance for a while: the ends of a stretch do not tell of it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Excursion {
    /// Time outside in all, s.
    pub outside_s: f64,
    /// The value furthest from its target: Ra in um, or the force in N.
    pub furthest: f64,
}

/// The first answer to a change.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct FirstAnswer {
    /// Time until the controller's command leaves what it was in the second before, s.
    pub command_after_s: f64,
    /// Time until the feed does, s.
    pub feed_after_s: f64,
    /// Dead time of the CNC, s.
    pub dead_time_s: f64,
    /// Furthest deviation of what is to be held until then, percent.
    pub deviation_percent: Option<f64>,
}

/// What a limit holds back.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum LimitedCommand {
    /// The feed.
    Feed,
    /// The spindle speed.
    SpindleSpeed,
}

/// A command at a limit.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct LimitReached {
    /// Which command.
    pub command: LimitedCommand,
    /// Whether it is the upper limit.
    pub upper: bool,
    /// The command there, mm/min or 1/min.
    pub value: f64,
    /// The same in percent of what is programmed.
    pub override_percent: f64,
    /// Fraction of the time from begin to end at which it stands there, percent.
    pub share_percent: f64,
    /// Mean deviation of what is to be held meanwhile, percent.
    pub deviation_percent: Option<f64>,
    /// Whether that lies within the tolerance.
    pub in_tolerance: Option<bool>,
    /// Mean deviation of Ra with dynamics from the target Ra meanwhile, percent.
    pub deviation_dyn_percent: Option<f64>,
    /// Whether that lies within the tolerance.
    pub in_tolerance_dyn: Option<bool>,
}

/// A model used outside its range.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RangeLeft {
    /// The model's name.
    pub model: String,
    /// Its number, 1 to 6.
    #[serde(skip)]
    pub number: u32,
    /// What it gives, in plain words.
    pub gives: &'static str,
    /// The input that is outside; none where the model belongs to another cutter or cannot say.
    pub input: Option<RangedInput>,
    /// Fraction of the time from begin to end at which it is outside, percent.
    pub share_percent: f64,
}

/// What a model is asked with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum ModelInput {
    /// The target roughness.
    #[serde(rename = "target Ra")]
    TargetRa,
    /// The force setpoint of the controller.
    #[serde(rename = "force asked for")]
    ForceAskedFor,
    /// The actual feed.
    #[serde(rename = "feed")]
    Feed,
    /// The actual spindle speed.
    #[serde(rename = "spindle speed")]
    SpindleSpeed,
    /// The cutting force.
    #[serde(rename = "force")]
    Force,
    /// The cutting force with its dynamic component.
    #[serde(rename = "force with dynamics")]
    ForceWithDynamics,
}

/// An input, the value furthest outside, and its range; an end that there is not is infinite.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct RangedInput {
    /// What it is.
    pub name: ModelInput,
    /// Its unit.
    pub unit: &'static str,
    /// Its value furthest outside.
    pub value: f64,
    /// Its range.
    pub range: [f64; 2],
}

/// Why chatter ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum ChatterEnd {
    /// The depth of cut changes there.
    Depth,
    /// The tool leaves the material.
    Air,
    /// By itself, or by what feed and speed have become.
    Itself,
    /// It goes on to the end of the run.
    GoesOn,
    /// It goes on where the playhead stands; what comes is not known.
    SoFar,
}

/// Chatter: a tooth that jumps out of the cut, or vibration that grows or stays from tooth to tooth.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Chatter {
    /// Depth of cut where it begins, mm.
    pub axial_depth_mm: f64,
    /// Greatest depth of cut meanwhile, mm.
    pub deepest_mm: f64,
    /// Spindle speed where it begins, 1/min.
    pub spindle_rpm: f64,
    /// Largest force with vibration, N.
    pub largest_force_n: f64,
    /// Mean force without vibration, N.
    pub mean_force_n: f64,
    /// Whether teeth jump out of the cut.
    pub loses_contact: bool,
    /// Amplitude of what differs from tooth to tooth, at most meanwhile, um.
    pub from_tooth_to_tooth_um: f64,
    /// Mean Ra with and without dynamics, um; none where their models have ended on more than half of it.
    pub ra_um: Option<[f64; 2]>,
    /// Why it ends.
    pub ends: ChatterEnd,
}

/// Wear over the run.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct WearEffect {
    /// Fraction of the tool's life used at the start, percent.
    pub used_from_percent: f64,
    /// The same at the end.
    pub used_to_percent: f64,
    /// The run in its first stretch at rest; none where other things changed since.
    pub before: Option<StretchMeans>,
    /// The run at its end.
    pub after: Option<StretchMeans>,
    /// The twin as far along the way as `before`.
    pub twin_before: Option<StretchMeans>,
    /// The twin as far along the way as `after`.
    pub twin_after: Option<StretchMeans>,
}

/// A limit cycle with the dead time that goes with it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct LimitCycle {
    /// Period and amplitudes.
    #[serde(flatten)]
    pub oscillation: Oscillation,
    /// Dead time of the CNC, s.
    pub dead_time_s: f64,
}

/// How far the way is done at the end, and what the cut comes to.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct WayDone {
    /// Length of path done, mm.
    pub path_mm: f64,
    /// Length of the whole path, mm.
    pub of_mm: f64,
    /// What the cut comes to.
    pub verdict: CutVerdict,
}

/// The tool in the air.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct AirCut {
    /// Length of path in the air, mm.
    pub length_mm: f64,
    /// Feed at the end, mm/min.
    pub feed_mm_min: f64,
}

/// What an event is, with its figures.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Figures {
    /// Of a start, contact, depth step, change of target or setting.
    Change(Box<ChangeEffect>),
    /// Of the tool in the air.
    Air(AirCut),
    /// Of the first answer to a change.
    Answer(FirstAnswer),
    /// Of a saturation.
    Limit(LimitReached),
    /// Of a model outside its range.
    Outside(RangeLeft),
    /// Of chatter.
    Chatter(Chatter),
    /// Of the wear.
    Wear(Box<WearEffect>),
    /// Of a limit cycle.
    LimitCycle(LimitCycle),
    /// Of the end.
    End(WayDone),
}
