//! A formula of the front as a model file.

use super::band::fit;
use super::problem::GpProblem;
use super::report::ReportedConstant;
use super::units::by_name;
use crate::base::formula::{Formula, Interval, Unit};
use crate::models::formula_model::{FormulaInput, FormulaModel, FormulaOutput};

/// The model of a formula that was fitted to the problem's rows, with its band where they determine all constants.
///
/// # Errors
/// As [`model`].
pub fn fitted_model(
    problem: &GpProblem,
    formula: &Formula,
    constants: &[ReportedConstant],
    given: &[(String, Unit)],
    source: String,
) -> Result<FormulaModel, String> {
    let model = model(problem, &formula.to_string(), given, source)?;
    Ok(banded(model, problem, constants))
}

/// A model of a formula that was fitted to the problem's rows, with its band where they determine all constants.
#[must_use]
pub fn banded(
    model: FormulaModel,
    problem: &GpProblem,
    constants: &[ReportedConstant],
) -> FormulaModel {
    let values: Vec<f64> = constants.iter().map(|constant| constant.value).collect();
    let whole = Formula::parse(&model.formula().to_string(), &problem.inputs).ok();
    let fit = whole.and_then(|whole| fit(&whole, &values, &problem.rows));
    // What is no sound fit is none: the model stands without.
    fit.and_then(|fit| model.clone().with_fit(fit).ok()).unwrap_or(model)
}

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
