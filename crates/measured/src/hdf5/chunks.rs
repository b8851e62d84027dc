//! The bytes of an array, from wherever its pieces lie.

use std::borrow::Cow;

use super::arrays;
use super::btree2;
use super::file::{Hdf5File, Trouble, whole};
use super::filters::{Filter, undone};
use super::layout::{ChunkIndex, Layout, Space, Stored};
use crate::base::language::{text, tr};
use crate::fault::DataFault;

/// Most levels of a tree.
const MAX_DEPTH: u8 = 16;

/// A piece of an array.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Chunk {
    pub address: u64,
    /// How many bytes it has in the file.
    pub bytes: u64,
    /// The filters that it did not go through.
    pub mask: u32,
}

/// The bytes of an array whose elements have `each`.
pub(super) fn bytes<'a>(
    file: &Hdf5File<'a>,
    stored: &Stored<'a>,
    each: usize,
) -> Result<Cow<'a, [u8]>, Trouble> {
    let too_many = || Trouble::Unread(text!("more values than a file of this size can have"));
    let total = stored.space.count()?.checked_mul(each).ok_or_else(too_many)?;
    file.take_bytes(total)?;
    match &stored.layout {
        Layout::Compact(bytes) => match bytes.get(..total) {
            Some(bytes) => Ok(Cow::Borrowed(bytes)),
            None => {
                let found = tr!("an array of {size} bytes", size = bytes.len());
                Err(DataFault::of_file(found, tr!("{count} bytes", count = total)).into())
            }
        },
        Layout::Contiguous(Some(address)) if total > 0 => {
            Ok(Cow::Borrowed(file.at(*address)?.take(total)?))
        }
        Layout::Contiguous(_) => Ok(Cow::Owned(filled(stored.fill, total, each))),
        Layout::Chunked { size, index, address } => {
            let mut pieces = Pieces {
                file,
                space: &stored.space,
                size,
                each,
                filters: &stored.filters,
                bytes: filled(stored.fill, total, each),
                chunk_bytes: 0,
            };
            let chunk = size.iter().try_fold(each, |all, size| all.checked_mul(*size));
            pieces.chunk_bytes = chunk.ok_or_else(too_many)?;
            if let Some(address) = address.filter(|_| total > 0) {
                pieces.all(index, address)?;
            }
            Ok(Cow::Owned(pieces.bytes))
        }
    }
}

/// An array that was never written.
fn filled(fill: &[u8], total: usize, each: usize) -> Vec<u8> {
    let mut bytes = vec![0; total];
    if fill.len() == each && fill.iter().any(|byte| *byte != 0) {
        bytes.chunks_exact_mut(each).for_each(|element| element.copy_from_slice(fill));
    }
    bytes
}

/// An array that is put together.
struct Pieces<'a, 'f> {
    file: &'f Hdf5File<'a>,
    space: &'f Space,
    /// Size of a chunk, and its bytes.
    size: &'f [usize],
    chunk_bytes: usize,
    each: usize,
    filters: &'f [Filter],
    bytes: Vec<u8>,
}

impl Pieces<'_, '_> {
    /// Puts all chunks of an index in their places.
    fn all(&mut self, index: &ChunkIndex, address: u64) -> Result<(), Trouble> {
        let bytes = self.chunk_bytes as u64;
        let whole_chunk = Chunk { address, bytes, mask: 0 };
        let mut endless = None;
        let chunks = match index {
            ChunkIndex::Tree => return self.tree(address, MAX_DEPTH),
            ChunkIndex::Tree2 => return self.tree2(address),
            ChunkIndex::Single { packed: None } => vec![(0, whole_chunk)],
            ChunkIndex::Single { packed: Some((bytes, mask)) } => {
                vec![(0, Chunk { address, bytes: *bytes, mask: *mask })]
            }
            ChunkIndex::Implicit => {
                let grid = self.grid();
                let count = grid.iter().fold(1u64, |all, count| all.saturating_mul(*count));
                let mut chunks = Vec::new();
                for number in 0..count {
                    let address = number.saturating_mul(bytes).saturating_add(address);
                    self.file.step(1, self.file.at(address)?.place())?;
                    chunks.push((number, Chunk { address, ..whole_chunk }));
                }
                chunks
            }
            ChunkIndex::FixedArray => arrays::fixed(self.file, address, self.chunk_bytes)?,
            ChunkIndex::ExtensibleArray => {
                endless = self.space.most.iter().position(|most| *most == u64::MAX);
                arrays::extensible(self.file, address, self.chunk_bytes)?
            }
        };
        let grid = self.grid();
        for (number, chunk) in chunks {
            if let Some(at) = self.place(number, &grid, endless) {
                self.put(chunk, &at)?;
            }
        }
        Ok(())
    }

