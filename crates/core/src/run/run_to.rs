//! A run as far as somebody wants to look at it.

use super::edits::Edits;
use super::job::{Budget, Job, Progress};
use super::metrics::Metrics;
use super::one_run::{LOOK_TICKS, Run};
use super::scenario::Scenario;
use crate::base::language::text;

/// A run that ends at a tick, or before where it comes to its own end.
#[derive(Clone, Debug)]
pub struct RunTo {
    run: Run,
    to: u64,
}

impl RunTo {
    /// The run of a scenario with edits, up to tick `to`.
    #[must_use]
    pub fn new(scenario: &Scenario, edits: &Edits, to: u64) -> Self {
        Self { run: Run::new(scenario, edits), to }
    }

    /// The run as far as it has come.
    #[must_use]
    pub fn run(&self) -> &Run {
        &self.run
    }

    fn is_over(&self) -> bool {
        self.run.ticks() >= self.to || self.run.end().is_some()
    }
}

/// A step is one of the plant.
impl Job for RunTo {
    type Partial = Metrics;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        while !self.is_over() {
            let granted = budget.spend(LOOK_TICKS.min(self.to - self.run.ticks()));
            if granted == 0 {
                break;
            }
            let before = self.run.ticks();
            self.run.advance(granted);
            budget.put_back(granted - (self.run.ticks() - before));
        }
        self.is_over()
    }

    fn progress(&self) -> Progress {
        let total = self.to as f64;
        let done = if self.is_over() { total } else { self.run.ticks() as f64 };
        Progress { done, total, unit: text!("steps") }
    }

    fn partial(&self) -> Metrics {
        self.run.metrics()
    }
}
