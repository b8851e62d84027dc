//! Published tables against runs: the ten simulations of SDNRP 2007, Table 3, and the eight of the
//! 2013 control strategy, Table 1.
//!
//! Every row is a run in time from the printed start values, not a solved equilibrium; the final
//! values are means over the last second of 15 s. [`TableJob`] runs a whole table.

mod calibrations;
mod table_job;

use serde::Serialize;

use super::errata::Erratum;
use super::published::{Bands, PaperId, TableRow};
use crate::base::language::text;
use crate::base::units::percent_from_ratio;
use crate::blocks::cutting::process::ForceModel;
use crate::models::genetic::Calibration;
use crate::run::edits::Edits;
use crate::run::job::Job;
use crate::run::metrics::Metrics;
use crate::run::one_run::{End, Run};
use crate::run::presets;
use crate::run::recording::Recording;
use crate::run::scenario::{Scenario, Settings};
use crate::run::signals::FLAGS;
pub use calibrations::{CalibrationMet, CalibrationsJob, RowMet};
pub use table_job::TableJob;

steadycut_core::choice! {
    /// Whether a reproduced value lies within its band.
    pub enum CellVerdict {
        /// Within the band.
        Met = "met", "met";
        /// Outside the band.
        Missed = "missed", "MISSED";
        /// A start value: given, not reproduced.
        Given = "given", "given";
        /// Reported without a band.
        Reported = "reported", "-";
    }
}

/// One cell of a table.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Cell {
    /// As printed.
    pub printed: f64,
    /// What it is compared with: as printed, or the misprint corrected.
    pub reference: f64,
    /// What the run gave.
    pub reproduced: f64,
    /// Reproduced minus reference.
    pub residual: f64,
    /// The same in percent of the reference.
    pub residual_percent: f64,
    /// Within its band or not.
    pub verdict: CellVerdict,
}

/// One row of a table, the cells named like its columns.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PaperRow {
    /// Number of the simulation.
    pub sim: u32,
    /// Desired roughness, um.
    pub ra_desired_um: Cell,
    /// 2007: desired force; 2013: initial force, N.
    pub force_start_n: Cell,
    /// Feed at the start, mm/min.
    pub feed_initial_mm_min: Cell,
    /// Spindle speed at the start, 1/min.
    pub spindle_initial_rpm: Cell,
    /// Force after 15 s, N.
    pub force_final_n: Cell,
    /// Feed after 15 s, mm/min.
    pub feed_final_mm_min: Cell,
    /// Spindle speed after 15 s, 1/min.
    pub spindle_final_rpm: Cell,
    /// Produced roughness, um.
    pub ra_produced_um: Cell,
    /// Names of states that occurred in the last second: saturation, models outside their range,
    /// `not_at_rest` where the feed still moved by more than 1 %.
    pub out_of_range: Vec<&'static str>,
    /// Deviation of the produced roughness from the desired one, as printed, percent.
    pub ra_deviation_printed_percent: f64,
    /// The same as reproduced, percent.
    pub ra_deviation_reproduced_percent: f64,
    /// What must be said about this row.
    pub note: Option<&'static str>,
}

impl PaperRow {
    /// The four cells of final values.
    #[must_use]
    pub fn compared(&self) -> [&Cell; 4] {
        [
            &self.force_final_n,
            &self.feed_final_mm_min,
            &self.spindle_final_rpm,
            &self.ra_produced_um,
        ]
    }
}

/// A published table against runs.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PaperTable {
    /// The paper's year, as in [`PaperId::id`].
    pub paper: &'static str,
    /// Calibration of plant and controller.
    pub calibration: &'static str,
    /// The plant's force model.
    pub plant: &'static str,
    /// The bands of the verdicts.
    pub bands: Bands,
    /// The rows.
    pub rows: Vec<PaperRow>,
    /// Errata of the paper.
    pub errata: &'static [Erratum],
}

impl PaperTable {
    /// Whether every compared cell lies within its band.
    #[must_use]
    pub fn all_met(&self) -> bool {
        let mut cells = self.rows.iter().flat_map(PaperRow::compared);
        cells.all(|cell| cell.verdict == CellVerdict::Met)
    }
}

const NOTE_SIM_10: &str = text!(
    "the paper prints a final force of 195.2 N, most likely a misprint of 190.2 N: the run is compared with 190.2 N. \
     Model K4 (restored) gives 190.2 N for the feed and speed of this row, and with that force its Ra fits those of \
     all other rows"
);

fn cell(printed: f64, reference: f64, reproduced: f64, within: impl Fn(f64, f64) -> bool) -> Cell {
    let residual = reproduced - reference;
    let residual_percent = percent_from_ratio(residual / reference);
    let met = within(residual, residual_percent);
    let verdict = if met { CellVerdict::Met } else { CellVerdict::Missed };
    Cell { printed, reference, reproduced, residual, residual_percent, verdict }
}

/// A final value for a cell: not a number without contact, which meets no band and is null in JSON.
fn final_or_none(value: Option<f64>) -> f64 {
    value.unwrap_or(f64::NAN)
}

fn given(printed: f64, used: f64) -> Cell {
    Cell { verdict: CellVerdict::Given, ..cell(printed, printed, used, |_, _| true) }
}

fn reported(cell: Cell) -> Cell {
    Cell { verdict: CellVerdict::Reported, ..cell }
}

