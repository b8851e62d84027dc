//! `steadycut train`: trains the neural force model, checks the shipped networks, repeats the
//! paper's comparison of 40 networks.

use std::io::Write;
use std::process::ExitCode;

use serde_json::json;

use super::args::{TrainArgs, TrainForceArgs, TrainWhat};
use super::files::report as report_to;
use super::{Outcome, progress};
use crate::models::neural_force::INPUTS;
use crate::study::train::TrainingSession;
use crate::study::train::comparison::{ComparisonJob, EPOCHS, LEVEL_PERCENT, Trial, recipes};
use crate::study::train::data::{FRESH_ROWS, NOTE, RowsJob, TrainingRow};
use crate::study::train::errors::TrainingErrors;
use crate::study::train::findings::{TrainingFindings, findings};
use crate::study::train::recipe::{LN_INPUTS, RecipeKind, TrainingRecipe};
use crate::study::train::report::{Report, report};

pub fn execute(args: &TrainArgs) -> Outcome {
    match &args.what {
        Some(TrainWhat::Force(force)) if force.check => check(force.json),
        Some(TrainWhat::Force(force)) => train_force(force),
        Some(TrainWhat::Genetic(args)) => super::train_genetic::execute(args),
        Some(TrainWhat::Unks(args)) => super::train_unks::execute(args),
        None if args.study => study(args.json),
        None => Err("what to train? `train force`, or `train --study`".into()),
    }
}

fn rows(mut job: RowsJob, what: &str, quiet: bool) -> Result<Vec<TrainingRow>, progress::NotDone> {
    progress::work(&mut job, what, quiet)?;
    Ok(job.rows().to_vec())
}

fn trained(
    recipe: &TrainingRecipe,
    measured: &[TrainingRow],
    quiet: bool,
) -> Result<TrainingSession, Box<dyn std::error::Error>> {
    let mut session = TrainingSession::new(recipe, measured)?;
    progress::work(&mut session, "training", quiet)?;
    Ok(session)
}

fn recipe_of(args: &TrainForceArgs) -> TrainingRecipe {
    let mut recipe = args.recipe.recipe();
    if let Some(activation) = args.activation.filter(|chosen| *chosen != recipe.activation) {
        recipe.activation = activation;
        recipe.target = activation.target_range();
    }
    if args.ln || args.no_ln {
        recipe.ln_inputs = if args.ln { LN_INPUTS } else { [false; 8] };
    }
    recipe.hidden = args.hidden.clone().unwrap_or(recipe.hidden);
    recipe.rows = args.rows.unwrap_or(recipe.rows);
    recipe.seed = args.seed.unwrap_or(recipe.seed);
    recipe.epochs = args.epochs.unwrap_or(recipe.epochs);
    recipe.learning.rate = args.rate.unwrap_or(recipe.learning.rate);
    recipe.learning.momentum = args.momentum.unwrap_or(recipe.learning.momentum);
    recipe.learning.decay = args.decay.unwrap_or(recipe.learning.decay);
    recipe
}

fn train_force(args: &TrainForceArgs) -> Outcome {
    let mut out = report_to(args.json, args.out.as_ref())?;
    let recipe = recipe_of(args);
    let measured = rows(RowsJob::measured(recipe.rows, recipe.seed), "rows", args.json)?;
    let session = trained(&recipe, &measured, args.json)?;
    let fresh = rows(RowsJob::fresh(FRESH_ROWS, recipe.seed), "fresh rows", args.json)?;
    let report = report(&session, &measured, &fresh)?;
    if let Some(path) = &args.out {
        path.write(&report.file)?;
    }
    let shipped = args.recipe.shipped().map(|kind| kind.file() == report.file);
    if args.json {
        let object = json!({ "report": report, "equals_shipped": shipped });
        writeln!(out, "{}", serde_json::to_string_pretty(&object)?)?;
        return Ok(ExitCode::SUCCESS);
    }
    print(&mut out, &report)?;
    match shipped {
        Some(true) => writeln!(out, "\nthis equals the shipped network file bit for bit")?,
        Some(false) => writeln!(out, "\nthis differs from the shipped network file")?,
        None => {}
    }
    if let Some(path) = &args.out {
        writeln!(out, "network file written to {path}")?;
    }
    Ok(ExitCode::SUCCESS)
}

fn print(out: &mut impl Write, report: &Report) -> std::io::Result<()> {
    let sizes: Vec<String> = report.sizes.iter().map(usize::to_string).collect();
    let logarithms: Vec<&str> =
        INPUTS.iter().zip(report.ln_inputs).filter(|(_, ln)| *ln).map(|(name, _)| *name).collect();
    let logarithms = if logarithms.is_empty() { "none".to_owned() } else { logarithms.join(", ") };
    let [rate, momentum, decay] = report.learning;
    writeln!(out, "{}\n", report.data)?;
    writeln!(out, "network      {}, {}", sizes.join("-"), report.activation)?;
    writeln!(out, "logarithms   {logarithms}")?;
    writeln!(
        out,
        "learning     rate {rate}, momentum {momentum}, decay {decay}, {} epochs, seed {}",
        report.epochs, report.seed
    )?;
    writeln!(
        out,
        "rows         {} trained on, {} held out, {} fresh\n",
        report.training.rows, report.hold_out.rows, report.fresh.rows
    )?;
    writeln!(
        out,
        "{:<42}{:>7}{:>8}{:>9}{:>7}   RMSE % of range",
        "error of F_xy in %", "mean", "median", "> 200 N", "95 %"
    )?;
    line(out, "network, rows trained on (noisy)", &report.training)?;
    line(out, "network, rows held out (noisy)", &report.hold_out)?;
    line(out, "network, fresh rows", &report.fresh)?;
    for (i, formula) in report.formulas.iter().enumerate() {
        let best = if i == 0 { " (best)" } else { "" };
        line(out, &format!("formula{best}, fresh rows"), &formula.errors)?;
        writeln!(out, "    {}, {} coefficients", formula.form, formula.coefficients)?;
    }
    let [network, formula] = report.paper_claims_percent;
    writeln!(
        out,
        "\nthe 2013 paper claims {network} % for its network and {formula} % for its best formula, \
         on measurements"
    )
}

