//! Which of the values of a file become channels.
//!
//! A vector is a channel, the columns of a matrix are some, and so are the vectors among the fields of a record.
//! Single numbers and texts beside them are facts; some tell the sample rate, names or units.

mod groups;
mod value;

use crate::assemble::RawColumn;
use crate::base::language::tr;
use crate::channel::SampleTimes;
use crate::fault::{DataFault, FaultPlace};
use crate::layout::DataLayout;
use crate::reader::RawData;
pub(crate) use value::{ColumnsTold, ContentEntry, ContentValue};
use value::{about, at, entry, fact, record_of};

/// Names of single numbers that are sample rates in Hz or distances of samples in s, in small letters without `_`.
const RATES: [&str; 7] =
    ["fs", "samplerate", "samplingrate", "samplefrequency", "samplingfrequency", "ratehz", "fshz"];
const STEPS: [&str; 4] = ["dt", "ts", "sampletime", "sampleinterval"];
/// Most facts that are kept.
const MAX_FACTS: usize = 200;
/// Most columns of a matrix.
const MAX_COLUMNS: usize = 10_000;

/// Which values are channels where a person names none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ChosenFirst {
    /// All vectors beside each other or, where there are none, those of the first record with one.
    VectorsOrRecord,
    /// All vectors, those within groups too.
    Everything,
}

/// The channels of all values of a file, or what `variable` of the layout names in it.
pub(crate) fn channels(
    all: &[ContentEntry],
    layout: &mut DataLayout,
    first: ChosenFirst,
) -> Result<RawData, DataFault> {
    let mut found = Found { all, raw: RawData::default() };
    // Files of groups have single values in any number, of attributes too; all are told as facts.
    let is_listed = |entry: &&ContentEntry| match first {
        ChosenFirst::VectorsOrRecord => true,
        ChosenFirst::Everything => fact(&entry.value).is_none(),
    };
    found.raw.entries = all.iter().filter(is_listed).map(entry).collect();
    match &layout.variable {
        Some(path) => {
            let (name, value) = at(all, path)?;
            found.chosen(path, name, value)?;
        }
        None if first == ChosenFirst::Everything => found.everything()?,
        None => layout.variable = found.all_or_first()?,
    }
    // What stands beside the chosen ones may tell their rate, too.
    for ContentEntry { name, value } in all {
        let known = found.raw.facts.iter().any(|(fact, _)| fact == name);
        if let Some(text) = fact(value).filter(|_| !known) {
            found.raw.facts.push((name.clone(), text));
        }
    }
    found.told();
    found.raw.facts.truncate(MAX_FACTS);
    Ok(found.raw)
}

/// The rate in Hz that a single number of this name tells.
pub(crate) fn rate_hz(name: &str, value: f64) -> Option<f64> {
    let bare = bare(name);
    let is_sound = value.is_finite() && value > 0.0;
    match (RATES.contains(&bare.as_str()), STEPS.contains(&bare.as_str())) {
        (true, _) if is_sound => Some(value),
        (false, true) if is_sound => Some(1.0 / value),
        (_, _) => None,
    }
}

/// The last part of a name, in small letters without `_`.
fn bare(name: &str) -> String {
    name.rsplit('.').next().unwrap_or("").to_lowercase().replace('_', "")
}

/// What stands before the last part of a name.
fn prefix_of(name: &str) -> &str {
    name.rfind('.').map_or("", |dot| &name[..=dot])
}

/// What was found so far.
struct Found<'a> {
    all: &'a [ContentEntry],
    raw: RawData,
}

