//! What is told of a search: the front with its errors, the formula chosen, its constants with their
//! intervals, its range, the rows that do not fit.

use std::cmp::Ordering;

use serde::Serialize;

use super::archive::FittedSum;
use super::constants::{FittedConstant, FittedFormula, fitted, is_exponent, rounded};
use super::families::declared;
use super::folds::{LeftOut, refitted};
use super::outliers::without;
use super::paper::PaperResult;
use super::problem::{GpProblem, SMALL};
use super::range::{RangeReport, WIDER};
use super::rows::DataRows;
use super::search::GpSearch;
use super::written::formula;
use crate::base::formula::{Formula, Function, Interval, Node, Operator};
use crate::base::language::text;
use crate::base::math;
use crate::run::digest::Digest;

/// Studentised residual above which a row is an outlier.
const OUTLIER: f64 = 3.0;
/// Size above which nothing is chosen from a small table, unless it is exact.
const SMALL_SIZE: usize = 11;
/// Error at rows left out, over the least, up to which a smaller formula is chosen from a small table.
const NEAR: f64 = 1.03;
/// Error over that of the best of its size up to which a formula with a certificate stands for it.
const SECOND: f64 = 1.5;
/// How many times the error of a formula that may stop within the ranges 30 % wider is accepted of one that does not:
/// where it stops, its own is boundless.
const WHOLE: f64 = 10.0;
/// What a node costs in the description of a formula, in units of twice the log-likelihood.
const PER_NODE: f64 = 2.0;
/// The same for a sine or cosine.
const PER_WAVE: f64 = 10.0;
/// Error of cross-validation, over the least of the front, above which a formula is greyed.
const GREYED: f64 = 2.0;

/// A constant of a formula.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ReportedConstant {
    /// Its value.
    pub value: f64,
    /// Its 95 % interval of confidence; none where the rows do not determine it.
    pub interval: Option<[f64; 2]>,
    /// Whether the rows determine it: its interval is narrower than it is large.
    pub determined: bool,
}

impl From<&FittedConstant> for ReportedConstant {
    fn from(constant: &FittedConstant) -> Self {
        let determined = constant.is_determined();
        Self { value: constant.value, interval: constant.interval, determined }
    }
}

/// A formula of the front.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FrontFormula {
    /// The formula of the columns.
    pub formula: String,
    /// Its nodes.
    pub size: usize,
    /// Root mean square of its residuals, in the target's unit.
    pub error: f64,
    /// Root mean square of its errors at rows left out, in the target's unit.
    pub loo_error: Option<f64>,
    /// The largest of these over the target, as a share.
    pub loo_worst_share: Option<f64>,
    /// Whether it is the one chosen.
    pub chosen: bool,
    /// Whether its error at rows left out is above twice the least of the front.
    pub greyed: bool,
    /// Whether it fits the rows but for rounding.
    pub exact: bool,
    /// Whether it is certain to be finite on the ranges of the rows.
    pub certified: bool,
    /// In strict search, its numbers with their units, from left to right.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub units: Option<Vec<String>>,
    /// Its constants, from left to right; whole and half exponents are none.
    pub constants: Vec<ReportedConstant>,
}

/// A row that does not fit.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct OutlyingRow {
    /// Its number, from 1.
    pub row: usize,
    /// Its target.
    pub target: f64,
    /// Target minus formula.
    pub residual: f64,
    /// Its error in its own standard deviations, estimated without the row: by the formula chosen, or with
    /// few rows by the simple family that fits the others best, whichever is larger.
    pub studentised: f64,
}

