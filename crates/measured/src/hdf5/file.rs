//! The file as a whole: where it begins, how wide its addresses are, and how much of it may be gone through.
//!
//! "HDF5 File Format Specification Version 3.0" (The HDF Group) is what all of this folder follows. Addresses, sizes and
//! counts are believed only as far as the file has bytes for them: every part that is gone to takes from a store of steps,
//! every array from one of bytes and one of values, so that parts that name each other in circles, and arrays that name
//! sizes of their own, end with a fault.

use std::cell::Cell;

use super::checksum::lookup3;
use crate::base::language::{text, tr};
use crate::bytes::ByteReader;
use crate::fault::DataFault;

/// First bytes of a file, which may stand behind a block of its user.
const SIGNATURE: &[u8] = b"\x89HDF\r\n\x1a\n";
/// Most that compressed bytes can become (deflate: 1032 to 1), and the most that is taken at all.
const MAX_RATIO: usize = 1100;
const MAX_BYTES: usize = 2_000_000_000;
/// Most values of a file.
const MAX_VALUES: usize = 1 << 28;
/// How often every byte of a file may be gone over on the way to its arrays.
const PASSES: usize = 16;

/// Why something is not read.
#[derive(Debug)]
pub(super) enum Trouble {
    /// The file is not as the format has it.
    Fault(DataFault),
    /// The format has it, this reader does not; a text for people.
    Unread(&'static str),
}

impl From<DataFault> for Trouble {
    fn from(fault: DataFault) -> Self {
        Self::Fault(fault)
    }
}

/// A file.
pub(super) struct Hdf5File<'a> {
    bytes: &'a [u8],
    /// Where address 0 is.
    base: usize,
    offset_size: usize,
    length_size: usize,
    /// Address of the root group's header.
    pub root: u64,
    steps: Cell<usize>,
    room: Cell<usize>,
    values: Cell<usize>,
}

/// Where a file's signature is: at its begin, or behind a block of 512 bytes or a power of two of it.
pub(crate) fn begin(bytes: &[u8]) -> Option<usize> {
    let places = std::iter::successors(Some(512usize), |place| place.checked_mul(2));
    std::iter::once(0)
        .chain(places.take_while(|place| *place < bytes.len()))
        .find(|place| bytes[*place..].starts_with(SIGNATURE))
}

/// A whole number of so many bytes, the lowest first.
pub(super) fn whole(reader: &mut ByteReader<'_>, size: usize) -> Result<u64, DataFault> {
    let bytes = reader.take(size)?;
    let mut eight = [0; 8];
    let Some(low) = eight.get_mut(..size) else {
        return Err(reader.fault(tr!("numbers of {size} bytes", size = size), tr("at most 8")));
    };
    low.copy_from_slice(bytes);
    Ok(u64::from_le_bytes(eight))
}

/// A fault for a version that is not known.
pub(super) fn unknown(reader: &ByteReader<'_>, what: &str, version: u8) -> DataFault {
    let found = tr!("version {version} of {what}", version = version, what = tr(what));
    reader.fault(found, tr("one that is known"))
}

