//! The cutting process: the formula of the model set (K4: 2007 eq. 7, M4: 2013 eq. 5) times what it
//! does not know, or the neural force model (2013, section 2.3).
//!
//! ```text
//! F = (K4(f_a, n_a) + offset) x material(HB) x (A_D R_D) / (A_0 R_0) x wear
//! F = (|F_xy|(f_a, n_a, R_D, A_D, material, HB, tool) + offset) x wear
//! ```
//!
//! or the mechanistic model, tooth by tooth ([`super::milling`]), whose force is that of every
//! instant and not a maximum.
//!
//! K4 and M4 belong to Ck45 at A_0 2 mm and R_0 3 mm with a sharp tool (those of the milling simulator
//! to its reference cut); force is taken as proportional to the cross-section (chosen). The network
//! knows depths and material itself; wear multiplies its force as well.

pub use super::force_model::ForceModel;

use super::contact;
use super::material::Material;
use super::milling::{Milling, MillingSetup};
use super::neural::{NeuralCut, NeuralLaw};
use super::tool_path::Engagement;
use super::workpiece::AXIAL_DEPTH_2007_MM;
use crate::base::math;
use crate::base::units::mm_from_um;
use crate::models::Valued;
use crate::models::ball_end::{CK45, Cutter, MNCRSI5};
use crate::models::genetic::{Calibration, GeneticModels, ModelSet};
use crate::models::part::CutPath;
use crate::models::tool::{Outline, Tool};

crate::settings! {
    /// The plant: what really is cut, whatever the controller believes.
    pub struct Plant {
        /// Set of the true force and roughness models; choosing one also sets the controller's.
        model_set: ModelSet = ModelSet::Sdnrp2007, [], "", live, "Model set";
        /// What gives the true cutting force; choosing it tooth by tooth also sets the controller's
        /// models to those identified on it.
        force_model: ForceModel = ForceModel::Formula, [], "", live, "Force model";
        /// Calibration of the true force and roughness models.
        calibration: Calibration = Calibration::Identified, [], "", live, "Calibration";
        /// Workpiece material; choosing one sets the hardness to its reference value.
        material: Material = Material::Ck45, [], "", live, "Material";
        /// Brinell hardness of the workpiece.
        hardness_hb: f64 = 200.0, [60.0, 500.0], "HB", live, "Hardness";
        /// Factor of tool wear on the force: 1 for a sharp tool.
        wear_factor: f64 = 1.0, [1.0, 2.0], "", live, "Wear factor";
        /// Added to the force of the formula (an error of its intercept) or of the network, for
        /// experiments on model mismatch; a plan does not know of it.
        force_offset_n: f64 = 0.0, [-100.0, 100.0], "N", live, "Force offset";
        /// Run-out of the cutter: its axis is shifted by this towards the first tooth, so of two one stands
        /// out and one in; tooth by tooth only.
        runout_um: f64 = 3.0, [0.0, 50.0], "um", live, "Run-out";
        /// Height of the cutter's slices; tooth by tooth only. It is part of the calibration.
        slice_mm: f64 = 0.25, [0.05, 1.0], "mm", live, "Slice height";
    }
}

/// The tool in the plant's material. Materials but the two of the 2005 paper are Ck45
/// times the ratio of their forces, hardness included.
fn milling_setup(plant: &Plant, tool: &Tool, dt_s: f64) -> MillingSetup {
    let (steel, base) = match plant.material {
        Material::MnCrSi5 => (MNCRSI5, Material::MnCrSi5),
        _ => (CK45, Material::Ck45),
    };
    let factor =
        plant.material.force_factor(plant.hardness_hb) / base.force_factor(base.hardness_hb());
    MillingSetup {
        cutter: Cutter::new(tool, mm_from_um(plant.runout_um), plant.slice_mm),
        steel,
        rake_deg: tool.rake_deg,
        hardness_hb: steel.hardness_hb,
        factor,
        dt_s,
    }
}

/// Cross-section of the cut for each millimetre of axial depth, over that at which the formula of
/// the set holds, 1/mm.
fn engagement_per_mm(models: &GeneticModels, radial_depth_mm: f64) -> f64 {
    let [axial_mm, radial_mm] = models.set.engagement_mm();
    radial_depth_mm / (axial_mm * radial_mm)
}

/// The cutting process set up from plant and workpiece settings.
#[derive(Clone, Debug)]
pub struct Process {
    outline: Outline,
    models: GeneticModels,
    /// Force factor per millimetre of axial depth, for the formula.
    factor_per_mm: f64,
    radial_depth_mm: f64,
    /// Material times wear.
    share: f64,
    /// In place of the formula.
    neural: Option<Box<NeuralLaw>>,
    milling: Option<Box<Milling>>,
    wear_factor: f64,
    /// Factor of the wear over the tool's life.
    life_factor: f64,
    offset_n: f64,
}

