//! `steadycut measured`: reads measured data, says as what, and writes them as plain CSV.

mod aligned;
pub mod args;

use std::io::Write;
use std::process::ExitCode;

use serde_json::{Map, Value, json};

use aligned::{Aligned, AlignmentTold, aligned};
use args::MeasuredArgs;

use super::Outcome;
use super::files::{InPath, OutPath, differ, report};
use crate::measured::channel::MeasuredChannel;
use crate::measured::layout::{DataLayout, LAYOUT_ENDING};
use crate::measured::reader::{MeasuredData, read};
use crate::measured::table;

/// A file as it was read, and what of its layout was said.
struct Read {
    file: String,
    data: MeasuredData,
    /// Keys that were said on the command line, and those that the file beside the data says.
    said: Vec<&'static str>,
    remembered: Vec<&'static str>,
    /// The file beside the data, if it is there or was written.
    layout_file: Option<String>,
    /// How a channel lies to a run, if that was asked for.
    aligned: Option<AlignmentTold>,
}

/// What a person says of the layout now.
fn said(entries: &[(String, String)], variable: Option<&String>) -> Result<DataLayout, String> {
    let mut layout = DataLayout::default();
    for (key, value) in entries {
        layout.set(key, value).map_err(|problem| format!("--layout: {problem}"))?;
    }
    if let Some(variable) = variable {
        if layout.variable.as_ref().is_some_and(|other| other != variable) {
            return Err("--variable and --layout variable= say different things".to_owned());
        }
        layout.variable = Some(variable.clone());
    }
    Ok(layout)
}

/// What the file beside measured data says of their layout; none where there is no such file.
fn kept(file: &InPath) -> Result<Option<DataLayout>, String> {
    let beside = file.beside(LAYOUT_ENDING).filter(|(path, _)| path.is_there());
    let Some((path, _)) = beside else { return Ok(None) };
    DataLayout::read(&path.text()?).map(Some).map_err(|problem| format!("{path}: {problem}"))
}

/// Measured data for another command, with what is said and remembered of their layout.
pub fn data(file: &InPath, layout: &[(String, String)]) -> Result<MeasuredData, String> {
    let layout = kept(file)?.unwrap_or_default().overruled_by(&said(layout, None)?);
    read(&file.measured()?, &layout).map_err(|fault| format!("{file}: {fault}"))
}

fn keys(layout: &DataLayout) -> Vec<&'static str> {
    layout.entries().into_iter().map(|(key, _)| key).collect()
}

pub fn execute(args: &MeasuredArgs) -> Outcome {
    let mut out = report(args.json, args.out.as_ref())?;
    let now = said(&args.layout, args.variable.as_ref())?;
    let beside = args.file.beside(LAYOUT_ENDING);
    if args.remember && beside.is_none() {
        return Err("--remember: beside standard input there is no place for a file".into());
    }
    if args.remember && now == DataLayout::default() {
        return Err("--remember: nothing was overruled by --layout or --variable".into());
    }
    let kept = kept(&args.file)?;
    let remembered = kept.clone().unwrap_or_default();
    let layout = remembered.overruled_by(&now);
    let told = |fault| format!("{}: {fault}", args.file);
    let mut data = read(&args.file.measured()?, &layout).map_err(told)?;
    let missing = data.channels.iter().filter(|channel| channel.summary().missing > 0).count();
    let preparation = args.prepare.preparation();
    if !preparation.is_none() {
        data.channels = preparation.of(&data.channels).map_err(told)?;
        if missing > 0 {
            data.notes.push(format!(
                "samples are missing in {missing} channels: filled in where a step needs them"
            ));
        }
    }
    let mut alignment = None;
    let mut written = data.channels.clone();
    if let Some(Aligned { told, channels }) = aligned(&args.prepare, &data.channels, args.json)? {
        (alignment, written) = (Some(told), channels);
    }
    let mut layout_file = kept.as_ref().and(beside.as_ref()).map(|(path, _)| path.to_string());
    if let Some((_, path)) = beside.as_ref().filter(|_| args.remember) {
        let outputs: Vec<OutPath> = args.out.iter().chain([path]).cloned().collect();
        differ(&outputs)?;
        path.write(&layout.write())?;
        layout_file = Some(path.to_string());
    }
    if let Some(path) = &args.out {
        let mut file = path.create()?;
        table::write(&mut file, &written).map_err(|error| file.failed(error))?;
        file.keep()?;
    }
    let read = Read {
        file: args.file.to_string(),
        data,
        said: keys(&now),
        remembered: keys(&remembered),
        layout_file,
        aligned: alignment,
    };
    if args.json {
        writeln!(out, "{}", serde_json::to_string_pretty(&read.to_json())?)?;
        return Ok(ExitCode::SUCCESS);
    }
    read.print(&mut out)?;
    if let Some(path) = &args.out {
        writeln!(out, "\nchannels written to {path}")?;
    }
    Ok(ExitCode::SUCCESS)
}

