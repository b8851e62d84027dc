//! The values of a page: its compression and its encodings. Apache Parquet's format, versions 1 and 2 of pages.

use std::io::Read;

use super::snappy;
use super::thrift;
use crate::base::language::tr;
use crate::bytes::ByteReader;
use crate::fault::DataFault;

/// Most bytes of a page.
const MAX_PAGE: usize = 1 << 30;

/// How a number of the file is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Physical {
    Boolean,
    Int32,
    Int64,
    Float,
    Double,
}

impl Physical {
    /// The type of a number in a column's description.
    pub fn of(kind: i64) -> Option<Self> {
        match kind {
            0 => Some(Self::Boolean),
            1 => Some(Self::Int32),
            2 => Some(Self::Int64),
            4 => Some(Self::Float),
            5 => Some(Self::Double),
            _ => None,
        }
    }

    fn width(self) -> usize {
        match self {
            Self::Boolean => 1,
            Self::Int32 | Self::Float => 4,
            Self::Int64 | Self::Double => 8,
        }
    }

    fn is_whole(self) -> bool {
        match self {
            Self::Boolean | Self::Int32 | Self::Int64 => true,
            Self::Float | Self::Double => false,
        }
    }

    /// A number from its bytes, the lowest first.
    fn number(self, bytes: &[u8]) -> Stored {
        let mut eight = [0; 8];
        eight[..bytes.len().min(8)].copy_from_slice(&bytes[..bytes.len().min(8)]);
        let whole = u64::from_le_bytes(eight);
        match self {
            Self::Boolean => Stored::Whole(i64::from(whole != 0)),
            Self::Int32 => Stored::Whole(i64::from(whole as u32 as i32)),
            Self::Int64 => Stored::Whole(whole as i64),
            Self::Float => Stored::Real(f64::from(f32::from_bits(whole as u32))),
            Self::Double => Stored::Real(f64::from_bits(whole)),
        }
    }
}

/// A number as it is stored: whole ones of 64 bits lose digits as doubles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Stored {
    Whole(i64),
    Real(f64),
}

/// The bytes of a page, which are `size` of them.
pub(super) fn inflated(
    codec: i64,
    bytes: &[u8],
    size: usize,
    place: usize,
) -> Result<Vec<u8>, DataFault> {
    let spoilt = || DataFault::at(place, tr("compressed bytes that are spoilt"), tr("a page"));
    if size > MAX_PAGE {
        let found = tr!("a page of {size} bytes", size = size);
        return Err(DataFault::at(place, found, tr!("at most {most}", most = MAX_PAGE)));
    }
    let found = match codec {
        0 => bytes.to_vec(),
        1 => snappy::unpacked(bytes, size).ok_or_else(spoilt)?,
        2 => {
            let raw = without_gzip_head(bytes).ok_or_else(spoilt)?;
            miniz_oxide::inflate::decompress_to_vec_with_limit(raw, size).map_err(|_| spoilt())?
        }
        6 => {
            let decoder = ruzstd::decoding::StreamingDecoder::new(bytes).map_err(|_| spoilt())?;
            let mut found = Vec::new();
            decoder.take(size as u64 + 1).read_to_end(&mut found).map_err(|_| spoilt())?;
            found
        }
        codec => {
            let name = ["", "", "", "LZO", "Brotli", "LZ4", "", "LZ4"];
            let name = usize::try_from(codec).ok().and_then(|codec| name.get(codec)).unwrap_or(&"");
            let found = tr!("the compression {name} (number {codec})", name = *name, codec = codec);
            return Err(DataFault::at(place, found, tr("none, Snappy, gzip or Zstandard")));
        }
    };
    if found.len() != size {
        let told = tr!("a page of {size} bytes", size = found.len());
        return Err(DataFault::at(place, told, tr!("{count} bytes", count = size)));
    }
    Ok(found)
}

/// What stands behind gzip's head (RFC 1952).
fn without_gzip_head(bytes: &[u8]) -> Option<&[u8]> {
    let flags = match bytes {
        [0x1f, 0x8b, 8, flags, ..] => *flags,
        _ => return None,
    };
    let mut rest = bytes.get(10..)?;
    if flags & 4 != 0 {
        let length = usize::from(u16::from_le_bytes([*rest.first()?, *rest.get(1)?]));
        rest = rest.get(2 + length..)?;
    }
    for flag in [8, 16] {
        if flags & flag != 0 {
            let end = rest.iter().position(|byte| *byte == 0)?;
            rest = &rest[end + 1..];
        }
    }
    rest.get(if flags & 2 != 0 { 2 } else { 0 }..)
}

