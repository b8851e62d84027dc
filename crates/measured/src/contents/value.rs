//! The contents of files of named values: numbers, texts, lists and records in each other, and how a path goes to one.

use crate::base::language::tr;
use crate::fault::{DataFault, FaultPlace, shown};
use crate::reader::DataEntry;

/// A value of a file.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum ContentValue {
    /// Numbers, column by column.
    Numbers {
        dims: Vec<usize>,
        values: Vec<f64>,
        /// Whether they have imaginary parts, which are not read.
        complex: bool,
        told: ColumnsTold,
    },
    /// A text; lines of a text of several rows are joined.
    Text(String),
    /// Values without names.
    Cells(Vec<ContentValue>),
    /// Records of the same fields, record by record.
    Records { fields: Vec<String>, records: Vec<Vec<ContentValue>> },
    /// What has no numbers that could be channels.
    Other(&'static str),
}

/// What the file says of numbers themselves, once for all of their columns or for each of them.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct ColumnsTold {
    pub names: Vec<String>,
    pub units: Vec<String>,
    pub rate_hz: Option<f64>,
}

/// A value with its name.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ContentEntry {
    pub name: String,
    pub value: ContentValue,
}

impl ContentValue {
    /// Real numbers of which nothing more is told.
    pub fn numbers(dims: Vec<usize>, values: Vec<f64>) -> Self {
        Self::Numbers { dims, values, complex: false, told: ColumnsTold::default() }
    }
}

/// What a value is, for the list of contents.
pub(super) fn about(value: &ContentValue) -> String {
    match value {
        ContentValue::Numbers { dims, complex, .. } => {
            let size = dims.iter().map(usize::to_string).collect::<Vec<_>>().join(" x ");
            match complex {
                true => tr!("{size} complex numbers", size = size),
                false => tr!("{size} numbers", size = size),
            }
        }
        ContentValue::Text(text) => tr!("the text {text}", text = shown(text)),
        ContentValue::Cells(cells) => tr!("{count} cells", count = cells.len()),
        ContentValue::Records { fields, records } => {
            tr!("{count} records of {fields}", count = records.len(), fields = fields.join(", "))
        }
        ContentValue::Other(what) => tr(what).to_owned(),
    }
}

pub(super) fn entry(variable: &ContentEntry) -> DataEntry {
    DataEntry { name: variable.name.clone(), about: about(&variable.value) }
}

/// A value that is a single number or a text, as a text.
pub(super) fn fact(value: &ContentValue) -> Option<String> {
    match value {
        ContentValue::Numbers { values, complex: false, .. } => match values.as_slice() {
            [x] => Some(x.to_string()),
            _ => None,
        },
        ContentValue::Text(text) => Some(text.clone()),
        ContentValue::Numbers { complex: true, .. }
        | ContentValue::Cells(_)
        | ContentValue::Records { .. }
        | ContentValue::Other(_) => None,
    }
}

/// The value at a path such as `mill[3].smcAC`, with the last name in it.
pub(super) fn at<'a>(
    all: &'a [ContentEntry],
    path: &str,
) -> Result<(String, &'a ContentValue), DataFault> {
    let wrong = |found: String, expected: String| {
        DataFault::new(FaultPlace::Entry(path.to_owned()), found, expected)
    };
    let names = || all.iter().map(|variable| variable.name.as_str()).collect::<Vec<_>>().join(", ");
    let mut parts =
        path.split(['.', '[', '(', '{']).map(|part| part.trim_end_matches([']', ')', '}']));
    let first = parts.next().unwrap_or("");
    let variable = all.iter().find(|variable| variable.name == first).ok_or_else(|| {
        wrong(
            tr!("there is no {name}", name = shown(first)),
            tr!("one of {names}", names = names()),
        )
    })?;
    let mut name = first.to_owned();
    let mut value = &variable.value;
    // A record by its number, with the field that is asked for next.
    let mut record: Option<&Vec<ContentValue>> = None;
    for part in parts {
        let number: Option<usize> = part.parse().ok();
        let out_of = |count: usize| {
            wrong(tr!("number {part}", part = part), tr!("1 to {most}", most = count))
        };
        match (value, number) {
            (ContentValue::Records { records, .. }, Some(number)) => {
                let index = number.checked_sub(1);
                record =
                    Some(index.and_then(|i| records.get(i)).ok_or_else(|| out_of(records.len()))?);
            }
            (ContentValue::Records { fields, records }, None) => {
                let field = fields.iter().position(|field| field == part).ok_or_else(|| {
                    let expected = tr!("one of {names}", names = fields.join(", "));
                    wrong(tr!("there is no {name}", name = shown(part)), expected)
                })?;
                let of = match (record, records.as_slice()) {
                    (Some(record), _) => record,
                    (None, [only]) => only,
                    (None, _) => {
                        let found = tr!("{count} records", count = records.len());
                        return Err(wrong(
                            found,
                            tr!("the number of one, as in {name}[1]", name = name),
                        ));
                    }
                };
                (value, record) = (&of[field], None);
                name = part.to_owned();
            }
            (ContentValue::Cells(cells), Some(number)) => {
                let index = number.checked_sub(1);
                value = index.and_then(|i| cells.get(i)).ok_or_else(|| out_of(cells.len()))?;
            }
            (
                ContentValue::Cells(_)
                | ContentValue::Numbers { .. }
                | ContentValue::Text(_)
                | ContentValue::Other(_),
                _,
            ) => {
                return Err(wrong(about(value), tr!("something with a {part} in it", part = part)));
            }
        }
    }
    Ok((name, value))
}

/// The number of the record that a path ends with.
pub(super) fn record_of(path: &str) -> Option<usize> {
    let inside = path.trim_end_matches([']', ')', '}']);
    let (_, number) = inside.rsplit_once(['[', '(', '{']).filter(|_| inside.len() < path.len())?;
    number.parse::<usize>().ok()?.checked_sub(1)
}
