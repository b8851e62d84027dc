//! How a search stands while it is under way: cheap enough to be asked for after every slice.

use serde::Serialize;

use super::job::GpJob;
use super::written::formula;

/// What a job is at.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum GpStage {
    /// It searches.
    Search,
    /// The paper's own search runs.
    Paper,
    /// The formulas are judged at rows left out.
    LeftOut,
    /// It is over.
    Over,
}

/// A formula of the front so far.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct StandingFormula {
    /// The formula of the columns.
    pub formula: String,
    /// Its nodes.
    pub size: usize,
    /// Root mean square of its residuals on the rows that are searched, in the target's unit.
    pub error: f64,
}

/// How a search stands.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct GpStanding {
    /// What it is at.
    pub stage: GpStage,
    /// Batches that are over.
    pub batches: u64,
    /// Most batches; it ends earlier where nothing is gained any more.
    pub most_batches: u64,
    /// Formulas that were made and fitted.
    pub evaluations: u64,
    /// The formulas, the smallest first; none is certified or judged at rows left out yet.
    pub front: Vec<StandingFormula>,
}

impl GpJob {
    /// How it stands: the front so far, with the error of each size.
    #[must_use]
    pub fn standing(&self) -> GpStanding {
        let search = self.search();
        let rows = search.nursery().rows.len() as f64;
        let one = |candidate: &super::archive::FittedSum| {
            let written = formula(&candidate.sum, &self.problem().columns).ok()?;
            Some(StandingFormula {
                size: written.size(),
                formula: written.to_string(),
                error: (candidate.left / rows).sqrt(),
            })
        };
        let mut front: Vec<StandingFormula> = Vec::new();
        for next in self.front().iter().filter_map(one) {
            // Simplified, one may have come down to the size of a worse one before it.
            while front.last().is_some_and(|last| last.size >= next.size) {
                front.pop();
            }
            front.push(next);
        }
        GpStanding {
            stage: self.stage(),
            batches: search.batches(),
            most_batches: self.settings().batches,
            evaluations: search.evaluations(),
            front,
        }
    }
}
