//! The surface as it is left by the tool: Ra by the force, with what vibration adds.
//!
//! ```text
//! Ra     = K5(F)
//! Ra_dyn = K6(F_dyn),  or  Ra + what the teeth's marks add     of a coupled machine, where it is set so
//! ```

use super::finish::Finish;
use super::roughness;
use crate::models::Valued;
use crate::models::genetic::GeneticModels;
use crate::models::roughness_profile::ProfileSettings;

/// Where the tooth was at the end of a machine step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToothPlace {
    /// Turns of the spindle in the step.
    pub turns: f64,
    /// Position along the path, mm.
    pub position_mm: f64,
    /// Displacement off the work, m.
    pub displacement_m: f64,
    /// The tool is in the material.
    pub in_cut: bool,
}

/// The surface behind the tool.
#[derive(Clone, Debug)]
pub struct Surface {
    models: GeneticModels,
    /// The teeth's marks, where Ra with dynamics is to come from them.
    finish: Option<Box<Finish>>,
}

impl Surface {
    /// The surface by the plant's true models.
    #[must_use]
    pub fn new(models: GeneticModels, finish: Option<Finish>) -> Self {
        Self { models, finish: finish.map(Box::new) }
    }

    /// Takes over other models and changed settings of the profile.
    pub fn reconfigure(&mut self, models: GeneticModels, profile: &ProfileSettings) {
        self.models = models;
        if let Some(finish) = &mut self.finish {
            finish.reconfigure(profile);
        }
    }

    /// A new cut begins.
    pub fn restart(&mut self) {
        if let Some(finish) = &mut self.finish {
            finish.clear();
        }
    }

    /// Takes a step of a machine that vibrates.
    #[inline]
    pub fn pass(&mut self, at: &ToothPlace) {
        if let Some(finish) = &mut self.finish {
            finish.update(at.turns, at.position_mm, at.displacement_m, at.in_cut);
        }
    }

    /// Ra and Ra with dynamics in um that a force in N leaves, without and with what shakes it.
    #[inline]
    pub fn leave(&mut self, force_n: f64, force_dyn_n: f64, air: bool) -> [Valued; 2] {
        if air {
            self.restart();
            return [Valued::new(0.0, true); 2];
        }
        let (ra, ra_dyn) = roughness::produced(force_n, force_dyn_n, &self.models);
        match &self.finish {
            Some(finish) => [ra, roughness::with_marks(ra, finish.added_um())],
            None => [ra, ra_dyn],
        }
    }
}
