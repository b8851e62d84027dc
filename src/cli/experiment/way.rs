//! `steadycut experiment way`: from cuts to models to a controller that holds Ra.

use std::io::Write;
use std::process::ExitCode;

use super::super::{Outcome, progress};
use super::args::WayArgs;
use crate::run::edits::Edits;
use crate::run::job::Job;
use crate::run::scenario_file;
use crate::study::experiment::assess::MeasuringNoise;
use crate::study::experiment::way::job::WayJob;
use crate::study::experiment::way::report::{EntrantSummary, WayReport};
use crate::study::experiment::way::rows::RowOutcome;
use crate::study::experiment::way::{WayPlant, WaySettings};

pub fn execute(args: &WayArgs) -> Outcome {
    let settings = WaySettings {
        tool: args.tool,
        material: args.material,
        hardness_hb: args.hardness,
        plant: args.plant,
        axial_depth_mm: args.axial_depth,
        radial_depth_mm: args.radial_depth,
        cuts: args.cuts,
        noise: MeasuringNoise { force_n: args.noise, ra_um: args.ra_noise },
        seed: args.seed,
        batches: args.batches,
    };
    let mut job = WayJob::new(&settings).map_err(|problem| format!("--{problem}"))?;
    if let Some(path) = &args.resume {
        job.resume(&path.text()?).map_err(|problem| format!("{path}: {problem}"))?;
    }
    let worked = progress::work(&mut job, "way", args.json);
    if let Some(path) = &args.state {
        path.write(&job.state_text())?;
    }
    match (worked, &args.state) {
        (Err(error), Some(path)) => {
            return Err(error.kept(format!("go on with --resume {path}")).into());
        }
        (worked, _) => worked?,
    }
    let report = job.partial();
    let mut out = std::io::stdout().lock();
    if args.json {
        writeln!(out, "{}", serde_json::to_string_pretty(&report)?)?;
    } else {
        print(&mut out, &report)?;
    }
    if let Some(folder) = &args.out {
        let models: Vec<(String, String)> = job
            .models()
            .iter()
            .map(|found| (format!("{}.toml", found.role.id()), found.model.write()))
            .collect();
        let cuts = job.table().unwrap_or_default();
        let scenario = scenario_file::write(&job.example()?, &Edits::none());
        let mut files = vec![("cuts.csv", cuts.as_str()), ("scenario.toml", scenario.as_str())];
        files.extend(models.iter().map(|(name, text)| (name.as_str(), text.as_str())));
        folder.write(&files)?;
        if !args.json {
            let names: Vec<&str> = files.iter().map(|(name, _)| *name).collect();
            writeln!(out, "written into {folder}: {}", names.join(", "))?;
        }
    }
    Ok(ExitCode::SUCCESS)
}

fn percent(value: Option<f64>) -> String {
    value.map_or_else(|| "no Ra".to_owned(), |value| format!("{value:+.1} %"))
}

fn cell(outcome: &RowOutcome) -> String {
    let mark = match (outcome.swings(), outcome.within) {
        (true, _) => "~",
        (false, Some(false)) => "*",
        (false, Some(true) | None) => " ",
    };
    format!("{:>12}{mark}", percent(outcome.ra_deviation_percent))
}

fn print(out: &mut impl Write, report: &WayReport) -> std::io::Result<()> {
    let WayReport { settings, truth, .. } = report;
    writeln!(out, "{} in {}", settings.tool.label(), settings.material.label())?;
    writeln!(out, "truth: {truth}")?;
    let [axial, radial] = report.depths_mm;
    writeln!(out, "depths: axial {axial} mm, radial {radial} mm")?;
    if let Some(pilot) = report.pilot {
        writeln!(
            out,
            "found by {} pilot cuts: feeds, and the axial depth unless given",
            pilot.cuts
        )?;
    }
    if let Some([[low, high], [slow, fast]]) = report.cut_box {
        writeln!(
            out,
            "cuts: {} over feeds {low} to {high} mm/min and speeds {slow} to {fast} 1/min; a third on the line from \
             ({low}, {fast}) to ({high}, {slow})",
            report.measured
        )?;
    }
    let noise = settings.noise;
    writeln!(
        out,
        "measuring noise: {} N, {} um; seed {}",
        noise.force_n, noise.ra_um, settings.seed
    )?;
    for (run, problem) in &report.unmeasured {
        writeln!(out, "  run {run}: {problem}")?;
    }
    writeln!(out, "\nmodels by genetic programming; each holds on the ranges beside it:")?;
    for found in &report.models {
        let next = if found.first_choice {
            ""
        } else {
            " (next of its front: the chosen one is not certain to go one way)"
        };
        writeln!(out, "  {:<8} {} = {}{next}", found.name, found.role.target(), found.formula)?;
        let ranges: Vec<String> = found
            .ranges
            .iter()
            .map(|(name, [low, high])| format!("{name} {low:.4} to {high:.4}"))
            .collect();
        writeln!(
            out,
            "           rms {:.3e}, left out {:.3e}, {} cuts; {}",
            found.error,
            found.left_out_error.unwrap_or(f64::NAN),
            found.cuts,
            ranges.join(", ")
        )?;
    }
    writeln!(out, "\nRa after 15 s against its target:")?;
    writeln!(
        out,
        "  {:>3} {:>7}{:>12}{:>13}{:>13}{:>13}{:>13}",
        "sim", "um", "2007, print", "SDNRP papers", "SDNRP found", "Track papers", "Track found"
    )?;
    for row in &report.rows {
        let cells: String = row.outcomes.iter().map(cell).collect();
        let printed = match report.plant {
            WayPlant::Formula => percent(Some(row.printed_deviation_percent)),
            WayPlant::Mechanistic => "-".to_owned(),
        };
        writeln!(out, "  {:>3} {:>7}{printed:>12}{cells}", row.sim, row.ra_target_um)?;
    }
    writeln!(
        out,
        "* outside the ranges that the models were found on; ~ the force still swings: no more than a mean\n"
    )?;
    report.summary.iter().try_for_each(|one| summary(out, one))?;
    writeln!(out, "\ndigest {}", report.digest)
}

fn summary(out: &mut impl Write, one: &EntrantSummary) -> std::io::Result<()> {
    let held = match (one.worst_percent, one.rms_percent) {
        (Some(worst), Some(rms)) => format!("Ra off by {worst:.1} % at most, {rms:.1} % rms"),
        _ => format!(
            "{} rows without a Ra: the force lies below what the plant's K5 knows",
            one.without_ra
        ),
    };
    let rows = |count: usize, what: &str| match count {
        0 => String::new(),
        count => format!("; {count} rows {what}"),
    };
    let outside = rows(one.swinging, "in which the loop swings")
        + rows(one.outside, "outside the ranges of the models").as_str();
    writeln!(out, "{:<9}{:<19} {held}{outside}", one.controller, one.models.label())
}
