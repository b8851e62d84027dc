//! How sure the rows that a formula was fitted to make its constants: what a band about it is worked out from.

use serde::{Deserialize, Serialize};

use crate::base::formula::{Formula, Node};
use crate::base::language::tr;

/// The fit of a formula to rows by least squares.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, expecting = "rows, deviation, constants and covariance")]
pub struct FormulaFit {
    /// Rows that it was fitted to.
    pub rows: usize,
    /// Standard deviation of the residuals, for the freedom that the constants leave, in the unit of the result.
    pub deviation: f64,
    /// The numbers of the formula that were fitted, from left to right, each in its own unit.
    pub constants: Vec<f64>,
    /// Their covariance, the lower triangle row by row: entry k, l in the unit of constant k times that of constant l.
    pub covariance: Vec<Vec<f64>>,
}

/// Numbers of a formula, from left to right.
fn numbers(node: &Node, found: &mut Vec<f64>) {
    if let Node::Number(x) = node {
        found.push(*x);
    }
    node.operands().iter().for_each(|operand| numbers(operand, found));
}

impl FormulaFit {
    /// Degrees of freedom of the residuals.
    #[must_use]
    pub fn freedom(&self) -> usize {
        self.rows.saturating_sub(self.constants.len())
    }

    /// The covariance of two constants.
    #[must_use]
    pub fn covariance(&self, k: usize, l: usize) -> f64 {
        let row = self.covariance.get(k.max(l));
        row.and_then(|row| row.get(k.min(l))).copied().unwrap_or(f64::NAN)
    }

    /// Whether it can be the fit of a formula.
    pub(super) fn check(&self, formula: &Formula) -> Result<(), String> {
        let Self { rows, deviation, constants, covariance } = self;
        if constants.len() >= *rows {
            let count = constants.len();
            return Err(tr!(
                "`rows` cannot be {rows}: allowed is more than the {n} constants",
                rows = *rows,
                n = count
            ));
        }
        if !(deviation.is_finite() && *deviation >= 0.0) {
            return Err(tr!(
                "`deviation` cannot be {deviation}: allowed is 0 or more",
                deviation = *deviation
            ));
        }
        let mut all = Vec::new();
        numbers(formula.root(), &mut all);
        let mut left = all.iter();
        for constant in constants {
            if !left.any(|number| number == constant) {
                return Err(tr!(
                    "`constants` cannot have {constant}: allowed are numbers of the formula, from left to right",
                    constant = *constant
                ));
            }
        }
        let triangle = covariance.iter().map(Vec::len).eq(1..=constants.len());
        let sound = triangle && covariance.iter().flatten().all(|x| x.is_finite());
        let spread = |k: usize| self.covariance(k, k) >= 0.0;
        if !(sound && (0..constants.len()).all(spread)) {
            return Err(tr!(
                "`covariance` is none of {n} constants: allowed is a lower triangle of finite numbers, none below 0 on \
                 the diagonal",
                n = constants.len()
            ));
        }
        Ok(())
    }
}
