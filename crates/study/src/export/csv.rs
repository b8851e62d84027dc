//! CSV: one column per signal with its unit in the header, one line per recorded row. A cell is empty where
//! there is no value: the roughness without a chip.

use std::io::{self, Write};

use crate::run::recording::Recording;
use crate::run::revolution::RevolutionSample;
use crate::run::signals::SIGNALS;

/// Writes a recording; numbers in the shortest form that reads back to the same bits.
///
/// ```
/// use steadycut_core::run::{edits::Edits, one_run::Run, presets};
/// use steadycut_study::export::csv;
///
/// let run = Run::complete(&presets::load("table3-5").unwrap(), &Edits::none());
/// let mut table = Vec::new();
/// csv::write(&mut table, run.recording()).unwrap();
/// let header = std::str::from_utf8(&table).unwrap().lines().next().unwrap();
/// assert!(header.contains("force_n [N]"));
/// ```
///
/// # Errors
/// Those of the writer.
pub fn write(out: &mut impl Write, recording: &Recording) -> io::Result<()> {
    for (i, signal) in SIGNALS.iter().enumerate() {
        let comma = if i == 0 { "" } else { "," };
        write!(out, "{comma}{}", signal.header())?;
    }
    writeln!(out)?;
    for row in recording.rows() {
        for (i, signal) in SIGNALS.iter().enumerate() {
            let comma = if i == 0 { "" } else { "," };
            match (signal.value)(row) {
                Some(value) => write!(out, "{comma}{value}")?,
                None => write!(out, "{comma}")?,
            }
        }
        writeln!(out)?;
    }
    Ok(())
}

/// Writes the samples of a revolution, one line each.
///
/// # Errors
/// Those of the writer.
pub fn write_samples(out: &mut impl Write, samples: &[RevolutionSample]) -> io::Result<()> {
    writeln!(out, "time_s [s],angle_deg [deg],fx_n [N],fy_n [N],fz_n [N],fxy_n [N]")?;
    for sample in samples {
        let RevolutionSample { time_s, angle_deg, fx_n, fy_n, fz_n } = sample;
        writeln!(out, "{time_s},{angle_deg},{fx_n},{fy_n},{fz_n},{}", sample.fxy_n())?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::run::edits::Edits;
    use crate::run::one_run::Run;
    use crate::run::presets;

    #[test]
    fn every_value_reads_back_to_the_same_bits() {
        let mut scenario = presets::load("table3-5-noise").unwrap();
        scenario.change(|s| s.run.duration_s = 0.5).unwrap();
        let run = Run::complete(&scenario, &Edits::none());
        let mut text = Vec::new();
        write(&mut text, run.recording()).unwrap();
        let text = String::from_utf8(text).unwrap();
        let mut lines = text.lines();
        let header = lines.next().unwrap();
        assert!(header.starts_with("time_s [s],position_mm [mm]"), "{header}");
        for (line, row) in lines.zip(run.recording().rows()) {
            let values: Vec<u64> =
                line.split(',').map(|v| v.parse::<f64>().unwrap().to_bits()).collect();
            assert_eq!(values, row.values().map(f64::to_bits));
        }
        assert_eq!(text.lines().count(), run.recording().rows().len() + 1);
    }

    #[test]
    fn a_cell_without_a_value_is_empty() {
        let mut scenario = presets::load("table3-5").unwrap();
        scenario.change(|s| (s.run.duration_s, s.workpiece.axial_depth_mm) = (0.1, 0.0)).unwrap();
        let run = Run::complete(&scenario, &Edits::none());
        let mut text = Vec::new();
        write(&mut text, run.recording()).unwrap();
        let text = String::from_utf8(text).unwrap();
        let mut lines = text.lines().map(|line| line.split(',').collect::<Vec<_>>());
        let header = lines.next().unwrap();
        for line in lines {
            for (name, cell) in header.iter().zip(line) {
                assert_eq!(cell.is_empty(), matches!(*name, "ra_um [um]" | "ra_dyn_um [um]"));
            }
        }
    }
}
