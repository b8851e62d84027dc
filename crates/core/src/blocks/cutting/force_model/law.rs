//! What a force model brings with it: all that the rest of the program knows of it.

use crate::base::equation::Live;
use crate::blocks::cutting::process::{CutStep, Force, PlantSettings};
use crate::blocks::cutting::tool_path::Engagement;
use crate::models::Valued;
use crate::models::genetic::{FormulaSettings, ModelSet};
use crate::models::mechanistic::Cutting;
use crate::models::neural_force::NeuralKind;
use crate::models::printed::Printed;
use crate::models::tool::Tool;

/// A plant with its tool on its way, as a force model is set up from it.
#[derive(Clone, Copy, Debug)]
pub struct ForceSetup<'a> {
    /// The plant.
    pub plant: &'a PlantSettings,
    /// Own formulas of the plant's models.
    pub formulas: &'a FormulaSettings,
    /// The tool.
    pub tool: &'a Tool,
    /// Radial depth of the path, mm.
    pub radial_depth_mm: f64,
    /// Whether the path goes through several cuts, with air between them.
    pub several: bool,
    /// Largest axial depth of the part, mm.
    pub depth_max_mm: f64,
    /// Plant step, s.
    pub dt_s: f64,
    /// Plant steps of a control period.
    pub window: u64,
}

/// A moment of a cut that a force model is explained with.
#[derive(Clone, Copy, Debug)]
pub struct ForceMoment<'a> {
    /// The plant.
    pub plant: &'a PlantSettings,
    /// Own formulas of the plant's models.
    pub formulas: &'a FormulaSettings,
    /// The tool.
    pub tool: &'a Tool,
    /// Actual feed, mm/min.
    pub feed_mm_min: f64,
    /// Actual speed, 1/min.
    pub speed_rpm: f64,
    /// Engagement at the tool's axis.
    pub place: Engagement,
    /// The force of the row, N.
    pub force_n: f64,
    /// The same with vibration and dynamic component, N.
    pub force_dyn_n: f64,
}

/// A force model. One file each; those that are a function of feed, speed and engagement implement
/// [`MapLaw`](super::map::MapLaw) and have this from [`Mapped`](super::map::Mapped).
pub trait ForceModelLaw: Clone + std::fmt::Debug {
    /// What it is, with its source, in a sentence or two.
    const ABOUT: &'static str;
    /// Whether the force is a function of feed, speed and engagement that gives the largest force of a
    /// revolution at once; otherwise it is simulated instant by instant, with the teeth that make it.
    const MAP: bool;
    /// Longest plant step in s with which the force can be simulated.
    const LONGEST_STEP_S: f64 = f64::INFINITY;
    /// The model set that was identified on this very force; none where the controller's models are
    /// those of the plant's own set.
    const IDENTIFIED_SET: Option<ModelSet> = None;
    /// The network, where it is one.
    const NETWORK: Option<NeuralKind> = None;
    /// Whether it is the formula of a published model set, which the tables of the papers were made with.
    const FORMULA: bool = false;

    /// The force at the start of a run.
    fn new(setup: &ForceSetup) -> Self;

    /// The force of a plant step, before any machine vibrates. It allocates nothing. `dynamic` gives the factor of
    /// the dynamic component; every step asks for it once, also without a chip, since its sources go on.
    fn cut(&mut self, step: &CutStep, dynamic: impl FnOnce() -> f64) -> Force;

    /// So many teeth are broken from now on, the first ones, fewer than there are; gives the factor by which the
    /// force of a step grows for a model that does not simulate the teeth.
    fn break_teeth(&mut self, broken: usize) -> f64;

    /// Goes on where the same model stood before its settings were changed in the cut.
    fn take_over(&mut self, _before: &Self) {}

    /// Takes the model's own compliance away: a machine that is coupled to the cut has its own, and counted
    /// twice the tool would be too soft.
    fn make_rigid(&mut self) {}

    /// A new cut begins.
    fn restart(&mut self) {}

    /// What the teeth do at the last instant, where there are teeth.
    #[inline]
    fn teeth(&self) -> Option<&Cutting> {
        None
    }

    /// The same, for a machine that shakes them.
    #[inline]
    fn teeth_mut(&mut self) -> Option<&mut Cutting> {
        None
    }

    /// The spindle's turn at the last instant, from 0 to below 1, where there are teeth.
    fn spindle_turn(&self) -> Option<f64> {
        None
    }

    /// Of a map, the force in N at feed in mm/min, speed in 1/min and an engagement.
    #[must_use]
    fn at(_: &ForceSetup, _: f64, _: f64, _: &Engagement) -> Option<Valued> {
        None
    }

    /// What it is called beside K1..K6 or M1..M6, where the formula is that of `set`.
    #[must_use]
    fn short_name(set: ModelSet) -> String;

    /// Its equations as their sources print them, where the formula is that of `set`.
    #[must_use]
    fn printed(set: ModelSet) -> &'static [Printed];

    /// Its equations with the values of a moment.
    #[must_use]
    fn explain(moment: &ForceMoment) -> Vec<Live>;
}
