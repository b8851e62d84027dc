//! Models K1..K5 from the cuts: which columns each is a formula of, and which formula of a front is taken.

use std::fmt::Write as _;

use serde::Serialize;

use super::super::design::RunRole;
use super::super::measure::MeasuredCut;
use super::super::plan::ExperimentPlan;
use super::super::sheet::{FORCE, ROUGHNESS};
use crate::base::formula::{Formula, Interval, Trend};
use crate::base::language::tr;
use crate::identify::gp::model::banded;
use crate::identify::gp::problem::GpProblem;
use crate::identify::gp::report::{FrontFormula, GpReport};
use crate::identify::gp::units::by_name;
use crate::models::formula_model::{FormulaInput, FormulaModel, FormulaOutput, OwnFormula};
use crate::models::genetic::FormulaSettings;
use crate::models::tool::ShippedTool;
use crate::run::digest::Digest;

steadycut_core::choice! {
    /// A model of the papers; its id is the setting's under `formula`.
    pub enum FoundRole {
        /// Force for a target Ra.
        ForceOfRa = "force_of_ra", "K1";
        /// Feed command for a force.
        Feed = "feed", "K2";
        /// Speed command for a force.
        Speed = "speed", "K3";
        /// Force of feed and speed.
        Force = "force", "K4";
        /// Ra of a force.
        Ra = "ra", "K5 = K6";
    }
}

/// Columns of feed and speed.
const FEED: &str = "feed_mm_min";
const SPEED: &str = "speed_rpm";

impl FoundRole {
    /// The column that it gives.
    #[must_use]
    pub fn target(self) -> &'static str {
        match self {
            Self::ForceOfRa | Self::Force => FORCE,
            Self::Feed => FEED,
            Self::Speed => SPEED,
            Self::Ra => ROUGHNESS,
        }
    }

    /// The columns that it reads.
    #[must_use]
    pub fn inputs(self) -> &'static [&'static str] {
        match self {
            Self::ForceOfRa => &[ROUGHNESS],
            Self::Feed | Self::Speed | Self::Ra => &[FORCE],
            Self::Force => &[FEED, SPEED],
        }
    }

    /// Whether it has to rise with its first input; otherwise it has to fall. A controller that turns round
    /// would go the wrong way.
    #[must_use]
    pub fn rises(self) -> bool {
        match self {
            Self::ForceOfRa | Self::Feed | Self::Force | Self::Ra => true,
            Self::Speed => false,
        }
    }

    /// Whether it is a formula of the cuts on the line alone.
    #[must_use]
    pub fn on_line(self) -> bool {
        match self {
            Self::Feed | Self::Speed => true,
            Self::ForceOfRa | Self::Force | Self::Ra => false,
        }
    }

    /// The cuts as a problem of the search.
    ///
    /// # Errors
    /// Too few cuts were measured.
    pub fn problem(self, plan: &ExperimentPlan, cuts: &[MeasuredCut]) -> Result<GpProblem, String> {
        let columns: Vec<&str> = self.inputs().iter().copied().chain([self.target()]).collect();
        let mut text = columns.join(",");
        for (run, cut) in plan.runs.iter().zip(cuts) {
            if self.on_line() && run.role != RunRole::Line {
                continue;
            }
            let cell = |column: &&str| match *column {
                FEED => run.values.first().copied(),
                SPEED => run.values.get(1).copied(),
                FORCE => cut.force_n,
                _ => cut.ra_um,
            };
            let cells: Option<Vec<f64>> = columns.iter().map(cell).collect();
            if let Some(cells) = cells {
                let cells: Vec<String> = cells.iter().map(f64::to_string).collect();
                let _ = write!(text, "\n{}", cells.join(","));
            }
        }
        let inputs: Vec<String> = self.inputs().iter().map(|&name| name.to_owned()).collect();
        GpProblem::read(&text, self.target(), &inputs)
            .map_err(|problem| format!("{}: {problem}", self.label()))
    }
}

/// A model that was found, with where it holds.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FoundModel {
    /// What it stands for.
    pub role: FoundRole,
    /// Its name in the papers.
    pub name: &'static str,
    /// The formula.
    pub formula: String,
    /// Its nodes.
    pub size: usize,
    /// Number of cuts.
    pub cuts: usize,
    /// Root mean square of its residuals, in the unit of what it gives.
    pub error: f64,
    /// The same at cuts left out.
    pub left_out_error: Option<f64>,
    /// Whether it is the one that the search chose: otherwise the next of its front that goes one way.
    pub first_choice: bool,
    /// The inputs with the ranges that it was found on; beyond them it is an extrapolation.
    pub ranges: Vec<(String, [f64; 2])>,
    /// The model.
    #[serde(skip)]
    pub model: FormulaModel,
}

