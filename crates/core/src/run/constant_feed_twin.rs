//! The constant-feed twin of a run: the same cut, the same noise, without control. What is changed during the
//! run, the twin meets at the same place of the part, not at the same time: it moves at another feed.

use super::edits::{Edit, Edits};
use super::job::{Budget, Job, Progress};
use super::metrics::Metrics;
use super::one_run::{LOOK_TICKS, Run};
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

/// The edits that the twin shares, at their times in the chosen run.
#[must_use]
pub fn edits(chosen: &Edits) -> Edits {
    // Checked for the chosen run, and no rule joins controller and cut.
    chosen.only(|edit| !is_of_controller(&edit.path))
}

/// The edits that the twin shares, each at the time when the twin is at the place of the part where the chosen
/// run was: a twin that is ahead or behind meets a change where the other one did, as it meets a step in depth.
#[derive(Clone, Debug, Default)]
pub struct SharedEdits {
    /// Edits of the chosen run, each with its time in the twin, s.
    placed: Vec<(Edit, f64)>,
}

impl SharedEdits {
    /// Forgets where those from a time of the chosen run in s on come, since they or their places have changed.
    pub fn truncate(&mut self, from_s: f64) {
        self.placed.retain(|(edit, _)| edit.at_s < from_s);
    }

    /// The twin's edits, as far as their places are known.
    #[must_use]
    pub fn edits(&self) -> Edits {
        Edits::at_times(self.placed.iter().cloned())
    }

    /// Finds the place of the next one, once both runs have come there; gives the twin's time there, s, from
    /// which on it is to be cut again with [`Self::edits`].
    #[must_use]
    pub fn place(&mut self, chosen: &Run, twin: &Run) -> Option<f64> {
        let next = edits(chosen.edits()).list().get(self.placed.len())?.clone();
        let rows = chosen.recording().rows();
        let half_step_s = 0.5 * chosen.scenario().dt_s();
        if rows.last().is_none_or(|last| last.time_s + half_step_s < next.at_s) {
            return None;
        }
        let place_mm = rows[chosen.recording().index_at(next.at_s)].position_mm;
        let rows = twin.recording().rows();
        let at_s = rows.get(rows.partition_point(|row| row.position_mm < place_mm))?.time_s;
        self.placed.push((next, at_s));
        Some(at_s)
    }
}

/// The twin beside a run that is over, as a job: the same part with the same changes at the same places.
///
/// ```
/// use steadycut_core::run::job::Job;
/// use steadycut_core::run::{constant_feed_twin::BesideRun, edits::Edits, one_run::Run, presets};
///
/// let chosen = Run::complete(&presets::load("first-cut").unwrap(), &Edits::none());
/// let mut beside = BesideRun::new(&chosen);
/// beside.to_end();
/// assert!(beside.twin().end().is_some());
/// ```
#[derive(Clone, Debug)]
pub struct BesideRun<'a> {
    chosen: &'a Run,
    twin: Run,
    shared: SharedEdits,
}

impl<'a> BesideRun<'a> {
    /// The twin at its first tick.
    #[must_use]
    pub fn new(chosen: &'a Run) -> Self {
        let twin = Run::new(&scenario(chosen.scenario()), &Edits::none());
        Self { chosen, twin, shared: SharedEdits::default() }
    }

    /// The twin as far as it is cut.
    #[must_use]
    pub fn twin(&self) -> &Run {
        &self.twin
    }
}

/// A step is one of the plant.
impl Job for BesideRun<'_> {
    type Partial = Metrics;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        loop {
            while let Some(at_s) = self.shared.place(self.chosen, &self.twin) {
                self.twin.branch(at_s, &self.shared.edits());
            }
            if self.twin.end().is_some() {
                return true;
            }
            let granted = budget.spend(LOOK_TICKS);
            if granted == 0 {
                return false;
            }
            let before = self.twin.ticks();
            self.twin.advance(granted);
            budget.put_back(granted - (self.twin.ticks() - before));
        }
    }

    fn progress(&self) -> Progress {
        self.twin.progress()
    }

    fn partial(&self) -> Metrics {
        self.twin.metrics()
    }
}

/// The twin of a run that is over, cut to its end.
#[must_use]
pub fn beside(chosen: &Run) -> Run {
    let mut beside = BesideRun::new(chosen);
    beside.to_end();
    beside.twin
}
