//! The force surface: the neural network's answer over feed and speed with everything else fixed,
//! times what the network does not know of material and wear.

use super::cut::REFERENCE;
use crate::blocks::cutting::neural::NeuralCut;
use crate::models::neural_force::{NeuralForce, NeuralForceAt};
use crate::run::scenario::Scenario;

/// The force over feed and speed for one cut.
#[derive(Clone, Debug)]
pub struct ForceSurface {
    network: NeuralForceAt,
    factor: f64,
    feed_factor: f64,
    known: bool,
}

impl ForceSurface {
    /// The surface for a scenario's plant at an axial and a radial depth in mm.
    #[must_use]
    pub fn new(scenario: &Scenario, depths_mm: [f64; 2]) -> Self {
        let (plant, tool) = (&scenario.plant, &scenario.tool);
        let cut = NeuralCut::new(tool, plant.material, plant.hardness_hb, depths_mm);
        let network = NeuralForce::shipped(scenario.plan.network).at(&cut.point);
        // Feed and speed of the search lie inside the training data; the rest is asked at one.
        let speed_rpm = tool.speed_rpm(REFERENCE[0]);
        let feed_mm_min = cut.feed_factor * tool.feed_mm_min(REFERENCE[1], speed_rpm);
        let known = cut.known() && network.peak(feed_mm_min, speed_rpm).valid;
        let factor = cut.factor * plant.wear_factor;
        Self { network, factor, feed_factor: cut.feed_factor, known }
    }

    /// Whether tool, material, hardness and depths lie inside the network's training data; otherwise its
    /// force is continued.
    #[must_use]
    pub fn known(&self) -> bool {
        self.known
    }

    /// The network, everything but feed and speed folded in; it counts the feed for two teeth.
    #[must_use]
    pub fn network(&self) -> &NeuralForceAt {
        &self.network
    }

    /// Signed force components F_x, F_y, F_z in N at the instant of the largest force.
    #[must_use]
    #[inline]
    pub fn components_n(&self, feed_mm_min: f64, speed_rpm: f64) -> [f64; 3] {
        let feed_mm_min = self.feed_factor * feed_mm_min;
        self.network.components(feed_mm_min, speed_rpm).map(|force_n| self.factor * force_n)
    }
}
