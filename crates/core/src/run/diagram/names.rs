//! What boxes, models and lamps are called: K1..K6 or M1..M6, as the model set in use has it.

use super::super::scenario::Scenario;
use super::super::signals::{FlagInfo, flag};
use super::{Block, BlockInfo, Lamp};
use crate::base::language::tr;
use crate::blocks::control::ControllerKind;
use crate::blocks::control::law::Held;
use crate::blocks::cutting::process::{ForceModel, PlantSettings};
use crate::models::disturbances::Disturbance;
use crate::models::genetic::{Calibration, ModelSet};

/// The models that a box computes with.
#[derive(Clone, Copy, Debug)]
pub struct Using {
    /// Whose models they are, in the chosen language.
    pub whose: &'static str,
    /// Their set.
    pub set: ModelSet,
    /// Their calibration.
    pub calibration: Calibration,
}

impl Block {
    /// The models that the box computes with; `None` for a box without.
    #[must_use]
    pub fn using(self, scenario: &Scenario) -> Option<Using> {
        match self {
            Self::Reference | Self::Controller => {
                let belief = &scenario.belief;
                let (set, calibration) = (belief.model_set, belief.calibration);
                Some(Using { whose: tr("the controller's belief"), set, calibration })
            }
            Self::Cutting | Self::Surface | Self::SurfaceDynamic => {
                let plant = &scenario.plant;
                let (set, calibration) = (plant.model_set, plant.calibration);
                Some(Using { whose: tr("the plant"), set, calibration })
            }
            Self::Override
            | Self::DeadTime
            | Self::FeedDrive
            | Self::SpindleDrive
            | Self::Dynamic
            | Self::Dynamometer => None,
        }
    }

    /// Where the coefficients of its models come from, for people: with formulas of one's own, each model
    /// tells its own, since those without one stay the identified ones. Empty for a box without models.
    #[must_use]
    pub fn origin(self, scenario: &Scenario) -> String {
        let Some(Using { set, calibration, .. }) = self.using(scenario) else {
            return String::new();
        };
        if calibration != Calibration::Formula {
            return tr(calibration.label()).to_owned();
        }
        let names = Names::of(scenario);
        let of_model = |number: &u32| {
            let own = set != ModelSet::Milling2005 && has_formula(*number, scenario);
            let origin = if own { tr("own formula") } else { tr(Calibration::Identified.label()) };
            (names.model(*number), origin)
        };
        let each: Vec<(String, &str)> = self.info().models.iter().map(of_model).collect();
        match &each[..] {
            [] => String::new(),
            [(_, first), rest @ ..] if rest.iter().all(|(_, origin)| origin == first) => {
                (*first).to_owned()
            }
            several => {
                let told = several.iter().map(|(name, origin)| format!("{name} {origin}"));
                told.collect::<Vec<String>>().join(", ")
            }
        }
    }

    /// The heading over its live values: whose models they come from.
    #[must_use]
    pub fn now(self, scenario: &Scenario) -> String {
        let force = scenario.plant.force_model;
        match self.using(scenario) {
            Some(Using { whose, .. }) if self == Self::Cutting && !force.is_formula() => {
                tr!("Now, {whose}: {force}", whose = whose, force = tr(force.label()))
            }
            Some(Using { whose, set, .. }) => {
                let (models, origin) = (tr(set.label()), self.origin(scenario));
                tr!(
                    "Now, {whose}: {models}, {origin}",
                    whose = whose,
                    models = models,
                    origin = origin
                )
            }
            None => tr("Now").to_owned(),
        }
    }
}

/// Whether there is a formula of one's own for the model with this number.
fn has_formula(number: u32, scenario: &Scenario) -> bool {
    let formulas = &scenario.formula;
    match number {
        1 => formulas.force_of_ra.get().is_some(),
        2 => formulas.feed.get().is_some(),
        3 => formulas.speed.get().is_some(),
        4 => formulas.force.get().is_some(),
        _ => formulas.ra.get().is_some(),
    }
}

