//! The cuts of a plan on the simulator: each a short steady run of the scenario's plant at constant feed, its
//! force and Ra read with measuring noise.
//!
//! Force is the mean over the steady part of the largest forces of the control periods with all that shakes them
//! ([`force_dyn_n`](crate::run::signals::Row::force_dyn_n)): what a controller of this plant sees. Ra is the mean
//! of the produced one over the same part. To each a normal deviate is added, drawn from the seed and the number of
//! the run: neither order nor threads show in it.

use serde::Serialize;

use super::assess::MeasuringNoise;
use super::plan::ExperimentPlan;
use crate::base::language::{text, tr};
use crate::base::rng::Stream;
use crate::base::stats;
use crate::blocks::control::ControllerKind;
use crate::models::disturbances::Disturbances;
use crate::run::edits::Edits;
use crate::run::end::End;
use crate::run::job::{Budget, Job, Progress};
use crate::run::one_run::Run;
use crate::run::parts::{Making, Parts};
use crate::run::scenario::Scenario;
use crate::run::signals::{Row, flag, signal};

/// A cut lasts so long, and is read from its steady part on, s (chosen: some ten turns at 800 1/min).
const CUT_S: f64 = 1.3;
const STEADY_S: f64 = 0.5;
/// No cut is longer than the longest path, mm.
const LONGEST_MM: f64 = 20_000.0;

/// What was measured of a cut.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct MeasuredCut {
    /// Force, N.
    pub force_n: Option<f64>,
    /// Roughness, um.
    pub ra_um: Option<f64>,
    /// Why nothing was measured.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub problem: Option<String>,
}

impl MeasuredCut {
    /// Whether force and roughness were measured.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        self.force_n.is_some() && self.ra_um.is_some()
    }
}

/// The cuts of a plan.
#[derive(Clone, Debug)]
pub struct MeasureJob {
    cuts: Cuts,
    done: Parts<Run, MeasuredCut>,
}

#[derive(Clone, Debug)]
struct Cuts {
    scenarios: Vec<Scenario>,
    noise: MeasuringNoise,
    seed: u64,
}

/// A scenario whose cut is short, steady and straight.
///
/// # Errors
/// A setting that does not go with such a cut.
pub fn steady(base: &Scenario) -> Result<Scenario, String> {
    let steady = base.with(|s| {
        s.controller.kind = ControllerKind::ConstantFeed;
        s.workpiece.cuts.clear();
        s.workpiece.depth_steps.clear();
        s.workpiece.radial_steps.clear();
        s.disturbances = Disturbances::default();
        s.workpiece.length_mm = LONGEST_MM;
        s.program.cut_feeds_mm_min.clear();
        s.run.duration_s = CUT_S;
        s.run.record_every = s.run.steps_per_control;
    });
    steady.map_err(|error| error.to_string())
}

/// Force in N and Ra in um over the steady part of a cut, without measuring noise.
#[must_use]
pub fn steady_values(run: &Run) -> [Option<f64>; 2] {
    let recording = run.recording();
    let first = recording.index_at(STEADY_S);
    let in_cut = |row: &&Row| !row.has(flag::AIR);
    let rows: Vec<&Row> = recording.rows().iter().skip(first).filter(in_cut).collect();
    let force = stats::mean(rows.iter().map(|row| row.force_dyn_n));
    let ra = signal("ra_um").map(|signal| signal.value);
    [force, ra.and_then(|ra| stats::mean(rows.iter().filter_map(|row| ra(row))))]
}

impl MeasureJob {
    /// The cuts of a plan on the plant of a scenario.
    ///
    /// # Errors
    /// Names the run and the setting that do not go together.
    pub fn new(
        plan: &ExperimentPlan,
        base: &Scenario,
        noise: MeasuringNoise,
        seed: u64,
    ) -> Result<Self, String> {
        let base = steady(base)?;
        let seeds = Stream::new(seed, "experiment.run.seed");
        let scenarios = plan
            .runs
            .iter()
            .map(|run| {
                let scenario = plan.scenario(&base, run)?;
                let seed = seeds.bits(run.run as u64) as u32;
                scenario.with(|s| s.run.seed = seed).map_err(|error| error.to_string())
            })
            .collect::<Result<_, String>>()?;
        Ok(Self { cuts: Cuts { scenarios, noise, seed }, done: Parts::default() })
    }

    /// What was measured of the first runs, in standard order.
    #[must_use]
    pub fn measured(&self) -> &[MeasuredCut] {
        self.done.done()
    }
}

impl Cuts {
    fn read(&self, number: usize, run: &Run) -> MeasuredCut {
        match run.end() {
            Some(End::TimeLimit | End::PathDone) | None => {}
            Some(
                end @ (End::Crash(_)
                | End::Breakage(_)
                | End::Fault(_)
                | End::Refused(_)
                | End::Script(_)
                | End::Overload(_)),
            ) => {
                return MeasuredCut { problem: Some(end.to_string()), ..MeasuredCut::default() };
            }
        }
        let [force, ra] = steady_values(run);
        let noisy = |value: Option<f64>, label: &str, deviation: f64| {
            let draw = Stream::new(self.seed, label).normal(number as u64);
            value.map(|value| value + deviation * draw).filter(|value| *value > 0.0)
        };
        let cut = MeasuredCut {
            force_n: noisy(force, "experiment.force", self.noise.force_n),
            ra_um: noisy(ra, "experiment.ra", self.noise.ra_um),
            problem: None,
        };
        let problem = match (cut.force_n, cut.ra_um) {
            (None, _) => Some(tr("no chip is cut").to_owned()),
            (Some(_), None) => {
                Some(tr("its Ra lies beyond the end of the plant's model").to_owned())
            }
            (Some(_), Some(_)) => None,
        };
        MeasuredCut { problem, ..cut }
    }
}

/// A step is one of the plant in one of the cuts.
impl Job for MeasureJob {
    /// What was measured of the first runs, in standard order.
    type Partial = Vec<MeasuredCut>;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        let cuts = &self.cuts;
        let begin = |number: usize| Ok(Run::new(&cuts.scenarios[number], &Edits::none()));
        let end = |number: usize, run: &Run| cuts.read(number, run);
        let making = Making { begin: &begin, end: &end };
        self.done.advance(cuts.scenarios.len(), budget, &making)
    }

    fn progress(&self) -> Progress {
        let total = self.cuts.scenarios.len() as f64;
        Progress { done: self.done.progress(), total, unit: text!("cuts") }
    }

    fn partial(&self) -> Vec<MeasuredCut> {
        self.measured().to_vec()
    }

    fn refusal(&self) -> Option<&str> {
        self.done.refusal()
    }
}
