//! Long work: a job advances in slices, reports its progress, can be stopped between any two of its
//! steps and continued later, and gives a result that can be read meanwhile.
//!
//! What a job gives depends on nothing but what it was made from: not on how it is sliced, not on
//! whether it was stopped on the way, not on the number of threads. The pure layers have neither
//! threads nor a clock: a front end hands its threads in with every slice ([`Threads`]), and works
//! out the time that is left by its own clock ([`Progress::left_s`]).
//!
//! ```
//! use steadycut_core::run::edits::Edits;
//! use steadycut_core::run::job::{Budget, Job};
//! use steadycut_core::run::one_run::Run;
//! use steadycut_core::run::scenario::Scenario;
//!
//! let mut run = Run::new(&Scenario::default(), &Edits::none());
//! while !Job::advance(&mut run, &Budget::steps(5_000)) {
//!     println!("{:.0} %", 100.0 * run.progress().share());
//! }
//! ```

use std::cell::Cell;

use crate::base::language::tr;

/// Long work of one kind or another.
pub trait Job: Send {
    /// What can be read of it at any time, finished or not.
    type Partial;

    /// Advances until the budget is spent, the job is cancelled or over; `true` when it is over.
    /// An advanced job that was over before stays as it is.
    fn advance(&mut self, budget: &Budget<'_>) -> bool;

    /// How far it is.
    fn progress(&self) -> Progress;

    /// What it has found so far.
    fn partial(&self) -> Self::Partial;

    /// Why it is over before its end, if it is.
    fn refusal(&self) -> Option<&str> {
        None
    }

    /// [`Self::advance`] by at most `steps` of its steps, on one thread.
    fn advance_by(&mut self, steps: u64) -> bool {
        self.advance(&Budget::steps(steps))
    }

    /// [`Self::advance`] to its end, on one thread.
    fn to_end(&mut self) {
        self.advance(&Budget::all());
    }
}

/// How far a job is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// What is done, in `unit`; the part under way counts by its share.
    pub done: f64,
    /// All there is to do, in `unit`. Where the end is not known before, the most it can be.
    pub total: f64,
    /// What is counted, in the plural.
    pub unit: &'static str,
}

impl Progress {
    /// Share that is done, 0 to 1; 1 where there is nothing to do.
    #[must_use]
    pub fn share(&self) -> f64 {
        if self.total > 0.0 { (self.done / self.total).clamp(0.0, 1.0) } else { 1.0 }
    }

    /// Time that is left in s, where `worked_s` seconds have brought the job from the share
    /// `from` to where it is now; none before it has come anywhere.
    #[must_use]
    pub fn left_s(&self, worked_s: f64, from: f64) -> Option<f64> {
        let come = self.share() - from;
        (come > 0.0).then(|| worked_s * (1.0 - self.share()) / come)
    }
}

impl std::fmt::Display for Progress {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&tr!(
            "{done:.0} of {total:.0} {unit}",
            done = self.done.floor(),
            total = self.total,
            unit = tr(self.unit)
        ))
    }
}

/// The threads of a front end.
pub trait Threads: Sync {
    /// How many there are, at least 1.
    fn count(&self) -> usize;

    /// Calls `work` with 0 to `lanes` - 1, at the same time or one after the other, and comes back
    /// when all calls have.
    fn run(&self, lanes: usize, work: &(dyn Fn(usize) + Sync));
}

/// The thread that calls, and no other.
#[derive(Clone, Copy, Debug)]
pub struct OneThread;

impl Threads for OneThread {
    fn count(&self) -> usize {
        1
    }

    fn run(&self, lanes: usize, work: &(dyn Fn(usize) + Sync)) {
        (0..lanes).for_each(work);
    }
}

/// The budget of one slice: a number of the job's steps on each thread. What a step is, and what it
/// costs, is the job's own; front ends measure how long a slice took and give the next one more or
/// less.
pub struct Budget<'a> {
    left: Cell<u64>,
    threads: &'a dyn Threads,
    cancelled: &'a (dyn Fn() -> bool + Sync),
}

impl Budget<'static> {
    /// At most `steps` steps, on one thread.
    #[must_use]
    pub fn steps(steps: u64) -> Self {
        Self { left: Cell::new(steps), threads: &OneThread, cancelled: &|| false }
    }

    /// All steps, on one thread.
    #[must_use]
    pub fn all() -> Self {
        Self::steps(u64::MAX)
    }
}

impl<'a> Budget<'a> {
    /// The same on several threads, until `cancelled` says so: it is asked between any two steps, from
    /// every thread.
    #[must_use]
    pub fn on<'b>(
        &self,
        threads: &'b dyn Threads,
        cancelled: &'b (dyn Fn() -> bool + Sync),
    ) -> Budget<'b> {
        Budget { left: self.left.clone(), threads, cancelled }
    }

    /// Takes up to `steps` from the budget; how many were left, none once cancelled.
    #[must_use]
    pub fn spend(&self, steps: u64) -> u64 {
        if (self.cancelled)() {
            return 0;
        }
        let granted = steps.min(self.left.get());
        self.left.set(self.left.get() - granted);
        granted
    }

    /// Takes one step from the budget; `false` where none is left, or once cancelled.
    #[must_use]
    pub fn step(&self) -> bool {
        self.spend(1) == 1
    }

    /// Puts back what was taken and not needed.
    pub fn put_back(&self, steps: u64) {
        self.left.set(self.left.get().saturating_add(steps));
    }

    /// Whether nothing can be taken.
    #[must_use]
    pub fn is_spent(&self) -> bool {
        self.left.get() == 0 || (self.cancelled)()
    }

    /// The threads.
    #[must_use]
    pub fn threads(&self) -> &'a dyn Threads {
        self.threads
    }

    /// Makes budgets for single threads, each with what this one has left.
    pub(super) fn lanes(&self) -> impl Fn() -> Budget<'a> + Sync + use<'a> {
        let (left, cancelled) = (self.left.get(), self.cancelled);
        move || Budget { left: Cell::new(left), threads: &OneThread, cancelled }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicUsize, Ordering};

    use super::*;

    #[test]
    fn a_budget_is_spent_once_and_what_is_put_back_counts_again() {
        let budget = Budget::steps(5);
        assert_eq!((budget.spend(3), budget.spend(3), budget.spend(3)), (3, 2, 0));
        assert!(budget.is_spent() && !budget.step());
        budget.put_back(1);
        assert!(budget.step() && !budget.step());
        assert_eq!(Budget::all().spend(u64::MAX), u64::MAX);
    }

    #[test]
    fn nothing_is_granted_once_cancelled() {
        let asked = AtomicUsize::new(0);
        let cancelled = || asked.fetch_add(1, Ordering::Relaxed) >= 2;
        let budget = Budget::all();
        let budget = budget.on(&OneThread, &cancelled);
        assert!(budget.step() && budget.step() && !budget.step());
    }

    #[test]
    fn time_left_goes_by_what_was_done_since_the_clock_began() {
        let progress = Progress { done: 50.0, total: 100.0, unit: "runs" };
        assert_eq!(progress.left_s(10.0, 0.0), Some(10.0));
        // Gone on with at 40 %.
        assert_eq!(progress.left_s(10.0, 0.4).map(f64::round), Some(50.0));
        assert_eq!(progress.left_s(10.0, 0.5), None);
        assert_eq!(Progress { done: 0.0, total: 0.0, unit: "runs" }.share(), 1.0);
        assert_eq!(Progress { done: 3.9, ..progress }.to_string(), "3 of 100 runs");
    }
}
