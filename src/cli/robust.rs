//! `steadycut robust`: many runs with plant and belief drawn at random.

use std::io::Write;
use std::process::ExitCode;

use serde_json::json;

use super::args::RobustArgs;
use super::scenarios::{apply, load};
use super::{Outcome, given, own, part, progress, run};
use crate::study::robust::{DRAWN, LIMIT_KN, Percentiles, RobustFindings, Robustness};
use crate::study::uses::Reader;

/// Runs the command.
pub fn execute(args: &RobustArgs) -> Outcome {
    let (mut scenario, edits) = load(&args.scenario)?;
    given::no_edits(Reader::Robust, &scenario.info.name, &edits)?;
    let brought = own::take(&mut scenario, Some(&args.own_cut), Some(&args.own_machine), None)?;
    apply(&mut scenario, &args.set)?;
    part::take(&mut scenario, args.part.as_ref(), &args.set)?;
    if let Some(kind) = args.controller {
        given::once("--controller", &["controller.kind"], &args.set)?;
        scenario.change(|settings| settings.controller.kind = kind)?;
    }
    run::own_script(args.script.as_ref(), &args.set, &mut scenario)?;
    own::all_used(Reader::Robust, &scenario, &edits, &args.set, &brought)?;
    let kind = scenario.controller.kind;
    let mut study = Robustness::new(&scenario, kind, args.runs, args.seed);
    progress::work(&mut study, "robustness", args.json)?;
    let findings = study.findings();
    let mut out = std::io::stdout().lock();
    if args.json {
        let report = json!({
            "scenario": scenario.info.name, "controller": kind.id(), "seed": args.seed,
            "drawn": DRAWN, "believed_dead_time_s": scenario.belief.dead_time_s,
            "limit_kn": LIMIT_KN, "findings": findings, "script_fault": study.script_fault(),
            "outcomes": study.outcomes(),
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
        if let Some(fault) = study.script_fault() {
            writeln!(out, "the script failed in {} runs, first: {fault}", findings.script_failed)?;
        }
    }
    Ok(if findings.passed { ExitCode::SUCCESS } else { ExitCode::from(1) })
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
