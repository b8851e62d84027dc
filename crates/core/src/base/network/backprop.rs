//! Back-propagation with momentum, pattern by pattern (Rumelhart, Hinton, Williams 1986), the
//! papers' learning rule: with E = 1/2 sum (y - target)^2 of one pattern,
//! v <- momentum v - rate dE/dw, w <- w + v.

use super::{Layer, MAX_LAYERS, MAX_WIDTH, Network, weighted_sum};
use crate::base::rng::Stream;

/// The memory of back-propagation: the last change of every weight.
#[derive(Clone, Debug)]
pub struct Backprop {
    changes: Vec<f64>,
}

impl Backprop {
    /// At rest, for `network`.
    #[must_use]
    pub fn new(network: &Network) -> Self {
        Self { changes: vec![0.0; network.weights.len()] }
    }

    /// Learns one pattern (normalised inputs and targets); returns its error E before the step.
    pub fn step(
        &mut self,
        network: &mut Network,
        inputs: &Layer,
        targets: &Layer,
        rate: f64,
        momentum: f64,
    ) -> f64 {
        let last = network.sizes.len() - 1;
        let mut values = [[0.0; MAX_WIDTH]; MAX_LAYERS];
        let mut slopes = [[0.0; MAX_WIDTH]; MAX_LAYERS];
        values[0] = *inputs;
        let mut start = 0;
        for layer in 1..=last {
            let (count, width) = (network.sizes[layer], network.sizes[layer - 1]);
            let end = start + count * (width + 1);
            let mut sums = [0.0; MAX_WIDTH];
            let rows = network.weights[start..end].chunks_exact(width + 1);
            for (sum, row) in sums.iter_mut().zip(rows) {
                *sum = weighted_sum(row, &values[layer - 1][..width]);
            }
            values[layer] = sums;
            match network.activation_of(layer) {
                Some(activation) => {
                    activation.apply(&mut values[layer][..count]);
                    for i in 0..count {
                        slopes[layer][i] = activation.slope(sums[i], values[layer][i]);
                    }
                }
                None => slopes[layer] = [1.0; MAX_WIDTH],
            }
            start = end;
        }
        let mut error = 0.0;
        // dE/ds of the layer in hand.
        let mut deltas = [0.0; MAX_WIDTH];
        for i in 0..network.sizes[last] {
            let off = values[last][i] - targets[i];
            error += 0.5 * off * off;
            deltas[i] = off * slopes[last][i];
        }
        for layer in (1..=last).rev() {
            let (count, width) = (network.sizes[layer], network.sizes[layer - 1]);
            let begin = start - count * (width + 1);
            let weights = network.weights[begin..start].chunks_exact_mut(width + 1);
            let changes = self.changes[begin..start].chunks_exact_mut(width + 1);
            let inputs = &values[layer - 1][..width];
            let mut below = [0.0; MAX_WIDTH];
            for ((row, change), delta) in weights.zip(changes).zip(deltas) {
                for i in 0..width {
                    below[i] += row[i] * delta;
                    change[i] = momentum * change[i] - rate * delta * inputs[i];
                    row[i] += change[i];
                }
                change[width] = momentum * change[width] - rate * delta;
                row[width] += change[width];
            }
            for i in 0..width {
                deltas[i] = below[i] * slopes[layer - 1][i];
            }
            start = begin;
        }
        error
    }
}

/// How a training learns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LearningParameters {
    /// Learning rate of the first epoch.
    pub rate: f64,
    /// Momentum, 0 to 1.
    pub momentum: f64,
    /// The rate of epoch e is rate / (1 + decay e).
    pub decay: f64,
}

/// A training under way; [`Self::epoch`] advances it, so that callers can show progress or stop.
#[derive(Clone, Debug)]
pub struct Training {
    network: Network,
    backprop: Backprop,
    learning: LearningParameters,
    patterns: Vec<(Layer, Layer)>,
    order: Vec<usize>,
    stream: Stream,
    epoch: u32,
}

impl Training {
    /// A training of `network` on `patterns` of normalised inputs and targets; `stream` gives the
    /// order of the patterns in each epoch.
    #[must_use]
    pub fn new(
        network: Network,
        learning: LearningParameters,
        patterns: Vec<(Layer, Layer)>,
        stream: Stream,
    ) -> Self {
        let backprop = Backprop::new(&network);
        let order = (0..patterns.len()).collect();
        Self { network, backprop, learning, patterns, order, stream, epoch: 0 }
    }