fn line(out: &mut impl Write, name: &str, errors: &TrainingErrors) -> std::io::Result<()> {
    write!(
        out,
        "{name:<42}{:>7.2}{:>8.2}{:>9.2}{:>7.2}",
        errors.mean_percent,
        errors.median_percent,
        errors.mean_above_200_n_percent,
        errors.p95_percent
    )?;
    match errors.rmse_percent_of_range {
        Some([x, y, z]) => writeln!(out, "   Fx {x:.2}  Fy {y:.2}  Fz {z:.2}"),
        None => writeln!(out),
    }
}

/// Trains the shipped networks again.
fn check(json: bool) -> Outcome {
    let mut out = std::io::stdout().lock();
    let mut results = serde_json::Map::new();
    let mut measured: Option<((u32, u32), Vec<TrainingRow>)> = None;
    for kind in RecipeKind::ALL {
        let Some(shipped) = kind.shipped() else { continue };
        let recipe = kind.recipe();
        let key = (recipe.rows, recipe.seed);
        let data = match measured.take() {
            Some((made, data)) if made == key => data,
            _ => rows(RowsJob::measured(recipe.rows, recipe.seed), "rows", json)?,
        };
        let same = trained(&recipe, &data, json)?.file() == shipped.file();
        results.insert(kind.id().to_owned(), same.into());
        if !json {
            let word = if same { "equals" } else { "DIFFERS FROM" };
            writeln!(out, "{}: {word} the shipped network file", kind.id())?;
        }
        measured = Some((key, data));
    }
    let all = results.values().all(|same| same == true);
    if json {
        writeln!(out, "{}", serde_json::to_string_pretty(&json!({ "equals_shipped": results }))?)?;
    }
    Ok(if all { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

fn study(json: bool) -> Outcome {
    let recipes = recipes();
    let first = &recipes[0];
    let measured = rows(RowsJob::measured(first.rows, first.seed), "rows", json)?;
    let mut comparison = ComparisonJob::new(recipes, &measured);
    progress::work(&mut comparison, "networks", json)?;
    let trials = comparison.trials();
    let findings = findings(trials).ok_or("the comparison has no networks")?;
    let mut out = std::io::stdout().lock();
    if json {
        let object = json!({
            "data": NOTE, "epochs": EPOCHS, "level_percent": LEVEL_PERCENT,
            "networks": trials, "findings": findings,
        });
        writeln!(out, "{}", serde_json::to_string_pretty(&object)?)?;
    } else {
        print_study(&mut out, trials, &findings)?;
    }
    Ok(ExitCode::SUCCESS)
}

fn print_study(
    out: &mut impl Write,
    trials: &[Trial],
    found: &TrainingFindings,
) -> std::io::Result<()> {
    writeln!(
        out,
        "{NOTE}\n{} networks 8-N-3, {EPOCHS} epochs each; error: mean of F_xy over the rows held \
         out;\ncycles, in brackets below: epochs until it first reached {LEVEL_PERCENT} %\n",
        trials.len()
    )?;
    writeln!(
        out,
        "{:<10}{:>11}{:>7}{:>10}{:>8}{:>6}{:>10}{:>9}",
        "activation", "targets", "rate", "momentum", "hidden", "seed", "error %", "cycles"
    )?;
    for trial in trials {
        let cycles = trial.epochs_to_level.map_or("never".to_owned(), |n| n.to_string());
        writeln!(
            out,
            "{:<10}{:>11}{:>7}{:>10}{:>8}{:>6}{:>10.2}{:>9}",
            trial.activation,
            format!("{}..{}", trial.target[0], trial.target[1]),
            trial.rate,
            trial.momentum,
            trial.hidden,
            trial.seed,
            trial.error_percent,
            cycles
        )?;
    }
    writeln!(
        out,
        "\nspread of the seeds: {:.2} percentage points; smaller differences mean nothing\n",
        found.seed_spread_percent
    )?;
    for (i, finding) in found.findings.iter().enumerate() {
        let (paper, verdict) = (finding.paper, finding.verdict.label());
        writeln!(out, "{}. paper: {paper}\n   found here: {verdict}", i + 1)?;
        for claim in &finding.claims {
            let word = if claim.found { "yes" } else { "no" };
            writeln!(out, "     {word:<4}{}", claim.statement)?;
        }
        writeln!(out, "   {}", finding.figures)?;
    }
    Ok(())
}
