//! `steadycut check`: validates scenario files, and says what of them a run leaves out.

use std::io::Write;
use std::process::ExitCode;

use serde_json::{Value, json};

use super::Outcome;
use super::args::CheckArgs;
use super::files::InPath;
use crate::base::settings::SettingError;
use crate::run::scenario::Settings;
use crate::run::scenario_file;
use crate::study::uses::Reader;

/// Why a file is no scenario.
enum Problem {
    Unreadable(String),
    Refused(SettingError),
}

/// A setting that differs from its default and has no part in the run, and why.
type Unused = (String, String);

impl std::fmt::Display for Problem {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Unreadable(problem) => f.write_str(problem),
            Self::Refused(refused) => refused.fmt(f),
        }
    }
}

impl From<SettingError> for Problem {
    fn from(refused: SettingError) -> Self {
        Self::Refused(refused)
    }
}

fn check(path: &InPath) -> Result<Vec<Unused>, Problem> {
    let text = path.read().map_err(|problem| Problem::Unreadable(problem.to_string()))?;
    let (scenario, edits) = scenario_file::parse(&text)?;
    let mut unused = Vec::new();
    for (param, _) in scenario.difference(&Settings::default()) {
        if let Some(because) = Reader::Run.unused_throughout(&scenario, &edits, &param.path)? {
            unused.push((param.path.clone(), because));
        }
    }
    Ok(unused)
}

pub fn execute(args: &CheckArgs) -> Outcome {
    let mut out = std::io::stdout().lock();
    let results: Vec<_> = args.files.iter().map(|path| (path.to_string(), check(path))).collect();
    if args.json {
        let list: Vec<_> = results.iter().map(|(file, result)| to_json(file, result)).collect();
        writeln!(out, "{}", serde_json::to_string_pretty(&list)?)?;
    } else {
        for (file, result) in &results {
            match result {
                Ok(unused) => {
                    writeln!(out, "{file}: ok")?;
                    for (path, because) in unused {
                        writeln!(out, "  `{path}` has no part in its run: {because}")?;
                    }
                }
                Err(problem) => writeln!(out, "{file}: {problem}")?,
            }
        }
    }
    let bad = results.iter().any(|(_, result)| result.is_err());
    Ok(if bad { ExitCode::from(1) } else { ExitCode::SUCCESS })
}

/// `error` is an id, what belongs to it stands in `error_details`, the words in `error_text`.
fn to_json(file: &str, result: &Result<Vec<Unused>, Problem>) -> Value {
    let text = result.as_ref().err().map(ToString::to_string);
    let (id, details) = match result {
        Ok(_) => (Value::Null, Value::Null),
        Err(Problem::Unreadable(_)) => ("unreadable".into(), Value::Null),
        Err(Problem::Refused(refused)) => {
            let mut details = json!(refused);
            let id = details.as_object_mut().and_then(|details| details.remove("error"));
            (id.unwrap_or_default(), details)
        }
    };
    let unused = result.as_deref().unwrap_or_default().iter();
    let unused: Vec<_> =
        unused.map(|(path, because)| json!({ "path": path, "because": because })).collect();
    json!({
        "file": file, "ok": result.is_ok(), "error": id, "error_details": details,
        "error_text": text, "unused": unused,
    })
}
