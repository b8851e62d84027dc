//! `steadycut plan --per-cut`: the programmed feed of every cut.

use std::io::Write;
use std::process::ExitCode;

use serde_json::json;

use super::args::PlanArgs;
use super::files::report as report_to;
use super::{Outcome, progress};
use crate::models::plan::PlannedSection;
use crate::run::edits::Edits;
use crate::run::scenario::Scenario;
use crate::run::scenario_file;
use crate::study::plan::machine::MachineLimits;
use crate::study::plan::schedule::ScheduleJob;

/// Plans all cuts, prints their feeds and writes the scenario.
pub fn execute(
    args: &PlanArgs,
    scenario: &Scenario,
    edits: &Edits,
    machine: &MachineLimits,
    sized_by: PlannedSection,
) -> Outcome {
    let mut out = report_to(args.json, args.out.as_ref())?;
    let mut job = ScheduleJob::on(scenario, machine, sized_by)?;
    progress::work(&mut job, "plans of the cuts", args.json)?;
    let feasible = job.planned().iter().all(|cut| cut.optimum.feasible);
    if args.json {
        let report = json!({
            "scenario": scenario.info.name, "sized_by": sized_by.id(), "feasible": feasible,
            "cut_feeds_mm_min": job.feeds_mm_min(), "cuts": job.planned(),
        });
        writeln!(out, "{}", serde_json::to_string_pretty(&report)?)?;
    } else {
        writeln!(
            out,
            "{}: feed of every cut for its {} section, spindle as programmed\n",
            scenario.info.name,
            sized_by.label()
        )?;
        for (i, cut) in job.planned().iter().enumerate() {
            let ([_, depth, wall], o) = (cut.section_mm, &cut.optimum);
            writeln!(
                out,
                "  cut {:<3} section {:<3} depth {depth} mm, wall {wall} mm: {:.2} mm/min, {:.4} mm \
                 per tooth, {:.0} N; {}",
                i + 1,
                cut.section + 1,
                o.feed_mm_min,
                o.feed_per_tooth_mm,
                o.force_n,
                o.verdict_text()
            )?;
        }
        writeln!(out, "\nprogram.cut_feeds_mm_min = {:?}", job.feeds_mm_min())?;
    }
    if let Some(path) = &args.out {
        if !feasible {
            return Err(format!("{path}: not written: a cut has no feasible feed").into());
        }
        let text = scenario_file::write(&job.apply(scenario)?, edits);
        path.write(&text)?;
        if !args.json {
            writeln!(out, "scenario with these feeds written to {path}")?;
        }
    }
    Ok(if feasible { ExitCode::SUCCESS } else { ExitCode::from(1) })
}
