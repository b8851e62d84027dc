//! Chunks that arrays index, by their numbers: one of a fixed size, and one that grows.

use super::chunks::Chunk;
use super::file::{Hdf5File, Trouble, checked, unknown, whole};
use crate::base::language::{text, tr};
use crate::bytes::ByteReader;
use crate::fault::DataFault;

/// How an array's elements are stored.
struct Elements<'a, 'f> {
    file: &'f Hdf5File<'a>,
    /// Bytes of one; more than an address where chunks are compressed.
    size: usize,
    page_bits: u32,
    found: Vec<(u64, Chunk)>,
    /// Number of the next.
    next: u64,
    /// How many there are.
    count: u64,
    /// Bytes of a chunk that is not compressed.
    chunk_bytes: usize,
}

impl<'a> Elements<'a, '_> {
    /// So many elements.
    fn take(&mut self, reader: &mut ByteReader<'a>, count: u64) -> Result<(), DataFault> {
        let count = count.min(self.count.saturating_sub(self.next));
        for _ in 0..count {
            let place = reader.place();
            let mut element = ByteReader::new(reader.take(self.size)?, place);
            let number = self.next;
            self.next += 1;
            let Some(address) = self.file.offset(&mut element)? else { continue };
            let packed = self.size > self.file.offset_size();
            let (bytes, mask) = match packed {
                true => {
                    let width = self.size - self.file.offset_size() - 4;
                    (whole(&mut element, width)?, element.u32()?)
                }
                false => (self.chunk_bytes as u64, 0),
            };
            self.found.push((number, Chunk { address, bytes, mask }));
        }
        Ok(())
    }

    /// The elements of a block from an address on, in pages where there are many; `head` bytes come before them.
    fn block(
        &mut self,
        address: u64,
        signature: &[u8],
        head: usize,
        count: u64,
    ) -> Result<(), DataFault> {
        let file = self.file;
        let size = self.size as u64;
        let page = 1u64 << self.page_bits;
        if count <= page {
            let all = count.saturating_mul(size).saturating_add(head as u64 + 4);
            let mut reader = file.sound(address, all, signature)?;
            reader.take(head - 4)?;
            return self.take(&mut reader, count);
        }
        file.sound(address, head as u64 + 4, signature)?;
        let mut at = address.saturating_add(head as u64 + 4);
        let mut left = count;
        while left > 0 && self.next < self.count {
            let here = left.min(page);
            self.page(at, here)?;
            at = at.saturating_add(here.saturating_mul(size)).saturating_add(4);
            left -= here;
        }
        // What is left out has numbers, too.
        self.next = self.next.saturating_add(left);
        Ok(())
    }

    /// A page of so many elements, which ends with its checksum. One that was never written is zeros alone, and no
    /// chunk can be at address 0: its elements are left out.
    fn page(&mut self, address: u64, count: u64) -> Result<(), DataFault> {
        let length = count.saturating_mul(self.size as u64).saturating_add(4);
        let mut block = self.file.block(address, length)?;
        let place = block.place();
        let bytes = block.take(block.left())?;
        if bytes.iter().all(|byte| *byte == 0) {
            self.next = self.next.saturating_add(count);
            return Ok(());
        }
        checked(bytes, place)?;
        self.take(&mut ByteReader::new(&bytes[..bytes.len() - 4], place), count)
    }
}

/// Kind of the elements, and their size, of an array's header.
fn elements<'a, 'f>(
    file: &'f Hdf5File<'a>,
    reader: &mut ByteReader<'a>,
    chunk_bytes: usize,
) -> Result<Elements<'a, 'f>, DataFault> {
    let version = reader.u8()?;
    if version != 0 {
        return Err(unknown(reader, text!("an array of chunks"), version));
    }
    let kind = reader.u8()?;
    let size = usize::from(reader.u8()?);
    let address = file.offset_size();
    let sound = match kind {
        0 => size == address,
        1 => (address + 5..=address + 12).contains(&size),
        _ => false,
    };
    if !sound {
        let found = tr!("elements of kind {kind} with {size} bytes", kind = kind, size = size);
        return Err(reader.fault(found, tr("those of an array of chunks")));
    }
    Ok(Elements { file, size, page_bits: 0, found: Vec::new(), next: 0, count: 0, chunk_bytes })
}

/// A number of bits that numbers have.
fn bits(reader: &mut ByteReader<'_>) -> Result<u32, DataFault> {
    let bits = u32::from(reader.u8()?);
    match bits {
        0..=63 => Ok(bits),
        _ => Err(reader.fault(tr!("numbers of {bits} bits", bits = bits), tr("at most 63"))),
    }
}

/// The chunks of an array of a fixed size, with their numbers.
pub(super) fn fixed(
    file: &Hdf5File<'_>,
    address: u64,
    chunk_bytes: usize,
) -> Result<Vec<(u64, Chunk)>, Trouble> {
    let (offset, length) = (file.offset_size(), file.length_size());
    let mut reader = file.sound(address, (12 + length + offset) as u64, b"FAHD")?;
    let mut all = elements(file, &mut reader, chunk_bytes)?;
    all.page_bits = bits(&mut reader)?;
    all.count = file.length(&mut reader)?;
    let count = all.count;
    let Some(block) = file.offset(&mut reader)? else { return Ok(Vec::new()) };
    let pages = count.div_ceil(1 << all.page_bits);
    let flags = if pages > 1 { pages.div_ceil(8) } else { 0 };
    let head = usize::try_from(flags).unwrap_or(usize::MAX).saturating_add(6 + offset);
    if head > usize::MAX / 4 {
        return Err(Trouble::Unread(text!("more values than a file of this size can have")));
    }
    // Pages that were never written are no addresses, but zeros: they are left out by the flags.
    if pages > 1 {
        return pages_written(&mut all, block, head, flags, count);
    }
    all.block(block, b"FADB", head, count)?;
    Ok(all.found)
}

