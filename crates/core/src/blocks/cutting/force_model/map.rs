//! Force models that are maps: functions of feed, speed and engagement.
//!
//! | path | force of a plant step |
//! |---|---|
//! | one path | the map where the tool is |
//! | several cuts | the same where the cutter meets their sections ([`contact`]), with air between them |

use super::law::{ForceModelLaw, ForceMoment, ForceSetup};
use crate::base::equation::Live;
use crate::base::math;
use crate::blocks::cutting::contact;
use crate::blocks::cutting::process::{CutStep, Force, PlantSettings};
use crate::blocks::cutting::tool_path::Engagement;
use crate::models::Valued;
use crate::models::feed_speed::FeedSpeed;
use crate::models::genetic::{FormulaSettings, ModelSet};
use crate::models::neural_force::NeuralKind;
use crate::models::printed::Printed;
use crate::models::tool::{Outline, Tool};

/// A map of the force; see [`ForceModelLaw`] for what is not said here.
pub trait MapLaw: Clone + std::fmt::Debug {
    /// See [`ForceModelLaw::ABOUT`].
    const ABOUT: &'static str;
    /// See [`ForceModelLaw::NETWORK`].
    const NETWORK: Option<NeuralKind> = None;
    /// See [`ForceModelLaw::FORMULA`].
    const FORMULA: bool = false;

    /// The map of a plant with a tool at a radial depth of cut in mm.
    fn new(plant: &PlantSettings, tool: &Tool, radial_depth_mm: f64) -> Self;

    /// The same with formulas of one's own, where it is the formula of a model set.
    #[must_use]
    fn with_formulas(self, _: &PlantSettings, _: &FormulaSettings) -> Self {
        self
    }

    /// The largest force of a revolution in N at feed in mm/min, speed in 1/min and an engagement, 0 in the
    /// air; `life_factor` is that of the wear over the tool's life.
    fn force(
        &mut self,
        feed_mm_min: f64,
        speed_rpm: f64,
        place: &Engagement,
        life_factor: f64,
    ) -> Valued;

    /// See [`ForceModelLaw::short_name`].
    #[must_use]
    fn short_name(set: ModelSet) -> String;

    /// See [`ForceModelLaw::printed`].
    #[must_use]
    fn printed(set: ModelSet) -> &'static [Printed];

    /// See [`ForceModelLaw::explain`].
    #[must_use]
    fn explain(moment: &ForceMoment) -> Vec<Live>;
}

/// A map along one path, or along the sections of several cuts.
#[derive(Clone, Debug)]
pub struct Mapped<M> {
    map: M,
    outline: Outline,
    several: bool,
    /// Exponent of the feed per tooth in the force of Kienzle's law, 1 - m_c.
    feed_exponent: f64,
}

/// Whether the tool is in the material; otherwise it is in the air.
pub(super) fn engaged(place: &Engagement) -> bool {
    place.axial_depth_mm > 0.0 && place.radial_depth_mm > 0.0
}

impl<M: MapLaw> ForceModelLaw for Mapped<M> {
    const ABOUT: &'static str = M::ABOUT;
    const MAP: bool = true;
    const NETWORK: Option<NeuralKind> = M::NETWORK;
    const FORMULA: bool = M::FORMULA;

    fn new(setup: &ForceSetup) -> Self {
        Self {
            map: M::new(setup.plant, setup.tool, setup.radial_depth_mm)
                .with_formulas(setup.plant, setup.formulas),
            outline: setup.tool.outline(),
            several: setup.several,
            feed_exponent: setup.plant.material.feed_exponent(),
        }
    }

    /// The largest force of a revolution is that of the tooth behind the broken ones: it cuts their feed as well as
    /// its own, and by Kienzle's law the force grows with the power 1 - m_c of the chip. The map itself is not
    /// asked at so large a feed: it ends long before.
    fn break_teeth(&mut self, broken: usize) -> f64 {
        if broken == 0 { 1.0 } else { math::pow((1 + broken) as f64, self.feed_exponent) }
    }

    #[inline]
    fn cut(&mut self, step: &CutStep, dynamic: impl FnOnce() -> f64) -> Force {
        let CutStep { feed_mm_min, speed_rpm, life_factor, .. } = *step;
        let map = &mut self.map;
        let mut force_in =
            |place: &Engagement| map.force(feed_mm_min, speed_rpm, place, life_factor);
        let (model, air) = if !(FeedSpeed { feed_mm_min, speed_rpm }).feeds() {
            // Maps end at a least feed; a standing tool lifts no chip.
            (Force::NONE.model, true)
        } else if self.several {
            let (cut, x_mm) = step.under;
            let model = contact::force_along(&self.outline, cut, x_mm, force_in);
            (model, model.value < step.air_n)
        } else {
            (force_in(&step.place), !engaged(&step.place))
        };
        // After the force, which takes long and does not wait for it: the processor then works on both at once.
        let dynamic_n = math::positive(model.value * dynamic());
        Force { model, dynamic_n, air }
    }

    fn at(
        setup: &ForceSetup,
        feed_mm_min: f64,
        speed_rpm: f64,
        place: &Engagement,
    ) -> Option<Valued> {
        let mut map = M::new(setup.plant, setup.tool, place.radial_depth_mm)
            .with_formulas(setup.plant, setup.formulas);
        Some(map.force(feed_mm_min, speed_rpm, place, 1.0))
    }

    fn short_name(set: ModelSet) -> String {
        M::short_name(set)
    }

    fn printed(set: ModelSet) -> &'static [Printed] {
        M::printed(set)
    }

    fn explain(moment: &ForceMoment) -> Vec<Live> {
        M::explain(moment)
    }
}
