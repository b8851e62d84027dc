//! Feed-forward neural networks (multi-layer perceptrons) of bounded size, evaluated without
//! allocation.
//!
//! A neuron gives y = a(w_1 x_1 + ... + w_n x_n + b). Weights are stored layer by layer, neuron by
//! neuron, its inputs then its bias. As in the 2013 paper one activation serves the hidden layers
//! and the output layer, unless the output is declared linear.

mod activation;
mod backprop;
mod file;
mod scaling;

pub use activation::Activation;
pub use backprop::{Backprop, LearningParameters, Training};
pub use file::{NetworkFile, Provenance, parse, write};
pub use scaling::{ScaledNetwork, Scaling};

use crate::base::language::tr;
use crate::base::rng::Stream;

/// Most neurons (or inputs) in a layer.
pub const MAX_WIDTH: usize = 32;
/// Most layers, the inputs counted.
pub const MAX_LAYERS: usize = 6;

/// The values of one layer.
pub type Layer = [f64; MAX_WIDTH];

/// A network over normalised values.
#[derive(Clone, Debug, PartialEq)]
pub struct Network {
    sizes: Vec<usize>,
    activation: Activation,
    linear_output: bool,
    weights: Vec<f64>,
}

/// Number of weights that layers of `sizes` need.
fn weights_needed(sizes: &[usize]) -> Result<usize, String> {
    let fit = sizes.iter().all(|size| (1..=MAX_WIDTH).contains(size));
    if (2..=MAX_LAYERS).contains(&sizes.len()) && fit {
        return Ok(sizes.windows(2).map(|pair| (pair[0] + 1) * pair[1]).sum());
    }
    Err(tr!(
        "`sizes` must be 2 to {layers} layers of 1 to {neurons} neurons",
        layers = MAX_LAYERS,
        neurons = MAX_WIDTH
    ))
}

impl Network {
    /// A network from its weights.
    ///
    /// # Errors
    /// Names `sizes` or `weights` and what is allowed.
    pub fn new(
        sizes: &[usize],
        activation: Activation,
        linear_output: bool,
        weights: Vec<f64>,
    ) -> Result<Self, String> {
        let needed = weights_needed(sizes)?;
        if weights.len() != needed {
            return Err(tr!(
                "`weights` holds {n} numbers, needed are {needed}",
                n = weights.len(),
                needed = needed
            ));
        }
        if let Some(i) = weights.iter().position(|weight| !weight.is_finite()) {
            return Err(tr!(
                "`weights[{index}]` is {weight}: it must be finite",
                index = i,
                weight = weights[i]
            ));
        }
        Ok(Self { sizes: sizes.to_vec(), activation, linear_output, weights })
    }

    /// A network to be trained: weights uniform in +-sqrt(6 / (inputs + outputs)) of their layer
    /// (Glorot and Bengio 2010), biases 0.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn random(
        sizes: &[usize],
        activation: Activation,
        linear_output: bool,
        stream: Stream,
    ) -> Result<Self, String> {
        let mut weights = Vec::with_capacity(weights_needed(sizes)?);
        for pair in sizes.windows(2) {
            let limit = (6.0 / (pair[0] + pair[1]) as f64).sqrt();
            for _ in 0..pair[1] {
                for _ in 0..pair[0] {
                    let draw = stream.uniform(weights.len() as u64);
                    weights.push(limit * (2.0 * draw - 1.0));
                }
                weights.push(0.0);
            }
        }
        Self::new(sizes, activation, linear_output, weights)
    }

    /// Neurons in each layer, the inputs first.
    #[must_use]
    pub fn sizes(&self) -> &[usize] {
        &self.sizes
    }

    /// The activation of its neurons.
    #[must_use]
    pub fn activation(&self) -> Activation {
        self.activation
    }

    /// Whether the output layer has no activation.
    #[must_use]
    pub fn linear_output(&self) -> bool {
        self.linear_output
    }

    /// All weights, in the order of the file.
    #[must_use]
    pub fn weights(&self) -> &[f64] {
        &self.weights
    }

    /// The activation of layer `layer` (1 for the first hidden one), `None` where linear.
    fn activation_of(&self, layer: usize) -> Option<Activation> {
        let linear = self.linear_output && layer + 1 == self.sizes.len();
        (!linear).then_some(self.activation)
    }

    /// The outputs for normalised `inputs`; entries beyond the sizes are not used and stay 0.
    #[must_use]
    pub fn forward(&self, inputs: &Layer) -> Layer {
        let mut values = *inputs;
        let mut rest = &self.weights[..];
        for layer in 1..self.sizes.len() {
            let (count, width) = (self.sizes[layer], self.sizes[layer - 1]);
            let (weights, others) = rest.split_at(count * (width + 1));
            rest = others;
            let mut next = [0.0; MAX_WIDTH];
            for (out, row) in next.iter_mut().zip(weights.chunks_exact(width + 1)) {
                *out = weighted_sum(row, &values[..width]);
            }
            if let Some(activation) = self.activation_of(layer) {
                activation.apply(&mut next[..count]);
            }
            values = next;
        }
        values
    }
}

/// w . x + b with the bias last in `row`.
#[inline]
fn weighted_sum(row: &[f64], values: &[f64]) -> f64 {
    let (bias, weights) = row.split_last().unwrap_or((&0.0, &[]));
    weights.iter().zip(values).fold(*bias, |sum, (w, x)| sum + w * x)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_network_by_hand() {
        let weights = vec![0.5, -1.0, 0.25, 2.0, 1.0, -0.5, 1.5, -2.0, 0.125];
        let network = Network::new(&[2, 2, 1], Activation::Arctan, true, weights).unwrap();
        let mut inputs = [0.0; MAX_WIDTH];
        (inputs[0], inputs[1]) = (0.3, 0.7);
        let hidden = [libm::atan(0.15 - 0.7 + 0.25), libm::atan(0.6 + 0.7 - 0.5)];
        let expected = 1.5 * hidden[0] - 2.0 * hidden[1] + 0.125;
        assert!((network.forward(&inputs)[0] - expected).abs() < 1e-15);
    }

    #[test]
    fn sizes_and_weights_that_do_not_fit_are_refused_by_name() {
        let new = |sizes: &[usize], weights| {
            Network::new(sizes, Activation::Tanh, false, weights).unwrap_err()
        };
        for sizes in [&[3][..], &[], &[3, 0, 1], &[3, 33, 1], &[usize::MAX, 2], &[1; 7]] {
            assert!(new(sizes, vec![0.0; 4]).contains("`sizes`"), "{sizes:?}");
        }
        assert!(new(&[3, 1], vec![0.0; 3]).contains("needed are 4"));
        assert!(new(&[1, 1], vec![0.0, f64::NAN]).contains("`weights[1]` is NaN"));
    }
}
