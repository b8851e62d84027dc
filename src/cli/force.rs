//! `steadycut force`: static peaks of the mechanistic force model beside published values, and how
//! they converge with thinner slices.

use std::io::Write;
use std::process::ExitCode;

use serde_json::json;

use super::Outcome;
use super::args::ForceArgs;
use crate::study::train::static_peaks::{PeakRow, REFERENCE_SLICE_MM, SLICES_MM, table};

pub fn execute(args: &ForceArgs) -> Outcome {
    let rows = table();
    let mut out = std::io::stdout().lock();
    if args.json {
        let object = json!({
            "slices_mm": SLICES_MM, "reference_slice_mm": REFERENCE_SLICE_MM, "rows": rows,
        });
        writeln!(out, "{}", serde_json::to_string_pretty(&object)?)?;
    } else {
        print(&mut out, &rows)?;
    }
    Ok(ExitCode::SUCCESS)
}

fn print(out: &mut impl Write, rows: &[PeakRow]) -> std::io::Result<()> {
    writeln!(
        out,
        "Ball-end mill D 16 mm, two teeth, helix 10 deg, Ck45 at 200 HB, 80 m/min, rake 12 deg.\n\
         Components at the instant of the largest F_xy, in N; slices of {REFERENCE_SLICE_MM} mm; \
         an independent implementation\nof the same model in brackets.\n"
    )?;
    let names = ["Fx", "Fy", "Fz", "F_xy", "mean F_xy"];
    write!(out, "{:>5}{:>5}{:>5}{:>8}", "f mm", "A_D", "R_D", "run-out")?;
    names.iter().try_for_each(|name| write!(out, "{name:>19}"))?;
    writeln!(out, "{:>8}", "off %")?;
    for row in rows {
        write_cut(out, row)?;
        let mut worst: f64 = 0.0;
        for (computed, reference) in row.computed_n.iter().zip(row.reference_n) {
            let cell = format!("{computed:.1} ({reference:.1})");
            write!(out, "{cell:>19}")?;
            worst = worst.max((100.0 * (computed / reference - 1.0)).abs());
        }
        writeln!(out, "{worst:>8.2}")?;
    }
    writeln!(out, "\nPeak F_xy in N over the height of the slices")?;
    write!(out, "{:>5}{:>5}{:>5}{:>8}", "f mm", "A_D", "R_D", "run-out")?;
    SLICES_MM.iter().try_for_each(|slice| write!(out, "{:>10}", format!("{slice} mm")))?;
    writeln!(out, "{:>10}", "limit %")?;
    for row in rows {
        write_cut(out, row)?;
        row.fxy_over_slices_n.iter().try_for_each(|force| write!(out, "{force:>10.1}"))?;
        writeln!(out, "{:>+10.1}", row.limit_percent)?;
    }
    writeln!(
        out,
        "\nlimit %: thin slices against {REFERENCE_SLICE_MM} mm. The height of the slices is part of \
         the calibration:\na slice enters and leaves the cut whole, so a peak at an exit carries part \
         of a slice too much,\nabout 3 % at the depths of the papers; the mean force does not change."
    )
}

fn write_cut(out: &mut impl Write, row: &PeakRow) -> std::io::Result<()> {
    let [feed, axial, radial, runout] = row.cut;
    write!(out, "{feed:>5}{axial:>5}{radial:>5}{runout:>8}")
}
