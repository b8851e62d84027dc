//! `steadycut combine`: the five steps of the combined system of 2005, each with its result.

use std::io::Write;
use std::process::ExitCode;

use serde::Serialize;
use serde_json::json;

use super::args::CombineArgs;
use super::files::report;
use super::recommend::{print as print_recommended, read_table, table_id};
use super::run::Ended;
use super::scenarios::{apply, load};
use super::{Outcome, given, own, part, progress};
use crate::run::edits::Edits;
use crate::run::metrics::Metrics;
use crate::run::scenario_file;
use crate::study::combined::{Adjusted, Combined, Planned, Recommended, STEPS};
use crate::study::plan::optimum::Optimum;
use crate::study::plan::remarks::remarks;
use crate::study::recommend::{Advisor, EngagementCode, NOTE};
use crate::study::uses::Reader;

/// The JSON object of the run.
#[derive(Serialize)]
struct RunReport<'a> {
    #[serde(flatten)]
    end: Option<Ended<'a>>,
    metrics: Metrics,
    ticks: u64,
    digest: String,
}

pub fn execute(args: &CombineArgs) -> Outcome {
    let mut out = report(args.json, args.out.as_ref())?;
    let (mut scenario, edits) = load(&args.scenario)?;
    given::no_edits(Reader::Combine, &scenario.info.name, &edits)?;
    let mut brought = own::Brought::new();
    let machine = own::planned_machine(&mut scenario, args.machine.as_ref(), &mut brought)?;
    apply(&mut scenario, &args.set)?;
    part::take(&mut scenario, args.part.as_ref(), &args.set)?;
    own::all_used(Reader::Combine, &scenario, &edits, &args.set, &brought)?;
    let (table, source) = read_table(args.table.as_ref())?;
    let mut combined = Combined::new(&scenario, &Advisor::new(&table), &machine, args.section)?;
    progress::work(&mut combined, "combined system", args.json)?;
    if args.json {
        writeln!(
            out,
            "{}",
            serde_json::to_string_pretty(&to_json(
                &combined,
                &table_id(args.table.as_ref()),
                &source
            ))?
        )?;
    } else {
        print(&mut out, &combined, &source)?;
    }
    if let Some(path) = &args.out {
        if combined.run().is_none() {
            return Err(format!("{path}: not written: the plan is not feasible").into());
        }
        let text = scenario_file::write(combined.scenario(), &Edits::none());
        path.write(&text)?;
        if !args.json {
            writeln!(out, "scenario with these programmed values written to {path}")?;
        }
    }
    Ok(if combined.run().is_some() { ExitCode::SUCCESS } else { ExitCode::from(1) })
}

fn to_json(combined: &Combined, table: &str, source: &str) -> serde_json::Value {
    let run = combined.run().map(|run| RunReport {
        end: run.end().map(Ended::new),
        metrics: run.metrics(),
        ticks: run.ticks(),
        digest: run.recording().digest(),
    });
    json!({
        "scenario": combined.scenario().info.name,
        "table": table,
        "table_text": source,
        "note": NOTE,
        "steps": STEPS,
        "recommended": combined.recommended(),
        "planned": combined.planned(),
        "adjusted": combined.adjusted(),
        "run": run,
        "remarks": remarks(combined.scenario()),
    })
}

