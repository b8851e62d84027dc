//! Models 1 to 5 of a paper by genetic programming, from its published table: the calibration `genetic`.
//!
//! ```text
//! 1  F(Ra)    2007: the ten (Ra desired, F desired) and the ten (Ra produced, F final)
//!             2013: the eight (Ra desired, F final)
//! 5  Ra(F)    2007: the same twenty points; 2013: the eight (F final, Ra produced)
//! 2  f(F_s)   F_s = F_d + Kp (F_d - F final), Kp = 0.5, F_d by model 1: what the proportional loop asks
//! 3  n(F_s)   for at the table's own final values
//! 4  F(f, n)  a + b n^3 + c ln(0.039 f)/f: only its constants, see [`FORCE_2007`]
//! ```
//!
//! Of the front of a search the formula is taken whose error at rows left out is the least among those that
//! interval arithmetic certifies to be finite and to rise, or to fall, as the model must over its whole range:
//! commands that turned round would turn the loop round.

use std::fmt::Write as _;

use super::Fit;
use super::gp::declared::declared_report;
use super::gp::job::{GpJob, GpSettings};
use super::gp::model::model;
use super::gp::problem::GpProblem;
use super::gp::report::{FrontFormula, GpReport};
use crate::base::formula::{Formula, Interval, Trend, Unit};
use crate::base::language::text;
use crate::blocks::control::sdnrp::KP_DEFAULT;
use crate::models::formula_model::FormulaModel;
use crate::models::genetic::found;
use crate::published::{PaperId, TableRow};
use crate::run::job::{Budget, Job, Progress};

/// Seed of all draws.
pub const SEED: u64 = 1;
/// Most batches of each search.
pub const SEARCH_BATCHES: u64 = 60;
/// Model 4 of 2007: the papers' form, all constants fitted. Final feed and speed of the table lie on one line
/// (correlation -0.995), so that no search can tell their effects apart.
pub const FORCE_2007: &str = "a - b*n^3 - c*ln(0.039*f)/f";
/// Model 4 of 2013: the same (correlation -0.937) with the speed's coefficient as printed, 265.11 2.0e-12; left
/// free, its sign turns.
pub const FORCE_2013: &str = "a - 5.3022e-10*n^3 - c*ln(0.039*f)/f";

/// What is searched for, in the order in which it is.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Role {
    ForceOfRa,
    Ra,
    Feed,
    Speed,
    Force,
}

const ROLES: [Role; 5] = [Role::ForceOfRa, Role::Ra, Role::Feed, Role::Speed, Role::Force];

impl Role {
    /// Names of the inputs and of the result, with their units.
    fn columns(self) -> &'static [(&'static str, &'static str)] {
        match self {
            Self::ForceOfRa => &[("Ra", "um"), ("F", "N")],
            Self::Ra => &[("F", "N"), ("Ra", "um")],
            Self::Feed => &[("F", "N"), ("f", "mm/min")],
            Self::Speed => &[("F", "N"), ("n", "1/min")],
            Self::Force => &[("f", "mm/min"), ("n", "1/min"), ("F", "N")],
        }
    }

    /// Whether the model falls with its input; otherwise it rises.
    fn falls(self) -> bool {
        self == Self::Speed
    }

    fn name(self, paper: PaperId) -> &'static str {
        match (self, paper) {
            (Self::ForceOfRa, PaperId::Sdnrp2007) => "K1",
            (Self::Ra, PaperId::Sdnrp2007) => "K5",
            (Self::Feed, PaperId::Sdnrp2007) => "K2",
            (Self::Speed, PaperId::Sdnrp2007) => "K3",
            (Self::Force, PaperId::Sdnrp2007) => "K4",
            (Self::ForceOfRa, PaperId::Strategy2013) => "M1",
            (Self::Ra, PaperId::Strategy2013) => "M5",
            (Self::Feed, PaperId::Strategy2013) => "M2",
            (Self::Speed, PaperId::Strategy2013) => "M3",
            (Self::Force, PaperId::Strategy2013) => "M4",
        }
    }

    fn meaning(self) -> &'static str {
        match self {
            Self::ForceOfRa => "force over Ra",
            Self::Ra => "Ra over force",
            Self::Feed => "final feed over F_s",
            Self::Speed => "final spindle speed over F_s",
            Self::Force => {
                "final force from final feed and speed, the papers' form with its constants fitted"
            }
        }
    }
}

/// A model that was found.
#[derive(Clone, Debug, PartialEq)]
pub struct FoundFormula {
    role: Role,
    /// The model.
    pub model: FormulaModel,
    /// Root mean square of its errors at rows left out.
    pub left_out: f64,
    /// Points (first input, result) and residuals.
    pub fit: Fit,
}

