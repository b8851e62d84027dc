//! What an element of an array is.

use super::file::{Hdf5File, unknown, whole};
use super::header::{DATATYPE, Message, shared};
use crate::base::language::{text, tr};
use crate::bytes::ByteReader;
use crate::fault::DataFault;

/// How deep types may lie in each other.
const MAX_DEPTH: usize = 16;

/// A type.
#[derive(Clone, Debug)]
pub(super) struct Datatype {
    /// Bytes of an element.
    pub size: usize,
    pub kind: ElementKind,
}

/// What an element is.
#[derive(Clone, Debug)]
pub(super) enum ElementKind {
    Number(Number),
    /// Characters, as many as the element has bytes.
    Text,
    /// Bytes of any number that lie in a heap, characters or values of this many bytes.
    Elsewhere {
        bytes_each: usize,
        text: bool,
    },
    /// The address of an object.
    Reference,
    Record(Vec<Field>),
    /// The same several times.
    Several(Box<Datatype>, usize),
    /// What has no numbers; a text for people.
    Other(&'static str),
}

/// A part of a record.
#[derive(Clone, Debug)]
pub(super) struct Field {
    pub name: String,
    /// Its first byte.
    pub at: usize,
    pub of: Datatype,
}

/// How a number is stored.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Number {
    pub size: usize,
    pub big_endian: bool,
    pub form: NumberForm,
}

/// What the bits of a number are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum NumberForm {
    Whole { signed: bool, shift: u32, bits: u32 },
    Float,
}

impl Number {
    /// The number in its bytes.
    pub fn value(self, bytes: &[u8]) -> f64 {
        let mut eight = [0; 8];
        for (place, byte) in bytes.iter().take(self.size).enumerate() {
            eight[if self.big_endian { self.size - 1 - place } else { place }] = *byte;
        }
        let all = u64::from_le_bytes(eight);
        match self.form {
            NumberForm::Float if self.size == 2 => half(all as u16),
            NumberForm::Float if self.size == 4 => f64::from(f32::from_bits(all as u32)),
            NumberForm::Float => f64::from_bits(all),
            NumberForm::Whole { signed, shift, bits } => {
                let high = (all >> shift) << (64 - bits);
                match signed {
                    true => (high as i64 >> (64 - bits)) as f64,
                    false => (high >> (64 - bits)) as f64,
                }
            }
        }
    }
}

/// A float of 16 bits.
fn half(bits: u16) -> f64 {
    const UNIT: f64 = 1.0 / (1u32 << 24) as f64;
    let (exponent, fraction) = (bits >> 10 & 31, f64::from(bits & 1023));
    let size = match exponent {
        0 => fraction * UNIT,
        31 if fraction == 0.0 => f64::INFINITY,
        31 => f64::NAN,
        exponent => (1024.0 + fraction) * UNIT * (1u32 << (exponent - 1)) as f64,
    };
    if bits >> 15 == 1 { -size } else { size }
}

impl Datatype {
    /// The type that a message tells.
    pub fn of(file: &Hdf5File<'_>, message: &Message<'_>) -> Result<Self, DataFault> {
        Self::read(&mut message.resolved(file)?, 0)
    }

