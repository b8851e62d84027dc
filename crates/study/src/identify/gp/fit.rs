//! Fits a sum of terms to rows: coefficients by linear least squares, constants inside the terms by
//! Levenberg and Marquardt's method on what least squares leave (variable projection, Golub and Pereyra
//! 1973, with the Jacobian of Kaufman 1975).

use super::evaluate::Sweeps;
use super::node::{Step, Sum};
use super::rows::{DataRows, FEW_ROWS};
use super::tidy::{LEAST_EXPONENT, MOST_EXPONENT};
use crate::base::cholesky;

/// Share of a column that must be left when the others are taken out of it.
const INDEPENDENT: f64 = 1e-10;
/// Residual over spread, in squares, below which a fit is exact up to rounding.
pub const EXACT: f64 = 1e-26;

/// How a fit is done.
#[derive(Clone, Copy, Debug)]
pub struct Effort {
    /// Most steps.
    pub steps: usize,
    /// Sum of squares above which slow progress is not worth going on.
    pub goal: f64,
}

/// Columns, orthonormal ones, and what is left.
#[derive(Default)]
pub struct Fitter {
    sweeps: Sweeps,
    /// Values of the terms.
    columns: Vec<Vec<f64>>,
    /// Orthonormal columns: the constant, then the terms.
    basis: Vec<Vec<f64>>,
    /// The columns in the basis, upper triangle by columns.
    upper: Vec<Vec<f64>>,
    /// The target in the basis.
    heights: Vec<f64>,
    /// Target minus fit.
    pub residuals: Vec<f64>,
    /// Derivatives of each term by its constants.
    derivatives: Vec<Vec<Vec<f64>>>,
    /// Derivatives of the fit, what the terms explain taken out.
    jacobian: Vec<Vec<f64>>,
}

#[must_use]
pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    // Four sums side by side, always in this order.
    let mut sums = [0.0; 4];
    let (a4, b4) = (a.chunks_exact(4), b.chunks_exact(4));
    let rest: f64 = a4.remainder().iter().zip(b4.remainder()).map(|(a, b)| a * b).sum();
    for (a, b) in a4.zip(b4) {
        for lane in 0..4 {
            sums[lane] += a[lane] * b[lane];
        }
    }
    (sums[0] + sums[1]) + (sums[2] + sums[3]) + rest
}

fn take_out(from: &mut [f64], share: f64, of: &[f64]) {
    for (from, of) in from.iter_mut().zip(of) {
        *from -= share * of;
    }
}

/// Whether all free exponents are within their bounds.
fn within(sum: &Sum) -> bool {
    let mut nodes = sum.terms.iter().flat_map(super::node::Product::nodes);
    nodes.all(|node| {
        let free = node.power().filter(|(_, free)| *free);
        free.is_none_or(|(exponent, _)| (LEAST_EXPONENT..=MOST_EXPONENT).contains(&exponent.abs()))
    })
}

impl Fitter {
    /// Works out the terms, and with `derive` their derivatives; `false` where a value is not finite.
    fn evaluate(&mut self, sum: &Sum, rows: &DataRows, all: bool, derive: bool) -> bool {
        let (n, count) = (rows.len(), sum.terms.len());
        self.columns.resize(count.max(self.columns.len()), Vec::new());
        self.derivatives.resize(count.max(self.derivatives.len()), Vec::new());
        for (k, term) in sum.terms.iter().enumerate() {
            let constants = term.constants();
            if !all && constants == 0 {
                continue;
            }
            self.columns[k].resize(n, 0.0);
            let code = term.code();
            let derivatives = &mut self.derivatives[k];
            derivatives.resize(constants, Vec::new());
            derivatives.iter_mut().for_each(|column| column.resize(n, 0.0));
            let derivatives = (derive && constants > 0).then_some(&mut derivatives[..]);
            if !self.sweeps.run(&code, &rows.inputs, &mut self.columns[k], derivatives) {
                return false;
            }
        }
        true
    }

