//! From the bytes of an array to numbers and texts.

use super::datatype::{Datatype, ElementKind, Field, Number};
use super::file::{Hdf5File, Trouble};
use super::heaps::GlobalHeap;
use crate::base::language::text;
use crate::bytes::ByteReader;
use crate::contents::{ColumnsTold, ContentValue};

/// Most texts of an array that are read: they name channels.
const MAX_TEXTS: usize = 10_000;

/// The bytes of elements that lie `each` bytes apart, beginning `at` bytes behind those.
#[derive(Clone, Copy)]
pub(super) struct ElementBytes<'b> {
    pub bytes: &'b [u8],
    pub at: usize,
    pub each: usize,
    pub size: usize,
}

impl<'b> ElementBytes<'b> {
    /// Elements one behind the other.
    pub fn dense(bytes: &'b [u8], each: usize) -> Self {
        Self { bytes, at: 0, each, size: each }
    }

    /// A part of each.
    fn part(self, at: usize, size: usize) -> Self {
        Self { at: self.at + at, size, ..self }
    }

    fn iter(self) -> impl Iterator<Item = &'b [u8]> {
        let Self { at, each, size, .. } = self;
        self.bytes.chunks_exact(each).filter_map(move |element| element.get(at..at + size))
    }
}

/// The order that numbers of several dimensions are told in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum DimensionOrder {
    /// The file's: the last counts fastest.
    File,
    /// MATLAB's, which writes them backwards: the first counts fastest.
    Matlab,
}

/// The value of an array.
pub(super) fn value(
    file: &Hdf5File<'_>,
    of: &Datatype,
    dims: &[usize],
    elements: ElementBytes<'_>,
    order: DimensionOrder,
) -> Result<ContentValue, Trouble> {
    match &of.kind {
        ElementKind::Number(number) => {
            let values = numbers(file, *number, elements)?;
            Ok(shaped(values, dims, order))
        }
        ElementKind::Text | ElementKind::Elsewhere { .. } => Ok(match texts(file, of, elements)? {
            texts if dims.is_empty() && texts.len() == 1 => {
                ContentValue::Text(texts.into_iter().next().unwrap_or_default())
            }
            texts => ContentValue::Cells(texts.into_iter().map(ContentValue::Text).collect()),
        }),
        ElementKind::Record(fields) => record(file, fields, dims, elements, order),
        ElementKind::Several(inner, count) => {
            let ElementKind::Number(number) = &inner.kind else {
                return Err(Trouble::Unread(text!("elements that are arrays")));
            };
            // Column by column: all first ones, all second ones, ...
            let mut values = Vec::new();
            for index in 0..*count {
                let part = elements.part(index * inner.size, inner.size);
                values.extend(numbers(file, *number, part)?);
            }
            let rows = values.len() / (*count).max(1);
            Ok(ContentValue::numbers(vec![rows, *count], values))
        }
        ElementKind::Reference => Err(Trouble::Unread(text!("references to other objects"))),
        ElementKind::Other(what) => Err(Trouble::Unread(what)),
    }
}

fn numbers(
    file: &Hdf5File<'_>,
    number: Number,
    elements: ElementBytes<'_>,
) -> Result<Vec<f64>, Trouble> {
    file.take_values(elements.bytes.len() / elements.each)?;
    Ok(elements.iter().map(|bytes| number.value(bytes)).collect())
}

/// Numbers in the file's order with their size.
fn shaped(values: Vec<f64>, dims: &[usize], order: DimensionOrder) -> ContentValue {
    match (dims, order) {
        ([], _) => ContentValue::numbers(vec![values.len(), 1], values),
        ([_], _) => ContentValue::numbers(vec![values.len(), 1], values),
        (dims, DimensionOrder::Matlab) => {
            ContentValue::numbers(dims.iter().rev().copied().collect(), values)
        }
        (&[rows, columns], DimensionOrder::File) if values.len() == rows * columns => {
            let column = |column| values.iter().skip(column).step_by(columns).copied();
            let turned = (0..columns).flat_map(column).collect();
            ContentValue::numbers(vec![rows, columns], turned)
        }
        (dims, DimensionOrder::File) => ContentValue::numbers(dims.to_vec(), values),
    }
}

/// Records as one record of their columns; a pair of real and imaginary part is a number.
fn record(
    file: &Hdf5File<'_>,
    fields: &[Field],
    dims: &[usize],
    elements: ElementBytes<'_>,
    order: DimensionOrder,
) -> Result<ContentValue, Trouble> {
    let names: Vec<&str> = fields.iter().map(|field| field.name.as_str()).collect();
    let part = |field: &Field| elements.part(field.at, field.of.size);
    if let ["r", "i"] | ["real", "imag"] = names.as_slice()
        && let ElementKind::Number(number) = &fields[0].of.kind
    {
        let values = numbers(file, *number, part(&fields[0]))?;
        if let ContentValue::Numbers { dims, values, .. } = shaped(values, dims, order) {
            let told = ColumnsTold::default();
            return Ok(ContentValue::Numbers { dims, values, complex: true, told });
        }
    }
    let mut values = Vec::new();
    for field in fields {
        values.push(match value(file, &field.of, dims, part(field), order) {
            Ok(value) => value,
            Err(Trouble::Unread(what)) => ContentValue::Other(what),
            Err(fault) => return Err(fault),
        });
    }
    let fields = fields.iter().map(|field| field.name.clone()).collect();
    Ok(ContentValue::Records { fields, records: vec![values] })
}

/// Texts, whether they lie in the array or elsewhere.
pub(super) fn texts(
    file: &Hdf5File<'_>,
    of: &Datatype,
    elements: ElementBytes<'_>,
) -> Result<Vec<String>, Trouble> {
    if elements.bytes.len() / elements.each > MAX_TEXTS {
        return Err(Trouble::Unread(text!("texts")));
    }
    let mut heap = GlobalHeap::default();
    let mut found = Vec::new();
    for bytes in elements.iter() {
        found.push(match &of.kind {
            ElementKind::Elsewhere { bytes_each, text } if *text || *bytes_each == 1 => {
                let bytes = heap.bytes(file, &mut ByteReader::new(bytes, 0), *bytes_each)?;
                file.take_bytes(bytes.len())?;
                shown(bytes)
            }
            ElementKind::Text => shown(bytes),
            ElementKind::Elsewhere { .. }
            | ElementKind::Number(_)
            | ElementKind::Reference
            | ElementKind::Record(_)
            | ElementKind::Several(..)
            | ElementKind::Other(_) => {
                return Err(Trouble::Unread(text!("lists of different lengths")));
            }
        });
    }
    Ok(found)
}

/// A text up to its zero, without the spaces that fill it up.
fn shown(bytes: &[u8]) -> String {
    let end = bytes.iter().position(|byte| *byte == 0).unwrap_or(bytes.len());
    let bytes = &bytes[..end];
    let latin = || bytes.iter().map(|byte| char::from(*byte)).collect();
    let text = std::str::from_utf8(bytes).map_or_else(|_| latin(), str::to_owned);
    text.trim_end_matches(' ').to_owned()
}
