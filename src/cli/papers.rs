//! `steadycut papers`: a published table against runs, and the errata.

use std::io::Write;
use std::process::ExitCode;

use serde::Serialize;

use super::Outcome;
use super::args::{ComparedPaper, PapersArgs};
use super::errata::errata;
use super::papers_2005;
use super::papers_2019;
use super::papers_told;
use super::progress;
use crate::run::job::Job;
use crate::study::papers::{CalibrationMet, CalibrationsJob, CellVerdict, PaperTable, TableJob};
use crate::study::published::PaperId;
use crate::study::train::claim::{ForceClaim, ForceClaimJob};
use crate::study::train::data::NOTE;

/// The JSON object: the table, its rows in every calibration, and of 2013 the claim about forces.
#[derive(Serialize)]
struct Told<'a> {
    #[serde(flatten)]
    paper: &'a PaperTable,
    calibrations: Vec<CalibrationMet>,
    #[serde(skip_serializing_if = "Option::is_none")]
    claim: Option<ForceClaim>,
}

pub fn execute(args: &PapersArgs) -> Outcome {
    if args.robustness && !matches!(args.paper, ComparedPaper::Combined2005) {
        return Err("--robustness: only `--paper 2005` has conditions to change".into());
    }
    let id = match args.paper {
        ComparedPaper::Combined2005 => return papers_2005::execute(args),
        ComparedPaper::Machine2019 => return papers_2019::execute(args),
        ComparedPaper::Sdnrp2007 => PaperId::Sdnrp2007,
        ComparedPaper::Strategy2013 => PaperId::Strategy2013,
    };
    let mut job = TableJob::new(id, args.calibration.into(), args.plant);
    progress::work(&mut job, "simulations", args.json)?;
    let paper = job.partial();
    let mut all = CalibrationsJob::new(id);
    progress::work(&mut all, "calibrations", args.json)?;
    let claim = match id {
        PaperId::Sdnrp2007 => None,
        PaperId::Strategy2013 => {
            let mut claim = ForceClaimJob::default();
            progress::work(&mut claim, "rows of the claim", args.json)?;
            Some(claim.partial())
        }
    };
    let told = Told { paper: &paper, calibrations: all.partial(), claim };
    let mut out = std::io::stdout().lock();
    if args.json {
        writeln!(out, "{}", serde_json::to_string_pretty(&told)?)?;
    } else {
        print(&mut out, id, &told)?;
    }
    Ok(ExitCode::SUCCESS)
}

/// A state with its model's name in the paper: ids call models by their names of 2007.
fn named(state: &str, id: PaperId) -> String {
    let letter = id.model_set().letter().to_ascii_lowercase();
    state.strip_prefix('k').map_or(state.to_owned(), |rest| format!("{letter}{rest}"))
}

fn print(out: &mut impl Write, id: PaperId, told: &Told<'_>) -> std::io::Result<()> {
    let Told { paper, calibrations, claim } = told;
    writeln!(
        out,
        "{}, calibration {}, plant {}: values after 15 s",
        id.label(),
        paper.calibration,
        paper.plant
    )?;
    let bands = &paper.bands;
    writeln!(
        out,
        "bands: force {} %, feed {} %, speed {} %, Ra {} um\n",
        bands.force_percent, bands.feed_percent, bands.speed_percent, bands.ra_um
    )?;
    writeln!(
        out,
        "{:>3}  {:<15}{:>10}{:>12}{:>11}{:>9}  verdict",
        "sim", "quantity", "printed", "reproduced", "residual", "%"
    )?;
    let start_force = format!("{} N", id.start_force());
    for row in &paper.rows {
        let cells = [
            ("Ra desired um", &row.ra_desired_um),
            (start_force.as_str(), &row.force_start_n),
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
                "{:>3}  {name:<15}{:>10}{:>12.3}{:>+11.3}{:>+9.2}  {}",
                row.sim,
                cell.printed,
                cell.reproduced,
                cell.residual,
                cell.residual_percent,
                cell.verdict.label()
            )?;
        }
        writeln!(
            out,
            "     Ra off its target: printed {:+.1} %, reproduced {:+.1} %",
            row.ra_deviation_printed_percent, row.ra_deviation_reproduced_percent
        )?;
        if !row.out_of_range.is_empty() {
            let states: Vec<String> =
                row.out_of_range.iter().map(|state| named(state, id)).collect();
            writeln!(out, "     states: {}", states.join(", "))?;
        }
        if let Some(note) = row.note {
            writeln!(out, "     note: {note}")?;
        }
    }
    let (mut met, mut all) = (0, 0);
    for cell in paper.rows.iter().flat_map(|row| row.compared()) {
        if cell.verdict == CellVerdict::Reported {
            continue;
        }
        all += 1;
        met += usize::from(cell.verdict == CellVerdict::Met);
    }
    if all > 0 {
        writeln!(out, "\n{met} of {all} cells within their bands")?;
    } else {
        writeln!(out, "\nfinal values as they are: the table's forces come from the formula")?;
        writeln!(out, "{NOTE}")?;
    }
    papers_told::calibrations(out, calibrations)?;
    if let Some(claim) = claim {
        papers_told::claim(out, claim)?;
    }
    errata(out, paper.errata)
}
