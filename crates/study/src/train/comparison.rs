//! The 2013 paper's comparison of 40 networks, repeated on the data of this program.
//!
//! One factor at a time around the paper's optimum (arc tangent, rate 0.05, momentum 0.01, 15 hidden
//! neurons, plain inputs, everything mapped to 0..1); every activation at two rates and two ranges
//! of its targets, the paper's and one inside its bounds; and the centre with further seeds, whose
//! spread says which differences mean anything. Every network gets the same number of epochs.

use serde::Serialize;

use super::data::TrainingRow;
use super::errors::of_components;
use super::recipe::{RecipeKind, TrainingRecipe};
use super::{TrainingSession, split};
use crate::base::network::Activation;

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

/// Trains one network on the first part of `measured` and judges it over the rest.
///
/// # Errors
/// As [`TrainingSession::new`].
pub fn trial(recipe: &TrainingRecipe, measured: &[TrainingRow]) -> Result<Trial, String> {
    let (_, held_out) = split(measured);
    let mut session = TrainingSession::new(recipe, measured)?;
    let mut checks = Vec::new();
    let mut epochs_to_level = None;
    for epoch in 1..=recipe.epochs {
        session.epoch();
        if epoch % CHECK_EVERY != 0 {
            continue;
        }
        let network = session.network();
        let errors = of_components(held_out, |row| {
            let [x, y, z, ..] = network.predict(&row.cut.inputs());
            [x, y, z]
        });
        if errors.mean_percent <= LEVEL_PERCENT && epochs_to_level.is_none() {
            epochs_to_level = Some(epoch);
        }
        checks.push(errors.mean_percent);
    }
    let last = &checks[checks.len().saturating_sub(LAST_CHECKS)..];
    Ok(Trial {
        activation: recipe.activation.id(),
        target: recipe.target,
        rate: recipe.learning.rate,
        momentum: recipe.learning.momentum,
        hidden: recipe.hidden[0],
        seed: recipe.seed,
        error_percent: last.iter().sum::<f64>() / last.len().max(1) as f64,
        epochs_to_level,
    })
}
