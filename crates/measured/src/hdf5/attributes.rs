//! Attributes: small values that say something of an object.

use super::btree2;
use super::datatype::Datatype;
use super::decode::{DimensionOrder, ElementBytes, value};
use super::file::{Hdf5File, Trouble, unknown};
use super::header::{ATTRIBUTE, ATTRIBUTE_INFO, DATASPACE, Header, shared};
use super::heaps::FractalHeap;
use super::layout::Space;
use crate::base::language::text;
use crate::bytes::ByteReader;
use crate::contents::ContentValue;

/// What of an object's attributes is read: their names with their values.
#[derive(Clone, Debug, Default)]
pub(super) struct Attributes(pub Vec<(String, ContentValue)>);

impl Attributes {
    /// The attributes in a header, and those that are kept in a heap.
    pub fn of<'a>(file: &Hdf5File<'a>, header: &Header<'a>) -> Result<Self, Trouble> {
        let mut found = Self::default();
        for message in header.all(ATTRIBUTE) {
            found.keep(file, &mut message.resolved(file)?)?;
        }
        if let Some(message) = header.one(ATTRIBUTE_INFO) {
            let mut body = message.body.clone();
            let place = body.place();
            body.take(1)?;
            let flags = body.u8()?;
            body.take(if flags & 1 != 0 { 2 } else { 0 })?;
            if let Some(heap) = file.offset(&mut body)? {
                let heap = FractalHeap::read(file, heap)?;
                for mut record in btree2::records(file, file.address(&mut body)?, &[8])? {
                    let name = record.take(8)?;
                    match heap.object(name, place) {
                        Ok(mut object) => found.keep(file, &mut object)?,
                        // One that is too large for the heap says nothing of channels.
                        Err(Trouble::Unread(_)) => {}
                        Err(fault) => return Err(fault),
                    }
                }
                found.0.sort_by(|(a, _), (b, _)| a.cmp(b));
            }
        }
        Ok(found)
    }

    /// Keeps an attribute if it can be read.
    fn keep<'a>(
        &mut self,
        file: &Hdf5File<'a>,
        reader: &mut ByteReader<'a>,
    ) -> Result<(), Trouble> {
        match attribute(file, reader) {
            Ok(attribute) => self.0.push(attribute),
            Err(Trouble::Unread(_)) => {}
            Err(fault) => return Err(fault),
        }
        Ok(())
    }

    /// The text of an attribute.
    pub fn text(&self, name: &str) -> Option<&str> {
        self.0.iter().find(|(known, _)| known == name).and_then(|(_, value)| as_text(value))
    }

    /// The number of an attribute.
    pub fn number(&self, name: &str) -> Option<f64> {
        self.0.iter().find(|(known, _)| known == name).and_then(|(_, value)| as_number(value))
    }

    /// The texts of an attribute that has one or several.
    pub fn texts(value: &ContentValue) -> Option<Vec<String>> {
        match value {
            ContentValue::Text(text) => Some(vec![text.clone()]),
            ContentValue::Cells(cells) => {
                cells.iter().map(|cell| as_text(cell).map(str::to_owned)).collect()
            }
            ContentValue::Numbers { .. }
            | ContentValue::Records { .. }
            | ContentValue::Other(_) => None,
        }
    }
}

/// The text that a value is, alone or as a list of one.
pub(super) fn as_text(value: &ContentValue) -> Option<&str> {
    match value {
        ContentValue::Text(text) => Some(text),
        ContentValue::Cells(cells) => match cells.as_slice() {
            [ContentValue::Text(text)] => Some(text),
            _ => None,
        },
        ContentValue::Numbers { .. } | ContentValue::Records { .. } | ContentValue::Other(_) => {
            None
        }
    }
}

/// The number that a value is, alone or as a list of one.
pub(super) fn as_number(value: &ContentValue) -> Option<f64> {
    match value {
        ContentValue::Numbers { values, complex: false, .. } => match values.as_slice() {
            [number] => Some(*number),
            _ => None,
        },
        ContentValue::Numbers { .. }
        | ContentValue::Text(_)
        | ContentValue::Cells(_)
        | ContentValue::Records { .. }
        | ContentValue::Other(_) => None,
    }
}

fn attribute<'a>(
    file: &Hdf5File<'a>,
    reader: &mut ByteReader<'a>,
) -> Result<(String, ContentValue), Trouble> {
    let version = reader.u8()?;
    if !(1..=3).contains(&version) {
        return Err(unknown(reader, text!("an attribute"), version).into());
    }
    let flags = if version == 1 { 0 } else { reader.clone().u8()? };
    reader.take(1)?;
    let sizes = [reader.u16()?, reader.u16()?, reader.u16()?].map(usize::from);
    reader.take(if version == 3 { 1 } else { 0 })?;
    let mut parts = Vec::new();
    for size in sizes {
        let place = reader.place();
        parts.push(ByteReader::new(reader.take(size)?, place));
        // The first version fills up eight bytes.
        reader.take(if version == 1 { size.next_multiple_of(8) - size } else { 0 })?;
    }
    let [name, of, space] = parts.as_mut_slice() else {
        return Err(Trouble::Unread(text!("an attribute")));
    };
    let name = name.take(name.left())?;
    let end = name.iter().position(|byte| *byte == 0).unwrap_or(name.len());
    let name = String::from_utf8_lossy(&name[..end]).into_owned();
    let of = Datatype::within(file, of, flags & 1 != 0)?;
    let space = match flags & 2 != 0 {
        true => Space::read(file, &mut shared(file, space, DATASPACE)?)?,
        false => Space::read(file, space)?,
    };
    let bytes = reader.take(space.count()?.saturating_mul(of.size))?;
    file.take_bytes(bytes.len())?;
    let elements = ElementBytes::dense(bytes, of.size);
    Ok((name, value(file, &of, &space.dims, elements, DimensionOrder::File)?))
}
