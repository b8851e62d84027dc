//! `steadycut papers --paper 2005`: the six methods of the 2005 paper on Experiment 2, beside its Table 1.

use std::io::Write;
use std::process::ExitCode;

use serde_json::json;

use super::Outcome;
use super::args::PapersArgs;
use super::train::bar;
use crate::study::compare_2005::{Compared, Comparison, DISCLOSED, NOT_REACHED, Spread};

pub fn execute(args: &PapersArgs) -> Outcome {
    let mut comparison = Comparison::new(args.seeds);
    let progress = bar(comparison.runs() as u64, "runs");
    while !comparison.advance() {
        progress.inc(1);
    }
    progress.finish_and_clear();
    let methods = comparison.compared();
    let mut out = std::io::stdout().lock();
    if args.json {
        let report = json!({
            "paper": "2005", "seeds": args.seeds, "methods": methods,
            "chosen_with_the_table_in_view": DISCLOSED, "not_reached": NOT_REACHED,
        });
        writeln!(out, "{}", serde_json::to_string_pretty(&report)?)?;
    } else {
        print(&mut out, args.seeds, &methods)?;
    }
    Ok(ExitCode::SUCCESS)
}

fn print(out: &mut impl Write, seeds: u32, methods: &[Compared]) -> std::io::Result<()> {
    writeln!(
        out,
        "Combined system 2005, Table 1, Experiment 2: mean and deviation over seeds 1 to {seeds},\n\
         printed figures in brackets; Nsn over all samples in contact, Nsn20 the paper's form\n"
    )?;
    writeln!(
        out,
        "{:<16}{:>22}{:>16}{:>22}{:>24}",
        "", "Nsn", "Nsn20", "time s", "largest force kN"
    )?;
    let cell = |spread: Spread, printed: f64, digits: usize| {
        let Spread { mean, deviation } = spread;
        format!("{mean:.digits$} ± {deviation:.digits$} ({printed})")
    };
    for method in methods {
        let printed = &method.printed;
        let Spread { mean, deviation } = method.normalized_standard_error_20;
        writeln!(
            out,
            "{:<16}{:>22}{:>16}{:>22}{:>24}",
            method.controller,
            cell(method.normalized_standard_error, printed.normalized_standard_error, 3),
            format!("{mean:.3} ± {deviation:.3}"),
            cell(method.time_of_cut_s, printed.time_of_cut_s, 1),
            cell(method.max_force_kn, printed.max_force_kn, 2),
        )?;
    }
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
