//! The whole way as a job: pilot cuts, cuts, searches, rows.

use super::super::factor::PAPERS_BOX;
use super::super::measure::{MeasureJob, MeasuredCut};
use super::super::plan::ExperimentPlan;
use super::super::sheet::csv;
use super::cuts::plan;
use super::models::{FoundModel, FoundRole, pick, settings};
use super::pilot::Pilot;
use super::report::{WayReport, digest, summary};
use super::rows::{ModelSource, RowOutcome, RowRuns, WayRow};
use super::{FEWEST_CUTS, MOST_CUTS, WayPlant, WaySettings};
use crate::base::language::{text, tr};
use crate::base::units::mm_s_from_mm_min;
use crate::blocks::control::ControllerKind;
use crate::identify::gp::job::{GpJob, GpSettings};
use crate::identify::gp::problem::GpProblem;
use crate::identify::gp::report::GpReport;
use crate::identify::gp::state::GpState;
use crate::models::genetic::FormulaSettings;
use crate::published::PaperId;
use crate::run::edits::Edits;
use crate::run::job::{Budget, Job, Progress};
use crate::run::one_run::Run;
use crate::run::parts::{Making, Parts};
use crate::run::scenario::Scenario;

/// Shares of the whole, percent: pilot cuts, cuts, searches, rows (chosen by what they take).
const SHARES: [f64; 4] = [2.0, 8.0, 75.0, 15.0];
/// The row whose scenario is written: 0.81 um, the paper's example.
const EXAMPLE_SIM: u32 = 5;
/// Its path is so much longer than the programmed feed goes in its time, and a multiple of so many mm.
const EXAMPLE_PATH: [f64; 2] = [1.5, 50.0];

/// The cuts, once they are planned.
#[derive(Clone, Debug)]
struct Planned {
    base: Scenario,
    plan: ExperimentPlan,
    cut_box: [[f64; 2]; 2],
    measure: MeasureJob,
}

/// The rows, once there are models.
#[derive(Clone, Debug)]
struct Running {
    runs: RowRuns,
    done: Parts<Run, RowOutcome>,
}

/// A search that is over.
#[derive(Clone, Debug)]
struct SearchOver {
    report: GpReport,
    state: GpState,
}

/// The way.
#[derive(Clone)]
pub struct WayJob {
    settings: WaySettings,
    plant: WayPlant,
    truth: String,
    rows: usize,
    base: Scenario,
    pilot: Option<Pilot>,
    planned: Option<Planned>,
    problems: Vec<GpProblem>,
    searches: Parts<GpJob, SearchOver>,
    /// Searches of a file, to go on with.
    saved: Vec<Option<GpState>>,
    models: Vec<FoundModel>,
    formulas: FormulaSettings,
    running: Option<Running>,
    refusal: Option<String>,
}

impl WayJob {
    /// Begins it.
    ///
    /// # Errors
    /// Names what does not go together, its value and what is allowed.
    pub fn new(settings: &WaySettings) -> Result<Self, String> {
        let cuts = settings.cuts;
        if !(FEWEST_CUTS..=MOST_CUTS).contains(&cuts) {
            return Err(tr!(
                "cuts: {cuts} is not possible: allowed are {fewest} to {most}",
                cuts = cuts,
                fewest = FEWEST_CUTS,
                most = MOST_CUTS
            ));
        }
        let noise = settings.noise;
        for (name, value, most) in [("noise", noise.force_n, 50.0), ("ra-noise", noise.ra_um, 1.0)]
        {
            if !(0.0..=most).contains(&value) {
                return Err(tr!(
                    "{name}: {value} is not possible: allowed is 0 to {most}",
                    name = name,
                    value = value,
                    most = most
                ));
            }
        }
        let (plant, base) = (settings.chosen_plant()?, settings.scenario()?);
        let pilot = match plant {
            WayPlant::Formula => None,
            WayPlant::Mechanistic => Some(Pilot::new(&base, settings.axial_depth_mm.is_some())),
        };
        Ok(Self {
            settings: settings.clone(),
            plant,
            truth: settings.truth()?,
            rows: PaperId::Sdnrp2007.rows().len(),
            base,
            pilot,
            planned: None,
            problems: Vec::new(),
            searches: Parts::default(),
            saved: Vec::new(),
            models: Vec::new(),
            formulas: FormulaSettings::default(),
            running: None,
            refusal: None,
        })
    }

    /// The same with the first rows alone.
    #[must_use]
    pub fn with_rows(self, rows: usize) -> Self {
        Self { rows, ..self }
    }

    /// How it is gone.
    pub(super) fn settings(&self) -> &WaySettings {
        &self.settings
    }

