//! How many iterations of its internal loop UNKS needs (2005 paper: "four or less").

use super::claims::UNKS;
use super::entrants::TABLE_1;
use crate::base::language::text;
use crate::run::edits::Edits;
use crate::run::job::{Budget, Job, Progress};
use crate::run::one_run::Run;
use crate::run::parts::{Making, Parts};
use crate::run::scenario::Scenario;

/// Iterations of the internal loop that never cut it short.
pub const MANY_ITERATIONS: u32 = 10;

/// Looks for the fewest iterations of the internal loop with which UNKS cuts a part as it does with
/// [`MANY_ITERATIONS`], to the bit: with fewer, the loop is cut short somewhere.
#[derive(Clone, Debug)]
pub struct IterationsJob {
    base: Scenario,
    /// Digests of the runs: first that with many iterations, then those with 1, 2 and so on.
    runs: Parts<Run, String>,
}

impl IterationsJob {
    /// The runs on the part of `base`.
    #[must_use]
    pub fn new(base: &Scenario) -> Self {
        Self { base: base.clone(), runs: Parts::default() }
    }

    fn begin(&self, part: usize) -> Result<Run, String> {
        let iterations = if part == 0 { MANY_ITERATIONS } else { part as u32 };
        let scenario = TABLE_1[UNKS].on(&self.base).scenario.with(|settings| {
            settings.controller.unks.internal_iterations = iterations;
            settings.run.record_every = settings.run.steps_per_control;
        });
        Ok(Run::new(&scenario.map_err(|error| error.to_string())?, &Edits::none()))
    }
}

/// A step is one of the plant. The runs with more iterations than are needed may be left out.
impl Job for IterationsJob {
    /// The number, once it is known.
    type Partial = Option<u32>;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        if self.partial().is_some() {
            return true;
        }
        let mut runs = std::mem::take(&mut self.runs);
        let making = Making {
            begin: &|part| self.begin(part),
            end: &|_, run: &Run| run.recording().digest(),
        };
        let over = runs.advance(MANY_ITERATIONS as usize, budget, &making);
        self.runs = runs;
        over || self.partial().is_some()
    }

    fn progress(&self) -> Progress {
        let total = f64::from(MANY_ITERATIONS);
        let done = if self.partial().is_some() { total } else { self.runs.progress() };
        Progress { done, total, unit: text!("runs") }
    }

    fn partial(&self) -> Option<u32> {
        let (many, fewer) = self.runs.done().split_first()?;
        let same = (1..).zip(fewer).find(|(_, digest)| *digest == many).map(|(fewest, _)| fewest);
        let all = self.runs.done().len() >= MANY_ITERATIONS as usize;
        same.or_else(|| all.then_some(MANY_ITERATIONS))
    }

    fn refusal(&self) -> Option<&str> {
        self.runs.refusal()
    }
}
