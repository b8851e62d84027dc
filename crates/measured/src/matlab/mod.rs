//! MATLAB v5: what a file holds, and which of it become channels.
//!
//! A vector is a channel, the columns of a matrix are some, and so are the vectors among the fields of a record.
//! Single numbers and texts beside them are facts; some tell the sample rate, names or units.

mod element;

use crate::assemble::RawColumn;
use crate::base::language::tr;
use crate::channel::SampleTimes;
use crate::fault::{DataFault, FaultPlace, shown};
use crate::layout::DataLayout;
use crate::reader::{DataEntry, RawData};
pub(crate) use element::is;
use element::{MatValue, MatVariable, variables};

/// Names of single numbers that are sample rates in Hz or distances of samples in s, in small letters without `_`.
const RATES: [&str; 7] =
    ["fs", "samplerate", "samplingrate", "samplefrequency", "samplingfrequency", "ratehz", "fshz"];
const STEPS: [&str; 4] = ["dt", "ts", "sampletime", "sampleinterval"];
/// Most facts that are kept.
const MAX_FACTS: usize = 200;
/// Most columns of a matrix.
const MAX_COLUMNS: usize = 10_000;

/// Reads a file, or what `variable` of the layout names in it.
pub(crate) fn read(bytes: &[u8], layout: &mut DataLayout) -> Result<RawData, DataFault> {
    let all = variables(bytes)?;
    let mut found = Found { all: &all, raw: RawData::default() };
    found.raw.entries = all.iter().map(entry).collect();
    match &layout.variable {
        Some(path) => {
            let (name, value) = at(&all, path)?;
            found.chosen(path, name, value)?;
        }
        None => layout.variable = found.all_or_first()?,
    }
    // What stands beside the chosen ones may tell their rate, too.
    for MatVariable { name, value } in &all {
        let known = found.raw.facts.iter().any(|(fact, _)| fact == name);
        if let Some(text) = fact(value).filter(|_| !known) {
            found.raw.facts.push((name.clone(), text));
        }
    }
    found.told();
    found.raw.facts.truncate(MAX_FACTS);
    Ok(found.raw)
}

/// What a value is, for the list of contents.
fn about(value: &MatValue) -> String {
    match value {
        MatValue::Numbers { dims, complex, .. } => {
            let size = dims.iter().map(usize::to_string).collect::<Vec<_>>().join(" x ");
            match complex {
                true => tr!("{size} complex numbers", size = size),
                false => tr!("{size} numbers", size = size),
            }
        }
        MatValue::Text(text) => tr!("the text {text}", text = shown(text)),
        MatValue::Cells(cells) => tr!("{count} cells", count = cells.len()),
        MatValue::Records { fields, records } => {
            tr!("{count} records of {fields}", count = records.len(), fields = fields.join(", "))
        }
        MatValue::Other(what) => tr(what).to_owned(),
    }
}

fn entry(variable: &MatVariable) -> DataEntry {
    DataEntry { name: variable.name.clone(), about: about(&variable.value) }
}

/// A value that is a single number or a text, as a text.
fn fact(value: &MatValue) -> Option<String> {
    match value {
        MatValue::Numbers { values, complex: false, .. } => match values.as_slice() {
            [x] => Some(x.to_string()),
            _ => None,
        },
        MatValue::Text(text) => Some(text.clone()),
        MatValue::Numbers { complex: true, .. }
        | MatValue::Cells(_)
        | MatValue::Records { .. }
        | MatValue::Other(_) => None,
    }
}

