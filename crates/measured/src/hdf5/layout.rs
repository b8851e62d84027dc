//! How an array is laid out: its size, where its bytes are, what they went through, and what stands for those that were
//! never written.

use super::file::{Hdf5File, Trouble, unknown, whole};
use super::filters::{Filter, filters};
use super::header::{DATASPACE, FILL, FILL_OLD, FILTERS, Header, LAYOUT};
use crate::base::language::{text, tr};
use crate::bytes::ByteReader;
use crate::fault::DataFault;

/// Most dimensions of an array (the format's own).
const MAX_RANK: usize = 32;

/// The size of an array.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Space {
    pub dims: Vec<usize>,
    /// Most that it may grow to, where that was told.
    pub most: Vec<u64>,
    pub is_scalar: bool,
}

impl Space {
    pub fn read(file: &Hdf5File<'_>, reader: &mut ByteReader<'_>) -> Result<Self, DataFault> {
        let version = reader.u8()?;
        let rank = usize::from(reader.u8()?);
        let flags = reader.u8()?;
        let kind = match version {
            1 => {
                reader.take(5)?;
                u8::from(rank > 0)
            }
            2 => reader.u8()?,
            version => return Err(unknown(reader, text!("an array's size"), version)),
        };
        if rank > MAX_RANK {
            let found = tr!("{rank} dimensions", rank = rank);
            return Err(reader.fault(found, tr!("at most {most}", most = MAX_RANK)));
        }
        let mut dims = Vec::new();
        for _ in 0..rank {
            dims.push(usize::try_from(file.length(reader)?).unwrap_or(usize::MAX));
        }
        let mut most = dims.iter().map(|size| *size as u64).collect::<Vec<_>>();
        if flags & 1 != 0 {
            let unlimited = u64::MAX >> (64 - 8 * file.length_size());
            for most in &mut most {
                let told = file.length(reader)?;
                *most = if told == unlimited { u64::MAX } else { told };
            }
        }
        // Nothing at all.
        if kind == 2 {
            return Ok(Self { dims: vec![0], most: vec![0], is_scalar: false });
        }
        Ok(Self { is_scalar: dims.is_empty(), dims, most })
    }

    /// How many elements it has.
    pub fn count(&self) -> Result<usize, Trouble> {
        let count = self.dims.iter().try_fold(1usize, |all, size| all.checked_mul(*size));
        count.ok_or(Trouble::Unread(text!("more values than a file of this size can have")))
    }
}

/// What indexes the chunks of an array.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum ChunkIndex {
    /// A tree, first version.
    Tree,
    /// One chunk alone, with its bytes and which filters it did not go through.
    Single {
        packed: Option<(u64, u32)>,
    },
    /// One after the other.
    Implicit,
    FixedArray,
    ExtensibleArray,
    /// A tree, second version.
    Tree2,
}

/// Where the bytes of an array are.
#[derive(Clone, Debug)]
pub(super) enum Layout<'a> {
    /// Here.
    Compact(&'a [u8]),
    /// In one piece.
    Contiguous(Option<u64>),
    /// In pieces of this size.
    Chunked { size: Vec<usize>, index: ChunkIndex, address: Option<u64> },
}

/// An array of a file.
pub(super) struct Stored<'a> {
    pub space: Space,
    pub layout: Layout<'a>,
    pub filters: Vec<Filter>,
    /// An element that was never written.
    pub fill: &'a [u8],
}

impl<'a> Stored<'a> {
    /// The array of a header, if it has one.
    pub fn of(file: &Hdf5File<'a>, header: &Header<'a>) -> Result<Option<Self>, Trouble> {
        let (Some(space), Some(layout)) = (header.one(DATASPACE), header.one(LAYOUT)) else {
            return Ok(None);
        };
        let space = Space::read(file, &mut space.resolved(file)?)?;
        let layout = layout_of(file, &mut layout.resolved(file)?, &space)?;
        let filters = match header.one(FILTERS) {
            Some(message) => filters(&mut message.resolved(file)?)?,
            None => Vec::new(),
        };
        let fill = match (header.one(FILL), header.one(FILL_OLD)) {
            (Some(message), _) => fill(&mut message.resolved(file)?)?,
            (None, Some(message)) => {
                let mut body = message.resolved(file)?;
                let size = body.u32()? as usize;
                body.take(size)?
            }
            (None, None) => &[],
        };
        Ok(Some(Self { space, layout, filters, fill }))
    }
}

