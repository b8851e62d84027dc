//! The neural force model as the paper of 2013 has it: inputs and learning parameters are its own.

use super::map::Mapped;
use super::neural::{MappedNetwork, NetworkMap};
use crate::models::neural_force::NeuralKind;

/// The network.
#[derive(Clone, Copy, Debug)]
pub struct Literal;

impl MappedNetwork for Literal {
    const ABOUT: &'static str =
        "The 8-15-3 network with the inputs and learning parameters of the 2013 paper.";
    const KIND: NeuralKind = NeuralKind::Literal;
}

/// The force model.
pub type NeuralLiteral = Mapped<NetworkMap<Literal>>;
