//! Where a formula of one's own can stand in a run, and what has to be set for that.

use crate::base::language::tr;
use crate::base::settings::{Structure, Value};
use crate::models::formula_model::{FormulaModel, FormulaRole, OwnFormula};
use crate::models::genetic::{
    Calibration, FeedOfForce, ForceOfCut, ForceOfRa, RaOfForce, SpeedOfForce,
};
use crate::run::scenario::Scenario;

steadycut_core::choice! {
    /// A model of the loop that a formula can stand in the place of: one of the settings `formula.*`.
    pub enum FormulaPlace {
        /// Model 1, K1 or M1.
        ForceOfRa = "force_of_ra", "Force for a target Ra";
        /// Model 2, K2 or M2.
        Feed = "feed", "Feed for a force";
        /// Model 3, K3 or M3.
        Speed = "speed", "Speed for a force";
        /// Model 4, K4 or M4.
        Force = "force", "Force of the cut";
        /// Models 5 and 6, K5 or M5.
        Ra = "ra", "Ra of a force";
    }
}

fn written<R: FormulaRole>(model: &FormulaModel) -> Result<Value, String> {
    OwnFormula::<R>::of(model.clone()).map(|own| own.write())
}

impl FormulaPlace {
    /// Path of its setting.
    #[must_use]
    pub fn path(self) -> String {
        format!("formula.{}", self.id())
    }

    /// What its setting is with a model in it.
    ///
    /// # Errors
    /// The units of the model's inputs or of its result are not those of this place: which are allowed.
    pub fn value(self, model: &FormulaModel) -> Result<Value, String> {
        match self {
            Self::ForceOfRa => written::<ForceOfRa>(model),
            Self::Feed => written::<FeedOfForce>(model),
            Self::Speed => written::<SpeedOfForce>(model),
            Self::Force => written::<ForceOfCut>(model),
            Self::Ra => written::<RaOfForce>(model),
        }
    }

    /// Whether the plant cuts by it: feed and speed for a force, and the force for a target Ra, are the controller's.
    fn is_of_the_plant(self) -> bool {
        match self {
            Self::Force | Self::Ra => true,
            Self::ForceOfRa | Self::Feed | Self::Speed => false,
        }
    }

    /// The settings with which a run computes with a model in this place: its own, and the calibration `formula` of
    /// the controller and, where the plant cuts by it, of the plant.
    ///
    /// # Errors
    /// As [`Self::value`]; or the run would have no use for it in this scenario, and why.
    pub fn settings(
        self,
        model: &FormulaModel,
        scenario: &Scenario,
    ) -> Result<Vec<(String, Value)>, String> {
        let mut changes = vec![(self.path(), self.value(model)?)];
        let plant = self.is_of_the_plant().then_some("plant.calibration");
        for of in plant.into_iter().chain(["belief.calibration"]) {
            changes.push((of.to_owned(), Value::Text(Calibration::Formula.id().to_owned())));
        }
        let mut with = scenario.clone();
        with.set_all(&changes).map_err(|error| error.to_string())?;
        let unused = with.unused(&self.path()).map_err(|error| error.to_string())?;
        match unused {
            None => Ok(changes),
            Some(because) => Err(tr!("a run has no use for it: {because}", because = tr(because))),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::run::presets::load;
    use crate::run::scenario::param;

    #[test]
    fn each_place_takes_its_own_models_and_says_what_it_takes_of_others() {
        let scenario = load("first-cut").unwrap();
        let examples = [
            ForceOfRa::EXAMPLE,
            FeedOfForce::EXAMPLE,
            SpeedOfForce::EXAMPLE,
            ForceOfCut::EXAMPLE,
            RaOfForce::EXAMPLE,
        ];
        for (number, place) in FormulaPlace::ALL.iter().enumerate() {
            assert_eq!(param(&place.path()).unwrap().spec.label, place.label());
            for (of, example) in examples.iter().enumerate() {
                let model = FormulaModel::parse(example).unwrap();
                let set = place.settings(&model, &scenario);
                if number == of {
                    let mut with = scenario.clone();
                    with.set_all(&set.unwrap()).unwrap();
                    assert_eq!(with.get(&place.path()).unwrap(), place.value(&model).unwrap());
                    let by_plant = with.plant.calibration == Calibration::Formula;
                    assert_eq!(by_plant, place.is_of_the_plant());
                    assert_eq!(with.belief.calibration, Calibration::Formula);
                } else {
                    assert!(set.unwrap_err().contains("allowed is"));
                }
            }
        }
    }

    #[test]
    fn a_run_that_has_no_use_for_it_is_said_so() {
        let scenario = load("experiment-2").unwrap();
        let model = FormulaModel::parse(FeedOfForce::EXAMPLE).unwrap();
        let said = FormulaPlace::Feed.settings(&model, &scenario).unwrap_err();
        assert!(said.starts_with("a run has no use for it: `"), "{said}");
    }
}
