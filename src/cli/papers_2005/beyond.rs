//! `steadycut papers --paper 2005 --beyond`: feeds per cut and the product's own controller.

use std::io::Write;
use std::process::ExitCode;

use serde_json::json;

use super::print::cell;
use super::{Outcome, played};
use crate::study::compare::beyond::{BeyondRow, CHOSEN, entrants, rows, verdicts};
use crate::study::compare::outcome::Measure;
use crate::study::compare::table_1::Table1Verdict;
use crate::study::compare::tournament::Tournament;

pub fn execute(seeds: u32, json: bool) -> Outcome {
    let rows = rows(played(Tournament::new(entrants(), seeds), "beyond the paper", json)?);
    let verdicts = verdicts(&rows);
    let mut out = std::io::stdout().lock();
    if json {
        let object = json!({
            "paper": "2005", "seeds": seeds, "rows": rows, "verdicts": verdicts, "chosen": CHOSEN,
        });
        writeln!(out, "{}", serde_json::to_string_pretty(&object)?)?;
    } else {
        print(&mut out, seeds, &rows, &verdicts)?;
    }
    Ok(ExitCode::SUCCESS)
}

fn print(
    out: &mut impl Write,
    seeds: u32,
    rows: &[BeyondRow],
    verdicts: &[Table1Verdict],
) -> std::io::Result<()> {
    writeln!(
        out,
        "Beyond the paper: Experiment 2 with feeds per cut and with Preview; mean and deviation over\n\
         seeds 1 to {seeds}; the controllers know the dead time. {CHOSEN}."
    )?;
    let mut before = String::new();
    for row in rows {
        let label = row.condition.label();
        if label != before {
            writeln!(out, "\n{label:<40}{:>18}{:>18}{:>22}", "Nsn", "time s", "largest force kN")?;
            before = label;
        }
        write!(out, "  {:<38}", row.found.name)?;
        for (measure, digits, width) in
            [(Measure::Nsn, 4, 18), (Measure::Time, 1, 18), (Measure::Force, 2, 22)]
        {
            write!(out, "{:>width$}", cell(&row.found, measure, None, digits))?;
        }
        match row.found.force_stops {
            0 => writeln!(out)?,
            stops => writeln!(out, "  {stops} of {} stopped by overload", row.found.runs)?,
        }
    }
    writeln!(out, "\nverdicts")?;
    for verdict @ Table1Verdict { band, found, .. } in verdicts {
        let word = if verdict.kept() { "ok" } else { "not reached" };
        writeln!(out, "  {word:<12}{band}: {found}")?;
    }
    Ok(())
}
