//! The measured data of `steadycut identify ...`, and how values are told.

use std::io::Write;

use clap::Args;
use serde_json::{Map, Value, json};

use super::files::{InPath, OutPath};
use super::measured;
use super::measured::args::{layout_entry, span};
use crate::base::settings;
use crate::run::edits::Edits;
use crate::run::scenario::Scenario;
use crate::study::identify::EstimatedValue;
use crate::study::identify::fits::{FitFault, FitRequest, FitValue, WITHIN};

/// Which data.
#[derive(Debug, Args)]
pub struct DataArgs {
    /// The recording, in any layout that `steadycut measured` reads; its samples are even in time.
    #[arg(long, value_name = "FILE")]
    pub data: InPath,
    /// Overrule a guess about the file's layout, as for `steadycut measured`.
    #[arg(long, value_name = "KEY=VALUE", value_parser = layout_entry)]
    pub layout: Vec<(String, String)>,
    /// Take the samples between two times in s alone.
    #[arg(long, value_name = "FROM..TO", value_parser = span)]
    pub within: Option<[f64; 2]>,
}

impl DataArgs {
    /// What a fit is asked of these data, its channels yet without roles.
    pub fn request(&self, scenario: Scenario, edits: Edits) -> Result<FitRequest, String> {
        let channels = measured::data(&self.data, &self.layout)?.channels;
        let request = FitRequest {
            file: self.data.to_string(),
            channels,
            roles: Vec::new(),
            values: Vec::new(),
            scenario,
            edits,
        };
        Ok(request.with_value(&WITHIN, self.within.map(FitValue::Span)))
    }

    /// A fault as the command tells it.
    pub fn told(&self, fault: &FitFault) -> String {
        fault.of_file(&self.data.to_string())
    }
}

/// A value with its interval, and its unit.
pub fn told(x: EstimatedValue, digits: usize, unit: &str) -> String {
    let half =
        x.half.map_or("+- ? (not determined)".to_owned(), |half| format!("+- {half:.digits$}"));
    format!("{:.digits$} {half} {unit}", x.value).trim_end().to_owned()
}

/// The same for machines.
pub fn value_json(x: EstimatedValue) -> Value {
    json!({ "value": x.value, "half_95": x.half })
}

/// Settings by their paths.
pub type Settings = [(String, settings::Value)];

/// Settings for machines, as `--set` takes them.
pub fn settings_json(settings: &Settings) -> Value {
    let entries = settings.iter().map(|(path, value)| (path.clone(), json!(value.to_string())));
    Value::Object(entries.collect::<Map<String, Value>>())
}

/// Where the settings were written to, or what they are.
pub fn tell_settings(
    out: &mut impl Write,
    settings: &Settings,
    written: Option<&OutPath>,
) -> std::io::Result<()> {
    match written {
        Some(path) => writeln!(out, "\nscenario with these written to {path}"),
        None => {
            writeln!(out, "\nsettings (--out writes a scenario with them):")?;
            settings.iter().try_for_each(|(path, value)| writeln!(out, "  {path} = {value}"))
        }
    }
}
