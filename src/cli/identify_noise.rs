//! `steadycut identify noise`.

use std::io::Write;
use std::process::ExitCode;

use clap::Args;
use serde_json::json;

use super::Outcome;
use super::files::{OutPath, ScenarioPath, report};
use super::identify_data::{DataArgs, settings_json, tell_settings, told, value_json};
use super::measured::args::span;
use super::scenarios::load;
use crate::study::identify::fits::FitValue;
use crate::study::identify::fits::force::{OTHER_FEED, OTHER_SPEED};
use crate::study::identify::fits::noise::{FORCE, REST, recorded};
use crate::study::identify::noise::{identify_noise, noisy_scenario};

/// Arguments of `identify noise`.
#[derive(Debug, Args)]
#[command(
    after_help = "Sample data: steadycut run table3-5-noise --set controller.kind=constant_feed --out trace.csv has the \
    channel force_measured_n of a steady cut."
)]
pub struct IdentifyNoiseArgs {
    /// The recording; --within takes the steady cut out of it.
    #[command(flatten)]
    pub data: DataArgs,
    /// The channel with the force, in N or kN.
    #[arg(long, value_name = "CHANNEL")]
    pub force: String,
    /// Times in s between which the tool was in the air: the sensor's noise is told there.
    #[arg(long, value_name = "FROM..TO", value_parser = span)]
    pub rest: Option<[f64; 2]>,
    /// The scenario with spindle speed, teeth and feed of the cut, and with corners and correlation length of the noise:
    /// program.spindle_rpm, tool.teeth, program.feed_mm_min, noise.band_low_hz, noise.band_high_hz, noise.correlation_mm.
    #[arg(long, value_name = "PRESET|FILE|LINK")]
    pub scenario: ScenarioPath,
    /// Another feed than the scenario's, mm/min.
    #[arg(long, value_name = "MM_MIN")]
    pub feed: Option<f64>,
    /// Another spindle speed than the scenario's, 1/min.
    #[arg(long, value_name = "RPM")]
    pub speed: Option<f64>,
    /// Where to write the scenario with the sizes that were found, source and intervals in comments.
    #[arg(long, value_name = "FILE.toml")]
    pub out: Option<OutPath>,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

pub fn execute(args: &IdentifyNoiseArgs) -> Outcome {
    let mut out = report(args.json, args.out.as_ref())?;
    let file = &args.data.data;
    let (scenario, edits) = load(&args.scenario)?;
    let request = args
        .data
        .request(scenario.clone(), edits.clone())?
        .with_channel(&FORCE, Some(&args.force))
        .with_value(&REST, args.rest.map(FitValue::Span))
        .with_value(&OTHER_FEED, args.feed.map(FitValue::Number))
        .with_value(&OTHER_SPEED, args.speed.map(FitValue::Number));
    let (recording, cut) = recorded(&request).map_err(|fault| args.data.told(&fault))?;
    let fit = identify_noise(&recording, &cut).map_err(|problem| format!("{file}: {problem}"))?;
    let (settings, text) = noisy_scenario(&scenario, &edits, &fit, &format!("from {file}"))?;
    if let Some(path) = &args.out {
        path.write(&text)?;
    }
    if args.json {
        let told = json!({
            "data": file.to_string(),
            "samples": fit.samples,
            "period_s": recording.period_s,
            "mean_n": fit.mean_n,
            "drift_n_s": fit.drift_n_s,
            "white_n": value_json(fit.white_n),
            "rest": fit.rest.map(|(white, drift_n_s)| {
                json!({ "white_n": value_json(white), "drift_n_s": drift_n_s })
            }),
            "band_percent": value_json(fit.band_percent),
            "inhomogeneity_percent": value_json(fit.inhomogeneity_percent),
            "tooth_percent": fit.tooth_percent.map(value_json),
            "spindle_percent": fit.spindle_percent.map(value_json),
            "settings": settings_json(&settings),
        });
        writeln!(out, "{}", serde_json::to_string_pretty(&told)?)?;
        return Ok(ExitCode::SUCCESS);
    }
    writeln!(
        out,
        "{file}: {} samples about {:.2} N, drift {:+.3} N/s; +- is half a 95 % interval\n",
        fit.samples, fit.mean_n, fit.drift_n_s
    )?;
    writeln!(out, "  white noise          {}", told(fit.white_n, 3, "N"))?;
    if let Some((white, drift_n_s)) = fit.rest {
        writeln!(out, "  at rest              {}, drift {drift_n_s:+.3} N/s", told(white, 3, "N"))?;
    }
    let [low_hz, high_hz] = cut.band_hz;
    writeln!(
        out,
        "  band {low_hz} to {high_hz} Hz     {}",
        told(fit.band_percent, 3, "% of the force")
    )?;
    writeln!(
        out,
        "  inhomogeneity        {}",
        told(fit.inhomogeneity_percent, 3, "% of the force")
    )?;
    for (name, ripple) in
        [("tooth passing", fit.tooth_percent), ("spindle turn", fit.spindle_percent)]
    {
        match ripple {
            Some(ripple) => {
                writeln!(out, "  {name:<21}{} (amplitude)", told(ripple, 3, "% of the force"))?;
            }
            None => writeln!(out, "  {name:<21}not seen: the samples are too far apart for it")?,
        }
    }
    tell_settings(&mut out, &settings, args.out.as_ref())?;
    Ok(ExitCode::SUCCESS)
}
