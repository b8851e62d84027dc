//! `steadycut identify drive`.

use std::io::Write;
use std::process::ExitCode;

use clap::Args;
use serde_json::{Value, json};

use super::Outcome;
use super::files::{InPath, OutPath, report};
use super::measured;
use super::measured::args::layout_entry;
use crate::measured::channel::MeasuredChannel;
use crate::measured::reader::MeasuredData;
use crate::measured::signal::filled;
use crate::study::identify::drive::{
    DriveFit, DriveRecording, EstimatedValue, drive_file, identify_drive,
};

/// Arguments of `identify drive`.
#[derive(Debug, Args)]
pub struct IdentifyDriveArgs {
    /// The recording, in any layout that `steadycut measured` reads; its samples are even in time.
    #[arg(long, value_name = "FILE")]
    pub data: InPath,
    /// Overrule a guess about the file's layout, as for `steadycut measured`.
    #[arg(long, value_name = "KEY=VALUE", value_parser = layout_entry)]
    pub layout: Vec<(String, String)>,
    /// The channel with the feed that was measured.
    #[arg(long, value_name = "CHANNEL")]
    pub feed: String,
    /// The channel with the feed that was asked for. What a sample has holds from the sample before on, as in the rows
    /// of a run.
    #[arg(long, value_name = "CHANNEL", required_unless_present = "step")]
    pub command: Option<String>,
    /// The step that was asked for, where it was not recorded: when, from and to which feed.
    #[arg(long, value_name = "AT_S,FROM,TO", value_parser = step, conflicts_with = "command")]
    pub step: Option<[f64; 3]>,
    /// Take the samples between two times in s alone.
    #[arg(long, value_name = "FROM..TO", value_parser = super::measured::args::span)]
    pub within: Option<[f64; 2]>,
    /// Where to write the drive's file: gain, poles, dead time, their intervals.
    #[arg(long, value_name = "FILE.toml")]
    pub out: Option<OutPath>,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

fn step(text: &str) -> Result<[f64; 3], String> {
    let numbers: Option<Vec<f64>> = text
        .split(',')
        .map(|part| part.trim().parse::<f64>().ok().filter(|x| x.is_finite()))
        .collect();
    match numbers.as_deref() {
        Some(&[at_s, from, to]) => Ok([at_s, from, to]),
        Some(_) | None => Err("allowed are three numbers: AT_S,FROM,TO".to_owned()),
    }
}

fn channel<'a>(
    data: &'a MeasuredData,
    option: &str,
    name: &str,
) -> Result<&'a MeasuredChannel, String> {
    data.channels.iter().find(|channel| channel.name == name).ok_or_else(|| {
        let names: Vec<&str> = data.channels.iter().map(|channel| channel.name.as_str()).collect();
        format!("{option}: there is no channel `{name}`; there are {}", names.join(", "))
    })
}

/// The recording, and the unit of its feed.
fn recording(args: &IdentifyDriveArgs) -> Result<(DriveRecording, String), String> {
    let data = measured::data(&args.data, &args.layout)?;
    let feed = channel(&data, "--feed", &args.feed)?;
    let rate_hz = feed.times.rate_hz().ok_or_else(|| {
        format!(
            "{}: the samples of `{}` are not even in time, or their times are not known: give --layout rate_hz=",
            args.data, feed.name
        )
    })?;
    let (feeds, missing) = filled(feed).map_err(|fault| format!("{}: {fault}", args.data))?;
    if missing > 0 {
        return Err(format!("{}: {missing} samples of `{}` are missing", args.data, feed.name));
    }
    let time_s = |i: usize| feed.times.at(i).unwrap_or(0.0);
    let commands: Vec<f64> = match (&args.command, args.step) {
        (Some(name), _) => {
            let command = channel(&data, "--command", name)?;
            if command.times != feed.times || command.values.len() != feeds.len() {
                return Err(format!("`{name}` and `{}` have different times", feed.name));
            }
            filled(command).map_err(|fault| format!("{}: {fault}", args.data))?.0
        }
        (None, Some([at_s, from, to])) => {
            (0..feeds.len()).map(|i| if time_s(i) <= at_s { from } else { to }).collect()
        }
        (None, None) => return Err("give --command or --step".to_owned()),
    };
    let [from_s, to_s] = args.within.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
    let taken = |i: &usize| (from_s..=to_s).contains(&time_s(*i));
    let pick = |values: &[f64]| (0..values.len()).filter(taken).map(|i| values[i]).collect();
    let recording =
        DriveRecording { period_s: 1.0 / rate_hz, command: pick(&commands), feed: pick(&feeds) };
    Ok((recording, feed.unit.clone()))
}