impl<'a> Hdf5File<'a> {
    /// Reads the file's own description.
    pub fn open(bytes: &'a [u8]) -> Result<Self, DataFault> {
        let begin = begin(bytes).ok_or_else(|| {
            DataFault::of_file(tr("no signature of HDF5"), tr("one at byte 0, 512, 1024, ..."))
        })?;
        let mut reader = ByteReader::new(&bytes[begin..], begin);
        reader.take(SIGNATURE.len())?;
        let version = reader.u8()?;
        let size =
            |reader: &mut ByteReader<'_>| {
                let size = usize::from(reader.u8()?);
                match size {
                    2 | 4 | 8 => Ok(size),
                    _ => Err(reader
                        .fault(tr!("addresses of {size} bytes", size = size), tr("2, 4 or 8"))),
                }
            };
        let steps = bytes.len().saturating_mul(PASSES);
        let room = bytes.len().saturating_mul(MAX_RATIO).min(MAX_BYTES);
        let mut file = Self {
            bytes,
            base: begin,
            offset_size: 8,
            length_size: 8,
            root: 0,
            steps: Cell::new(steps),
            room: Cell::new(room),
            values: Cell::new(MAX_VALUES),
        };
        match version {
            0 | 1 => {
                reader.take(4)?;
                (file.offset_size, file.length_size) = (size(&mut reader)?, size(&mut reader)?);
                reader.take(if version == 0 { 9 } else { 13 })?;
            }
            2 | 3 => {
                (file.offset_size, file.length_size) = (size(&mut reader)?, size(&mut reader)?);
                reader.take(1)?;
            }
            version => return Err(unknown(&reader, text!("HDF5"), version)),
        }
        // The begin that is told counts not: programs that put a block in front leave it as it was.
        for _ in 0..2 {
            file.offset(&mut reader)?;
        }
        let place = reader.place();
        let end = file.offset(&mut reader)?.unwrap_or(0);
        if usize::try_from(end).is_ok_and(|end| end <= bytes.len()) {
            // The address of a driver, which only older files have here.
            if version < 2 {
                file.offset(&mut reader)?;
            }
        } else {
            let found = tr!("a file of {size} bytes", size = bytes.len());
            return Err(DataFault::at(place, found, tr!("{count} bytes", count = end)));
        }
        if version < 2 {
            // The root group's entry: the place of its name first.
            file.offset(&mut reader)?;
        }
        let place = reader.place();
        let root = file.offset(&mut reader)?;
        if version >= 2 {
            let end = reader.place() + 4;
            checked(bytes.get(begin..end).unwrap_or(&[]), begin)?;
        }
        file.root =
            root.ok_or_else(|| DataFault::at(place, tr("no root group"), tr("its address")))?;
        Ok(file)
    }

    /// The next address; none where it is said that there is none.
    pub fn offset(&self, reader: &mut ByteReader<'_>) -> Result<Option<u64>, DataFault> {
        let none = u64::MAX >> (64 - 8 * self.offset_size);
        Ok(Some(whole(reader, self.offset_size)?).filter(|offset| *offset != none))
    }

    /// The next address, which has to be there.
    pub fn address(&self, reader: &mut ByteReader<'_>) -> Result<u64, DataFault> {
        let place = reader.place();
        let offset = self.offset(reader)?;
        offset.ok_or_else(|| DataFault::at(place, tr("no address"), tr("one")))
    }

    /// The next size.
    pub fn length(&self, reader: &mut ByteReader<'_>) -> Result<u64, DataFault> {
        whole(reader, self.length_size)
    }

    /// Bytes of an address.
    pub fn offset_size(&self) -> usize {
        self.offset_size
    }

    /// Bytes of a size.
    pub fn length_size(&self) -> usize {
        self.length_size
    }

    /// The bytes from an address on.
    pub fn at(&self, address: u64) -> Result<ByteReader<'a>, DataFault> {
        let place = usize::try_from(address).ok().and_then(|x| x.checked_add(self.base));
        let rest = place.and_then(|place| Some((place, self.bytes.get(place..)?)));
        let Some((place, rest)) = rest else {
            let found = tr!("the address {address}", address = address);
            let most = self.bytes.len().saturating_sub(self.base);
            return Err(DataFault::of_file(found, tr!("at most {most}", most = most)));
        };
        Ok(ByteReader::new(rest, place))
    }

    /// So many bytes from an address on.
    pub fn block(&self, address: u64, length: u64) -> Result<ByteReader<'a>, DataFault> {
        let mut reader = self.at(address)?;
        let place = reader.place();
        let length = usize::try_from(length).unwrap_or(usize::MAX);
        let bytes = reader.take(length)?;
        self.step(length, place)?;
        Ok(ByteReader::new(bytes, place))
    }

    /// What stands in a block of so many bytes between its signature and its checksum, which is checked.
    pub fn sound(
        &self,
        address: u64,
        length: u64,
        signature: &[u8],
    ) -> Result<ByteReader<'a>, DataFault> {
        let mut block = self.block(address, length)?;
        let place = block.place();
        let bytes = block.take(block.left())?;
        checked(bytes, place)?;
        let mut inner = ByteReader::new(&bytes[..bytes.len() - 4], place);
        self.signed(&mut inner, signature)?;
        Ok(inner)
    }

    /// The signature that has to stand here.
    pub fn signed(&self, reader: &mut ByteReader<'_>, signature: &[u8]) -> Result<(), DataFault> {
        let place = reader.place();
        let found = reader.take(signature.len())?;
        if found == signature {
            return self.step(1, place);
        }
        let found = tr!("the bytes {bytes}", bytes = format!("{found:02x?}"));
        Err(DataFault::at(place, found, format!("`{}`", String::from_utf8_lossy(signature))))
    }

    /// Takes from the store of steps.
    pub fn step(&self, count: usize, place: usize) -> Result<(), DataFault> {
        let left = self.steps.get().checked_sub(count);
        self.steps.set(left.unwrap_or(0));
        left.map(|_| ()).ok_or_else(|| {
            let found = tr("parts of the file that name each other again and again");
            DataFault::at(place, found, tr("each of them once"))
        })
    }

    /// Takes from the store of bytes that arrays may have.
    pub fn take_bytes(&self, count: usize) -> Result<(), Trouble> {
        taken(&self.room, count)
    }

    /// Takes from the store of values.
    pub fn take_values(&self, count: usize) -> Result<(), Trouble> {
        taken(&self.values, count)
    }
}

fn taken(store: &Cell<usize>, count: usize) -> Result<(), Trouble> {
    let left = store.get().checked_sub(count);
    left.map(|left| store.set(left))
        .ok_or(Trouble::Unread(text!("more values than a file of this size can have")))
}

/// Whether a block ends with its checksum.
pub(super) fn checked(bytes: &[u8], place: usize) -> Result<(), DataFault> {
    let sum = bytes.len().checked_sub(4).map(|end| bytes.split_at(end));
    match sum {
        Some((bytes, sum)) if lookup3(bytes).to_le_bytes() == *sum => Ok(()),
        Some(_) | None => {
            let found = tr("a part of the file whose checksum does not fit");
            Err(DataFault::at(place, found, tr("one that does")))
        }
    }
}