/// Models 1 to 5 of a paper.
#[derive(Clone, Debug, PartialEq)]
pub struct FoundFormulas {
    /// The paper.
    pub paper: PaperId,
    /// Those found so far, in the order of the search.
    pub models: Vec<FoundFormula>,
}

impl FoundFormulas {
    /// The file that is shipped as `assets/models/genetic_<year>.toml`; none before all are found.
    #[must_use]
    pub fn file(&self) -> Option<String> {
        let of = |role: Role| self.models.iter().find(|found| found.role == role);
        let model = |role: Role| of(role).map(|found| &found.model);
        let text = found::write([
            model(Role::ForceOfRa)?,
            model(Role::Feed)?,
            model(Role::Speed)?,
            model(Role::Force)?,
            model(Role::Ra)?,
        ]);
        let id = self.paper.id();
        let label = self.paper.label();
        Some(format!(
            "# Models 1 to 5 in the data of {label} by `steadycut identify genetic --paper {id}`.\n\n{text}"
        ))
    }
}

/// The search for all of them.
#[derive(Clone)]
pub struct GeneticJob {
    rows: Vec<TableRow>,
    found: FoundFormulas,
    search: Option<GpJob>,
    batches: u64,
    refusal: Option<String>,
}

impl GeneticJob {
    /// Begins it over rows of a paper's table.
    #[must_use]
    pub fn new(paper: PaperId, rows: &[TableRow]) -> Self {
        let found = FoundFormulas { paper, models: Vec::new() };
        let batches = SEARCH_BATCHES;
        Self { rows: rows.to_vec(), found, search: None, batches, refusal: None }
    }

    /// The same with other lengths of its searches.
    #[must_use]
    pub fn of_batches(self, batches: u64) -> Self {
        Self { batches, ..self }
    }

    /// The force setpoint of the loop at a row's final values.
    fn setpoint_n(&self, row: &TableRow) -> f64 {
        let of_ra = self.found.models.iter().find(|found| found.role == Role::ForceOfRa);
        let desired_n = of_ra.map_or(f64::NAN, |found| found.model.at(&[row.ra_desired_um]).value);
        desired_n + KP_DEFAULT * (desired_n - row.force_reference_n())
    }

    /// Inputs and result, row by row.
    fn points(&self, role: Role) -> Vec<Vec<f64>> {
        let rows = self.rows.iter();
        let of_2007 = self.found.paper == PaperId::Sdnrp2007;
        match role {
            Role::ForceOfRa | Role::Ra => {
                let desired = rows.clone().map(|row| [row.ra_desired_um, row.force_start_n]);
                let produced = rows.map(|row| {
                    let wanted = !of_2007 && role == Role::ForceOfRa;
                    let ra_um = if wanted { row.ra_desired_um } else { row.ra_produced_um };
                    [ra_um, row.force_reference_n()]
                });
                // The initial force of 2013 is not the desired one.
                let all = desired.filter(|_| of_2007).chain(produced);
                all.map(
                    |[ra, force]| {
                        if role == Role::Ra { vec![force, ra] } else { vec![ra, force] }
                    },
                )
                .collect()
            }
            Role::Feed => {
                rows.map(|row| vec![self.setpoint_n(row), row.feed_final_mm_min]).collect()
            }
            Role::Speed => {
                rows.map(|row| vec![self.setpoint_n(row), row.spindle_final_rpm]).collect()
            }
            Role::Force => rows
                .map(|row| {
                    vec![row.feed_final_mm_min, row.spindle_final_rpm, row.force_reference_n()]
                })
                .collect(),
        }
    }

    fn problem(&self, role: Role) -> Result<GpProblem, String> {
        let names: Vec<&str> = role.columns().iter().map(|(name, _)| *name).collect();
        let mut text = names.join(",");
        for row in self.points(role) {
            let cells: Vec<String> = row.iter().map(f64::to_string).collect();
            let _ = write!(text, "\n{}", cells.join(","));
        }
        let (inputs, target) = names.split_at(names.len() - 1);
        let inputs: Vec<String> = inputs.iter().map(|name| (*name).to_owned()).collect();
        GpProblem::read(&text, target[0], &inputs)
    }

    /// One look at a search; the model once it is over.
    fn searched(
        &mut self,
        role: Role,
        budget: &Budget<'_>,
    ) -> Result<Option<FoundFormula>, String> {
        let mut search = match self.search.take() {
            Some(search) => search,
            None => {
                let settings = GpSettings { seed: SEED, batches: self.batches, paper: None };
                GpJob::new(self.problem(role)?, &settings)?
            }
        };
        if !search.advance(budget) {
            self.search = Some(search);
            return Ok(None);
        }
        let (problem, report) = (search.problem(), search.report());
        let formula = monotone(problem, &report, role.falls())
            .ok_or_else(|| format!("no formula is certain to be monotone: {}", role.meaning()))?;
        let how = format!("{} batches", report.batches);
        self.found_model(role, problem, formula, &how).map(Some)
    }

