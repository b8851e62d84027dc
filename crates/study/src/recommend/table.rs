//! Cutting-data tables: what a maker recommends for hardness, diameter and engagement, as CSV.
//!
//! The shipped table is synthetic: a maker's tables may not be copied. Its rows follow formulas
//! whose exponents imitate one (Sandvik CoroMill Plura, p. D155: P steel 375 to 160 m/min for 125
//! to 450 HB; 0.055, 0.09, 0.089, 0.161 mm for a diameter of 16 mm), with 3 % of noise:
//!
//! ```text
//! v_c = 100 (200 / HB)^0.67 {0.47, 0.56, 1, 1.85}     f_z = 0.0265 D^0.44 {0.6, 0.95, 1, 1.8}
//! ```

use std::fmt::Write as _;

use super::EngagementCode;
use crate::base::language::text;
use crate::base::math;
use crate::base::rng::Stream;
use crate::base::settings::SettingError;
use crate::csv_table::{ColumnNames, CsvRow, CsvTable};

/// The shipped table.
pub const SHIPPED: &str = include_str!("../../../../assets/data/cutting_data_2005.csv");
/// What it is, for reports.
pub const NOTE: &str =
    text!("synthetic: formulas that imitate a maker's table, with 3 % noise; no maker's data");

/// Columns in their order, with the range that each allows.
const COLUMNS: [(ColumnNames, f64, f64); 5] = [
    (&["hardness_hb"], 50.0, 700.0),
    (&["diameter_mm"], 0.5, 100.0),
    (&["engagement"], 1.0, 4.0),
    (&["cutting_speed_m_min"], 1.0, 2000.0),
    (&["feed_per_tooth_mm"], 0.0001, 5.0),
];
/// Column of the hardness.
pub(super) const HARDNESS: usize = 0;
/// Column of the diameter.
pub(super) const DIAMETER: usize = 1;
const ENGAGEMENT: usize = 2;
const SPEED: usize = 3;
const FEED: usize = 4;
/// Most rows: leaving one out learns the whole table once a row.
const MAX_ROWS: usize = 200;

/// One value of the table: the input beside the engagement (hardness in HB or diameter in mm), the
/// number of the engagement, the value (m/min or mm).
pub type Entry = ([f64; 2], f64);

/// A table.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// Cutting speeds in m/min over hardness in HB and engagement.
    pub speeds: Vec<Entry>,
    /// Feeds per tooth in mm over diameter in mm and engagement.
    pub feeds: Vec<Entry>,
}

fn fault(problem: String) -> SettingError {
    SettingError::Format { what: "cutting-data table".to_owned(), problem }
}

/// Whether a number may stand in a column.
///
/// # Errors
/// Names the column, the value and its range.
pub(super) fn check(column: usize, value: f64) -> Result<(), SettingError> {
    let (names, low, high) = COLUMNS[column];
    let name = names[0];
    if (low..=high).contains(&value) {
        return Ok(());
    }
    Err(SettingError::Refused {
        path: name.to_owned(),
        value: value.to_string(),
        allowed: format!("a number from {low} to {high}"),
    })
}

impl Table {
    /// The shipped table.
    #[must_use]
    pub fn shipped() -> Self {
        Self::parse(SHIPPED).expect("the shipped table is checked by a test")
    }

    /// Reads a table ([`CsvTable`]): a row gives a
    /// cutting speed for a hardness, a feed per tooth for a diameter, or both; what it does not give
    /// stays empty.
    ///
    /// # Errors
    /// Names the line, the column, the value and what is allowed.
    pub fn parse(text: &str) -> Result<Self, SettingError> {
        let read = CsvTable::parse(text, &COLUMNS.map(|(names, ..)| names)).map_err(fault)?;
        let mut table = Self { speeds: Vec::new(), feeds: Vec::new() };
        if let Some(row) = read.rows.get(MAX_ROWS) {
            return Err(fault(format!("line {}: at most {MAX_ROWS} rows are read", row.line)));
        }
        read.rows.iter().try_for_each(|row| table.take(&read, row))?;
        for (what, entries) in
            [("cutting_speed_m_min", &table.speeds), ("feed_per_tooth_mm", &table.feeds)]
        {
            enough(what, entries)?;
        }
        Ok(table)
    }

