//! The 2013 paper's comparison of 40 networks, repeated on the data of this program.
//!
//! One factor at a time around the paper's optimum (arc tangent, rate 0.05, momentum 0.01, 15 hidden
//! neurons, plain inputs, everything mapped to 0..1); every activation at two rates and two ranges
//! of its targets, the paper's and one inside its bounds; and the centre with further seeds, whose
//! spread says which differences mean anything. Every network gets the same number of epochs.

use std::sync::Arc;

use serde::Serialize;

use super::data::TrainingRow;
use super::errors::of_components;
use super::recipe::{RecipeKind, TrainingRecipe};
use super::{TrainingSession, split};
use crate::base::language::text;
use crate::base::network::Activation;
use crate::base::stats;
use crate::run::job::{Budget, Job, Progress};
use crate::run::parts::{Making, Parts};

/// Epochs of every network (chosen: all 40 in some minutes).
pub const EPOCHS: u32 = 1000;
/// Epochs from one hold-out error to the next.
const CHECK_EVERY: u32 = 10;
/// Number of last checks whose mean is a network's error, since a constant rate makes it fluctuate.
const LAST_CHECKS: usize = 10;
/// The error level whose first reaching counts as training cycles, percent (chosen).
pub const LEVEL_PERCENT: f64 = 12.0;

const RATES: [f64; 8] = [0.01, 0.02, 0.03, 0.07, 0.1, 0.15, 0.2, 0.3];
const MOMENTA: [f64; 5] = [0.004, 0.008, 0.03, 0.1, 0.5];
const HIDDEN: [usize; 9] = [3, 5, 7, 9, 11, 13, 17, 19, 21];
/// Rates at which every activation is tried.
pub const ACTIVATION_RATES: [f64; 2] = [0.05, 0.1];
const SEEDS: [u32; 3] = [3, 4, 5];

/// The recipes of the 40 networks, the centre first.
#[must_use]
pub fn recipes() -> Vec<TrainingRecipe> {
    let centre = TrainingRecipe { epochs: EPOCHS, ..RecipeKind::Literal.recipe() };
    let mut all = vec![centre.clone()];
    let mut add = |change: &dyn Fn(&mut TrainingRecipe)| {
        let mut recipe = centre.clone();
        change(&mut recipe);
        if !all.contains(&recipe) {
            all.push(recipe);
        }
    };
    RATES.iter().for_each(|rate| add(&|recipe| recipe.learning.rate = *rate));
    MOMENTA.iter().for_each(|momentum| add(&|recipe| recipe.learning.momentum = *momentum));
    HIDDEN.iter().for_each(|hidden| add(&|recipe| recipe.hidden = vec![*hidden]));
    for activation in Activation::ALL {
        for target in [centre.target, activation.target_range()] {
            for rate in ACTIVATION_RATES {
                add(&|recipe| {
                    (recipe.activation, recipe.target) = (*activation, target);
                    recipe.learning.rate = rate;
                });
            }
        }
    }
    SEEDS.iter().for_each(|seed| add(&|recipe| recipe.seed = *seed));
    all
}

/// A network trained by its recipe.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Trial {
    /// Activation.
    pub activation: &'static str,
    /// Range of the normalised targets.
    pub target: [f64; 2],
    /// Learning rate.
    pub rate: f64,
    /// Momentum.
    pub momentum: f64,
    /// Hidden neurons.
    pub hidden: usize,
    /// Seed of first weights and order.
    pub seed: u32,
    /// Mean error of F_xy over the held-out rows at the end, percent.
    pub error_percent: f64,
    /// Epochs until that error first reached [`LEVEL_PERCENT`]; `None` where it never did.
    pub epochs_to_level: Option<u32>,
}

/// The networks of the comparison, each trained on the first part of the rows and judged over the rest.
#[derive(Clone, Debug)]
pub struct ComparisonJob {
    recipes: Vec<TrainingRecipe>,
    measured: Arc<[TrainingRow]>,
    trials: Parts<TrialJob, Trial>,
}

impl ComparisonJob {
    /// A comparison of these recipes on `measured`, not yet begun.
    #[must_use]
    pub fn new(recipes: Vec<TrainingRecipe>, measured: &[TrainingRow]) -> Self {
        Self { recipes, measured: measured.into(), trials: Parts::default() }
    }

    /// The networks judged so far, in the order of their recipes.
    #[must_use]
    pub fn trials(&self) -> &[Trial] {
        self.trials.done()
    }
}

/// A step is an epoch of one of the networks.
impl Job for ComparisonJob {
    type Partial = Vec<Trial>;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        let (recipes, measured) = (&self.recipes, &self.measured);
        let begin = |index: usize| TrialJob::new(&recipes[index], measured);
        let end = |_: usize, job: &TrialJob| job.trial();
        self.trials.advance(recipes.len(), budget, &Making { begin: &begin, end: &end })
    }

    fn progress(&self) -> Progress {
        let total = self.recipes.len() as f64;
        Progress { done: self.trials.progress(), total, unit: text!("networks") }
    }

    fn partial(&self) -> Vec<Trial> {
        self.trials().to_vec()
    }

    fn refusal(&self) -> Option<&str> {
        self.trials.refusal()
    }
}

/// One network in training.
#[derive(Clone, Debug)]
struct TrialJob {
    recipe: TrainingRecipe,
    measured: Arc<[TrainingRow]>,
    session: TrainingSession,
    /// Errors over the held-out rows, percent.
    checks: Vec<f64>,
    epochs_to_level: Option<u32>,
}

impl TrialJob {
    fn new(recipe: &TrainingRecipe, measured: &Arc<[TrainingRow]>) -> Result<Self, String> {
        Ok(Self {
            session: TrainingSession::new(recipe, measured)?,
            recipe: recipe.clone(),
            measured: Arc::clone(measured),
            checks: Vec::new(),
            epochs_to_level: None,
        })
    }

    fn epoch(&mut self) {
        self.session.epoch();
        let epoch = self.session.epochs_done();
        if !epoch.is_multiple_of(CHECK_EVERY) {
            return;
        }
        let network = self.session.network();
        let (_, held_out) = split(&self.measured);
        let errors = of_components(held_out, |row| {
            let [x, y, z, ..] = network.predict(&row.cut.inputs());
            [x, y, z]
        });
        if errors.mean_percent <= LEVEL_PERCENT && self.epochs_to_level.is_none() {
            self.epochs_to_level = Some(epoch);
        }
        self.checks.push(errors.mean_percent);
    }

    fn trial(&self) -> Trial {
        let recipe = &self.recipe;
        let last = &self.checks[self.checks.len().saturating_sub(LAST_CHECKS)..];
        Trial {
            activation: recipe.activation.id(),
            target: recipe.target,
            rate: recipe.learning.rate,
            momentum: recipe.learning.momentum,
            hidden: recipe.hidden[0],
            seed: recipe.seed,
            error_percent: stats::mean(last.iter().copied()).unwrap_or(0.0),
            epochs_to_level: self.epochs_to_level,
        }
    }
}

impl Job for TrialJob {
    type Partial = Trial;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        while self.session.epochs_done() < self.recipe.epochs && budget.step() {
            self.epoch();
        }
        self.session.epochs_done() >= self.recipe.epochs
    }

    fn progress(&self) -> Progress {
        self.session.progress()
    }

    fn partial(&self) -> Trial {
        self.trial()
    }
}