    /// The network as it is now.
    #[must_use]
    pub fn network(&self) -> &Network {
        &self.network
    }

    /// Shows every pattern once, in a new order; returns the root mean square of the output errors
    /// met on the way (normalised).
    pub fn epoch(&mut self) -> f64 {
        let count = self.order.len();
        for i in (1..count).rev() {
            // Fisher and Yates' shuffle.
            let counter = (u64::from(self.epoch) << 32) | i as u64;
            self.order.swap(i, self.stream.below(counter, i as u64 + 1) as usize);
        }
        let rate = self.learning.rate / (1.0 + self.learning.decay * f64::from(self.epoch));
        let mut sum = 0.0;
        for index in &self.order {
            let (inputs, targets) = &self.patterns[*index];
            let momentum = self.learning.momentum;
            sum += self.backprop.step(&mut self.network, inputs, targets, rate, momentum);
        }
        self.epoch += 1;
        let outputs = self.network.sizes[self.network.sizes.len() - 1];
        (2.0 * sum / (count.max(1) * outputs) as f64).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::super::Activation;
    use super::*;

    const SIZES: [usize; 4] = [3, 4, 5, 2];

    fn layer(stream: Stream, from: u64) -> Layer {
        std::array::from_fn(|i| stream.uniform(from + i as u64) - 0.3)
    }

    fn error(network: &Network, inputs: &Layer, targets: &Layer) -> f64 {
        let outputs = network.forward(inputs);
        (0..2).map(|i| 0.5 * (outputs[i] - targets[i]) * (outputs[i] - targets[i])).sum()
    }

    #[test]
    fn the_step_is_the_gradient_by_finite_differences() {
        for activation in Activation::ALL {
            for linear in [false, true] {
                let stream = Stream::new(3, "gradient");
                let network = Network::random(&SIZES, *activation, linear, stream).unwrap();
                let (inputs, targets) = (layer(stream, 1000), layer(stream, 2000));
                let mut stepped = network.clone();
                let mut backprop = Backprop::new(&network);
                let met = backprop.step(&mut stepped, &inputs, &targets, 1.0, 0.0);
                assert!((met - error(&network, &inputs, &targets)).abs() < 1e-15);
                for i in 0..network.weights.len() {
                    let at = |change: f64| {
                        let mut moved = network.clone();
                        moved.weights[i] += change;
                        error(&moved, &inputs, &targets)
                    };
                    let slope = (at(1e-5) - at(-1e-5)) / 2e-5;
                    let step = network.weights[i] - stepped.weights[i];
                    assert!(
                        (slope - step).abs() < 1e-9,
                        "{activation:?}, weight {i}: {slope} {step}"
                    );
                }
            }
        }
    }

    #[test]
    fn momentum_repeats_the_last_change_and_training_finds_a_simple_law() {
        let stream = Stream::new(4, "training");
        let network = Network::random(&[2, 6, 1], Activation::Arctan, false, stream).unwrap();
        let patterns = (0..200).map(|i| {
            let (mut inputs, mut targets) = ([0.0; MAX_WIDTH], [0.0; MAX_WIDTH]);
            (inputs[0], inputs[1]) = (stream.uniform(900 + 2 * i), stream.uniform(901 + 2 * i));
            targets[0] = 0.2 + 0.6 * inputs[0] * inputs[1];
            (inputs, targets)
        });
        let patterns: Vec<(Layer, Layer)> = patterns.collect();
        let mut once = network.clone();
        let mut backprop = Backprop::new(&once);
        let (inputs, targets) = &patterns[0];
        backprop.step(&mut once, inputs, targets, 0.1, 0.5);
        let mut again = once.clone();
        // Without a rate only the momentum moves: half of the first change.
        backprop.step(&mut again, inputs, targets, 0.0, 0.5);
        let weights = network.weights.iter().zip(&once.weights).zip(&again.weights);
        for ((start, first), second) in weights {
            assert!((0.5 * (first - start) - (second - first)).abs() < 1e-15);
        }
        let learning = LearningParameters { rate: 0.1, momentum: 0.5, decay: 0.002 };
        let mut training = Training::new(network, learning, patterns, stream);
        let first = training.epoch();
        let last = (0..300).map(|_| training.epoch()).last().unwrap();
        assert!(first > 0.05 && last < 0.01, "{first} {last}");
    }
}
