//! What chunks went through before they were written: undone in the other order.

use std::io::Read;

use miniz_oxide::inflate::decompress_to_vec_zlib_with_limit;

use super::checksum::fletcher32;
use super::file::{Trouble, unknown};
use crate::base::language::{text, tr};
use crate::bytes::ByteReader;
use crate::fault::DataFault;

/// Something that chunks went through.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Filter {
    kind: FilterKind,
}

#[derive(Clone, Debug, PartialEq)]
enum FilterKind {
    Deflate,
    /// All first bytes of elements of this size, then all second ones, ...
    Shuffle(usize),
    Fletcher32,
    /// h5py's own, LZF.
    Lzf,
    Zstandard,
    /// One that is not undone; a text for people.
    Other(&'static str),
}

/// The filters of a message.
pub(super) fn filters(reader: &mut ByteReader<'_>) -> Result<Vec<Filter>, DataFault> {
    let version = reader.u8()?;
    let count = reader.u8()?;
    match version {
        1 => {
            reader.take(6)?;
        }
        2 => {}
        version => return Err(unknown(reader, text!("a list of filters"), version)),
    }
    let mut found = Vec::new();
    for _ in 0..count {
        let id = reader.u16()?;
        let named = version == 1 || id >= 256;
        let name = if named { usize::from(reader.u16()?) } else { 0 };
        reader.take(2)?;
        let values = usize::from(reader.u16()?);
        reader.take(if version == 1 { name.next_multiple_of(8) } else { name })?;
        let mut first = None;
        for _ in 0..values {
            let value = reader.u32()?;
            first = first.or(Some(value));
        }
        reader.take(if version == 1 { 4 * (values % 2) } else { 0 })?;
        let kind = match (id, first) {
            (1, _) => FilterKind::Deflate,
            (2, Some(size)) => FilterKind::Shuffle(size as usize),
            (3, _) => FilterKind::Fletcher32,
            (32000, _) => FilterKind::Lzf,
            (32015, _) => FilterKind::Zstandard,
            (4, _) => FilterKind::Other(text!("compressed by szip, which is not read")),
            (32001, _) => FilterKind::Other(text!("compressed by Blosc, which is not read")),
            (_, _) => FilterKind::Other(text!("compressed in a way that is not read")),
        };
        found.push(Filter { kind });
    }
    Ok(found)
}

/// The bytes of a chunk, `size` of them; `mask` has the filters that it did not go through.
pub(super) fn undone(
    filters: &[Filter],
    mask: u32,
    packed: &[u8],
    size: usize,
    place: usize,
) -> Result<Vec<u8>, Trouble> {
    let mut bytes = packed.to_vec();
    for (number, filter) in filters.iter().enumerate().rev() {
        if number < 32 && mask >> number & 1 == 1 {
            continue;
        }
        // A checksum that was compressed with the chunk stands behind it.
        let most = size.saturating_add(4);
        let spoilt = || DataFault::at(place, tr("compressed bytes that are spoilt"), tr("a chunk"));
        bytes = match filter.kind {
            FilterKind::Deflate => {
                decompress_to_vec_zlib_with_limit(&bytes, most).map_err(|_| spoilt())?
            }
            FilterKind::Shuffle(each) => unshuffled(&bytes, each),
            FilterKind::Fletcher32 => checked(bytes, place)?,
            FilterKind::Lzf => unpacked(&bytes, most).ok_or_else(spoilt)?,
            FilterKind::Zstandard => {
                let decoder = ruzstd::decoding::StreamingDecoder::new(bytes.as_slice());
                let mut found = Vec::new();
                let decoder = decoder.map_err(|_| spoilt())?;
                decoder.take(most as u64).read_to_end(&mut found).map_err(|_| spoilt())?;
                found
            }
            FilterKind::Other(what) => return Err(Trouble::Unread(what)),
        };
    }
    if bytes.len() != size {
        let found = tr!("a chunk of {size} bytes", size = bytes.len());
        return Err(DataFault::at(place, found, tr!("{count} bytes", count = size)).into());
    }
    Ok(bytes)
}

fn unshuffled(bytes: &[u8], each: usize) -> Vec<u8> {
    let count = bytes.len() / each.max(1);
    if each < 2 || count < 2 {
        return bytes.to_vec();
    }
    let mut found = Vec::with_capacity(bytes.len());
    for index in 0..count {
        found.extend((0..each).map(|byte| bytes[byte * count + index]));
    }
    // What is less than an element stays in its place.
    found.extend(&bytes[count * each..]);
    found
}

fn checked(mut bytes: Vec<u8>, place: usize) -> Result<Vec<u8>, DataFault> {
    let end = bytes.len().checked_sub(4);
    let sound = end.filter(|end| {
        let (values, sum) = bytes.split_at(*end);
        fletcher32(values).to_le_bytes() == *sum
    });
    match sound {
        Some(end) => bytes.truncate(end),
        None => {
            let found = tr("values whose checksum does not fit");
            return Err(DataFault::at(place, found, tr("those that were written")));
        }
    }
    Ok(bytes)
}

/// LibLZF's format: pieces as they are, and pieces of what was there before.
fn unpacked(bytes: &[u8], most: usize) -> Option<Vec<u8>> {
    let mut found: Vec<u8> = Vec::new();
    let mut rest = bytes.iter().copied();
    while let Some(head) = rest.next() {
        let head = usize::from(head);
        if head < 32 {
            for _ in 0..=head {
                found.push(rest.next()?);
            }
        } else {
            let length = match head >> 5 {
                7 => 9 + usize::from(rest.next()?),
                length => 2 + length,
            };
            let back = (head & 31) << 8 | usize::from(rest.next()?);
            let from = found.len().checked_sub(back + 1)?;
            for index in from..from + length {
                found.push(*found.get(index)?);
            }
        }
        if found.len() > most {
            return None;
        }
    }
    Some(found)
}
