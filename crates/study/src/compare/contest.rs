//! Ways of control on one part: each entrant taken through the load step, then the tournament over
//! the seeds.

use super::entrants::Entrant;
use super::load_step::{self, Transient};
use super::tournament::{Compared, Tournament};
use crate::run::edits::Edits;
use crate::run::job::{Budget, Job, Progress};
use crate::run::one_run::Run;
use crate::run::parts::{Making, Parts};

/// Load step and tournament of the same entrants.
#[derive(Clone, Debug)]
pub struct ContestJob {
    /// Number of entrants that take the load step: all or none.
    stepping: usize,
    steps: Parts<Run, Transient>,
    tournament: Tournament,
}

impl ContestJob {
    /// A contest over seeds 1 to `seeds`, not yet begun. The load step is made of sections that are
    /// milled: it is left out where an entrant's part has none.
    #[must_use]
    pub fn new(entrants: Vec<Entrant>, seeds: u32) -> Self {
        let milled = entrants.iter().all(|entrant| !entrant.scenario.workpiece.cuts.is_empty());
        Self {
            stepping: if milled { entrants.len() } else { 0 },
            steps: Parts::default(),
            tournament: Tournament::new(entrants, seeds),
        }
    }

    /// The tournament.
    #[must_use]
    pub fn tournament(&self) -> &Tournament {
        &self.tournament
    }

    /// See [`Tournament::set_seeds`].
    pub fn set_seeds(&mut self, seeds: u32) {
        self.tournament.set_seeds(seeds);
    }

    /// Whether the load step belongs to the part.
    #[must_use]
    pub fn has_load_step(&self) -> bool {
        self.stepping > 0
    }

    /// How the entrants took the load step, as far as they have.
    #[must_use]
    pub fn transients(&self) -> &[Transient] {
        self.steps.done()
    }
}

/// What a contest has given so far.
#[derive(Clone, Debug, PartialEq)]
pub struct ContestSoFar {
    /// How the first entrants took the load step.
    pub transients: Vec<Transient>,
    /// The table.
    pub table: Vec<Compared>,
    /// How many entrants take the load step, which comes first.
    pub stepping: usize,
    /// How far the tournament is.
    pub runs: Progress,
}

/// A step is one of the plant in one of the runs.
impl Job for ContestJob {
    type Partial = ContestSoFar;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        let entrants = self.tournament.entrants();
        let begin = |index: usize| {
            Ok(Run::new(&load_step::scenario(&entrants[index].scenario), &Edits::none()))
        };
        let end = |index: usize, run: &Run| load_step::judged(&entrants[index].name, run);
        let making = Making { begin: &begin, end: &end };
        self.steps.advance(self.stepping, budget, &making) && self.tournament.advance(budget)
    }

    /// Of the runs over the seeds: a load step takes a small part of the time of one of them.
    fn progress(&self) -> Progress {
        self.tournament.progress()
    }

    fn partial(&self) -> ContestSoFar {
        ContestSoFar {
            transients: self.transients().to_vec(),
            stepping: self.stepping,
            table: self.tournament.table(),
            runs: self.tournament.progress(),
        }
    }
}
