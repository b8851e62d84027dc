//! How far each row of a published table is met, calibration by calibration.

use serde::Serialize;

use super::super::published::{Bands, PaperId};
use super::{Cell, CellVerdict, PaperRow, PaperTable, TableJob};
use crate::base::language::text;
use crate::blocks::cutting::process::ForceModel;
use crate::models::genetic::Calibration;
use crate::run::job::{Budget, Job, Progress};
use crate::run::parts::{Making, Parts};

/// How far a row is met.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RowMet {
    /// Number of the simulation.
    pub sim: u32,
    /// Final values within their bands.
    pub met: usize,
    /// Final values.
    pub of: usize,
    /// The largest residual of its final values, in bands; not a number without contact, which is null in JSON.
    pub worst_bands: f64,
}

/// How far the rows are met in a calibration.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CalibrationMet {
    /// The calibration's id.
    pub calibration: &'static str,
    /// Its rows.
    pub rows: Vec<RowMet>,
}

impl CalibrationMet {
    /// Final values within their bands, and all of them.
    #[must_use]
    pub fn met(&self) -> [usize; 2] {
        let sum = |of: fn(&RowMet) -> usize| self.rows.iter().map(of).sum();
        [sum(|row| row.met), sum(|row| row.of)]
    }
}

/// Residuals of a row's final values over their bands.
fn bands_off(row: &PaperRow, bands: &Bands) -> [f64; 4] {
    let [force, feed, speed, ra] = row.compared();
    let percent = |cell: &Cell, band: f64| cell.residual_percent.abs() / band;
    [
        percent(force, bands.force_percent),
        percent(feed, bands.feed_percent),
        percent(speed, bands.speed_percent),
        ra.residual.abs() / bands.ra_um,
    ]
}

fn met(table: &PaperTable) -> CalibrationMet {
    let row = |row: &PaperRow| {
        let cells = row.compared();
        let off = bands_off(row, &table.bands);
        let worst = |worst: f64, off: &f64| if off.is_nan() { *off } else { worst.max(*off) };
        RowMet {
            sim: row.sim,
            met: cells.iter().filter(|cell| cell.verdict == CellVerdict::Met).count(),
            of: cells.len(),
            worst_bands: off.iter().fold(0.0, worst),
        }
    };
    CalibrationMet { calibration: table.calibration, rows: table.rows.iter().map(row).collect() }
}

/// A paper's table in every calibration that it can be run in, the plant's force from the formula.
#[derive(Clone, Debug)]
pub struct CalibrationsJob {
    paper: PaperId,
    tables: Parts<TableJob, CalibrationMet>,
}

impl CalibrationsJob {
    /// The table of a paper, not yet begun.
    #[must_use]
    pub fn new(paper: PaperId) -> Self {
        Self { paper, tables: Parts::default() }
    }
}

/// A step is one of the plant.
impl Job for CalibrationsJob {
    /// The calibrations that are done, in their order.
    type Partial = Vec<CalibrationMet>;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        let paper = self.paper;
        let of = Calibration::PUBLISHED;
        let making = Making {
            begin: &|number: usize| Ok(TableJob::new(paper, of[number], ForceModel::Formula)),
            end: &|_: usize, job: &TableJob| met(&job.partial()),
        };
        self.tables.advance(of.len(), budget, &making)
    }

    fn progress(&self) -> Progress {
        let total = Calibration::PUBLISHED.len() as f64;
        Progress { done: self.tables.progress(), total, unit: text!("calibrations") }
    }

    fn partial(&self) -> Vec<CalibrationMet> {
        self.tables.done().to_vec()
    }

    fn refusal(&self) -> Option<&str> {
        self.tables.refusal()
    }
}
