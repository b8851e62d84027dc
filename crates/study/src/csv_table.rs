//! Tables that people bring, as CSV the way spreadsheets of any country write them: separated by commas,
//! semicolons or tabs, with decimal points or decimal commas, columns in any order. What could be read in
//! two ways is refused.

use crate::base::language::tr;

/// Longest piece of a table that a message shows, characters.
const MAX_SHOWN: usize = 40;
/// Longest list of columns that a message shows, characters.
const MAX_LIST: usize = 200;

/// A column that a table must have: its name, and other names that it may have.
pub type ColumnNames<'a> = &'a [&'a str];

/// A table: the cells of the columns asked for, in their order.
#[derive(Clone, Debug, PartialEq)]
pub struct CsvTable {
    /// Its rows.
    pub rows: Vec<CsvRow>,
    separator: u8,
    commas: bool,
}

/// A row of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct CsvRow {
    /// Its line in the file, from 1.
    pub line: u64,
    /// The cells, without spaces around them.
    pub cells: Vec<String>,
}

fn shown(text: &str, most: usize) -> String {
    let short: String = text.chars().take(most).collect();
    if short.len() < text.len() { format!("{short}...") } else { short }
}

/// The separator, and the text without the line by which some spreadsheets tell it.
fn separated(text: &str) -> (u8, &str) {
    for (mark, separator) in [("sep=,", b','), ("sep=;", b';'), ("sep=\t", b'\t')] {
        if let Some(rest) = text.strip_prefix(mark) {
            return (separator, rest);
        }
    }
    let header = text.lines().find(|line| !line.trim().is_empty() && !line.starts_with('#'));
    let count = |separator: char| header.map_or(0, |header| header.matches(separator).count());
    let (commas, semicolons, tabs) = (count(','), count(';'), count('\t'));
    let separator = if semicolons > commas.max(tabs) {
        b';'
    } else if tabs > commas.max(semicolons) {
        b'\t'
    } else {
        b','
    };
    (separator, text)
}

/// Whether a cell is a number with a decimal comma, or with commas between thousands.
fn has_comma(cell: &str) -> bool {
    cell.contains(',') && cell.chars().all(|c| c.is_ascii_digit() || ",.+-eE".contains(c))
}

/// The cells of a table as they stand in its text, read one after the other: what is kept of them is up to the reader.
#[derive(Clone, Debug)]
pub struct CsvCells<'a> {
    text: &'a str,
    separator: u8,
    places: Vec<usize>,
    names: Vec<String>,
    commas: bool,
}

impl<'a> CsvCells<'a> {
    /// Looks through a table for some columns; `#` begins a comment line, rows without any value are left out.
    ///
    /// # Errors
    /// Names the columns found and those that are missing, or the line that does not fit them.
    pub fn of(text: &'a str, columns: &[ColumnNames<'_>]) -> Result<Self, String> {
        Self::read(text, |header| places(header, columns))
    }

    /// Looks through a table for all of its columns.
    ///
    /// # Errors
    /// There is no header, or a line does not fit it.
    pub fn whole(text: &'a str) -> Result<Self, String> {
        Self::read(text, |header| {
            // Spreadsheets end a line with separators of columns that are not there.
            let last = (0..header.len()).rfind(|place| !header[*place].is_empty());
            let last = last.ok_or_else(|| tr("there is no line with the names of the columns"))?;
            Ok((0..=last).collect())
        })
    }

    fn read(
        text: &'a str,
        places: impl Fn(&csv::StringRecord) -> Result<Vec<usize>, String>,
    ) -> Result<Self, String> {
        let (separator, text) = separated(text);
        let header = reader(separator, text).headers().map_err(|error| error.to_string())?.clone();
        let places = places(&header)?;
        let names = places.iter().map(|place| header[*place].to_owned()).collect();
        let mut cells = Self { text, separator, places, names, commas: false };
        let mut signs = Signs::default();
        cells.each(|line, _, cell| {
            signs.see(line, cell);
            Ok(())
        })?;
        cells.commas = signs.commas(separator)?;
        Ok(cells)
    }

    /// Names of the columns, as the header has them.
    #[must_use]
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// Hands out every cell, row by row, with its line in the file and the number of its column.
    ///
    /// # Errors
    /// What `see` refuses, or a line does not fit the header.
    pub fn each(
        &self,
        mut see: impl FnMut(u64, usize, &str) -> Result<(), String>,
    ) -> Result<(), String> {
        let mut reader = reader(self.separator, self.text);
        let columns = reader.headers().map_err(|error| error.to_string())?.len();
        let mut record = csv::StringRecord::new();
        while reader.read_record(&mut record).map_err(|error| error.to_string())? {
            let line = record.position().map_or(0, csv::Position::line);
            if record.iter().all(str::is_empty) {
                continue;
            }
            self.fits(line, &record, columns)?;
            for (column, place) in self.places.iter().enumerate() {
                see(line, column, &record[*place])?;
            }
        }
        Ok(())
    }

    /// Spreadsheets fill rows up with empty cells; any other cell needs its column.
    fn fits(&self, line: u64, record: &csv::StringRecord, columns: usize) -> Result<(), String> {
        let values = record.len();
        if values == columns || values > columns && record.iter().skip(columns).all(str::is_empty) {
            return Ok(());
        }
        Err(match self.separator {
            b',' if values > columns => tr!(
                "line {line} has {values} values for {columns} columns; numbers with decimal commas need semicolons \
                 between them, as in `0,5;1,2`",
                line = line,
                values = values,
                columns = columns
            ),
            _ => tr!(
                "line {line} has {values} values for {columns} columns",
                line = line,
                values = values,
                columns = columns
            ),
        })
    }

    /// The number in a cell.
    #[must_use]
    pub fn number(&self, cell: &str) -> Option<f64> {
        number(cell, self.commas)
    }

    /// The columns as numbers.
    ///
    /// # Errors
    /// Names the line, column and cell that is no finite number.
    pub fn numbers(&self) -> Result<Vec<Vec<f64>>, String> {
        let mut columns = vec![Vec::new(); self.places.len()];
        self.each(|line, column, cell| {
            let value = self.number(cell).filter(|value| value.is_finite()).ok_or_else(|| {
                let name = &self.names[column];
                tr!(
                    "line {line}: `{name}` is `{cell}`: allowed is a finite number",
                    line = line,
                    name = name,
                    cell = cell
                )
            })?;
            columns[column].push(value);
            Ok(())
        })?;
        columns.iter_mut().for_each(Vec::shrink_to_fit);
        Ok(columns)
    }
}