    /// The searches as they stand, in the order of the models; none that was not begun.
    pub(super) fn searches(&self) -> Vec<Option<GpState>> {
        let one = |number: usize| match self.searches.part(number) {
            Some(Ok(over)) => Some(over.state.clone()),
            Some(Err(job)) => Some(job.state()),
            None => self.saved.get(number).cloned().flatten(),
        };
        (0..FoundRole::ALL.len()).map(one).collect()
    }

    /// Begins its searches where these stand.
    pub(super) fn go_on_with(&mut self, searches: Vec<Option<GpState>>) {
        self.saved = searches;
    }

    /// The cuts as a table, which `identify gp --data` reads.
    #[must_use]
    pub fn table(&self) -> Option<String> {
        let planned = self.planned.as_ref()?;
        Some(csv(&planned.plan, Some(planned.measure.measured())))
    }

    /// The models found.
    #[must_use]
    pub fn models(&self) -> &[FoundModel] {
        &self.models
    }

    /// The paper's example, 0.81 um, with Tracking on the models found.
    ///
    /// # Errors
    /// There are no models yet, or a setting does not go with the plant.
    pub fn example(&self) -> Result<Scenario, String> {
        let running = self.running.as_ref().ok_or_else(|| tr("there are no models yet"))?;
        let row = PaperId::Sdnrp2007.rows().into_iter().find(|row| row.sim == EXAMPLE_SIM);
        let row = row.ok_or_else(|| tr("the table has no such row"))?;
        let scenario = running.runs.scenario(&row, ControllerKind::Tracking, ModelSource::Found)?;
        let (tool, material) = (self.settings.tool, self.settings.material);
        let described = scenario.with(|s| {
            s.info.name = format!("{}-{}", tool.id(), material.id());
            s.info.description = format!(
                "{} in {}: Tracking on models K1 to K5 that genetic programming has found from {} simulated cuts. Made by \
                 `steadycut experiment way`, as the screen Identify does by Go the whole way. Force: {}; Ra: what a force leaves by the papers' K5.",
                tool.label(),
                material.label(),
                self.settings.cuts,
                self.plant.label()
            );
            let [longer, multiple] = EXAMPLE_PATH;
            let way_mm = mm_s_from_mm_min(s.program.feed_mm_min) * s.run.duration_s;
            s.workpiece.length_mm = (longer * way_mm / multiple).ceil() * multiple;
        });
        described.map_err(|error| error.to_string())
    }

    fn source(&self) -> String {
        let WaySettings { tool, material, cuts, seed, .. } = &self.settings;
        format!(
            "found by `steadycut experiment way` from {cuts} simulated cuts of {} in {}, seed {seed}",
            tool.id(),
            material.id()
        )
    }

    /// Goes on; whether it is over.
    fn go_on(&mut self, budget: &Budget<'_>) -> Result<bool, String> {
        if self.planned.is_none() {
            if let Some(pilot) = &mut self.pilot
                && !pilot.advance(budget)
            {
                return Ok(false);
            }
            self.planned = Some(self.plan()?);
        }
        if self.problems.is_empty() {
            let Some(planned) = &mut self.planned else { return Ok(false) };
            if !planned.measure.advance(budget) {
                return Ok(false);
            }
            if let Some(problem) = planned.measure.refusal() {
                return Err(problem.to_owned());
            }
            let cuts = planned.measure.measured();
            let problems = FoundRole::ALL.iter().map(|role| role.problem(&planned.plan, cuts));
            self.problems = problems.collect::<Result<_, String>>()?;
        }
        if self.running.is_none() {
            if !self.search(budget)? {
                return Ok(false);
            }
            self.take()?;
        }
        let Some(Running { runs, done }) = &mut self.running else { return Ok(false) };
        let begin = |number: usize| Ok(Run::new(&runs.run_scenario(number)?, &Edits::none()));
        let end = |number: usize, run: &Run| runs.outcome(number, run);
        let over = done.advance(runs.count(), budget, &Making { begin: &begin, end: &end });
        match done.refusal() {
            Some(problem) => Err(problem.to_owned()),
            None => Ok(over),
        }
    }

    fn plan(&self) -> Result<Planned, String> {
        let mut base = self.base.clone();
        let cut_box = match &self.pilot {
            None => PAPERS_BOX,
            Some(pilot) => {
                if let Some(problem) = pilot.refusal() {
                    return Err(problem.to_owned());
                }
                let found = pilot.result().ok_or_else(|| tr("the pilot cuts found nothing"))?;
                base.change(|s| s.workpiece.axial_depth_mm = found.axial_depth_mm)
                    .map_err(|error| error.to_string())?;
                [found.feeds_mm_min, found.speeds_rpm]
            }
        };
        let WaySettings { cuts, noise, seed, .. } = self.settings;
        let plan = plan(cuts, cut_box[0], cut_box[1], seed);
        let measure = MeasureJob::new(&plan, &base, noise, seed)?;
        Ok(Planned { base, plan, cut_box, measure })
    }