    /// The type in an attribute, which may be one of another object.
    pub fn within<'a>(
        file: &Hdf5File<'a>,
        reader: &mut ByteReader<'a>,
        is_shared: bool,
    ) -> Result<Self, DataFault> {
        match is_shared {
            true => Self::read(&mut shared(file, reader, DATATYPE)?, 0),
            false => Self::read(reader, 0),
        }
    }

    fn read(reader: &mut ByteReader<'_>, depth: usize) -> Result<Self, DataFault> {
        if depth > MAX_DEPTH {
            let found = tr!("types more than {depth} deep in each other", depth = MAX_DEPTH);
            return Err(reader.fault(found, ""));
        }
        let head = reader.u8()?;
        let (version, class) = (head >> 4, head & 15);
        if !(1..=5).contains(&version) {
            return Err(unknown(reader, text!("a type"), version));
        }
        let flags = whole(reader, 3)? as usize;
        let place = reader.place();
        let size = reader.u32()? as usize;
        if size == 0 {
            return Err(DataFault::at(place, tr("a type of no bytes"), tr("at least one")));
        }
        let kind = match class {
            0 | 4 => whole_number(reader, size, flags, class == 0)?,
            1 => float(reader, size, flags)?,
            2 => ElementKind::Other(text!("times")),
            3 => ElementKind::Text,
            5 => ElementKind::Other(text!("bytes without a meaning")),
            6 => record(reader, version, flags & 0xffff, size, depth)?,
            7 if flags & 15 == 0 && size <= 8 => ElementKind::Reference,
            7 => ElementKind::Other(text!("references to parts of arrays")),
            // Names and numbers of an enumeration follow: its base says all.
            8 => match Self::read(reader, depth + 1)? {
                base if base.size == size => base.kind,
                base => {
                    let found = tr!("{size} bytes", size = base.size);
                    return Err(DataFault::at(place, found, tr!("{count} bytes", count = size)));
                }
            },
            9 => {
                let bytes_each = Self::read(reader, depth + 1)?.size;
                ElementKind::Elsewhere { bytes_each, text: flags & 15 == 1 }
            }
            10 => several(reader, version, size, depth)?,
            11 => ElementKind::Other(text!("complex numbers")),
            class => {
                let found = tr!("a type of class {class}", class = class);
                return Err(DataFault::at(place, found, tr("0 to 11")));
            }
        };
        Ok(Self { size, kind })
    }
}

fn whole_number(
    reader: &mut ByteReader<'_>,
    size: usize,
    flags: usize,
    may_be_signed: bool,
) -> Result<ElementKind, DataFault> {
    let (shift, bits) = (u32::from(reader.u16()?), u32::from(reader.u16()?));
    if size > 8 {
        return Ok(ElementKind::Other(text!("whole numbers of more than 64 bits")));
    }
    if bits == 0 || shift + bits > 8 * size as u32 {
        let found = tr!("{bits} bits from bit {shift} on", bits = bits, shift = shift);
        return Err(reader.fault(found, tr!("within {size} bytes", size = size)));
    }
    let signed = may_be_signed && flags & 8 != 0;
    let form = NumberForm::Whole { signed, shift, bits };
    Ok(ElementKind::Number(Number { size, big_endian: flags & 1 != 0, form }))
}

fn float(reader: &mut ByteReader<'_>, size: usize, flags: usize) -> Result<ElementKind, DataFault> {
    let mut told = [0u32; 7];
    for (place, number) in told.iter_mut().enumerate() {
        *number = match place {
            0 | 1 => u32::from(reader.u16()?),
            6 => reader.u32()?,
            _ => u32::from(reader.u8()?),
        };
    }
    // First bit and bits, of all, of exponent and of fraction; what is taken off the exponent; the place of the sign.
    let known = match size {
        2 => [0, 16, 10, 5, 0, 10, 15],
        4 => [0, 32, 23, 8, 0, 23, 127],
        8 => [0, 64, 52, 11, 0, 52, 1023],
        _ => return Ok(ElementKind::Other(text!("floats of an unusual form"))),
    };
    // The order of bytes of a VAX has a bit of its own.
    if told != known || flags & 0x40 != 0 || flags >> 8 & 0xff != 8 * size - 1 {
        return Ok(ElementKind::Other(text!("floats of an unusual form")));
    }
    let number = Number { size, big_endian: flags & 1 != 0, form: NumberForm::Float };
    Ok(ElementKind::Number(number))
}

