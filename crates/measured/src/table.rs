//! Channels as plain CSV: separated by commas, decimal points, names with units in the first line, times in s before
//! the channels that they belong to. A sample that is missing is an empty cell.

use std::io::{self, Write};

use crate::channel::{MeasuredChannel, SampleTimes};

/// A column of the table.
enum TableColumn<'a> {
    Times(&'a SampleTimes, usize),
    Values(&'a MeasuredChannel),
}

impl TableColumn<'_> {
    fn len(&self) -> usize {
        match self {
            Self::Times(_, length) => *length,
            Self::Values(channel) => channel.values.len(),
        }
    }

    fn at(&self, row: usize) -> Option<f64> {
        match self {
            Self::Times(times, length) => times.at(row).filter(|_| row < *length),
            Self::Values(channel) => channel.values.get(row).copied().filter(|x| !x.is_nan()),
        }
    }
}

/// Writes channels as a table; numbers in the shortest form that reads back to the same bits. Channels with the same
/// times stand behind one column of times; the columns of shorter ones end with empty cells.
///
/// ```
/// use steadycut_measured::layout::DataLayout;
/// use steadycut_measured::{reader, table};
///
/// let data = reader::read(b"t [s]\tF [N]\n0\t1,5\n0,5\t\n", &DataLayout::default()).unwrap();
/// let mut csv = Vec::new();
/// table::write(&mut csv, &data.channels).unwrap();
/// assert_eq!(csv, b"time [s],F [N]\n0,1.5\n0.5,\n");
/// ```
///
/// # Errors
/// Those of the writer.
pub fn write(out: &mut impl Write, channels: &[MeasuredChannel]) -> io::Result<()> {
    let mut columns: Vec<TableColumn<'_>> = Vec::new();
    let mut titles: Vec<String> = Vec::new();
    let mut told: Option<(&SampleTimes, usize)> = None;
    for channel in channels {
        let times = (&channel.times, channel.values.len());
        if *times.0 != SampleTimes::Unknown && told != Some(times) {
            let number = columns.iter().filter(|c| matches!(c, TableColumn::Times(..))).count();
            titles.push(match number {
                0 => "time [s]".to_owned(),
                _ => format!("time {} [s]", number + 1),
            });
            columns.push(TableColumn::Times(times.0, times.1));
        }
        told = Some(times);
        titles.push(channel.title());
        columns.push(TableColumn::Values(channel));
    }
    let cell = |title: &String| match title.contains([',', '"', '\n', '\r']) {
        true => format!("\"{}\"", title.replace('"', "\"\"")),
        false => title.clone(),
    };
    writeln!(out, "{}", titles.iter().map(cell).collect::<Vec<_>>().join(","))?;
    for row in 0..columns.iter().map(TableColumn::len).max().unwrap_or(0) {
        for (place, column) in columns.iter().enumerate() {
            let comma = if place == 0 { "" } else { "," };
            match column.at(row) {
                Some(x) => write!(out, "{comma}{x}")?,
                None => write!(out, "{comma}")?,
            }
        }
        writeln!(out)?;
    }
    Ok(())
}