/// The elements of those pages that were written.
fn pages_written(
    all: &mut Elements<'_, '_>,
    address: u64,
    head: usize,
    flags: u64,
    count: u64,
) -> Result<Vec<(u64, Chunk)>, Trouble> {
    let file = all.file;
    let mut reader = file.sound(address, head as u64 + 4, b"FADB")?;
    reader.take(head - 4 - flags as usize)?;
    let flags = reader.take(flags as usize)?;
    let page = 1u64 << all.page_bits;
    let length = page.saturating_mul(all.size as u64).saturating_add(4);
    let mut at = address.saturating_add(head as u64 + 4);
    for number in 0..count.div_ceil(page) {
        all.next = number.saturating_mul(page);
        let here = page.min(count - all.next);
        let byte = flags.get(usize::try_from(number / 8).unwrap_or(usize::MAX)).copied();
        if byte.unwrap_or(0) << (number % 8) & 0x80 != 0 {
            all.page(at, here)?;
        }
        at = at.saturating_add(length);
    }
    Ok(std::mem::take(&mut all.found))
}

/// The chunks of an array that grows, with their numbers.
pub(super) fn extensible(
    file: &Hdf5File<'_>,
    address: u64,
    chunk_bytes: usize,
) -> Result<Vec<(u64, Chunk)>, Trouble> {
    let (offset, length) = (file.offset_size(), file.length_size());
    let mut reader = file.sound(address, (16 + 6 * length + offset) as u64, b"EAHD")?;
    let mut all = elements(file, &mut reader, chunk_bytes)?;
    let most_bits = bits(&mut reader)?;
    let in_index = u64::from(reader.u8()?);
    let place = reader.place();
    let least = u64::from(reader.u8()?);
    let pointers = u64::from(reader.u8()?);
    all.page_bits = bits(&mut reader)?;
    reader.take(4 * length)?;
    all.count = file.length(&mut reader)?;
    reader.take(length)?;
    let Some(index) = file.offset(&mut reader)? else { return Ok(Vec::new()) };
    if !least.is_power_of_two() || !pointers.is_power_of_two() || least.ilog2() > most_bits {
        let found = tr!("blocks of {least} elements", least = least);
        return Err(DataFault::at(place, found, tr("a power of two")).into());
    }
    // Blocks of blocks: number n has 2^(n/2) blocks of 2^((n+1)/2) times the least number of elements.
    let supers = 1 + most_bits - least.ilog2();
    let direct = 2 * pointers.ilog2();
    let blocks = 2 * (pointers - 1);
    let behind = u64::from(supers.saturating_sub(direct));
    let size = 10 + offset as u64 + in_index * all.size as u64 + (blocks + behind) * offset as u64;
    let mut reader = file.sound(index, size, b"EAIB")?;
    reader.take(2 + offset)?;
    all.take(&mut reader, in_index)?;
    let place_size = most_bits.div_ceil(8) as usize;
    let head = 6 + offset + place_size;
    for number in 0..supers {
        if all.next >= all.count {
            break;
        }
        let blocks = 1u64 << (number / 2);
        let each = least.checked_shl(number.div_ceil(2)).unwrap_or(u64::MAX);
        let addresses = if number < direct {
            let mut addresses = Vec::new();
            for _ in 0..blocks {
                addresses.push(file.offset(&mut reader)?);
            }
            addresses
        } else {
            let Some(address) = file.offset(&mut reader)? else {
                all.next = all.next.saturating_add(blocks.saturating_mul(each));
                continue;
            };
            addresses(file, address, head, blocks, each, all.page_bits)?
        };
        for address in addresses {
            match address {
                Some(address) => all.block(address, b"EADB", head, each)?,
                None => all.next = all.next.saturating_add(each),
            }
        }
    }
    Ok(all.found)
}

/// The addresses in a block of blocks.
fn addresses(
    file: &Hdf5File<'_>,
    address: u64,
    head: usize,
    blocks: u64,
    each: u64,
    page_bits: u32,
) -> Result<Vec<Option<u64>>, DataFault> {
    let pages = each >> page_bits;
    let flags = if pages > 1 { blocks.saturating_mul(pages.div_ceil(8)) } else { 0 };
    let length = blocks.saturating_mul(file.offset_size() as u64).saturating_add(flags);
    let mut reader = file.sound(address, length.saturating_add(head as u64 + 4), b"EASB")?;
    reader.take(head - 4)?;
    reader.take(usize::try_from(flags).unwrap_or(usize::MAX))?;
    let mut found = Vec::new();
    for _ in 0..blocks {
        found.push(file.offset(&mut reader)?);
    }
    Ok(found)
}
