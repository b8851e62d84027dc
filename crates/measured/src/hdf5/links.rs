//! The members of a group: old groups have tables of symbols, newer ones links in their header or, many, in a heap.

use super::btree2;
use super::file::{Hdf5File, Trouble, unknown, whole};
use super::header::{Header, LINK, LINK_INFO, SYMBOL_TABLE};
use super::heaps::{FractalHeap, LocalHeap};
use crate::base::language::{text, tr};
use crate::bytes::ByteReader;
use crate::fault::DataFault;

/// Most levels of a tree.
const MAX_DEPTH: u8 = 16;

/// A member of a group.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Member {
    pub name: String,
    /// Where its header is; none of a link by name, whose target is read in its own place.
    pub address: Option<u64>,
}

/// Whether a header is that of a group.
pub(super) fn is_group(header: &Header<'_>) -> bool {
    [SYMBOL_TABLE, LINK_INFO, LINK].iter().any(|kind| header.one(*kind).is_some())
}

/// The members of a group by their names.
pub(super) fn members(file: &Hdf5File<'_>, header: &Header<'_>) -> Result<Vec<Member>, Trouble> {
    let mut found = Vec::new();
    if let Some(message) = header.one(SYMBOL_TABLE) {
        let mut body = message.body.clone();
        let tree = file.address(&mut body)?;
        let heap = LocalHeap::read(file, file.address(&mut body)?)?;
        symbols(file, &heap, tree, MAX_DEPTH, &mut found)?;
    }
    for message in header.all(LINK) {
        found.push(link(file, &mut message.body.clone())?);
    }
    if let Some(message) = header.one(LINK_INFO) {
        let mut body = message.body.clone();
        let place = body.place();
        body.take(1)?;
        let flags = body.u8()?;
        body.take(if flags & 1 != 0 { 8 } else { 0 })?;
        if let Some(heap) = file.offset(&mut body)? {
            let heap = FractalHeap::read(file, heap)?;
            for mut record in btree2::records(file, file.address(&mut body)?, &[5])? {
                record.take(4)?;
                let name = record.take(record.left())?;
                found.push(link(file, &mut heap.object(name, place)?)?);
            }
        }
    }
    // Old groups are kept so; newer ones as there was room for their links.
    found.sort_by(|a, b| a.name.cmp(&b.name));
    Ok(found)
}

/// Goes down a tree of an old group to its symbols.
fn symbols(
    file: &Hdf5File<'_>,
    heap: &LocalHeap<'_>,
    address: u64,
    levels: u8,
    found: &mut Vec<Member>,
) -> Result<(), DataFault> {
    let mut reader = file.at(address)?;
    if reader.clone().take(4)? == b"SNOD" {
        file.signed(&mut reader, b"SNOD")?;
        reader.take(2)?;
        for _ in 0..reader.u16()? {
            file.step(2 * file.offset_size() + 24, reader.place())?;
            let name = heap.name(file, whole(&mut reader, file.offset_size())?)?;
            let address = file.offset(&mut reader)?;
            let is_soft = reader.u32()? == 2;
            reader.take(20)?;
            found.push(Member { name, address: address.filter(|_| !is_soft) });
        }
        return Ok(());
    }
    file.signed(&mut reader, b"TREE")?;
    let kind = reader.u8()?;
    let level = reader.u8()?;
    if kind != 0 || level >= levels {
        let found = tr!("a tree of kind {kind}, level {level}", kind = kind, level = level);
        return Err(reader.fault(found, tr!("kind 0, below level {most}", most = levels)));
    }
    let count = reader.u16()?;
    reader.take(2 * file.offset_size())?;
    for _ in 0..count {
        file.step(file.offset_size() + file.length_size(), reader.place())?;
        file.length(&mut reader)?;
        let child = file.address(&mut reader)?;
        symbols(file, heap, child, level, found)?;
    }
    Ok(())
}

/// The link in a message.
fn link(file: &Hdf5File<'_>, body: &mut ByteReader<'_>) -> Result<Member, DataFault> {
    let version = body.u8()?;
    if version != 1 {
        return Err(unknown(body, text!("a link"), version));
    }
    let flags = body.u8()?;
    let kind = if flags & 8 != 0 { body.u8()? } else { 0 };
    // The order of its making, and the encoding of its name.
    body.take(if flags & 4 != 0 { 8 } else { 0 })?;
    body.take(if flags & 16 != 0 { 1 } else { 0 })?;
    let length = usize::try_from(whole(body, 1 << (flags & 3))?).unwrap_or(usize::MAX);
    let name = String::from_utf8_lossy(body.take(length)?).into_owned();
    let address = if kind == 0 { file.offset(body)? } else { None };
    Ok(Member { name, address })
}
