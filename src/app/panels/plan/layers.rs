//! What can be shown and hidden on the map.

use std::collections::BTreeSet;

/// One thing on the map.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum MapLayer {
    /// The boundary of a constraint, by its number in the list of seven.
    Boundary(usize),
    /// The lines of equal force.
    ForceLines,
    /// The particles.
    Particles,
    /// The best place of every particle.
    OwnBests,
    /// The best place of all.
    Best,
    /// The programmed values of the scenario.
    Programmed,
}

/// The layers switched off.
#[derive(Clone, Debug, Default)]
pub struct Layers {
    hidden: BTreeSet<MapLayer>,
}

impl Layers {
    /// Whether a layer is shown.
    #[must_use]
    pub fn show(&self, layer: MapLayer) -> bool {
        !self.hidden.contains(&layer)
    }

    /// Shows it if it is hidden, and hides it if it is shown.
    pub fn toggle(&mut self, layer: MapLayer) {
        if !self.hidden.remove(&layer) {
            self.hidden.insert(layer);
        }
    }
}
