//! The cutting force as a map of feed, speed and engagement: the formula of the model set (K4: 2007
//! eq. 7, M4: 2013 eq. 5) times what it does not know, or the neural force model (2013, section 2.3).
//!
//! ```text
//! F = (K4(f_a, n_a) + offset) x material(HB) x (A_D R_D) / (A_0 R_0) x wear
//! F = (|F_xy|(f_a, n_a, R_D, A_D, material, HB, tool) + offset) x wear
//! ```
//!
//! K4 and M4 belong to Ck45 at A_0 2 mm and R_0 3 mm with a sharp tool (those of the milling simulator
//! to its reference cut); force is taken as proportional to the cross-section (chosen). The network
//! knows depths and material itself; wear multiplies its force as well.

use super::neural::{NeuralCut, NeuralLaw};
use super::process::PlantSettings;
use super::tool_path::Engagement;
use super::workpiece::AXIAL_DEPTH_2007_MM;
use crate::base::math;
use crate::models::Valued;
use crate::models::genetic::GeneticModels;
use crate::models::tool::{Outline, Tool};

/// Cross-section of the cut for each millimetre of axial depth, over that at which the formula of
/// the set holds, 1/mm.
fn engagement_per_mm(models: &GeneticModels, radial_depth_mm: f64) -> f64 {
    let [axial_mm, radial_mm] = models.set.engagement_mm();
    radial_depth_mm / (axial_mm * radial_mm)
}

/// The map of a plant.
#[derive(Clone, Debug)]
pub struct ForceMap {
    outline: Outline,
    models: GeneticModels,
    /// Force factor per millimetre of axial depth, for the formula.
    factor_per_mm: f64,
    radial_depth_mm: f64,
    /// Material times wear.
    share: f64,
    /// In place of the formula.
    neural: Option<Box<NeuralLaw>>,
    wear_factor: f64,
    offset_n: f64,
}

impl ForceMap {
    /// The map of a plant with a tool at a radial depth of cut in mm; the formula where its force model is none.
    #[must_use]
    pub fn new(plant: &PlantSettings, tool: &Tool, radial_depth_mm: f64) -> Self {
        let models = GeneticModels::new(plant.model_set, plant.calibration);
        let mut models = models.for_tool(tool);
        models.force.intercept_n += plant.force_offset_n;
        let engagement = engagement_per_mm(&models, radial_depth_mm);
        let material = plant.material.force_factor(plant.hardness_hb);
        let depths_mm = [AXIAL_DEPTH_2007_MM, radial_depth_mm];
        let cut = NeuralCut::new(tool, plant.material, plant.hardness_hb, depths_mm);
        Self {
            outline: tool.outline(),
            models,
            factor_per_mm: material * plant.wear_factor * engagement,
            radial_depth_mm,
            share: material * plant.wear_factor,
            neural: plant.force_model.network().map(|kind| Box::new(NeuralLaw::new(kind, cut))),
            wear_factor: plant.wear_factor,
            offset_n: plant.force_offset_n,
        }
    }

    /// Outline of the tool.
    #[must_use]
    pub fn outline(&self) -> Outline {
        self.outline
    }

    /// The true models, with the offset of the force.
    #[must_use]
    pub fn models(&self) -> &GeneticModels {
        &self.models
    }

    /// Whether the tool is in the material at this axial depth in mm; otherwise it is in the air.
    #[must_use]
    pub fn engaged(&self, axial_depth_mm: f64) -> bool {
        self.factor_per_mm * axial_depth_mm > 0.0
    }

    /// The maximum cutting force in N at feed in mm/min, speed in 1/min and an engagement;
    /// `life_factor` is that of the wear over the tool's life (see [`super::wear`]).
    #[inline]
    #[must_use]
    pub fn force(
        &mut self,
        feed_mm_min: f64,
        speed_rpm: f64,
        place: &Engagement,
        life_factor: f64,
    ) -> Valued {
        let axial_depth_mm = place.axial_depth_mm;
        if place.radial_depth_mm != self.radial_depth_mm {
            self.radial_depth_mm = place.radial_depth_mm;
            let engagement = engagement_per_mm(&self.models, place.radial_depth_mm);
            self.factor_per_mm = self.share * engagement;
        }
        let in_air = !self.engaged(axial_depth_mm);
        if let Some(neural) = &mut self.neural {
            if in_air {
                // No cut, and so none that the network does not know.
                return Valued::new(0.0, true);
            }
            let peak =
                neural.update(feed_mm_min, speed_rpm, [axial_depth_mm, place.radial_depth_mm]);
            if peak.value == 0.0 {
                return peak;
            }
            let force_n = (peak.value + self.offset_n) * self.wear_factor * life_factor;
            // An offset may ask for less than no force: as of the formula, that is outside its range.
            return Valued::new(math::positive(force_n), peak.valid && force_n >= 0.0);
        }
        let base = self.models.force(feed_mm_min, speed_rpm);
        Valued::new(base.value * self.factor_per_mm * axial_depth_mm * life_factor, base.valid)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blocks::cutting::force_model::ForceModel;

    #[test]
    fn an_offset_that_asks_for_less_than_no_force_is_marked_on_every_map() {
        for force_model in ForceModel::MAPS {
            let place = Engagement { axial_depth_mm: 2.0, radial_depth_mm: 3.0 };
            let force = |force_offset_n: f64| {
                let plant =
                    PlantSettings { force_model, force_offset_n, ..PlantSettings::default() };
                ForceMap::new(&plant, &Tool::default(), 3.0).force(330.0, 1600.0, &place, 1.0)
            };
            assert!(force(0.0).valid && force(0.0).value > 100.0, "{force_model:?}");
            let least = force(-1e4);
            assert_eq!((least.value, least.valid), (0.0, false), "{force_model:?}");
        }
    }
}
