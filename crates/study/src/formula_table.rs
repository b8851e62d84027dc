//! A formula on a table: every row with what the formula makes of it.

use crate::csv_table::{CsvRow, CsvTable};
use crate::models::Valued;

/// Name of the column with the formula's values.
pub const PREDICTED: &str = "predicted";
/// Name of the column that marks rows outside the formula's ranges.
pub const EXTRAPOLATED: &str = "extrapolated";

/// Names of the columns with the ends of the 95 % band.
pub const BAND: [&str; 2] = ["low", "high"];

/// Half the width of a formula's band at a place.
pub type HalfWidth<'a> = &'a dyn Fn(&[f64]) -> Option<f64>;

/// What is put beside the formula's values.
#[derive(Clone, Copy, Default)]
pub struct Beside<'a> {
    /// Whether the formula has ranges, and rows outside them are marked in a column of their own.
    pub marked: bool,
    /// The 95 % band in which its true values lie, in two columns; none outside the ranges.
    pub band: Option<HalfWidth<'a>>,
}

impl Beside<'_> {
    /// Names of the new columns.
    fn columns(&self) -> Vec<&'static str> {
        let band = if self.band.is_some() { &BAND[..] } else { &[] };
        let marked = self.marked.then_some(EXTRAPOLATED);
        [PREDICTED].into_iter().chain(band.iter().copied()).chain(marked).collect()
    }
}

/// A table with the values of a formula.
#[derive(Clone, Debug)]
pub struct PredictedTable {
    header: Vec<String>,
    table: CsvTable,
    new: Vec<&'static str>,
    /// The values, a row each; NaN where the formula has none.
    pub values: Vec<Valued>,
    /// The ends of the band, a row each, where it is asked for; none where there is no band.
    pub bands: Option<Vec<Option<[f64; 2]>>>,
}

/// How far the values are from what the table says they should be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PredictionErrors {
    /// Rows that have both.
    pub rows: usize,
    /// Root of the mean square.
    pub rms: f64,
    /// Largest magnitude.
    pub worst: f64,
}

impl PredictedTable {
    /// Evaluates a formula with these inputs on a table whose columns have their names.
    ///
    /// # Errors
    /// Names the column that is missing or stands there twice, the line and value that is no number, or a
    /// column that has the name of the new one.
    pub fn new(
        text: &str,
        inputs: &[String],
        beside: Beside<'_>,
        at: impl Fn(&[f64]) -> Valued,
    ) -> Result<Self, String> {
        let (header, table) = CsvTable::whole(text)?;
        let mut places = Vec::new();
        for input in inputs {
            let mut found = (0..header.len()).filter(|place| header[*place] == *input);
            let Some(place) = found.next() else {
                let columns = header.join(", ");
                return Err(format!("there is no column `{input}`: the columns are {columns}"));
            };
            if found.next().is_some() {
                return Err(format!("the column `{input}` stands there more than once"));
            }
            places.push(place);
        }
        let new = beside.columns();
        if let Some(name) = header.iter().find(|name| new.contains(&name.as_str())) {
            return Err(format!("there is a column `{name}` already, the name of the result"));
        }
        let value = |row: &CsvRow| {
            let number = |place: &usize| {
                let cell = &row.cells[*place];
                let number = table.number(cell).filter(|x| x.is_finite());
                number.ok_or_else(|| {
                    let (line, name) = (row.line, &header[*place]);
                    format!("line {line}: `{name}` cannot be `{cell}`: allowed is a number")
                })
            };
            let inputs: Vec<f64> = places.iter().map(number).collect::<Result<_, String>>()?;
            let value = at(&inputs);
            let half = beside.band.filter(|_| value.valid).and_then(|band| band(&inputs));
            let band = half.map(|half| [value.value - half, value.value + half]);
            Ok((value, band))
        };
        let found: Vec<(Valued, Option<[f64; 2]>)> =
            table.rows.iter().map(value).collect::<Result<_, String>>()?;
        let (values, bands): (Vec<Valued>, Vec<Option<[f64; 2]>>) = found.into_iter().unzip();
        let bands = beside.band.is_some().then_some(bands);
        Ok(Self { header, table, new, values, bands })
    }

    /// The number of rows outside the formula's ranges.
    #[must_use]
    pub fn outside(&self) -> usize {
        self.values.iter().filter(|value| !value.valid).count()
    }

    /// The number of rows for which the formula has no finite value.
    #[must_use]
    pub fn without_value(&self) -> usize {
        self.values.iter().filter(|value| !value.value.is_finite()).count()
    }