impl Read {
    /// Where an entry of the layout comes from.
    fn source(&self, key: &str) -> &'static str {
        if self.said.contains(&key) {
            "said"
        } else if self.remembered.contains(&key) {
            "remembered"
        } else {
            "guessed"
        }
    }

    fn to_json(&self) -> Value {
        let mut layout = Map::new();
        for (key, value) in self.data.layout.entries() {
            let value = match key {
                "names" => json!(self.data.layout.names),
                "units" => json!(self.data.layout.units),
                "names_line" | "units_line" | "first_line" | "rate_hz" => {
                    json!(value.parse::<f64>().ok())
                }
                _ => json!(value),
            };
            layout.insert(key.to_owned(), json!({ "value": value, "from": self.source(key) }));
        }
        let pairs = |facts: &[(String, String)]| {
            facts
                .iter()
                .map(|(name, value)| json!({ "name": name, "value": value }))
                .collect::<Vec<_>>()
        };
        let contents: Vec<Value> = self
            .data
            .entries
            .iter()
            .map(|entry| json!({ "name": entry.name, "about": entry.about }))
            .collect();
        json!({
            "file": self.file,
            "format": self.data.format.id(),
            "layout": layout,
            "layout_file": self.layout_file,
            "contents": contents,
            "facts": pairs(&self.data.facts),
            "notes": self.data.notes,
            "channels": self.data.channels.iter().map(channel_json).collect::<Vec<_>>(),
            "aligned": self.aligned,
        })
    }

    fn print(&self, out: &mut impl Write) -> std::io::Result<()> {
        writeln!(out, "{}: {}", self.file, self.data.format.label())?;
        if let Some(file) = &self.layout_file {
            writeln!(out, "layout remembered in {file}")?;
        }
        writeln!(out, "\nlayout; overrule an entry by --layout KEY=VALUE")?;
        for (key, value) in self.data.layout.entries() {
            writeln!(out, "  {key:<12}{value:<32}  {}", self.source(key))?;
        }
        if !self.data.entries.is_empty() {
            writeln!(out, "\ncontents; choose by --variable NAME")?;
            for entry in &self.data.entries {
                writeln!(out, "  {:<12}{}", entry.name, entry.about)?;
            }
        }
        if !self.data.facts.is_empty() {
            writeln!(out, "\nbeside the channels")?;
            for (name, value) in &self.data.facts {
                writeln!(out, "  {name:<24}  {}", value.replace('\n', " | "))?;
            }
        }
        let names = self.data.channels.iter().map(|channel| channel.title().chars().count());
        let width = names.max().unwrap_or(0).max(7);
        let [rate, rows] = ["rate 1/s", "rows"];
        writeln!(
            out,
            "\n  {:<width$}{rate:>14}{rows:>10}{:>9}{:>14}{:>14}{:>14}",
            "channel", "missing", "min", "mean", "max"
        )?;
        for channel in &self.data.channels {
            let summary = channel.summary();
            let rate = channel.times.rate_hz().map_or("-".to_owned(), short);
            writeln!(
                out,
                "  {:<width$}{rate:>14}{:>10}{:>9}{:>14}{:>14}{:>14}",
                channel.title(),
                channel.values.len(),
                summary.missing,
                short(summary.min),
                short(summary.mean),
                short(summary.max)
            )?;
        }
        if let Some(aligned) = &self.aligned {
            writeln!(out, "\naligned with a run")?;
            for (name, value) in aligned.lines() {
                writeln!(out, "  {name:<20}{value}")?;
            }
        }
        for note in &self.data.notes {
            writeln!(out, "\nnote: {note}")?;
        }
        Ok(())
    }
}

/// A number in at most 12 characters.
fn short(x: f64) -> String {
    let plain = (1e-3..1e7).contains(&x.abs()) || x == 0.0;
    match x {
        x if !x.is_finite() => x.to_string(),
        x if x.fract() == 0.0 && x.abs() < 1e9 => x.to_string(),
        x if plain => format!("{x:.4}"),
        x => format!("{x:.4e}"),
    }
}

fn channel_json(channel: &MeasuredChannel) -> Value {
    let summary = channel.summary();
    json!({
        "name": channel.name,
        "unit": channel.unit,
        "rate_hz": channel.times.rate_hz(),
        "first_s": channel.times.at(0),
        "rows": channel.values.len(),
        "missing": summary.missing,
        "min": summary.min,
        "mean": summary.mean,
        "max": summary.max,
    })
}