    fn take(&mut self, table: &CsvTable, row: &CsvRow) -> Result<(), SettingError> {
        let (line, mut cells) = (row.line, [None; 5]);
        for (cell, (text, (names, low, high))) in
            cells.iter_mut().zip(row.cells.iter().zip(COLUMNS))
        {
            let name = names[0];
            if text.is_empty() {
                continue;
            }
            let whole = name == COLUMNS[ENGAGEMENT].0[0];
            let fits = |x: &f64| (low..=high).contains(x) && (!whole || x.fract() == 0.0);
            *cell = table.number(text).filter(fits);
            if cell.is_none() {
                let text: String = text.chars().take(40).collect();
                let kind = if whole { "a whole number" } else { "a number" };
                return Err(fault(format!(
                    "line {line}: `{name}` cannot be {text}: allowed is {kind} from {low} to {high}"
                )));
            }
        }
        let missing = |needed: usize, by: usize| {
            let (needed, by) = (COLUMNS[needed].0[0], COLUMNS[by].0[0]);
            fault(format!("line {line}: `{needed}` is missing; `{by}` needs it"))
        };
        let mut given = 0;
        for (value, input, entries) in
            [(SPEED, HARDNESS, &mut self.speeds), (FEED, DIAMETER, &mut self.feeds)]
        {
            if let Some(number) = cells[value] {
                let input = cells[input].ok_or_else(|| missing(input, value))?;
                let engagement = cells[ENGAGEMENT].ok_or_else(|| missing(ENGAGEMENT, value))?;
                entries.push(([input, engagement], number));
                given += 1;
            }
        }
        if given == 0 {
            return Err(fault(format!(
                "line {line}: neither `cutting_speed_m_min` nor `feed_per_tooth_mm` is given"
            )));
        }
        Ok(())
    }
}

/// A system over two inputs needs two different values of each; closer ones than a part in a hundred
/// say nothing of a trend.
fn enough(what: &str, entries: &[Entry]) -> Result<(), SettingError> {
    let differ = |axis: usize| {
        let [low, high] = math::extent(entries.iter().map(|(input, _)| input[axis]));
        high >= 1.01 * low && high.is_finite()
    };
    if differ(0) && differ(1) {
        return Ok(());
    }
    let (count, input) =
        (entries.len(), if what == COLUMNS[SPEED].0[0] { HARDNESS } else { DIAMETER });
    Err(fault(format!(
        "`{what}` is given in {count} rows; needed are at least two values of `{}`, 1 % \
         apart, and two engagements",
        COLUMNS[input].0[0]
    )))
}

/// The synthetic table, the text of the shipped file.
#[must_use]
pub fn synthetic() -> String {
    const SEED: u64 = 1;
    let mut text = HEAD.to_owned();
    let _ = writeln!(text, "{}", COLUMNS.map(|(names, ..)| names[0]).join(","));
    let stream = Stream::new(SEED, "recommend.table");
    let mut draw = 0;
    let mut noisy = |value: f64| {
        draw += 1;
        value * (1.0 + 0.03 * stream.normal(draw))
    };
    for hardness in [125.0, 160.0, 200.0, 250.0, 300.0, 370.0, 450.0] {
        for (class, factor) in EngagementCode::ALL.iter().zip([0.47, 0.56, 1.0, 1.85]) {
            let speed = noisy(100.0 * math::pow(200.0 / hardness, 0.67) * factor);
            let _ = writeln!(text, "{hardness},,{},{speed:.1},", class.id());
        }
    }
    for diameter in [3.0, 4.0, 6.0, 8.0, 10.0, 12.0, 16.0, 20.0] {
        for (class, factor) in EngagementCode::ALL.iter().zip([0.6, 0.95, 1.0, 1.8]) {
            let feed = noisy(0.0265 * math::pow(diameter, 0.44) * factor);
            let _ = writeln!(text, ",{diameter},{},,{feed:.4}", class.id());
        }
    }
    text
}

