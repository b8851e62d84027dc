//! A formula of the front as a model file.

use super::problem::GpProblem;
use super::units::by_name;
use crate::base::formula::{Formula, Interval, Unit};
use crate::models::formula_model::{FormulaInput, FormulaModel, FormulaOutput};

/// The model of a formula of this problem, with the ranges of its rows. Units are those given, those that the
/// columns' names end with, or none.
///
/// # Errors
/// The formula is not certain to be finite with finite slopes on the ranges of the rows, or has too many
/// inputs.
pub fn model(
    problem: &GpProblem,
    text: &str,
    given: &[(String, Unit)],
    source: String,
) -> Result<FormulaModel, String> {
    let whole = Formula::parse(text, &problem.inputs).map_err(|error| error.to_string())?;
    let reads = whole.reads();
    let unit = |column: &String| {
        let own = given.iter().find(|(name, _)| name == column).map(|(_, unit)| unit.clone());
        own.or_else(|| by_name(column)).unwrap_or_else(Unit::none)
    };
    let ranges = problem.rows.ranges();
    let inputs: Vec<FormulaInput> = problem
        .inputs
        .iter()
        .zip(&ranges)
        .zip(reads)
        .filter(|(_, reads)| *reads)
        .map(|((name, [low, high]), _)| FormulaInput {
            name: name.clone(),
            unit: unit(name),
            range: Interval::new(*low, *high),
        })
        .collect();
    let names: Vec<&String> = inputs.iter().map(|input| &input.name).collect();
    let formula = Formula::parse(text, &names).map_err(|error| error.to_string())?;
    let output = FormulaOutput { name: problem.target.clone(), unit: unit(&problem.target) };
    FormulaModel::new(formula, inputs, output, source)
}
