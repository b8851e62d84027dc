//! The elements of a MATLAB v5 file as values: "MAT-File Format" (MathWorks), level 5. Lengths are believed only as far
//! as the file has bytes for them.

use miniz_oxide::inflate::decompress_to_vec_zlib_with_limit;

use crate::base::language::{text, tr};
use crate::bytes::ByteReader;
use crate::contents::{ColumnsTold, ContentEntry, ContentValue};
use crate::fault::DataFault;

/// Bytes of the file's header.
const HEADER: usize = 128;
/// How deep structures and cells may lie in each other.
const MAX_DEPTH: usize = 32;
/// Most that compressed bytes can become (deflate: 1032 to 1), and the most that is taken at all.
const MAX_RATIO: usize = 1100;
const MAX_INFLATED: usize = 2_000_000_000;

/// Types of elements.
const COMPRESSED: u32 = 15;
const MATRIX: u32 = 14;

/// Whether bytes begin as a file of this format.
pub(crate) fn is(bytes: &[u8]) -> bool {
    let of_version_5 = [Some(&b"\x00\x01IM"[..]), Some(&b"\x01\x00MI"[..])];
    bytes.starts_with(b"MATLAB 5.0 MAT-file") || of_version_5.contains(&bytes.get(124..HEADER))
}

/// All variables of a file.
///
/// # Errors
/// The place of what is not as the format has it.
pub(super) fn variables(bytes: &[u8]) -> Result<Vec<ContentEntry>, DataFault> {
    let mut reader = ByteReader::new(bytes, 0);
    reader.take(HEADER - 2)?;
    let big_endian = match reader.take(2)? {
        b"IM" => false,
        b"MI" => true,
        other => {
            let found = tr!("the bytes {bytes}", bytes = format!("{other:02x?}"));
            return Err(DataFault::at(HEADER - 2, found, tr("the order of bytes, `IM` or `MI`")));
        }
    };
    let mut reader = reader.ordered(big_endian);
    let mut found = Vec::new();
    while reader.left() > 0 {
        let place = reader.place();
        let element = Element::next(&mut reader)?;
        match element.kind {
            COMPRESSED => {
                let most = element.data.len().saturating_mul(MAX_RATIO).min(MAX_INFLATED);
                let inflated =
                    decompress_to_vec_zlib_with_limit(element.data, most).map_err(|_| {
                        DataFault::at(
                            place,
                            tr("compressed bytes that are spoilt"),
                            tr("zlib's format"),
                        )
                    })?;
                // Places within are those of the compressed bytes.
                let mut inner = ByteReader::new(&inflated, place).ordered(big_endian);
                let element = Element::next(&mut inner)?;
                found.extend(variable(&element, big_endian, place)?);
            }
            _ => found.extend(variable(&element, big_endian, place)?),
        }
    }
    Ok(found)
}

/// The variable in an element; none for what the file keeps for itself.
fn variable(
    element: &Element<'_>,
    big_endian: bool,
    place: usize,
) -> Result<Option<ContentEntry>, DataFault> {
    if element.kind != MATRIX {
        let found = tr!("an element of type {kind}", kind = element.kind);
        return Err(DataFault::at(place, found, tr("a variable (type 14 or 15)")));
    }
    let reader = ByteReader::new(element.data, element.place).ordered(big_endian);
    let (name, value) = matrix(reader, 0)?;
    Ok((!name.is_empty()).then_some(ContentEntry { name, value }))
}

/// A tagged piece of the file.
struct Element<'a> {
    kind: u32,
    data: &'a [u8],
    place: usize,
    big_endian: bool,
}

impl<'a> Element<'a> {
    fn next(reader: &mut ByteReader<'a>) -> Result<Self, DataFault> {
        let big_endian = reader.is_big_endian();
        let tag = reader.u32()?;
        // A small element has its length in the tag, and its data in the place of the length.
        if tag >> 16 != 0 {
            let place = reader.place();
            let data = reader.take(4)?;
            let length = (tag >> 16) as usize;
            let Some(data) = data.get(..length) else {
                let found = tr!("a small element of {length} bytes", length = length);
                return Err(DataFault::at(place, found, tr("at most 4")));
            };
            return Ok(Self { kind: tag & 0xffff, data, place, big_endian });
        }
        let length = reader.u32()? as usize;
        let place = reader.place();
        let data = reader.take(length)?;
        if tag != COMPRESSED {
            reader.skip(length.next_multiple_of(8) - length);
        }
        Ok(Self { kind: tag, data, place, big_endian })
    }

    /// Its numbers, whatever they are stored as.
    fn numbers(&self) -> Result<Vec<f64>, DataFault> {
        macro_rules! all {
            ($type:ty) => {{
                let (whole, _) = self.data.as_chunks();
                let big = self.big_endian;
                let number = |bytes: &[u8; size_of::<$type>()]| {
                    (if big {
                        <$type>::from_be_bytes(*bytes)
                    } else {
                        <$type>::from_le_bytes(*bytes)
                    }) as f64
                };
                Ok(whole.iter().map(number).collect())
            }};
        }
        match self.kind {
            1 => all!(i8),
            2 => all!(u8),
            3 => all!(i16),
            4 => all!(u16),
            5 => all!(i32),
            6 => all!(u32),
            7 => all!(f32),
            9 => all!(f64),
            12 => all!(i64),
            13 => all!(u64),
            kind => {
                let found = tr!("an element of type {kind}", kind = kind);
                Err(DataFault::at(self.place, found, tr("numbers (types 1 to 9, 12, 13)")))
            }
        }
    }

