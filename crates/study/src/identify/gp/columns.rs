//! What columns a table offers to a search: their names, units and ranges.

use super::units::by_name;
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
}

impl OfferedTable {
    /// Reads a table.
    ///
    /// # Errors
    /// There is no line with names, no row, fewer than two columns of numbers, or a line does not fit; names the
    /// line and what is allowed.
    pub fn read(text: &str) -> Result<Self, String> {
        let cells = CsvCells::whole(text)?;
        let mut rows = 0;
        let mut ranges: Vec<Result<[f64; 2], String>> =
            vec![Ok([f64::INFINITY, f64::NEG_INFINITY]); cells.names().len()];
        cells.each(|line, column, cell| {
            rows += usize::from(column == 0);
            let Ok([low, high]) = &mut ranges[column] else { return Ok(()) };
            match cells.number(cell).filter(|value| value.is_finite()) {
                Some(value) => [*low, *high] = [low.min(value), high.max(value)],
                None => {
                    let name = &cells.names()[column];
                    let fault =
                        format!("line {line}: `{name}` is `{cell}`: allowed is a finite number");
                    ranges[column] = Err(fault);
                }
            }
            Ok(())
        })?;
        if rows == 0 {
            return Err("no rows below the names of the columns".to_owned());
        }
        let offered = |(name, range): (&String, Result<[f64; 2], String>)| {
            let unit = by_name(name).map_or_else(String::new, |unit| unit.to_string());
            OfferedColumn { name: name.clone(), unit, range }
        };
        let named = cells.names().iter().zip(ranges).filter(|(name, _)| !name.is_empty());
        let offered = Self { columns: named.map(offered).collect(), rows };
        let numbers = offered.columns.iter().filter(|column| column.range.is_ok()).count();
        if numbers < 2 {
            let faults = offered.columns.iter().filter_map(|column| column.range.as_ref().err());
            let first = faults.map(String::as_str).next().unwrap_or("there is one column");
            return Err(format!("a target and an input need two columns of numbers: {first}"));
        }
        Ok(offered)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_told_with_units_ranges_and_what_is_wrong_with_them() {
        let text = "name;force_n;feed_mm_min;;x\na;1,5;300;;1\nb;-2;500;;\n";
        let OfferedTable { columns, rows } = OfferedTable::read(text).unwrap();
        assert_eq!(rows, 2);
        let told: Vec<(&str, &str)> =
            columns.iter().map(|column| (column.name.as_str(), column.unit.as_str())).collect();
        let units = [("name", ""), ("force_n", "N"), ("feed_mm_min", "mm/min"), ("x", "")];
        assert_eq!(told, units);
        assert_eq!(columns[1].range, Ok([-2.0, 1.5]));
        let fault = |place: usize| columns[place].range.clone().unwrap_err();
        assert_eq!(fault(0), "line 2: `name` is `a`: allowed is a finite number");
        assert_eq!(fault(3), "line 3: `x` is ``: allowed is a finite number");
    }

    #[test]
    fn a_table_without_two_columns_of_numbers_is_refused_with_its_first_fault() {
        for (text, part) in [
            ("", "no line with the names"),
            ("a,b\n", "no rows"),
            ("a,b\n1,x\n", "line 2: `b` is `x`"),
            ("a\n1\n", "there is one column"),
            ("a,b\n1,2,3\n", "line 2 has 3 values for 2 columns"),
        ] {
            let said = OfferedTable::read(text).unwrap_err();
            assert!(said.contains(part), "{text}: {said}");
        }
    }
}
