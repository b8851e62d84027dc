//! The whole identification as a job: search, cross-validation of its front, report.

use super::archive::{Archive, FittedSum};
use super::breed::Nursery;
use super::draw::{Functions, Grammar};
use super::folds::Folds;
use super::paper::PaperSearch;
use super::problem::{GpProblem, SMALL};
use super::report::{GpReport, report};
use super::rows::DataRows;
use super::search::{GROUP, GpSearch, Stop};
use super::standing::GpStage;
use super::vary::SumBounds;
use crate::base::language::text;
use crate::published::PaperId;
use crate::run::job::{Budget, Job, Progress};

/// Batches without gain after which a search ends.
const IDLE: u64 = 200;
/// Most batches of a search by default.
pub const BATCHES: u64 = 400;
/// How much better a formula with sines and cosines has to be than all of its size without.
const PERIODIC_GAIN: f64 = 0.5;

/// How to search.
#[derive(Clone, Debug, PartialEq)]
pub struct GpSettings {
    /// Seed of all draws.
    pub seed: u64,
    /// Most batches.
    pub batches: u64,
    /// The paper whose own search runs beside.
    pub paper: Option<PaperId>,
}

impl Default for GpSettings {
    fn default() -> Self {
        Self { seed: 1, batches: BATCHES, paper: None }
    }
}

/// The identification of a formula.
#[derive(Clone)]
pub struct GpJob {
    problem: GpProblem,
    settings: GpSettings,
    search: GpSearch,
    paper: Option<PaperSearch>,
    folds: Option<Folds>,
    over: bool,
}

/// On half of the islands of a group formulas have no sines and cosines. Where an input is no more than likely to be
/// positive, a second group takes it to be of any sign; with few rows there is nothing to choose from by that.
fn nursery(rows: DataRows, problem: &GpProblem) -> Nursery {
    let rule = problem.rule.clone();
    let (likely, sure) = (problem.positive(), problem.surely_positive());
    let groups =
        if likely == sure || rows.len() <= SMALL { vec![likely] } else { vec![likely, sure] };
    let language = |island: usize| {
        let periodic = island % GROUP >= GROUP / 2;
        let functions = Functions { ln: true, exp: true, periodic, scaled: rule.is_some() };
        Grammar::new(&rows, groups[island / GROUP].clone(), functions)
    };
    let languages = (0..groups.len() * GROUP).map(language).collect();
    let constants = (rows.len() / 2).min(16);
    let bounds = SumBounds { terms: 6, factors: 5, nodes: 15, size: 44, constants };
    Nursery::new(rows, languages, bounds).with(rule)
}

impl GpJob {
    /// Begins it.
    ///
    /// # Errors
    /// The inputs lie on one line.
    pub fn new(problem: GpProblem, settings: &GpSettings) -> Result<Self, String> {
        if let Some(collinear) = problem.collinear().filter(|_| problem.template.is_none()) {
            return Err(collinear.to_string());
        }
        let rows = problem.searched(settings.seed);
        let nursery = nursery(rows, &problem).locked(problem.template.as_ref());
        let stop = Stop { batches: settings.batches, idle: IDLE };
        let paper = settings
            .paper
            .map(|paper| PaperSearch::new(paper, nursery.rows.clone(), settings.seed));
        let search = GpSearch::started(nursery, settings.seed, stop);
        Ok(Self { problem, settings: settings.clone(), search, paper, folds: None, over: false })
    }

    /// What is asked.
    #[must_use]
    pub fn problem(&self) -> &GpProblem {
        &self.problem
    }

    /// What was asked, without the search.
    #[must_use]
    pub fn into_problem(self) -> GpProblem {
        self.problem
    }

    /// How it searches.
    #[must_use]
    pub fn settings(&self) -> &GpSettings {
        &self.settings
    }

    /// Ends the search with its last whole batch; what was found is judged on rows left out all the same. The result
    /// is that of a search of so many batches. What has come to that already stays as it is.
    pub fn end_here(&mut self) {
        if self.folds.is_none() {
            self.settings.batches = self.search.end_here();
        }
    }

