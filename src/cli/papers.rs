//! `steadycut papers`: a published table against runs, and the errata.

use std::io::Write;
use std::process::ExitCode;

use super::Outcome;
use super::args::{Paper, PapersArgs};
use crate::study::papers::{Cell, Paper2007, Verdict, band, paper_2007};

pub fn execute(args: &PapersArgs) -> Outcome {
    let Paper::Sdnrp2007 = args.paper;
    let paper = paper_2007(args.calibration.into());
    let mut out = std::io::stdout().lock();
    if args.json {
        writeln!(out, "{}", serde_json::to_string_pretty(&paper)?)?;
    } else {
        print(&mut out, &paper)?;
    }
    Ok(ExitCode::SUCCESS)
}

fn word(cell: &Cell) -> &'static str {
    match cell.verdict {
        Verdict::Met => "met",
        Verdict::Missed => "MISSED",
        Verdict::Given => "given",
    }
}

fn print(out: &mut impl Write, paper: &Paper2007) -> std::io::Result<()> {
    writeln!(out, "SDNRP 2007, Table 3, calibration {}: values after 15 s", paper.calibration)?;
    writeln!(
        out,
        "bands: force {} %, feed {} %, speed {} %, Ra {} um\n",
        band::FORCE_PERCENT,
        band::FEED_PERCENT,
        band::SPEED_PERCENT,
        band::RA_UM
    )?;
    writeln!(
        out,
        "{:>3}  {:<14}{:>10}{:>12}{:>11}{:>9}  verdict",
        "sim", "quantity", "printed", "reproduced", "residual", "%"
    )?;
    for row in &paper.rows {
        let cells = [
            ("Ra desired um", &row.ra_desired_um),
            ("F desired N", &row.f_desired_n),
            ("feed start", &row.feed_initial_mm_min),
            ("speed start", &row.spindle_initial_rpm),
            ("force N", &row.force_final_n),
            ("feed mm/min", &row.feed_final_mm_min),
            ("speed 1/min", &row.spindle_final_rpm),
            ("Ra um", &row.ra_produced_um),
        ];
        for (name, cell) in cells {
            writeln!(
                out,
                "{:>3}  {name:<14}{:>10}{:>12.3}{:>+11.3}{:>+9.2}  {}",
                row.sim,
                cell.printed,
                cell.reproduced,
                cell.residual,
                cell.residual_percent,
                word(cell)
            )?;
        }
        writeln!(
            out,
            "     Ra off its target: printed {:+.1} %, reproduced {:+.1} %",
            row.ra_deviation_printed_percent, row.ra_deviation_reproduced_percent
        )?;
        if !row.out_of_range.is_empty() {
            writeln!(out, "     states: {}", row.out_of_range.join(", "))?;
        }
        if let Some(note) = row.note {
            writeln!(out, "     note: {note}")?;
        }
    }
    let (mut met, mut all) = (0, 0);
    for cell in paper.rows.iter().flat_map(|row| row.compared()) {
        all += 1;
        met += usize::from(cell.verdict == Verdict::Met);
    }
    writeln!(out, "\n{met} of {all} cells within their bands\n\nerrata")?;
    for erratum in paper.errata {
        writeln!(
            out,
            "{:>3}. {}\n     problem: {}\n     here: {}",
            erratum.number, erratum.printed, erratum.problem, erratum.resolution
        )?;
    }
    Ok(())
}