fn print(out: &mut impl Write, combined: &Combined, source: &str) -> std::io::Result<()> {
    let scenario = combined.scenario();
    writeln!(out, "{}: the combined system of 2005, step by step", scenario.info.name)?;
    writeln!(out, "\n1  {}", STEPS[0])?;
    recommended(out, combined.recommended(), source)?;
    writeln!(out, "\n2  {}", STEPS[1])?;
    planned(out, combined.planned())?;
    let Some(run) = combined.run() else {
        return writeln!(out, "\nNothing is cut: no feed and speed keep all constraints.");
    };
    if let Some(adjusted) = combined.adjusted() {
        loop_steps(out, &adjusted)?;
    }
    let m = run.metrics();
    let error = |error: Option<f64>| error.map_or("no contact".to_owned(), |x| format!("{x:.4}"));
    writeln!(out, "\nthe run (seed {})", scenario.run.seed)?;
    for (name, value) in [
        ("normalised std. error", error(m.normalized_standard_error)),
        ("  over 20 samples", error(m.normalized_standard_error_20)),
        ("time of cut", format!("{:.2} s", m.time_of_cut_s)),
        ("largest force", format!("{:.1} N", m.max_force_n)),
        ("metal removed", format!("{:.3} cm3", m.metal_removed_cm3)),
        ("end", run.end().map_or(String::new(), ToString::to_string)),
    ] {
        writeln!(out, "  {name:<24}{value}")?;
    }
    writeln!(out)?;
    remarks(scenario).iter().try_for_each(|remark| writeln!(out, "{}.", remark.text))
}

fn recommended(out: &mut impl Write, found: &Recommended, source: &str) -> std::io::Result<()> {
    let asked = &found.recommendation;
    let engagement = EngagementCode::from_id(asked.engagement).map_or("", EngagementCode::label);
    let [axial, radial] = found.depths_mm;
    writeln!(
        out,
        "  for {} HB, {} mm, {engagement} (A_D {axial:.2}, R_D {radial:.2} mm)",
        asked.hardness_hb, asked.diameter_mm
    )?;
    print_recommended(out, asked)?;
    let broken = violated(&found.checked);
    let verdict = match broken.is_empty() {
        true => "keeps all seven constraints".to_owned(),
        false => format!("violates: {}", broken.join(", ")),
    };
    writeln!(out, "  {:<24}{verdict}", "as it is")?;
    writeln!(out, "  {NOTE}\n  The table: {source}.")
}

fn violated(optimum: &Optimum) -> Vec<&'static str> {
    let broken = optimum.constraints.iter().filter(|one| one.violation > 0.0);
    broken.map(|one| one.constraint.label).collect()
}

fn planned(out: &mut impl Write, plan: &Planned) -> std::io::Result<()> {
    let o = &plan.optimum;
    let [speed, feed] = plan.at_most;
    writeln!(
        out,
        "  for the {} section, at most {speed:.1} m/min and {feed:.4} mm: {} after {} iterations",
        plan.section,
        o.verdict_text(),
        plan.iterations
    )?;
    for (name, value) in [
        ("cutting speed", format!("{:.2} m/min", o.cutting_speed_m_min)),
        ("feed per tooth", format!("{:.4} mm", o.feed_per_tooth_mm)),
        ("programmed speed", format!("{:.1} 1/min", o.speed_rpm)),
        ("programmed feed", format!("{:.2} mm/min", o.feed_mm_min)),
        (
            "force",
            format!(
                "{:.1} N; in the heaviest section without control {:.1} N",
                o.force_n, plan.heaviest_force_n
            ),
        ),
    ] {
        writeln!(out, "  {name:<24}{value}")?;
    }
    Ok(())
}

fn loop_steps(out: &mut impl Write, adjusted: &Adjusted) -> std::io::Result<()> {
    let [low, mean, high] = adjusted.override_percent;
    writeln!(out, "\n3  {}", STEPS[2])?;
    writeln!(
        out,
        "  {:<24}mean {:.1} N, largest {:.1} N; {:.1} % of periods within 10 % of the reference",
        "measured force",
        adjusted.measured_mean_n,
        adjusted.measured_max_n,
        adjusted.within_ten_percent
    )?;
    writeln!(out, "\n4  {}", STEPS[3])?;
    writeln!(out, "  {:<24}{low:.0} to {high:.0} %, mean {mean:.1} %", "feed override")?;
    writeln!(out, "\n5  {}", STEPS[4])?;
    writeln!(out, "  {:<24}{} control periods in contact", "repeated", adjusted.periods)
}
