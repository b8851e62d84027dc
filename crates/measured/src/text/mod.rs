//! Text: lines of values, with or without names and units above them.
//!
//! [`guess`] finds what the values are written with, [`head`] what stands above them, [`rows`] reads them.

mod cells;
mod clock;
mod encoding;
mod guess;
mod head;
mod number;
mod rows;

use crate::assemble::{RawColumn, unnamed};
use crate::base::language::tr;
use crate::channel::SampleTimes;
use crate::fault::{DataFault, FaultPlace, shown};
use crate::layout::{DataLayout, FieldSeparator};
use crate::reader::RawData;
use cells::MAX_COLUMNS;
use guess::{Guess, HEAD_LINES, Holds, Writing, guess};
use rows::{RowPlan, Rows};

/// Reads a text; the layout then says as what.
///
/// # Errors
/// Names line, column, what stands there and what was expected.
pub(crate) fn read(bytes: &[u8], layout: &mut DataLayout) -> Result<RawData, DataFault> {
    let (text, encoding) = encoding::decode(bytes, layout.encoding)?;
    layout.encoding = Some(encoding);
    let text: &str = &text;
    separator_told(text, layout);
    let skipped =
        layout.first_line.map_or(0, |line| usize::try_from(line - 1).unwrap_or(usize::MAX));
    let mut head: Vec<&str> = text.lines().take(HEAD_LINES.saturating_add(skipped)).collect();
    let from = match (layout.first_line, layout.names_line, layout.units_line) {
        (Some(_), _, _) => skipped,
        (None, names, units) => {
            usize::try_from(names.unwrap_or(0).max(units.unwrap_or(0))).unwrap_or(usize::MAX)
        }
    };
    let found = guess(text, &head, from, layout).ok_or_else(|| no_values(text, &head, from))?;
    let Guess { writing, columns, first, holds, doubt } = found;
    let first = if layout.first_line.is_some() { skipped } else { first };
    if columns > MAX_COLUMNS {
        let found = tr!("more than {most} values", most = MAX_COLUMNS);
        let place = FaultPlace::Line(first as u64 + 1);
        return Err(DataFault::new(
            place,
            found,
            tr!("at most {most} columns", most = MAX_COLUMNS),
        ));
    }
    head.truncate(first);
    let mut notes = Vec::new();
    if let Some(other) = doubt {
        notes.push(tr!(
            "the values may also be meant with separator={separator} decimal={decimal}",
            separator = other.separator.id(),
            decimal = other.decimal.id()
        ));
    }
    let titles = Titles::of(&head, writing, columns, layout)?;
    let facts = head::facts(&head[..titles.top.min(head.len())]);
    let start = line_start(text, first);
    let names: Vec<String> = titles.columns.iter().map(|(name, _, _)| name.clone()).collect();
    let plan = RowPlan { writing, names: &names, holds: &holds, first_line: first as u64 + 1 };
    let Rows { columns: values, broken_off } = plan.read(&text[start..])?;
    if let Some(line) = broken_off {
        notes.push(tr!("line {line} breaks off and was left out", line = line));
    }
    let mut kept = Vec::new();
    let all = titles.columns.into_iter().zip(values).zip(holds);
    for (((name, mut unit, named), mut values), holds) in all {
        match holds {
            Holds::Words => {
                notes.push(tr!("`{name}` holds no numbers and was left out", name = name));
                continue;
            }
            Holds::Clock => {
                // Since the first: what day it was, nothing here asks.
                let first_s = values.iter().copied().find(|x| !x.is_nan()).unwrap_or(0.0);
                values.iter_mut().for_each(|time_s| *time_s -= first_s);
                "s".clone_into(&mut unit);
            }
            Holds::Numbers => {}
        }
        if named || values.iter().any(|x| !x.is_nan()) {
            kept.push(RawColumn { name, unit, values, times: SampleTimes::Unknown, named });
        }
    }
    layout.separator = Some(writing.separator);
    layout.decimal = Some(writing.decimal);
    layout.thousands = Some(writing.thousands);
    layout.first_line = Some(first as u64 + 1);
    layout.names_line = Some(titles.names_line);
    layout.units_line = Some(titles.units_line);
    let rate_hz = head::rate_hz(&facts);
    Ok(RawData { columns: kept, rate_hz, entries: Vec::new(), facts, notes })
}

/// Spreadsheets tell the separator in a line of its own.
fn separator_told(text: &str, layout: &mut DataLayout) {
    let told = match text.lines().next() {
        Some("sep=;") => Some(FieldSeparator::Semicolon),
        Some("sep=,") => Some(FieldSeparator::Comma),
        Some("sep=\t") => Some(FieldSeparator::Tab),
        Some(_) | None => None,
    };
    layout.separator = layout.separator.or(told);
}