/// Numbers in runs and packed bits, `count` of them.
pub(super) fn hybrid(
    reader: &mut ByteReader<'_>,
    bits: u32,
    count: usize,
) -> Result<Vec<u64>, DataFault> {
    if bits > 64 {
        return Err(reader.fault(tr!("numbers of {bits} bits", bits = bits), tr("at most 64")));
    }
    let mut found: Vec<u64> = Vec::new();
    let width = bits.div_ceil(8) as usize;
    while found.len() < count {
        let head = thrift::unsigned(reader)?;
        let left = count - found.len();
        if head & 1 == 0 {
            let mut eight = [0; 8];
            eight[..width].copy_from_slice(reader.take(width)?);
            let run = usize::try_from(head >> 1).unwrap_or(usize::MAX).min(left);
            if run == 0 {
                return Err(reader.fault(tr("a run of no values"), tr("at least one")));
            }
            found.resize(found.len() + run, u64::from_le_bytes(eight));
        } else {
            let groups = usize::try_from(head >> 1).unwrap_or(usize::MAX);
            let bytes = groups.saturating_mul(bits as usize).min(reader.left());
            let packed = reader.take(bytes)?;
            let there = if bits == 0 { left } else { packed.len() * 8 / bits as usize };
            let taken = groups.saturating_mul(8).min(left).min(there);
            if taken == 0 {
                return Err(reader.fault(tr("no packed numbers"), tr("at least one")));
            }
            found.extend((0..taken).map(|index| packed_at(packed, index, bits)));
        }
    }
    Ok(found)
}

/// A number among those packed, the lowest bits first.
fn packed_at(bytes: &[u8], index: usize, bits: u32) -> u64 {
    let from = index * bits as usize;
    (0..bits as usize).fold(0, |number, bit| {
        let at = from + bit;
        let set = bytes.get(at / 8).is_some_and(|byte| byte >> (at % 8) & 1 == 1);
        number | u64::from(set) << bit
    })
}

/// The values of a page, `count` of them.
pub(super) fn values(
    reader: &mut ByteReader<'_>,
    encoding: i64,
    physical: Physical,
    count: usize,
    dictionary: Option<&[Stored]>,
) -> Result<Vec<Stored>, DataFault> {
    let width = physical.width();
    match (encoding, dictionary) {
        (0, _) if physical == Physical::Boolean => {
            let packed = reader.take(count.div_ceil(8))?;
            Ok((0..count).map(|index| Stored::Whole(packed_at(packed, index, 1) as i64)).collect())
        }
        (0, _) => {
            let bytes = reader.take(count.saturating_mul(width))?;
            Ok(bytes.chunks_exact(width).map(|bytes| physical.number(bytes)).collect())
        }
        // A dictionary's numbers.
        (2 | 8, Some(dictionary)) => {
            if count == 0 {
                return Ok(Vec::new());
            }
            let bits = u32::from(reader.u8()?);
            let indices = hybrid(reader, bits, count)?;
            let of = |index: &u64| {
                usize::try_from(*index).ok().and_then(|index| dictionary.get(index)).copied()
            };
            indices.iter().map(of).collect::<Option<Vec<Stored>>>().ok_or_else(|| {
                let found = tr("a number that the dictionary does not have");
                reader.fault(found, tr!("below {count}", count = dictionary.len()))
            })
        }
        (3, _) if physical == Physical::Boolean => {
            reader.u32()?;
            let bits = hybrid(reader, 1, count)?;
            Ok(bits.into_iter().map(|bit| Stored::Whole(bit as i64)).collect())
        }
        (5, _) if physical.is_whole() => {
            let whole = differences(reader, count)?;
            let narrow = |x: i64| if physical == Physical::Int32 { i64::from(x as i32) } else { x };
            Ok(whole.into_iter().map(|x| Stored::Whole(narrow(x))).collect())
        }
        // All first bytes, then all second ones, ...
        (9, _) => {
            let bytes = reader.take(count.saturating_mul(width))?;
            let number = |index: usize| {
                let mut of = [0; 8];
                for (place, byte) in of.iter_mut().enumerate().take(width) {
                    *byte = bytes[place * count + index];
                }
                physical.number(&of[..width])
            };
            Ok((0..count).map(number).collect())
        }
        (encoding, _) => {
            let found = tr!("the encoding {encoding}", encoding = encoding);
            Err(reader.fault(found, tr("plain, dictionary, runs, differences or split bytes")))
        }
    }
}