    /// Least squares over the terms; the sum of the squares that are left, or the term that depends on
    /// those before it.
    fn project(&mut self, sum: &Sum, rows: &DataRows) -> Result<f64, usize> {
        let (n, count) = (rows.len(), sum.linear());
        let first = usize::from(sum.intercept);
        self.basis.resize(count.max(self.basis.len()), Vec::new());
        self.upper.resize(count.max(self.upper.len()), Vec::new());
        self.heights.clear();
        self.residuals.clear();
        self.residuals.extend_from_slice(&rows.target);
        for k in 0..count {
            let (before, rest) = self.basis.split_at_mut(k);
            let own = &mut rest[0];
            own.clear();
            let upper = &mut self.upper[k];
            upper.clear();
            if k < first {
                own.resize(n, 1.0);
            } else {
                own.extend_from_slice(&self.columns[k - first]);
            }
            let whole = dot(own, own);
            for basis in before.iter() {
                let share = dot(own, basis);
                take_out(own, share, basis);
                upper.push(share);
            }
            let left = dot(own, own);
            let independent = left > INDEPENDENT * INDEPENDENT * whole && left.is_finite();
            if !independent {
                return Err(k.saturating_sub(first));
            }
            let norm = left.sqrt();
            own.iter_mut().for_each(|x| *x /= norm);
            if left < 1e-6 * whole {
                // Much was taken out: what rounding has left of the others goes too.
                for basis in before.iter() {
                    let share = dot(own, basis);
                    take_out(own, share, basis);
                }
                let norm = dot(own, own).sqrt();
                own.iter_mut().for_each(|x| *x /= norm);
            }
            upper.push(norm);
            let height = dot(&self.residuals, own);
            take_out(&mut self.residuals, height, own);
            self.heights.push(height);
        }
        Ok(dot(&self.residuals, &self.residuals))
    }

    /// The coefficients of the last projection.
    fn coefficients(&self, sum: &Sum) -> Vec<f64> {
        let count = sum.linear();
        let mut c = self.heights[..count].to_vec();
        for k in (0..count).rev() {
            let known: f64 = (k + 1..count).map(|j| self.upper[j][k] * c[j]).sum();
            c[k] = (c[k] - known) / self.upper[k][k];
        }
        if !sum.intercept {
            c.insert(0, 0.0);
        }
        c
    }

    /// The Jacobian of what is left, up to its sign.
    fn linearise(&mut self, sum: &Sum, coefficients: &[f64]) {
        let count = sum.linear();
        let mut m = 0;
        for (k, term) in sum.terms.iter().enumerate() {
            for constant in 0..term.constants() {
                if self.jacobian.len() == m {
                    self.jacobian.push(Vec::new());
                }
                let column = &mut self.jacobian[m];
                column.clear();
                let factor = coefficients[k + 1];
                column.extend(self.derivatives[k][constant].iter().map(|d| factor * d));
                for basis in &self.basis[..count] {
                    let share = dot(column, basis);
                    take_out(column, share, basis);
                }
                m += 1;
            }
        }
        self.jacobian.truncate(m);
    }

    /// Fits `sum`; terms that others make superfluous are taken out of it. The sum of squares left, none
    /// where the formula has no values on the rows.
    pub fn fit(&mut self, sum: &mut Sum, rows: &DataRows, effort: Effort) -> Option<f64> {
        if sum.linear() == 0 {
            return None;
        }
        let spread = rows.spread();
        let mut left = loop {
            if !self.evaluate(sum, rows, true, true) {
                return None;
            }
            match self.project(sum, rows) {
                Ok(left) => break left,
                Err(_) if sum.linear() <= 1 => return None,
                Err(term) => {
                    sum.terms.remove(term);
                    self.columns.remove(term);
                    self.derivatives.remove(term);
                }
            }
        };
        let constants: usize = sum.terms.iter().map(super::node::Product::constants).sum();
        sum.coefficients = self.coefficients(sum);
        let mut damping = 1e-2;
        let mut steps = if constants > 0 { effort.steps } else { 0 };
        while steps > 0 && left > EXACT * 1e-4 * spread {
            steps -= 1;
            let coefficients = sum.coefficients.clone();
            self.linearise(sum, &coefficients);
            if self.jacobian.iter().any(|column| !dot(column, column).is_finite()) {
                break;
            }
            let before = left;
            let mut moved = None;
            for _ in 0..4 {
                let Some(step) = self.step(damping) else {
                    damping *= 10.0;
                    continue;
                };
                let mut next = sum.clone();
                let values = next.terms.iter_mut().flat_map(super::node::Product::constants_mut);
                for (value, step) in values.zip(&step) {
                    *value += step;
                }
                if within(&next)
                    && self.evaluate(&next, rows, false, true)
                    && let Ok(less) = self.project(&next, rows)
                    && less < left
                {
                    moved = Some(next);
                    left = less;
                    damping *= 0.1;
                    break;
                }
                damping *= 10.0;
            }
            let Some(next) = moved else {
                // The last trial has spoilt the columns.
                self.evaluate(sum, rows, false, true);
                left = self.project(sum, rows).ok()?;
                break;
            };
            *sum = next;
            sum.coefficients = self.coefficients(sum);
            if left > 0.999_9 * before || left > effort.goal && left > 0.8 * before {
                break;
            }
        }
        sum.coefficients.iter().all(|c| c.is_finite()).then_some(left)
    }

    /// Works out what a formula leaves with its constants as they are; `false` where it has no values. For
    /// [`Self::gain`].
    pub fn explain(&mut self, sum: &mut Sum, rows: &DataRows) -> bool {
        if sum.linear() == 0 {
            self.residuals.clear();
            self.residuals.extend_from_slice(&rows.target);
            return true;
        }
        self.fit(sum, rows, Effort { steps: 0, goal: 0.0 }).is_some()
    }

