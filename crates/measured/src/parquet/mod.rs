//! Parquet: flat columns of numbers, truth values and times, as pandas, polars and DuckDB write them.
//!
//! An own reader, since the usual crate brings C for Zstandard, which polars writes unless told otherwise.

mod pages;
mod snappy;
mod thrift;

use crate::assemble::RawColumn;
use crate::base::language::tr;
use crate::bytes::ByteReader;
use crate::channel::SampleTimes;
use crate::fault::DataFault;
use crate::reader::RawData;
use pages::{Physical, Stored, hybrid, inflated, values};
use thrift::Thrift;

/// Most values of a file.
const MAX_VALUES: usize = 1 << 28;
/// Longest text among a file's own that is kept as a fact, characters.
const MAX_FACT: usize = 200;

/// Reads a file.
pub(crate) fn read(bytes: &[u8]) -> Result<RawData, DataFault> {
    let description = description(bytes)?;
    let mut raw = RawData::default();
    let told = |entry: &Thrift<'_>| Some((entry.text(1)?, entry.text(2)?));
    let short = |(_, text): &(String, String)| text.chars().count() <= MAX_FACT;
    raw.facts = description.list(5).iter().filter_map(told).filter(short).collect();
    if let Some(program) = description.text(6) {
        raw.facts.push(("created_by".to_owned(), program));
    }
    let [root, elements @ ..] = description.list(2) else {
        return Err(DataFault::at(bytes.len(), tr("a file without columns"), tr("at least one")));
    };
    let mut columns: Vec<ColumnInFile> = Vec::new();
    let mut leaf = 0;
    let mut index = 0;
    for _ in 0..root.int(5).unwrap_or(0) {
        let Some(element) = elements.get(index) else { break };
        let leaves = subtree(elements, &mut index, 0)?;
        match ColumnInFile::of(element, leaf) {
            Some(column) if leaves == 1 => columns.push(column),
            Some(_) | None => raw.notes.push(tr!(
                "`{name}` holds no numbers and was left out",
                name = element.text(4).unwrap_or_default()
            )),
        }
        leaf += leaves;
    }
    let rows: i64 =
        description.list(4).iter().filter_map(|group| group.int(3)).fold(0, i64::saturating_add);
    let total = usize::try_from(rows).unwrap_or(usize::MAX).saturating_mul(columns.len());
    if total > MAX_VALUES {
        let found = tr!("{count} values", count = total);
        return Err(DataFault::of_file(found, tr!("at most {most}", most = MAX_VALUES)));
    }
    for column in columns {
        let mut stored = Vec::new();
        for group in description.list(4) {
            column.read(bytes, group, &mut stored)?;
        }
        raw.columns.push(column.raw(stored));
    }
    Ok(raw)
}

/// The description at the end of a file.
fn description(bytes: &[u8]) -> Result<Thrift<'_>, DataFault> {
    let ended = |bytes: &[u8]| {
        DataFault::at(
            bytes.len(),
            tr("an end without `PAR1`"),
            tr("a file that was written to its end"),
        )
    };
    let body =
        bytes.strip_suffix(b"PAR1").filter(|body| body.len() >= 8).ok_or_else(|| ended(bytes))?;
    let (body, length) = body.split_at(body.len() - 4);
    let length = u32::from_le_bytes([length[0], length[1], length[2], length[3]]) as usize;
    let from = body.len().checked_sub(length).filter(|from| *from >= 4).ok_or_else(|| {
        let found = tr!("a description of {size} bytes", size = length);
        DataFault::at(body.len(), found, tr!("at most {most}", most = body.len() - 4))
    })?;
    Thrift::read(&mut ByteReader::new(&body[from..], from))
}

/// Goes over an element of the schema with those in it; gives how many columns these are.
fn subtree(elements: &[Thrift<'_>], index: &mut usize, depth: usize) -> Result<usize, DataFault> {
    const MAX_DEPTH: usize = 64;
    let Some(element) = elements.get(*index).filter(|_| depth < MAX_DEPTH) else {
        return Err(DataFault::of_file(
            tr("a tree of columns that does not fit"),
            tr("one that does"),
        ));
    };
    *index += 1;
    let children = element.int(5).unwrap_or(0);
    if children <= 0 {
        return Ok(1);
    }
    let mut leaves = 0;
    for _ in 0..children {
        leaves += subtree(elements, index, depth + 1)?;
    }
    Ok(leaves)
}

/// A flat column of numbers.
struct ColumnInFile {
    name: String,
    /// Its place among the columns of a group of rows.
    leaf: usize,
    physical: Physical,
    /// Whether values may be missing.
    optional: bool,
    meaning: Meaning,
}

/// What its whole numbers are.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Meaning {
    Number,
    /// Whole numbers without a sign.
    Unsigned,
    /// So many of them are one.
    Decimal(f64),
    /// So many of them are a second.
    Time(f64),
}

