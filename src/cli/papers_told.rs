//! What `steadycut papers` prints besides a table: how far its rows are met in every calibration, and the claim of
//! 2013 about forces.

use std::io::Write;

use crate::study::papers::{CalibrationMet, RowMet};
use crate::study::train::claim::ForceClaim;

/// Final values of a row within their bands, and its largest residual in bands.
fn cell(row: &RowMet) -> String {
    format!("{} of {} {:>8.1}", row.met, row.of, row.worst_bands)
}

/// The rows of a table in all calibrations.
pub fn calibrations(out: &mut impl Write, all: &[CalibrationMet]) -> std::io::Result<()> {
    writeln!(
        out,
        "\nfinal values within their bands, and the largest residual in bands, by calibration\n"
    )?;
    write!(out, "{:>3}", "sim")?;
    for calibration in all {
        write!(out, "  {:<15}", calibration.calibration)?;
    }
    writeln!(out)?;
    for row in 0..all.first().map_or(0, |first| first.rows.len()) {
        write!(out, "{:>3}", all[0].rows[row].sim)?;
        for calibration in all {
            write!(out, "  {:<15}", cell(&calibration.rows[row]))?;
        }
        writeln!(out)?;
    }
    write!(out, "{:>3}", "all")?;
    for calibration in all {
        let [met, of] = calibration.met();
        write!(out, "  {:<15}", format!("{met} of {of}"))?;
    }
    writeln!(out)
}

/// The claim about forces, with what is found.
pub fn claim(out: &mut impl Write, claim: &ForceClaim) -> std::io::Result<()> {
    writeln!(out, "\nclaim: {}\n{}", claim.paper, claim.data)?;
    writeln!(out, "errors of F_xy over the same {} fresh rows\n", claim.fresh_rows)?;
    writeln!(
        out,
        "{:<22}{:>9}{:>8}{:>8}{:>8}  model",
        "", "claimed %", "mean %", "median", "95 %"
    )?;
    for contender in &claim.contenders {
        let errors = &contender.errors;
        writeln!(
            out,
            "{:<22}{:>9}{:>8.2}{:>8.2}{:>8.2}  {}",
            contender.name,
            contender.claimed_percent,
            errors.mean_percent,
            errors.median_percent,
            errors.p95_percent,
            contender.what
        )?;
    }
    writeln!(out)?;
    for statement in &claim.statements {
        writeln!(out, "  {:<15} {}", statement.verdict.label(), statement.statement)?;
    }
    writeln!(out, "the formula (`steadycut train genetic`): F_xy = {}", claim.formula)
}
