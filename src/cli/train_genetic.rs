//! `steadycut train genetic`: the formula of the 2013 paper's comparison, by genetic programming.

use std::io::Write;
use std::process::ExitCode;

use serde_json::json;

use super::args::TrainGeneticArgs;
use super::files::report;
use super::{Outcome, progress};
use crate::models::formula_model::FormulaModel;
use crate::run::job::Job;
use crate::study::train::data::NOTE;
use crate::study::train::genetic::{GeneticForceJob, SHIPPED};

pub fn execute(args: &TrainGeneticArgs) -> Outcome {
    let mut out = report(args.json, args.out.as_ref())?;
    let mut job = GeneticForceJob::default();
    progress::work(&mut job, "formula", args.json)?;
    let file = job.partial().file.ok_or("the search has found no formula")?;
    let same = file == SHIPPED;
    if let Some(path) = &args.out {
        path.write(&file)?;
    }
    if args.json {
        let formula = FormulaModel::parse(&file)?.formula().to_string();
        let object = json!({ "data": NOTE, "formula": formula, "equals_shipped": same });
        writeln!(out, "{}", serde_json::to_string_pretty(&object)?)?;
    } else {
        writeln!(out, "{NOTE}\n\n{file}")?;
        match &args.out {
            Some(path) => writeln!(out, "model file written to {path}")?,
            None => {
                let word = if same { "equals" } else { "DIFFERS FROM" };
                writeln!(out, "this {word} the shipped model file")?;
            }
        }
    }
    Ok(if args.check && !same { ExitCode::FAILURE } else { ExitCode::SUCCESS })
}