fn fill<'a>(reader: &mut ByteReader<'a>) -> Result<&'a [u8], DataFault> {
    let version = reader.u8()?;
    let is_told = match version {
        1 => {
            reader.take(3)?;
            true
        }
        2 => {
            reader.take(2)?;
            reader.u8()? != 0
        }
        3 => reader.u8()? & 0x20 != 0,
        version => {
            return Err(unknown(reader, text!("a value for what was never written"), version));
        }
    };
    let size = if is_told { reader.u32()? as usize } else { 0 };
    reader.take(size)
}

fn layout_of<'a>(
    file: &Hdf5File<'a>,
    reader: &mut ByteReader<'a>,
    space: &Space,
) -> Result<Layout<'a>, Trouble> {
    let version = reader.u8()?;
    let other = |reader: &ByteReader<'_>, class: u8| {
        let found = tr!("a layout of class {class}", class = class);
        Trouble::Fault(reader.fault(found, tr("0, 1 or 2")))
    };
    let rank = space.dims.len();
    match version {
        1 | 2 => {
            let dimensions = usize::from(reader.u8()?);
            let class = reader.u8()?;
            reader.take(5)?;
            let address = if class == 0 { None } else { file.offset(reader)? };
            let size = sizes(reader, dimensions, 4)?;
            match class {
                0 => {
                    let size = reader.u32()? as usize;
                    Ok(Layout::Compact(reader.take(size)?))
                }
                1 => Ok(Layout::Contiguous(address)),
                2 => chunked(reader, rank, size, ChunkIndex::Tree, address),
                class => Err(other(reader, class)),
            }
        }
        3..=5 => match reader.u8()? {
            0 => {
                let size = usize::from(reader.u16()?);
                Ok(Layout::Compact(reader.take(size)?))
            }
            1 => Ok(Layout::Contiguous(file.offset(reader)?)),
            2 if version == 3 => {
                let dimensions = usize::from(reader.u8()?);
                let address = file.offset(reader)?;
                let size = sizes(reader, dimensions, 4)?;
                chunked(reader, rank, size, ChunkIndex::Tree, address)
            }
            2 => {
                let flags = reader.u8()?;
                let dimensions = usize::from(reader.u8()?);
                let width = usize::from(reader.u8()?);
                let size = sizes(reader, dimensions, width)?;
                let index = match reader.u8()? {
                    1 if flags & 2 != 0 => {
                        let packed = (file.length(reader)?, reader.u32()?);
                        ChunkIndex::Single { packed: Some(packed) }
                    }
                    1 => ChunkIndex::Single { packed: None },
                    2 => ChunkIndex::Implicit,
                    3 => {
                        reader.take(1)?;
                        ChunkIndex::FixedArray
                    }
                    4 => {
                        reader.take(5)?;
                        ChunkIndex::ExtensibleArray
                    }
                    5 => {
                        reader.take(6)?;
                        ChunkIndex::Tree2
                    }
                    index => {
                        let found = tr!("an index of kind {kind}", kind = index);
                        return Err(reader.fault(found, tr("1 to 5")).into());
                    }
                };
                let address = file.offset(reader)?;
                chunked(reader, rank, size, index, address)
            }
            3 => Err(Trouble::Unread(text!("parts of arrays in other places (a virtual array)"))),
            class => Err(other(reader, class)),
        },
        version => Err(unknown(reader, text!("a layout"), version).into()),
    }
}

fn sizes(reader: &mut ByteReader<'_>, count: usize, width: usize) -> Result<Vec<usize>, DataFault> {
    let mut sizes = Vec::new();
    for _ in 0..count {
        sizes.push(usize::try_from(whole(reader, width)?).unwrap_or(usize::MAX));
    }
    Ok(sizes)
}

/// The last size is that of an element.
fn chunked<'a>(
    reader: &ByteReader<'_>,
    rank: usize,
    mut size: Vec<usize>,
    index: ChunkIndex,
    address: Option<u64>,
) -> Result<Layout<'a>, Trouble> {
    let told = size.len();
    size.truncate(rank);
    if told != rank + 1 || rank == 0 || size.contains(&0) {
        let found = tr!("chunks of {rank} dimensions", rank = told);
        let expected = tr!("{rank}, none of them 0", rank = rank + 1);
        return Err(reader.fault(found, expected).into());
    }
    Ok(Layout::Chunked { size, index, address })
}
