//! The formula of the model set, K4 (2007, eq. 7) or M4 (2013, eq. 5), times what it does not know.
//!
//! ```text
//! F = (K4(f_a, n_a) + offset) x material(HB) x (A_D R_D) / (A_0 R_0) x wear
//! ```
//!
//! K4 and M4 belong to Ck45 at A_0 2 mm and R_0 3 mm with a sharp tool (those of the milling simulator
//! to its reference cut); force is taken as proportional to the cross-section (chosen).

use super::law::ForceMoment;
use super::map::{MapLaw, Mapped};
use crate::base::equation::{Live, number};
use crate::base::language::{text, tr};
use crate::blocks::cutting::process::PlantSettings;
use crate::blocks::cutting::tool_path::Engagement;
use crate::models::Valued;
use crate::models::formula_model::FormulaModel;
use crate::models::genetic::force_formula::{FEED_MIN_MM_MIN, INCH, SPEED_MIN_RPM};
use crate::models::genetic::{FormulaSettings, GeneticModels, ModelSet, OwnModels};
use crate::models::printed::Printed;
use crate::models::tool::Tool;

const K4: &[Printed] = &[Printed::new(
    "F = 286.44 - 5.82·10^{-10} n^3 - 8973 ln(0.039 f) / f",
    text!("SDNRP 2007, eq. 7 (Ck45, A_D 2 mm, R_D 3 mm, sharp tool)"),
)];
const M4: &[Printed] = &[Printed::new(
    "F = 265.11 (1 - 2.0·10^{-12} n^3 - (31.32 / f) ln(0.039 f))",
    text!("Control strategy 2013, eq. 5; the paper then takes its neural network in place of it"),
)];

/// The force model.
pub type Formula = Mapped<FormulaMap>;

/// Cross-section of the cut for each millimetre of axial depth, over that at which the formula of
/// the set holds, 1/mm.
fn engagement_per_mm(models: &GeneticModels, radial_depth_mm: f64) -> f64 {
    let [axial_mm, radial_mm] = models.set.engagement_mm();
    radial_depth_mm / (axial_mm * radial_mm)
}

/// The map of a plant.
#[derive(Clone, Debug)]
pub struct FormulaMap {
    models: GeneticModels,
    /// Force factor per millimetre of axial depth.
    factor_per_mm: f64,
    radial_depth_mm: f64,
    /// Material times wear.
    share: f64,
    /// Whether the hardness lies where the material's factor is known.
    material_known: bool,
}

impl MapLaw for FormulaMap {
    const ABOUT: &'static str = "The formula of the model set: K4 or M4.";
    const FORMULA: bool = true;

    fn new(plant: &PlantSettings, tool: &Tool, radial_depth_mm: f64) -> Self {
        let models = GeneticModels::new(plant.model_set, plant.calibration);
        let mut models = models.for_tool(tool);
        models.force.intercept_n += plant.force_offset_n;
        let engagement = engagement_per_mm(&models, radial_depth_mm);
        let material = plant.material.force_factor(plant.hardness_hb);
        Self {
            models,
            factor_per_mm: material * plant.wear_factor * engagement,
            radial_depth_mm,
            share: material * plant.wear_factor,
            material_known: true,
        }
    }

    fn with_formulas(mut self, plant: &PlantSettings, formulas: &FormulaSettings) -> Self {
        let PlantSettings { model_set, calibration, force_offset_n, .. } = *plant;
        let models = GeneticModels::with_formulas(model_set, calibration, formulas);
        self.models.own = OwnModels { force_offset_n, ..models.own };
        if let Some(material) = formulas.material_factor(plant.hardness_hb) {
            self.share = material.value * plant.wear_factor;
            self.factor_per_mm = self.share * engagement_per_mm(&self.models, self.radial_depth_mm);
            self.material_known = material.valid;
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
        if place.radial_depth_mm != self.radial_depth_mm {
            self.radial_depth_mm = place.radial_depth_mm;
            let engagement = engagement_per_mm(&self.models, place.radial_depth_mm);
            self.factor_per_mm = self.share * engagement;
        }
        let base = self.models.force(feed_mm_min, speed_rpm);
        Valued::new(
            base.value * self.factor_per_mm * place.axial_depth_mm * life_factor,
            base.valid && self.material_known,
        )
    }

    fn short_name(set: ModelSet) -> String {
        format!("{}4", set.letter())
    }

    fn printed(set: ModelSet) -> &'static [Printed] {
        match set {
            // Those of the milling simulator have the forms of 2007.
            ModelSet::Sdnrp2007 | ModelSet::Milling2005 => K4,
            ModelSet::Strategy2013 => M4,
        }
    }

