//! Rows that do not fit the others.
//!
//! A row with much leverage draws the formula to itself and hides in it. With few rows, each is therefore
//! judged by the simple family that fits the *other* rows best: its error there over the standard deviation
//! of a prediction (externally studentised).

use super::constants::fitted;
use super::families::declared;
use super::problem::GpProblem;
use super::written::formula;

/// Largest formula by which a row is judged.
const SIZE: usize = 11;

/// Studentised error of a row at the family that fits the others best; none where no family does.
#[must_use]
pub fn without(problem: &GpProblem, row: usize) -> Option<f64> {
    let rest = problem.rows.only(|other| other != row);
    let families = declared(&rest, &problem.positive(), SIZE);
    let best = families.iter().min_by(|a, b| a.error.total_cmp(&b.error))?;
    let written = formula(&best.sum, &problem.columns).ok()?;
    let fit = fitted(&written, &rest).ok()?;
    let at: Vec<f64> = problem.rows.inputs.iter().map(|column| column[row]).collect();
    let error = problem.rows.target[row] - fit.formula.value(&at);
    let spread = fit.prediction_deviation(&at)?;
    (spread > 0.0 && error.is_finite()).then_some(error / spread)
}
