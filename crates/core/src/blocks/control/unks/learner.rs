//! A network that learns in the cut, one step of back-propagation per sample.

use crate::base::math::limit;
use crate::base::network::{Backprop, ScaledNetwork};

/// A network with the memory of its training.
#[derive(Clone, Debug)]
pub struct Learner {
    pub(super) scaled: ScaledNetwork,
    memory: Backprop,
    /// Number of samples that it was trained with.
    pub(super) lessons: u32,
}

impl Learner {
    pub(super) fn new(scaled: &ScaledNetwork) -> Self {
        Self { scaled: scaled.clone(), memory: Backprop::new(&scaled.network), lessons: 0 }
    }

    pub(super) fn predict(&self, features: [f64; 3], last: f64) -> f64 {
        let [a, b, c] = features;
        self.scaled.predict(&[a, b, c, last])[0]
    }

    /// One step of back-propagation that moves the output at these inputs by up to `error`, limited to
    /// `most` in normalised units.
    pub(super) fn learn(
        &mut self,
        (features, last): ([f64; 3], f64),
        error: f64,
        most: f64,
        rate: f64,
    ) {
        if rate <= 0.0 {
            return;
        }
        let [a, b, c] = features;
        let inputs = self.scaled.scaling.normal_inputs(&[a, b, c, last]);
        let mut targets = self.scaled.network.forward(&inputs);
        let [slope, _] = self.scaled.scaling.output_map(0);
        targets[0] += limit(error / slope, -most, most);
        self.memory.step(&mut self.scaled.network, &inputs, &targets, rate, 0.0);
        self.lessons = self.lessons.saturating_add(1);
    }
}
