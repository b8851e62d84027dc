//! The cutting process: from feed, speed and engagement to the force of the cut, by one of the models of
//! [`super::force_model`].
//!
//! | model | force of a plant step |
//! |---|---|
//! | a map | the largest of a revolution, by formula or network |
//! | a map of several cuts | the same where the ball meets their sections ([`super::contact`]) |
//! | tooth by tooth | that of the instant, its maximum held for a control period ([`super::milling`]) |
//!
//! What is one force to everything behind it stands in [`Force`]; what the teeth do at the instant stays with
//! the process that simulates them. The dynamic component multiplies the maximum of a map and every instant of
//! the teeth: only a map's force is known without it. However large the noise, the size of a force is not
//! negative.

use super::force_model::law::ForceSetup;
pub use super::force_model::{ForceModel, Process};
use super::material::Material;
use super::tool_path::{Engagement, ToolPath};
use crate::models::Valued;
use crate::models::genetic::{Calibration, FormulaSettings, ModelSet};
use crate::models::part::CutPath;
use crate::models::tool::Tool;

crate::settings! {
    /// The plant: what really is cut, whatever the controller believes.
    pub struct PlantSettings {
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
        /// Height of the cutter's slices; tooth by tooth only. It is part of the calibration.
        slice_mm: f64 = 0.25, [0.05, 1.0], "mm", live, "Slice height";
    }
}

/// The force on the tool over a plant step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Force {
    /// The largest of the control window by the plant's model, N: a map gives it at once, without the
    /// dynamic component; tooth by tooth it is that of the last whole control period, without vibration.
    pub model: Valued,
    /// The same with all that shakes it, N: dynamic component and vibration.
    pub dynamic_n: f64,
    /// No chip is cut: the tool is in the air, or stands.
    pub air: bool,
}

impl Force {
    /// No force, because no chip is cut.
    pub const NONE: Self =
        Self { model: Valued { value: 0.0, valid: true }, dynamic_n: 0.0, air: true };
}

/// What a plant step cuts.
#[derive(Clone, Copy, Debug)]
pub struct CutStep<'a> {
    /// Number of the step.
    pub tick: u64,
    /// Actual feed, mm/min.
    pub feed_mm_min: f64,
    /// Actual speed, 1/min.
    pub speed_rpm: f64,
    /// Engagement at the tool's axis.
    pub place: Engagement,
    /// The cut under the tool, and where along it the axis is, mm.
    pub under: (&'a CutPath, f64),
    /// Factor of the wear over the tool's life.
    pub life_factor: f64,
    /// Force below which a tool that goes through cuts with air between them counts as in the air, N.
    pub air_n: f64,
}

impl Process {
    /// The process of a plant, with own formulas of its models, with a tool along a path at a radial depth in mm, in steps of `dt_s`, `window` to a
    /// control period.
    #[must_use]
    pub fn new(
        plant: &PlantSettings,
        formulas: &FormulaSettings,
        tool: &Tool,
        path: &ToolPath,
        radial_depth_mm: f64,
        dt_s: f64,
        window: u64,
    ) -> Self {
        Self::of(&ForceSetup {
            plant,
            formulas,
            tool,
            radial_depth_mm,
            several: path.is_several(),
            depth_max_mm: path.depth_max_mm(),
            dt_s,
            window,
        })
    }
}
