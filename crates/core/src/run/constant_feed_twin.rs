//! The constant-feed twin of a run: the same cut, the same noise, without control.

use super::edits::Edits;
use super::one_run::Run;
use super::scenario::Scenario;
use crate::blocks::control::ControllerKind;

/// Whether a setting belongs to the controller alone, so that the twin does not know it.
#[must_use]
pub fn is_of_controller(path: &str) -> bool {
    path.starts_with("controller.") || path.starts_with("belief.")
}

/// The twin's scenario: constant feed at 100 % overrides, all else equal.
///
/// ```
/// use steadycut_core::blocks::control::ControllerKind;
/// use steadycut_core::run::{constant_feed_twin, presets};
///
/// let chosen = presets::load("first-cut").unwrap();
/// let twin = constant_feed_twin::scenario(&chosen);
/// assert_eq!(twin.controller.kind, ControllerKind::ConstantFeed);
/// assert_eq!(twin.run.seed, chosen.run.seed);
/// ```
#[must_use]
pub fn scenario(chosen: &Scenario) -> Scenario {
    let twin = chosen.with(|settings| {
        settings.controller.kind = ControllerKind::ConstantFeed;
        settings.controller.constant_feed.feed_percent = 100.0;
        settings.controller.constant_feed.speed_percent = 100.0;
    });
    // No rule joins the controller and its settings with anything that constant feed lacks.
    twin.expect("constant feed goes with any scenario")
}

/// The edits that the twin shares.
#[must_use]
pub fn edits(chosen: &Edits) -> Edits {
    // Checked for the chosen run, and no rule joins controller and cut.
    chosen.only(|edit| !is_of_controller(&edit.path))
}

/// The twin of a scenario with its edits, at its first tick.
#[must_use]
pub fn of(chosen: &Scenario, edits_of_chosen: &Edits) -> Run {
    Run::new(&scenario(chosen), &edits(edits_of_chosen))
}