fn reader(separator: u8, text: &str) -> csv::Reader<&[u8]> {
    csv::ReaderBuilder::new()
        .delimiter(separator)
        .comment(Some(b'#'))
        .trim(csv::Trim::All)
        .flexible(true)
        .from_reader(text.as_bytes())
}

fn number(cell: &str, commas: bool) -> Option<f64> {
    if commas { cell.replace(',', ".").parse().ok() } else { cell.parse().ok() }
}

/// Decimal signs seen, each with its line.
#[derive(Default)]
struct Signs {
    comma: Option<(u64, String)>,
    point: Option<(u64, String)>,
    /// Several commas in one cell.
    twice: Option<(u64, String)>,
}

impl Signs {
    fn see(&mut self, line: u64, cell: &str) {
        let comma = has_comma(cell);
        let here = || (line, shown(cell, MAX_SHOWN));
        if comma {
            self.comma.get_or_insert_with(here);
            if cell.matches(',').count() > 1 {
                self.twice.get_or_insert_with(here);
            }
        }
        if self.point.is_none() && cell.contains('.') && (comma || cell.parse::<f64>().is_ok()) {
            self.point = Some(here());
        }
    }

    /// Whether the table has decimal commas; it has points or commas: with both, one of them may mean thousands.
    fn commas(self, separator: u8) -> Result<bool, String> {
        let Some((line, comma)) = self.comma else { return Ok(false) };
        if separator == b',' {
            return Err(tr!(
                "line {line}: `{comma}` has a comma, which separates the values of this table: write a decimal \
                 point, or separate the values by semicolons",
                line = line,
                comma = comma
            ));
        }
        match self.point.or(self.twice) {
            None => Ok(true),
            Some((other, cell)) => Err(tr!(
                "line {line} has `{comma}`, line {other} `{cell}`: write all numbers with the same decimal \
                 sign, and nothing between thousands",
                line = line,
                comma = comma,
                other = other,
                cell = cell
            )),
        }
    }
}