impl Found<'_> {
    /// Takes what was asked for.
    fn chosen(&mut self, path: &str, name: String, value: &ContentValue) -> Result<(), DataFault> {
        let wrong = |found: String, expected: String| {
            Err(DataFault::new(FaultPlace::Entry(path.to_owned()), found, expected))
        };
        match value {
            ContentValue::Records { fields, records } => {
                let record = match (record_of(path), records.as_slice()) {
                    (Some(index), records) => records.get(index),
                    (None, [only]) => Some(only),
                    (None, _) => None,
                };
                let Some(record) = record else {
                    let found = tr!("{count} records", count = records.len());
                    return wrong(found, tr!("the number of one, as in {name}[1]", name = name));
                };
                self.record("", fields, record, 0);
            }
            ContentValue::Numbers { complex: true, .. } => {
                return wrong(about(value), tr("real numbers").to_owned());
            }
            ContentValue::Numbers { .. } => self.numbers(&name, value),
            ContentValue::Text(_) | ContentValue::Cells(_) | ContentValue::Other(_) => {
                return wrong(about(value), tr("numbers or a record").to_owned());
            }
        }
        match self.raw.columns.is_empty() {
            true => wrong(about(value), tr("a vector of numbers in it").to_owned()),
            false => Ok(()),
        }
    }

    /// Takes all vectors of the file or, where there are none, the first record with one; gives its path.
    fn all_or_first(&mut self) -> Result<Option<String>, DataFault> {
        for ContentEntry { name, value } in self.all {
            if matches!(value, ContentValue::Numbers { .. }) {
                self.numbers(name, value);
            }
        }
        if !self.raw.columns.is_empty() {
            return Ok(None);
        }
        for ContentEntry { name, value } in self.all {
            let ContentValue::Records { fields, records } = value else { continue };
            for (index, record) in records.iter().enumerate() {
                self.record("", fields, record, 0);
                if self.raw.columns.is_empty() {
                    self.raw.facts.clear();
                    continue;
                }
                if records.len() == 1 {
                    return Ok(Some(name.clone()));
                }
                self.raw.notes.push(tr!(
                    "record {number} of {count} in `{name}`; choose another one by variable={name}[{count}]",
                    number = index + 1,
                    count = records.len(),
                    name = name
                ));
                return Ok(Some(format!("{name}[{}]", index + 1)));
            }
        }
        Err(self.nothing())
    }

    /// Takes all vectors of the file, those of groups with the group's name before theirs.
    fn everything(&mut self) -> Result<(), DataFault> {
        for ContentEntry { name, value } in self.all {
            match value {
                ContentValue::Numbers { .. } => self.numbers(name, value),
                ContentValue::Records { fields, records } if records.len() == 1 => {
                    self.record(&format!("{name}."), fields, &records[0], 0);
                }
                ContentValue::Other(_) => self.left_out(name, value),
                ContentValue::Records { .. } | ContentValue::Cells(_) | ContentValue::Text(_) => {}
            }
        }
        groups::settle(&mut self.raw.columns);
        match self.raw.columns.is_empty() {
            true => Err(self.nothing()),
            false => Ok(()),
        }
    }

    /// That there are no vectors, with what there is.
    fn nothing(&self) -> DataFault {
        let names: Vec<String> = self
            .raw
            .entries
            .iter()
            .take(20)
            .map(|entry| format!("{}: {}", entry.name, entry.about))
            .collect();
        let found = match names.is_empty() {
            true => tr("the file holds no variables").to_owned(),
            false => tr!("the file holds {names}", names = names.join("; ")),
        };
        DataFault::of_file(found, tr("a vector of numbers"))
    }

    /// The vectors and facts of a record; those of records in it have its name before theirs.
    fn record(&mut self, prefix: &str, fields: &[String], record: &[ContentValue], depth: usize) {
        const DEEP: usize = 16;
        for (field, value) in fields.iter().zip(record) {
            let name = format!("{prefix}{field}");
            match value {
                ContentValue::Records { fields, records } if records.len() == 1 && depth < DEEP => {
                    self.record(&format!("{name}."), fields, &records[0], depth + 1);
                }
                ContentValue::Numbers { .. } => self.numbers(&name, value),
                ContentValue::Text(text) => self.raw.facts.push((name, text.clone())),
                ContentValue::Other(_) => self.left_out(&name, value),
                ContentValue::Records { .. } | ContentValue::Cells(_) => {}
            }
        }
    }

    /// Numbers as columns, or as a fact if it is one.
    fn numbers(&mut self, name: &str, value: &ContentValue) {
        let ContentValue::Numbers { dims, values, complex, told } = value else { return };
        if let Some(text) = fact(value) {
            return self.raw.facts.push((name.to_owned(), text));
        }
        if values.is_empty() {
            return;
        }
        let &[rows, columns] = dims.as_slice() else {
            return self.left_out(name, value);
        };
        // Channels are fewer than samples: which way a matrix lies follows from that.
        let (count, across) = if rows == 1 || (columns > rows && columns > 1 && rows > 0) {
            (rows, true)
        } else {
            (columns, false)
        };
        if *complex || count > MAX_COLUMNS {
            return self.left_out(name, value);
        }
        for channel in 0..count {
            let values: Vec<f64> = match across {
                true => values.iter().skip(channel).step_by(rows).copied().collect(),
                false => values[channel * rows..(channel + 1) * rows].to_vec(),
            };
            let told_name = told.names.get(channel).filter(|_| count == told.names.len());
            let name = match told_name.filter(|told| count > 1 && !told.is_empty()) {
                Some(told) => format!("{}{told}", prefix_of(name)),
                None if count == 1 => name.to_owned(),
                None => format!("{name}_{}", channel + 1),
            };
            let unit = match told.units.as_slice() {
                [unit] => unit.clone(),
                units if units.len() == count => units[channel].clone(),
                _ => String::new(),
            };
            let times = match told.rate_hz {
                Some(rate_hz) => SampleTimes::Even { rate_hz, first_s: 0.0 },
                None => SampleTimes::Unknown,
            };
            self.raw.columns.push(RawColumn { name, unit, values, times, named: true });
        }
    }

    fn left_out(&mut self, name: &str, value: &ContentValue) {
        self.raw.notes.push(tr!(
            "`{name}` was left out: {about}",
            name = name,
            about = about(value)
        ));
    }

    /// What facts and lists of texts tell of the columns: rate, names, units.
    fn told(&mut self) {
        let number = |names: &[&str]| {
            let fact = self.raw.facts.iter().find(|(name, _)| names.contains(&bare(name).as_str()));
            fact.and_then(|(_, text)| text.parse::<f64>().ok())
                .filter(|x| x.is_finite() && *x > 0.0)
        };
        self.raw.rate_hz = number(&RATES).or_else(|| number(&STEPS).map(|step_s| 1.0 / step_s));
        let unit = self
            .raw
            .facts
            .iter()
            .find(|(name, _)| ["unit", "units"].contains(&bare(name).as_str()));
        let unit = unit.map(|(_, unit)| unit.clone());
        let titles: Vec<String> =
            self.raw.columns.iter().map(|column| column.name.clone()).collect();
        let lists = |words: &[&str]| {
            self.all.iter().find_map(|ContentEntry { name, value }| {
                let ContentValue::Cells(cells) = value else { return None };
                let texts: Option<Vec<String>> = cells
                    .iter()
                    .map(|cell| match cell {
                        ContentValue::Text(text) => Some(text.clone()),
                        ContentValue::Numbers { .. }
                        | ContentValue::Cells(_)
                        | ContentValue::Records { .. }
                        | ContentValue::Other(_) => None,
                    })
                    .collect();
                let named = words.iter().any(|word| name.to_lowercase().contains(word));
                texts
                    .filter(|_| named)
                    .and_then(|texts| Some((of_list(&titles, texts.len())?, texts)))
            })
        };
        let (names, units) = (lists(&["name", "label", "channel", "signal"]), lists(&["unit"]));
        let of = |list: &Option<(Vec<usize>, Vec<String>)>, index: usize| {
            let (places, texts) = list.as_ref()?;
            places.iter().position(|place| *place == index).map(|place| texts[place].clone())
        };
        for (index, column) in self.raw.columns.iter_mut().enumerate() {
            if let Some(name) = of(&names, index).filter(|name| !name.is_empty()) {
                column.name = name;
            }
            let time = ["t", "time"].contains(&column.name.to_lowercase().as_str());
            let own = Some(column.unit.clone()).filter(|unit| !unit.is_empty());
            let unit = of(&units, index).or(own).or_else(|| unit.clone().filter(|_| !time));
            column.unit = unit.unwrap_or_default();
        }
    }
}

/// The places of the columns that a list of so many texts is about: all of them, or those of the one matrix with as many.
fn of_list(titles: &[String], count: usize) -> Option<Vec<usize>> {
    if titles.len() == count {
        return Some((0..count).collect());
    }
    let place = |base: &str, number: usize| {
        titles.iter().position(|title| *title == format!("{base}_{number}"))
    };
    let bases = titles.iter().filter_map(|title| title.strip_suffix("_1"));
    let mut fitting = bases.filter(|base| place(base, count + 1).is_none()).filter_map(|base| {
        (1..=count).map(|number| place(base, number)).collect::<Option<Vec<usize>>>()
    });
    fitting.next().filter(|_| fitting.next().is_none())
}
