//! The measured data of `steadycut identify ...`: channels by name, even in time; and how values are told.

use std::io::Write;

use clap::Args;
use serde_json::{Map, Value, json};

use super::files::{InPath, OutPath};
use super::measured;
use super::measured::args::{layout_entry, span};
use crate::base::settings;
use crate::measured::channel::{MeasuredChannel, SampleTimes};
use crate::measured::reader::MeasuredData;
use crate::measured::signal::filled;
use crate::study::identify::EstimatedValue;

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

/// A channel whose samples are even in time and all there.
pub struct EvenChannel {
    pub name: String,
    pub unit: String,
    pub rate_hz: f64,
    pub values: Vec<f64>,
    times: SampleTimes,
}

impl EvenChannel {
    /// The time of a sample, s.
    pub fn time_s(&self, i: usize) -> f64 {
        self.times.at(i).unwrap_or(0.0)
    }

    /// Whether another one was sampled at the same times.
    pub fn goes_with(&self, other: &Self) -> Result<(), String> {
        if self.times != other.times || self.values.len() != other.values.len() {
            return Err(format!("`{}` and `{}` have different times", self.name, other.name));
        }
        Ok(())
    }
}

impl DataArgs {
    pub fn read(&self) -> Result<MeasuredData, String> {
        measured::data(&self.data, &self.layout)
    }

    /// The channel that an option names.
    ///
    /// # Errors
    /// There is none of that name, its samples are not even, or some are missing.
    pub fn even(
        &self,
        data: &MeasuredData,
        option: &str,
        name: &str,
    ) -> Result<EvenChannel, String> {
        let channel = named(data, option, name)?;
        let rate_hz = channel.times.rate_hz().ok_or_else(|| {
            format!(
                "{}: the samples of `{name}` are not even in time, or their times are not known: give --layout rate_hz=",
                self.data
            )
        })?;
        let (values, missing) =
            filled(channel).map_err(|fault| format!("{}: {fault}", self.data))?;
        if missing > 0 {
            return Err(format!(
                "{}: {missing} samples of `{name}` are missing or no numbers; expected are whole records",
                self.data
            ));
        }
        Ok(EvenChannel {
            name: channel.name.clone(),
            unit: channel.unit.clone(),
            rate_hz,
            values,
            times: channel.times.clone(),
        })
    }

    /// The values within the times that are taken.
    pub fn taken(&self, channel: &EvenChannel, values: &[f64]) -> Vec<f64> {
        let [from_s, to_s] = self.within.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
        let taken = |i: &usize| (from_s..=to_s).contains(&channel.time_s(*i));
        (0..values.len()).filter(taken).map(|i| values[i]).collect()
    }

    /// The force in a channel, N, within the times that are taken.
    ///
    /// # Errors
    /// As [`Self::even`]; its unit is none of force.
    pub fn force_n(
        &self,
        data: &MeasuredData,
        option: &str,
        name: &str,
    ) -> Result<(EvenChannel, Vec<f64>), String> {
        let channel = self.even(data, option, name)?;
        let factor = match channel.unit.as_str() {
            "" | "N" => 1.0,
            "kN" => 1000.0,
            other => {
                return Err(format!(
                    "{option}: `{name}` is in {other}; expected is a force in N or kN"
                ));
            }
        };
        let values: Vec<f64> = channel.values.iter().map(|x| factor * x).collect();
        let taken = self.taken(&channel, &values);
        Ok((channel, taken))
    }
}

/// The channel of a name.
pub fn named<'a>(
    data: &'a MeasuredData,
    option: &str,
    name: &str,
) -> Result<&'a MeasuredChannel, String> {
    data.channels.iter().find(|channel| channel.name == name).ok_or_else(|| {
        let names: Vec<&str> = data.channels.iter().map(|channel| channel.name.as_str()).collect();
        format!("{option}: there is no channel `{name}`; there are {}", names.join(", "))
    })
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
