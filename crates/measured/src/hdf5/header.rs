//! The header of an object: its messages, from all blocks that they are kept in.

use super::file::{Hdf5File, unknown, whole};
use crate::base::language::{text, tr};
use crate::bytes::ByteReader;
use crate::fault::DataFault;

/// Kinds of messages.
pub(super) const DATASPACE: u16 = 0x01;
pub(super) const LINK_INFO: u16 = 0x02;
pub(super) const DATATYPE: u16 = 0x03;
pub(super) const FILL_OLD: u16 = 0x04;
pub(super) const FILL: u16 = 0x05;
pub(super) const LINK: u16 = 0x06;
pub(super) const LAYOUT: u16 = 0x08;
pub(super) const FILTERS: u16 = 0x0b;
pub(super) const ATTRIBUTE: u16 = 0x0c;
const CONTINUED: u16 = 0x10;
pub(super) const SYMBOL_TABLE: u16 = 0x11;
pub(super) const ATTRIBUTE_INFO: u16 = 0x15;

/// A message that stands in another object's header.
const SHARED: u8 = 2;

/// Something that a header says of its object.
#[derive(Clone, Debug)]
pub(super) struct Message<'a> {
    pub kind: u16,
    pub body: ByteReader<'a>,
    /// Whether the body only says where the message is.
    pub shared: bool,
}

/// The header of an object.
#[derive(Clone, Debug)]
pub(super) struct Header<'a> {
    pub messages: Vec<Message<'a>>,
}

impl<'a> Header<'a> {
    /// The header at an address.
    pub fn read(file: &Hdf5File<'a>, address: u64) -> Result<Self, DataFault> {
        let mut reader = file.at(address)?;
        let mut header = Self { messages: Vec::new() };
        if reader.clone().take(4)? == b"OHDR" {
            header.second(file, address)?;
            return Ok(header);
        }
        let version = reader.u8()?;
        if version != 1 {
            return Err(unknown(&reader, text!("an object's header"), version));
        }
        reader.take(7)?;
        let length = u64::from(reader.u32()?);
        let mut blocks = vec![file.block(address.saturating_add(16), length)?];
        while let Some(mut block) = blocks.pop() {
            while block.left() >= 8 {
                let (kind, size) = (block.u16()?, usize::from(block.u16()?));
                let flags = block.u8()?;
                block.take(3)?;
                if let Some((address, length)) = header.keep(file, kind, size, flags, &mut block)? {
                    blocks.push(file.block(address, length)?);
                }
            }
        }
        Ok(header)
    }

    /// The newer kind, with signatures and checksums.
    fn second(&mut self, file: &Hdf5File<'a>, address: u64) -> Result<(), DataFault> {
        let mut reader = file.at(address)?;
        let begin = reader.place();
        file.signed(&mut reader, b"OHDR")?;
        let version = reader.u8()?;
        if version != 2 {
            return Err(unknown(&reader, text!("an object's header"), version));
        }
        let flags = reader.u8()?;
        // Times, and when attributes are kept elsewhere.
        reader.take(if flags & 0x20 != 0 { 16 } else { 0 })?;
        reader.take(if flags & 0x10 != 0 { 4 } else { 0 })?;
        let length = whole(&mut reader, 1 << (flags & 3))?;
        let head = reader.place() - begin;
        let all = length.saturating_add(head as u64 + 4);
        let mut first = file.sound(address, all, b"OHDR")?;
        first.take(head - 4)?;
        let mut blocks = vec![first];
        let order = if flags & 4 != 0 { 2 } else { 0 };
        while let Some(mut block) = blocks.pop() {
            while block.left() >= 4 + order {
                let (kind, size) = (u16::from(block.u8()?), usize::from(block.u16()?));
                let flags = block.u8()?;
                block.take(order)?;
                if let Some((address, length)) = self.keep(file, kind, size, flags, &mut block)? {
                    blocks.push(file.sound(address, length, b"OCHK")?);
                }
            }
        }
        Ok(())
    }

    /// Keeps a message; gives address and size of a block that the header goes on in.
    fn keep(
        &mut self,
        file: &Hdf5File<'a>,
        kind: u16,
        size: usize,
        flags: u8,
        block: &mut ByteReader<'a>,
    ) -> Result<Option<(u64, u64)>, DataFault> {
        let place = block.place();
        let mut body = ByteReader::new(block.take(size)?, place);
        if kind == CONTINUED {
            return Ok(Some((file.address(&mut body)?, file.length(&mut body)?)));
        }
        if kind != 0 {
            self.messages.push(Message { kind, body, shared: flags & SHARED != 0 });
        }
        Ok(None)
    }

    /// All messages of a kind.
    pub fn all(&self, kind: u16) -> impl Iterator<Item = &Message<'a>> {
        self.messages.iter().filter(move |message| message.kind == kind)
    }

    /// The message of a kind.
    pub fn one(&self, kind: u16) -> Option<&Message<'a>> {
        self.messages.iter().find(|message| message.kind == kind)
    }
}

impl<'a> Message<'a> {
    /// The message itself: what stands here, or what it says where it stands.
    pub fn resolved(&self, file: &Hdf5File<'a>) -> Result<ByteReader<'a>, DataFault> {
        if !self.shared {
            return Ok(self.body.clone());
        }
        shared(file, &mut self.body.clone(), self.kind)
    }
}

/// A message of another object's header.
pub(super) fn shared<'a>(
    file: &Hdf5File<'a>,
    body: &mut ByteReader<'a>,
    kind: u16,
) -> Result<ByteReader<'a>, DataFault> {
    let version = body.u8()?;
    let of = body.u8()?;
    match version {
        1 => {
            body.take(6)?;
        }
        2 | 3 => {}
        version => return Err(unknown(body, text!("a message that is shared"), version)),
    }
    if version == 3 && of == 1 {
        let found = tr("a message in the heap of messages that are shared");
        return Err(body.fault(found, tr("one in an object's header")));
    }
    let place = body.place();
    let header = Header::read(file, file.address(body)?)?;
    match header.one(kind) {
        Some(message) if !message.shared => Ok(message.body.clone()),
        Some(_) | None => {
            let found = tr("an object without the message that it should share");
            Err(DataFault::at(place, found, tr("one with it")))
        }
    }
}