/// What models and flags are called.
#[derive(Clone, Copy, Debug)]
pub struct Names {
    belief: ModelSet,
    plant: ModelSet,
    force: ForceModel,
}

impl Names {
    /// The names in a scenario.
    #[must_use]
    pub fn of(scenario: &Scenario) -> Self {
        let PlantSettings { model_set, force_model, .. } = scenario.plant;
        Self { belief: scenario.belief.model_set, plant: model_set, force: force_model }
    }

    /// The names where plant and controller have the models of one set.
    #[must_use]
    pub fn both(set: ModelSet, force: ForceModel) -> Self {
        Self { belief: set, plant: set, force }
    }

    /// The name of the model with this number.
    fn model(self, number: u32) -> String {
        match number {
            4 => self.force.short_name(self.plant),
            1..=3 => format!("{}{number}", self.belief.letter()),
            _ => format!("{}{number}", self.plant.letter()),
        }
    }

    /// What the model with this number gives, in plain words of the chosen language; empty for a number that
    /// no model has.
    #[must_use]
    pub fn gives(number: u32) -> &'static str {
        match number {
            1 => tr("force for a target Ra"),
            2 => tr("feed for a force"),
            3 => tr("speed for a force"),
            4 => tr("cutting force"),
            5 => tr("Ra"),
            6 => tr("Ra with dynamics"),
            _ => "",
        }
    }

    /// The present name of the model whose name in the set of 2007 a text begins with, if it begins with one.
    fn named_in(self, text: &str) -> Option<String> {
        let mut chars = text.chars();
        match (chars.next(), chars.next()) {
            (Some('K'), Some(digit)) => digit.to_digit(10).map(|number| self.model(number)),
            _ => None,
        }
    }

    /// The model that a flag is of, by its present name; none of a flag of something else.
    #[must_use]
    pub fn model_of(self, flag: &FlagInfo) -> Option<String> {
        self.named_in(flag.label)
    }

    /// A flag in words: the table of flags calls models by their names of 2007.
    #[must_use]
    pub fn flag(self, flag: &FlagInfo) -> String {
        match self.model_of(flag) {
            Some(model) => tr!("{model} outside its range", model = model),
            None => tr(flag.label).to_owned(),
        }
    }
}

impl BlockInfo {
    /// The models of the box by name, joined by commas; empty for a box without.
    #[must_use]
    pub fn models(&self, scenario: &Scenario) -> String {
        let idle = match scenario.controller.kind.held() {
            Held::Overrides | Held::Force => self.block == Block::Controller,
            Held::Roughness => false,
        };
        if idle {
            return String::new();
        }
        let names = Names::of(scenario);
        let models = self.models.iter().map(|number| names.model(*number));
        models.collect::<Vec<String>>().join(", ")
    }

    /// The box's name with its models.
    #[must_use]
    pub fn title(&self, scenario: &Scenario) -> String {
        format!("{} {}", tr(self.name), self.models(scenario)).trim_end().to_owned()
    }
}

/// Whether a tooth can break in this cut, under its load or by a disturbance.
fn can_break(scenario: &Scenario) -> bool {
    let tool = &scenario.tool;
    let by_load = tool.chip_max_mm > 0.0 || tool.force_max_n > 0.0;
    by_load || !scenario.disturbances.of(Disturbance::BrokenTooth).is_empty()
}

impl Lamp {
    /// Its name.
    #[must_use]
    pub fn name(&self, scenario: &Scenario) -> String {
        let model = Names::of(scenario).named_in(self.label);
        model.unwrap_or_else(|| tr(self.label).to_owned())
    }

