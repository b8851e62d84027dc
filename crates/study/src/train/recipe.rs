//! Recipes: everything that a training depends on.

use crate::base::network::{Activation, LearningParameters};
use crate::models::neural_force::NeuralKind;

/// Which inputs go in as logarithms in the improved recipe: feed, speed, depths, hardness and
/// diameter, but not the two codes. Cutting forces are products of powers, sums of logarithms.
pub const LN_INPUTS: [bool; 8] = [true, true, true, true, false, true, true, false];

/// A training: its data, network and learning.
#[derive(Clone, Debug, PartialEq)]
pub struct TrainingRecipe {
    /// Measured rows, training and hold-out together.
    pub rows: u32,
    /// Seed of data, first weights and order.
    pub seed: u32,
    /// Neurons of the hidden layers.
    pub hidden: Vec<usize>,
    /// Activation of all neurons.
    pub activation: Activation,
    /// Which inputs go in as logarithms.
    pub ln_inputs: [bool; 8],
    /// Range of the normalised inputs.
    pub norm: [f64; 2],
    /// Range of the normalised targets.
    pub target: [f64; 2],
    /// Rate, momentum, decay.
    pub learning: LearningParameters,
    /// Epochs.
    pub epochs: u32,
}

steadycut_core::choice! {
    /// A recipe by name.
    pub enum RecipeKind {
        /// 8-15-3 with logarithms, ranges -1 to 1 and rates chosen by the hold-out error.
        Improved = "improved", "improved";
        /// 8-15-3 as the 2013 paper has it: plain inputs, ranges 0 to 1, its rate and momentum.
        Literal = "literal", "as in the 2013 paper";
        /// 8-5-3-7-3 on 720 rows, the 2005 paper's network, learning as in 2013.
        Combined2005 = "2005", "as in the 2005 paper";
    }
}

impl RecipeKind {
    /// The recipe.
    #[must_use]
    pub fn recipe(self) -> TrainingRecipe {
        let literal = TrainingRecipe {
            rows: 3500,
            seed: 2,
            hidden: vec![15],
            activation: Activation::Arctan,
            ln_inputs: [false; 8],
            norm: [0.0, 1.0],
            target: [0.0, 1.0],
            // Within the paper's 0.03..0.1 and 0.008..0.01; it names no decay.
            learning: LearningParameters { rate: 0.05, momentum: 0.01, decay: 0.0 },
            epochs: 4000,
        };
        match self {
            Self::Literal => literal,
            Self::Improved => TrainingRecipe {
                ln_inputs: LN_INPUTS,
                norm: [-1.0, 1.0],
                target: Activation::Arctan.target_range(),
                learning: LearningParameters { rate: 0.05, momentum: 0.5, decay: 0.003 },
                epochs: 6000,
                ..literal
            },
            Self::Combined2005 => {
                TrainingRecipe { rows: 720, hidden: vec![5, 3, 7], epochs: 8000, ..literal }
            }
        }
    }

    /// The shipped network that the recipe makes, if one is shipped.
    #[must_use]
    pub fn shipped(self) -> Option<NeuralKind> {
        match self {
            Self::Improved => Some(NeuralKind::Improved),
            Self::Literal => Some(NeuralKind::Literal),
            Self::Combined2005 => None,
        }
    }
}

impl TrainingRecipe {
    /// Neurons of all layers.
    #[must_use]
    pub fn sizes(&self) -> Vec<usize> {
        [&[8][..], &self.hidden, &[3]].concat()
    }
}
