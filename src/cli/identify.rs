//! `steadycut identify`: fits the default models and writes the shipped model file.

use std::io::Write;
use std::process::ExitCode;

use serde_json::json;

use super::Outcome;
use super::args::{IdentifyArgs, IdentifyTarget, IdentifyWhat};
use super::files::report;
use crate::study::identify::{Identified, identify, identify_milling, model_file};
use crate::study::published::{PaperId, parse_table};

/// The models of a paper from its table, or another one.
fn from_table(args: &IdentifyArgs) -> Result<Identified, Box<dyn std::error::Error>> {
    let paper = PaperId::from(args.paper);
    let text = match &args.table {
        Some(path) => path.text()?,
        None => paper.text().to_owned(),
    };
    let source = args.table.as_ref().map_or(paper.label().to_owned(), ToString::to_string);
    let rows = parse_table(&text).map_err(|error| format!("{source}: {error}"))?;
    Ok(identify(paper, &rows).map_err(|error| format!("{source}: {error}"))?)
}

pub fn execute(args: &IdentifyArgs) -> Outcome {
    if let Some(IdentifyWhat::Gp(args)) = &args.what {
        return super::identify_gp::execute(args);
    }
    let mut out = report(args.json, args.out.as_ref())?;
    let identified = match args.target {
        Some(IdentifyTarget::Milling) => {
            if args.table.is_some() {
                return Err("`--table` is for `identify tables`: `milling` needs no table".into());
            }
            identify_milling(&args.tool.load().tool)?
        }
        Some(IdentifyTarget::Tables) | None => from_table(args)?,
    };
    let shipped = identified.models.set.identified_file();
    let file = model_file(&identified);
    if args.json {
        writeln!(out, "{}", serde_json::to_string_pretty(&to_json(&identified, &file, shipped))?)?;
    } else {
        print(&mut out, &identified)?;
        writeln!(out, "{file}")?;
    }
    match &args.out {
        Some(path) => {
            path.write(&file)?;
            if !args.json {
                writeln!(out, "model file written to {path}")?;
            }
        }
        None if !args.json => {
            let same = file == shipped;
            let word = if same { "equals" } else { "differs from" };
            writeln!(out, "this {word} the shipped model file")?;
        }
        None => {}
    }
    Ok(ExitCode::SUCCESS)
}

fn to_json(identified: &Identified, file: &str, shipped: &str) -> serde_json::Value {
    let fits: Vec<_> = identified
        .fits
        .iter()
        .map(|fit| {
            json!({
                "model": fit.model, "meaning": fit.meaning, "unit": fit.unit,
                "rms": fit.rms(), "worst": fit.worst(),
                "points": fit.points, "residuals": fit.residuals,
            })
        })
        .collect();
    json!({ "fits": fits, "model_file": file, "equals_shipped": file == shipped })
}

fn print(out: &mut impl Write, identified: &Identified) -> std::io::Result<()> {
    for fit in &identified.fits {
        writeln!(
            out,
            "{}: {}; rms {:.3} {unit}, worst {:.3} {unit}",
            fit.model,
            fit.meaning,
            fit.rms(),
            fit.worst(),
            unit = fit.unit
        )?;
        for ([x, y], residual) in fit.points.iter().zip(&fit.residuals) {
            writeln!(out, "  {x:>10.3}{y:>12.3}{residual:>+10.3}")?;
        }
    }
    writeln!(out)
}
