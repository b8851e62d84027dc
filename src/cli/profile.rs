//! `steadycut run --profile`: the machined surface of a run measured along a line.

use std::io::Write;
use std::process::ExitCode;

use serde::Serialize;

use super::{Outcome, progress};
use crate::blocks::cutting::tool_path::ToolPath;
use crate::run::edits::Edits;
use crate::run::one_run::Run;
use crate::run::scenario::Scenario;
use crate::run::tooth_marks::MarkedPart;
use crate::study::profilometer::{ProfileLine, measure};

/// The JSON object of a measurement.
#[derive(Serialize)]
struct Report<'a> {
    scenario: &'a str,
    cut: usize,
    from_mm: [f64; 2],
    to_mm: [f64; 2],
    short_um: f64,
    long_mm: f64,
    sampling_lengths: usize,
    ra_um: f64,
    rq_um: f64,
    rz_um: f64,
    run_ra_um: Option<f64>,
}

/// Runs a scenario to its end and measures cut number `cut`, or the last one reached.
pub fn execute(
    scenario: &Scenario,
    edits: &Edits,
    line: ProfileLine,
    cut: Option<usize>,
    json: bool,
) -> Outcome {
    let mut run = Run::new(scenario, edits);
    progress::work(&mut run, "run", json)?;
    let last_s = run.recording().rows().last().map_or(0.0, |row| row.time_s);
    let settings = edits.scenario_at(scenario, last_s)?;
    let mut marks = MarkedPart::new(scenario).disturbed(&settings.disturbances, run.breakages());
    marks.extend(run.recording().rows());
    let number = cut.unwrap_or(marks.cut() + 1);
    let reached = marks.cut() + 1;
    let index = number.checked_sub(1).filter(|index| *index < reached);
    let index = index.ok_or_else(|| format!("--cut {number}: allowed is 1 to {reached}"))?;
    let path = ToolPath::new(&settings.workpiece, settings.tool.outline())
        .disturbed(&settings.disturbances);
    let found = measure(&marks.cuts()[index].surface, path.of(index), &line, &settings.profile)
        .map_err(|error| format!("--profile: {error}"))?;
    let report = Report {
        scenario: &scenario.info.name,
        cut: number,
        from_mm: line.from_mm,
        to_mm: line.to_mm,
        short_um: settings.profile.short_um,
        long_mm: settings.profile.long_mm,
        sampling_lengths: found.lengths,
        ra_um: found.roughness.ra_um,
        rq_um: found.roughness.rq_um,
        rz_um: found.roughness.rz_um,
        run_ra_um: found.run_ra_um,
    };
    let mut out = std::io::stdout().lock();
    if json {
        writeln!(out, "{}", serde_json::to_string_pretty(&report)?)?;
        return Ok(ExitCode::SUCCESS);
    }
    let [x0, y0] = line.from_mm;
    let [x1, y1] = line.to_mm;
    writeln!(out, "{}, cut {number}: from ({x0}, {y0}) to ({x1}, {y1}) mm", report.scenario)?;
    let lengths = format!("{} of {} mm", report.sampling_lengths, report.long_mm);
    let run = match report.run_ra_um {
        None => "none: simulated tooth by tooth, K5 does not hold".to_owned(),
        Some(ra_um) => format!("{ra_um:.4} um"),
    };
    for (name, value) in [
        ("Ra", format!("{:.4} um", report.ra_um)),
        ("Rq", format!("{:.4} um", report.rq_um)),
        ("Rz", format!("{:.4} um", report.rz_um)),
        ("sampling lengths", lengths),
        ("short-wave cut-off", format!("{} um", report.short_um)),
        ("Ra of the run, mean", run),
    ] {
        writeln!(out, "  {name:<24}{value}")?;
    }
    Ok(ExitCode::SUCCESS)
}
