//! All simulations of a paper's table, as a job.

use super::super::errata;
use super::super::published::PaperId;
use super::{PaperRow, PaperTable, judge, scenario};
use crate::base::language::text;
use crate::blocks::cutting::process::ForceModel;
use crate::models::genetic::Calibration;
use crate::run::edits::Edits;
use crate::run::job::{Budget, Job, Progress};
use crate::run::one_run::Run;
use crate::run::parts::{Making, Parts};

/// Re-runs the simulations of a paper's table, each compared with its row when it is over.
#[derive(Clone, Debug)]
pub struct TableJob {
    paper: PaperId,
    calibration: Calibration,
    force_model: ForceModel,
    rows: Parts<Run, PaperRow>,
}

impl TableJob {
    /// The table of a paper with a calibration of both plant and controller and a force model of the
    /// plant, a map of force.
    #[must_use]
    pub fn new(paper: PaperId, calibration: Calibration, force_model: ForceModel) -> Self {
        Self { paper, calibration, force_model, rows: Parts::default() }
    }
}

/// A step is one of the plant.
impl Job for TableJob {
    /// The table with the first rows that are done.
    type Partial = PaperTable;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        let Self { paper, calibration, force_model, ref mut rows } = *self;
        let printed = paper.rows();
        let making = Making {
            begin: &|row: usize| {
                let scenario = scenario(paper, printed[row].sim, calibration, force_model);
                Ok(Run::new(&scenario, &Edits::none()))
            },
            end: &|row: usize, run: &Run| judge(paper, &printed[row], force_model, run),
        };
        rows.advance(printed.len(), budget, &making)
    }

    fn progress(&self) -> Progress {
        let total = self.paper.rows().len() as f64;
        Progress { done: self.rows.progress(), total, unit: text!("simulations") }
    }

    fn partial(&self) -> PaperTable {
        PaperTable {
            paper: self.paper.id(),
            calibration: self.calibration.id(),
            plant: self.force_model.id(),
            bands: self.paper.bands(),
            rows: self.rows.done().to_vec(),
            errata: errata::of(self.paper),
        }
    }

    fn refusal(&self) -> Option<&str> {
        self.rows.refusal()
    }
}