/// The scenario of one simulation, with a calibration of both plant and controller and a force
/// model of the plant.
///
/// # Panics
/// Never for a row of the paper's table and a map of force: a test loads every preset. Tooth by tooth
/// asks for shorter plant steps than the rows have.
#[must_use]
pub fn scenario(
    paper: PaperId,
    sim: u32,
    calibration: Calibration,
    force_model: ForceModel,
) -> Scenario {
    let scenario = presets::load(&paper.preset(sim)).expect("presets are tested");
    let chosen = scenario.with(|settings| {
        settings.plant.calibration = calibration;
        settings.plant.force_model = force_model;
        settings.belief.calibration = calibration;
    });
    chosen.expect("any calibration and any map of force go with a row's plant step")
}

/// Runs one simulation and compares it with its row; `change` may alter the scenario first, which
/// is how tests show that the comparison can fail.
///
/// # Panics
/// As [`scenario`], or where `change` breaks a rule.
#[must_use]
pub fn row(
    paper: PaperId,
    printed: &TableRow,
    calibration: Calibration,
    force_model: ForceModel,
    change: impl FnOnce(&mut Settings),
) -> PaperRow {
    let mut scenario = scenario(paper, printed.sim, calibration, force_model);
    scenario.change(change).expect("a change within the ranges");
    judge(paper, printed, force_model, &Run::complete(&scenario, &Edits::none()))
}

/// Compares the run of a simulation with its row.
fn judge(paper: PaperId, printed: &TableRow, force_model: ForceModel, run: &Run) -> PaperRow {
    let metrics: Metrics = run.metrics();
    let start = run.recording().rows()[0];
    let bands = paper.bands();
    let judged = |printed: f64, reproduced: f64, band_percent: f64| {
        cell(printed, printed, reproduced, |_, percent| percent.abs() <= band_percent)
    };
    let mut row = PaperRow {
        sim: printed.sim,
        ra_desired_um: given(printed.ra_desired_um, start.ra_target_um),
        force_start_n: match paper {
            PaperId::Sdnrp2007 => {
                judged(printed.force_start_n, start.force_ref_n, bands.force_percent)
            }
            // Where this comes from is not said: the formula at the row's own start feed and
            // speed misses it by 27 to 36 N.
            PaperId::Strategy2013 => reported(judged(printed.force_start_n, start.force_n, 0.0)),
        },
        feed_initial_mm_min: given(printed.feed_initial_mm_min, start.feed_mm_min),
        spindle_initial_rpm: given(printed.spindle_initial_rpm, start.spindle_rpm),
        force_final_n: cell(
            printed.force_final_n,
            printed.force_reference_n(),
            final_or_none(metrics.force_final_n),
            |_, percent| percent.abs() <= bands.force_percent,
        ),
        feed_final_mm_min: judged(
            printed.feed_final_mm_min,
            metrics.feed_final_mm_min,
            bands.feed_percent,
        ),
        spindle_final_rpm: judged(
            printed.spindle_final_rpm,
            metrics.spindle_final_rpm,
            bands.speed_percent,
        ),
        ra_produced_um: cell(
            printed.ra_produced_um,
            printed.ra_produced_um,
            final_or_none(metrics.ra_final_um),
            |residual, _| residual.abs() <= bands.ra_um,
        ),
        out_of_range: states_at_the_end(run),
        ra_deviation_printed_percent: percent_from_ratio(
            printed.ra_produced_um / printed.ra_desired_um - 1.0,
        ),
        ra_deviation_reproduced_percent: final_or_none(metrics.ra_deviation_percent),
        note: (paper == PaperId::Sdnrp2007 && printed.sim == 10).then_some(NOTE_SIM_10),
    };
    if !force_model.is_formula() {
        // The table's forces come from the formula; the neural plant's are others by nature.
        row.force_final_n = reported(row.force_final_n);
        row.feed_final_mm_min = reported(row.feed_final_mm_min);
        row.spindle_final_rpm = reported(row.spindle_final_rpm);
        row.ra_produced_um = reported(row.ra_produced_um);
    }
    row
}

fn states_at_the_end(run: &Run) -> Vec<&'static str> {
    let tail = Recording::last_second(run.recording().rows(), run.recording().row_s());
    let held = FLAGS.iter().filter(|flag| tail.iter().any(|row| row.has(flag.bit)));
    let mut names: Vec<&'static str> = held.map(|flag| flag.id).collect();
    let feeds = tail.iter().map(|row| row.feed_mm_min);
    let (low, high) = feeds.fold((f64::INFINITY, 0.0_f64), |(l, h), f| (l.min(f), h.max(f)));
    if high - low > 0.01 * high {
        names.push("not_at_rest");
    }
    match run.end() {
        Some(End::Fault(fault)) => names.push(fault.signal),
        Some(End::Crash(_)) => names.push("crash"),
        Some(End::Breakage(_)) => names.push("breakage"),
        Some(End::Script(_)) => names.push("script"),
        Some(End::PathDone | End::TimeLimit | End::Overload(_) | End::Refused(_)) | None => {}
    }
    names
}

/// Re-runs all simulations of a paper's table.
///
/// ```
/// use steadycut_core::blocks::cutting::force_model::ForceModel;
/// use steadycut_core::models::genetic::Calibration;
/// use steadycut_study::{papers, published::PaperId};
///
/// let table = papers::table(PaperId::Sdnrp2007, Calibration::Identified, ForceModel::Formula);
/// assert_eq!(table.rows.len(), 10);
/// assert!(table.all_met(), "all cells of Table 3 lie within their bands");
/// ```
#[must_use]
pub fn table(paper: PaperId, calibration: Calibration, force_model: ForceModel) -> PaperTable {
    let mut job = TableJob::new(paper, calibration, force_model);
    job.to_end();
    job.partial()
}
