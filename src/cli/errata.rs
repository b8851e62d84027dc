//! The errata of a paper as text.

use std::io::Write;

use crate::study::errata::Erratum;

/// The errata of a paper.
pub fn errata(out: &mut impl Write, errata: &[Erratum]) -> std::io::Result<()> {
    writeln!(out, "\nerrata")?;
    for erratum in errata {
        writeln!(
            out,
            "{:>3}. {}\n     problem: {}\n     here: {}",
            erratum.number, erratum.printed, erratum.problem, erratum.resolution
        )?;
    }
    Ok(())
}