    /// A damped step of the constants from the last Jacobian.
    fn step(&self, damping: f64) -> Option<Vec<f64>> {
        let count = self.jacobian.len();
        let lower = (0..count)
            .map(|i| {
                let mut row: Vec<f64> =
                    (0..=i).map(|j| dot(&self.jacobian[i], &self.jacobian[j])).collect();
                row[i] = row[i] * (1.0 + damping) + f64::MIN_POSITIVE;
                row
            })
            .collect();
        // Kaufman's Jacobian of the fit: the residual falls along it.
        let slope = self.jacobian.iter().map(|column| dot(column, &self.residuals)).collect();
        cholesky::solve(lower, slope, 0.0)
    }

    /// The estimated error of prediction after [`Self::fit`]: with few rows, the root mean square of the
    /// residuals that each row would have if it were left out (by its leverage, constants inside the
    /// terms included); with many, the residual standard deviation.
    pub fn prediction_error(&mut self, sum: &Sum, rows: &DataRows, left: f64) -> f64 {
        let n = rows.len();
        let constants = sum.constants();
        if constants + 1 >= n {
            return f64::INFINITY;
        }
        if n > FEW_ROWS {
            return (left / (n - constants) as f64).sqrt();
        }
        let leverages = self.leverages(sum, n);
        let squares: f64 = self
            .residuals
            .iter()
            .zip(&leverages)
            .map(|(residual, leverage)| {
                let without = residual / (1.0 - leverage).max(1e-6);
                without * without
            })
            .sum();
        (squares / n as f64).sqrt()
    }

    /// The largest variation of a term after [`Self::fit`], as the norm of its values about their mean.
    #[must_use]
    pub fn cancellation(&self, sum: &Sum) -> f64 {
        let mut most: f64 = 0.0;
        for (column, coefficient) in self.columns.iter().zip(&sum.coefficients[1..]) {
            let mean = column.iter().sum::<f64>() / column.len() as f64;
            let squares: f64 = column.iter().map(|x| (x - mean) * (x - mean)).sum();
            most = most.max(coefficient.abs() * squares.sqrt());
        }
        most
    }

    /// Leverage of each row after [`Self::fit`].
    pub fn leverages(&mut self, sum: &Sum, n: usize) -> Vec<f64> {
        let count = sum.linear();
        let coefficients = sum.coefficients.clone();
        self.linearise(sum, &coefficients);
        let mut leverages = vec![0.0; n];
        for basis in &self.basis[..count] {
            for (leverage, q) in leverages.iter_mut().zip(basis) {
                *leverage += q * q;
            }
        }
        for m in 0..self.jacobian.len() {
            let (before, rest) = self.jacobian.split_at_mut(m);
            let own = &mut rest[0];
            let whole = dot(own, own);
            for column in before.iter() {
                let share = dot(own, column);
                take_out(own, share, column);
            }
            let left = dot(own, own);
            if left > 1e-16 * whole && left.is_finite() {
                let norm = left.sqrt();
                for (q, leverage) in own.iter_mut().zip(&mut leverages) {
                    *q /= norm;
                    *leverage += *q * *q;
                }
            } else {
                own.fill(0.0);
            }
        }
        leverages
    }

    /// Values of a formula at other rows; none where one is not finite.
    pub fn predict(&mut self, sum: &Sum, inputs: &[Vec<f64>], to: &mut Vec<f64>) -> bool {
        let n = inputs.first().map_or(0, Vec::len);
        to.clear();
        to.resize(n, sum.coefficients[0]);
        let mut column = vec![0.0; n];
        for (term, coefficient) in sum.terms.iter().zip(&sum.coefficients[1..]) {
            if !self.sweeps.run(&term.code(), inputs, &mut column, None) {
                return false;
            }
            for (to, value) in to.iter_mut().zip(&column) {
                *to += coefficient * value;
            }
        }
        true
    }

    /// Least squares of a formula whose constants inside the terms stay as they are, for a candidate term:
    /// by how much it would lower the sum of squares that the last fit has left.
    pub fn gain(&mut self, code: &[Step], sum: &Sum, rows: &DataRows, room: &mut Vec<f64>) -> f64 {
        room.resize(rows.len(), 0.0);
        if !self.sweeps.run(code, &rows.inputs, room, None) {
            return 0.0;
        }
        let whole = dot(room, room);
        for basis in &self.basis[..sum.linear()] {
            let share = dot(room, basis);
            take_out(room, share, basis);
        }
        let left = dot(room, room);
        let height = dot(room, &self.residuals);
        if left > 1e-12 * whole { height * height / left } else { 0.0 }
    }
}
