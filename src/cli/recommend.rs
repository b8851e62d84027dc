//! `steadycut recommend`: recommended cutting conditions from a cutting-data table.

use std::io::Write;
use std::process::ExitCode;

use serde_json::json;

use super::Outcome;
use super::args::{RecommendArgs, RecommendTableArgs, RecommendWhat};
use super::files::{InPath, report};
use crate::models::tool::Tool;
use crate::study::recommend::learned::{Answer, Learned};
use crate::study::recommend::table::{NOTE as TABLE_NOTE, SHIPPED, Table, synthetic};
use crate::study::recommend::{Advisor, NOTE, Recommendation};

/// Rules with less strength are not printed; `--json` has all.
const LEAST_SHOWN: f64 = 0.005;

pub fn execute(args: &RecommendArgs) -> Outcome {
    if let Some(RecommendWhat::Table(args)) = &args.what {
        return make_table(args);
    }
    let (Some(hb), Some(diameter), Some(engagement)) = (args.hb, args.diameter, args.engagement)
    else {
        return Err("`--hb`, `--diameter` and `--engagement` are needed".into());
    };
    let (table, source) = read_table(args.table.as_ref())?;
    let advisor = Advisor::new(&table);
    let tool = Tool { diameter_mm: diameter, teeth: args.teeth, ..Tool::default() };
    let found = advisor.recommend(hb, &tool, engagement)?;
    let mut out = std::io::stdout().lock();
    if args.json {
        let system = |learned: &Learned| {
            json!({
                "rows": learned.rows(), "memberships": learned.counts(),
                "input_range": learned.input_range(),
                "training": learned.training_errors(), "left_out": learned.left_out_errors(),
            })
        };
        let report = json!({
            "recommendation": found, "inside_table": found.inside_table(),
            "table": table_id(args.table.as_ref()), "table_text": source, "note": NOTE,
            "systems": {
                "cutting_speed_m_min": system(&advisor.speed),
                "feed_per_tooth_mm": system(&advisor.feed),
            },
        });
        writeln!(out, "{}", serde_json::to_string_pretty(&report)?)?;
        return Ok(ExitCode::SUCCESS);
    }
    writeln!(out, "{hb} HB, {diameter} mm, {}: recommended", engagement.label())?;
    print(&mut out, &found)?;
    system(
        &mut out,
        "cutting speed over hardness (HB)",
        "m/min",
        &advisor.speed,
        &found.cutting_speed_m_min,
    )?;
    system(
        &mut out,
        "feed per tooth over diameter (mm)",
        "mm",
        &advisor.feed,
        &found.feed_per_tooth_mm,
    )?;
    writeln!(out, "\n{NOTE}\nThe table: {source}.")?;
    Ok(ExitCode::SUCCESS)
}

/// A table and what it is: that of a file, or the shipped one.
pub fn read_table(path: Option<&InPath>) -> Result<(Table, String), Box<dyn std::error::Error>> {
    let Some(path) = path else {
        return Ok((Table::shipped(), TABLE_NOTE.to_owned()));
    };
    let table = Table::parse(&path.text()?).map_err(|error| format!("{path}: {error}"))?;
    Ok((table, path.to_string()))
}

/// A table in reports: `shipped`, or its file.
pub fn table_id(path: Option<&InPath>) -> String {
    path.map_or_else(|| "shipped".to_owned(), ToString::to_string)
}

/// The recommended values.
pub fn print(out: &mut impl Write, found: &Recommendation) -> std::io::Result<()> {
    let lines = [
        (
            "cutting speed",
            format!("{:.1} m/min", found.cutting_speed_m_min.value),
            &found.cutting_speed_m_min,
        ),
        (
            "feed per tooth",
            format!("{:.4} mm", found.feed_per_tooth_mm.value),
            &found.feed_per_tooth_mm,
        ),
    ];
    for (name, value, answer) in lines {
        let mark = if answer.inside_table { "" } else { "  OUTSIDE THE TABLE: its edge answers" };
        writeln!(out, "  {name:<24}{value}{mark}")?;
    }
    writeln!(out, "  {:<24}{:.1} 1/min", "spindle speed", found.speed_rpm)?;
    let teeth = match found.teeth {
        1 => "one tooth".to_owned(),
        2 => "two teeth".to_owned(),
        teeth => format!("{teeth} teeth"),
    };
    writeln!(out, "  {:<24}{:.2} mm/min with {teeth}", "feed", found.feed_mm_min)
}

fn system(
    out: &mut impl Write,
    name: &str,
    unit: &str,
    learned: &Learned,
    answer: &Answer,
) -> std::io::Result<()> {
    let [first, second] = learned.counts();
    let [low, high] = learned.input_range();
    let rows = learned.rows();
    writeln!(out, "\n{name}, {low} to {high}: {first} x {second} rules from {rows} rows")?;
    for firing in answer.rules.iter().filter(|firing| firing.strength >= LEAST_SHOWN) {
        let fraction = 100.0 * firing.strength;
        let value = rounded(firing.value);
        writeln!(out, "  {fraction:>5.1} %  {:<36}{value:>9} {unit}", firing.rule)?;
    }
    for (name, errors) in
        [("learned", learned.training_errors()), ("left out", learned.left_out_errors())]
    {
        let (rms, mean, worst) = (errors.rms_percent, errors.mean_percent, errors.worst_percent);
        writeln!(out, "  rows {name:<10}rms {rms:.1} %, mean {mean:.1} %, worst {worst:.1} %")?;
    }
    Ok(())
}

fn rounded(value: f64) -> String {
    if value >= 1.0 { format!("{value:.1}") } else { format!("{value:.4}") }
}

fn make_table(args: &RecommendTableArgs) -> Outcome {
    let text = synthetic();
    let mut out = report(false, args.out.as_ref())?;
    let same = text == SHIPPED;
    match &args.out {
        Some(path) => {
            path.write(&text)?;
            writeln!(out, "table written to {path}")?;
        }
        None if args.check => {
            let word = if same { "equals" } else { "differs from" };
            writeln!(out, "the table made from its formulas {word} the shipped one")?;
        }
        None => write!(out, "{text}")?,
    }
    Ok(if args.check && !same { ExitCode::from(1) } else { ExitCode::SUCCESS })
}