    /// Its characters.
    fn text(&self) -> Result<String, DataFault> {
        match self.kind {
            // UTF-8, and bytes.
            16 | 1 | 2 => Ok(self.data.iter().map(|byte| char::from(*byte)).collect::<String>())
                .map(|latin| std::str::from_utf8(self.data).map_or(latin, str::to_owned)),
            // UTF-16, and the same by its type of numbers.
            17 | 4 => {
                let units: Vec<u16> =
                    Self { kind: 4, ..*self }.numbers()?.into_iter().map(|x| x as u16).collect();
                Ok(String::from_utf16_lossy(&units))
            }
            kind => {
                let found = tr!("an element of type {kind}", kind = kind);
                Err(DataFault::at(self.place, found, tr("characters (types 1, 2, 4, 16, 17)")))
            }
        }
    }
}

/// A whole number of an array's size.
fn size(number: f64, reader: &ByteReader<'_>) -> Result<usize, DataFault> {
    let fits = (0.0..=2_147_483_647.0).contains(&number);
    fits.then_some(number as usize)
        .ok_or_else(|| reader.fault(tr!("a size of {size}", size = number), tr("0 to 2147483647")))
}

/// The name and value of a matrix, which anything is.
fn matrix(mut reader: ByteReader<'_>, depth: usize) -> Result<(String, ContentValue), DataFault> {
    let nothing = ContentValue::numbers(vec![0, 0], Vec::new());
    if reader.left() == 0 {
        return Ok((String::new(), nothing));
    }
    if depth > MAX_DEPTH {
        let found = tr!("structures more than {depth} deep in each other", depth = MAX_DEPTH);
        return Err(reader.fault(found, ""));
    }
    let flags = Element::next(&mut reader)?.numbers()?.first().copied().unwrap_or(0.0) as u32;
    let (class, complex) = (flags & 0xff, flags & 0x800 != 0);
    // What classes of one's own keep their data in.
    if class == 17 {
        return Ok((String::new(), ContentValue::Other(text!("an object of a class"))));
    }
    let dims = Element::next(&mut reader)?.numbers()?;
    let dims: Vec<usize> = dims.into_iter().map(|x| size(x, &reader)).collect::<Result<_, _>>()?;
    let count = dims.iter().try_fold(1usize, |all, size| all.checked_mul(*size));
    let too_many = |reader: &ByteReader<'_>| {
        let dims: Vec<String> = dims.iter().map(usize::to_string).collect();
        let found = tr!("an array of {size} values", size = dims.join(" x "));
        let expected = tr!("no more than the {left} bytes that follow hold", left = reader.left());
        reader.fault(found, expected)
    };
    let name = Element::next(&mut reader)?.text()?;
    // Every value takes a byte at least.
    let count = count.filter(|count| *count <= reader.left()).ok_or_else(|| too_many(&reader))?;
    let value = match class {
        1 => ContentValue::Cells(values(&mut reader, count, depth)?),
        2 | 3 => {
            if class == 3 {
                Element::next(&mut reader)?;
            }
            records(&mut reader, count, depth)?
        }
        4 => {
            let text =
                if count == 0 { String::new() } else { Element::next(&mut reader)?.text()? };
            ContentValue::Text(rows(&text, &dims))
        }
        5 => ContentValue::Other(text!("a sparse matrix")),
        6..=15 => {
            let element = Element::next(&mut reader)?;
            let values = element.numbers()?;
            if values.len() != count {
                let found = tr!("{count} values", count = values.len());
                return Err(DataFault::at(
                    element.place,
                    found,
                    tr!("{count} values", count = count),
                ));
            }
            ContentValue::Numbers { dims, values, complex, told: ColumnsTold::default() }
        }
        _ => ContentValue::Other(text!("a function or another class")),
    };
    Ok((name, value))
}

/// So many values, one after the other.
fn values(
    reader: &mut ByteReader<'_>,
    count: usize,
    depth: usize,
) -> Result<Vec<ContentValue>, DataFault> {
    let mut found = Vec::new();
    for _ in 0..count {
        let element = Element::next(reader)?;
        if element.kind != MATRIX {
            let what = tr!("an element of type {kind}", kind = element.kind);
            return Err(DataFault::at(element.place, what, tr("a value (type 14)")));
        }
        let inner = ByteReader::new(element.data, element.place).ordered(element.big_endian);
        found.push(matrix(inner, depth + 1)?.1);
    }
    Ok(found)
}

fn records(
    reader: &mut ByteReader<'_>,
    count: usize,
    depth: usize,
) -> Result<ContentValue, DataFault> {
    let length = Element::next(reader)?.numbers()?.first().copied().unwrap_or(0.0);
    let length = size(length, reader)?;
    let names = Element::next(reader)?;
    if length == 0 && !names.data.is_empty() {
        return Err(DataFault::at(names.place, tr("names of no length"), tr("1 to 64 characters")));
    }
    let name = |bytes: &[u8]| {
        let end = bytes.iter().position(|byte| *byte == 0).unwrap_or(bytes.len());
        String::from_utf8_lossy(&bytes[..end]).into_owned()
    };
    let fields: Vec<String> = names.data.chunks(length.max(1)).map(name).collect();
    let mut records = Vec::new();
    for _ in 0..count {
        records.push(values(reader, fields.len(), depth)?);
        if fields.is_empty() {
            break;
        }
    }
    Ok(ContentValue::Records { fields, records })
}

/// A text of several rows is stored column by column.
pub(crate) fn rows(text: &str, dims: &[usize]) -> String {
    let &[rows, columns] = dims else { return text.to_owned() };
    let letters: Vec<char> = text.chars().collect();
    if rows <= 1 || letters.len() != rows * columns {
        return text.to_owned();
    }
    let row = |row: usize| letters.iter().skip(row).step_by(rows).collect::<String>();
    (0..rows).map(|r| row(r).trim_end().to_owned()).collect::<Vec<_>>().join("\n")
}