    /// Whether it can be lit at all: without a rate limit, a machine or a controller with a limit of its
    /// own there is no lamp for it.
    #[must_use]
    pub fn serves(&self, scenario: &Scenario) -> bool {
        let limited = self.bits & flag::RATE_LIMITED == 0 || scenario.cnc.override_rate_limited;
        let guarded = scenario.controller.kind == ControllerKind::Afc;
        limited
            && (self.bits & flag::LOST_CONTACT == 0 || scenario.machine.coupled)
            && (self.bits & flag::TOOTH_BROKEN == 0 || can_break(scenario))
            && (self.bits & (flag::OVER_LIMIT | flag::CONTROL_OFF) == 0 || guarded)
    }
}

#[cfg(test)]
mod tests {
    use super::super::BLOCKS;
    use super::*;
    use crate::base::settings::Value;
    use crate::run::signals::FLAGS;

    fn titles(scenario: &Scenario) -> Vec<String> {
        BLOCKS.iter().map(|info| info.title(scenario)).collect()
    }

    fn flags(scenario: &Scenario) -> Vec<String> {
        FLAGS.iter().map(|flag| Names::of(scenario).flag(flag)).collect()
    }

    #[test]
    fn belief_and_plant_are_named_after_their_own_sets() {
        let mut scenario = Scenario::default();
        scenario.change(|s| s.belief.model_set = ModelSet::Strategy2013).unwrap();
        let mixed = titles(&scenario);
        assert_eq!(mixed[..3], ["Reference M1", "Controller M2, M3", "Override limits"]);
        assert_eq!(mixed[6], "Cutting process K4");
        let words = flags(&scenario);
        assert!(words.contains(&"M3 outside its range".to_owned()), "{words:?}");
        assert!(words.contains(&"K4 outside its range".to_owned()), "{words:?}");
        scenario.change(|s| s.plant.model_set = ModelSet::Strategy2013).unwrap();
        assert!(!titles(&scenario).concat().contains('K'));
        assert!(flags(&scenario).contains(&"M6 outside its range".to_owned()));
        assert!(flags(&scenario).contains(&"in the air".to_owned()));
    }

    #[test]
    fn with_formulas_of_one_s_own_each_box_tells_its_own_origin() {
        let mut scenario = crate::run::presets::load("own-formula").unwrap();
        let origins = |scenario: &Scenario| {
            let boxes = [Block::Reference, Block::Controller, Block::Cutting, Block::Surface];
            boxes.map(|block| block.origin(scenario))
        };
        // The shipped scenario sets the force of the cut alone.
        assert!(scenario.formula.ra.get().is_none() && scenario.formula.force.get().is_some());
        scenario.change(|s| s.belief.calibration = Calibration::Formula).unwrap();
        assert_eq!(origins(&scenario), ["identified", "identified", "own formula", "identified"]);
        assert!(Block::Surface.now(&scenario).ends_with(", identified"));
        scenario.set("formula.feed", Value::Text(OWN_FEED.to_owned())).unwrap();
        assert_eq!(origins(&scenario)[1], "K2 own formula, K3 identified");
        scenario.change(|s| s.belief.calibration = Calibration::Restored).unwrap();
        assert_eq!(origins(&scenario)[1], "restored");
        assert_eq!(Block::FeedDrive.origin(&scenario), "");
    }

    const OWN_FEED: &str = r#"{"version":1,"formula":"25.4*(40 - 900000/F^2)","output":{"name":"f","unit":"mm/min"},"inputs":[{"name":"F","unit":"N","low":160,"high":200}]}"#;

    #[test]
    fn a_network_takes_the_place_of_model_4_only() {
        let mut scenario = Scenario::default();
        scenario.change(|s| s.plant.force_model = ForceModel::NeuralLiteral).unwrap();
        assert_eq!(titles(&scenario)[6], "Cutting process NN");
        let now = Block::Cutting.now(&scenario);
        assert_eq!(now, format!("Now, the plant: {}", ForceModel::NeuralLiteral.label()));
        assert!(flags(&scenario).contains(&"NN outside its range".to_owned()));
        assert!(flags(&scenario).contains(&"K5 outside its range".to_owned()));
    }
}