    pub(super) fn search_mut(&mut self) -> &mut GpSearch {
        &mut self.search
    }

    /// The search.
    #[must_use]
    pub fn search(&self) -> &GpSearch {
        &self.search
    }

    /// What it is at.
    pub(super) fn stage(&self) -> GpStage {
        if self.over {
            GpStage::Over
        } else if self.folds.is_some() {
            GpStage::LeftOut
        } else if self.search.progress().share() < 1.0 {
            GpStage::Search
        } else {
            GpStage::Paper
        }
    }

    /// The front: the best formula of each size that pays for its size. Where an input may be of any sign, those that
    /// stop at 0 have a front, and those that do not have one of their own, which comes first at a size of both.
    #[must_use]
    pub fn front(&self) -> Vec<FittedSum> {
        let mut front = self.front_of(self.search.calm(), self.search.best());
        if let Some([calm, best]) = self.search.whole() {
            let whole = self.front_of(&calm, &best);
            front.retain(|other| !whole.iter().any(|candidate| candidate.size == other.size));
            front.extend(whole);
            front.sort_by_key(|candidate| candidate.size);
        }
        // Nothing larger than an exact formula says more.
        let exact = front.iter().position(|candidate| self.search.nursery().is_exact(candidate));
        front.truncate(exact.map_or(front.len(), |exact| exact + 1));
        front
    }

    /// The best formulas of some survivors; one with sines and cosines only where it halves the error of all that
    /// have none.
    fn front_of(&self, calm: &Archive, best: &Archive) -> Vec<FittedSum> {
        let nursery = self.search.nursery();
        // A few rows are soon followed by a wave: there, only an exact one counts.
        let few = nursery.rows.len() <= SMALL;
        let (mut least, mut calm_least) = (f64::INFINITY, f64::INFINITY);
        let mut front: Vec<FittedSum> = Vec::new();
        for size in 0..calm.sizes().max(best.sizes()) {
            let plain = calm.best(size);
            calm_least = calm_least.min(plain.map_or(f64::INFINITY, |plain| plain.error));
            let periodic = best.best(size).filter(|best| {
                best.error < PERIODIC_GAIN * calm_least && (!few || nursery.is_exact(best))
            });
            let Some(candidate) = periodic.or(plain) else { continue };
            if candidate.error < 0.999 * least {
                least = candidate.error;
                front.push(candidate.clone());
            }
        }
        front
    }

    /// The report; before the end without cross-validation.
    #[must_use]
    pub fn report(&self) -> GpReport {
        let front = self.front();
        let left_out = self.folds.as_ref().filter(|_| self.over);
        let left_out = left_out.map(|folds| (folds.left_out(&front), folds.told()));
        let repeated = self.folds.as_ref().is_some_and(Folds::is_repeated);
        let paper = self.paper.as_ref().map(|paper| paper.result(&self.problem.inputs));
        report(&self.problem, &self.search, &front, left_out, repeated && self.over).beside(paper)
    }
}

impl Job for GpJob {
    type Partial = GpReport;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        if !self.search.advance(budget) {
            return false;
        }
        if let Some(paper) = &mut self.paper
            && !paper.advance(budget)
        {
            return false;
        }
        if self.folds.is_none() {
            let GpSettings { seed, batches, .. } = self.settings;
            self.folds = Some(Folds::new(&self.search, &self.front(), seed, batches));
        }
        self.over = self.folds.as_mut().is_some_and(|folds| folds.advance(budget));
        self.over
    }

    fn progress(&self) -> Progress {
        // The folds count as a fifth of the batches, and the paper's search too.
        let batches = self.settings.batches as f64;
        let share = |folds: &Folds| folds.progress() / folds.count().max(1) as f64;
        let folds = self.folds.as_ref().map_or(0.0, share);
        let paper = self.paper.as_ref().map_or(1.0, |paper| paper.progress().share());
        let done = self.search.progress().share() + 0.25 * (folds + paper);
        Progress { done: batches * done / 1.5, total: batches, unit: text!("batches") }
    }

    fn partial(&self) -> GpReport {
        self.report()
    }
}
