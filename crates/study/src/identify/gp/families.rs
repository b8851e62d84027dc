//! Simple families of curves and laws that every search begins with: with few rows one of them is often the
//! most that can be told.

use super::archive::FittedSum;
use super::fit::{Effort, Fitter};
use super::node::{Factor, Product, RECIPROCAL, Step, Sum, fixed};
use super::rows::DataRows;

fn sum(intercept: bool, terms: Vec<Factor>) -> Sum {
    Sum::of(intercept, terms.into_iter().map(Product::of).collect())
}

/// The families of curves with their constants fitted, at most `size` nodes large; without those that have
/// no values on the rows, or as many constants as rows.
#[must_use]
pub fn declared(rows: &DataRows, positive: &[bool], size: usize) -> Vec<FittedSum> {
    let mut fitter = Fitter::default();
    let mut found = Vec::new();
    for mut sum in families(rows, positive) {
        let effort = Effort { steps: 40, goal: 0.0 };
        let Some(left) = fitter.fit(&mut sum, rows, effort) else { continue };
        let error = fitter.prediction_error(&sum, rows, left);
        let sizes = sum.size();
        if sizes <= size && error.is_finite() && !sum.terms.is_empty() {
            found.push(FittedSum { sum, size: sizes, left, error });
        }
    }
    found
}

/// The families of some of the inputs.
#[must_use]
pub fn families_of(rows: &DataRows, positive: &[bool], inputs: &[u8]) -> Vec<Sum> {
    let column = |input: &u8| rows.inputs[usize::from(*input)].clone();
    let some =
        DataRows { inputs: inputs.iter().map(column).collect(), target: rows.target.clone() };
    let positive: Vec<bool> = inputs.iter().map(|input| positive[usize::from(*input)]).collect();
    let mut found = families(&some, &positive);
    for step in
        found.iter_mut().flat_map(|sum| &mut sum.terms).flat_map(|term| &mut term.factors).flatten()
    {
        if let Step::Input(number) = step {
            *number = inputs[usize::from(*number)];
        }
    }
    found
}

/// The families for these rows, of which some inputs are positive.
#[must_use]
pub fn families(rows: &DataRows, positive: &[bool]) -> Vec<Sum> {
    let ranges = rows.ranges();
    let mut found = vec![Sum::default()];
    let inputs = 0..ranges.len() as u8;
    for ((input, [low, high]), positive) in inputs.clone().zip(&ranges).zip(positive) {
        let x = Step::Input(input);
        let power = |exponent| vec![x, Step::Power { exponent, free: true }];
        let scale = low.abs().max(high.abs());
        let rate = |by: f64| vec![x, Step::Constant(by / scale), Step::Mul, Step::Exp];
        found.extend([
            sum(true, vec![vec![x]]),
            sum(true, vec![vec![x], vec![x, fixed(2.0)]]),
            sum(true, vec![vec![x], vec![x, fixed(2.0)], vec![x, fixed(3.0)]]),
            sum(true, vec![vec![x, fixed(2.0)]]),
            sum(true, vec![vec![x, fixed(3.0)]]),
            sum(false, vec![rate(1.0)]),
            sum(false, vec![rate(-1.0)]),
            sum(true, vec![rate(2.0)]),
            sum(true, vec![rate(-2.0)]),
        ]);
        for c in [-0.2 * (high - low) + low, 0.5 * (low + high), high + 0.2 * (high - low)] {
            let shifted = |node: Step| vec![x, Step::Constant(-c), Step::Add, node];
            found.extend([2.0, 3.0, 4.0, 5.0, -1.0].map(|e| sum(true, vec![shifted(fixed(e))])));
            found.push(sum(true, vec![shifted(Step::Ln)]));
        }
        if *positive {
            found.extend([
                sum(true, vec![vec![x, RECIPROCAL]]),
                sum(true, vec![vec![x, fixed(-2.0)]]),
                sum(true, vec![vec![x, fixed(-0.5)]]),
                sum(true, vec![vec![x, fixed(0.5)]]),
                sum(true, vec![vec![x, Step::Ln]]),
                sum(false, vec![power(0.7)]),
                sum(false, vec![power(-0.7)]),
                sum(true, vec![power(1.7)]),
                sum(true, vec![power(-0.7)]),
            ]);
        }
    }
    if ranges.len() > 1 {
        found.push(sum(true, inputs.clone().map(|input| vec![Step::Input(input)]).collect()));
        let power =
            |exponent| move |input| vec![Step::Input(input), Step::Power { exponent, free: true }];
        if positive.iter().all(|positive| *positive) {
            // The product of powers, as in the laws of Kienzle and Taylor.
            let factors: Vec<Factor> = inputs.clone().map(power(0.6)).collect();
            found.push(Sum::of(false, vec![Product { factors }]));
            found.push(sum(true, inputs.map(power(0.8)).collect()));
        }
    }
    found
}
