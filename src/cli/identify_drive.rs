//! `steadycut identify drive`.

use std::io::Write;
use std::process::ExitCode;

use clap::Args;
use serde_json::{Value, json};

use super::Outcome;
use super::files::{OutPath, report};
use super::identify_data::{DataArgs, told, value_json};
use crate::run::edits::Edits;
use crate::run::scenario::Scenario;
use crate::study::identify::drive::{DriveFit, DriveRecording, drive_file, identify_drive};
use crate::study::identify::fits::FitValue;
use crate::study::identify::fits::drive::{COMMAND, FEED, STEP_AT, STEP_FROM, STEP_TO, recorded};

/// Arguments of `identify drive`.
#[derive(Debug, Args)]
pub struct IdentifyDriveArgs {
    /// The recording.
    #[command(flatten)]
    pub data: DataArgs,
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

/// The recording, and the unit of its feed.
fn recording(args: &IdentifyDriveArgs) -> Result<(DriveRecording, String), String> {
    let request = args.data.request(Scenario::default(), Edits::none())?;
    let number = |i: usize| args.step.map(|step| FitValue::Number(step[i]));
    let request = request
        .with_channel(&FEED, Some(&args.feed))
        .with_channel(&COMMAND, args.command.as_ref())
        .with_value(&STEP_AT, number(0))
        .with_value(&STEP_FROM, number(1))
        .with_value(&STEP_TO, number(2));
    recorded(&request).map_err(|fault| args.data.told(&fault))
}

pub fn execute(args: &IdentifyDriveArgs) -> Outcome {
    let mut out = report(args.json, args.out.as_ref())?;
    let (recording, unit) = recording(args)?;
    let file = &args.data.data;
    let fits = identify_drive(&recording).map_err(|problem| format!("{file}: {problem}"))?;
    let best = &fits[0];
    let samples = recording.feed.len();
    if let Some(path) = &args.out {
        path.write(&drive_file(best, &format!("identified in {file}"), samples))?;
    }
    if args.json {
        let fits: Vec<Value> = fits.iter().map(fit_json).collect();
        let told = json!({
            "data": file.to_string(),
            "samples": samples,
            "period_s": recording.period_s,
            "unit": unit,
            "fits": fits,
        });
        writeln!(out, "{}", serde_json::to_string_pretty(&told)?)?;
        return Ok(ExitCode::SUCCESS);
    }
    writeln!(out, "{file}: {samples} samples, {} s apart", recording.period_s)?;
    writeln!(
        out,
        "structures; the first has the least BIC and is taken. +- is half a 95 % interval"
    )?;
    for fit in &fits {
        writeln!(out, "\n  {}, BIC {:.1}, AIC {:.1}", fit.structure.label(), fit.bic, fit.aic)?;
        writeln!(out, "    dead time  {}", told(fit.dead_time_s, 6, "s"))?;
        writeln!(out, "    lag        {}", told(fit.lag_s, 6, "s"))?;
        writeln!(out, "    gain       {}", told(fit.gain, 6, ""))?;
        for (name, unit, value) in &fit.parameters {
            writeln!(out, "    {name:<11}{}", told(*value, 6, unit))?;
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

fn fit_json(fit: &DriveFit) -> Value {
    let parameters: Vec<Value> = fit
        .parameters
        .iter()
        .map(|(name, unit, x)| json!({ "name": name, "unit": unit, "value": x.value, "half_95": x.half }))
        .collect();
    json!({
        "structure": fit.structure.id(),
        "dead_time_s": value_json(fit.dead_time_s),
        "lag_s": value_json(fit.lag_s),
        "gain": value_json(fit.gain),
        "parameters": parameters,
        "poles": fit.poles,
        "rest": fit.rest,
        "aic": fit.aic,
        "bic": fit.bic,
        "residuals": fit.residuals,
    })
}
