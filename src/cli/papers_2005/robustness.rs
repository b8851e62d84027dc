//! `steadycut papers --paper 2005 --robustness`: other dead times and another steel.

use std::io::Write;
use std::process::ExitCode;

use serde_json::json;

use super::print::cell;
use super::{Outcome, played};
use crate::study::compare::claims::ControlClaim;
use crate::study::compare::outcome::Measure;
use crate::study::compare::robustness::{RobustnessRow, entrants, material_claim, rows};
use crate::study::compare::tournament::Tournament;
use crate::study::verdict::Verdict;

const NOTE: &str = "in brackets the figures of an independent prototype of the same simulator and \
                    controllers, not of the paper, which has none; * where they differ by more than \
                    6 %. P stands at its stability limit and MRAC bursts: their largest forces hang on \
                    the noise drawn, which is another one there.";

pub fn execute(seeds: u32, json: bool) -> Outcome {
    let rows: Vec<RobustnessRow> =
        rows(played(Tournament::new(entrants(None), seeds), "conditions", json)?);
    let mut out = std::io::stdout().lock();
    if json {
        let object = json!({ "paper": "2005", "seeds": seeds, "note": NOTE, "robustness": rows, "claim": material_claim(&rows),
        });
        writeln!(out, "{}", serde_json::to_string_pretty(&object)?)?;
    } else {
        print(&mut out, seeds, &rows)?;
    }
    Ok(ExitCode::SUCCESS)
}

fn print(out: &mut impl Write, seeds: u32, rows: &[RobustnessRow]) -> std::io::Result<()> {
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
            stops => writeln!(out, "  {stops} of {} stopped by overload", row.found.runs)?,
        }
    }
    if let Some(ControlClaim { verdict, paper, found, .. }) = material_claim(rows) {
        let word = if verdict == Verdict::Holds { "true" } else { "not true" };
        writeln!(out, "\nclaim of the paper\n  {word:<10}{paper}\n            {found}")?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::run::job::Job;

    #[test]
    fn every_condition_and_method_is_printed_beside_the_prototypes_figures() {
        let mut short = entrants(None);
        for entrant in &mut short {
            entrant.scenario.change(|s| s.run.duration_s = 2.2).unwrap();
        }
        let mut tournament = Tournament::new(short, 1);
        tournament.to_end();
        let mut text = Vec::new();
        print(&mut text, 1, &rows(tournament.table())).unwrap();
        let text = String::from_utf8(text).unwrap();
        assert_eq!(text.lines().filter(|line| line.starts_with("  UNKS")).count(), 4, "{text}");
        for (label, figure) in [
            ("dead time 80 ms", "(1.69)"),
            ("16MnCrSi5 in place of Ck45", "(0.119)"),
            ("no dead time", "(0.955)"),
        ] {
            let after = text.split(label).nth(1).unwrap();
            assert!(after.contains(figure), "{label}: {after}");
        }
        assert!(text.contains("not of the paper") && text.contains("claim of the paper"));
    }
}