const HEAD: &str = "\
# Cutting data for steel, to choose recommended conditions from. SYNTHETIC: no row is a maker's.
# `steadycut recommend table --out FILE` makes this file anew, `--check` compares it.
#
# cutting_speed_m_min = 100 (200 / hardness_hb)^0.67 x {0.47, 0.56, 1, 1.85}
# feed_per_tooth_mm   = 0.0265 diameter_mm^0.44 x {0.6, 0.95, 1, 1.8}
# for the engagements 1 slot, 2 heavy side cut, 3 light side cut, 4 finishing; 3 % noise, seed 1.
#
# Source of the form: factors and exponents imitate a maker's table (Sandvik CoroMill Plura, p. D155,
# read as an excerpt: P steel 375 to 160 m/min for 125 to 450 HB; 0.055, 0.09, 0.089, 0.161 mm at a
# diameter of 16 mm). The table that the 2005 paper chose from is not published.
#
# Your own table: the same columns; a row gives a speed for a hardness, a feed for a diameter, or
# both. `steadycut recommend --table FILE` learns it.
";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_shipped_table_is_made_by_its_formulas() {
        assert_eq!(SHIPPED, synthetic());
        let table = Table::shipped();
        assert_eq!([table.speeds.len(), table.feeds.len()], [28, 32]);
        let ([hardness, class], speed) = table.speeds[10];
        assert_eq!([hardness, class], [200.0, 3.0]);
        assert!((speed / 100.0 - 1.0).abs() < 0.1, "{speed}");
    }

    #[test]
    fn faulty_tables_are_refused_by_line_column_and_range() {
        let message = |from: &str, to: &str| {
            let text = SHIPPED.replacen(from, to, 1);
            assert_ne!(text, SHIPPED, "{from}");
            Table::parse(&text).unwrap_err().to_string()
        };
        let text = message("\n125,,1,", "\n12,,1,");
        for part in ["line 15", "`hardness_hb`", "12:", "from 50 to 700"] {
            assert!(text.contains(part), "{part}: {text}");
        }
        assert!(message("\n125,,1,", "\n125,,1.5,").contains("`engagement` cannot be 1.5"));
        assert!(message("\n125,,1,", "\n125,,nan,").contains("`engagement` cannot be nan"));
        assert!(message("\n125,,1,", "\n,125,1,").contains("`diameter_mm` cannot be 125"));
        assert!(message("\n125,,1,", "\n,,1,").contains("`hardness_hb` is missing"));
        assert!(message("\n125,,1,", "\n125,,,").contains("`engagement` is missing"));
        assert!(message("\n125,,1,", "\n125,,1,,\n125,,1,").contains("neither"));
        assert!(message("\n125,,1,", "\n125,1,").contains("line 15 has 4 values for 5 columns"));
        let text = message("hardness_hb,", "hardness,");
        assert!(text.contains("missing are hardness_hb; needed are hardness_hb, dia"), "{text}");
        assert!(Table::parse("").is_err());
        let one = "hardness_hb,diameter_mm,engagement,cutting_speed_m_min,feed_per_tooth_mm\n";
        let text = Table::parse(&format!("{one}200,16,1,100,0.1\n200,10,2,80,0.08\n"));
        assert!(text.unwrap_err().to_string().contains("two values of `hardness_hb`"));
        let rows = "200,16,1,100,0.1\n250,10,2,80,0.08\n";
        assert_eq!(Table::parse(&format!("{one}{rows}")).unwrap().feeds.len(), 2);
        let many = format!("{one}{}", rows.repeat(101));
        assert!(Table::parse(&many).unwrap_err().to_string().contains("at most 200 rows"));
    }
}
