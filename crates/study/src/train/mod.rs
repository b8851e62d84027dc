//! Training of the neural force model: data, recipes, errors, the best formula on the same data,
//! the formula that genetic programming finds on it, and the 2013 paper's comparison of 40 networks.
//!
//! All of it are jobs: [`data::RowsJob`] row by row, [`TrainingSession`] epoch by epoch,
//! [`comparison::ComparisonJob`] network by network.

pub mod claim;
pub mod comparison;
pub mod data;
pub mod errors;
pub mod findings;
pub mod formula;
pub mod genetic;
pub mod recipe;
pub mod report;
pub mod static_peaks;
pub mod unks;

use crate::base::language::text;
use crate::base::math::extent;
use crate::base::network::{Network, Provenance, ScaledNetwork, Scaling, Training, write};
use crate::base::rng::Stream;
use crate::run::job::{Budget, Job, Progress};

use data::TrainingRow;
use recipe::TrainingRecipe;

/// Fraction of the measured rows that is trained on; the others are held out, to choose recipes by.
pub const TRAINING_FRACTION: f64 = 0.8;

/// Measured rows split into those trained on and those held out. The rows of a Latin hypercube are
/// in random order already.
#[must_use]
pub fn split(measured: &[TrainingRow]) -> (&[TrainingRow], &[TrainingRow]) {
    measured.split_at((measured.len() as f64 * TRAINING_FRACTION) as usize)
}

/// A training under way.
#[derive(Clone, Debug)]
pub struct TrainingSession {
    recipe: TrainingRecipe,
    rows: u32,
    scaling: Scaling,
    training: Training,
    epochs_done: u32,
}

impl TrainingSession {
    /// A training by `recipe` on the first part of `measured`.
    ///
    /// # Errors
    /// Names `sizes`, or the input or output that does not vary in the rows.
    pub fn new(recipe: &TrainingRecipe, measured: &[TrainingRow]) -> Result<Self, String> {
        let (rows, _) = split(measured);
        let stream = |label: &str| Stream::new(recipe.seed.into(), label);
        let activation = recipe.activation;
        let start = stream("train.weights");
        let network = Network::random(&recipe.sizes(), activation, false, start)?;
        let scaling = Scaling {
            norm: recipe.norm,
            target: recipe.target,
            ln_inputs: recipe.ln_inputs.to_vec(),
            inputs: (0..8).map(|i| extent(rows.iter().map(|row| row.cut.inputs()[i]))).collect(),
            outputs: (0..3).map(|i| extent(rows.iter().map(|row| row.forces_n[i]))).collect(),
        };
        // Rounded before the first epoch, so that the file's ranges are those trained with.
        let scaling = ScaledNetwork { network: network.clone(), scaling }.as_in_file().scaling;
        scaling.check(&network)?;
        let patterns = rows.iter().map(|row| {
            (scaling.normal_inputs(&row.cut.inputs()), scaling.normal_targets(&row.forces_n))
        });
        let patterns = patterns.collect();
        let training = Training::new(network, recipe.learning, patterns, stream("train.order"));
        Ok(Self {
            recipe: recipe.clone(),
            rows: measured.len() as u32,
            scaling,
            training,
            epochs_done: 0,
        })
    }

    /// One epoch; returns the root mean square of the normalised errors met.
    pub fn epoch(&mut self) -> f64 {
        self.epochs_done += 1;
        self.training.epoch()
    }

    /// Epochs done.
    #[must_use]
    pub fn epochs_done(&self) -> u32 {
        self.epochs_done
    }

    /// The network as it is now, with the digits of a file.
    #[must_use]
    pub fn network(&self) -> ScaledNetwork {
        let network = self.training.network().clone();
        ScaledNetwork { network, scaling: self.scaling.clone() }.as_in_file()
    }

    /// The network file.
    #[must_use]
    pub fn file(&self) -> String {
        let TrainingRecipe { seed, epochs, learning, .. } = self.recipe;
        let provenance = Provenance {
            note: format!("{} Written by `steadycut train force`.", data::NOTE),
            rows: self.rows,
            seed,
            epochs,
            rate: learning.rate,
            momentum: learning.momentum,
            decay: learning.decay,
        };
        write(&self.network(), &provenance)
    }
}

/// A step is an epoch.
impl Job for TrainingSession {
    type Partial = ScaledNetwork;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        while self.epochs_done < self.recipe.epochs && budget.step() {
            self.epoch();
        }
        self.epochs_done >= self.recipe.epochs
    }

    fn progress(&self) -> Progress {
        let total = f64::from(self.recipe.epochs);
        Progress { done: f64::from(self.epochs_done), total, unit: text!("epochs") }
    }

    fn partial(&self) -> ScaledNetwork {
        self.network()
    }
}
