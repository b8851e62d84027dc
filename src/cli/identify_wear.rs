//! `steadycut identify wear`.

use std::io::Write;
use std::process::ExitCode;

use clap::Args;
use serde_json::{Value, json};

use super::Outcome;
use super::files::{InPath, OutPath, ScenarioPath, report};
use super::identify_data::{settings_json, tell_settings, told, value_json};
use super::scenarios::load;
use crate::run::edits::Edits;
use crate::run::scenario::Scenario;
use crate::study::identify::wear::{WearColumns, identify_wear, worn_scenario};

/// Arguments of `identify wear`.
#[derive(Debug, Args)]
#[command(
    after_help = "Sample data, three readings of a tool:\n\n  speed_m_min,time_min,vb_mm\n  160,5,0.14\n  160,10,0.21\n  160,16,0.34"
)]
pub struct IdentifyWearArgs {
    /// The readings: a table with a line of column names, a reading of a tool in every row, in order of time.
    #[arg(long, value_name = "FILE.csv")]
    pub data: InPath,
    /// The column with the cutting speed, m/min.
    #[arg(long, value_name = "COLUMN", default_value = "speed_m_min")]
    pub speed: String,
    /// The column with the time in the cut, min.
    #[arg(long, value_name = "COLUMN", default_value = "time_min")]
    pub time: String,
    /// The column with the width of the flank wear land VB, mm.
    #[arg(long, value_name = "COLUMN", default_value = "vb_mm")]
    pub land: String,
    /// The column with the feed per tooth, mm, where that was varied.
    #[arg(long, value_name = "COLUMN")]
    pub feed: Option<String>,
    /// The column with the axial depth, mm, where that was varied.
    #[arg(long, value_name = "COLUMN")]
    pub depth: Option<String>,
    /// The column with the number of the tool, where several made the same cut.
    #[arg(long, value_name = "COLUMN")]
    pub tool_number: Option<String>,
    /// The wear land at which a tool's life ends, mm.
    #[arg(long, value_name = "MM", default_value_t = 0.3)]
    pub limit: f64,
    /// The scenario that is written with what was identified; without it the default one.
    #[arg(long, value_name = "PRESET|FILE|LINK")]
    pub scenario: Option<ScenarioPath>,
    /// Where to write that scenario, source and intervals in comments; its tool wears over its life.
    #[arg(long, value_name = "FILE.toml")]
    pub out: Option<OutPath>,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

pub fn execute(args: &IdentifyWearArgs) -> Outcome {
    let mut out = report(args.json, args.out.as_ref())?;
    let (scenario, edits) = match &args.scenario {
        Some(path) => load(path)?,
        None => (Scenario::default(), Edits::none()),
    };
    let columns = WearColumns {
        speed: args.speed.clone(),
        time: args.time.clone(),
        land: args.land.clone(),
        feed: args.feed.clone(),
        depth: args.depth.clone(),
        tool: args.tool_number.clone(),
    };
    let fit = identify_wear(&args.data.text()?, &columns, args.limit)
        .map_err(|problem| format!("{}: {problem}", args.data))?;
    let source = format!("from {}", args.data);
    let (settings, text) = worn_scenario(&scenario, &edits, &fit, &source)?;
    if let Some(path) = &args.out {
        path.write(&text)?;
    }
    let powers = [("feed", &fit.feed), ("depth", &fit.depth)];
    if args.json {
        let power = |found: &Option<(f64, Option<_>)>| {
            found.map(|(middle_mm, exponent)| {
                json!({ "reference_mm": middle_mm, "exponent": exponent.map(value_json) })
            })
        };
        let lives: Vec<Value> = fit
            .lives
            .iter()
            .map(|life| {
                json!({
                    "speed_m_min": life.speed_m_min, "feed_mm": life.feed_mm,
                    "depth_mm": life.depth_mm, "life_min": life.life_min,
                    "fitted_min": life.fitted_min,
                })
            })
            .collect();
        let told = json!({
            "data": args.data.to_string(),
            "limit_mm": fit.land_mm,
            "speed_m_min": fit.speed_m_min,
            "life_min": value_json(fit.life_min),
            "exponent": value_json(fit.exponent),
            "constant_m_min": value_json(fit.constant_m_min),
            "feed": power(&fit.feed),
            "depth": power(&fit.depth),
            "spread": fit.spread,
            "lives": lives,
            "notes": fit.notes,
            "settings": settings_json(&settings),
        });
        writeln!(out, "{}", serde_json::to_string_pretty(&told)?)?;
        return Ok(ExitCode::SUCCESS);
    }
    writeln!(
        out,
        "{}: {} lives to a wear land of {} mm; +- is half a 95 % interval\n",
        args.data,
        fit.lives.len(),
        fit.land_mm
    )?;
    let at = format!("T at {:.2} m/min", fit.speed_m_min);
    writeln!(out, "  {at:<22}{}", told(fit.life_min, 3, "min"))?;
    writeln!(out, "  {:<22}{}", "n", told(fit.exponent, 4, ""))?;
    writeln!(out, "  {:<22}{}", "C of v T^n = C", told(fit.constant_m_min, 2, "m/min"))?;
    for (name, found) in powers {
        if let Some((middle_mm, Some(exponent))) = found {
            let what = format!("exponent of {name}");
            writeln!(out, "  {what:<22}{} about {middle_mm:.4} mm", told(*exponent, 4, ""))?;
        }
    }
    if let Some(spread) = fit.spread {
        writeln!(out, "  {:<22}{:.1} % of the life", "left", 100.0 * spread)?;
    }
    writeln!(
        out,
        "\n{:>10}{:>10}{:>10}{:>12}{:>12}",
        "v m/min", "fz mm", "ap mm", "life min", "fit min"
    )?;
    let cell = |x: Option<f64>| x.map_or("-".to_owned(), |x| format!("{x:.3}"));
    for life in &fit.lives {
        writeln!(
            out,
            "{:>10.1}{:>10}{:>10}{:>12.2}{:>12.2}",
            life.speed_m_min,
            cell(life.feed_mm),
            cell(life.depth_mm),
            life.life_min,
            life.fitted_min
        )?;
    }
    for note in &fit.notes {
        writeln!(out, "\nnote: {note}")?;
    }
    tell_settings(&mut out, &settings, args.out.as_ref())?;
    Ok(ExitCode::SUCCESS)
}
