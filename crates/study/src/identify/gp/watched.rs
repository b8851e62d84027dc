//! A search as a screen watches it: how it stands after every slice, and its report once it is over.

use std::sync::Arc;

use super::job::GpJob;
use super::report::GpReport;
use super::standing::GpStanding;
use crate::run::job::{Budget, Job, Progress};

/// See the head of this file.
#[derive(Clone)]
pub struct WatchedSearch {
    job: GpJob,
    report: Option<Arc<GpReport>>,
}

/// What can be seen of a search at any time.
#[derive(Clone, Debug, PartialEq)]
pub struct SearchSoFar {
    /// How it stands.
    pub standing: GpStanding,
    /// The report, once it is over.
    pub report: Option<Arc<GpReport>>,
}

impl WatchedSearch {
    /// Watches a search, begun or not.
    #[must_use]
    pub fn new(job: GpJob) -> Self {
        Self { job, report: None }
    }

    /// The search itself.
    #[must_use]
    pub fn job(&self) -> &GpJob {
        &self.job
    }

    /// See [`GpJob::end_here`].
    pub fn end_here(&mut self) {
        self.job.end_here();
    }
}

impl Job for WatchedSearch {
    type Partial = SearchSoFar;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        let over = self.job.advance(budget);
        if over && self.report.is_none() {
            self.report = Some(Arc::new(self.job.report()));
        }
        over
    }

    fn progress(&self) -> Progress {
        self.job.progress()
    }

    fn partial(&self) -> SearchSoFar {
        SearchSoFar { standing: self.job.standing(), report: self.report.clone() }
    }
}
