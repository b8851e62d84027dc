//! A frequency response as a table: a column of frequencies, and real and imaginary part or magnitude and phase.

use super::{MeasuredResponse, POINTS};
use crate::base::language::tr;
use crate::base::math::{self, PI};
use crate::csv_table::CsvCells;
use crate::models::structure::Complex;

/// Metres per newton in a column by the end of its name.
const UNITS: [(&str, f64); 2] = [("_m_n", 1.0), ("_um_n", 1e-6)];

/// The column of a name with one of the units, and what one of it is in m/N.
fn column(names: &[String], quantity: &str) -> Option<(usize, f64)> {
    // "_um_n" ends with no "_m_n": there is no underscore before its m.
    UNITS.iter().find_map(|(ending, scale)| {
        let wanted = format!("{quantity}{ending}");
        names.iter().position(|name| *name == wanted).map(|place| (place, *scale))
    })
}

impl MeasuredResponse {
    /// Reads a table with `frequency_hz` and either `real_m_n` and `imaginary_m_n`, or `magnitude_m_n` and `phase_deg`;
    /// in um/N the names end with `_um_n`.
    ///
    /// # Errors
    /// Names columns that are missing, a cell that is no number with its line, frequencies that do not ascend, or too
    /// few or too many points.
    pub fn read(text: &str) -> Result<Self, String> {
        let cells = CsvCells::whole(text)?;
        let names = cells.names();
        let frequency = names.iter().position(|name| name == "frequency_hz");
        let parts = column(names, "real").zip(column(names, "imaginary"));
        let phase = names.iter().position(|name| name == "phase_deg");
        let polar = column(names, "magnitude").zip(phase);
        let Some(frequency) = frequency.filter(|_| parts.is_some() || polar.is_some()) else {
            return Err(tr!(
                "its columns are {names}: wanted are frequency_hz with real_m_n and imaginary_m_n, or with magnitude_m_n \
                 and phase_deg; _um_n for um/N",
                names = names.join(", ")
            ));
        };
        let columns = cells.numbers()?;
        let frequency_hz = columns[frequency].clone();
        let response_m_n = match (parts, polar) {
            (Some(((real, re), (imaginary, im))), _) => {
                let pairs = columns[real].iter().zip(&columns[imaginary]);
                pairs.map(|(x, y)| Complex::new(re * x, im * y)).collect()
            }
            (None, Some(((magnitude, scale), phase))) => {
                let pairs = columns[magnitude].iter().zip(&columns[phase]);
                pairs
                    .map(|(size, degrees)| {
                        let rad = degrees * (PI / 180.0);
                        Complex::new(scale * size * math::cos(rad), scale * size * math::sin(rad))
                    })
                    .collect()
            }
            (None, None) => Vec::new(),
        };
        let this = Self { frequency_hz, response_m_n };
        this.check()?;
        Ok(this)
    }

    /// Whether modes can be found in it.
    pub(super) fn check(&self) -> Result<(), String> {
        let (count, [least, most]) = (self.frequency_hz.len(), POINTS);
        if !(least..=most).contains(&count) || count != self.response_m_n.len() {
            return Err(tr!(
                "the response has {count} points: allowed are {least} to {most}",
                count = count,
                least = least,
                most = most
            ));
        }
        let rises = self.frequency_hz.windows(2).all(|pair| pair[0] < pair[1]);
        if !rises || self.frequency_hz[0] <= 0.0 {
            return Err(tr("the frequencies do not ascend from above 0 Hz").to_owned());
        }
        Ok(())
    }
}
