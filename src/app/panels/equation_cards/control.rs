//! The card of the controller: its law with the values of the moment.

use super::models::{feed, speed};
use crate::base::equation::Live;
use crate::models::genetic::GeneticModels;
use crate::run::explanation::explain_controller;
use crate::run::scenario::Scenario;
use crate::run::signals::Row;

/// The controller's law, with its models 2 and 3 where it ends in them.
pub fn controller(belief: &GeneticModels, row: &Row, scenario: &Scenario) -> Vec<Live> {
    let explained = explain_controller(scenario, row);
    let mut lines = explained.lines;
    if let Some(force_n) = explained.models_at_n {
        lines.extend([feed(belief, force_n), speed(belief, force_n)]);
    }
    lines
}
