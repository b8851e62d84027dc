//! What columns a table offers to a search: their names, units and ranges.

use super::problem::{FEWEST, too_few};
use super::units::by_name;
use crate::base::language::tr;
use crate::csv_table::CsvCells;

/// A column of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct OfferedColumn {
    /// Its name.
    pub name: String,
    /// The unit that its name ends with, as it is written; empty where it tells none.
    pub unit: String,
    /// Least and largest value, or why it can be neither target nor input.
    pub range: Result<[f64; 2], String>,
}

/// The columns of a table, with the number of its rows.
#[derive(Clone, Debug, PartialEq)]
pub struct OfferedTable {
    /// Those that have a name.
    pub columns: Vec<OfferedColumn>,
    /// Number of rows.
    pub rows: usize,
    /// The cells of the first rows, as they stand in the table, for those columns.
    pub first: Vec<Vec<String>>,
}

/// Rows that are shown of a table, to see that it was read as it is meant.
pub const SHOWN_ROWS: usize = 3;

impl OfferedTable {
    /// Reads a table.
    ///
    /// # Errors
    /// There is no line with names, too few rows, fewer than two columns of numbers, or a line does not fit; names
    /// all that is wrong at once, the lines and what is allowed.
    pub fn read(text: &str) -> Result<Self, String> {
        let cells = CsvCells::whole(text)?;
        let mut rows = 0;
        let mut ranges: Vec<Result<[f64; 2], String>> =
            vec![Ok([f64::INFINITY, f64::NEG_INFINITY]); cells.names().len()];
        let mut first: Vec<Vec<String>> = Vec::new();
        cells.each(|line, column, cell| {
            rows += usize::from(column == 0);
            if rows <= SHOWN_ROWS && !cells.names()[column].is_empty() {
                first.resize(rows, Vec::new());
                first[rows - 1].push(cell.to_owned());
            }
            let Ok([low, high]) = &mut ranges[column] else { return Ok(()) };
            match cells.number(cell).filter(|value| value.is_finite()) {
                Some(value) => [*low, *high] = [low.min(value), high.max(value)],
                None => {
                    let name = &cells.names()[column];
                    let fault = tr!(
                        "line {line}: `{name}` is `{cell}`: allowed is a finite number",
                        line = line,
                        name = name,
                        cell = cell
                    );
                    ranges[column] = Err(fault);
                }
            }
            Ok(())
        })?;
        if rows == 0 {
            return Err(tr("no rows below the names of the columns").to_owned());
        }
        let offered = |(name, range): (&String, Result<[f64; 2], String>)| {
            let unit = by_name(name).map_or_else(String::new, |unit| unit.to_string());
            OfferedColumn { name: name.clone(), unit, range }
        };
        let named = cells.names().iter().zip(ranges).filter(|(name, _)| !name.is_empty());
        let offered = Self { columns: named.map(offered).collect(), rows, first };
        match offered.faults().join("; ") {
            none if none.is_empty() => Ok(offered),
            faults => Err(faults),
        }
    }

    /// All that is wrong with the table as a whole.
    fn faults(&self) -> Vec<String> {
        let mut faults = Vec::new();
        if self.rows < FEWEST {
            faults.push(too_few(self.rows));
        }
        if self.columns.iter().filter(|column| column.range.is_ok()).count() < 2 {
            let of_columns: Vec<&str> = self
                .columns
                .iter()
                .filter_map(|column| column.range.as_ref().err().map(String::as_str))
                .collect();
            let which = match of_columns[..] {
                [] => tr("there is one column").to_owned(),
                [..] => of_columns.join(", "),
            };
            faults.push(tr!(
                "a target and an input need two columns of numbers: {which}",
                which = which
            ));
        }
        faults
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_told_with_units_ranges_and_what_is_wrong_with_them() {
        let more = "c;1;400;;2\n".repeat(3);
        let text = format!("name;force_n;Feed [mm/min];;x\na;1,5;300;;1\nb;-2;500;;\n{more}");
        let OfferedTable { columns, rows, first } = OfferedTable::read(&text).unwrap();
        assert_eq!(rows, 5);
        assert_eq!(first.len(), SHOWN_ROWS);
        assert_eq!(first[1], ["b", "-2", "500", ""]);
        let told: Vec<(&str, &str)> =
            columns.iter().map(|column| (column.name.as_str(), column.unit.as_str())).collect();
        let units = [("name", ""), ("force_n", "N"), ("Feed [mm/min]", "mm/min"), ("x", "")];
        assert_eq!(told, units);
        assert_eq!(columns[1].range, Ok([-2.0, 1.5]));
        let fault = |place: usize| columns[place].range.clone().unwrap_err();
        assert_eq!(fault(0), "line 2: `name` is `a`: allowed is a finite number");
        assert_eq!(fault(3), "line 3: `x` is ``: allowed is a finite number");
    }

    #[test]
    fn a_table_that_does_not_do_is_refused_with_all_that_is_wrong() {
        for (text, parts) in [
            ("", &["no line with the names"][..]),
            ("a,b\n", &["no rows"]),
            ("a,b\ny,x\n", &["1 row: at least 5", "line 2: `a` is `y`", "line 2: `b` is `x`"]),
            ("a\n1\n", &["at least 5", "there is one column"]),
            ("a,b\n1,2,3\n", &["line 2 has 3 values for 2 columns"]),
        ] {
            let said = OfferedTable::read(text).unwrap_err();
            for part in parts {
                assert!(said.contains(part), "{text}: {said}");
            }
        }
    }
}