/// The value at a path such as `mill[3].smcAC`, with the last name in it.
fn at<'a>(all: &'a [MatVariable], path: &str) -> Result<(String, &'a MatValue), DataFault> {
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
    let mut record: Option<&Vec<MatValue>> = None;
    for part in parts {
        let number: Option<usize> = part.parse().ok();
        let out_of = |count: usize| {
            wrong(tr!("number {part}", part = part), tr!("1 to {most}", most = count))
        };
        match (value, number) {
            (MatValue::Records { records, .. }, Some(number)) => {
                let index = number.checked_sub(1);
                record =
                    Some(index.and_then(|i| records.get(i)).ok_or_else(|| out_of(records.len()))?);
            }
            (MatValue::Records { fields, records }, None) => {
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
            (MatValue::Cells(cells), Some(number)) => {
                let index = number.checked_sub(1);
                value = index.and_then(|i| cells.get(i)).ok_or_else(|| out_of(cells.len()))?;
            }
            (
                MatValue::Cells(_)
                | MatValue::Numbers { .. }
                | MatValue::Text(_)
                | MatValue::Other(_),
                _,
            ) => {
                return Err(wrong(about(value), tr!("something with a {part} in it", part = part)));
            }
        }
    }
    Ok((name, value))
}

/// The number of the record that a path ends with.
fn record_of(path: &str) -> Option<usize> {
    let inside = path.trim_end_matches([']', ')', '}']);
    let (_, number) = inside.rsplit_once(['[', '(', '{']).filter(|_| inside.len() < path.len())?;
    number.parse::<usize>().ok()?.checked_sub(1)
}

/// What was found so far.
struct Found<'a> {
    all: &'a [MatVariable],
    raw: RawData,
}

impl Found<'_> {
    /// Takes what was asked for.
    fn chosen(&mut self, path: &str, name: String, value: &MatValue) -> Result<(), DataFault> {
        let wrong = |found: String, expected: String| {
            Err(DataFault::new(FaultPlace::Entry(path.to_owned()), found, expected))
        };
        match value {
            MatValue::Records { fields, records } => {
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
            MatValue::Numbers { complex: true, .. } => {
                return wrong(about(value), tr("real numbers").to_owned());
            }
            MatValue::Numbers { .. } => self.numbers(&name, value),
            MatValue::Text(_) | MatValue::Cells(_) | MatValue::Other(_) => {
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
        for MatVariable { name, value } in self.all {
            if matches!(value, MatValue::Numbers { .. }) {
                self.numbers(name, value);
            }
        }
        if !self.raw.columns.is_empty() {
            return Ok(None);
        }
        for MatVariable { name, value } in self.all {
            let MatValue::Records { fields, records } = value else { continue };
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
        Err(DataFault::of_file(found, tr("a vector of numbers")))
    }

    /// The vectors and facts of a record; those of records in it have its name before theirs.
    fn record(&mut self, prefix: &str, fields: &[String], record: &[MatValue], depth: usize) {
        const DEEP: usize = 3;
        for (field, value) in fields.iter().zip(record) {
            let name = format!("{prefix}{field}");
            match value {
                MatValue::Records { fields, records } if records.len() == 1 && depth < DEEP => {
                    self.record(&format!("{name}."), fields, &records[0], depth + 1);
                }
                MatValue::Numbers { .. } => self.numbers(&name, value),
                MatValue::Text(text) => self.raw.facts.push((name, text.clone())),
                MatValue::Records { .. } | MatValue::Cells(_) | MatValue::Other(_) => {}
            }
        }
    }

    /// Numbers as columns, or as a fact if it is one.
    fn numbers(&mut self, name: &str, value: &MatValue) {
        let MatValue::Numbers { dims, values, complex } = value else { return };
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
            let name = if count == 1 { name.to_owned() } else { format!("{name}_{}", channel + 1) };
            let times = SampleTimes::Unknown;
            self.raw.columns.push(RawColumn {
                name,
                unit: String::new(),
                values,
                times,
                named: true,
            });
        }
    }

    fn left_out(&mut self, name: &str, value: &MatValue) {
        self.raw.notes.push(tr!(
            "`{name}` was left out: {about}",
            name = name,
            about = about(value)
        ));
    }

    /// What facts and lists of texts tell of the columns: rate, names, units.
    fn told(&mut self) {
        let bare =
            |name: &str| name.rsplit('.').next().unwrap_or("").to_lowercase().replace('_', "");
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
            self.all.iter().find_map(|MatVariable { name, value }| {
                let MatValue::Cells(cells) = value else { return None };
                let texts: Option<Vec<String>> = cells
                    .iter()
                    .map(|cell| match cell {
                        MatValue::Text(text) => Some(text.clone()),
                        MatValue::Numbers { .. }
                        | MatValue::Cells(_)
                        | MatValue::Records { .. }
                        | MatValue::Other(_) => None,
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
            let unit = of(&units, index).or_else(|| unit.clone().filter(|_| !time));
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
