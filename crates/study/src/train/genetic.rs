//! The formula of the 2013 paper's comparison, found by this program's own genetic programming on the rows that
//! the networks are trained on: the largest force in the plane of the teeth over the same eight inputs.
//!
//! The search goes over the logarithm of the force, so that it is fitted to what it is judged by, relative
//! errors, as the other formulas are ([`super::formula`]).

use std::fmt::Write as _;

use super::data::{RowsJob, TrainingRow, fxy_n};
use super::recipe::RecipeKind;
use super::split;
use crate::base::formula::Unit;
use crate::base::language::text;
use crate::base::math;
use crate::identify::gp::job::{GpJob, GpSettings};
use crate::identify::gp::model::model;
use crate::identify::gp::problem::GpProblem;
use crate::models::formula_model::FormulaModel;
use crate::models::neural_force::INPUTS;
use crate::run::job::{Budget, Job, Progress};

/// Seed of the search.
pub const SEED: u64 = 1;
/// Most batches of the search.
pub const BATCHES: u64 = 300;
/// Name of the result.
const FORCE: &str = "force_n";

/// The shipped formula, as `steadycut train genetic` writes it.
pub const SHIPPED: &str = include_str!("../../../../assets/models/genetic_force.toml");

/// Units of columns whose names do not tell them.
fn units() -> Result<Vec<(String, Unit)>, String> {
    [("material_code", ""), ("geometry_code", ""), ("hardness_hb", "HB"), (FORCE, "N")]
        .into_iter()
        .map(|(name, unit)| Ok((name.to_owned(), Unit::parse(unit)?)))
        .collect()
}

/// The shipped formula.
///
/// # Panics
/// Never: a test reads the shipped file.
#[must_use]
pub fn shipped() -> FormulaModel {
    FormulaModel::parse(SHIPPED).expect("the shipped formula is checked by a test")
}

/// The force in N that a formula gives for the cut of a row.
#[must_use]
pub fn force_n(model: &FormulaModel, row: &TrainingRow) -> f64 {
    let inputs = row.cut.inputs();
    let of = |name: &str| INPUTS.iter().position(|input| *input == name).map(|at| inputs[at]);
    let values: Vec<f64> =
        model.inputs().iter().map(|input| of(&input.name).unwrap_or(f64::NAN)).collect();
    model.at(&values).value
}

/// What was found.
#[derive(Clone, Debug, PartialEq)]
pub struct FoundForce {
    /// The text of the model file; none before the end.
    pub file: Option<String>,
}

/// Rows and search.
#[derive(Clone)]
pub struct GeneticForceJob {
    rows: RowsJob,
    search: Option<GpJob>,
    found: Option<String>,
    refusal: Option<String>,
    batches: u64,
}

impl Default for GeneticForceJob {
    fn default() -> Self {
        let recipe = RecipeKind::Literal.recipe();
        Self::new(recipe.rows, BATCHES)
    }
}

impl GeneticForceJob {
    /// A search over the part of so many measured rows that networks are trained on.
    #[must_use]
    pub fn new(rows: u32, batches: u64) -> Self {
        let rows = RowsJob::measured(rows, RecipeKind::Literal.recipe().seed);
        Self { rows, search: None, found: None, refusal: None, batches }
    }

    fn problem(&self) -> Result<GpProblem, String> {
        let (training, _) = split(self.rows.rows());
        let mut text = format!("{},{FORCE}", INPUTS.join(","));
        for row in training {
            let force_n = math::ln(fxy_n(&row.forces_n));
            let cells = row.cut.inputs().into_iter().chain([force_n]);
            let cells: Vec<String> = cells.map(|x| x.to_string()).collect();
            let _ = write!(text, "\n{}", cells.join(","));
        }
        // Codes count from 1: none of the inputs is ever negative.
        Ok(GpProblem::read(&text, FORCE, &INPUTS.map(str::to_owned))?.told(&units()?))
    }

    fn written(search: &GpJob) -> Result<String, String> {
        let report = search.report();
        let chosen = report.chosen().ok_or("no formula is certain to be finite on its ranges")?;
        let source = format!(
            "{} of {} rows, seed {SEED}, {} batches, by `steadycut train genetic`",
            report.searched_rows, report.rows, report.batches
        );
        let text = format!("exp({})", chosen.formula);
        Ok(model(search.problem(), &text, &units()?, source)?.write())
    }
}

/// A step is a row, then one of the search's.
impl Job for GeneticForceJob {
    type Partial = FoundForce;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        if self.found.is_some() || self.refusal.is_some() {
            return true;
        }
        if !self.rows.advance(budget) {
            return false;
        }
        let begun = match self.search.take() {
            Some(search) => Ok(search),
            None => self.problem().and_then(|problem| {
                let settings = GpSettings { seed: SEED, batches: self.batches, paper: None };
                GpJob::new(problem, &settings)
            }),
        };
        let mut search = match begun {
            Ok(search) => search,
            Err(problem) => {
                self.refusal = Some(problem);
                return true;
            }
        };
        let over = search.advance(budget);
        if over {
            match Self::written(&search) {
                Ok(file) => self.found = Some(file),
                Err(problem) => self.refusal = Some(problem),
            }
        }
        self.search = Some(search);
        over
    }

    fn progress(&self) -> Progress {
        // The rows count as a tenth.
        let search = self.search.as_ref().map_or(0.0, |search| search.progress().share());
        let done = if self.found.is_some() {
            1.0
        } else {
            0.1 * self.rows.progress().share() + 0.9 * search
        };
        let total = self.batches as f64;
        Progress { done: total * done, total, unit: text!("batches") }
    }

    fn partial(&self) -> FoundForce {
        FoundForce { file: self.found.clone() }
    }

    fn refusal(&self) -> Option<&str> {
        self.refusal.as_deref()
    }
}
