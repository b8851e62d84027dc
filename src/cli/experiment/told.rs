//! A plan and what it tells, in words.

use std::io::{Result, Write};

use crate::run::scenario::{Scenario, param};
use crate::study::experiment::assess::{ExperimentAssessment, TermAssessment, TermVerdict};
use crate::study::experiment::fraction::{LETTERS, roman};
use crate::study::experiment::measure::MeasuredCut;
use crate::study::experiment::plan::ExperimentPlan;
use crate::study::experiment::sheet::TOLD_SETTINGS;

/// Most runs and most pairs that are printed.
const MOST_RUNS: usize = 40;
const MOST_PAIRS: usize = 6;

/// What is the same in all cuts: path, label and value with its unit.
pub fn fixed(scenario: &Scenario, plan: &ExperimentPlan) -> Vec<(&'static str, String, String)> {
    let varied = |path: &str| {
        plan.factors.iter().any(|factor| {
            let cutter = factor.cutters().is_some() && path.starts_with("tool.");
            factor.kind.path() == path || cutter
        })
    };
    let told = |path: &'static str| {
        let param = param(path).ok()?;
        let value = scenario.get(path).ok()?;
        let unit = param.spec.unit;
        let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
        Some((path, param.spec.label.to_owned(), format!("{value}{unit}")))
    };
    TOLD_SETTINGS.iter().copied().filter(|path| !varied(path)).filter_map(told).collect()
}

/// The factors, the design and its runs.
pub fn print_plan(
    out: &mut impl Write,
    plan: &ExperimentPlan,
    scenario: Option<&Scenario>,
    leverages: &[f64],
) -> Result<()> {
    writeln!(out, "{}: {} runs", plan.id, plan.runs.len())?;
    for (factor, letter) in plan.factors.iter().zip(LETTERS) {
        let name = factor.kind.id();
        let values = match factor.cutters() {
            Some(all) => all.iter().map(|tool| tool.id()).collect::<Vec<_>>().join(", "),
            None => {
                let [low, high] = factor.range();
                format!("{low} to {high} {}", factor.kind.unit())
            }
        };
        writeln!(out, "  {letter} {name:<14}{values}")?;
    }
    if let Some(scenario) = scenario {
        writeln!(out, "the same in all cuts:")?;
        for (_, label, value) in fixed(scenario, plan) {
            writeln!(out, "    {label:<18}{value}")?;
        }
    }
    if let Some(fraction) = &plan.fraction
        && let Some(resolution) = fraction.resolution()
    {
        let words: Vec<String> = fraction.defining().iter().map(ToString::to_string).collect();
        writeln!(out, "\nfraction: I = {}, resolution {}", words.join(" = "), roman(resolution))?;
        for set in fraction.aliases() {
            writeln!(out, "  not told apart: {set}")?;
        }
    }
    write!(out, "\n  order  run  role       ")?;
    for factor in &plan.factors {
        write!(out, "{:>15}", factor.kind.column())?;
    }
    writeln!(out, "  leverage")?;
    let runs = plan.in_order();
    for run in runs.iter().take(MOST_RUNS) {
        write!(out, "  {:>5} {:>4}  {:<11}", run.order, run.run, run.role.label())?;
        for (factor, value) in plan.factors.iter().zip(&run.values) {
            write!(out, "{:>15}", factor.text(*value))?;
        }
        let leverage = leverages.get(run.run - 1).copied().unwrap_or(f64::NAN);
        writeln!(out, "{leverage:>10.3}")?;
    }
    if runs.len() > MOST_RUNS {
        writeln!(out, "  {} more: --out and --json have all", runs.len() - MOST_RUNS)?;
    }
    Ok(())
}

fn shown(value: Option<f64>) -> String {
    value.map_or_else(|| "-".to_owned(), |value| format!("{value:.3e}"))
}

fn term(out: &mut impl Write, told: &TermAssessment) -> Result<()> {
    let inflation = told.inflation.map_or_else(|| "-".to_owned(), |x| format!("{x:.2}"));
    write!(
        out,
        "  {:<36}{:>12}{:>12}{inflation:>10}  {}",
        told.term,
        shown(told.standard_error_n),
        shown(told.standard_error_um),
        told.verdict.label()
    )?;
    match (&told.nearest, told.verdict) {
        (Some((other, r)), TermVerdict::Weak | TermVerdict::Hardly) => {
            writeln!(out, ": goes with {other}, correlation {r:.3}")
        }
        (Some(_), TermVerdict::Told | TermVerdict::Aliased) | (None, _) => writeln!(out),
    }
}

