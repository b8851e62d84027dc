//! Trees of records, second version: what indexes many links, many attributes, and chunks that grow in several
//! directions.

use super::file::{Hdf5File, unknown, whole};
use crate::base::language::{text, tr};
use crate::bytes::ByteReader;
use crate::fault::DataFault;

/// Bytes of a node that are no records: signature, version, kind, checksum.
const AROUND: usize = 10;
/// Most levels of a tree.
const MAX_DEPTH: usize = 16;

/// Sizes of the nodes of a level.
#[derive(Clone, Copy)]
struct Level {
    /// Most records of a node, and of it with all below.
    most: u64,
    most_below: u64,
}

/// Bytes that a number up to this one takes.
fn bytes_of(most: u64) -> usize {
    most.max(1).ilog2() as usize / 8 + 1
}

struct Tree<'a, 'f> {
    file: &'f Hdf5File<'a>,
    node_size: usize,
    record_size: usize,
    levels: Vec<Level>,
    found: Vec<ByteReader<'a>>,
}

/// All records of a tree of a kind, in their order, without what stands between them.
pub(super) fn records<'a>(
    file: &Hdf5File<'a>,
    address: u64,
    kinds: &[u8],
) -> Result<Vec<ByteReader<'a>>, DataFault> {
    let length = 22 + file.offset_size() + file.length_size();
    let mut reader = file.sound(address, length as u64, b"BTHD")?;
    let version = reader.u8()?;
    if version != 0 {
        return Err(unknown(&reader, text!("a tree"), version));
    }
    let kind = reader.u8()?;
    if !kinds.contains(&kind) {
        let found = tr!("a tree of kind {kind}", kind = kind);
        return Err(reader.fault(found, format!("{kinds:?}")));
    }
    let node_size = reader.u32()? as usize;
    let record_size = usize::from(reader.u16()?);
    let depth = usize::from(reader.u16()?);
    reader.take(2)?;
    let root = file.offset(&mut reader)?;
    let count = u64::from(reader.u16()?);
    if record_size == 0 || node_size <= AROUND + record_size || depth > MAX_DEPTH {
        let found = tr!("a tree of depth {depth}", depth = depth);
        return Err(reader.fault(found, tr!("at most {most}", most = MAX_DEPTH)));
    }
    let most = ((node_size - AROUND) / record_size) as u64;
    let mut levels = vec![Level { most, most_below: most }];
    for depth in 1..=depth {
        let below = levels[depth - 1];
        let pointer = pointer_size(file, &levels, depth);
        let room = node_size.saturating_sub(AROUND + pointer) / (record_size + pointer);
        let most = room as u64;
        let most_below = (most + 1).saturating_mul(below.most_below).saturating_add(most);
        levels.push(Level { most, most_below });
    }
    let mut tree = Tree { file, node_size, record_size, levels, found: Vec::new() };
    if let Some(root) = root {
        tree.node(root, count, depth)?;
    }
    Ok(tree.found)
}

/// Bytes of an address with the records of the node there and, where that has children, with those below.
fn pointer_size(file: &Hdf5File<'_>, levels: &[Level], depth: usize) -> usize {
    let below = if depth > 1 { bytes_of(levels[depth - 1].most_below) } else { 0 };
    file.offset_size() + bytes_of(levels[0].most) + below
}

impl Tree<'_, '_> {
    fn node(&mut self, address: u64, count: u64, depth: usize) -> Result<(), DataFault> {
        let inner = depth > 0;
        let signature: &[u8] = if inner { b"BTIN" } else { b"BTLF" };
        let mut reader = self.file.at(address)?;
        if count > self.levels[depth].most {
            let found = tr!("{count} records in a node", count = count);
            return Err(reader.fault(found, tr!("at most {most}", most = self.levels[depth].most)));
        }
        let count = count as usize;
        let pointer = if inner { pointer_size(self.file, &self.levels, depth) } else { 0 };
        let children = if inner { count + 1 } else { 0 };
        let length = AROUND + count * self.record_size + children * pointer;
        if length > self.node_size {
            let found = tr!("a node of {size} bytes", size = length);
            return Err(reader.fault(found, tr!("at most {most}", most = self.node_size)));
        }
        reader = self.file.sound(address, length as u64, signature)?;
        reader.take(2)?;
        let mut records = Vec::new();
        for _ in 0..count {
            let place = reader.place();
            records.push(ByteReader::new(reader.take(self.record_size)?, place));
        }
        let mut records = records.into_iter();
        for _ in 0..children {
            let address = self.file.address(&mut reader)?;
            let count = whole(&mut reader, bytes_of(self.levels[0].most))?;
            reader.take(pointer - self.file.offset_size() - bytes_of(self.levels[0].most))?;
            self.node(address, count, depth - 1)?;
            self.found.extend(records.next());
        }
        self.found.extend(records);
        Ok(())
    }
}
