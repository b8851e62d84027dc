//! The ten rows of 2007 Table 3 on a plant, with SDNRP and Tracking on the models found and on the papers' own.

use serde::Serialize;

use super::WayPlant;
use super::models::{FoundModel, FoundRole};
use crate::base::math::extent;
use crate::base::stats;
use crate::base::units::percent_from_ratio;
use crate::blocks::control::ControllerKind;
use crate::models::genetic::{Calibration, FormulaSettings};
use crate::published::{PaperId, TableRow};
use crate::run::one_run::Run;
use crate::run::recording::Recording;
use crate::run::scenario::Scenario;

/// Final values are those after so long, as in the paper, s.
const ROW_S: f64 = 15.0;
/// No run reaches the end of such a path, mm.
const PATH_MM: f64 = 20_000.0;

/// Swing of the force from which on a run counts as not at rest; the teeth alone make up to 10 %, percent (chosen).
const SWINGING_PERCENT: f64 = 25.0;

steadycut_core::choice! {
    /// Whose models a controller has.
    pub enum ModelSource {
        /// The papers' own, identified from the published table.
        Papers = "papers", "the papers' models";
        /// Those found from the cuts.
        Found = "found", "the models found";
    }
}

/// Who cuts the rows: controller and models.
pub const ENTRANTS: [(ControllerKind, ModelSource); 4] = [
    (ControllerKind::Sdnrp, ModelSource::Papers),
    (ControllerKind::Sdnrp, ModelSource::Found),
    (ControllerKind::Tracking, ModelSource::Papers),
    (ControllerKind::Tracking, ModelSource::Found),
];

/// How a run of a row came out.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RowOutcome {
    /// The controller.
    pub controller: &'static str,
    /// Whose models.
    pub models: ModelSource,
    /// Final Ra, um; none where it lies beyond the plant's model, or nothing was cut at the end.
    pub ra_um: Option<f64>,
    /// Its deviation from the target, percent.
    pub ra_deviation_percent: Option<f64>,
    /// Final force, N.
    pub force_n: Option<f64>,
    /// Final feed, mm/min.
    pub feed_mm_min: f64,
    /// Final speed, 1/min.
    pub speed_rpm: f64,
    /// How far the force still swings over the last second, largest less least, percent of its mean.
    pub swing_percent: Option<f64>,
    /// Whether target, force, feed and speed lie within the ranges that the models were found on; none of the
    /// papers' models.
    pub within: Option<bool>,
    /// How the run ended.
    pub end: String,
}

/// A row of the table.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct WayRow {
    /// Number of the simulation.
    pub sim: u32,
    /// Target, um.
    pub ra_target_um: f64,
    /// Deviation of the printed final Ra from the target, percent.
    pub printed_deviation_percent: f64,
    /// What came out, in the order of [`ENTRANTS`].
    pub outcomes: Vec<RowOutcome>,
}

impl RowOutcome {
    /// Whether the force has not come to rest: its mean over the last second says little then.
    #[must_use]
    pub fn swings(&self) -> bool {
        self.swing_percent.is_some_and(|percent| percent > SWINGING_PERCENT)
    }
}

fn swing_percent(run: &Run) -> Option<f64> {
    let recording = run.recording();
    let rows = Recording::last_second(recording.rows(), recording.row_s());
    let forces = || rows.iter().map(|row| row.force_n);
    let [least, most] = extent(forces());
    let mean = stats::mean(forces()).filter(|mean| *mean > 0.0)?;
    Some(percent_from_ratio((most - least) / mean))
}

/// What the rows are run with.
#[derive(Clone, Debug)]
pub struct RowRuns {
    rows: Vec<TableRow>,
    plant: WayPlant,
    base: Scenario,
    /// Feed and speed at the start tooth by tooth: the middle of the line.
    start: [f64; 2],
    formulas: FormulaSettings,
    models: Vec<FoundModel>,
}

