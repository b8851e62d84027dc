//! Heaps: where names, texts of any length, and many links or attributes of an object lie.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

use super::file::{Hdf5File, Trouble, unknown, whole};
use crate::base::language::{text, tr};
use crate::bytes::ByteReader;
use crate::fault::DataFault;

/// Most rows of blocks in a heap.
const MAX_ROWS: u32 = 128;

/// Names of a group's members.
pub(super) struct LocalHeap<'a> {
    data: ByteReader<'a>,
}

impl<'a> LocalHeap<'a> {
    pub fn read(file: &Hdf5File<'a>, address: u64) -> Result<Self, DataFault> {
        let mut reader = file.at(address)?;
        file.signed(&mut reader, b"HEAP")?;
        reader.take(4)?;
        let length = file.length(&mut reader)?;
        file.length(&mut reader)?;
        let data = file.address(&mut reader)?;
        Ok(Self { data: file.block(data, length)? })
    }

    /// The name at a place.
    pub fn name(&self, file: &Hdf5File<'_>, at: u64) -> Result<String, DataFault> {
        let mut reader = self.data.clone();
        reader.take(usize::try_from(at).unwrap_or(usize::MAX))?;
        let place = reader.place();
        let rest = reader.take(reader.left())?;
        let Some(end) = rest.iter().position(|byte| *byte == 0) else {
            return Err(DataFault::at(place, tr("a name without an end"), tr("a zero behind it")));
        };
        file.step(end, place)?;
        Ok(String::from_utf8_lossy(&rest[..end]).into_owned())
    }
}

/// Texts of any length.
#[derive(Default)]
pub(super) struct GlobalHeap<'a> {
    collections: BTreeMap<u64, BTreeMap<u16, &'a [u8]>>,
}

impl<'a> GlobalHeap<'a> {
    /// What an element says lies in the heap: so many pieces of `bytes_each` bytes.
    pub fn bytes(
        &mut self,
        file: &Hdf5File<'a>,
        element: &mut ByteReader<'_>,
        bytes_each: usize,
    ) -> Result<&'a [u8], DataFault> {
        let length = (element.u32()? as usize).saturating_mul(bytes_each);
        let place = element.place();
        let address = file.offset(element)?.filter(|address| *address != 0);
        let index = element.u32()?;
        let (Some(address), 1..) = (address, length) else { return Ok(&[]) };
        let objects = match self.collections.entry(address) {
            Entry::Vacant(entry) => entry.insert(collection(file, address)?),
            Entry::Occupied(entry) => entry.into_mut(),
        };
        let found = u16::try_from(index).ok().and_then(|index| objects.get(&index)).copied();
        found.and_then(|bytes| bytes.get(..length)).ok_or_else(|| {
            let found = tr!("a text of {length} bytes", length = length);
            DataFault::at(place, found, tr("one that the heap has"))
        })
    }
}

fn collection<'a>(file: &Hdf5File<'a>, address: u64) -> Result<BTreeMap<u16, &'a [u8]>, DataFault> {
    let mut reader = file.at(address)?;
    file.signed(&mut reader, b"GCOL")?;
    reader.take(4)?;
    let length = file.length(&mut reader)?;
    let mut reader = file.block(address, length)?;
    reader.take(8 + file.length_size())?;
    let mut objects = BTreeMap::new();
    while reader.left() >= 8 + file.length_size() {
        let index = reader.u16()?;
        reader.take(6)?;
        let size = usize::try_from(file.length(&mut reader)?).unwrap_or(usize::MAX);
        // What is left is free.
        if index == 0 {
            break;
        }
        objects.insert(index, reader.take(size)?);
        reader.skip(size.wrapping_neg() % 8);
    }
    Ok(objects)
}

/// Where an object keeps many links or attributes.
pub(super) struct FractalHeap<'a, 'f> {
    file: &'f Hdf5File<'a>,
    /// Bytes of a place and of a length in what names an object.
    place_size: usize,
    length_size: usize,
    width: u64,
    start: u64,
    direct_rows: u32,
    root: Option<u64>,
    root_rows: u32,
    /// Bytes in front of a block's children.
    head: usize,
    packed: bool,
}

/// Bytes that a number up to this one takes.
fn bytes_of(most: u64) -> usize {
    (64 - most.leading_zeros()).div_ceil(8).max(1) as usize
}