impl ColumnInFile {
    fn of(element: &Thrift<'_>, leaf: usize) -> Option<Self> {
        let physical = Physical::of(element.int(1)?)?;
        let optional = match element.int(3) {
            Some(0) | None => false,
            Some(1) => true,
            Some(_) => return None,
        };
        // Milliseconds, microseconds, nanoseconds, of points of time and of times of day.
        let logical = element.field(10);
        let unit = |id| logical.and_then(|kind| kind.field(id)).and_then(|kind| kind.field(2));
        let of_unit = |unit: &Thrift<'_>| {
            [(1, 1e3), (2, 1e6), (3, 1e9)].into_iter().find(|(id, _)| unit.field(*id).is_some())
        };
        let time = unit(8).or_else(|| unit(7)).and_then(of_unit);
        let meaning = match (time, element.int(6)) {
            (Some((_, size)), _) => Meaning::Time(size),
            (None, Some(7 | 9)) => Meaning::Time(1e3),
            (None, Some(8 | 10)) => Meaning::Time(1e6),
            (None, Some(5)) => {
                let scale =
                    u32::try_from(element.int(7).unwrap_or(0)).ok().filter(|scale| *scale <= 18)?;
                Meaning::Decimal(10u64.pow(scale) as f64)
            }
            (None, Some(11..=14)) => Meaning::Unsigned,
            (None, Some(_) | None) => Meaning::Number,
        };
        Some(Self { name: element.text(4)?, leaf, physical, optional, meaning })
    }

    /// Reads its values in a group of rows.
    fn read(
        &self,
        bytes: &[u8],
        group: &Thrift<'_>,
        stored: &mut Vec<Option<Stored>>,
    ) -> Result<(), DataFault> {
        let none =
            || DataFault::of_file(tr!("`{name}` has no values", name = self.name), tr("some"));
        let about =
            group.list(1).get(self.leaf).and_then(|chunk| chunk.field(3)).ok_or_else(none)?;
        let number = |id| about.int(id).and_then(|x| usize::try_from(x).ok());
        let rows = group.int(3).and_then(|x| usize::try_from(x).ok()).ok_or_else(none)?;
        let codec = about.int(4).unwrap_or(0);
        let from = match (number(11).filter(|x| *x > 0), number(9)) {
            (Some(dictionary), Some(data)) => dictionary.min(data),
            (Some(x), None) | (None, Some(x)) => x,
            (None, None) => return Err(none()),
        };
        let rest = bytes.get(from..).ok_or_else(|| {
            let found = tr!("pages of `{name}` at byte {byte}", name = self.name, byte = from);
            DataFault::at(from, found, tr!("at most {most}", most = bytes.len()))
        })?;
        let mut reader = ByteReader::new(rest, from);
        let mut dictionary: Option<Vec<Stored>> = None;
        let end = stored.len() + rows;
        while stored.len() < end {
            let place = reader.place();
            let head = Thrift::read(&mut reader)?;
            let size = |id| {
                let size = head.int(id).and_then(|x| usize::try_from(x).ok());
                size.ok_or_else(|| DataFault::at(place, tr("a page without its size"), tr("one")))
            };
            let (inner, outer) = (size(2)?, size(3)?);
            let packed = reader.take(outer)?;
            let count = |about: Option<&Thrift<'_>>, most: usize| {
                let told = about.and_then(|about| about.int(1)).unwrap_or(-1);
                usize::try_from(told).ok().filter(|count| *count <= most).ok_or_else(|| {
                    let found = tr!("a page of {count} values", count = told);
                    DataFault::at(place, found, tr!("at most {most}", most = most))
                })
            };
            match head.int(1) {
                Some(2) => {
                    let page = inflated(codec, packed, inner, place)?;
                    let count = count(head.field(7), page.len().saturating_mul(8))?;
                    let mut page = ByteReader::new(&page, place);
                    dictionary = Some(values(&mut page, 0, self.physical, count, None)?);
                }
                Some(0) => {
                    let about = head.field(5);
                    let count = count(about, end - stored.len())?;
                    let page = inflated(codec, packed, inner, place)?;
                    let mut page = ByteReader::new(&page, place);
                    let there = if self.optional {
                        let length = page.u32()? as usize;
                        let mut levels = ByteReader::new(page.take(length)?, place);
                        Some(hybrid(&mut levels, 1, count)?)
                    } else {
                        None
                    };
                    let encoding = about.and_then(|about| about.int(2)).unwrap_or(0);
                    self.keep(&mut page, encoding, count, there, dictionary.as_deref(), stored)?;
                }
                Some(3) => {
                    let about = head.field(8);
                    let count = count(about, end - stored.len())?;
                    let length = |id| {
                        about
                            .and_then(|about| about.int(id))
                            .and_then(|x| usize::try_from(x).ok())
                            .unwrap_or(0)
                    };
                    let mut packed = ByteReader::new(packed, place);
                    packed.take(length(6))?;
                    let levels = packed.take(length(5))?;
                    let rest = packed.take(packed.left())?;
                    let plain =
                        about.and_then(|about| about.field(7)) == Some(&Thrift::Bool(false));
                    let size = inner.saturating_sub(length(5)).saturating_sub(length(6));
                    // Nothing is compressed where all values are missing.
                    let page = match rest.is_empty() {
                        true => Vec::new(),
                        false => inflated(if plain { 0 } else { codec }, rest, size, place)?,
                    };
                    let there = match self.optional {
                        true => Some(hybrid(&mut ByteReader::new(levels, place), 1, count)?),
                        false => None,
                    };
                    let mut page = ByteReader::new(&page, place);
                    let encoding = about.and_then(|about| about.int(4)).unwrap_or(0);
                    self.keep(&mut page, encoding, count, there, dictionary.as_deref(), stored)?;
                }
                // Pages of an index have no values.
                Some(_) | None => {}
            }
        }
        Ok(())
    }

    /// Keeps the values of a page, in their places among those that are missing.
    fn keep(
        &self,
        page: &mut ByteReader<'_>,
        encoding: i64,
        count: usize,
        there: Option<Vec<u64>>,
        dictionary: Option<&[Stored]>,
        stored: &mut Vec<Option<Stored>>,
    ) -> Result<(), DataFault> {
        let filled =
            there.as_ref().map_or(count, |there| there.iter().filter(|x| **x == 1).count());
        let mut found = values(page, encoding, self.physical, filled, dictionary)?.into_iter();
        match there {
            None => stored.extend(found.map(Some)),
            Some(there) => {
                stored.extend(there.into_iter().map(|x| if x == 1 { found.next() } else { None }))
            }
        }
        Ok(())
    }

    /// The column as numbers; points of time since the first, in s.
    fn raw(self, stored: Vec<Option<Stored>>) -> RawColumn {
        let first = stored.iter().flatten().find_map(|x| match x {
            Stored::Whole(x) => Some(*x),
            Stored::Real(_) => None,
        });
        let value = |x: &Option<Stored>| match (x, self.meaning) {
            (None, _) => f64::NAN,
            (Some(Stored::Real(x)), _) => *x,
            (Some(Stored::Whole(x)), Meaning::Number) => *x as f64,
            (Some(Stored::Whole(x)), Meaning::Unsigned) => match self.physical {
                Physical::Int32 => f64::from(*x as u32),
                Physical::Boolean | Physical::Int64 | Physical::Float | Physical::Double => {
                    *x as u64 as f64
                }
            },
            (Some(Stored::Whole(x)), Meaning::Decimal(one)) => *x as f64 / one,
            (Some(Stored::Whole(x)), Meaning::Time(second)) => {
                x.wrapping_sub(first.unwrap_or(0)) as f64 / second
            }
        };
        let values = stored.iter().map(value).collect();
        let (name, unit) = crate::text::titled(&self.name);
        let unit = if matches!(self.meaning, Meaning::Time(_)) { "s".to_owned() } else { unit };
        RawColumn { name, unit, values, times: SampleTimes::Unknown, named: true }
    }
}