pub fn execute(args: &IdentifyDriveArgs) -> Outcome {
    let mut out = report(args.json, args.out.as_ref())?;
    let (recording, unit) = recording(args)?;
    let fits = identify_drive(&recording).map_err(|problem| format!("{}: {problem}", args.data))?;
    let best = &fits[0];
    let samples = recording.feed.len();
    if let Some(path) = &args.out {
        path.write(&drive_file(best, &format!("identified in {}", args.data), samples))?;
    }
    if args.json {
        let fits: Vec<Value> = fits.iter().map(fit_json).collect();
        let told = json!({
            "data": args.data.to_string(),
            "samples": samples,
            "period_s": recording.period_s,
            "unit": unit,
            "fits": fits,
        });
        writeln!(out, "{}", serde_json::to_string_pretty(&told)?)?;
        return Ok(ExitCode::SUCCESS);
    }
    writeln!(out, "{}: {samples} samples, {} s apart", args.data, recording.period_s)?;
    writeln!(
        out,
        "structures; the first has the least BIC and is taken. +- is half a 95 % interval"
    )?;
    for fit in &fits {
        writeln!(out, "\n  {}, BIC {:.1}, AIC {:.1}", fit.structure.label(), fit.bic, fit.aic)?;
        writeln!(out, "    dead time  {}", told(fit.dead_time_s, "s"))?;
        writeln!(out, "    lag        {}", told(fit.lag_s, "s"))?;
        writeln!(out, "    gain       {}", told(fit.gain, ""))?;
        for (name, unit, value) in &fit.parameters {
            writeln!(out, "    {name:<11}{}", told(*value, unit))?;
        }
        let poles: Vec<String> =
            fit.poles.iter().map(|[re, im]| format!("{re:.3}{im:+.3}i")).collect();
        writeln!(out, "    poles      {} rad/s", poles.join(", "))?;
        writeln!(out, "    rest       {:.4} {unit} rms", fit.rest)?;
    }
    if let Some(path) = &args.out {
        writeln!(out, "\ndrive written to {path}")?;
    }
    Ok(ExitCode::SUCCESS)
}

fn told(x: EstimatedValue, unit: &str) -> String {
    let half = x.half.map_or("+- ? (not determined)".to_owned(), |half| format!("+- {half:.6}"));
    format!("{:.6} {half} {unit}", x.value).trim_end().to_owned()
}

fn fit_json(fit: &DriveFit) -> Value {
    let value = |x: EstimatedValue| json!({ "value": x.value, "half_95": x.half });
    let parameters: Vec<Value> = fit
        .parameters
        .iter()
        .map(|(name, unit, x)| json!({ "name": name, "unit": unit, "value": x.value, "half_95": x.half }))
        .collect();
    json!({
        "structure": fit.structure.id(),
        "dead_time_s": value(fit.dead_time_s),
        "lag_s": value(fit.lag_s),
        "gain": value(fit.gain),
        "parameters": parameters,
        "poles": fit.poles,
        "rest": fit.rest,
        "aic": fit.aic,
        "bic": fit.bic,
        "residuals": fit.residuals,
    })
}
