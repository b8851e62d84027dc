//! The segments of a TDMS file: "TDMS File Format Internal Structure" (National Instruments). Each has a lead-in, what
//! it says of its objects, and raw data. A segment that does not say of an object goes on with what the last one said.

use std::collections::BTreeMap;

use crate::base::language::{text, tr};
use crate::bytes::ByteReader;
use crate::fault::DataFault;

/// Bits of a segment's table of contents.
const HAS_META: u32 = 1 << 1;
const NEW_LIST: u32 = 1 << 2;
const HAS_RAW: u32 = 1 << 3;
const INTERLEAVED: u32 = 1 << 5;
const BIG_ENDIAN: u32 = 1 << 6;
/// Bytes of a lead-in.
const LEAD_IN: u64 = 28;
/// Seconds from 1904, where its times begin, are doubles to the microsecond.
const FRACTION: f64 = 18_446_744_073_709_551_616.0;

/// What a property says.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Property {
    Number(f64),
    Text(String),
}

/// How the values of a channel are stored.
#[derive(Clone, Copy, Debug, PartialEq)]
struct RawIndex {
    kind: u32,
    count: u64,
    /// Bytes of them all.
    bytes: u64,
}

/// An object: the file, a group or a channel.
#[derive(Clone, Debug, Default)]
pub(super) struct TdmsObject {
    /// Its names, from the outermost on: none for the file, two for a channel.
    pub path: Vec<String>,
    pub properties: BTreeMap<String, Property>,
    pub values: Vec<f64>,
    /// Whether its values are points of time, s from 1904.
    pub is_time: bool,
    /// Why its values are not read; empty where they are.
    pub unread: &'static str,
    index: Option<RawIndex>,
}

/// Bytes of a value of a type, if it has always as many.
fn width(kind: u32) -> Option<usize> {
    match kind {
        1 | 5 | 0x21 => Some(1),
        2 | 6 => Some(2),
        3 | 7 | 9 | 0x19 => Some(4),
        4 | 8 | 10 | 0x1a | 0x0008_000c => Some(8),
        11 | 0x1b | 0x44 | 0x0010_000d => Some(16),
        _ => None,
    }
}

/// The objects of a file in their order, with all their values.
///
/// # Errors
/// The place of what is not as the format has it.
pub(super) fn objects(bytes: &[u8]) -> Result<Vec<TdmsObject>, DataFault> {
    let mut objects: Vec<TdmsObject> = Vec::new();
    let mut by_path: BTreeMap<String, usize> = BTreeMap::new();
    // Channels with raw data in the present segment.
    let mut listed: Vec<usize> = Vec::new();
    let mut at: usize = 0;
    while at < bytes.len() {
        let mut lead = ByteReader::new(&bytes[at..], at);
        let mark = lead.take(4)?;
        if mark != b"TDSm" {
            let found = tr!("the bytes {bytes}", bytes = format!("{mark:02x?}"));
            return Err(DataFault::at(at, found, tr("a segment, which begins with `TDSm`")));
        }
        let contents = lead.u32()?;
        lead.u32()?;
        let next = lead.u64()?;
        let raw_from = lead.u64()?;
        let left = lead.left() as u64;
        // Of a segment that was not finished as the program stopped, the length is not known.
        let length = if next == u64::MAX { left } else { next.min(left) };
        if raw_from > length {
            let found = tr!("raw data {bytes} bytes behind", bytes = raw_from);
            return Err(DataFault::at(at + 20, found, tr!("at most {most}", most = length)));
        }
        let body = lead.take(length as usize)?;
        let (meta, raw) = body.split_at(raw_from as usize);
        let start = at + LEAD_IN as usize;
        let big_endian = contents & BIG_ENDIAN != 0;
        if contents & HAS_META != 0 {
            if contents & NEW_LIST != 0 {
                listed.clear();
            }
            let mut reader = ByteReader::new(meta, start).ordered(big_endian);
            for _ in 0..reader.u32()? {
                told(&mut reader, &mut objects, &mut by_path, &mut listed)?;
            }
        }
        if contents & HAS_RAW != 0 && !raw.is_empty() {
            let reader = ByteReader::new(raw, start + meta.len()).ordered(big_endian);
            values(reader, contents & INTERLEAVED != 0, &mut objects, &listed)?;
        }
        at = start + body.len();
    }
    Ok(objects)
}

fn text(reader: &mut ByteReader<'_>) -> Result<String, DataFault> {
    let length = reader.u32()? as usize;
    Ok(String::from_utf8_lossy(reader.take(length)?).into_owned())
}

/// The names in a path such as `/'Force'/'Fx'`.
fn names(path: &str) -> Vec<String> {
    let mut names = Vec::new();
    let mut rest = path;
    while let Some(inside) = rest.strip_prefix("/'") {
        let mut name = String::new();
        let mut signs = inside.char_indices().peekable();
        rest = "";
        while let Some((at, sign)) = signs.next() {
            match sign {
                // A quote in a name is written twice.
                '\'' if signs.peek().is_some_and(|(_, next)| *next == '\'') => {
                    signs.next();
                    name.push('\'');
                }
                '\'' => {
                    rest = &inside[at + 1..];
                    break;
                }
                sign => name.push(sign),
            }
        }
        names.push(name);
    }
    names
}

