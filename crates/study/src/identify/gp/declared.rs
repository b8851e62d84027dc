//! A formula whose structure is declared: only its constants are fitted, from several places.

use super::constants::{FittedFormula, fitted};
use super::draw::Draws;
use super::folds::LeftOut;
use super::problem::{GpProblem, SMALL};
use super::report::{GpReport, only};
use super::rows::DataRows;
use super::template::Template;
use crate::base::formula::{Formula, Node, Operator};
use crate::base::language::tr;
use crate::base::math;

/// Places that a fit is begun at.
const STARTS: u64 = 60;
/// Parts that many rows are left out in.
const PARTS: usize = 10;

/// The formula with values for its named constants.
fn started(formula: &Formula, draws: &mut Draws, first: bool) -> Option<Formula> {
    fn start(node: &Node, exponent: bool, draws: &mut Draws, first: bool) -> Node {
        match node {
            Node::Constant(constant) if super::constants::is_named(node) => {
                let mut constant = constant.clone();
                if !first && exponent {
                    constant.value = 7.0 * draws.uniform() - 3.0;
                } else if !first {
                    // Any sign, any magnitude from 1e-4 to 1e4.
                    let size = math::exp(9.2 * (2.0 * draws.uniform() - 1.0));
                    constant.value = if draws.chance(0.5) { size } else { -size };
                }
                Node::Constant(constant)
            }
            Node::Number(_) | Node::Input(_) | Node::Constant(_) => node.clone(),
            Node::Unary(function, a) => Node::unary(*function, start(a, false, draws, first)),
            Node::Binary(operator, pair) => {
                let a = start(&pair[0], false, draws, first);
                let b = start(&pair[1], *operator == Operator::Power, draws, first);
                Node::binary(*operator, a, b)
            }
        }
    }
    Formula::new(start(formula.root(), false, draws, first), formula.inputs()).ok()
}

fn best(formula: &Formula, rows: &DataRows, seed: u64) -> Result<FittedFormula, String> {
    let mut found: Result<FittedFormula, String> =
        Err(tr("no start has a value on all rows").to_owned());
    for number in 0..STARTS {
        let mut draws = Draws::new(seed, "identify.gp.declared", number);
        let Some(start) = started(formula, &mut draws, number == 0) else { continue };
        match (fitted(&start, rows), &found) {
            (Ok(next), Ok(known)) if next.rms() >= known.rms() => {}
            (Ok(next), _) => found = Ok(next),
            (Err(problem), Err(_)) if number == 0 => found = Err(problem),
            (Err(_), _) => {}
        }
    }
    found
}

/// Fits the constants of a template without T, and reports.
///
/// # Errors
/// The formula has no values on the rows wherever it is begun, or too many constants.
pub fn declared_report(
    problem: &GpProblem,
    template: &Template,
    seed: u64,
) -> Result<GpReport, String> {
    let rows = &problem.rows;
    let fit = best(&template.formula, rows, seed)?;
    let parts = if rows.len() <= SMALL { rows.len() } else { PARTS };
    let mut errors = vec![f64::INFINITY; rows.len()];
    for part in 0..parts {
        let rest = rows.only(|row| row % parts != part);
        let Ok(without) = best(&template.formula, &rest, seed) else { continue };
        let program = without.formula.compile();
        for row in (0..rows.len()).filter(|row| row % parts == part) {
            let at: Vec<f64> = rows.inputs.iter().map(|column| column[row]).collect();
            errors[row] = rows.target[row] - program.value(&at);
        }
    }
    Ok(only(problem, fit, LeftOut { errors }, seed))
}