    /// How far the values are from those of a column; none where there is no such column, or no number in it.
    #[must_use]
    pub fn errors(&self, column: &str) -> Option<PredictionErrors> {
        let place = self.header.iter().position(|name| name == column)?;
        let pairs = self.table.rows.iter().zip(&self.values);
        let errors: Vec<f64> = pairs
            .filter_map(|(row, value)| Some(value.value - self.table.number(&row.cells[place])?))
            .filter(|error| error.is_finite())
            .collect();
        let rows = errors.len();
        let rms = (errors.iter().map(|error| error * error).sum::<f64>() / rows as f64).sqrt();
        let worst = errors.iter().fold(0.0, |worst: f64, error| worst.max(error.abs()));
        (rows > 0).then_some(PredictionErrors { rows, rms, worst })
    }

    /// The table as CSV with its own separator and decimal sign: all of its columns and the new ones. Where the
    /// formula has no finite value, the cell is empty.
    ///
    /// # Errors
    /// The table cannot be written.
    pub fn csv(&self) -> Result<String, String> {
        let mut writer =
            csv::WriterBuilder::new().delimiter(self.table.separator()).from_writer(Vec::new());
        let mut header: Vec<&str> = self.header.iter().map(String::as_str).collect();
        header.extend(&self.new);
        let failed = |error: csv::Error| error.to_string();
        writer.write_record(&header).map_err(failed)?;
        let number = |x: f64| if x.is_finite() { self.table.text(x) } else { String::new() };
        for (place, (row, value)) in self.table.rows.iter().zip(&self.values).enumerate() {
            let mut cells = row.cells.clone();
            let band = self.bands.as_ref().and_then(|bands| bands.get(place).copied().flatten());
            let [low, high] = band.unwrap_or([f64::NAN; 2]);
            for column in &self.new {
                cells.push(match *column {
                    PREDICTED => number(value.value),
                    EXTRAPOLATED => if value.valid { "no" } else { "yes" }.to_owned(),
                    other => number(if other == BAND[0] { low } else { high }),
                });
            }
            writer.write_record(&cells).map_err(failed)?;
        }
        let bytes = writer.into_inner().map_err(|error| error.to_string())?;
        String::from_utf8(bytes).map_err(|error| error.to_string())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::formula::Formula;

    fn table(text: &str) -> Result<PredictedTable, String> {
        let formula = Formula::parse("2 * a - ln(b)", &["a", "b"]).unwrap();
        let beside = Beside { marked: true, band: None };
        PredictedTable::new(text, formula.inputs(), beside, |at| {
            Valued::new(formula.value(at), at[0] < 2.0)
        })
    }

    #[test]
    fn all_columns_stay_and_the_formula_s_come_behind_them() {
        let made = table("name;b;a;y\n\"x;1\";1;0,5;1,5\nz;1;3;\n;0;1;2\n").unwrap();
        assert_eq!((made.outside(), made.without_value()), (1, 1));
        let expected =
            "name;b;a;y;predicted;extrapolated\n\"x;1\";1;0,5;1,5;1;no\nz;1;3;;6;yes\n;0;1;2;;no\n";
        assert_eq!(made.csv().unwrap(), expected);
        assert_eq!(made.errors("y"), Some(PredictionErrors { rows: 1, rms: 0.5, worst: 0.5 }));
        assert_eq!(made.errors("name"), None);
        let again = table("a,b\n0.1,2\n").unwrap().csv().unwrap();
        let value: f64 = again.lines().nth(1).unwrap().split(',').nth(2).unwrap().parse().unwrap();
        assert_eq!(value, 0.2 - crate::base::math::ln(2.0), "to the bit");
    }

    #[test]
    fn a_band_stands_beside_the_values_within_the_ranges() {
        let half = |at: &[f64]| (at[0] > 0.0).then(|| 0.5 * at[0]);
        let beside = Beside { marked: true, band: Some(&half) };
        let names = ["a".to_owned()];
        let of = |text: &str| {
            PredictedTable::new(text, &names, beside, |at| Valued::new(2.0 * at[0], at[0] < 2.0))
        };
        let made = of("a\n1\n0\n3\n").unwrap().csv().unwrap();
        let expected = "a,predicted,low,high,extrapolated\n1,2,1.5,2.5,no\n0,0,,,no\n3,6,,,yes\n";
        assert_eq!(made, expected);
        assert!(of("a,low\n1,2\n").unwrap_err().contains("a column `low` already"));
    }

    #[test]
    fn a_table_that_does_not_fit_is_told() {
        for (text, part) in [
            ("a,c\n1,2\n", "no column `b`: the columns are a, c"),
            ("a,b,a\n1,2,3\n", "`a` stands there more than once"),
            ("a,b\n1,x\n", "line 2: `b` cannot be `x`"),
            ("a,b\n1,\n", "line 2: `b` cannot be ``"),
            ("a,b,predicted\n1,2,3\n", "a column `predicted` already"),
            ("\n", "no line with the names"),
        ] {
            let error = table(text).unwrap_err();
            assert!(error.contains(part), "{text}: {error}");
        }
    }
}