    fn declared(&self) -> Result<FoundFormula, String> {
        let role = Role::Force;
        let text = match self.found.paper {
            PaperId::Sdnrp2007 => FORCE_2007,
            PaperId::Strategy2013 => FORCE_2013,
        };
        let problem = self.problem(role)?;
        let line = problem.collinear().map_or(String::new(), |line| {
            format!(", f and n on one line (correlation {:.3})", line.correlation)
        });
        let problem = problem.with_template(text)?;
        let template = problem.template.clone().ok_or("no template")?;
        let report = declared_report(&problem, &template, SEED)?;
        let formula = report.chosen().ok_or("the constants are not determined")?;
        self.found_model(role, &problem, formula, &format!("the papers' form{line}"))
    }

    fn found_model(
        &self,
        role: Role,
        problem: &GpProblem,
        formula: &FrontFormula,
        how: &str,
    ) -> Result<FoundFormula, String> {
        let unit = |(name, unit): &(&str, &str)| Ok(((*name).to_owned(), Unit::parse(unit)?));
        let units = role.columns().iter().map(unit).collect::<Result<Vec<_>, String>>()?;
        let left_out = formula.loo_error.unwrap_or(f64::INFINITY);
        let of = units.last().map(|(_, unit)| unit.to_string()).unwrap_or_default();
        let source = format!(
            "{} points of {}, seed {SEED}, {how}; rms error {:.3} {of}, at points left out {left_out:.3} {of}",
            problem.rows.len(),
            self.found.paper.label(),
            formula.error,
        );
        let model = model(problem, &formula.formula, &units, source)?;
        let points = self.points(role);
        let off = |point: &Vec<f64>| {
            let (inputs, result) = point.split_at(point.len() - 1);
            model.at(inputs).value - result[0]
        };
        let fit = Fit {
            model: role.name(self.found.paper),
            meaning: role.meaning(),
            residuals: points.iter().map(off).collect(),
            points: points.iter().map(|point| [point[0], point[point.len() - 1]]).collect(),
            unit: role.columns()[role.columns().len() - 1].1,
        };
        Ok(FoundFormula { role, model, left_out, fit })
    }
}

/// Of the front the formula with the least error at rows left out that is certain to be finite and monotone.
fn monotone<'a>(
    problem: &GpProblem,
    report: &'a GpReport,
    falls: bool,
) -> Option<&'a FrontFormula> {
    let ranges: Vec<Interval> =
        problem.rows.ranges().iter().map(|[low, high]| Interval::new(*low, *high)).collect();
    let certain = |front: &&FrontFormula| {
        let formula = Formula::parse(&front.formula, &problem.inputs).ok();
        let certificate = formula.and_then(|formula| formula.certify(&ranges).ok());
        let wanted = if falls { Trend::Falling } else { Trend::Rising };
        front.certified
            && front.loo_error.is_some_and(f64::is_finite)
            && certificate.is_some_and(|certificate| certificate.trends == [wanted])
    };
    let loo = |front: &&FrontFormula| front.loo_error.unwrap_or(f64::INFINITY);
    report.front.iter().filter(certain).min_by(|a, b| loo(a).total_cmp(&loo(b)))
}

/// A step is one of the searches'.
impl Job for GeneticJob {
    type Partial = FoundFormulas;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        while let Some(role) = ROLES.get(self.found.models.len()).copied() {
            if self.refusal.is_some() {
                return true;
            }
            let found = match role {
                Role::ForceOfRa | Role::Ra | Role::Feed | Role::Speed => {
                    self.searched(role, budget)
                }
                Role::Force if budget.step() => self.declared().map(Some),
                Role::Force => Ok(None),
            };
            match found {
                Ok(Some(found)) => self.found.models.push(found),
                Ok(None) => return false,
                Err(problem) => self.refusal = Some(problem),
            }
        }
        true
    }

    fn progress(&self) -> Progress {
        let whole = self.found.models.len() as f64;
        let under_way = self.search.as_ref().map_or(0.0, |search| search.progress().share());
        Progress { done: whole + under_way, total: ROLES.len() as f64, unit: text!("models") }
    }

    fn partial(&self) -> FoundFormulas {
        self.found.clone()
    }

    fn refusal(&self) -> Option<&str> {
        self.refusal.as_deref()
    }
}