    fn search(&mut self, budget: &Budget<'_>) -> Result<bool, String> {
        let WaySettings { seed, batches, .. } = self.settings;
        let (problems, saved) = (&self.problems, &self.saved);
        let begin = |number: usize| {
            let settings = GpSettings { seed, batches, ..GpSettings::default() };
            let name = FoundRole::ALL[number].label();
            let mut job = GpJob::new(problems[number].clone(), &settings)
                .map_err(|problem| format!("{name}: {problem}"))?;
            if let Some(state) = saved.get(number).cloned().flatten() {
                job.resume_state(state).map_err(|problem| format!("{name}: {problem}"))?;
            }
            Ok(job)
        };
        let end = |_: usize, job: &GpJob| SearchOver { report: job.report(), state: job.state() };
        let making = Making { begin: &begin, end: &end };
        let over = self.searches.advance(problems.len(), budget, &making);
        match self.searches.refusal() {
            Some(problem) => Err(problem.to_owned()),
            None => Ok(over),
        }
    }

    /// Takes the models of all fronts, and gets the rows ready.
    fn take(&mut self) -> Result<(), String> {
        let Some(planned) = &self.planned else { return Err(tr("nothing is planned").to_owned()) };
        let source = self.source();
        let found = FoundRole::ALL.iter().zip(&self.problems).zip(self.searches.done());
        let models: Vec<FoundModel> = found
            .map(|((role, problem), over)| {
                pick(*role, problem, &over.report, (&source, self.settings.tool))
            })
            .collect::<Result<_, String>>()?;
        let formulas = settings(&models)?;
        let start = planned.cut_box.map(|[low, high]| (0.5 * (low + high)).round());
        let runs = RowRuns::new(
            self.rows,
            self.plant,
            &planned.base,
            start,
            formulas.clone(),
            models.clone(),
        );
        (self.models, self.formulas) = (models, formulas);
        self.running = Some(Running { runs, done: Parts::default() });
        Ok(())
    }

    fn rows(&self) -> Vec<WayRow> {
        let running = self.running.as_ref();
        running.map_or_else(Vec::new, |running| running.runs.told(running.done.done()))
    }
}

/// A step is one of whatever is under way: of the plant, or an offspring of a search.
impl Job for WayJob {
    type Partial = WayReport;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        if self.refusal.is_some() {
            return true;
        }
        match self.go_on(budget) {
            Ok(over) => over,
            Err(problem) => {
                self.refusal = Some(problem);
                true
            }
        }
    }

    fn progress(&self) -> Progress {
        let share = |job: &dyn Fn() -> Option<f64>, before: bool| match before {
            true => 1.0,
            false => job().unwrap_or(0.0),
        };
        let pilot = || self.pilot.as_ref().map(|pilot| pilot.progress().share());
        let measure = || self.planned.as_ref().map(|planned| planned.measure.progress().share());
        let search = || Some(self.searches.progress() / FoundRole::ALL.len() as f64);
        let rows = || {
            let running = self.running.as_ref()?;
            match running.runs.count() {
                0 => Some(1.0),
                count => Some(running.done.progress() / count as f64),
            }
        };
        let parts = [
            share(&pilot, self.planned.is_some()),
            share(&measure, !self.problems.is_empty()),
            share(&search, self.running.is_some()),
            share(&rows, false),
        ];
        let done = parts.iter().zip(SHARES).map(|(part, share)| part * share).sum();
        Progress { done, total: 100.0, unit: text!("percent of the way") }
    }

    fn partial(&self) -> WayReport {
        let planned = self.planned.as_ref();
        let cuts: &[MeasuredCut] = planned.map_or(&[], |planned| planned.measure.measured());
        let rows = self.rows();
        let unmeasured = cuts
            .iter()
            .enumerate()
            .filter_map(|(place, cut)| cut.problem.clone().map(|problem| (place + 1, problem)));
        let workpiece = &planned.map_or(&self.base, |planned| &planned.base).workpiece;
        WayReport {
            settings: self.settings.clone(),
            plant: self.plant,
            truth: self.truth.clone(),
            depths_mm: [workpiece.axial_depth_mm, workpiece.radial_depth_mm],
            pilot: self.pilot.as_ref().and_then(Pilot::result).map(Into::into),
            cut_box: planned.map(|planned| planned.cut_box),
            plan: planned.map(|planned| planned.plan.id.clone()),
            measured: cuts.len(),
            unmeasured: unmeasured.collect(),
            models: self.models.clone(),
            summary: summary(&rows),
            digest: digest(cuts, &self.models, &rows),
            rows,
        }
    }

    fn refusal(&self) -> Option<&str> {
        self.refusal.as_deref()
    }
}
