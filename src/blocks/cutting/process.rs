//! The cutting process: K4 (2007 eq. 7) times what K4 does not know.
//!
//! ```text
//! F = (K4(f_a, n_a) + offset) x material(HB) x (A_D R_D) / (2 mm x 3 mm) x wear
//! ```
//!
//! K4 was identified on Ck45 at A_D 2 mm and R_D 3 mm with a sharp tool; force is taken as
//! proportional to the cross-section of the cut (chosen).

use super::material::Material;
use super::workpiece::{AXIAL_DEPTH_2007_MM, RADIAL_DEPTH_2007_MM};
use crate::base::model::Valued;
use crate::base::model::gp::{Calibration, GpModels, ModelSet};

crate::choice! {
    /// What gives the plant's cutting force.
    pub enum ForceModel {
        /// The formula of the model set: K4 or M4.
        Formula = "formula", "Formula (K4, M4)";
    }
}

crate::settings! {
    /// The plant: what really is cut, whatever the controller believes.
    pub struct Plant {
        /// Set of the true force and roughness models; choosing one also sets the controller's.
        model_set: ModelSet = ModelSet::Sdnrp2007, [], "", live, "Model set";
        /// What gives the true cutting force.
        force_model: ForceModel = ForceModel::Formula, [], "", live, "Force model";
        /// Calibration of the true force and roughness models.
        calibration: Calibration = Calibration::Identified, [], "", live, "Calibration";
        /// Workpiece material; choosing one sets the hardness to its reference value.
        material: Material = Material::Ck45, [], "", live, "Material";
        /// Brinell hardness of the workpiece.
        hardness_hb: f64 = 200.0, [60.0, 500.0], "HB", live, "Hardness";
        /// Factor of tool wear on the force: 1 for a sharp tool.
        wear_factor: f64 = 1.0, [1.0, 2.0], "", live, "Wear factor";
        /// Added to K4's force: an error of its intercept, for experiments on model mismatch.
        force_offset_n: f64 = 0.0, [-100.0, 100.0], "N", live, "Force offset";
    }
}

/// The cutting process set up from plant and workpiece settings.
#[derive(Clone, Debug)]
pub struct Process {
    models: GpModels,
    /// Force factor per millimetre of axial depth.
    factor_per_mm: f64,
}

impl Process {
    /// The process for a plant with a radial depth of cut in mm.
    #[must_use]
    pub fn new(plant: &Plant, radial_depth_mm: f64) -> Self {
        let mut models = GpModels::new(plant.model_set, plant.calibration);
        models.force.intercept_n += plant.force_offset_n;
        let engagement = radial_depth_mm / (AXIAL_DEPTH_2007_MM * RADIAL_DEPTH_2007_MM);
        let material = plant.material.force_factor(plant.hardness_hb);
        Self { models, factor_per_mm: material * plant.wear_factor * engagement }
    }

    /// The true models, for the surface block.
    #[must_use]
    pub fn models(&self) -> &GpModels {
        &self.models
    }

    /// Whether the tool is in the material at this axial depth in mm; otherwise it is in the air.
    #[must_use]
    pub fn engaged(&self, axial_depth_mm: f64) -> bool {
        self.factor_per_mm * axial_depth_mm > 0.0
    }

    /// The maximum cutting force in N.
    #[inline]
    #[must_use]
    pub fn update(&self, feed_mm_min: f64, speed_rpm: f64, axial_depth_mm: f64) -> Valued {
        let base = self.models.force(feed_mm_min, speed_rpm);
        Valued::new(base.value * self.factor_per_mm * axial_depth_mm, base.valid)
    }
}
