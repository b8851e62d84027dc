//! What must be said beside a plan that is to be run.

use serde::Serialize;

use crate::run::scenario::Scenario;

/// What must be said.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Remark {
    /// Which remark.
    pub id: &'static str,
    /// A sentence without the full stop.
    pub text: String,
}

/// How a run of the scenario relates to its plan.
#[must_use]
pub fn remarks(scenario: &Scenario) -> Vec<Remark> {
    let (plant, planned) = (scenario.plant.force_model, scenario.plan.network);
    let mut said = Vec::new();
    if plant.network() != Some(planned) {
        let text = format!(
            "The plan's force is that of the network ({}), the run's comes from: {}; they differ, so \
             the run does not begin at the planned force",
            planned.label(),
            plant.label()
        );
        said.push(Remark { id: "another_force", text });
    }
    let text = "The constraints hold at the programmed values: an adaptive controller then holds the \
                force and moves feed and speed along its models, whatever that does to tool life and \
                power";
    said.push(Remark { id: "constraints_at_programmed_values", text: text.to_owned() });
    said
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::run::presets::load;

    #[test]
    fn a_plant_with_another_force_than_the_plan_s_is_named() {
        let other = remarks(&load("first-cut").unwrap());
        assert!(other.len() == 2 && other[0].text.contains("Formula"), "{other:?}");
        assert_eq!(remarks(&load("strategy-2013").unwrap()).len(), 1, "the same network");
    }
}