/// What is told of a search.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct GpReport {
    /// Column of the target.
    pub target: String,
    /// Number of rows.
    pub rows: usize,
    /// Number of rows that the search went over, and that its front is judged by. The constants of the formula
    /// chosen are fitted to all.
    pub searched_rows: usize,
    /// Seed of all draws, those of the rows that were searched among them.
    pub seed: u64,
    /// The formulas, the smallest first.
    pub front: Vec<FrontFormula>,
    /// How the errors at rows left out were found.
    pub left_out: Option<&'static str>,
    /// What is certain of the chosen formula over the ranges of the rows, and over wider ones.
    pub ranges: Option<RangeReport>,
    /// Standard deviation of its residuals.
    pub residual_deviation: Option<f64>,
    /// Target minus formula, row by row.
    pub residuals: Vec<f64>,
    /// Half the width of its 95 % band at each row, in which its true values lie where its form is the true
    /// one; none where the rows do not determine all of its constants.
    pub bands: Vec<Option<f64>>,
    /// Rows that do not fit.
    pub outliers: Vec<OutlyingRow>,
    /// What the paper's own search has found.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub paper: Option<PaperResult>,
    /// Which search found the formula of the smaller error: `default` or `paper`.
    pub found_by: &'static str,
    /// Batches of the search.
    pub batches: u64,
    /// Formulas that were made and fitted.
    pub evaluations: u64,
    /// The batch that found a formula exact but for rounding.
    pub exact_batch: Option<u64>,
    /// XXH3 over the formulas, bits of all constants included, and which is chosen.
    pub digest: String,
}

impl GpReport {
    /// The same beside what the paper's own search has found.
    #[must_use]
    pub fn beside(mut self, paper: Option<PaperResult>) -> Self {
        let own = self.chosen().map_or(f64::INFINITY, |chosen| chosen.error);
        if paper.as_ref().is_some_and(|paper| paper.error < own) {
            self.found_by = "paper";
        }
        self.paper = paper;
        self
    }

    /// Least and largest half width of the 95 % band over the rows; none where it is not determined.
    #[must_use]
    pub fn band(&self) -> Option<[f64; 2]> {
        let widths = self.bands.iter().copied().collect::<Option<Vec<f64>>>()?;
        (!widths.is_empty()).then(|| math::extent(widths.into_iter()))
    }

    /// The formula chosen.
    #[must_use]
    pub fn chosen(&self) -> Option<&FrontFormula> {
        self.front.iter().find(|formula| formula.chosen)
    }
}

/// A formula of the front, finished.
struct Entry {
    /// Without what it has for each row, where the rows are very many.
    fit: FittedFormula,
    /// Root mean square of its residuals.
    rms: f64,
    /// Estimated error of prediction.
    error: f64,
    exact: bool,
    periodic: usize,
    left_out: Option<LeftOut>,
    certified: bool,
    /// Whether it is certain to be finite on the ranges 30 % wider, too.
    whole: bool,
}

impl Entry {
    fn size(&self) -> usize {
        self.fit.formula.size()
    }

    fn loo(&self) -> f64 {
        self.left_out.as_ref().map_or(self.error, LeftOut::rms)
    }
}

/// Whole and half exponents of a formula: they were tried like any constant, though none is fitted any more.
fn powers(node: &Node) -> usize {
    let own = match node {
        Node::Unary(Function::Sqrt, _) => 1,
        Node::Binary(Operator::Power, pair) => match pair[1] {
            Node::Number(x) => usize::from(is_exponent(x)),
            Node::Input(_) | Node::Constant(_) | Node::Unary(..) | Node::Binary(..) => 0,
        },
        Node::Number(_)
        | Node::Input(_)
        | Node::Constant(_)
        | Node::Unary(..)
        | Node::Binary(..) => 0,
    };
    own + node.operands().iter().map(powers).sum::<usize>()
}