/// Whole numbers by their differences, in blocks of packed bits.
fn differences(reader: &mut ByteReader<'_>, count: usize) -> Result<Vec<i64>, DataFault> {
    let block = thrift::unsigned(reader)?;
    let parts = thrift::unsigned(reader)?;
    let (total, first) = thrift::numbers(reader)?;
    let total = usize::try_from(total).unwrap_or(usize::MAX);
    let per_part = block.checked_div(parts).unwrap_or(0);
    let sound = (8..=1 << 20).contains(&per_part) && per_part % 8 == 0 && parts <= 1 << 12;
    if !sound || total != count {
        let found = tr!("{count} values in {parts} parts", count = total, parts = parts);
        return Err(reader.fault(found, tr!("{count} values", count = count)));
    }
    let mut found = Vec::new();
    let mut last = first;
    if count > 0 {
        found.push(first);
    }
    while found.len() < count {
        let least = thrift::signed(reader)?;
        let widths = reader.take(parts as usize)?;
        for bits in widths {
            let bits = u32::from(*bits);
            if found.len() >= count {
                break;
            }
            if bits > 64 {
                return Err(
                    reader.fault(tr!("numbers of {bits} bits", bits = bits), tr("at most 64"))
                );
            }
            let packed = reader.take(per_part as usize * bits as usize / 8)?;
            for index in 0..(per_part as usize).min(count - found.len()) {
                let step = least.wrapping_add(packed_at(packed, index, bits) as i64);
                last = last.wrapping_add(step);
                found.push(last);
            }
        }
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_formats_own_examples_are_read() {
        // Parquet's documentation: 0 to 7 in three bits each.
        let mut reader = ByteReader::new(&[0x03, 0x88, 0xc6, 0xfa], 0);
        assert_eq!(hybrid(&mut reader, 3, 8).unwrap(), [0, 1, 2, 3, 4, 5, 6, 7]);
        // A run of five fours.
        let mut reader = ByteReader::new(&[0x0a, 0x04], 0);
        assert_eq!(hybrid(&mut reader, 3, 5).unwrap(), [4; 5]);
        // 1 to 5: differences of 1, a block of 8 in one part, no bits.
        let mut reader = ByteReader::new(&[8, 1, 5, 2, 2, 0], 0);
        assert_eq!(differences(&mut reader, 5).unwrap(), [1, 2, 3, 4, 5]);
        // 7, 5, 3, 1, 2, 3, 4, 5: the least difference is -2, the others are 0 0 0 3 3 3 3 above it.
        let mut reader = ByteReader::new(&[8, 1, 8, 14, 3, 2, 0xc0, 0x3f], 0);
        assert_eq!(differences(&mut reader, 8).unwrap(), [7, 5, 3, 1, 2, 3, 4, 5]);
        // Two floats with their bytes split.
        let [a, b] = [1.5f32, -2.25].map(f32::to_le_bytes);
        let split: Vec<u8> = a.iter().zip(&b).flat_map(|(a, b)| [*a, *b]).collect();
        let read = values(&mut ByteReader::new(&split, 0), 9, Physical::Float, 2, None).unwrap();
        assert_eq!(read, [Stored::Real(1.5), Stored::Real(-2.25)]);
    }

    #[test]
    fn pages_that_claim_too_much_are_refused() {
        assert!(inflated(0, b"abc", 4, 0).unwrap_err().to_string().contains("expected is 4 bytes"));
        assert!(inflated(4, b"", 0, 0).unwrap_err().to_string().contains("Brotli"));
        assert!(inflated(1, &[0xff, 0xff, 0xff, 0x7f, 0], 1 << 20, 0).is_err());
        assert!(hybrid(&mut ByteReader::new(&[0], 0), 0, 5).is_err());
        assert!(hybrid(&mut ByteReader::new(&[], 0), 1, 5).is_err());
    }
}
