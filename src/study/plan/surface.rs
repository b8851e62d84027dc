//! The force surface: the neural network's answer over feed and speed with everything else fixed,
//! times what the network does not know.

use crate::base::math;
use crate::run::scenario::Scenario;

/// The force over feed and speed for one cut.
#[derive(Clone, Debug)]
pub struct ForceSurface {
    radial_depth_mm: f64,
    axial_depth_mm: f64,
    factor: f64,
}

impl ForceSurface {
    /// The surface for a scenario's plant and workpiece at an axial depth in mm.
    #[must_use]
    pub fn new(scenario: &Scenario, axial_depth_mm: f64) -> Self {
        let plant = &scenario.plant;
        let material = plant.material.force_factor(plant.hardness_hb);
        Self {
            radial_depth_mm: scenario.workpiece.radial_depth_mm,
            axial_depth_mm,
            factor: material * plant.wear_factor,
        }
    }

    /// Signed force components F_x, F_y, F_z in N at the instant of the largest force.
    #[must_use]
    #[inline]
    pub fn components_n(&self, feed_mm_min: f64, speed_rpm: f64) -> [f64; 3] {
        let feed_per_tooth_mm = feed_mm_min / (2.0 * speed_rpm);
        let force = 1147.0
            * self.factor
            * math::pow(feed_per_tooth_mm, 0.83)
            * math::pow(self.axial_depth_mm, 0.9)
            * math::pow(self.radial_depth_mm, 0.6)
            * math::pow(1500.0 / speed_rpm, 0.1);
        [-0.82 * force, 0.572 * force, 0.4 * force]
    }
}