impl RowRuns {
    /// The first `rows` rows on a plant.
    #[must_use]
    pub fn new(
        rows: usize,
        plant: WayPlant,
        base: &Scenario,
        start: [f64; 2],
        formulas: FormulaSettings,
        models: Vec<FoundModel>,
    ) -> Self {
        let mut all = PaperId::Sdnrp2007.rows();
        all.truncate(rows);
        Self { rows: all, plant, base: base.clone(), start, formulas, models }
    }

    /// Number of runs.
    #[must_use]
    pub fn count(&self) -> usize {
        self.rows.len() * ENTRANTS.len()
    }

    /// A target with a controller on models.
    ///
    /// # Errors
    /// A setting that does not go with the plant.
    pub fn scenario(
        &self,
        row: &TableRow,
        controller: ControllerKind,
        source: ModelSource,
    ) -> Result<Scenario, String> {
        let [feed, speed] = match self.plant {
            WayPlant::Formula => [row.feed_initial_mm_min, row.spindle_initial_rpm],
            WayPlant::Mechanistic => self.start,
        };
        let scenario = self.base.with(|s| {
            s.target.ra_um = row.ra_desired_um;
            s.controller.kind = controller;
            s.program.feed_mm_min = feed;
            s.program.spindle_rpm = speed;
            s.workpiece.length_mm = PATH_MM;
            s.run.duration_s = ROW_S;
            if source == ModelSource::Found {
                s.belief.calibration = Calibration::Formula;
                s.formula = self.formulas.clone();
            }
        });
        scenario.map_err(|error| error.to_string())
    }

    /// The scenario of a run, by its number.
    ///
    /// # Errors
    /// As [`Self::scenario`].
    pub fn run_scenario(&self, number: usize) -> Result<Scenario, String> {
        let (controller, source) = ENTRANTS[number % ENTRANTS.len()];
        self.scenario(&self.rows[number / ENTRANTS.len()], controller, source)
    }

    /// What a run gave.
    #[must_use]
    pub fn outcome(&self, number: usize, run: &Run) -> RowOutcome {
        let (controller, source) = ENTRANTS[number % ENTRANTS.len()];
        let row = &self.rows[number / ENTRANTS.len()];
        let metrics = run.metrics();
        let (feed, speed) = (metrics.feed_final_mm_min, metrics.spindle_final_rpm);
        let force = metrics.force_final_n;
        let within = (source == ModelSource::Found)
            .then(|| self.within(row.ra_desired_um, force, [feed, speed]));
        RowOutcome {
            controller: controller.id(),
            models: source,
            ra_um: metrics.ra_final_um,
            ra_deviation_percent: metrics.ra_deviation_percent,
            force_n: force,
            feed_mm_min: feed,
            speed_rpm: speed,
            swing_percent: swing_percent(run),
            within,
            end: run.end().map_or_else(String::new, ToString::to_string),
        }
    }

    fn within(&self, ra_um: f64, force_n: Option<f64>, cut: [f64; 2]) -> bool {
        self.models.iter().all(|found| {
            let at: Option<Vec<f64>> = match found.role {
                FoundRole::ForceOfRa => Some(vec![ra_um]),
                FoundRole::Force => Some(cut.to_vec()),
                FoundRole::Feed | FoundRole::Speed | FoundRole::Ra => force_n.map(|f| vec![f]),
            };
            at.is_some_and(|at| {
                at.iter().zip(&found.ranges).all(|(x, (_, [low, high]))| (low..=high).contains(&x))
            })
        })
    }

    /// The rows that are done, of outcomes in the order of the runs.
    #[must_use]
    pub fn told(&self, outcomes: &[RowOutcome]) -> Vec<WayRow> {
        let whole = outcomes.chunks_exact(ENTRANTS.len());
        whole
            .zip(&self.rows)
            .map(|(outcomes, row)| WayRow {
                sim: row.sim,
                ra_target_um: row.ra_desired_um,
                printed_deviation_percent: percent_from_ratio(
                    row.ra_produced_um / row.ra_desired_um - 1.0,
                ),
                outcomes: outcomes.to_vec(),
            })
            .collect()
    }
}