impl CsvTable {
    /// Reads the table; `#` begins a comment line, rows without any value are left out.
    ///
    /// # Errors
    /// Names the columns found and those that are missing, or the line that does not fit them.
    pub fn parse(text: &str, columns: &[ColumnNames<'_>]) -> Result<Self, String> {
        Self::kept(&CsvCells::of(text, columns)?)
    }

    /// Reads all of its columns, with the names in its header.
    ///
    /// # Errors
    /// There is no header, or a line does not fit it.
    pub fn whole(text: &str) -> Result<(Vec<String>, Self), String> {
        let cells = CsvCells::whole(text)?;
        Ok((cells.names.clone(), Self::kept(&cells)?))
    }

    fn kept(cells: &CsvCells<'_>) -> Result<Self, String> {
        let mut rows: Vec<CsvRow> = Vec::new();
        cells.each(|line, column, cell| {
            if column == 0 {
                rows.push(CsvRow { line, cells: Vec::with_capacity(cells.places.len()) });
            }
            if let Some(row) = rows.last_mut() {
                row.cells.push(cell.to_owned());
            }
            Ok(())
        })?;
        Ok(Self { rows, separator: cells.separator, commas: cells.commas })
    }

    /// What separates its values.
    #[must_use]
    pub fn separator(&self) -> u8 {
        self.separator
    }

    /// A number with the decimal sign of the table.
    #[must_use]
    pub fn text(&self, x: f64) -> String {
        let text = format!("{x}");
        if self.commas { text.replace('.', ",") } else { text }
    }

    /// The number in a cell.
    #[must_use]
    pub fn number(&self, cell: &str) -> Option<f64> {
        number(cell, self.commas)
    }
}

/// Where the columns stand in the header.
fn places(header: &csv::StringRecord, columns: &[ColumnNames<'_>]) -> Result<Vec<usize>, String> {
    let place = |names: &ColumnNames<'_>| header.iter().position(|name| names.contains(&name));
    let list = |columns: &mut dyn Iterator<Item = &ColumnNames<'_>>| {
        columns.map(|names| names.join(tr(" or "))).collect::<Vec<_>>().join(", ")
    };
    let missing = list(&mut columns.iter().filter(|names| place(names).is_none()));
    if !missing.is_empty() {
        let found: Vec<&str> = header.iter().filter(|name| !name.is_empty()).collect();
        let needed = list(&mut columns.iter());
        return Err(match found.is_empty() {
            true => tr!(
                "there is no line with the names of the columns; needed are {needed}",
                needed = needed
            ),
            false => tr!(
                "the columns are {found}; missing are {missing}; needed are {needed}",
                found = shown(&found.join(", "), MAX_LIST),
                missing = missing,
                needed = needed
            ),
        });
    }
    for names in columns {
        if header.iter().filter(|name| names.contains(name)).count() > 1 {
            return Err(tr!(
                "the column {name} stands there more than once",
                name = names.join(tr(" or "))
            ));
        }
    }
    Ok(columns.iter().filter_map(place).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    const COLUMNS: [ColumnNames<'static>; 2] = [&["speed"], &["force", "load"]];

    fn numbers(text: &str) -> Result<Vec<Vec<Option<f64>>>, String> {
        let table = CsvTable::parse(text, &COLUMNS)?;
        let row = |row: &CsvRow| row.cells.iter().map(|cell| table.number(cell)).collect();
        Ok(table.rows.iter().map(row).collect())
    }

    #[test]
    fn tables_of_any_country_are_read_as_they_are_meant() {
        let meant = Ok(vec![vec![Some(0.5), Some(1200.0)], vec![Some(2.25), None]]);
        for text in [
            "speed,force\n0.5,1200\n2.25,\n",
            "# a note; with, signs\nspeed;load\r\n0,5;1200\r\n2,25;\r\n",
            "sep=;\r\nspeed;force\r\n0.5;1200\r\n2.25;\r\n",
            "speed\tforce\n0,5\t1200\n2,25\t\n",
            "\nforce;name;speed;;\n1200;a, b.;0,5;;\n;\"c;d\";2,25;;\n;;;;\n",
            "speed;force\n\"0,5\";\"1200\"\n\"2,25\";\"\"\n",
        ] {
            assert_eq!(numbers(text), meant, "{text}");
        }
    }

    #[test]
    fn what_could_be_read_in_two_ways_is_refused() {
        for (text, parts) in [
            ("speed,force\n0,5,1200\n", ["line 2 has 3 values for 2 columns", "semicolons"]),
            ("speed,force\n\"0,5\",1200\n", ["line 2: `0,5`", "decimal point"]),
            ("speed;force\n0,5;1.200\n", ["`0,5`, line 2 `1.200`", "same decimal sign"]),
            ("speed;force\n0,5;1\n1.200,5;2\n", ["line 3 `1.200,5`", "thousands"]),
            ("speed;force\n0,5;1\n1,200,000;2\n", ["line 3 `1,200,000`", "thousands"]),
            ("speed;force\n0,5\n", ["line 2 has 1 values for 2 columns", ""]),
            ("speed;force\n0,5;1;2\n", ["line 2 has 3 values for 2 columns", ""]),
            ("speed;force;load\n", ["force or load", "more than once"]),
        ] {
            let error = numbers(text).unwrap_err();
            for part in parts {
                assert!(error.contains(part), "{part}: {error}");
            }
        }
    }

    #[test]
    fn missing_columns_are_named_beside_those_found() {
        let error = numbers("Speed;force\n1;2\n").unwrap_err();
        let needed = "missing are speed; needed are speed, force or load";
        assert_eq!(error, format!("the columns are Speed, force; {needed}"));
        for text in ["", "\n\n", "# nothing\n"] {
            let error = numbers(text).unwrap_err();
            assert!(error.contains("no line with the names") && error.contains("speed, force"));
        }
        let long = format!("{}\n1\n", "x".repeat(1000));
        assert!(numbers(&long).unwrap_err().len() < 400);
    }
}
