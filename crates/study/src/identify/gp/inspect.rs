//! One formula of the front looked at closely: predictions and residuals row by row, outliers, units of its
//! constants, where it holds, and its model.

use super::band::FormulaBand;
use super::constants::fitted;
use super::model::fitted_model;
use super::problem::{GpProblem, MOST_SEARCHED};
use super::range::RangeReport;
use super::report::{FrontFormula, OutlyingRow, ReportedConstant, outliers};
use super::standing::StandingFormula;
use super::units::by_name;
use crate::base::formula::{Formula, NumberUnits, Unit};
use crate::models::formula_model::FormulaModel;

/// See the head of this file.
#[derive(Clone, Debug)]
pub struct FormulaInspection {
    /// The formula, of all inputs of the problem.
    pub formula: Formula,
    /// Its fitted constants, from left to right; whole and half exponents are none.
    pub constants: Vec<ReportedConstant>,
    /// Its values, row by row.
    pub predicted: Vec<f64>,
    /// Half the width of its 95 % band, row by row; none where the rows do not determine its constants, or it can be
    /// no model.
    pub bands: Vec<Option<f64>>,
    /// Target minus formula, row by row.
    pub residuals: Vec<f64>,
    /// Rows that do not fit it, by the rule of the report.
    pub outliers: Vec<OutlyingRow>,
    /// Units of its fitted constants, from left to right; none where its units leave one open. Or why the formula is
    /// not right in its units.
    pub units: Result<Vec<Option<String>>, String>,
    /// What is certain of it on the ranges of the rows, and on wider ones.
    pub ranges: RangeReport,
    /// Its model on the ranges of the rows, or why it can be none.
    pub model: Result<FormulaModel, String>,
}

/// Unit of a column: the one given, the one its name ends with, or none.
fn unit_of(column: &str, given: &[(String, Unit)]) -> Unit {
    let own = given.iter().find(|(name, _)| name == column).map(|(_, unit)| unit.clone());
    own.or_else(|| by_name(column)).unwrap_or_else(Unit::none)
}

/// Half the width of a model's band at the rows.
fn bands(problem: &GpProblem, model: Option<&FormulaModel>) -> Vec<Option<f64>> {
    let count = problem.rows.len();
    let Some((model, band)) = model.and_then(|model| Some((model, FormulaBand::of(model)?))) else {
        return vec![None; count];
    };
    let place = |name: &String| problem.inputs.iter().position(|input| input == name);
    let columns: Vec<&Vec<f64>> = (model.formula().inputs().iter())
        .filter_map(|name| problem.rows.inputs.get(place(name)?))
        .collect();
    let at = |row: usize| -> Vec<f64> { columns.iter().map(|column| column[row]).collect() };
    (0..count).map(|row| band.half_width(&at(row))).collect()
}

impl FormulaInspection {
    /// Looks at a formula of a report; `given` are units of columns, `source` says where the formula comes from.
    ///
    /// # Errors
    /// It is no formula of the problem's columns.
    pub fn of(
        problem: &GpProblem,
        found: &FrontFormula,
        given: &[(String, Unit)],
        source: String,
    ) -> Result<Self, String> {
        let formula =
            Formula::parse(&found.formula, &problem.inputs).map_err(|error| error.to_string())?;
        if problem.rows.len() > MOST_SEARCHED && !found.chosen {
            return Self::fitted(problem, &formula, given, source);
        }
        // Where nothing is left over, no row stands out.
        let outliers = match fitted(&formula, &problem.rows) {
            Ok(fit) if !found.exact => outliers(problem, &fit),
            Ok(_) | Err(_) => Vec::new(),
        };
        Ok(Self::told(problem, formula, found.constants.clone(), outliers, given, source))
    }

    /// The same of a formula of a search under way: its constants are fitted to all rows first.
    ///
    /// # Errors
    /// It is no formula of the problem's columns, or has no finite value on some row.
    pub fn on_the_way(
        problem: &GpProblem,
        found: &StandingFormula,
        given: &[(String, Unit)],
        source: String,
    ) -> Result<Self, String> {
        let formula =
            Formula::parse(&found.formula, &problem.inputs).map_err(|error| error.to_string())?;
        Self::fitted(problem, &formula, given, source)
    }

    /// With its constants fitted to all rows.
    fn fitted(
        problem: &GpProblem,
        formula: &Formula,
        given: &[(String, Unit)],
        source: String,
    ) -> Result<Self, String> {
        let fit = fitted(formula, &problem.rows)?;
        let constants = fit.constants.iter().map(ReportedConstant::from).collect();
        Ok(Self::told(
            problem,
            fit.formula.clone(),
            constants,
            outliers(problem, &fit),
            given,
            source,
        ))
    }

    fn told(
        problem: &GpProblem,
        formula: Formula,
        constants: Vec<ReportedConstant>,
        outliers: Vec<OutlyingRow>,
        given: &[(String, Unit)],
        source: String,
    ) -> Self {
        let program = formula.compile();
        let value = |row: usize| {
            let at: Vec<f64> = problem.rows.inputs.iter().map(|column| column[row]).collect();
            program.value(&at)
        };
        let predicted: Vec<f64> = (0..problem.rows.len()).map(value).collect();
        let pairs = problem.rows.target.iter().zip(&predicted);
        let residuals: Vec<f64> = pairs.map(|(y, value)| y - value).collect();
        let inputs: Vec<Unit> =
            problem.inputs.iter().map(|column| unit_of(column, given)).collect();
        let output = unit_of(&problem.target, given);
        let checked = formula.check_units(&inputs, &output, NumberUnits::Solved);
        let units = checked
            .map(|checked| {
                let mut all = checked.constants.into_iter();
                // Whole exponents are numbers too, but not fitted ones.
                let unit = |constant: &ReportedConstant| {
                    let found = all.by_ref().find(|found| found.value == constant.value)?;
                    found.fixed.then_some(found.unit)
                };
                constants.iter().map(unit).collect()
            })
            .map_err(|error| error.to_string());
        let ranges = RangeReport::of(problem, &formula);
        let model = fitted_model(problem, &formula, &constants, given, source);
        let bands = bands(problem, model.as_ref().ok());
        Self { formula, constants, predicted, bands, residuals, outliers, units, ranges, model }
    }
}
