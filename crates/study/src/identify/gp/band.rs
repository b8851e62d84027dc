//! The 95 % band about a fitted formula: where the true values lie as far as the rows tell, if its form is the true
//! one. To first order in the constants (Seber and Wild, Nonlinear Regression, 1989, section 5.1):
//!
//! ```text
//! y(x) +- t sqrt(g' C g),   g = dy/dc at x, C the covariance of the constants c
//! ```
//!
//! with t the 97.5 % point of Student's distribution of the residuals' freedom.

use super::constants::{column, covariance, t_quantile};
use super::fit::dot;
use super::rows::DataRows;
use crate::base::formula::{CompiledFormula, Formula, Node};
use crate::models::formula_model::{FormulaFit, FormulaModel};

/// The band of a formula.
#[derive(Clone, Debug)]
pub struct FormulaBand {
    /// Derivatives by the constants, which are inputs behind those of the formula.
    slopes: Vec<CompiledFormula>,
    fit: FormulaFit,
}

/// A formula's derivatives by some of its numbers, which are further inputs then, and these numbers.
struct Slopes {
    slopes: Vec<CompiledFormula>,
    constants: Vec<f64>,
}

impl Slopes {
    /// By the numbers of these magnitudes, from left to right: a sign may stand before a number. None where the
    /// formula has not all of them, or a derivative is too large.
    fn of(formula: &Formula, magnitudes: &[f64]) -> Option<Self> {
        fn opened(node: &Node, first: usize, wanted: &[f64], found: &mut Vec<f64>) -> Node {
            match node {
                Node::Number(x) if wanted.get(found.len()).is_some_and(|w| w.abs() == x.abs()) => {
                    found.push(*x);
                    Node::Input(first + found.len() - 1)
                }
                Node::Number(_) | Node::Input(_) | Node::Constant(_) => node.clone(),
                Node::Unary(function, a) => Node::unary(*function, opened(a, first, wanted, found)),
                Node::Binary(operator, pair) => {
                    let a = opened(&pair[0], first, wanted, found);
                    let b = opened(&pair[1], first, wanted, found);
                    Node::binary(*operator, a, b)
                }
            }
        }
        let first = formula.inputs().len();
        let mut constants = Vec::new();
        let root = opened(formula.root(), first, magnitudes, &mut constants);
        let mut names = formula.inputs().to_vec();
        // Names that no column can have.
        names.extend((0..constants.len()).map(|number| format!("\u{1}{number}")));
        let open = Formula::new(root, &names).ok()?;
        let slope = |k: usize| Some(open.derivative(first + k).ok()?.compile());
        let slopes = (0..constants.len()).map(slope).collect::<Option<_>>()?;
        (constants.len() == magnitudes.len()).then_some(Self { slopes, constants })
    }
}

/// How sure rows make the constants of a formula that was fitted to them; none where they do not determine all of
/// them.
#[must_use]
pub fn fit(formula: &Formula, fitted: &[f64], rows: &DataRows) -> Option<FormulaFit> {
    let Slopes { slopes, constants } = Slopes::of(formula, fitted)?;
    let freedom = rows.len().checked_sub(constants.len()).filter(|freedom| *freedom > 0)?;
    let values = column(&formula.compile(), rows, &[]);
    let residuals: Vec<f64> = rows.target.iter().zip(values).map(|(y, value)| y - value).collect();
    let variance = dot(&residuals, &residuals) / freedom as f64;
    let jacobian: Vec<Vec<f64>> =
        slopes.iter().map(|slope| column(slope, rows, &constants)).collect();
    let spread = covariance(&jacobian)?;
    let lower = spread.iter().enumerate();
    let covariance: Vec<Vec<f64>> =
        lower.map(|(k, row)| row[..=k].iter().map(|x| variance * x).collect()).collect();
    let sound = covariance.iter().flatten().all(|x| x.is_finite());
    sound.then(|| FormulaFit {
        rows: rows.len(),
        deviation: variance.sqrt(),
        constants,
        covariance,
    })
}

impl FormulaBand {
    /// The band of a model that has what it takes.
    #[must_use]
    pub fn of(model: &FormulaModel) -> Option<Self> {
        Self::new(model.formula(), model.fit()?.clone())
    }

    /// The band of a formula by its fit.
    #[must_use]
    pub fn new(formula: &Formula, fit: FormulaFit) -> Option<Self> {
        let Slopes { slopes, .. } = Slopes::of(formula, &fit.constants)?;
        Some(Self { slopes, fit })
    }

    /// Half its width at a place of the formula's ranges, in the unit of the result; none where that is not finite.
    #[must_use]
    pub fn half_width(&self, inputs: &[f64]) -> Option<f64> {
        let mut values = inputs.to_vec();
        values.extend(&self.fit.constants);
        let slopes: Vec<f64> = self.slopes.iter().map(|slope| slope.value(&values)).collect();
        let row = |k: usize| -> f64 {
            slopes.iter().enumerate().map(|(l, slope)| self.fit.covariance(k, l) * slope).sum()
        };
        let variance: f64 = slopes.iter().enumerate().map(|(k, slope)| slope * row(k)).sum();
        let half = t_quantile(self.fit.freedom()) * variance.max(0.0).sqrt();
        (variance.is_finite() && half.is_finite()).then_some(half)
    }
}
