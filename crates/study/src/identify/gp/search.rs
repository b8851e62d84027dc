//! The search as a job: batches of offspring on several islands.
//!
//! Offspring number i of batch b depends on the survivors before the batch and on the draws of (seed, b, i)
//! only, and survivors are chosen in the order of the numbers: neither slices nor threads show.

use super::archive::{Archive, FittedSum};
use super::breed::Nursery;
use super::draw::Draws;
use super::state::GpState;
use crate::base::language::{text, tr};
use crate::run::job::{Budget, Job, Progress};
use crate::run::parts::{Making, OneStep, Parts};

/// Islands that search alike: two outer ones, and between them two inner ones that begin anew now and then.
pub const GROUP: usize = 4;
/// Offspring of a batch on each island.
const PER_ISLAND: usize = 32;
/// Batches that go on after an exact formula was found, to find a smaller one.
const AFTER_EXACT: u64 = 6;
/// Batches after which an inner island begins anew.
const RESTART: u64 = 24;

/// When a search ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stop {
    /// Most batches.
    pub batches: u64,
    /// Batches without gain on the front after which it ends.
    pub idle: u64,
}

/// A search.
#[derive(Clone)]
pub struct GpSearch {
    nursery: Nursery,
    seed: u64,
    stop: Stop,
    /// The survivors of each island.
    pub(super) islands: Vec<Archive>,
    /// The best of all islands and times.
    pub(super) best: Archive,
    /// The best of these without sines and cosines.
    pub(super) calm: Archive,
    pub(super) batch: u64,
    pub(super) evaluations: u64,
    /// The batch of the last gain.
    pub(super) gained: u64,
    /// The batch that found the first exact formula.
    pub(super) exact: Option<u64>,
    parts: Parts<OneStep, Option<FittedSum>>,
}

impl GpSearch {
    /// A search that begins with the families of curves.
    #[must_use]
    pub fn started(nursery: Nursery, seed: u64, stop: Stop) -> Self {
        let first = nursery.first();
        let archive = |island: usize| {
            let mut archive = Archive::default();
            let own = first.iter().filter(|candidate| nursery.is_at_home(candidate, island));
            own.for_each(|candidate| archive.admit(candidate.clone()));
            archive
        };
        let islands: Vec<Archive> = (0..nursery.islands()).map(archive).collect();
        Self {
            seed,
            stop,
            calm: archive(0),
            best: archive(0),
            islands,
            batch: 0,
            evaluations: 0,
            gained: 0,
            exact: None,
            parts: Parts::default(),
            nursery,
        }
    }

    /// Ends it with the last whole batch; the first one is made in any case.
    pub(super) fn end_here(&mut self) -> u64 {
        self.stop.batches = self.stop.batches.min(self.batch.max(1));
        self.stop.batches
    }

    /// Goes on from a state that was saved.
    ///
    /// # Errors
    /// The state has formulas that cannot be.
    pub(super) fn go_on(&mut self, state: GpState) -> Result<(), String> {
        let inputs = self.nursery.rows.inputs.len();
        let archives = state.islands.iter().chain([&state.best, &state.calm]);
        if state.islands.len() != self.islands.len()
            || !archives.into_iter().all(|archive| archive.is_sound(inputs))
        {
            return Err(tr("the saved search has formulas that cannot be").to_owned());
        }
        self.islands = state.islands;
        self.best = state.best;
        self.calm = state.calm;
        self.batch = state.batch;
        self.evaluations = state.evaluations;
        self.gained = state.gained;
        self.exact = state.exact;
        self.parts = Parts::default();
        Ok(())
    }

    /// Seed of all draws.
    #[must_use]
    pub fn seed(&self) -> u64 {
        self.seed
    }

    /// The nursery.
    #[must_use]
    pub fn nursery(&self) -> &Nursery {
        &self.nursery
    }

    /// The best formulas of all sizes.
    #[must_use]
    pub fn best(&self) -> &Archive {
        &self.best
    }

    /// The best formulas without sines and cosines of all sizes.
    #[must_use]
    pub fn calm(&self) -> &Archive {
        &self.calm
    }

    /// Where an input may be of any sign: the best formulas of all sizes that have values on both sides of 0, those
    /// without sines and cosines first.
    #[must_use]
    pub fn whole(&self) -> Option<[Archive; 2]> {
        let group = self.islands.get(GROUP..).filter(|group| !group.is_empty())?;
        let mut both = [Archive::default(), Archive::default()];
        for candidate in group.iter().flat_map(Archive::all) {
            let [calm, best] = &mut both;
            if candidate.sum.periodic() == 0 {
                calm.admit(candidate.clone());
            }
            best.admit(candidate.clone());
        }
        Some(both)
    }

