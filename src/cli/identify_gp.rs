//! `steadycut identify gp`: a formula of a table's columns.

use std::io::Write;
use std::process::ExitCode;

use super::args::{IdentifyGpArgs, UnitsArg};
use super::files::report as report_to;
use super::{Outcome, progress};
use crate::base::formula::{Formula, Unit};
use crate::run::job::Job;
use crate::study::identify::gp::constants::fitted;
use crate::study::identify::gp::declared::declared_report;
use crate::study::identify::gp::job::{GpJob, GpSettings};
use crate::study::identify::gp::model::fitted_model;
use crate::study::identify::gp::problem::GpProblem;
use crate::study::identify::gp::report::{FrontFormula, GpReport, ReportedConstant};
use crate::study::identify::gp::standing::{GpStage, GpStanding};
use crate::study::published::PaperId;

/// Most rows that do not fit which are printed.
const MOST_ROWS: usize = 10;

/// Units given as `COLUMN=UNIT`.
fn units(args: &IdentifyGpArgs) -> Result<Vec<(String, Unit)>, String> {
    let columns: Vec<&String> = args.inputs.iter().chain([&args.target]).collect();
    let one = |text: &String| {
        let (column, unit) = text
            .split_once('=')
            .ok_or_else(|| format!("--unit {text}: allowed is COLUMN=UNIT, as `feed=mm/min`"))?;
        if !columns.iter().any(|name| *name == column) {
            return Err(format!("--unit {text}: `{column}` is neither the target nor an input"));
        }
        let unit = Unit::parse(unit).map_err(|problem| format!("--unit {text}: {problem}"))?;
        Ok((column.to_owned(), unit))
    };
    args.unit.iter().map(one).collect()
}

/// What the user may give where the rows do not tell the effects of two inputs apart.
const DECLARE: &str = "give the structure, as --template 'a + b*n^3 + c*ln(0.039*f)/f': then its constants are \
                       fitted, with their intervals";

fn asked(args: &IdentifyGpArgs) -> Result<GpProblem, Box<dyn std::error::Error>> {
    let problem = GpProblem::read(&args.data.text()?, &args.target, &args.inputs)
        .map_err(|problem| format!("{}: {problem}", args.data))?;
    let given = units(args)?;
    let problem = match args.units {
        UnitsArg::Strict => problem.strict(&given)?,
        UnitsArg::Free => problem,
    };
    let problem = problem.told(&given);
    Ok(match &args.template {
        Some(text) => {
            problem.with_template(text).map_err(|problem| format!("--template: {problem}"))?
        }
        None => problem,
    })
}

fn begun(args: &IdentifyGpArgs, problem: GpProblem) -> Result<GpJob, Box<dyn std::error::Error>> {
    let paper = args.paper.map(PaperId::from);
    let settings = GpSettings { seed: args.seed, batches: args.batches, paper };
    if let Some(collinear) = problem.collinear().filter(|_| args.template.is_none()) {
        return Err(format!("{}: {collinear}; {DECLARE}", args.data).into());
    }
    let mut job =
        GpJob::new(problem, &settings).map_err(|problem| format!("{}: {problem}", args.data))?;
    if let Some(path) = &args.resume {
        job.resume(&path.text()?).map_err(|problem| format!("{path}: {problem}"))?;
    }
    Ok(job)
}

pub fn execute(args: &IdentifyGpArgs) -> Outcome {
    let mut out = report_to(args.json, args.out.as_ref())?;
    let problem = asked(args)?;
    let declared = problem.template.clone().filter(|template| template.free.is_none());
    let (report, problem) = match declared {
        Some(template) => {
            if args.resume.is_some() || args.state.is_some() || args.paper.is_some() {
                let unused =
                    "without T nothing is searched for: leave out --resume, --state, --paper";
                return Err(format!("--template: {unused}").into());
            }
            let report = declared_report(&problem, &template, args.seed)
                .map_err(|problem| format!("--template: {problem}"))?;
            (report, problem)
        }
        None => {
            let mut job = begun(args, problem)?;
            (searched(args, &mut job)?, job.into_problem())
        }
    };
    if let Some(path) = &args.out {
        let text = model_text(args, &problem, &report);
        path.write(&text.map_err(|problem| format!("{path}: {problem}"))?)?;
    }
    if args.json {
        writeln!(out, "{}", serde_json::to_string_pretty(&report)?)?;
    } else {
        print(&mut out, &report)?;
    }
    if let Some(path) = args.out.as_ref().filter(|_| !args.json) {
        writeln!(out, "model written to {path}")?;
    }
    Ok(if report.chosen().is_some() { ExitCode::SUCCESS } else { ExitCode::from(1) })
}