impl Process {
    /// The process for a plant with a tool at a radial depth of cut in mm, for steps of `dt_s` and axial depths
    /// up to `depth_max_mm`.
    #[must_use]
    pub fn new(
        plant: &Plant,
        tool: &Tool,
        radial_depth_mm: f64,
        depth_max_mm: f64,
        dt_s: f64,
    ) -> Self {
        let models = GeneticModels::new(plant.model_set, plant.calibration);
        let mut models = models.for_tool(tool);
        models.force.intercept_n += plant.force_offset_n;
        let engagement = engagement_per_mm(&models, radial_depth_mm);
        let material = plant.material.force_factor(plant.hardness_hb);
        let depths_mm = [AXIAL_DEPTH_2007_MM, radial_depth_mm];
        let cut = NeuralCut::new(tool, plant.material, plant.hardness_hb, depths_mm);
        let neural = plant.force_model.network().map(|kind| Box::new(NeuralLaw::new(kind, cut)));
        let by_teeth = plant.force_model.tooth_by_tooth();
        let setup = || milling_setup(plant, tool, dt_s);
        let milling = by_teeth.then(|| Box::new(Milling::new(&setup(), depth_max_mm)));
        Self {
            outline: tool.outline(),
            models,
            factor_per_mm: material * plant.wear_factor * engagement,
            radial_depth_mm,
            share: material * plant.wear_factor,
            neural,
            milling,
            wear_factor: plant.wear_factor,
            life_factor: 1.0,
            offset_n: plant.force_offset_n,
        }
    }

    /// Takes the factor of the wear over the tool's life; see [`super::wear`].
    pub fn set_life_factor(&mut self, factor: f64) {
        self.life_factor = factor;
    }

    /// The true models, for the surface block.
    #[must_use]
    pub fn models(&self) -> &GeneticModels {
        &self.models
    }

    /// Whether the tool is in the material at this axial depth in mm; otherwise it is in the air.
    #[must_use]
    pub fn engaged(&self, axial_depth_mm: f64) -> bool {
        self.factor_per_mm * axial_depth_mm > 0.0
    }

    /// The forces of this instant in N, if the mechanistic model gives them: see
    /// [`Milling::update`]; `dynamic` is the factor of the dynamic component.
    #[inline]
    pub fn mill(
        &mut self,
        feed_mm_min: f64,
        speed_rpm: f64,
        (cut, x_mm): (&CutPath, f64),
        dynamic: f64,
    ) -> Option<[f64; 3]> {
        let factor = self.wear_factor * self.life_factor * math::positive(dynamic);
        let milling = self.milling.as_deref_mut()?;
        Some(milling.update(feed_mm_min, speed_rpm, x_mm, cut, factor))
    }

    /// Takes the compliance of the force tooth by tooth away: a machine that is coupled to the cut has
    /// its own, and counted twice the tool would be too soft.
    pub fn stiffen(&mut self) {
        if let Some(milling) = &mut self.milling {
            milling.stiffen();
        }
    }

    /// The spindle's turn at the last instant, from 0 to below 1, where there are teeth.
    #[must_use]
    pub fn spindle_turn(&self) -> Option<f64> {
        self.milling.as_deref().map(Milling::spindle_turn)
    }

    /// A new cut begins.
    pub fn restart(&mut self) {
        if let Some(milling) = &mut self.milling {
            milling.restart();
        }
    }

    /// Takes over settings changed in the cut; a turning cutter goes on.
    pub fn reconfigure(
        &mut self,
        plant: &Plant,
        tool: &Tool,
        place: &Engagement,
        depth_max_mm: f64,
        dt_s: f64,
    ) {
        let before = self.milling.take();
        let life_factor = self.life_factor;
        *self = Self::new(plant, tool, place.radial_depth_mm, depth_max_mm, dt_s);
        self.life_factor = life_factor;
        if let (Some(before), Some(now)) = (before, &mut self.milling) {
            now.take_over(&before);
        }
    }

    /// The maximum cutting force in N by formula or network.
    #[inline]
    #[must_use]
    pub fn update(&mut self, feed_mm_min: f64, speed_rpm: f64, place: &Engagement) -> Valued {
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
            let force_n = (peak.value + self.offset_n) * self.wear_factor * self.life_factor;
            return Valued::new(math::positive(force_n), peak.valid);
        }
        let base = self.models.force(feed_mm_min, speed_rpm);
        Valued::new(base.value * self.factor_per_mm * axial_depth_mm * self.life_factor, base.valid)
    }

    /// The same with the tool's axis at `x_mm` along a cut of sections: see [`contact`].
    pub fn update_along(
        &mut self,
        feed_mm_min: f64,
        speed_rpm: f64,
        (cut, x_mm): (&CutPath, f64),
    ) -> Valued {
        let outline = self.outline;
        let force_in = |place: &Engagement| self.update(feed_mm_min, speed_rpm, place);
        contact::force_along(&outline, cut, x_mm, force_in)
    }
}
