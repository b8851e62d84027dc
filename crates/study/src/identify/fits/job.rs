//! A fit as long work: it is begun, steps are made, what was found is told.

use std::sync::Arc;

use super::{AnyWork, FitFault, FitOutcome, FitRequest, MeasuredFitKind};
use crate::base::language::text;
use crate::run::job::{Budget, Job, Progress};

/// The job.
#[derive(Clone)]
pub struct MeasuredFitJob {
    kind: MeasuredFitKind,
    request: Arc<FitRequest>,
    work: Option<AnyWork>,
    steps: usize,
    /// Whether nothing is left but to tell what was found.
    worked: bool,
    found: Option<Arc<Result<FitOutcome, FitFault>>>,
}

impl MeasuredFitJob {
    /// Of a request.
    #[must_use]
    pub fn new(kind: MeasuredFitKind, request: FitRequest) -> Self {
        Self { kind, request: Arc::new(request), work: None, steps: 0, worked: false, found: None }
    }

    /// Tells what was found anew, in the language of now.
    pub fn tell_anew(&mut self) {
        if self.found.take().is_none() {
            return;
        }
        match &self.work {
            Some(work) => self.found = Some(Arc::new(work.outcome())),
            None => self.step(),
        }
    }

    fn step(&mut self) {
        self.steps += 1;
        let Some(work) = &mut self.work else {
            let lack = self.kind.lacks(&self.request);
            let begun = match lack {
                Some(lack) => Err(lack),
                None => AnyWork::begin(self.kind, &self.request),
            };
            match begun {
                Ok(work) => self.work = Some(work),
                Err(fault) => self.found = Some(Arc::new(Err(fault))),
            }
            return;
        };
        if self.worked {
            self.found = Some(Arc::new(work.outcome()));
        } else {
            self.worked = !work.step();
        }
    }
}

impl Job for MeasuredFitJob {
    /// What was found, or why nothing was.
    type Partial = Option<Arc<Result<FitOutcome, FitFault>>>;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        while self.found.is_none() && budget.step() {
            self.step();
        }
        self.found.is_some()
    }

    fn progress(&self) -> Progress {
        let total = (2 + self.kind.about().most_steps) as f64;
        let done = if self.found.is_some() { total } else { (self.steps as f64).min(total - 1.0) };
        Progress { done, total, unit: text!("steps") }
    }

    fn partial(&self) -> Self::Partial {
        self.found.clone()
    }
}
