//! A search under way or over, its front, and the formula that is looked at.

use std::sync::{Arc, Mutex, PoisonError};

use super::form::Asked;
use crate::app::clock::now_s;
use crate::app::command::{Command, FileCommand};
use crate::app::files::file_name;
use crate::app::jobs::{Jobs, Work};
use crate::base::formula::Unit;
use crate::base::language::{text, tr};
use crate::study::identify::gp::inspect::FormulaInspection;
use crate::study::identify::gp::job::GpJob;
use crate::study::identify::gp::problem::GpProblem;
use crate::study::identify::gp::report::GpReport;
use crate::study::identify::gp::standing::GpStanding;
use crate::study::identify::gp::watched::{SearchSoFar, WatchedSearch};

/// Steps of the first slice of a search.
const FIRST: u64 = 4;
/// Least time that a formula is looked at while the search works and none was picked, s.
const SEEN_S: f64 = 0.5;

/// A formula of the front, under way or judged.
#[derive(Clone, Debug, PartialEq)]
pub struct FrontRow {
    /// Its nodes.
    pub size: usize,
    /// Root mean square of its residuals.
    pub error: f64,
    /// The same at rows left out, once they were.
    pub left_out: Option<f64>,
    /// The largest of these over the target, as a share.
    pub worst_share: Option<f64>,
    /// The formula.
    pub formula: String,
    /// Whether it is the one that is chosen.
    pub chosen: bool,
    /// Why it is to be looked at twice; empty where nothing is against it.
    pub doubt: &'static str,
    /// Whether it is exact but for rounding.
    pub exact: bool,
}

/// A formula that was looked at closely.
#[derive(Clone)]
pub struct Seen {
    /// It, in the front.
    pub row: FrontRow,
    /// What was seen, or why nothing can be.
    pub found: Result<Arc<FormulaInspection>, String>,
    /// Whether the search was over.
    judged: bool,
    /// When, s.
    at_s: f64,
}

/// A search.
pub struct FormulaSearch {
    /// What was asked for.
    pub asked: Asked,
    problem: GpProblem,
    given: Vec<(String, Unit)>,
    work: Work<WatchedSearch>,
    latest: Arc<SearchSoFar>,
    rows: Vec<FrontRow>,
    /// Size of the formula that was picked; none for the one chosen.
    picked: Option<usize>,
    seen: Option<Seen>,
    /// Where a copy of the search is put to be saved.
    saved: Option<Arc<Mutex<Option<String>>>>,
}

fn rows(so_far: &SearchSoFar) -> Vec<FrontRow> {
    if let Some(report) = &so_far.report {
        let judged = report.front.iter().map(|found| FrontRow {
            size: found.size,
            error: found.error,
            left_out: found.loo_error,
            worst_share: found.loo_worst_share,
            formula: found.formula.clone(),
            chosen: found.chosen,
            doubt: match (found.certified, found.greyed) {
                (false, _) => text!("not certain to be finite on the ranges of the rows"),
                (true, true) => {
                    text!("at rows left out more than twice the least error of the front")
                }
                (true, false) => "",
            },
            exact: found.exact,
        });
        return judged.collect();
    }
    let under_way = so_far.standing.front.iter().map(|found| FrontRow {
        size: found.size,
        error: found.error,
        left_out: None,
        worst_share: None,
        formula: found.formula.clone(),
        chosen: false,
        doubt: "",
        exact: false,
    });
    under_way.collect()
}

impl FormulaSearch {
    /// Begins a search, or goes on with that of a file: its name and its text.
    ///
    /// # Errors
    /// Why it cannot be searched, or the file cannot be gone on with.
    pub fn begin(
        asked: Asked,
        problem: GpProblem,
        jobs: &Jobs,
        resumed: Option<(&str, &str)>,
    ) -> Result<Self, String> {
        let given = asked.given()?;
        let mut job = GpJob::new(problem.clone(), &asked.settings())?;
        if let Some((name, text)) = resumed {
            job.resume(text).map_err(|problem| format!("{name}: {problem}"))?;
        }
        let name = tr!("Identify: {target}", target = problem.target);
        let work = jobs.begin(name, WatchedSearch::new(job), FIRST);
        let latest = work.partial();
        let rows = rows(&latest);
        Ok(Self {
            asked,
            problem,
            given,
            work,
            latest,
            rows,
            picked: None,
            seen: None,
            saved: None,
        })
    }

