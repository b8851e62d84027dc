//! `steadycut papers --paper 2005 --robustness`: other dead times and another steel.

use std::io::Write;
use std::process::ExitCode;

use serde_json::json;

use super::print::cell;
use super::{Outcome, played};
use crate::study::compare::outcome::Measure;
use crate::study::compare::robustness::{Row, entrants, rows};
use crate::study::compare::tournament::Tournament;

const NOTE: &str = "in brackets the figures of an independent prototype of the same simulator and \
                    controllers, not of the paper, which has none; * where they differ by more than 6 %";

pub fn execute(seeds: u32, json: bool) -> Outcome {
    let rows = rows(played(Tournament::new(entrants(), seeds), "conditions"));
    let mut out = std::io::stdout().lock();
    if json {
        let object = json!({ "paper": "2005", "seeds": seeds, "note": NOTE, "robustness": rows });
        writeln!(out, "{}", serde_json::to_string_pretty(&object)?)?;
    } else {
        print(&mut out, seeds, &rows)?;
    }
    Ok(ExitCode::SUCCESS)
}

fn print(out: &mut impl Write, seeds: u32, rows: &[Row]) -> std::io::Result<()> {
    writeln!(
        out,
        "Combined system 2005, Experiment 2 under changed conditions, nothing retuned: mean and\n\
         deviation over seeds 1 to {seeds}; the controllers know the dead time, not the steel;\n{NOTE}"
    )?;
    let mut condition = "";
    for row in rows {
        if row.condition != condition {
            condition = row.condition;
            writeln!(
                out,
                "\n{:<28}{:>24}{:>22}{:>24}",
                row.label, "Nsn", "time s", "largest force kN"
            )?;
        }
        write!(out, "  {:<26}", row.found.name)?;
        for (measure, digits, width) in
            [(Measure::Nsn, 3, 24), (Measure::Time, 1, 22), (Measure::Force, 2, 24)]
        {
            let beside = row.reference.as_ref().and_then(|reference| reference.get(measure));
            write!(out, "{:>width$}", cell(&row.found, measure, beside, digits))?;
        }
        match row.found.force_stops {
            0 => writeln!(out)?,
            stops => writeln!(out, "  {stops} of {} stopped by extreme force", row.found.runs)?,
        }
    }
    Ok(())
}