    /// How many chunks there are at most in each dimension.
    fn grid(&self) -> Vec<u64> {
        let most = self.space.most.iter().zip(self.size);
        most.map(|(most, size)| most.div_ceil(*size as u64).max(1)).collect()
    }

    /// The first element of a chunk by its number: the last dimension counts fastest, the one without an end slowest,
    /// wherever that is.
    fn place(&self, number: u64, grid: &[u64], endless: Option<usize>) -> Option<Vec<usize>> {
        let mut left = number;
        let mut at = vec![0u64; grid.len()];
        for (dimension, count) in grid.iter().enumerate().rev() {
            if endless != Some(dimension) {
                at[dimension] = left % count;
                left /= count;
            }
        }
        if let Some(endless) = endless {
            at[endless] = std::mem::take(&mut left);
        }
        let first = |(at, size): (&u64, &usize)| usize::try_from(*at).ok()?.checked_mul(*size);
        let at = at.iter().zip(self.size).map(first).collect::<Option<Vec<usize>>>()?;
        Some(at).filter(|_| left == 0)
    }

    fn tree(&mut self, address: u64, levels: u8) -> Result<(), Trouble> {
        let file = self.file;
        let mut reader = file.at(address)?;
        file.signed(&mut reader, b"TREE")?;
        let kind = reader.u8()?;
        let level = reader.u8()?;
        if kind != 1 || level >= levels {
            let found = tr!("a tree of kind {kind}, level {level}", kind = kind, level = level);
            let expected = tr!("kind 1, below level {most}", most = levels);
            return Err(reader.fault(found, expected).into());
        }
        let count = reader.u16()?;
        reader.take(2 * file.offset_size())?;
        for _ in 0..count {
            file.step(8 * self.size.len() + 16 + file.offset_size(), reader.place())?;
            let (bytes, mask) = (u64::from(reader.u32()?), reader.u32()?);
            let mut at = Vec::new();
            for _ in self.size {
                at.push(usize::try_from(reader.u64()?).unwrap_or(usize::MAX));
            }
            reader.take(8)?;
            let address = file.address(&mut reader)?;
            match level {
                0 => self.put(Chunk { address, bytes, mask }, &at)?,
                level => self.tree(address, level)?,
            }
        }
        Ok(())
    }

    fn tree2(&mut self, address: u64) -> Result<(), Trouble> {
        for mut record in btree2::records(self.file, address, &[10, 11])? {
            let address = self.file.address(&mut record)?;
            let places = 8 * self.size.len();
            let (bytes, mask) = match record.left().checked_sub(places + 4) {
                Some(width) => (whole(&mut record, width)?, record.u32()?),
                None => (self.chunk_bytes as u64, 0),
            };
            let mut at = Vec::new();
            for size in self.size {
                let number = usize::try_from(record.u64()?).unwrap_or(usize::MAX);
                at.push(number.saturating_mul(*size));
            }
            self.put(Chunk { address, bytes, mask }, &at)?;
        }
        Ok(())
    }

    /// Puts a chunk in its place; what of it lies outside the array is left out.
    fn put(&mut self, chunk: Chunk, at: &[usize]) -> Result<(), Trouble> {
        let dims = &self.space.dims;
        if at.iter().zip(dims).any(|(at, size)| at >= size) {
            return Ok(());
        }
        let mut reader = self.file.at(chunk.address)?;
        let place = reader.place();
        let packed = reader.take(usize::try_from(chunk.bytes).unwrap_or(usize::MAX))?;
        self.file.take_bytes(self.chunk_bytes)?;
        let bytes = undone(self.filters, chunk.mask, packed, self.chunk_bytes, place)?;
        let there: Vec<usize> = at
            .iter()
            .zip(dims)
            .zip(self.size)
            .map(|((at, all), size)| (*size).min(all - at))
            .collect();
        let last = there.len() - 1;
        let run = there[last] * self.each;
        // Runs along the last dimension, one after the other.
        let mut index = vec![0usize; last];
        loop {
            let (mut from, mut to) = (0, 0);
            for dimension in 0..last {
                from = (from + index[dimension]) * self.size[dimension + 1];
                to = (to + at[dimension] + index[dimension]) * dims[dimension + 1];
            }
            let (from, to) = (from * self.each, (to + at[last]) * self.each);
            self.bytes[to..to + run].copy_from_slice(&bytes[from..from + run]);
            let Some(dimension) = (0..last).rev().find(|d| index[*d] + 1 < there[*d]) else {
                return Ok(());
            };
            index[dimension] += 1;
            index[dimension + 1..].fill(0);
        }
    }
}
