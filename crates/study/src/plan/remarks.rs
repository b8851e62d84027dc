//! What must be said beside a plan that is to be run.

use serde::Serialize;

use crate::base::language::tr;
use crate::blocks::control::ControllerKind;
use crate::run::scenario::Scenario;

/// Id of the remark on times: whose feed they are of.
pub const TIMES: &str = "times_at_this_feed";

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
    let kind = scenario.controller.kind;
    if kind != ControllerKind::ConstantFeed {
        let text = tr!(
            "Times, removal rate and cost are those of this feed, kept through the whole cut: {controller} changes the \
             feed in the cut, and with it all of them",
            controller = tr(kind.label())
        );
        said.push(Remark { id: TIMES, text });
    }
    if plant.network() != Some(planned) {
        let [plan, run] = [planned.label(), plant.label()].map(tr);
        let text = tr!(
            "The plan's force is that of the network ({plan}), the run's comes from: {run}; they differ, so \
             the run does not begin at the planned force",
            plan = plan,
            run = run,
        );
        said.push(Remark { id: "another_force", text });
    }
    if scenario.machine.coupled {
        let text = tr(
            "Chatter is none of the constraints, and this machine vibrates in the cut: whether the planned speed and depth \
             are quiet, its stability chart says",
        );
        said.push(Remark { id: "chatter_is_no_constraint", text: text.to_owned() });
    }
    let text = tr(
        "The constraints are judged at the programmed values: an adaptive controller then holds the force and moves feed and \
         speed along its models, whatever that does to tool life and power",
    );
    said.push(Remark { id: "constraints_at_programmed_values", text: text.to_owned() });
    said
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::settings::Value;
    use crate::run::presets::load;

    #[test]
    fn a_plant_with_another_force_than_the_plan_s_is_named() {
        let other = remarks(&load("first-cut").unwrap());
        assert!(other.len() == 3 && other[1].text.contains("Formula"), "{other:?}");
        assert_eq!(remarks(&load("strategy-2013").unwrap()).len(), 2, "the same network");
    }

    /// The seven constraints know no vibration: feasible is not quiet.
    #[test]
    fn where_the_machine_vibrates_chatter_is_said_to_be_no_constraint() {
        let said = |name: &str| {
            let all = remarks(&load(name).unwrap());
            all.iter().any(|remark| remark.id == "chatter_is_no_constraint")
        };
        assert!(said("chatter") && !said("first-cut"));
    }

    /// The swarm's time is that of one feed: a controller cuts in another.
    #[test]
    fn the_time_is_said_to_be_that_of_constant_feed_where_a_controller_changes_it() {
        let mut scenario = load("first-cut").unwrap();
        let of_times =
            |scenario: &Scenario| remarks(scenario).into_iter().find(|remark| remark.id == TIMES);
        assert!(of_times(&scenario).unwrap().text.contains("SDNRP changes the feed"));
        let constant = Value::Text(ControllerKind::ConstantFeed.id().to_owned());
        scenario.set("controller.kind", constant).unwrap();
        assert_eq!(of_times(&scenario), None);
    }
}
