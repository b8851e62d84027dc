//! What a controller brings with it: all that the rest of the program knows of it.

use super::script::ScriptProblem;
use super::unks::Learning;
use super::{Belief, ControlInput, ControlOutput, ControlSetup, FeedSpeed, Limits, Running};
use crate::base::equation::Live;
use crate::base::settings::Group;
use crate::models::genetic::{GeneticModels, ModelSet};
use crate::models::printed::Printed;

/// A controller: its settings, its law, and its law in words. One file each; the controllers of the
/// feed override implement [`ForceLaw`](super::override_loop::ForceLaw) and have this from
/// [`ForceController`](super::override_loop::ForceController).
pub trait ControlLaw: Sized {
    /// Its settings, those under `controller.<id>`.
    type Settings: Group + Clone + std::fmt::Debug + Default + PartialEq;
    /// What it is, with its source, in a sentence.
    const ABOUT: &'static str;
    /// What it holds.
    const HELD: Held;
    /// Whether networks learn in it; [`Self::learning`] then shows them.
    const LEARNS: bool = false;
    /// Whether a control period of it takes memory: a script's does.
    const ALLOCATES: bool = false;

    /// The controller at the start of a run, the machine at rest at the programmed values.
    fn new(settings: &Self::Settings, setup: &ControlSetup, programmed: FeedSpeed) -> Self;

    /// The controller that takes over a running machine. One with a state does so without a bump of
    /// the feed; a static law has nothing to match, and the command goes where it says.
    fn take_over(settings: &Self::Settings, setup: &ControlSetup, running: &Running) -> Self {
        Self::new(settings, setup, running.actual)
    }

    /// Takes over changed settings and keeps its state.
    fn configure(&mut self, settings: &Self::Settings, setup: &ControlSetup);

    /// A new cut begins at the programmed values: what was learned stays, dynamic state goes.
    fn restart(&mut self, programmed: FeedSpeed);

    /// One control period. It allocates nothing where [`Self::ALLOCATES`] does not say so.
    fn update(&mut self, input: &ControlInput) -> ControlOutput;

    /// The limits that it keeps, of those that the overrides set. What adapts feed or speed to the
    /// force stays where the force model holds.
    #[must_use]
    fn limits(overrides: Limits) -> Limits {
        overrides.within_force_model()
    }

    /// What went wrong in it, if anything did: the run ends there.
    fn problem(&self) -> Option<&ScriptProblem> {
        None
    }

    /// Its networks that learn in the cut, for display.
    fn learning(&self) -> Option<Learning<'_>> {
        None
    }

    /// Where the force comes to rest in a cut that does not change.
    fn at_rest(settings: &Self::Settings) -> AtRest;

    /// Keys of the beliefs that it asks for, as it is set; its models it always has.
    #[must_use]
    fn believes(_: &Self::Settings) -> &'static [&'static str] {
        &[]
    }

    /// Keys of its own settings that have no part in it as the others stand.
    #[must_use]
    fn left_out(_: &Self::Settings) -> &'static [&'static str] {
        &[]
    }

    /// The law as its source prints it, without the models 2 and 3 of `set` that it may use.
    fn printed(settings: &Self::Settings, set: ModelSet) -> Vec<Printed>;

    /// The law with the values of a moment.
    fn explain(settings: &Self::Settings, moment: &ControlMoment) -> Explained;
}

/// What a controller holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Held {
    /// Feed and speed at what was chosen.
    Overrides,
    /// Ra: feed and speed come from the believed models 2 and 3.
    Roughness,
    /// The force, by the feed override alone and without models 2 and 3.
    Force,
}

/// Where the force comes to rest in a cut that does not change.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AtRest {
    /// On its reference, or the override is at a limit: the controller integrates.
    OnReference,
    /// Within a tenth of its reference: only learning brings it nearer.
    NearReference,
    /// Where the static law meets the plant.
    WhereTheLawMeetsThePlant,
    /// Nobody knows: a script can be any law.
    Unknown,
}

/// The control sample that a law is explained with.
#[derive(Clone, Copy, Debug)]
pub struct ControlMoment<'a> {
    /// Desired force F_d, N.
    pub force_ref_n: f64,
    /// Measured force F_m, N.
    pub force_measured_n: f64,
    /// The cut that the machine is in, counted from 0.
    pub cut: usize,
    /// The controller's estimate of true over modelled force.
    pub gain_estimate: f64,
    /// The command that was sent.
    pub command: FeedSpeed,
    /// The feed override that was sent, percent.
    pub feed_override_percent: f64,
    /// Programmed feed and speed of the present cut.
    pub programmed: FeedSpeed,
    /// Limits of the commands in it.
    pub limits: Limits,
    /// Whether models 2 and 3 were used within their ranges.
    pub models_valid: bool,
    /// The controller's models.
    pub models: &'a GeneticModels,
    /// The controller's beliefs.
    pub belief: &'a Belief,
}

/// A law with the values of a moment.
#[derive(Clone, Debug, PartialEq)]
pub struct Explained {
    /// The equations, in the order in which they are computed.
    pub lines: Vec<Live>,
    /// The force in N at which the believed models 2 and 3 then give feed and speed, where the law
    /// ends in them.
    pub models_at_n: Option<f64>,
    /// What stands beside the controller's name in its block of the diagram: the value that matters
    /// most; empty where none does.
    pub beside_name: String,
}
