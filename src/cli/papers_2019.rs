//! `steadycut papers --paper 2019`: Table 1 beside its rules, errata, and what is reproduced.

use std::io::Write;
use std::process::ExitCode;

use serde_json::json;

use super::Outcome;
use super::args::PapersArgs;
use super::errata::errata;
use crate::study::errata_2019::MACHINE_2019;
use crate::study::papers_2019::{NOT_REPRODUCED, REPRODUCED, measured, table};

pub fn execute(args: &PapersArgs) -> Outcome {
    let mut out = std::io::stdout().lock();
    if args.json {
        let report = json!({
            "paper": "2019", "rows": table(), "errata": MACHINE_2019, "measured": measured(),
            "reproduced": REPRODUCED, "not_reproduced": NOT_REPRODUCED,
        });
        writeln!(out, "{}", serde_json::to_string_pretty(&report)?)?;
    } else {
        print(&mut out)?;
    }
    Ok(ExitCode::SUCCESS)
}

fn print(out: &mut impl Write) -> std::io::Result<()> {
    writeln!(
        out,
        "Dynamic model 2019, Table 1: springs and dampers as printed, and by the note below the\n\
         table, k = m (2 pi f)^2 and c = sqrt(k m) / Q\n"
    )?;
    writeln!(
        out,
        "{:<14}{:>9}{:>9}{:>5}{:>12}{:>12}{:>11}{:>12}{:>12}{:>9}  verdict",
        "node", "m kg", "f Hz", "Q", "k printed", "k rule", "ratio", "c printed", "c rule", "ratio"
    )?;
    for row in table() {
        writeln!(
            out,
            "{:<14}{:>9}{:>9}{:>5}{:>12.3e}{:>12.3e}{:>11.3}{:>12.4e}{:>12.4e}{:>9.3}  {}",
            row.node,
            row.mass_kg,
            row.frequency_hz,
            row.quality,
            row.stiffness_printed_n_m,
            row.stiffness_rule_n_m,
            row.stiffness_printed_n_m / row.stiffness_rule_n_m,
            row.damping_printed_n_s_m,
            row.damping_rule_n_s_m,
            row.damping_printed_n_s_m / row.damping_rule_n_s_m,
            row.verdict_text
        )?;
    }
    writeln!(out, "\nmeasured")?;
    measured().iter().try_for_each(|line| writeln!(out, "  {line}"))?;
    for (title, lines) in [("reproduced", REPRODUCED), ("not reproduced, and why", NOT_REPRODUCED)]
    {
        writeln!(out, "\n{title}")?;
        lines.iter().try_for_each(|line| writeln!(out, "  {line}"))?;
    }
    errata(out, MACHINE_2019)
}