/// What a segment says of an object.
fn told(
    reader: &mut ByteReader<'_>,
    objects: &mut Vec<TdmsObject>,
    by_path: &mut BTreeMap<String, usize>,
    listed: &mut Vec<usize>,
) -> Result<(), DataFault> {
    let path = text(reader)?;
    let place = *by_path.entry(path).or_insert_with_key(|path| {
        objects.push(TdmsObject { path: names(path), ..TdmsObject::default() });
        objects.len() - 1
    });
    let object = &mut objects[place];
    let has_raw = match reader.u32()? {
        u32::MAX => false,
        // As in the last segment.
        0 if object.index.is_some() => true,
        0 => return Err(reader.fault(tr("no length of raw data before it"), tr("one"))),
        0x1269 | 0x1369 => {
            let found = tr("raw values of DAQmx, which are scaled elsewhere");
            return Err(reader.fault(found, tr("values that LabVIEW has converted, or CSV")));
        }
        _ => {
            let kind = reader.u32()?;
            let dimension = reader.u32()?;
            if dimension != 1 {
                let found = tr!("an array of {count} dimensions", count = dimension);
                return Err(reader.fault(found, "1"));
            }
            let count = reader.u64()?;
            let bytes = match width(kind) {
                Some(width) => count.checked_mul(width as u64),
                None if kind == 0x20 => Some(reader.u64()?),
                None => {
                    let found = tr!("values of type {kind}", kind = format!("0x{kind:x}"));
                    return Err(reader.fault(found, tr("numbers, texts or times")));
                }
            };
            let too_many = || reader.fault(tr!("{count} values", count = count), tr("fewer"));
            let bytes = bytes.ok_or_else(too_many)?;
            object.index = Some(RawIndex { kind, count, bytes });
            object.is_time = kind == 0x44;
            object.unread = match kind {
                0x20 => text!("texts"),
                11 | 0x1b => text!("numbers of 16 bytes"),
                0x0008_000c | 0x0010_000d => text!("complex numbers"),
                _ => "",
            };
            true
        }
    };
    match listed.iter().position(|index| *index == place) {
        None if has_raw => listed.push(place),
        Some(index) if !has_raw => drop(listed.remove(index)),
        Some(_) | None => {}
    }
    for _ in 0..reader.u32()? {
        let name = text(reader)?;
        let kind = reader.u32()?;
        let property = match kind {
            0x20 => Property::Text(text(reader)?),
            _ => Property::Number(number(reader, kind)?),
        };
        objects[place].properties.insert(name, property);
    }
    Ok(())
}

/// A number of a type; not a number for one that is none.
fn number(reader: &mut ByteReader<'_>, kind: u32) -> Result<f64, DataFault> {
    Ok(match kind {
        1 => f64::from(reader.u8()? as i8),
        2 => f64::from(reader.u16()? as i16),
        3 => f64::from(reader.i32()?),
        4 => reader.i64()? as f64,
        5 | 0x21 => f64::from(reader.u8()?),
        6 => f64::from(reader.u16()?),
        7 => f64::from(reader.u32()?),
        8 => reader.u64()? as f64,
        9 | 0x19 => f64::from(reader.f32()?),
        10 | 0x1a => reader.f64()?,
        0x44 => {
            // The order of the two is that of a number of 128 bits.
            match reader.is_big_endian() {
                true => {
                    let seconds = reader.i64()?;
                    seconds as f64 + reader.u64()? as f64 / FRACTION
                }
                false => {
                    let fraction = reader.u64()?;
                    reader.i64()? as f64 + fraction as f64 / FRACTION
                }
            }
        }
        kind => {
            let Some(width) = width(kind) else {
                let found = tr!("a value of type {kind}", kind = format!("0x{kind:x}"));
                return Err(reader.fault(found, tr("numbers, texts or times")));
            };
            reader.take(width)?;
            f64::NAN
        }
    })
}

/// Reads the raw data of a segment: its channels one after the other, again and again to its end, or value by value in
/// turn. What is cut off at its end is left out.
fn values(
    mut reader: ByteReader<'_>,
    interleaved: bool,
    objects: &mut [TdmsObject],
    listed: &[usize],
) -> Result<(), DataFault> {
    let indices: Vec<(usize, RawIndex)> =
        listed.iter().filter_map(|place| Some((*place, objects[*place].index?))).collect();
    let chunk: u64 = indices.iter().fold(0, |sum, (_, index)| sum.saturating_add(index.bytes));
    if chunk == 0 {
        return Ok(());
    }
    while reader.left() > 0 {
        if interleaved {
            let row: usize = indices.iter().filter_map(|(_, index)| width(index.kind)).sum();
            if row == 0 || indices.iter().any(|(_, index)| width(index.kind).is_none()) {
                return Err(
                    reader.fault(tr("texts between numbers, value by value"), tr("numbers alone"))
                );
            }
            while reader.left() >= row {
                for (place, index) in &indices {
                    let value = number(&mut reader, index.kind)?;
                    keep(&mut objects[*place], value);
                }
            }
            break;
        }
        for (place, index) in &indices {
            let object = &mut objects[*place];
            let Some(width) = width(index.kind).filter(|_| object.unread.is_empty()) else {
                reader.skip(usize::try_from(index.bytes).unwrap_or(usize::MAX));
                continue;
            };
            let there = (reader.left() / width) as u64;
            let count = index.count.min(there);
            object.values.reserve(count as usize);
            for _ in 0..count {
                object.values.push(number(&mut reader, index.kind)?);
            }
            if count < index.count {
                return Ok(());
            }
        }
    }
    Ok(())
}

fn keep(object: &mut TdmsObject, value: f64) {
    if object.unread.is_empty() {
        object.values.push(value);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_are_parted_and_quotes_in_names_kept() {
        for (path, expected) in [
            ("/", &[][..]),
            ("/'Force'", &["Force"]),
            ("/'Force'/'F''x'", &["Force", "F'x"]),
            ("/'a/b'/'c'", &["a/b", "c"]),
            ("/'open", &["open"]),
        ] {
            assert_eq!(names(path), expected, "{path}");
        }
    }
}