/// The formula of a front that is taken: the one chosen, or the next by its error at cuts left out; certain to be
/// finite on the ranges of its cuts, with its slopes, and certain to rise or fall with its first input there.
///
/// # Errors
/// None of the front is.
pub fn pick(
    role: FoundRole,
    problem: &GpProblem,
    report: &GpReport,
    (source, tool): (&str, ShippedTool),
) -> Result<FoundModel, String> {
    let mut front: Vec<&FrontFormula> = report.front.iter().collect();
    let error = |formula: &FrontFormula| formula.loo_error.unwrap_or(formula.error);
    front.sort_by(|a, b| b.chosen.cmp(&a.chosen).then_with(|| error(a).total_cmp(&error(b))));
    let mut why = tr("its front is empty").to_owned();
    for found in front {
        match taken(role, problem, found, source) {
            Ok(model) => {
                let model = model.found_on(Some(tool));
                let ranges = model.inputs().iter();
                let ranges = ranges.map(|i| (i.name.clone(), [i.range.low, i.range.high]));
                return Ok(FoundModel {
                    role,
                    name: role.label(),
                    formula: model.formula().to_string(),
                    size: found.size,
                    cuts: report.rows,
                    error: found.error,
                    left_out_error: found.loo_error,
                    first_choice: found.chosen,
                    ranges: ranges.collect(),
                    model,
                });
            }
            Err(problem) => why = problem,
        }
    }
    let (name, count) = (role.label(), report.front.len());
    Err(tr!(
        "{name}: none of the {count} formulas found can be used: {why}",
        name = name,
        count = count,
        why = why
    ))
}

fn taken(
    role: FoundRole,
    problem: &GpProblem,
    found: &FrontFormula,
    source: &str,
) -> Result<FormulaModel, String> {
    let text = &found.formula;
    let formula = Formula::parse(text, &problem.inputs).map_err(|error| error.to_string())?;
    let ranges: Vec<Interval> =
        problem.rows.ranges().iter().map(|[low, high]| Interval::new(*low, *high)).collect();
    let certificate = formula.certify(&ranges)?;
    let way = match certificate.trends.first() {
        Some(Trend::Rising) => Some(true),
        Some(Trend::Falling) => Some(false),
        Some(Trend::Constant | Trend::Turning | Trend::Uncertified(_)) | None => None,
    };
    if way != Some(role.rises()) {
        let input = &problem.inputs[0];
        return Err(match role.rises() {
            true => tr!(
                "`{formula}` is not certain to rise with {input} over its cuts",
                formula = text,
                input = input
            ),
            false => tr!(
                "`{formula}` is not certain to fall with {input} over its cuts",
                formula = text,
                input = input
            ),
        });
    }
    let unit = |column: &str| {
        by_name(column).ok_or_else(|| tr!("`{column}` has no unit", column = column))
    };
    let inputs = problem
        .inputs
        .iter()
        .zip(ranges)
        .map(|(name, range)| Ok(FormulaInput { name: name.clone(), unit: unit(name)?, range }))
        .collect::<Result<Vec<_>, String>>()?;
    let output = FormulaOutput { name: problem.target.clone(), unit: unit(&problem.target)? };
    let told = format!(
        "{source}; {} over {} cuts, rms {:.4e}",
        role.label(),
        problem.rows.len(),
        found.error
    );
    let model = FormulaModel::new(formula, inputs, output, told)?;
    Ok(banded(model, problem, &found.constants))
}

/// The models as settings of a scenario.
///
/// # Errors
/// A model has the units of another role.
pub fn settings(models: &[FoundModel]) -> Result<FormulaSettings, String> {
    let mut all = FormulaSettings::default();
    for found in models {
        let model = found.model.clone();
        match found.role {
            FoundRole::ForceOfRa => all.force_of_ra = OwnFormula::of(model)?,
            FoundRole::Feed => all.feed = OwnFormula::of(model)?,
            FoundRole::Speed => all.speed = OwnFormula::of(model)?,
            FoundRole::Force => all.force = OwnFormula::of(model)?,
            FoundRole::Ra => all.ra = OwnFormula::of(model)?,
        }
    }
    Ok(all)
}

/// Takes a model into a digest, to the bit.
pub fn take(digest: &mut Digest, found: &FoundModel) {
    found.formula.bytes().for_each(|byte| digest.word(u64::from(byte)));
    for (_, range) in &found.ranges {
        range.iter().for_each(|end| digest.word(end.to_bits()));
    }
}