/// What the plan can tell of a declared model.
pub fn print_assessment(
    out: &mut impl Write,
    plan: &ExperimentPlan,
    told: &ExperimentAssessment,
) -> Result<()> {
    let noise = told.noise;
    writeln!(
        out,
        "\nwhat the runs tell, at a noise of {} N and {} um; constants of factors are for half their range",
        noise.force_n, noise.ra_um
    )?;
    writeln!(out, "  {:<36}{:>12}{:>12}{:>10}", "term", "error, N", "error, um", "inflation")?;
    told.terms.iter().try_for_each(|one| term(out, one))?;
    for alias in &told.aliases {
        writeln!(out, "  cannot be told apart: {alias}; only the sum of their constants can")?;
    }
    let hardly: Vec<&str> = told
        .terms
        .iter()
        .filter(|term| term.verdict == TermVerdict::Hardly)
        .map(|term| term.term.as_str())
        .collect();
    if !hardly.is_empty() {
        writeln!(
            out,
            "  these runs hardly tell {} apart: they lie on one line; cut off it",
            hardly.join(" and ")
        )?;
    }
    for (a, b, r) in told.correlated.iter().take(MOST_PAIRS) {
        writeln!(out, "  correlation {r:+.3}: {a} and {b}")?;
    }
    let more = told.correlated.len().saturating_sub(MOST_PAIRS);
    if more > 0 {
        writeln!(out, "  {more} more pairs from 0.3 on: --json has all")?;
    }
    writeln!(
        out,
        "  {} of {} terms told at once; condition {:.3e}; {} runs left to tell the noise by, {} of them repeated",
        told.rank,
        told.terms.len(),
        told.condition,
        told.freedom,
        told.repeated
    )?;
    let p = told.prediction;
    writeln!(
        out,
        "  a prediction is off by {:.3} N at the runs, {:.3} N in the middle, up to {:.3} N ({:.4} um) in the box",
        p.at_runs_n, p.middle_n, p.worst_n, p.worst_um
    )?;
    let most = told.leverages.iter().copied().fold(0.0, f64::max);
    let pulls: Vec<String> = plan
        .runs
        .iter()
        .zip(&told.leverages)
        .filter(|(_, leverage)| **leverage > most - 1e-9)
        .map(|(run, _)| run.run.to_string())
        .collect();
    let runs = match pulls.len() {
        count if count > 8 => format!("{count} runs"),
        1 => format!("run {}", pulls[0]),
        _ => format!("runs {}", pulls.join(", ")),
    };
    writeln!(out, "  largest leverage {most:.3}: {runs}")?;
    if told.freedom == 0 {
        writeln!(
            out,
            "  no run is left over: the noise cannot be told; replicate, or add centre points"
        )?;
    }
    Ok(())
}

/// What was measured, and what is missing.
pub fn print_measured(
    out: &mut impl Write,
    plan: &ExperimentPlan,
    measured: &[MeasuredCut],
) -> Result<()> {
    let whole = measured.iter().filter(|cut| cut.is_whole()).count();
    writeln!(out, "\n{whole} of {} cuts measured", plan.runs.len())?;
    for run in plan.in_order().into_iter().take(MOST_RUNS) {
        let Some(cut) = measured.get(run.run - 1) else { continue };
        let force = cut.force_n.map_or("-".to_owned(), |force| format!("{force:.2} N"));
        let ra = cut.ra_um.map_or("-".to_owned(), |ra| format!("{ra:.3} um"));
        let problem = cut.problem.as_deref().unwrap_or_default();
        writeln!(out, "  {:>5} {:>4}  {force:>12}{ra:>12}  {problem}", run.order, run.run)?;
    }
    let missing: Vec<String> = plan
        .in_order()
        .into_iter()
        .filter(|run| measured.get(run.run - 1).is_none_or(|cut| !cut.is_whole()))
        .map(|run| run.run.to_string())
        .collect();
    if !missing.is_empty() {
        writeln!(out, "not measured, or not whole: runs {}", missing.join(", "))?;
    }
    Ok(())
}
