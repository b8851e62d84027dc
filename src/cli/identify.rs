//! `steadycut identify`: fits the default models and writes the shipped model file.

use std::io::Write;
use std::process::ExitCode;

use serde_json::json;

use super::args::{IdentifyArgs, IdentifyTarget, IdentifyWhat};
use super::files::report;
use super::{Outcome, progress};
use crate::run::job::Job;
use crate::study::identify::genetic::GeneticJob;
use crate::study::identify::{Fit, Identified, identify, identify_milling, model_file};
use crate::study::published::{PaperId, TableRow, parse_table};

/// What was identified: its fits, its file, and the file that is shipped.
struct Made {
    fits: Vec<Fit>,
    file: String,
    shipped: &'static str,
}

impl From<Identified> for Made {
    fn from(identified: Identified) -> Self {
        let shipped = identified.models.set.identified_file();
        Self { file: model_file(&identified), fits: identified.fits, shipped }
    }
}

/// The rows of the paper's table, or of another one, and where they come from.
fn rows(args: &IdentifyArgs) -> Result<(Vec<TableRow>, String), Box<dyn std::error::Error>> {
    let paper = PaperId::from(args.paper);
    let text = match &args.table {
        Some(path) => path.text()?,
        None => paper.text().to_owned(),
    };
    let source = args.table.as_ref().map_or(paper.label().to_owned(), ToString::to_string);
    let rows = parse_table(&text).map_err(|error| format!("{source}: {error}"))?;
    Ok((rows, source))
}

/// The models of a paper from its table, or another one.
fn from_table(args: &IdentifyArgs) -> Result<Made, Box<dyn std::error::Error>> {
    let (rows, source) = rows(args)?;
    let found = identify(args.paper.into(), &rows);
    Ok(found.map_err(|error| format!("{source}: {error}"))?.into())
}

/// The same by genetic programming.
fn by_genetic_programming(args: &IdentifyArgs) -> Result<Made, Box<dyn std::error::Error>> {
    let (rows, source) = rows(args)?;
    let paper = PaperId::from(args.paper);
    let mut job = GeneticJob::new(paper, &rows);
    progress::work(&mut job, "models", args.json)?;
    let found = job.partial();
    let file = found.file().ok_or_else(|| format!("{source}: not all models were found"))?;
    let shipped = paper.model_set().found_file().unwrap_or_default();
    Ok(Made { fits: found.models.into_iter().map(|found| found.fit).collect(), file, shipped })
}

pub fn execute(args: &IdentifyArgs) -> Outcome {
    match &args.what {
        Some(IdentifyWhat::Gp(args)) => return super::identify_gp::execute(args),
        Some(IdentifyWhat::Drive(args)) => return super::identify_drive::execute(args),
        Some(IdentifyWhat::Force(args)) => return super::identify_force::execute(args),
        Some(IdentifyWhat::Wear(args)) => return super::identify_wear::execute(args),
        Some(IdentifyWhat::Noise(args)) => return super::identify_noise::execute(args),
        Some(IdentifyWhat::Material(args)) => return super::identify_material::execute(args),
        Some(IdentifyWhat::Structure(args)) => return super::identify_structure::execute(args),
        None => {}
    }
    let mut out = report(args.json, args.out.as_ref())?;
    let Made { fits, file, shipped } = match args.target {
        Some(IdentifyTarget::Milling) => {
            if args.table.is_some() {
                let taken =
                    "`--table` is for `identify tables` and `genetic`: `milling` needs no table";
                return Err(taken.into());
            }
            identify_milling(&args.tool.load().tool)?.into()
        }
        Some(IdentifyTarget::Genetic) => by_genetic_programming(args)?,
        Some(IdentifyTarget::Tables) | None => from_table(args)?,
    };
    if args.json {
        writeln!(out, "{}", serde_json::to_string_pretty(&to_json(&fits, &file, shipped))?)?;
    } else {
        print(&mut out, &fits)?;
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

fn to_json(fits: &[Fit], file: &str, shipped: &str) -> serde_json::Value {
    let fits: Vec<_> = fits
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

fn print(out: &mut impl Write, fits: &[Fit]) -> std::io::Result<()> {
    for fit in fits {
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
