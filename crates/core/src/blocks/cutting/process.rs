//! The cutting process: from feed, speed and engagement to the force of the cut, by one of its kinds.
//!
//! | kind | force of a plant step |
//! |---|---|
//! | map | the largest of a revolution, by formula or network ([`super::force_map`]) |
//! | sections | the same where the ball meets the sections of a cut ([`super::contact`]) |
//! | tooth by tooth | that of the instant, its maximum held for a control period ([`super::milling`]) |
//!
//! What is one force to everything behind it stands in [`Force`]. The dynamic component multiplies the
//! maximum of a map and every instant of the teeth: only a map's force is known without it.

pub use super::force_model::ForceModel;

use super::contact;
use super::force_map::ForceMap;
use super::material::Material;
use super::milling::{Milling, MillingSetup};
use super::tool_path::{Engagement, ToolPath};
use crate::base::math;
use crate::base::units::mm_from_um;
use crate::base::window::WindowMax;
use crate::models::Valued;
use crate::models::ball_end::{CK45, Cutter, Cutting, MAX_TEETH, MNCRSI5};
use crate::models::genetic::{Calibration, ModelSet};
use crate::models::part::CutPath;
use crate::models::spindle::SLOWEST_RPM;
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

/// The tool in the plant's material. Materials but the two of the 2005 paper are Ck45
/// times the ratio of their forces, hardness included.
fn milling_setup(plant: &PlantSettings, tool: &Tool, dt_s: f64) -> MillingSetup {
    let (steel, base) = match plant.material {
        Material::MnCrSi5 => (MNCRSI5, Material::MnCrSi5),
        Material::Ck45
        | Material::S235
        | Material::Crmo42
        | Material::X5CrNi
        | Material::NiCrMoV
        | Material::Gjl250
        | Material::Gjs600
        | Material::Al7075
        | Material::Brass
        | Material::Ti64 => (CK45, Material::Ck45),
    };
    let factor =
        plant.material.force_factor(plant.hardness_hb) / base.force_factor(base.hardness_hb());
    MillingSetup {
        cutter: Cutter::new(tool, mm_from_um(tool.runout_um), plant.slice_mm),
        steel,
        rake_deg: tool.rake_deg,
        hardness_hb: steel.hardness_hb,
        factor,
        dt_s,
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
    /// F_x, F_y, F_z of this instant in N, tooth by tooth.
    pub teeth_n: Option<[f64; 3]>,
    /// Height of the edges in the cut in mm by the tooth before that left the surface, tooth by tooth
    /// ([`crate::models::ball_end::Cutting`]).
    pub height_mm: [f64; MAX_TEETH],
    /// The tool is in the air.
    pub air: bool,
}

impl Force {
    /// No force: the tool has not begun to cut.
    pub const NONE: Self = Self {
        model: Valued { value: 0.0, valid: true },
        dynamic_n: 0.0,
        teeth_n: None,
        height_mm: [0.0; MAX_TEETH],
        air: true,
    };

    /// F_x and F_y of this instant, N; of a map its largest force.
    #[must_use]
    #[inline]
    pub fn across_n(&self) -> [f64; 2] {
        match self.teeth_n {
            Some([x, y, _]) => [x, y],
            None => [self.dynamic_n, 0.0],
        }
    }

    /// The force across the tool that acts in this plant step, N.
    #[must_use]
    #[inline]
    pub fn acting_n(&self) -> f64 {
        match self.teeth_n {
            Some([x, y, _]) => (x * x + y * y).sqrt(),
            None => self.dynamic_n,
        }
    }
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
    /// Factor of the dynamic component.
    pub dynamic: f64,
    /// Factor of the wear over the tool's life.
    pub life_factor: f64,
    /// Force below which a tool that goes through cuts with air between them counts as in the air, N.
    pub air_n: f64,
}

/// The teeth with the largest of what they make.
#[derive(Clone, Debug)]
pub struct Teeth {
    milling: Milling,
    largest: WindowMax<1>,
    wear_factor: f64,
}

/// The cutting process by its kind.
#[derive(Clone, Debug)]
pub enum Process {
    /// A map of feed and speed along one path.
    Map(Box<ForceMap>),
    /// A map along the sections of several cuts, with air between them.
    Sections(Box<ForceMap>),
    /// Tooth by tooth.
    Teeth(Box<Teeth>),
}

impl Process {
    /// The process of a plant with a tool along a path at a radial depth in mm, in steps of `dt_s`, `window` to a
    /// control period.
    #[must_use]
    pub fn new(
        plant: &PlantSettings,
        tool: &Tool,
        path: &ToolPath,
        radial_depth_mm: f64,
        dt_s: f64,
        window: u64,
    ) -> Self {
        match plant.force_model {
            ForceModel::Formula | ForceModel::Neural | ForceModel::NeuralLiteral => {
                let map = Box::new(ForceMap::new(plant, tool, radial_depth_mm));
                if path.is_several() { Self::Sections(map) } else { Self::Map(map) }
            }
            ForceModel::Mechanistic => Self::Teeth(Box::new(Teeth {
                milling: Milling::new(&milling_setup(plant, tool, dt_s), path.depth_max_mm()),
                largest: WindowMax::new(window),
                wear_factor: plant.wear_factor,
            })),
        }
    }

    /// Takes over settings changed in the cut; a turning cutter goes on.
    pub fn reconfigure(&mut self, mut now: Self) {
        if let (Self::Teeth(before), Self::Teeth(now)) = (&*self, &mut now) {
            now.milling.take_over(&before.milling);
            now.largest = before.largest.clone();
        }
        *self = now;
    }

    /// Takes the compliance of the force tooth by tooth away: a machine that is coupled to the cut has
    /// its own, and counted twice the tool would be too soft.
    pub fn make_rigid(&mut self) {
        match self {
            Self::Map(_) | Self::Sections(_) => {}
            Self::Teeth(teeth) => teeth.milling.make_rigid(),
        }
    }

    /// A new cut begins.
    pub fn restart(&mut self) {
        match self {
            Self::Map(_) | Self::Sections(_) => {}
            Self::Teeth(teeth) => {
                teeth.milling.restart();
                teeth.largest.restart();
            }
        }
    }

    /// The spindle's turn at the last instant, from 0 to below 1, where there are teeth.
    #[must_use]
    pub fn spindle_turn(&self) -> Option<f64> {
        match self {
            Self::Map(_) | Self::Sections(_) => None,
            Self::Teeth(teeth) => Some(teeth.milling.spindle_turn()),
        }
    }

    /// The force of a plant step, before any machine vibrates.
    #[inline]
    pub fn cut(&mut self, step: &CutStep) -> Force {
        let CutStep { feed_mm_min, speed_rpm, life_factor, dynamic, .. } = *step;
        match self {
            Self::Map(map) => {
                let model = map.force(feed_mm_min, speed_rpm, &step.place, life_factor);
                let air = !map.engaged(step.place.axial_depth_mm);
                Force {
                    model,
                    dynamic_n: math::positive(model.value * dynamic),
                    teeth_n: None,
                    height_mm: [0.0; MAX_TEETH],
                    air,
                }
            }
            Self::Sections(map) => {
                let (cut, x_mm) = step.under;
                let model = contact::force_along(&map.outline(), cut, x_mm, |place| {
                    map.force(feed_mm_min, speed_rpm, place, life_factor)
                });
                let air = model.value < step.air_n;
                Force {
                    model,
                    dynamic_n: math::positive(model.value * dynamic),
                    teeth_n: None,
                    height_mm: [0.0; MAX_TEETH],
                    air,
                }
            }
            Self::Teeth(teeth) => {
                let (cut, x_mm) = step.under;
                let factor = teeth.wear_factor * life_factor * math::positive(dynamic);
                let Cutting { forces_n, height_mm } =
                    teeth.milling.update(feed_mm_min, speed_rpm, x_mm, cut, factor);
                let [x, y, _] = forces_n;
                let [largest_n] = teeth.largest.push(step.tick, [(x * x + y * y).sqrt()]);
                Force {
                    model: Valued::new(largest_n, speed_rpm >= SLOWEST_RPM),
                    dynamic_n: largest_n,
                    teeth_n: Some(forces_n),
                    height_mm,
                    air: largest_n < step.air_n,
                }
            }
        }
    }
}