/// Which formula is chosen, of those certified on the ranges of the rows: one that is exact, or with few rows
/// the smallest whose error at rows left out is near the least, with many the one of the least description
/// by that error, its constants and its size: of all, or of those that are certain to be finite on the ranges 30 % wider
/// where its error is at most ten times as large.
fn choose(entries: &[Entry], rows: usize) -> Option<usize> {
    let numbers: Vec<usize> =
        (0..entries.len()).filter(|number| entries[*number].certified).collect();
    if let Some(exact) = numbers.iter().find(|number| entries[**number].exact) {
        return Some(*exact);
    }
    if rows <= SMALL {
        let small = numbers.into_iter().filter(|number| entries[*number].size() <= SMALL_SIZE);
        let small: Vec<usize> = small.collect();
        let least = small.iter().map(|number| entries[*number].loo()).fold(f64::INFINITY, f64::min);
        return small.into_iter().find(|number| entries[*number].loo() <= NEAR * least);
    }
    let n = rows as f64;
    let description = |number: &usize| {
        let entry = &entries[*number];
        n * 2.0 * math::ln(entry.loo())
            + (math::ln(n) - 2.0) * (entry.fit.fitted + powers(entry.fit.formula.root())) as f64
            + PER_NODE * entry.size() as f64
            + PER_WAVE * entry.periodic as f64
    };
    let least = |numbers: &mut dyn Iterator<Item = usize>| {
        numbers.min_by(|a, b| description(a).total_cmp(&description(b)))
    };
    let any = least(&mut numbers.iter().copied())?;
    let whole = least(&mut numbers.iter().copied().filter(|number| entries[*number].whole));
    let near = |whole: &usize| entries[*whole].loo() <= WHOLE * entries[any].loo();
    Some(whole.filter(near).unwrap_or(any))
}

/// What the formulas of a front are judged by.
struct Judged<'a> {
    problem: &'a GpProblem,
    search: &'a GpSearch,
    /// The rows that were searched.
    rows: DataRows,
    boxes: Boxes,
}

/// The ranges of all rows, and wider ones.
struct Boxes {
    training: Vec<Interval>,
    wider: Vec<Interval>,
}

impl Boxes {
    fn of(problem: &GpProblem) -> Self {
        let of = |share: f64| {
            let ranges = problem.ranges(share).into_iter();
            ranges.map(|[low, high]| Interval::new(low, high)).collect()
        };
        Self { training: of(0.0), wider: of(WIDER) }
    }
}

/// Whether a formula is certain to be finite on ranges.
fn is_finite(formula: &Formula, ranges: &[Interval]) -> bool {
    formula.certify_values(ranges).is_ok_and(|(_, open)| open.is_empty())
}

fn finished(
    judged: &Judged<'_>,
    candidate: &FittedSum,
    left_out: Option<LeftOut>,
) -> Option<Entry> {
    let Judged { problem, search, rows, boxes } = judged;
    let written: Formula = formula(&candidate.sum, &problem.columns).ok()?;
    let exact = search.nursery().is_exact(candidate);
    let mut fit = fitted(&written, rows).ok()?;
    if exact {
        fit = rounded(fit, rows);
    }
    // A constant may have become one that simplifies.
    let simpler = fit.formula.simplified();
    if simpler.size() < fit.formula.size() {
        fit = fitted(&simpler, rows).ok()?;
    }
    let rms = fit.rms();
    Some(Entry {
        certified: is_finite(&fit.formula, &boxes.training),
        whole: is_finite(&fit.formula, &boxes.wider),
        fit,
        rms,
        error: candidate.error,
        exact,
        periodic: candidate.sum.periodic(),
        left_out,
    })
}

/// The entries of the search's front; where the best of a size has no certificate, the next of the same size
/// that has one.
fn searched(
    judged: &Judged<'_>,
    front: &[FittedSum],
    left_out: Option<&Vec<LeftOut>>,
    repeated: bool,
) -> Vec<Entry> {
    let search = judged.search;
    let mut entries = Vec::new();
    for (number, candidate) in front.iter().enumerate() {
        let errors = left_out.and_then(|errors| errors.get(number).cloned());
        let Some(entry) = finished(judged, candidate, errors.clone()) else { continue };
        let others = search.calm().of_size(candidate.size).iter();
        let other = others
            .filter(|other| !entry.certified && other.error <= SECOND * candidate.error)
            .find_map(|other| {
                // Where the search was repeated, its errors stand for all formulas of this size.
                let errors = match repeated {
                    true => errors.clone(),
                    false => errors.as_ref().map(|_| refitted(&other.sum, &search.nursery().rows)),
                };
                finished(judged, other, errors).filter(|entry| entry.certified)
            });
        entries.push(other.unwrap_or(entry));
    }
    entries
}