/// Most sizes of the front told on the way.
const MOST_SIZES: usize = 5;

/// Where a search stands: batches, formulas made, the least error against size.
fn on_the_way(standing: &GpStanding) -> String {
    let GpStanding { batches, most_batches, evaluations, front, .. } = standing;
    let stage = match standing.stage {
        GpStage::Search => "",
        GpStage::Paper => ", the paper's search",
        GpStage::LeftOut => ", rows left out",
        GpStage::Over => ", over",
    };
    // The best, and evenly down to the smallest.
    let skip = front.len().div_ceil(MOST_SIZES).max(1);
    let told: Vec<String> = (front.iter().rev().step_by(skip))
        .map(|formula| format!("{:.2e} with {}", formula.error, formula.size))
        .collect();
    let told = if told.is_empty() { "none yet".to_owned() } else { told.join(", ") };
    format!(
        "{batches} of {most_batches} batches{stage}, {evaluations} formulas, error {told} nodes"
    )
}

/// Searches to the end, and keeps the search where that is wished.
fn searched(
    args: &IdentifyGpArgs,
    job: &mut GpJob,
) -> Result<GpReport, Box<dyn std::error::Error>> {
    let worked =
        progress::work_telling(job, "search", args.json, |job| on_the_way(&job.standing()));
    if let Some(path) = &args.state {
        path.write(&job.state_text())?;
    }
    match (worked, &args.state) {
        (Ok(()), _) => Ok(job.partial()),
        (Err(error), Some(path)) => Err(error.kept(format!("go on with --resume {path}")).into()),
        (Err(error), None) => Err(error.into()),
    }
}

/// The model file of the formula chosen, or of that of another size.
fn model_text(
    args: &IdentifyGpArgs,
    problem: &GpProblem,
    report: &GpReport,
) -> Result<String, String> {
    let wanted = match args.size {
        None => report.chosen().ok_or("not written: no formula is chosen")?,
        Some(size) => {
            report.front.iter().find(|formula| formula.size == size).ok_or_else(|| {
                let sizes: Vec<String> =
                    report.front.iter().map(|formula| formula.size.to_string()).collect();
                format!(
                    "not written: --size {size}: the sizes of the front are {}",
                    sizes.join(", ")
                )
            })?
        }
    };
    let source = format!(
        "found by `steadycut identify gp` on {} rows of {}, seed {}, {} batches; rms error {:.4e}",
        report.rows, args.data, args.seed, report.batches, wanted.error
    );
    let mut formula =
        Formula::parse(&wanted.formula, &problem.inputs).map_err(|error| error.to_string())?;
    let mut constants = wanted.constants.clone();
    if report.searched_rows < report.rows && !wanted.chosen {
        let fit = fitted(&formula, &problem.rows)?;
        constants = fit.constants.iter().map(ReportedConstant::from).collect();
        formula = fit.formula;
    }
    let model = fitted_model(problem, &formula, &constants, &units(args)?, source);
    Ok(model.map_err(|problem| format!("not written: {problem}"))?.write())
}

