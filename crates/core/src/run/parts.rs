//! A job's independent parts: the runs of a comparison, the points of a chart. They are worked at on as
//! many threads as a slice brings, and their results stand in the order of the parts, so that neither
//! the threads nor the slices show in them.

use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

use super::job::{Budget, Job, Progress};
use crate::base::language::text;

/// Parts, each a job `J` that ends in an outcome `O`.
#[derive(Clone, Debug)]
pub struct Parts<J, O> {
    /// Outcomes of the first parts, without a gap.
    done: Vec<O>,
    /// Outcomes that came before those of parts with smaller numbers.
    ahead: BTreeMap<usize, O>,
    under_way: BTreeMap<usize, J>,
    /// All parts with smaller numbers have been begun.
    begun: usize,
    /// The first part that could not be begun, and why.
    refused: Option<(usize, String)>,
}

impl<J, O> Default for Parts<J, O> {
    fn default() -> Self {
        Self {
            done: Vec::new(),
            ahead: BTreeMap::new(),
            under_way: BTreeMap::new(),
            begun: 0,
            refused: None,
        }
    }
}

/// How a part is begun, and what it has given at its end.
pub struct Making<'a, J, O> {
    /// Begins a part.
    pub begin: &'a (dyn Fn(usize) -> Result<J, String> + Sync),
    /// What a part has given that is over.
    pub end: &'a (dyn Fn(usize, &J) -> O + Sync),
}

/// Where a part stands after a slice.
enum Stand<J, O> {
    UnderWay(J),
    Over(O),
    Refused(String),
}

impl<J: Job, O: Send> Parts<J, O> {
    /// Goes on with `count` parts; `true` when all are over, or one could not be begun.
    pub fn advance(
        &mut self,
        count: usize,
        budget: &Budget<'_>,
        making: &Making<'_, J, O>,
    ) -> bool {
        if self.is_over(count) {
            return true;
        }
        let waiting = std::mem::take(&mut self.under_way);
        let lanes = (waiting.len() + count.saturating_sub(self.begun)).max(1);
        let queue = Mutex::new((waiting, self.begun));
        let stands = Mutex::new(Vec::new());
        let next = || {
            let mut queue = queue.lock().unwrap_or_else(PoisonError::into_inner);
            let (waiting, begun) = &mut *queue;
            if let Some((index, job)) = waiting.pop_first() {
                return Some((index, Some(job)));
            }
            (*begun < count).then(|| {
                *begun += 1;
                (*begun - 1, None)
            })
        };
        let lane_budget = budget.lanes();
        let work = |_lane: usize| {
            let budget = lane_budget();
            let mut mine = Vec::new();
            while !budget.is_spent() {
                let Some((index, job)) = next() else { break };
                let stand = match job.map_or_else(|| (making.begin)(index), Ok) {
                    Err(error) => Stand::Refused(error),
                    Ok(mut job) => {
                        let over = job.advance(&budget);
                        if over {
                            Stand::Over((making.end)(index, &job))
                        } else {
                            Stand::UnderWay(job)
                        }
                    }
                };
                let stop = !matches!(stand, Stand::Over(_));
                mine.push((index, stand));
                if stop {
                    break;
                }
            }
            stands.lock().unwrap_or_else(PoisonError::into_inner).append(&mut mine);
        };
        let threads = budget.threads();
        threads.run(threads.count().clamp(1, lanes), &work);
        let (waiting, begun) = queue.into_inner().unwrap_or_else(PoisonError::into_inner);
        (self.under_way, self.begun) = (waiting, begun);
        for (index, stand) in stands.into_inner().unwrap_or_else(PoisonError::into_inner) {
            self.take(index, stand);
        }
        while let Some(outcome) = self.ahead.remove(&self.done.len()) {
            self.done.push(outcome);
        }
        self.is_over(count)
    }

    fn take(&mut self, index: usize, stand: Stand<J, O>) {
        match stand {
            Stand::UnderWay(job) => {
                self.under_way.insert(index, job);
            }
            Stand::Over(outcome) => {
                self.ahead.insert(index, outcome);
            }
            Stand::Refused(error) => {
                if self.refused.as_ref().is_none_or(|(first, _)| index < *first) {
                    self.refused = Some((index, error));
                }
            }
        }
    }

    /// Parts that are over, those under way by their share.
    #[must_use]
    pub fn progress(&self) -> f64 {
        let shares: f64 = self.under_way.values().map(|job| job.progress().share()).sum();
        (self.done.len() + self.ahead.len()) as f64 + shares
    }
}

impl<J, O> Parts<J, O> {
    fn is_over(&self, count: usize) -> bool {
        self.refused.is_some() || self.done.len() >= count
    }

    /// Outcomes of the first parts, in their order, without a gap.
    #[must_use]
    pub fn done(&self) -> &[O] {
        &self.done
    }

    /// All outcomes, once all parts are over.
    #[must_use]
    pub fn into_done(self) -> Vec<O> {
        self.done
    }

    /// The part after those, where it is under way.
    #[must_use]
    pub fn next_under_way(&self) -> Option<&J> {
        self.under_way.get(&self.done.len())
    }

    /// The outcome of a part that is over, or the part where it is under way.
    #[must_use]
    pub fn part(&self, index: usize) -> Option<Result<&O, &J>> {
        let over = self.done.get(index).or_else(|| self.ahead.get(&index)).map(Ok);
        over.or_else(|| self.under_way.get(&index).map(Err))
    }

    /// Number of parts that have been begun.
    #[must_use]
    pub fn begun(&self) -> usize {
        self.begun
    }

    /// Why a part could not be begun, if one could not.
    #[must_use]
    pub fn refusal(&self) -> Option<&str> {
        self.refused.as_ref().map(|(_, error)| error.as_str())
    }
}

/// A part that is done in one step: all its work is in what it gives.
#[derive(Clone, Debug, Default)]
pub struct OneStep {
    done: bool,
}

impl Job for OneStep {
    type Partial = ();

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        self.done = self.done || budget.step();
        self.done
    }

    fn progress(&self) -> Progress {
        let done = if self.done { 1.0 } else { 0.0 };
        Progress { done, total: 1.0, unit: text!("steps") }
    }

    fn partial(&self) {}
}
