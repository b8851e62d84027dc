//! The values of a text, row by row: the hot loop of reading.

use super::cells::{bare, cell_end};
use super::clock::clock;
use super::guess::{Holds, Writing};
use super::number::leading;
use crate::base::language::{text, tr};
use crate::fault::{DataFault, FaultPlace, shown};
use crate::layout::{DecimalMark, FieldSeparator, ThousandsMark};

/// What rows are read as.
pub(super) struct RowPlan<'a> {
    pub writing: Writing,
    /// Names of the columns, for faults.
    pub names: &'a [String],
    /// What stands in the columns.
    pub holds: &'a [Holds],
    /// Number of the first line, from 1.
    pub first_line: u64,
}

/// The values of the rows.
pub(super) struct Rows {
    pub columns: Vec<Vec<f64>>,
    /// The last line, if it broke off before its end and was left out.
    pub broken_off: Option<u64>,
}

impl RowPlan<'_> {
    /// Reads the rows of a text that begins with the first of them; empty lines are left out.
    ///
    /// # Errors
    /// Names the line, the column, and what is no number or one too many.
    pub fn read(&self, text: &str) -> Result<Rows, DataFault> {
        let bytes = text.as_bytes();
        let longest =
            bytes.iter().take(1 << 16).position(|byte| *byte == b'\n').unwrap_or(bytes.len());
        // No more than the file has room for, even if its first line is short.
        let rows = (bytes.len() / longest.max(1)).min(bytes.len() / self.names.len().max(1)) + 1;
        let mut columns: Vec<Vec<f64>> = self
            .holds
            .iter()
            .map(|holds| Vec::with_capacity(if *holds == Holds::Words { 0 } else { rows }))
            .collect();
        let (mut at, mut line) = (0, self.first_line);
        while at < bytes.len() {
            let start = at;
            if !self.row(text, &mut at, line, &mut columns)? {
                // A row that is too short: told, unless it is the last one, and the file ends within it.
                let fault = |found| {
                    let expected = tr!("{count} values", count = self.names.len());
                    DataFault::new(FaultPlace::Line(line), found, expected)
                };
                if at < bytes.len() || bytes.ends_with(b"\n") {
                    let cells = super::cells::cells(&text[start..at], self.writing.separator).len();
                    return Err(fault(tr!("{count} values", count = cells)));
                }
                let whole =
                    columns.iter().zip(self.holds).filter(|(_, holds)| **holds != Holds::Words);
                let whole = whole.map(|(column, _)| column.len()).min().unwrap_or(0);
                columns.iter_mut().for_each(|column| column.truncate(whole));
                return Ok(Rows { columns, broken_off: Some(line) });
            }
            line += 1;
        }
        Ok(Rows { columns, broken_off: None })
    }

    /// Reads a line and goes to the next; whether it had all columns or none.
    #[inline]
    fn row(
        &self,
        text: &str,
        at: &mut usize,
        line: u64,
        columns: &mut [Vec<f64>],
    ) -> Result<bool, DataFault> {
        let bytes = text.as_bytes();
        let separator = self.writing.separator;
        let decimal = self.writing.decimal.byte();
        let plain = self.writing.thousands == ThousandsMark::None && !self.writing.is_one_sign();
        let is_blank = |byte: Option<&u8>| match byte {
            Some(b' ') => true,
            Some(b'\t') => separator == FieldSeparator::Blank,
            Some(_) | None => false,
        };
        let mut column = 0;
        loop {
            while is_blank(bytes.get(*at)) {
                *at += 1;
            }
            // A plain number, and behind it a separator or the end of the line.
            if plain
                && let Some((value, used)) = leading(&bytes[*at..], decimal)
                && let Some(values) = columns.get_mut(column)
                && self.holds[column] == Holds::Numbers
            {
                let mut end = *at + used;
                let blank = is_blank(bytes.get(end));
                while is_blank(bytes.get(end)) {
                    end += 1;
                }
                let ended = match bytes.get(end) {
                    Some(b'\n') => Some(end + 1),
                    Some(b'\r') if bytes.get(end + 1) == Some(&b'\n') => Some(end + 2),
                    None => Some(end),
                    Some(_) => None,
                };
                if let Some(next) = ended {
                    values.push(value);
                    *at = next;
                    return Ok(column + 1 == columns.len());
                }
                let next = match separator {
                    FieldSeparator::Blank => blank.then_some(end),
                    FieldSeparator::Tab | FieldSeparator::Semicolon | FieldSeparator::Comma => {
                        separator.is(bytes[end]).then_some(end + 1)
                    }
                };
                if let Some(next) = next {
                    values.push(value);
                    *at = next;
                    column += 1;
                    continue;
                }
            }
            // Anything else: one cell of the rest of the line.
            let rest = bytes[*at..].iter().position(|byte| *byte == b'\n');
            let line_end = rest.map_or(bytes.len(), |length| *at + length);
            let this = &bytes[*at..line_end];
            let this = this.strip_suffix(b"\r").unwrap_or(this);
            if column == 0 && text[*at..*at + this.len()].trim().is_empty() {
                *at = (line_end + 1).min(bytes.len());
                return Ok(true);
            }
            let (end, next) = cell_end(this, 0, separator);
            self.cell(bare(&text[*at..*at + end]), line, column, columns)?;
            column += 1;
            match next {
                Some(next) => *at += next,
                None => {
                    *at = (line_end + 1).min(bytes.len());
                    return Ok(column >= columns.len());
                }
            }
        }
    }

    /// A cell that is no plain number.
    fn cell(
        &self,
        cell: &str,
        line: u64,
        column: usize,
        columns: &mut [Vec<f64>],
    ) -> Result<(), DataFault> {
        let Some(values) = columns.get_mut(column) else {
            // Spreadsheets end lines with separators of columns that are not there.
            if cell.is_empty() {
                return Ok(());
            }
            let found = tr!("the value {value}", value = shown(cell));
            let expected = tr!("no more than {count} values", count = columns.len());
            return Err(DataFault::new(FaultPlace::Line(line), found, expected));
        };
        let (value, expected) = match self.holds[column] {
            Holds::Words => return Ok(()),
            Holds::Clock if cell.is_empty() => (Some(f64::NAN), String::new()),
            Holds::Clock => (clock(cell), tr("a date, a time of day, or both").to_owned()),
            Holds::Numbers => (self.writing.number(cell), self.expected()),
        };
        let value = value.ok_or_else(|| {
            let name = self.names[column].clone();
            let place = FaultPlace::Cell { line, column: column + 1, name };
            DataFault::new(place, shown(cell), expected)
        })?;
        values.push(value);
        Ok(())
    }

    /// What a cell is to hold.
    fn expected(&self) -> String {
        let decimal = match self.writing.decimal {
            DecimalMark::Point => text!("a number with a decimal point, or nothing"),
            DecimalMark::Comma => text!("a number with a decimal comma, or nothing"),
        };
        match self.writing.thousands {
            ThousandsMark::None => tr(decimal).to_owned(),
            ThousandsMark::Point
            | ThousandsMark::Comma
            | ThousandsMark::Blank
            | ThousandsMark::Apostrophe => tr!(
                "{number}, thousands parted by {sign}",
                number = tr(decimal),
                sign = self.writing.thousands.id()
            ),
        }
    }
}
