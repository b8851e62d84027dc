//! `steadycut papers --paper 2005`: the six methods of the 2005 paper on Experiment 2, beside its Table 1.

use std::io::Write;
use std::process::ExitCode;

use serde_json::json;

use super::Outcome;
use super::args::PapersArgs;
use super::train::bar;
use crate::study::compare::entrants;
use crate::study::compare::outcome::Measure;
use crate::study::compare::table_1::{self, BY_A_HAIR, DISCLOSED, NOT_REACHED, Verdict};
use crate::study::compare::tournament::{Compared, Tournament};

/// Steps of the plant between two looks at the progress.
const SLICE: u64 = 200_000;

pub fn execute(args: &PapersArgs) -> Outcome {
    let base = entrants::experiment_2();
    let methods = entrants::TABLE_1.iter().chain(&entrants::BEYOND);
    let entrants = methods.map(|method| method.on(&base)).collect();
    let table = played(Tournament::new(entrants, args.seeds));
    let verdicts = table_1::verdicts(&table);
    let mut out = std::io::stdout().lock();
    if args.json {
        let report = json!({
            "paper": "2005", "seeds": args.seeds, "printed": table_1::printed(),
            "methods": table, "verdicts": verdicts,
            "chosen_with_the_table_in_view": DISCLOSED, "not_reached": NOT_REACHED,
            "by_a_hair": BY_A_HAIR,
        });
        writeln!(out, "{}", serde_json::to_string_pretty(&report)?)?;
    } else {
        print(&mut out, args.seeds, &table, &verdicts)?;
    }
    Ok(ExitCode::SUCCESS)
}

/// The table of a tournament played to its end, with a progress bar.
pub fn played(mut tournament: Tournament) -> Vec<Compared> {
    let progress = bar(tournament.progress().1 as u64, "runs");
    while !tournament.advance(SLICE) {
        progress.set_position(tournament.progress().0 as u64);
    }
    progress.finish_and_clear();
    tournament.table()
}

fn print(
    out: &mut impl Write,
    seeds: u32,
    table: &[Compared],
    verdicts: &[Verdict],
) -> std::io::Result<()> {
    writeln!(
        out,
        "Combined system 2005, Table 1, Experiment 2: mean and deviation over seeds 1 to {seeds},\n\
         printed figures in brackets; Nsn over all samples in contact, Nsn20 the paper's form\n"
    )?;
    writeln!(
        out,
        "{:<18}{:>22}{:>22}{:>22}{:>24}",
        "", "Nsn", "Nsn20", "time s", "largest force kN"
    )?;
    let printed = table_1::printed();
    for (i, method) in table.iter().enumerate() {
        write!(out, "{:<18}", method.name)?;
        for (measure, digits, width) in [
            (Measure::Nsn, 3, 22),
            (Measure::Nsn20, 3, 22),
            (Measure::Time, 1, 22),
            (Measure::Force, 2, 24),
        ] {
            let figure = printed.get(i).and_then(|row| row.get(measure));
            write!(out, "{:>width$}", cell(method, measure, figure, digits))?;
        }
        writeln!(out)?;
    }
    writeln!(out, "\nverdicts")?;
    for Verdict { band, found, ok } in verdicts {
        let word = if *ok { "ok" } else { "not reached" };
        writeln!(out, "  {word:<12}{band}: {found}")?;
    }
    writeln!(out, "\n{BY_A_HAIR}")?;
    for (title, lines) in
        [("chosen with the table in view", DISCLOSED), ("not reached, and why", NOT_REACHED)]
    {
        writeln!(out, "\n{title}")?;
        for line in lines {
            writeln!(out, "  {line}")?;
        }
    }
    Ok(())
}

fn cell(method: &Compared, measure: Measure, printed: Option<f64>, digits: usize) -> String {
    let found = method.get(measure).map_or_else(
        || "-".to_owned(),
        |spread| format!("{:.digits$} ± {:.digits$}", spread.mean, spread.deviation),
    );
    printed.map_or(found.clone(), |printed| format!("{found} ({printed})"))
}