    /// Takes what was found since, and saves what is to be saved.
    pub fn refresh(&mut self, commands: &mut Vec<Command>) {
        let latest = self.work.partial();
        if !Arc::ptr_eq(&latest, &self.latest) {
            self.rows = rows(&latest);
            self.latest = latest;
        }
        let copied = self
            .saved
            .as_ref()
            .and_then(|place| place.lock().unwrap_or_else(PoisonError::into_inner).take());
        if let Some(text) = copied {
            self.saved = None;
            let name = file_name(&self.problem.target, "search.json");
            commands.push(Command::File(FileCommand::SaveText { name, text }));
        }
    }

    /// The work at it.
    pub fn work(&self) -> &Work<WatchedSearch> {
        &self.work
    }

    /// What is searched.
    pub fn problem(&self) -> &GpProblem {
        &self.problem
    }

    /// How it stands.
    pub fn standing(&self) -> &GpStanding {
        &self.latest.standing
    }

    /// Its report, once it is over.
    pub fn report(&self) -> Option<&GpReport> {
        self.latest.report.as_deref()
    }

    /// The front so far, the smallest first.
    pub fn rows(&self) -> &[FrontRow] {
        &self.rows
    }

    /// Ends the search; what was found is still judged.
    pub fn end_here(&self) {
        self.work.change(WatchedSearch::end_here);
        self.work.go_on();
    }

    /// Copies the search out of the work at it, to be saved in one of the next frames.
    pub fn save(&mut self) {
        let place = Arc::new(Mutex::new(None));
        self.saved = Some(Arc::clone(&place));
        self.work.change(move |search| {
            let text = search.job().state_text();
            *place.lock().unwrap_or_else(PoisonError::into_inner) = Some(text);
        });
    }

    /// Picks the formula of a size.
    pub fn pick(&mut self, size: usize) {
        self.picked = Some(size);
    }

    /// The formula that is looked at: the one picked, or the largest below it; without a pick the one chosen, and
    /// before there is one the best.
    pub fn shown(&self) -> Option<&FrontRow> {
        match self.picked {
            Some(size) => {
                self.rows.iter().rev().find(|row| row.size <= size).or_else(|| self.rows.first())
            }
            None => self.rows.iter().find(|row| row.chosen).or_else(|| self.rows.last()),
        }
    }

    /// The formula that is shown, looked at closely. While the search works it stays for a moment, so that it can be
    /// read and looking at it does not take the time of the search.
    pub fn inspect(&mut self) -> Option<Seen> {
        let shown = self.shown()?.clone();
        let judged = self.latest.report.is_some();
        if let Some(seen) = &self.seen {
            let waits = self.work.is_running() && now_s() - seen.at_s < SEEN_S;
            let same = seen.row.formula == shown.formula && seen.judged == judged;
            if same || (waits && self.picked.is_none()) {
                return Some(seen.clone());
            }
        }
        let found = self.inspected(&shown).map(Arc::new);
        self.seen = Some(Seen { row: shown, found, judged, at_s: now_s() });
        self.seen.clone()
    }

    fn inspected(&self, row: &FrontRow) -> Result<FormulaInspection, String> {
        let table = self.asked.table.as_ref().map_or("a table", |table| table.name.as_str());
        let source = format!(
            "found by `steadycut identify gp` on {} rows of {table}, seed {}, {} batches; rms error {:.4e}",
            self.problem.rows.len(),
            self.asked.seed,
            self.latest.standing.batches,
            row.error
        );
        if let Some(report) = &self.latest.report {
            let found = report.front.iter().find(|found| found.formula == row.formula);
            let found = found.ok_or(tr("the front has this formula no more"))?;
            return FormulaInspection::of(&self.problem, found, &self.given, source);
        }
        let front = &self.latest.standing.front;
        let found = front.iter().find(|found| found.formula == row.formula);
        let found = found.ok_or(tr("the front has this formula no more"))?;
        FormulaInspection::on_the_way(&self.problem, found, &self.given, source)
    }
}
