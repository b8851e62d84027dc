//! `steadycut afc`: teach-in and log of adaptive feed control.

pub mod args;

use std::io::Write;
use std::process::ExitCode;

use serde_json::json;

use self::args::{AfcArgs, AfcLogArgs, AfcTeachArgs, AfcWhat};
use super::files::report as report_to;
use super::scenarios::load;
use super::{Outcome, part, progress};
use crate::blocks::control::ControllerKind;
use crate::run::edits::Edits;
use crate::run::job::Job;
use crate::run::one_run::Run;
use crate::run::{constant_feed_twin, scenario_file};
use crate::study::afc::{AfcCut, Recorded, TeachIn, Teaching, log, sheet, sum, taught};

/// Runs the command.
pub fn execute(args: &AfcArgs) -> Outcome {
    match &args.what {
        AfcWhat::Teach(args) => teach(args),
        AfcWhat::Log(args) => tell(args),
    }
}

fn teach(args: &AfcTeachArgs) -> Outcome {
    let (mut scenario, edits) = load(&args.scenario)?;
    let edits = part::take_with(&mut scenario, edits, args.part.as_ref(), &[])?;
    let name = &scenario.info.name;
    let mut out = report_to(args.json, args.out.as_ref())?;
    let mut teach_in = TeachIn::new(&scenario);
    progress::work(&mut teach_in, "teach-in", args.json)?;
    let (references_n, whole) = match teach_in.partial() {
        Teaching::Taught { references_n, whole } => (references_n, whole),
        Teaching::NotTaught(why) => {
            return Err(format!("{name}: nothing is taught in: {why}").into());
        }
        Teaching::UnderWay => {
            return Err(format!("{name}: the teach-in has not come to its end").into());
        }
    };
    if args.json {
        let report = json!({
            "scenario": name, "references_n": references_n, "whole_part": whole,
            "changes_left_out": edits.list().len(),
        });
        writeln!(out, "{}", serde_json::to_string_pretty(&report)?)?;
    } else {
        writeln!(out, "{name}: peak force of each cut at the programmed feed\n")?;
        for (cut, reference_n) in (1..).zip(&references_n) {
            writeln!(out, "  cut {cut:<4}{reference_n:>10.1} N")?;
        }
        if !whole {
            let limit_s = scenario.run.duration_s;
            writeln!(out, "\nthe time limit, {limit_s} s, came before the end of the part")?;
        }
        if !edits.list().is_empty() {
            writeln!(out, "\nchanges during the cut do not belong to the teach-in")?;
        }
    }
    if let Some(path) = &args.out {
        let scenario = taught(&scenario, &references_n)?;
        path.write(&scenario_file::write(&scenario, &edits))?;
        if !args.json {
            writeln!(out, "\nscenario under AFC written to {path}")?;
        }
    }
    Ok(ExitCode::SUCCESS)
}

fn tell(args: &AfcLogArgs) -> Outcome {
    let (mut scenario, edits) = load(&args.scenario)?;
    let edits = part::take_with(&mut scenario, edits, args.part.as_ref(), &[])?;
    let name = &scenario.info.name;
    let kind = scenario.controller.kind;
    if kind != ControllerKind::Afc {
        return Err(format!(
            "{name}: `controller.kind` is {}: a log is that of afc (`steadycut afc teach` writes such a \
             scenario)",
            kind.id()
        )
        .into());
    }
    let mut out = report_to(args.json, args.out.as_ref())?;
    let mut run = Run::new(&scenario, &edits);
    progress::work(&mut run, "AFC", args.json)?;
    let mut constant = Run::new(&constant_feed_twin::scenario(&scenario), &Edits::none());
    progress::work(&mut constant, "programmed feed", args.json)?;
    let cuts = log(&scenario, Recorded::all(&run), Recorded::all(&constant));
    let end = run.end().ok_or("the run has not come to its end")?;
    if args.json {
        let sum = sum(&cuts).map(|[teach_in_s, control_s, difference_percent]| {
            json!({
                "teach_in_s": teach_in_s, "control_s": control_s,
                "difference_percent": difference_percent,
            })
        });
        let mut report = serde_json::to_value(end)?;
        report["scenario"] = json!(name);
        report["cuts"] = json!(cuts);
        report["sum"] = json!(sum);
        writeln!(out, "{}", serde_json::to_string_pretty(&report)?)?;
    } else {
        writeln!(out, "{name}: {end}\n")?;
        print(&mut out, &cuts)?;
    }
    if let Some(path) = &args.out {
        path.write(&sheet(&cuts).csv())?;
        if !args.json {
            writeln!(out, "\nlog written to {path}")?;
        }
    }
    Ok(ExitCode::SUCCESS)
}

fn print(out: &mut impl Write, cuts: &[AfcCut]) -> std::io::Result<()> {
    let cell = |value: Option<f64>, digits: usize| {
        value.map_or("-".to_owned(), |value| format!("{value:.digits$}"))
    };
    writeln!(
        out,
        "{:<5}{:>12}{:>12}{:>12}{:>14}{:>10}{:>14}  overload",
        "cut", "reference N", "teach-in s", "control s", "difference %", "peak N", "least feed %"
    )?;
    for cut in cuts {
        writeln!(
            out,
            "{:<5}{:>12}{:>12}{:>12}{:>14}{:>10}{:>14}  {}",
            cut.cut,
            cut.reference_n.map_or("taught in".to_owned(), |force_n| format!("{force_n:.1}")),
            cell(cut.teach_in_s, 2),
            cell(cut.control_s, 2),
            cut.difference_percent.map_or("-".to_owned(), |percent| format!("{percent:+.1}")),
            cell(cut.peak_n, 1),
            cell(cut.least_factor_percent, 1),
            if cut.overload { "yes" } else { "no" },
        )?;
    }
    if let Some([teach_in_s, control_s, percent]) = sum(cuts) {
        writeln!(
            out,
            "{:<5}{:>12}{teach_in_s:>12.2}{control_s:>12.2}{:>14}",
            "all",
            "",
            format!("{percent:+.1}")
        )?;
    }
    Ok(())
}