/// The families of curves beside what was searched, with few rows: nobody has searched for them, so their
/// constants alone are fitted without each row.
fn with_families(judged: &Judged<'_>, mut entries: Vec<Entry>) -> Vec<Entry> {
    let problem = judged.problem;
    for family in declared(&problem.rows, &problem.positive(), SMALL_SIZE) {
        let left_out = refitted(&family.sum, &problem.rows);
        entries.extend(finished(judged, &family, Some(left_out)));
    }
    entries.sort_by(|a, b| {
        (a.size(), a.loo()).partial_cmp(&(b.size(), b.loo())).unwrap_or(Ordering::Equal)
    });
    let (mut loo, mut error) = (f64::INFINITY, f64::INFINITY);
    let mut size = 0;
    entries.retain(|entry| {
        let better = entry.loo() < 0.999 * loo || entry.rms < 0.999 * error;
        let keeps = entry.size() > size && better;
        if keeps {
            size = entry.size();
            loo = loo.min(entry.loo());
            error = error.min(entry.rms);
        }
        keeps
    });
    entries
}

/// The report on a front; where the search was `repeated` for every row, the families of curves stand beside it.
#[must_use]
pub fn report(
    problem: &GpProblem,
    search: &GpSearch,
    front: &[FittedSum],
    left_out: Option<(Vec<LeftOut>, &'static str)>,
    repeated: bool,
) -> GpReport {
    let (errors, left_out) = left_out.unzip();
    let (rows, boxes) = (problem.sample(search.seed()), Boxes::of(problem));
    let judged = Judged { problem, search, rows, boxes };
    let mut entries = searched(&judged, front, errors.as_ref(), repeated);
    if repeated && problem.template.is_none() {
        entries = with_families(&judged, entries);
    }
    let chosen = choose(&entries, judged.rows.len());
    let least = entries.iter().map(Entry::loo).fold(f64::INFINITY, f64::min);
    if let Some(chosen) = chosen.filter(|_| judged.rows.len() < problem.rows.len()) {
        on_all_rows(&judged, &mut entries[chosen]);
    }
    told(
        problem,
        &entries,
        chosen,
        least,
        Searched {
            rows: judged.rows.len(),
            seed: search.seed(),
            left_out,
            batches: search.batches(),
            evaluations: search.evaluations(),
            exact_batch: search.exact(),
        },
    )
}

/// Fits the constants of a formula to all rows that were found on some of them. Where it were no longer certain to be
/// finite, they stay as they are.
fn on_all_rows(judged: &Judged<'_>, entry: &mut Entry) {
    let (rows, boxes) = (&judged.problem.rows, &judged.boxes);
    let fit = fitted(&entry.fit.formula, rows).ok();
    let fit = fit.map(|fit| if entry.exact { rounded(fit, rows) } else { fit });
    match fit.filter(|fit| is_finite(&fit.formula, &boxes.training)) {
        Some(fit) => {
            entry.whole = is_finite(&fit.formula, &boxes.wider);
            entry.rms = fit.rms();
            entry.fit = fit;
        }
        None => entry.fit = entry.fit.clone().with_rows(rows),
    }
}

/// The report on one formula whose structure was declared.
#[must_use]
pub fn only(problem: &GpProblem, fit: FittedFormula, left_out: LeftOut, seed: u64) -> GpReport {
    let boxes = Boxes::of(problem);
    let entry = Entry {
        certified: is_finite(&fit.formula, &boxes.training),
        whole: is_finite(&fit.formula, &boxes.wider),
        error: fit.rms(),
        rms: fit.rms(),
        exact: false,
        periodic: 0,
        left_out: Some(left_out),
        fit,
    };
    let least = entry.loo();
    let searched = Searched {
        rows: problem.rows.len(),
        seed,
        left_out: Some(text!("the constants fitted without some of the rows")),
        batches: 0,
        evaluations: 0,
        exact_batch: None,
    };
    told(problem, &[entry], Some(0), least, searched)
}

/// How a search went.
struct Searched {
    rows: usize,
    seed: u64,
    left_out: Option<&'static str>,
    batches: u64,
    evaluations: u64,
    exact_batch: Option<u64>,
}

fn told(
    problem: &GpProblem,
    entries: &[Entry],
    chosen: Option<usize>,
    least: f64,
    searched: Searched,
) -> GpReport {
    let front: Vec<FrontFormula> = entries
        .iter()
        .enumerate()
        .map(|(number, entry)| FrontFormula {
            formula: entry.fit.formula.to_string(),
            size: entry.size(),
            error: entry.rms,
            loo_error: entry.left_out.as_ref().map(LeftOut::rms),
            loo_worst_share: entry.left_out.as_ref().map(|left_out| worst(problem, left_out)),
            chosen: chosen == Some(number),
            greyed: entry.loo() > GREYED * least,
            exact: entry.exact,
            certified: entry.certified,
            units: problem.rule.as_ref().and_then(|rule| rule.constants(&entry.fit.formula).ok()),
            constants: entry.fit.constants.iter().map(ReportedConstant::from).collect(),
        })
        .collect();
    let exact = chosen.is_some_and(|chosen| entries[chosen].exact);
    let chosen = chosen.map(|chosen| &entries[chosen].fit);
    let digest = digest(&front);
    GpReport {
        target: problem.target.clone(),
        rows: problem.rows.len(),
        searched_rows: searched.rows,
        seed: searched.seed,
        front,
        left_out: searched.left_out,
        ranges: chosen.map(|fit| RangeReport::of(problem, &fit.formula)),
        residual_deviation: chosen.map(FittedFormula::deviation),
        residuals: chosen.map(|fit| fit.residuals.clone()).unwrap_or_default(),
        bands: chosen.map(|fit| fit.bands(&problem.rows)).unwrap_or_default(),
        // Where nothing is left over, no row stands out.
        outliers: chosen.filter(|_| !exact).map(|fit| outliers(problem, fit)).unwrap_or_default(),
        paper: None,
        found_by: "default",
        batches: searched.batches,
        evaluations: searched.evaluations,
        exact_batch: searched.exact_batch,
        digest,
    }
}

fn worst(problem: &GpProblem, left_out: &LeftOut) -> f64 {
    let shares = left_out.errors.iter().zip(&problem.rows.target);
    shares
        .map(|(error, y)| (error / y).abs())
        .fold(0.0, |a: f64, b| if b.is_finite() { a.max(b) } else { f64::INFINITY })
}

/// Rows that do not fit a formula, the farthest first.
#[must_use]
pub fn outliers(problem: &GpProblem, fit: &FittedFormula) -> Vec<OutlyingRow> {
    let few = problem.rows.len() <= SMALL && problem.template.is_none();
    let mut found: Vec<OutlyingRow> = fit
        .studentised()
        .into_iter()
        .enumerate()
        .filter_map(|(row, own)| {
            let without = if few { without(problem, row) } else { None };
            let most = without.filter(|without| without.abs() > own.abs()).unwrap_or(own);
            (most.abs() > OUTLIER).then(|| OutlyingRow {
                row: row + 1,
                target: problem.rows.target[row],
                residual: fit.residuals[row],
                studentised: most,
            })
        })
        .collect();
    found.sort_by(|a, b| b.studentised.abs().total_cmp(&a.studentised.abs()));
    found
}

fn digest(front: &[FrontFormula]) -> String {
    let mut digest = Digest::default();
    for formula in front {
        // Numbers are printed so that they read back to the same bits.
        for byte in formula.formula.bytes() {
            digest.word(u64::from(byte));
        }
        digest.word(u64::from(formula.chosen) << 32);
    }
    digest.hex()
}
