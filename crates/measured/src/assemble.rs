//! From the columns of a file to channels: names and units as a person says, and which column has the times.

use std::collections::BTreeSet;

use crate::base::language::tr;
use crate::channel::{MeasuredChannel, SampleTimes};
use crate::fault::{DataFault, shown};
use crate::layout::DataLayout;

/// A column of a file.
#[derive(Clone, Debug)]
pub(crate) struct RawColumn {
    pub name: String,
    pub unit: String,
    pub values: Vec<f64>,
    /// What the file itself says of this column's times.
    pub times: SampleTimes,
    /// Whether the name is the file's and not the column's number.
    pub named: bool,
}

/// Names of columns with times, in the languages that machines here speak; the first word of a name counts.
const TIME_NAMES: [&str; 12] = [
    "time",
    "t",
    "zeit",
    "čas",
    "cas",
    "vrijeme",
    "temps",
    "tempo",
    "tiempo",
    "x_value",
    "timestamp",
    "elapsed",
];

/// Units of time with their size in s.
const TIME_UNITS: [(&str, f64); 13] = [
    ("s", 1.0),
    ("sec", 1.0),
    ("seconds", 1.0),
    ("ms", 1e-3),
    ("msec", 1e-3),
    ("us", 1e-6),
    ("µs", 1e-6),
    ("μs", 1e-6),
    ("ns", 1e-9),
    ("min", 60.0),
    ("h", 3600.0),
    ("sek", 1.0),
    ("Sek", 1.0),
];

/// Whether the second of two times is not at or behind the first.
fn goes_back(pair: &[f64]) -> bool {
    pair[1].partial_cmp(&pair[0]).is_none_or(std::cmp::Ordering::is_lt)
}

/// The size of a unit of time in s.
pub(crate) fn seconds(unit: &str) -> Option<f64> {
    TIME_UNITS.iter().find(|(text, _)| *text == unit).map(|(_, size)| *size)
}

/// The name of a column that the file has no name for.
pub(crate) fn unnamed(column: usize) -> String {
    format!("column {}", column + 1)
}

/// The channels of columns, with what is remarkable of them. The layout then says what was taken for what.
///
/// # Errors
/// Names or units are not as many as columns, or the column with the times is none of them.
pub(crate) fn assemble(
    mut columns: Vec<RawColumn>,
    layout: &mut DataLayout,
    rate_told_hz: Option<f64>,
) -> Result<(Vec<MeasuredChannel>, Vec<String>), DataFault> {
    renamed(&mut columns, layout)?;
    let time = match (&layout.time, layout.rate_hz) {
        (Some(name), _) if name == "none" => None,
        (Some(name), _) => Some(named(&columns, name)?),
        (None, Some(_)) => None,
        (None, None) => guessed(&columns),
    };
    let mut notes = Vec::new();
    let rate_hz = layout.rate_hz.or(rate_told_hz);
    let of_rate = rate_hz.map(|rate_hz| SampleTimes::Even { rate_hz, first_s: 0.0 });
    let of_column = time.map(|index| {
        let column = &columns[index];
        let size_s = seconds(&column.unit).unwrap_or_else(|| {
            notes.push(match column.unit.as_str() {
                "" => tr!("the times in `{name}` have no unit: taken to be s", name = column.name),
                unit => tr!(
                    "the times in `{name}` have the unit `{unit}`, which is none of time: taken to be s",
                    name = column.name,
                    unit = unit
                ),
            });
            1.0
        });
        let times_s: Vec<f64> = column.values.iter().map(|time| time * size_s).collect();
        if let Some(back) = times_s.windows(2).position(goes_back) {
            notes.push(tr!(
                "the times in `{name}` do not go on at sample {sample}",
                name = column.name,
                sample = back + 2
            ));
        }
        match (times_s.as_slice(), rate_hz) {
            // A single time says nothing of a rate that the head tells.
            (&[first_s], Some(rate_hz)) => SampleTimes::Even { rate_hz, first_s },
            (times_s, _) => SampleTimes::of(times_s),
        }
    });
    layout.names = Some(columns.iter().map(|column| column.name.clone()).collect());
    layout.units = Some(columns.iter().map(|column| column.unit.clone()).collect());
    layout.time = Some(time.map_or("none".to_owned(), |index| columns[index].name.clone()));
    layout.rate_hz = match &of_column {
        Some(times) => times.rate_hz(),
        None => rate_hz,
    };
    let length = time.map(|index| columns[index].values.len());
    let channels = columns.into_iter().enumerate().filter(|(index, _)| Some(*index) != time);
    let channels = channels.map(|(_, RawColumn { name, unit, values, times, .. })| {
        let times = match (&of_column, &of_rate) {
            (Some(of_column), _) if length == Some(values.len()) => of_column.clone(),
            (None, Some(of_rate)) if times == SampleTimes::Unknown => of_rate.clone(),
            (Some(_) | None, _) => times,
        };
        MeasuredChannel { name, unit, times, values }
    });
    Ok((channels.collect(), notes))
}