    /// Model 4 of the plant, and what it does not know.
    fn explain(moment: &ForceMoment) -> Vec<Live> {
        let ForceMoment { plant, formulas, tool, place, .. } = *moment;
        let (feed, speed) = (moment.feed_mm_min, moment.speed_rpm);
        let mut map = Self::new(plant, tool, place.radial_depth_mm).with_formulas(plant, formulas);
        let force = map.force(feed, speed, &place, 1.0);
        let models = &map.models;
        let k4 = models.force(feed, speed);
        let name = format!("{}4", models.set.letter());
        let model = match &models.own.force {
            Some(own) => own_card(own, models, &name, [feed, speed]),
            None => printed_card(models, &name, [feed, speed]),
        };
        let [axial_mm, radial_mm] = models.set.engagement_mm();
        let reference = axial_mm * radial_mm;
        let own = formulas.material_factor(plant.hardness_hb);
        let name_of = if own.is_some() { tr("a formula") } else { tr(plant.material.label()) };
        let factor =
            own.map_or_else(|| plant.material.force_factor(plant.hardness_hb), |own| own.value);
        let product = Live::everywhere(
            format!("F = {name} · material · (A_D R_D / {} mm^2) · wear", number(reference)),
            format!(
                "F = {} · {} · {} / {} · {} = {} N  ({}, {} HB)",
                number(k4.value),
                number(factor),
                number(place.axial_depth_mm * place.radial_depth_mm),
                number(reference),
                number(plant.wear_factor),
                number(force.value),
                name_of,
                number(plant.hardness_hb),
            ),
        );
        vec![model, product]
    }
}

/// Model 4 of the set with the values of a moment.
fn printed_card(models: &GeneticModels, name: &str, [feed, speed]: [f64; 2]) -> Live {
    let k4 = models.force(feed, speed);
    let [intercept, feed_coefficient, inch, speed_coefficient] =
        [models.force.intercept_n, models.force.feed, INCH, models.force.speed * 1e10].map(number);
    let formula = |f: &str, n: &str, times: &str| {
        format!(
            "{intercept} - {speed_coefficient}·10^{{-10}}{times}{n}^3 \
                 - {feed_coefficient} ln({inch}{times}{f}) / {f}"
        )
    };
    let with = formula(&number(feed.max(FEED_MIN_MM_MIN)), &number(speed), " · ");
    let with = if k4.value == 0.0 { format!("max(0, {with})") } else { with };
    Live {
        formula: format!("{name} = {}", formula("f", "n", " ")),
        values: format!("{name} = {with} = {} N", number(k4.value)),
        range: tr!(
            "f from {feed} mm/min on (its least force), n from {speed} 1/min on",
            feed = number(FEED_MIN_MM_MIN),
            speed = number(SPEED_MIN_RPM)
        ) + of_another(models, None).as_str(),
        valid: k4.valid,
    }
}

/// What is said of a model that does not belong to the cutter, with what parts it from the words before.
fn of_another(models: &GeneticModels, own: Option<&FormulaModel>) -> String {
    match (models.of_tool(own), own.and_then(FormulaModel::tool)) {
        (true, _) => String::new(),
        (false, None) => format!("; {}", tr("of the papers' cutter alone")),
        (false, Some(tool)) => {
            format!("; {}", tr!("of the cutter {cutter} alone", cutter = tool.id()))
        }
    }
}

/// A formula in its place.
fn own_card(
    own: &FormulaModel,
    models: &GeneticModels,
    name: &str,
    [feed, speed]: [f64; 2],
) -> Live {
    let force = models.force(feed, speed);
    let offset_n = models.own.force_offset_n;
    let offset = if offset_n == 0.0 { String::new() } else { format!(" + {}", number(offset_n)) };
    let [formula, with] = own.shown(&["f", "n"], &[feed, speed]);
    let with = with + offset.as_str();
    let with = if force.value == 0.0 { format!("max(0, {with})") } else { with };
    let [[least_feed, most_feed], [least_speed, most_speed]] =
        models.cut_ranges().map(|range| range.map(number));
    Live {
        formula: format!("{name} = {formula}{offset}"),
        values: format!("{name} = {with} = {} N", number(force.value)),
        range: tr!(
            "f {least_feed} to {most_feed} mm/min, n {least_speed} to {most_speed} 1/min; straight on \
             beyond",
            least_feed = least_feed,
            most_feed = most_feed,
            least_speed = least_speed,
            most_speed = most_speed
        ) + of_another(models, Some(own)).as_str(),
        valid: force.valid,
    }
}