fn record(
    reader: &mut ByteReader<'_>,
    version: u8,
    count: usize,
    size: usize,
    depth: usize,
) -> Result<ElementKind, DataFault> {
    let mut fields = Vec::new();
    for _ in 0..count {
        let name = name(reader, version < 3)?;
        let place = reader.place();
        let at = match (version, size) {
            (1 | 2, _) => reader.u32()? as usize,
            (_, 0..=0xff) => whole(reader, 1)? as usize,
            (_, 0x100..=0xffff) => whole(reader, 2)? as usize,
            (_, 0x1_0000..=0xff_ffff) => whole(reader, 3)? as usize,
            (_, _) => whole(reader, 4)? as usize,
        };
        let mut several = 1usize;
        if version == 1 {
            let dimensions = usize::from(reader.u8()?);
            reader.take(11)?;
            for dimension in 0..4 {
                let size = reader.u32()? as usize;
                several = several.saturating_mul(if dimension < dimensions { size } else { 1 });
            }
        }
        let mut of = Datatype::read(reader, depth + 1)?;
        if several != 1 {
            let size = of.size.saturating_mul(several);
            of = Datatype { size, kind: ElementKind::Several(Box::new(of), several) };
        }
        if at.checked_add(of.size).is_none_or(|end| end > size) {
            let found = tr!("{bytes} bytes from byte {at} on", bytes = of.size, at = at);
            return Err(DataFault::at(place, found, tr!("within {size} bytes", size = size)));
        }
        fields.push(Field { name, at, of });
    }
    Ok(ElementKind::Record(fields))
}

/// A name that ends with a zero; older ones fill up eight bytes.
fn name(reader: &mut ByteReader<'_>, filled: bool) -> Result<String, DataFault> {
    let mut bytes = Vec::new();
    loop {
        match reader.u8()? {
            0 => break,
            byte => bytes.push(byte),
        }
    }
    let length = bytes.len() + 1;
    reader.take(if filled { length.next_multiple_of(8) - length } else { 0 })?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

fn several(
    reader: &mut ByteReader<'_>,
    version: u8,
    size: usize,
    depth: usize,
) -> Result<ElementKind, DataFault> {
    let dimensions = usize::from(reader.u8()?);
    reader.take(if version < 3 { 3 } else { 0 })?;
    let mut count = 1usize;
    for _ in 0..dimensions {
        count = count.saturating_mul(reader.u32()? as usize);
    }
    reader.take(if version < 3 { 4 * dimensions } else { 0 })?;
    let place = reader.place();
    let of = Datatype::read(reader, depth + 1)?;
    if count == 0 || of.size.checked_mul(count) != Some(size) {
        let found = tr!("{count} elements of {bytes} bytes", count = count, bytes = of.size);
        return Err(DataFault::at(place, found, tr!("{count} bytes", count = size)));
    }
    Ok(ElementKind::Several(Box::new(of), count))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_few_bits_and_halves() {
        let whole = |signed, shift, bits| NumberForm::Whole { signed, shift, bits };
        let number = |size, big_endian, form| Number { size, big_endian, form };
        // Twelve bits in the middle of two bytes, as analogue inputs have them.
        assert_eq!(number(2, false, whole(true, 4, 12)).value(&[0xf0, 0xff]), -1.0);
        assert_eq!(number(2, false, whole(false, 4, 12)).value(&[0xf0, 0xff]), 4095.0);
        assert_eq!(number(3, true, whole(true, 0, 24)).value(&[0xff, 0xff, 0xfe]), -2.0);
        assert_eq!(
            number(8, false, whole(false, 0, 64)).value(&[0, 0, 0, 0, 0, 0, 0, 128]),
            9_223_372_036_854_775_808.0
        );
        // IEEE 754: 1, -2, the largest, the least.
        for (bits, known) in
            [(0x3c00, 1.0), (0xc000, -2.0), (0x7bff, 65504.0), (1, 5.960_464_477_539_063e-8)]
        {
            assert_eq!(half(bits), known);
        }
        assert!(half(0x7e00).is_nan() && half(0xfc00) == f64::NEG_INFINITY);
    }
}
