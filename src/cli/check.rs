//! `steadycut check`: validates scenario files.

use std::io::Write;
use std::process::ExitCode;

use serde_json::json;

use super::Outcome;
use super::args::CheckArgs;
use crate::run::scenario_file;

pub fn execute(args: &CheckArgs) -> Outcome {
    let mut out = std::io::stdout().lock();
    let mut results = Vec::new();
    for path in &args.files {
        let result = path.read().and_then(|text| {
            scenario_file::parse(&text).map(drop).map_err(|error| error.to_string())
        });
        results.push((path.to_string(), result.err()));
    }
    if args.json {
        let list: Vec<_> = results
            .iter()
            .map(|(file, error)| json!({"file": file, "ok": error.is_none(), "error": error}))
            .collect();
        writeln!(out, "{}", serde_json::to_string_pretty(&list)?)?;
    } else {
        for (file, error) in &results {
            match error {
                None => writeln!(out, "{file}: ok")?,
                Some(error) => writeln!(out, "{file}: {error}")?,
            }
        }
    }
    let bad = results.iter().any(|(_, error)| error.is_some());
    Ok(if bad { ExitCode::from(1) } else { ExitCode::SUCCESS })
}