/// The byte at which a line begins, counted from 0.
fn line_start(text: &str, index: usize) -> usize {
    text.split_inclusive('\n').take(index).map(str::len).sum()
}

/// That no line has values: the first that could have is shown.
fn no_values(text: &str, head: &[&str], from: usize) -> DataFault {
    let index = (from..head.len()).find(|index| !head[*index].trim().is_empty());
    let expected = tr("lines of numbers, separated by tabs, semicolons, commas or blanks");
    match index {
        Some(index) => {
            let place = FaultPlace::Line(index as u64 + 1);
            let found = tr!("no line with numbers from here on: {line}", line = shown(head[index]));
            DataFault::new(place, found, expected)
        }
        None => {
            let found = tr!("the text ends after {count} lines", count = text.lines().count());
            DataFault::of_file(found, expected)
        }
    }
}

/// Names and units above the values.
struct Titles {
    /// Name, unit, and whether the name is the file's, of every column.
    columns: Vec<(String, String, bool)>,
    /// Their lines, from 1; 0 for none.
    names_line: u64,
    units_line: u64,
    /// Index of the first line that belongs to them.
    top: usize,
}

impl Titles {
    fn of(
        head: &[&str],
        writing: Writing,
        columns: usize,
        said: &DataLayout,
    ) -> Result<Self, DataFault> {
        let cells_of = |index: usize| head::header(head[index], writing, columns);
        let mut above = (0..head.len()).rev().filter(|index| !head[*index].trim().is_empty());
        let lowest = above.next();
        let second = above.next();
        let told = |line: Option<u64>, key: &str| match line {
            None => Ok(None),
            Some(0) => Ok(Some(None)),
            Some(line) => {
                match usize::try_from(line - 1).ok().filter(|index| *index < head.len()) {
                    Some(index) => Ok(Some(Some(index))),
                    None => Err(DataFault::of_file(
                        tr!("`{key}` is {line}", key = key, line = line),
                        tr!(
                            "a line above the values, which begin in line {line}",
                            line = head.len() + 1
                        ),
                    )),
                }
            }
        };
        let names_told = told(said.names_line, "names_line")?;
        let units_told = told(said.units_line, "units_line")?;
        let seem_units = |index: usize| cells_of(index).and_then(|cells| head::units(&cells));
        let units = units_told.unwrap_or_else(|| {
            // A line of units stands below one of names, or alone if it is in brackets throughout.
            let index = lowest.filter(|index| Some(Some(*index)) != names_told)?;
            let in_brackets = head[index].contains(['[', '(']);
            let below_names =
                names_told.is_some() || second.is_some_and(|index| cells_of(index).is_some());
            seem_units(index).filter(|_| below_names || in_brackets).map(|_| index)
        });
        let names = names_told.unwrap_or_else(|| {
            let index = if units.is_some() && units == lowest { second } else { lowest };
            index.filter(|index| cells_of(*index).is_some() && Some(*index) != units)
        });
        let list = |index: Option<usize>| {
            let cells = index.map(|index| {
                cells_of(index).ok_or_else(|| {
                    let found = shown(head[index]);
                    let expected = tr!("{count} values", count = columns);
                    DataFault::new(FaultPlace::Line(index as u64 + 1), found, expected)
                })
            });
            cells.transpose().map(Option::unwrap_or_default)
        };
        let name_cells = list(names)?;
        let unit_cells = list(units)?;
        let unit_cells = head::units(&unit_cells).unwrap_or(unit_cells);
        let columns = (0..columns).map(|column| {
            let title = name_cells.get(column).filter(|title| !title.is_empty());
            let unit = unit_cells.get(column).filter(|unit| !unit.is_empty());
            let (name, of_name) = match (title, unit) {
                (None, _) => (unnamed(column), String::new()),
                (Some(title), Some(_)) => (title.clone(), String::new()),
                (Some(title), None) => head::named(title),
            };
            (name, unit.cloned().unwrap_or(of_name), title.is_some())
        });
        let line = |index: Option<usize>| index.map_or(0, |index| index as u64 + 1);
        let top = names.into_iter().chain(units).min().unwrap_or(head.len());
        Ok(Self {
            columns: columns.collect(),
            names_line: line(names),
            units_line: line(units),
            top,
        })
    }
}

/// A column's name and unit, by its title.
pub(crate) fn titled(title: &str) -> (String, String) {
    head::named(title)
}
