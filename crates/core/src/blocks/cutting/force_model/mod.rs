//! Force models: what gives the plant's cutting force, and what follows from the choice for everything
//! around it.
//!
//! A force model is one file here and one line in the list below (CONTRIBUTING.md shows how). Its file says
//! all that the program knows of it ([`law::ForceModelLaw`]): its kind, the force, the steps that it needs, and its
//! equations in words.

#[macro_use]
mod registry;

pub mod law;
pub mod map;
mod network_card;

use std::sync::LazyLock;

use super::process::{CutStep, Force};
use super::tool_path::Engagement;
use crate::base::equation::Live;
use crate::models::Valued;
use crate::models::genetic::ModelSet;
use crate::models::mechanistic::Cutting;
use crate::models::neural_force::NeuralKind;
use crate::models::printed::Printed;
use law::{ForceModelLaw, ForceMoment, ForceSetup};

// Module, type, id in files and on the command line, name for people; in the order of files and lists.
force_models! {
    formula::Formula = "formula", "Formula (K4, M4)";
    neural::Neural = "neural", "Neural network";
    neural_literal::NeuralLiteral = "neural_literal", "Neural network as in the paper";
    mechanistic::Mechanistic = "mechanistic", "Tooth by tooth";
}

impl ForceModel {
    /// The force models that are functions of feed, speed and depth, as published tables need them.
    #[must_use]
    pub fn maps() -> &'static [Self] {
        static MAPS: LazyLock<Vec<ForceModel>> = LazyLock::new(|| {
            ForceModel::ALL.iter().copied().filter(|model| model.is_map()).collect()
        });
        &MAPS
    }

    /// Whether the force is simulated instant by instant, with the teeth that make it: it then has
    /// run-out, slices, an angle of the spindle and a force along each axis.
    #[must_use]
    pub fn tooth_by_tooth(self) -> bool {
        !self.is_map()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blocks::cutting::process::PlantSettings;
    use crate::models::genetic::FormulaSettings;
    use crate::models::tool::Tool;

    #[test]
    fn published_tables_have_the_formula_and_the_networks() {
        let maps = [ForceModel::Formula, ForceModel::Neural, ForceModel::NeuralLiteral];
        assert_eq!(ForceModel::maps(), maps);
        assert!(ForceModel::Mechanistic.tooth_by_tooth());
    }

    #[test]
    fn an_offset_that_asks_for_less_than_no_force_is_marked_on_every_map() {
        for force_model in ForceModel::maps().iter().copied() {
            let place = Engagement { axial_depth_mm: 2.0, radial_depth_mm: 3.0 };
            let force = |force_offset_n: f64| {
                let plant =
                    PlantSettings { force_model, force_offset_n, ..PlantSettings::default() };
                let setup = ForceSetup {
                    plant: &plant,
                    formulas: &FormulaSettings::default(),
                    tool: &Tool::default(),
                    radial_depth_mm: 3.0,
                    several: false,
                    depth_max_mm: 2.0,
                    dt_s: 1e-3,
                    window: 20,
                };
                force_model.at(&setup, 330.0, 1600.0, &place).unwrap()
            };
            assert!(force(0.0).valid && force(0.0).value > 100.0, "{force_model:?}");
            let least = force(-1e4);
            assert_eq!((least.value, least.valid), (0.0, false), "{force_model:?}");
        }
    }

    #[test]
    fn what_is_simulated_by_the_teeth_needs_short_steps_and_its_own_models() {
        for model in ForceModel::ALL {
            assert_eq!(model.tooth_by_tooth(), model.longest_step_s().is_finite(), "{model:?}");
            assert_eq!(model.tooth_by_tooth(), model.identified_set().is_some(), "{model:?}");
        }
    }
}
