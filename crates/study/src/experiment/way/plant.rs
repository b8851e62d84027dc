//! The plant of the way, as a scenario; what it is, in words.

use super::{WayPlant, WaySettings};
use crate::base::language::tr;
use crate::blocks::cutting::process::ForceModel;
use crate::models::genetic::{Calibration, ModelSet};
use crate::run::scenario::{Scenario, Settings};

/// Plant steps of a control period tooth by tooth: 28.8 kHz.
const TOOTH_STEPS: u32 = 576;

impl WaySettings {
    /// What gives the force.
    ///
    /// # Errors
    /// The papers' formula for a cutter that it does not know.
    pub fn chosen_plant(&self) -> Result<WayPlant, String> {
        let papers = self.tool.load().tool.cuts_as_in_the_papers();
        let steel =
            Scenario::default().plant.material == self.material && self.hardness_hb.is_none();
        match self.plant {
            Some(WayPlant::Formula) if !papers => Err(tr!(
                "plant: formula: the papers' K4 does not know the cutter {tool}: allowed is {allowed}",
                tool = self.tool.id(),
                allowed = WayPlant::Mechanistic.id()
            )),
            Some(plant) => Ok(plant),
            None if papers && steel => Ok(WayPlant::Formula),
            None => Ok(WayPlant::Mechanistic),
        }
    }

    /// The plant as a scenario; what pilot cuts find is as it is by default.
    ///
    /// # Errors
    /// Names the setting, its value and what is allowed.
    pub fn scenario(&self) -> Result<Scenario, String> {
        let plant = self.chosen_plant()?;
        let change = |s: &mut Settings| {
            s.tool = crate::models::tool::Tool { name: self.tool, ..self.tool.load().tool };
            s.plant.material = self.material;
            s.plant.hardness_hb = self.hardness_hb.unwrap_or(self.material.hardness_hb());
            s.plant.force_model = match plant {
                WayPlant::Formula => ForceModel::Formula,
                WayPlant::Mechanistic => ForceModel::Mechanistic,
            };
            if plant == WayPlant::Mechanistic {
                s.run.steps_per_control = TOOTH_STEPS;
            }
            s.run.record_every = s.run.steps_per_control;
            s.plant.calibration = Calibration::Identified;
            s.belief.model_set = ModelSet::Sdnrp2007;
            s.belief.calibration = Calibration::Identified;
            if let Some(depth_mm) = self.axial_depth_mm {
                s.workpiece.axial_depth_mm = depth_mm;
            }
            if let Some(depth_mm) = self.radial_depth_mm {
                s.workpiece.radial_depth_mm = depth_mm;
            }
        };
        Scenario::default().with(change).map_err(|error| error.to_string())
    }

    /// What the truth is, in words.
    ///
    /// # Errors
    /// As [`Self::chosen_plant`].
    pub fn truth(&self) -> Result<String, String> {
        let force = match self.chosen_plant()? {
            WayPlant::Formula => {
                tr("the papers' K4 with its intercept restored, times the factor of material and hardness").to_owned()
            }
            WayPlant::Mechanistic => tr!(
                "tooth by tooth, the mechanistic model of the cutter {tool} in {material} (Kienzle's laws; materials \
                 but Ck45 and 16MnCrSi5 by the ratio of their forces), its largest value of each control period",
                tool = self.tool.id(),
                material = tr(self.material.label())
            ),
        };
        Ok(tr!(
            "force: {force}; Ra: what that force leaves by the papers' K5, which no measurement confirms for another \
             cutter or material",
            force = force
        ))
    }
}
