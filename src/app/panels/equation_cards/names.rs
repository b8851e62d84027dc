//! What boxes, models and lamps are called: K1..K6 or M1..M6, as the model set in use has it.

use super::{Block, Card, Lamp};
use crate::base::model::gp::{Calibration, ModelSet};
use crate::run::scenario::Scenario;
use crate::run::signals::{FlagInfo, flag};

/// The models that a box computes with.
#[derive(Clone, Copy, Debug)]
pub struct Using {
    /// Whose models they are.
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
                Some(Using { whose: "the controller's belief", set, calibration })
            }
            Self::Cutting | Self::Surface | Self::SurfaceDynamic => {
                let plant = &scenario.plant;
                let (set, calibration) = (plant.model_set, plant.calibration);
                Some(Using { whose: "the plant", set, calibration })
            }
            _ => None,
        }
    }
}

impl Card {
    /// The models of the box by name, joined by commas; empty for a box without.
    #[must_use]
    pub fn models(&self, scenario: &Scenario) -> String {
        let Some(using) = self.block.using(scenario) else { return String::new() };
        let letter = using.set.letter();
        let names = self.models.iter().map(|number| format!("{letter}{number}"));
        names.collect::<Vec<String>>().join(", ")
    }

    /// The box's name with its models.
    #[must_use]
    pub fn title(&self, scenario: &Scenario) -> String {
        format!("{} {}", self.name, self.models(scenario)).trim_end().to_owned()
    }
}

impl Lamp {
    /// Its name.
    #[must_use]
    pub fn name(&self, scenario: &Scenario) -> String {
        renamed(self.label, letter_of(self.bits, scenario))
    }

    /// Whether it can be lit at all: without a rate limit there is no lamp for it.
    #[must_use]
    pub fn serves(&self, scenario: &Scenario) -> bool {
        self.bits & flag::RATE_LIMITED == 0 || scenario.cnc.override_rate_limited
    }
}

/// The letter of the set that a flag about a model belongs to.
fn letter_of(bits: u32, scenario: &Scenario) -> char {
    const BELIEF: u32 = flag::K1_OUTSIDE | flag::K2_OUTSIDE | flag::K3_OUTSIDE;
    let of_belief = bits & BELIEF != 0;
    let set = if of_belief { scenario.belief.model_set } else { scenario.plant.model_set };
    set.letter()
}

/// A text that begins with the name of a model of 2007, with the letter in its place.
fn renamed(text: &str, letter: char) -> String {
    let mut chars = text.chars();
    match (chars.next(), chars.next()) {
        (Some('K'), Some('1'..='6')) => format!("{letter}{}", &text[1..]),
        _ => text.to_owned(),
    }
}

/// A flag in words: the table of flags calls models by their names of 2007.
#[must_use]
pub fn flag_name(flag: &FlagInfo, scenario: &Scenario) -> String {
    renamed(flag.label, letter_of(flag.bit, scenario))
}

/// A flag in words where plant and controller have the models of one set.
#[must_use]
pub fn flag_in_set(flag: &FlagInfo, set: ModelSet) -> String {
    renamed(flag.label, set.letter())
}

#[cfg(test)]
mod tests {
    use super::super::CARDS;
    use super::*;
    use crate::run::signals::FLAGS;

    #[test]
    fn belief_and_plant_are_named_after_their_own_sets() {
        let mut scenario = Scenario::default();
        scenario.belief.model_set = ModelSet::Strategy2013;
        let titles = |scenario: &Scenario| CARDS.iter().map(|c| c.title(scenario)).collect();
        let mixed: Vec<String> = titles(&scenario);
        assert_eq!(mixed[..3], ["Reference M1", "Controller M2, M3", "Override limits"]);
        assert_eq!(mixed[6], "Cutting process K4");
        let flags = |scenario: &Scenario| -> Vec<String> {
            FLAGS.iter().map(|flag| flag_name(flag, scenario)).collect()
        };
        let words = flags(&scenario);
        assert!(words.contains(&"M3 outside its range".to_owned()), "{words:?}");
        assert!(words.contains(&"K4 outside its range".to_owned()), "{words:?}");
        scenario.plant.model_set = ModelSet::Strategy2013;
        assert!(!titles(&scenario).concat().contains('K'));
        assert!(flags(&scenario).contains(&"M6 outside its range".to_owned()));
        assert!(flags(&scenario).contains(&"in the air".to_owned()));
    }
}
