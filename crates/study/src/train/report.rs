//! What a training has come to.

use serde::Serialize;

use super::data::{NOTE, TrainingRow};
use super::errors::{TrainingErrors, of_components};
use super::formula::{FittedForm, fit_all};
use super::recipe::TrainingRecipe;
use super::{TrainingSession, split};
use crate::base::network::{ScaledNetwork, parse};

/// The 2013 paper's claim for the network and for its best formula, percent off the measurements.
pub const CLAIM_PERCENT: [f64; 2] = [4.0, 6.0];

/// A finished training.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Report {
    /// What the data are.
    pub data: &'static str,
    /// Neurons of all layers.
    pub sizes: Vec<usize>,
    /// Activation.
    pub activation: &'static str,
    /// Which inputs went in as logarithms.
    pub ln_inputs: [bool; 8],
    /// Seed.
    pub seed: u32,
    /// Epochs.
    pub epochs: u32,
    /// Learning rate, momentum and decay.
    pub learning: [f64; 3],
    /// Over the rows trained on, against their noisy forces.
    pub training: TrainingErrors,
    /// Over the rows held out, against their noisy forces.
    pub hold_out: TrainingErrors,
    /// Over fresh rows without noise.
    pub fresh: TrainingErrors,
    /// Formulas fitted to the rows trained on, judged over the fresh rows, the best first.
    pub formulas: Vec<FittedForm>,
    /// The 2013 paper's claim in percent: network, best formula.
    pub paper_claims_percent: [f64; 2],
    /// The network file.
    #[serde(skip)]
    pub file: String,
}

fn errors(network: &ScaledNetwork, rows: &[TrainingRow]) -> TrainingErrors {
    of_components(rows, |row| {
        let [x, y, z, ..] = network.predict(&row.cut.inputs());
        [x, y, z]
    })
}

/// Judges a session over its rows and over fresh ones, by the network that its file holds.
///
/// # Errors
/// Where the training has diverged, or the rows do not determine a formula.
pub fn report(
    session: &TrainingSession,
    measured: &[TrainingRow],
    fresh: &[TrainingRow],
) -> Result<Report, String> {
    let file = session.file();
    let (network, _) =
        parse(&file).map_err(|error| format!("the training has diverged: {error}"))?;
    let (training, held_out) = split(measured);
    let TrainingRecipe { learning, ln_inputs, seed, epochs, activation, .. } = session.recipe;
    Ok(Report {
        data: NOTE,
        sizes: session.recipe.sizes(),
        activation: activation.id(),
        ln_inputs,
        seed,
        epochs,
        learning: [learning.rate, learning.momentum, learning.decay],
        training: errors(&network, training),
        hold_out: errors(&network, held_out),
        fresh: errors(&network, fresh),
        formulas: fit_all(training, fresh)?,
        paper_claims_percent: CLAIM_PERCENT,
        file,
    })
}