    /// Batches that are over.
    #[must_use]
    pub fn batches(&self) -> u64 {
        self.batch
    }

    /// Formulas made.
    #[must_use]
    pub fn evaluations(&self) -> u64 {
        self.evaluations
    }

    /// The batch that found the first exact formula.
    #[must_use]
    pub fn exact(&self) -> Option<u64> {
        self.exact
    }

    fn is_over(&self) -> bool {
        self.batch >= self.stop.batches
            || self.batch >= self.gained + self.stop.idle
            || self.exact.is_some_and(|exact| {
                // The larger it is, the longer a smaller one is looked for.
                let longer = AFTER_EXACT + self.most().min(self.nursery.bounds().size) as u64;
                self.batch >= exact.max(self.gained) + longer
            })
    }

    /// The size that offspring may have: nothing larger than an exact formula is wanted.
    fn most(&self) -> usize {
        let exact = self.best.all().find(|candidate| self.nursery.is_exact(candidate));
        exact.map_or(usize::MAX, |candidate| candidate.size)
    }

    /// The inner islands of each group in turn hand their survivors to the outer one beside them and begin anew: a
    /// search that has run itself into a corner is no longer asked.
    fn restart(&mut self) {
        let inner = GROUP - 2;
        let turn = (self.batch / RESTART) as usize % inner;
        let outer = if turn < inner / 2 { 0 } else { inner + 1 };
        for group in self.islands.chunks_mut(GROUP) {
            let survivors = std::mem::take(&mut group[1 + turn]);
            for survivor in survivors.all() {
                group[outer].admit(survivor.clone());
            }
        }
    }

    /// Takes the offspring of a batch in.
    fn take(&mut self, offspring: Vec<Option<FittedSum>>) {
        let islands = self.islands.len();
        let errors = |archive: &Archive| -> Vec<f64> {
            let mut least = f64::INFINITY;
            let sizes = 0..self.nursery.bounds().size + 1;
            sizes
                .map(|size| {
                    least = least.min(archive.best(size).map_or(f64::INFINITY, |best| best.error));
                    least
                })
                .collect()
        };
        let before = errors(&self.best);
        self.evaluations += offspring.len() as u64;
        for (number, candidate) in offspring.into_iter().enumerate() {
            let Some(candidate) = candidate else { continue };
            if self.exact.is_none() && self.nursery.is_exact(&candidate) {
                self.exact = Some(self.batch);
            }
            self.best.admit(candidate.clone());
            if candidate.sum.periodic() == 0 {
                self.calm.admit(candidate.clone());
            }
            self.islands[number % islands].admit(candidate);
        }
        let after = errors(&self.best);
        if before.iter().zip(&after).any(|(before, after)| *after < 0.99 * before) {
            self.gained = self.batch + 1;
        }
        self.batch += 1;
        if self.batch.is_multiple_of(RESTART) {
            self.restart();
        }
    }
}

impl Job for GpSearch {
    type Partial = Archive;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        while !self.is_over() {
            let count = PER_ISLAND * self.islands.len();
            let (nursery, islands, seed, batch) =
                (&self.nursery, &self.islands, self.seed, self.batch);
            let most = self.most();
            let end = |index: usize, _: &OneStep| {
                let number = batch * 1_000_000 + index as u64;
                let mut draws = Draws::new(seed, "identify.gp.offspring", number);
                nursery.offspring(islands, index % islands.len(), most, &mut draws)
            };
            let making = Making { begin: &|_| Ok(OneStep::default()), end: &end };
            let before = self.parts.progress();
            if !self.parts.advance(count, budget, &making) {
                return false;
            }
            // The lanes had budgets of their own: what they spent on this batch is taken from the slice's.
            let spent = (count as f64 - before).max(0.0) as u64;
            let _ = budget.spend(spent.div_ceil(budget.threads().count().max(1) as u64));
            let offspring = std::mem::take(&mut self.parts).into_done();
            self.take(offspring);
        }
        true
    }

    fn progress(&self) -> Progress {
        if self.is_over() {
            return Progress { done: 1.0, total: 1.0, unit: text!("batches") };
        }
        let share = self.parts.progress() / (PER_ISLAND * self.islands.len()) as f64;
        let done = self.batch as f64 + share;
        Progress { done, total: self.stop.batches as f64, unit: text!("batches") }
    }

    fn partial(&self) -> Archive {
        self.best.clone()
    }
}
