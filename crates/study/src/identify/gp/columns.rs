//! What columns a table offers to a search: their names, units and ranges.

use super::units::by_name;
use crate::base::math;
use crate::csv_table::CsvTable;

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
        let (names, table) = CsvTable::whole(text)?;
        if table.rows.is_empty() {
            return Err("no rows below the names of the columns".to_owned());
        }
        let offered = |(place, name): (usize, &String)| {
            let mut values = Vec::with_capacity(table.rows.len());
            let mut fault = None;
            for row in &table.rows {
                let cell = &row.cells[place];
                match table.number(cell).filter(|value| value.is_finite()) {
                    Some(value) => values.push(value),
                    None => {
                        let line = row.line;
                        fault = Some(format!(
                            "line {line}: `{name}` is `{cell}`: allowed is a finite number"
                        ));
                        break;
                    }
                }
            }
            let range = fault.map_or_else(|| Ok(math::extent(values.into_iter())), Err);
            let unit = by_name(name).map_or_else(String::new, |unit| unit.to_string());
            OfferedColumn { name: name.clone(), unit, range }
        };
        let named = names.iter().enumerate().filter(|(_, name)| !name.is_empty());
        let offered = Self { columns: named.map(offered).collect(), rows: table.rows.len() };
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
