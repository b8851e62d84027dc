//! Cross-validation of the front. With few rows each is left out once and the whole search repeated without
//! it; with many the rows are left out in ten parts and the constants fitted without them.

use super::archive::FittedSum;
use super::breed::Nursery;
use super::fit::{Effort, Fitter};
use super::node::Sum;
use super::problem::SMALL;
use super::rows::DataRows;
use super::search::{GpSearch, Stop};
use crate::base::language::text;
use crate::run::job::Budget;
use crate::run::parts::{Making, OneStep, Parts};

/// Parts that many rows are left out in.
const PARTS: usize = 10;
/// Most batches of the search of a fold.
const FOLD_BATCHES: u64 = 16;
/// Batches without gain after which it ends.
const FOLD_IDLE: u64 = 10;

/// Errors of the rows left out, for one formula of the front.
#[derive(Clone, Debug, PartialEq)]
pub struct LeftOut {
    /// Target minus prediction of each row, from a fit without it; not finite where there is none.
    pub errors: Vec<f64>,
}

impl LeftOut {
    /// Root mean square.
    #[must_use]
    pub fn rms(&self) -> f64 {
        let squares: f64 = self.errors.iter().map(|error| error * error).sum();
        let rms = (squares / self.errors.len() as f64).sqrt();
        if rms.is_finite() { rms } else { f64::INFINITY }
    }
}

/// What is left out, and how the rest is used.
#[derive(Clone)]
pub enum Folds {
    /// The search repeated without each row.
    Repeated {
        /// A part for each row: errors by size.
        parts: Parts<GpSearch, Vec<f64>>,
        /// Makes the search on other rows.
        nursery: Box<Nursery>,
        /// Seed of the searches.
        seed: u64,
        /// When they end.
        stop: Stop,
    },
    /// The constants fitted without some rows.
    Refitted {
        /// A part for each formula.
        parts: Parts<OneStep, LeftOut>,
        /// The formulas.
        front: Vec<Sum>,
        /// The rows.
        rows: DataRows,
    },
}

impl Folds {
    /// For a search that is over.
    #[must_use]
    pub fn new(search: &GpSearch, front: &[FittedSum], seed: u64, batches: u64) -> Self {
        let nursery = search.nursery();
        let exact = front.iter().any(|candidate| nursery.is_exact(candidate));
        if nursery.rows.len() <= SMALL && !exact {
            let stop = Stop { batches: batches.min(FOLD_BATCHES), idle: FOLD_IDLE };
            return Self::Repeated {
                parts: Parts::default(),
                nursery: Box::new(nursery.clone()),
                seed,
                stop,
            };
        }
        let front = front.iter().map(|candidate| candidate.sum.clone()).collect();
        Self::Refitted { parts: Parts::default(), front, rows: nursery.rows.clone() }
    }

    /// Whether the search is repeated.
    #[must_use]
    pub fn is_repeated(&self) -> bool {
        matches!(self, Self::Repeated { .. })
    }

    /// Number of parts.
    #[must_use]
    pub fn count(&self) -> usize {
        match self {
            Self::Repeated { nursery, .. } => nursery.rows.len(),
            Self::Refitted { front, .. } => front.len(),
        }
    }

    /// How many rows are left out at a time, in words.
    #[must_use]
    pub fn told(&self) -> &'static str {
        match self {
            Self::Repeated { .. } => text!("the search repeated without each row"),
            Self::Refitted { rows, .. } if rows.len() <= SMALL => {
                text!("the constants fitted without each row")
            }
            Self::Refitted { .. } => text!("the constants fitted without each tenth of the rows"),
        }
    }

    /// Goes on; `true` when all are over.
    pub fn advance(&mut self, budget: &Budget<'_>) -> bool {
        match self {
            Self::Repeated { parts, nursery, seed, stop } => {
                let begin = |out: usize| {
                    let nursery = nursery.on(nursery.rows.only(|row| row != out));
                    Ok(GpSearch::started(nursery, seed.wrapping_add(1 + out as u64), *stop))
                };
                let end = |out: usize, search: &GpSearch| {
                    let at: Vec<Vec<f64>> =
                        nursery.rows.inputs.iter().map(|column| vec![column[out]]).collect();
                    errors_by_size(search, &at, nursery.rows.target[out])
                };
                let count = nursery.rows.len();
                parts.advance(count, budget, &Making { begin: &begin, end: &end })
            }
            Self::Refitted { parts, front, rows } => {
                let end = |number: usize, _: &OneStep| refitted(&front[number], rows);
                let begin = |_| Ok(OneStep::default());
                let count = front.len();
                parts.advance(count, budget, &Making { begin: &begin, end: &end })
            }
        }
    }

    /// Parts that are over.
    #[must_use]
    pub fn progress(&self) -> f64 {
        match self {
            Self::Repeated { parts, .. } => parts.progress(),
            Self::Refitted { parts, .. } => parts.progress(),
        }
    }

    /// The errors of each formula of the front, once over.
    #[must_use]
    pub fn left_out(&self, front: &[FittedSum]) -> Vec<LeftOut> {
        match self {
            Self::Repeated { parts, .. } => {
                let one = |candidate: &FittedSum| {
                    let error = |errors: &Vec<f64>| {
                        errors.get(candidate.size).or(errors.last()).copied().unwrap_or(f64::NAN)
                    };
                    LeftOut { errors: parts.done().iter().map(error).collect() }
                };
                front.iter().map(one).collect()
            }
            Self::Refitted { parts, .. } => parts.done().to_vec(),
        }
    }
}

/// The error at a row, for each size that of the best formula of that size or a smaller one.
fn errors_by_size(search: &GpSearch, at: &[Vec<f64>], target: f64) -> Vec<f64> {
    let mut fitter = Fitter::default();
    let mut errors = Vec::new();
    let (mut least, mut last) = (f64::INFINITY, f64::NAN);
    let mut value = Vec::new();
    for size in 0..search.calm().sizes() {
        if let Some(best) = search.calm().best(size)
            && best.error < least
        {
            least = best.error;
            let known = fitter.predict(&best.sum, at, &mut value);
            last = if known { target - value[0] } else { f64::INFINITY };
        }
        errors.push(last);
    }
    errors
}

/// Errors of the rows, each predicted by a fit without its part of the rows.
#[must_use]
pub fn refitted(sum: &Sum, rows: &DataRows) -> LeftOut {
    let count = rows.len();
    let parts = if count <= SMALL { count } else { PARTS };
    let mut fitter = Fitter::default();
    let mut errors = vec![f64::INFINITY; count];
    for part in 0..parts {
        let rest = rows.only(|row| row % parts != part);
        let mut sum = sum.clone();
        if fitter.fit(&mut sum, &rest, Effort { steps: 20, goal: 0.0 }).is_none() {
            continue;
        }
        let out = rows.only(|row| row % parts == part);
        let mut values = Vec::new();
        if fitter.predict(&sum, &out.inputs, &mut values) {
            let targets = (0..count).filter(|row| row % parts == part);
            for (row, value) in targets.zip(values) {
                errors[row] = rows.target[row] - value;
            }
        }
    }
    LeftOut { errors }
}
