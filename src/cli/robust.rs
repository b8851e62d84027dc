//! `steadycut robust`: many runs with plant and belief drawn at random.

use std::io::Write;
use std::process::ExitCode;

use indicatif::ProgressBar;
use serde_json::json;

use super::Outcome;
use super::args::RobustArgs;
use super::run::{apply, load};
use super::train::bar;
use crate::base::settings::SettingError;
use crate::run::edits::Edits;
use crate::run::one_run::Run;
use crate::study::robust::{self, DRAWN, LIMIT_KN, Percentiles, RobustFindings, Robustness};

/// Runs the command.
pub fn execute(args: &RobustArgs) -> Outcome {
    let (mut scenario, _) = load(&args.scenario)?;
    apply(&mut scenario, &args.set)?;
    let kind = args.controller.unwrap_or(scenario.controller.kind);
    let mut study = Robustness::new(&scenario, kind, args.runs, args.seed);
    let progress = bar(study.runs() as u64, "runs");
    let outcomes = all(&study, &progress)?;
    study.take(outcomes);
    progress.finish_and_clear();
    let findings = study.findings();
    let mut out = std::io::stdout().lock();
    if args.json {
        let report = json!({
            "scenario": scenario.info.name, "controller": kind.id(), "seed": args.seed,
            "drawn": DRAWN, "believed_dead_time_s": scenario.belief.dead_time_s,
            "limit_kn": LIMIT_KN, "findings": findings, "outcomes": study.outcomes(),
        });
        writeln!(out, "{}", serde_json::to_string_pretty(&report)?)?;
    } else {
        writeln!(
            out,
            "{} with {}: {} runs; drawn at random, unknown to the controller:",
            scenario.info.name,
            kind.label(),
            findings.runs
        )?;
        for drawn in DRAWN {
            let [low, high] = drawn.range;
            let times = if drawn.relative { "its value times " } else { "" };
            writeln!(out, "  {:<28}{times}{low} to {high}", drawn.path)?;
        }
        writeln!(out, "  believed dead time {} s throughout\n", scenario.belief.dead_time_s)?;
        print(&mut out, &findings)?;
    }
    Ok(if findings.passed { ExitCode::SUCCESS } else { ExitCode::from(1) })
}

/// All runs, spread over the machine's cores: runs are independent, so how they are spread changes
/// nothing.
#[expect(clippy::disallowed_methods, reason = "threads come from the front end")]
fn all(
    study: &Robustness,
    progress: &ProgressBar,
) -> Result<Vec<robust::RobustOutcome>, SettingError> {
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let share = |first: usize| -> Result<Vec<(usize, robust::RobustOutcome)>, SettingError> {
        let mine = (first..study.runs()).step_by(threads);
        mine.map(|index| {
            let run = Run::complete(&study.scenario(index)?, &Edits::none());
            progress.inc(1);
            Ok((index, study.outcome(index, &run)))
        })
        .collect()
    };
    let mut found = std::thread::scope(|scope| {
        let workers: Vec<_> = (0..threads).map(|first| scope.spawn(move || share(first))).collect();
        let mut found = Vec::with_capacity(study.runs());
        for worker in workers {
            found.extend(worker.join().expect("a run does not panic")?);
        }
        Ok(found)
    })?;
    found.sort_by_key(|(index, _)| *index);
    Ok(found.into_iter().map(|(_, outcome)| outcome).collect())
}

fn print(out: &mut impl Write, findings: &RobustFindings) -> std::io::Result<()> {
    writeln!(out, "  {:<28}{:>9}{:>9}{:>9}", "", "median", "95 %", "largest")?;
    for (name, p, digits) in [
        ("largest force, kN", findings.max_force_kn, 3),
        ("Nsn", findings.normalized_standard_error, 4),
        ("time of cut, s", findings.time_of_cut_s, 2),
    ] {
        let Percentiles { p50, p95, largest } = p;
        writeln!(out, "  {name:<28}{p50:>9.digits$}{p95:>9.digits$}{largest:>9.digits$}")?;
    }
    writeln!(out, "  {:<28}{:>9}", "runs not finished", findings.unfinished)?;
    let verdict = if findings.passed { "passed" } else { "NOT passed" };
    writeln!(
        out,
        "\n{verdict}: 95th percentile of the largest force {:.3} kN, allowed {LIMIT_KN} kN; no run may \
         be stopped",
        findings.max_force_kn.p95
    )
}
