//! The neural force model (2013, section 2.3) in its network trained for accuracy.
//!
//! ```text
//! F = (|F_xy|(f_a, n_a, R_D, A_D, material, HB, tool) + offset) x wear
//! ```
//!
//! The network knows depths and material itself ([`crate::blocks::cutting::neural`]); wear multiplies its
//! force as well. What is said here of one network holds for every one of them ([`NetworkMap`]).

use super::law::ForceMoment;
use super::map::{MapLaw, Mapped, engaged};
use super::network_card;
use crate::base::equation::Live;
use crate::base::language::text;
use crate::base::math;
use crate::blocks::cutting::neural::{NeuralCut, NeuralLaw};
use crate::blocks::cutting::process::PlantSettings;
use crate::blocks::cutting::tool_path::Engagement;
use crate::blocks::cutting::workpiece::AXIAL_DEPTH_2007_MM;
use crate::models::Valued;
use crate::models::genetic::{FormulaSettings, ModelSet};
use crate::models::neural_force::NeuralKind;
use crate::models::printed::Printed;
use crate::models::tool::Tool;

const PRINTED: &[Printed] = &[Printed::new(
    "F_x, F_y, F_z = NN(f, n, R_D, A_D, material, hardness, D, geometry)",
    text!(
        "Control strategy 2013, section 2.3: 8 inputs, 15 hidden neurons, 3 outputs; its weights were \
     never published"
    ),
)];

/// A network that gives a force: which one it is.
pub trait MappedNetwork: Clone + std::fmt::Debug {
    /// See [`MapLaw::ABOUT`].
    const ABOUT: &'static str;
    /// The shipped network.
    const KIND: NeuralKind;
}

/// The network trained for accuracy.
#[derive(Clone, Copy, Debug)]
pub struct Improved;

impl MappedNetwork for Improved {
    const ABOUT: &'static str = "The 8-15-3 network trained for accuracy.";
    const KIND: NeuralKind = NeuralKind::Improved;
}

/// The force model.
pub type Neural = Mapped<NetworkMap<Improved>>;

/// The map of a network in a plant.
#[derive(Clone, Debug)]
pub struct NetworkMap<N> {
    law: NeuralLaw,
    wear_factor: f64,
    offset_n: f64,
    network: std::marker::PhantomData<N>,
}

impl<N: MappedNetwork> MapLaw for NetworkMap<N> {
    const ABOUT: &'static str = N::ABOUT;
    const NETWORK: Option<NeuralKind> = Some(N::KIND);

    fn new(plant: &PlantSettings, tool: &Tool, radial_depth_mm: f64) -> Self {
        let depths_mm = [AXIAL_DEPTH_2007_MM, radial_depth_mm];
        let cut = NeuralCut::new(tool, plant.material, plant.hardness_hb, depths_mm);
        Self {
            law: NeuralLaw::new(N::KIND, cut),
            wear_factor: plant.wear_factor,
            offset_n: plant.force_offset_n,
            network: std::marker::PhantomData,
        }
    }

    fn with_formulas(mut self, plant: &PlantSettings, formulas: &FormulaSettings) -> Self {
        if let Some(material) = formulas.material_factor(plant.hardness_hb) {
            self.law = NeuralLaw::new(N::KIND, self.law.cut().of_ck45_times(material));
        }
        self
    }

    #[inline]
    fn force(
        &mut self,
        feed_mm_min: f64,
        speed_rpm: f64,
        place: &Engagement,
        life_factor: f64,
    ) -> Valued {
        if !engaged(place) {
            // No cut, and so none that the network does not know.
            return Valued::new(0.0, true);
        }
        let depths_mm = [place.axial_depth_mm, place.radial_depth_mm];
        let peak = self.law.update(feed_mm_min, speed_rpm, depths_mm);
        if peak.value == 0.0 {
            return peak;
        }
        let force_n = (peak.value + self.offset_n) * self.wear_factor * life_factor;
        // An offset may ask for less than no force: as of the formula, that is outside its range.
        Valued::new(math::positive(force_n), peak.valid && force_n >= 0.0)
    }

    /// As in the paper of 2013.
    fn short_name(_: ModelSet) -> String {
        "NN".to_owned()
    }

    fn printed(_: ModelSet) -> &'static [Printed] {
        PRINTED
    }

    fn explain(moment: &ForceMoment) -> Vec<Live> {
        let mut map = Self::new(moment.plant, moment.tool, moment.place.radial_depth_mm)
            .with_formulas(moment.plant, moment.formulas);
        let force = map.force(moment.feed_mm_min, moment.speed_rpm, &moment.place, 1.0);
        network_card::lines(N::KIND, moment, force)
    }
}
