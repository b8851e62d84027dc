//! Thrift's compact protocol, in which a Parquet file describes itself: any structure as a tree.

use std::collections::BTreeMap;

use crate::base::language::tr;
use crate::bytes::ByteReader;
use crate::fault::DataFault;

/// How deep structures may lie in each other.
const MAX_DEPTH: usize = 24;

/// A value of a description.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Thrift<'a> {
    Bool(bool),
    Int(i64),
    Double(f64),
    Bytes(&'a [u8]),
    List(Vec<Thrift<'a>>),
    Struct(BTreeMap<i64, Thrift<'a>>),
}

impl<'a> Thrift<'a> {
    /// A structure from the bytes.
    pub fn read(reader: &mut ByteReader<'a>) -> Result<Self, DataFault> {
        structure(reader, 0)
    }

    /// A field of a structure.
    pub fn field(&self, id: i64) -> Option<&Self> {
        match self {
            Self::Struct(fields) => fields.get(&id),
            Self::Bool(_) | Self::Int(_) | Self::Double(_) | Self::Bytes(_) | Self::List(_) => None,
        }
    }

    /// A whole number in a field.
    pub fn int(&self, id: i64) -> Option<i64> {
        match self.field(id)? {
            Self::Int(x) => Some(*x),
            Self::Bool(_) | Self::Double(_) | Self::Bytes(_) | Self::List(_) | Self::Struct(_) => {
                None
            }
        }
    }

    /// A text in a field.
    pub fn text(&self, id: i64) -> Option<String> {
        self.field(id)?.as_text()
    }

    /// It as a text.
    pub fn as_text(&self) -> Option<String> {
        match self {
            Self::Bytes(bytes) => Some(String::from_utf8_lossy(bytes).into_owned()),
            Self::Bool(_) | Self::Int(_) | Self::Double(_) | Self::List(_) | Self::Struct(_) => {
                None
            }
        }
    }

    /// A list in a field; empty where there is none.
    pub fn list(&self, id: i64) -> &[Self] {
        match self.field(id) {
            Some(Self::List(list)) => list,
            Some(
                Self::Bool(_) | Self::Int(_) | Self::Double(_) | Self::Bytes(_) | Self::Struct(_),
            )
            | None => &[],
        }
    }
}

fn varint(reader: &mut ByteReader<'_>) -> Result<u64, DataFault> {
    let mut value = 0u64;
    for shift in (0..64).step_by(7) {
        let byte = reader.u8()?;
        value |= u64::from(byte & 0x7f) << shift;
        if byte & 0x80 == 0 {
            return Ok(value);
        }
    }
    Err(reader.fault(tr("a number of more than 64 bits"), tr("at most 64")))
}

/// Signed numbers are stored by turns: 0, -1, 1, -2, ...
fn zigzag(reader: &mut ByteReader<'_>) -> Result<i64, DataFault> {
    let value = varint(reader)?;
    Ok((value >> 1) as i64 ^ -((value & 1) as i64))
}

/// The same of a page's data.
pub(super) fn numbers(reader: &mut ByteReader<'_>) -> Result<(u64, i64), DataFault> {
    Ok((varint(reader)?, zigzag(reader)?))
}

/// An unsigned number of a page's data.
pub(super) fn unsigned(reader: &mut ByteReader<'_>) -> Result<u64, DataFault> {
    varint(reader)
}

/// A signed number of a page's data.
pub(super) fn signed(reader: &mut ByteReader<'_>) -> Result<i64, DataFault> {
    zigzag(reader)
}

fn structure<'a>(reader: &mut ByteReader<'a>, depth: usize) -> Result<Thrift<'a>, DataFault> {
    let mut fields = BTreeMap::new();
    let mut id = 0i64;
    loop {
        let head = reader.u8()?;
        if head == 0 {
            return Ok(Thrift::Struct(fields));
        }
        id = match head >> 4 {
            0 => zigzag(reader)?,
            step => id.saturating_add(i64::from(step)),
        };
        let value = match head & 0xf {
            1 => Thrift::Bool(true),
            2 => Thrift::Bool(false),
            kind => value(reader, kind, depth + 1)?,
        };
        fields.insert(id, value);
    }
}

fn value<'a>(reader: &mut ByteReader<'a>, kind: u8, depth: usize) -> Result<Thrift<'a>, DataFault> {
    if depth > MAX_DEPTH {
        let found = tr!("structures more than {depth} deep in each other", depth = MAX_DEPTH);
        return Err(reader.fault(found, ""));
    }
    Ok(match kind {
        // Within lists a truth value is a byte.
        1 | 2 => Thrift::Bool(reader.u8()? == 1),
        3 => Thrift::Int(i64::from(reader.u8()? as i8)),
        4..=6 => Thrift::Int(zigzag(reader)?),
        7 => Thrift::Double(reader.f64()?),
        8 => {
            let length = varint(reader)?;
            Thrift::Bytes(reader.take(usize::try_from(length).unwrap_or(usize::MAX))?)
        }
        9 | 10 => {
            let head = reader.u8()?;
            let count = match head >> 4 {
                15 => varint(reader)?,
                count => u64::from(count),
            };
            let mut list = Vec::new();
            for _ in 0..count {
                list.push(value(reader, head & 0xf, depth + 1)?);
            }
            Thrift::List(list)
        }
        11 => {
            let count = varint(reader)?;
            let kinds = if count == 0 { 0 } else { reader.u8()? };
            let mut list = Vec::new();
            for _ in 0..count {
                list.push(value(reader, kinds >> 4, depth + 1)?);
                list.push(value(reader, kinds & 0xf, depth + 1)?);
            }
            Thrift::List(list)
        }
        12 => structure(reader, depth)?,
        kind => {
            let found = tr!("a value of type {kind}", kind = kind);
            return Err(reader.fault(found, tr("types 1 to 12")));
        }
    })
}