impl<'a, 'f> FractalHeap<'a, 'f> {
    pub fn read(file: &'f Hdf5File<'a>, address: u64) -> Result<Self, DataFault> {
        let (offset, length) = (file.offset_size(), file.length_size());
        let mut reader = file.at(address)?;
        file.signed(&mut reader, b"FRHP")?;
        let version = reader.u8()?;
        if version != 0 {
            return Err(unknown(&reader, text!("a heap"), version));
        }
        reader.take(2)?;
        let filters = usize::from(reader.u16()?);
        let size = 26 + 12 * length + 3 * offset;
        let size = size + if filters > 0 { length + 4 + filters } else { 0 };
        let mut reader = file.sound(address, size as u64, b"FRHP")?;
        reader.take(6)?;
        let mut most = u64::from(reader.u32()?);
        reader.take(10 * length + 2 * offset)?;
        let place = reader.place();
        let width = u64::from(reader.u16()?);
        let start = file.length(&mut reader)?;
        let most_direct = file.length(&mut reader)?;
        let bits = u32::from(reader.u16()?);
        reader.take(2)?;
        let root = file.offset(&mut reader)?;
        let root_rows = u32::from(reader.u16()?);
        let powers = width.is_power_of_two() && start.is_power_of_two();
        let fits = powers && most_direct.is_power_of_two() && most_direct >= start && bits <= 64;
        if !fits || root_rows > MAX_ROWS {
            let found = tr("blocks of a heap whose sizes do not fit");
            return Err(DataFault::at(place, found, tr("powers of two")));
        }
        most = most.min(most_direct);
        let place_size = bits.div_ceil(8) as usize;
        Ok(Self {
            file,
            place_size,
            length_size: bytes_of(most).min(most_direct.ilog2().div_ceil(8) as usize),
            width,
            start,
            direct_rows: most_direct.ilog2() - start.ilog2() + 2,
            root,
            root_rows,
            head: 5 + offset + place_size,
            packed: filters > 0,
        })
    }

    /// What lies in the heap under a name.
    pub fn object(&self, name: &[u8], place: usize) -> Result<ByteReader<'a>, Trouble> {
        let mut reader = ByteReader::new(name, place);
        let kind = reader.u8()?;
        if self.packed || kind & 0xf0 != 0 {
            return Err(Trouble::Unread(text!("kept in a heap in a way that is not read")));
        }
        let at = whole(&mut reader, self.place_size)?;
        let length = whole(&mut reader, self.length_size)?;
        let nowhere = || {
            let found = tr!("byte {at} of a heap", at = at);
            DataFault::at(place, found, tr("one that it has"))
        };
        let mut block = self.root.ok_or_else(nowhere)?;
        let mut rows = self.root_rows;
        let mut within = at;
        // A block of blocks has in its first two rows the smallest, and in each row behind them twice as large ones.
        while rows > 0 {
            let (mut row, mut first) = (0, 0u64);
            let (size, column) = loop {
                let size = self.start.checked_shl(u32::saturating_sub(row, 1));
                let size = size.filter(|size| *size >= self.start).ok_or_else(nowhere)?;
                let all = size.checked_mul(self.width).ok_or_else(nowhere)?;
                if row >= rows {
                    return Err(nowhere().into());
                }
                if within - first < all {
                    let column = (within - first) / size;
                    first += column * size;
                    break (size, column);
                }
                first = first.checked_add(all).ok_or_else(nowhere)?;
                row += 1;
            };
            within -= first;
            let entry = u64::from(row) * self.width + column;
            let entry = usize::try_from(entry).unwrap_or(usize::MAX);
            let mut reader = self.file.at(block)?;
            self.file.signed(&mut reader, b"FHIB")?;
            reader.take(self.head - 4)?;
            reader.take(entry.saturating_mul(self.file.offset_size()))?;
            block = self.file.address(&mut reader)?;
            rows = match row < self.direct_rows {
                true => 0,
                // As many rows as make up the size of the block.
                false => (size.ilog2() + 1).saturating_sub(self.start.ilog2() + self.width.ilog2()),
            };
        }
        let mut reader = self.file.at(block)?;
        self.file.signed(&mut reader, b"FHDB")?;
        Ok(self.file.block(block.saturating_add(within), length)?)
    }
}