fn print(out: &mut impl Write, report: &GpReport) -> std::io::Result<()> {
    let GpReport { target, rows, batches, evaluations, .. } = report;
    writeln!(out, "{target} over {rows} rows: {batches} batches, {evaluations} formulas")?;
    if report.searched_rows < report.rows {
        let GpReport { searched_rows, seed, .. } = report;
        writeln!(
            out,
            "searched and judged on {searched_rows} rows drawn with seed {seed}; the constants of the formula chosen are \
             fitted to all"
        )?;
    }
    writeln!(out, "\n  size       error   left out  formula")?;
    for formula in &report.front {
        let FrontFormula { size, error, .. } = formula;
        let mark = match (formula.chosen, formula.greyed || !formula.certified) {
            (true, _) => "*",
            (false, true) => "-",
            (false, false) => " ",
        };
        let loo = formula.loo_error.unwrap_or(f64::NAN);
        let text = &formula.formula;
        writeln!(out, "{mark} {size:>4} {error:>11.4e} {loo:>10.3e}  {text}")?;
    }
    let told = report.left_out.unwrap_or("nothing");
    writeln!(
        out,
        "* chosen; - unsure: twice the least error left out, or not certain to be finite"
    )?;
    writeln!(out, "left out: {told}")?;
    if let Some(paper) = &report.paper {
        writeln!(
            out,
            "\nas the paper of {} searched (population {}, at most {} generations, shares {:?}, {}, constants within \
             {}): {} of size {}, R2 {:.5} after {} generations, stop at {}{}",
            paper.paper,
            paper.population,
            paper.most_generations,
            paper.shares,
            paper.functions,
            paper.constants,
            paper.formula.as_deref().unwrap_or("no formula"),
            paper.size,
            paper.fitness,
            paper.generations,
            paper.stop,
            if paper.reached { "" } else { " not reached" }
        )?;
        writeln!(
            out,
            "the formula of the smaller error is that of the {} search",
            report.found_by
        )?;
    }
    if let Some(chosen) = report.chosen() {
        print_chosen(out, report, chosen)?;
    } else {
        writeln!(
            out,
            "\nno formula is certain to be finite on the ranges of the rows: none is chosen"
        )?;
    }
    writeln!(out, "\ndigest {}", report.digest)
}

fn print_chosen(
    out: &mut impl Write,
    report: &GpReport,
    chosen: &FrontFormula,
) -> std::io::Result<()> {
    writeln!(out, "\n{} = {}", report.target, chosen.formula)?;
    if chosen.exact {
        writeln!(out, "exact but for rounding")?;
    }
    for constant in &chosen.constants {
        let value = constant.value;
        match constant.interval {
            Some([low, high]) if constant.determined => {
                writeln!(out, "  {value:<24} 95 % interval {low:.6e} to {high:.6e}")?;
            }
            Some([low, high]) => writeln!(
                out,
                "  {value:<24} not determined: 95 % interval {low:.2e} to {high:.2e}"
            )?,
            None => writeln!(out, "  {value:<24} not determined by these rows")?,
        }
    }
    match report.band() {
        Some([least, most]) => writeln!(
            out,
            "  95 % band of the formula on the rows: within {least:.3e} to {most:.3e} on either side"
        )?,
        None => writeln!(out, "  95 % band of the formula: not determined by these rows")?,
    }
    for unit in chosen.units.iter().flatten() {
        writeln!(out, "  {unit}")?;
    }
    if let Some(ranges) = &report.ranges {
        writeln!(out, "\nrange of the rows; beyond it every value is an extrapolation:")?;
        let both = ranges.training.ranges.iter().zip(&ranges.training.slopes);
        for (input, ([low, high], slope)) in ranges.inputs.iter().zip(both) {
            writeln!(out, "  {input:<24} {low} to {high}: {slope}")?;
        }
        let wide = &ranges.widened;
        let told = if wide.finite { "certain to be finite" } else { "not certain to be finite" };
        writeln!(out, "  30 % wider on each side: {told}")?;
        for place in &wide.not_finite {
            writeln!(out, "    {:?}: {}", place.at, place.why)?;
        }
    }
    let more = report.outliers.len().saturating_sub(MOST_ROWS);
    for row in report.outliers.iter().take(MOST_ROWS) {
        writeln!(
            out,
            "row {} does not fit: {} = {}, studentised residual {:.1}; it was used all the same",
            row.row, report.target, row.target, row.studentised
        )?;
    }
    if more > 0 {
        writeln!(out, "{more} more rows with studentised residuals above 3: --json lists them")?;
    }
    Ok(())
}
