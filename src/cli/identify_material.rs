//! `steadycut identify material`.

use std::io::Write;
use std::process::ExitCode;

use clap::Args;
use serde_json::json;

use super::Outcome;
use super::files::{OutPath, ScenarioPath, report};
use super::identify_data::{DataArgs, settings_json, tell_settings, told, value_json};
use super::scenarios::load;
use crate::study::identify::fits::material::{FEED, PEAK, POSITION, SPEED, recorded};
use crate::study::identify::material::{identify_material, scenario_of_material};

/// Arguments of `identify material`.
#[derive(Debug, Args)]
#[command(
    after_help = "Sample data: steadycut run table3-5-noise --set controller.kind=constant_feed --set \
    plant.hardness_hb=260 --out trace.csv has the channels force_measured_n, feed_mm_min, spindle_rpm, position_mm."
)]
pub struct IdentifyMaterialArgs {
    /// The recording; --within takes the cut out of it.
    #[command(flatten)]
    pub data: DataArgs,
    /// The channel with the largest force of a revolution, in N or kN (`steadycut measured --peak` makes it of components).
    #[arg(long, value_name = "CHANNEL")]
    pub force: String,
    /// The channel with the feed, mm/min; without it the scenario's program holds.
    #[arg(long, value_name = "CHANNEL")]
    pub feed: Option<String>,
    /// The channel with the spindle speed, 1/min; without it the scenario's program holds.
    #[arg(long, value_name = "CHANNEL")]
    pub speed: Option<String>,
    /// The channel with the position along the path, mm, where the part has several depths.
    #[arg(long, value_name = "CHANNEL")]
    pub position: Option<String>,
    /// The scenario with cutter, part, force model (a map) and the material as it is believed to be.
    #[arg(long, value_name = "PRESET|FILE|LINK")]
    pub scenario: ScenarioPath,
    /// Where to write the scenario with the material that was found, source and intervals in comments.
    #[arg(long, value_name = "FILE.toml")]
    pub out: Option<OutPath>,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

pub fn execute(args: &IdentifyMaterialArgs) -> Outcome {
    let mut out = report(args.json, args.out.as_ref())?;
    let file = &args.data.data;
    let (scenario, edits) = load(&args.scenario)?;
    let request = args
        .data
        .request(scenario.clone(), edits.clone())?
        .with_channel(&PEAK, Some(&args.force))
        .with_channel(&FEED, args.feed.as_ref())
        .with_channel(&SPEED, args.speed.as_ref())
        .with_channel(&POSITION, args.position.as_ref());
    let (samples, _) = recorded(&request).map_err(|fault| args.data.told(&fault))?;
    let fit =
        identify_material(&scenario, &samples).map_err(|problem| format!("{file}: {problem}"))?;
    let (settings, text) = scenario_of_material(&scenario, &edits, &fit, &format!("from {file}"))?;
    if let Some(path) = &args.out {
        path.write(&text)?;
    }
    if args.json {
        let told = json!({
            "data": file.to_string(),
            "samples": fit.samples,
            "factor": value_json(fit.factor),
            "hardness_hb": value_json(fit.hardness_hb),
            "material": scenario.plant.material.id(),
            "rest_n": fit.rest_n,
            "outside": fit.outside,
            "settings": settings_json(&settings),
        });
        writeln!(out, "{}", serde_json::to_string_pretty(&told)?)?;
        return Ok(ExitCode::SUCCESS);
    }
    writeln!(out, "{file}: {} samples in the cut; +- is half a 95 % interval\n", fit.samples)?;
    writeln!(out, "  force over that of Ck45 at 200 HB   {}", told(fit.factor, 4, ""))?;
    let hardness = format!("hardness of {}", scenario.plant.material.label());
    writeln!(out, "  {hardness:<36}{}", told(fit.hardness_hb, 1, "HB"))?;
    writeln!(out, "  {:<36}{:.3} N rms", "left", fit.rest_n)?;
    if fit.outside > 0.0 {
        let percent = 100.0 * fit.outside;
        writeln!(
            out,
            "\nnote: the model was used outside its range in {percent:.0} % of the samples"
        )?;
    }
    tell_settings(&mut out, &settings, args.out.as_ref())?;
    Ok(ExitCode::SUCCESS)
}