/// Gives the columns the names and units that a person says, and no two the same name.
fn renamed(columns: &mut [RawColumn], layout: &DataLayout) -> Result<(), DataFault> {
    for (key, list) in [("names", &layout.names), ("units", &layout.units)] {
        let Some(list) = list else { continue };
        if list.len() != columns.len() {
            let found = tr!("`{key}` has {count} entries", key = key, count = list.len());
            let expected = tr!(
                "one for each of the {count} columns: {names}",
                count = columns.len(),
                names = name_list(columns)
            );
            return Err(DataFault::of_file(found, expected));
        }
        for (column, text) in columns.iter_mut().zip(list) {
            match key {
                "names" => (column.name, column.named) = (text.clone(), true),
                _ => column.unit.clone_from(text),
            }
        }
    }
    let mut taken = BTreeSet::new();
    for column in columns {
        let bare = column.name.clone();
        let mut number = 2;
        while !taken.insert(column.name.clone()) {
            column.name = format!("{bare} ({number})");
            number += 1;
        }
    }
    Ok(())
}

/// The names of the columns, the first ones of many.
fn name_list(columns: &[RawColumn]) -> String {
    const SHOWN: usize = 20;
    let names = columns.iter().take(SHOWN).map(|column| column.name.as_str());
    let dots = if columns.len() > SHOWN { ", ..." } else { "" };
    names.collect::<Vec<_>>().join(", ") + dots
}

/// The column that is meant by a name or number.
fn named(columns: &[RawColumn], name: &str) -> Result<usize, DataFault> {
    let by_name = columns.iter().position(|column| column.name == name);
    let by_number = || name.parse().ok().filter(|number| (1..=columns.len()).contains(number));
    by_name.or_else(|| by_number().map(|number: usize| number - 1)).ok_or_else(|| {
        let found = tr!("there is no column {name} for the times", name = shown(name));
        DataFault::of_file(found, tr!("none, or one of {names}", names = name_list(columns)))
    })
}

/// Whether a name is one of a column with times.
pub(crate) fn names_time(name: &str) -> bool {
    let lower = name.to_lowercase();
    let end = lower.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(lower.len());
    TIME_NAMES.contains(&&lower[..end])
}

/// Whether its values can be times: there are some, and none is before the one before it.
pub(crate) fn goes_on(column: &RawColumn) -> bool {
    !column.values.is_empty() && !column.values.windows(2).any(goes_back)
}

/// The column that seems to have the times.
fn guessed(columns: &[RawColumn]) -> Option<usize> {
    if columns.len() < 2 {
        return None;
    }
    let by_name = |column: &RawColumn| {
        names_time(&column.name) && (column.unit.is_empty() || seconds(&column.unit).is_some())
    };
    let by_unit = |column: &RawColumn| seconds(&column.unit).is_some();
    // Steps of 1 in a column without a name count rows, as likely as seconds.
    let by_steps = |column: &RawColumn| {
        let even = matches!(SampleTimes::of(&column.values), SampleTimes::Even { rate_hz, .. } if rate_hz != 1.0);
        !column.named && column.unit.is_empty() && column.values.len() > 2 && even
    };
    let find = |is: &dyn Fn(&RawColumn) -> bool| columns.iter().position(|c| is(c) && goes_on(c));
    find(&by_name).or_else(|| find(&by_unit)).or_else(|| Some(0).filter(|_| by_steps(&columns[0])))
}
