//! A place in the bytes of a binary file: every step is checked, so that a file that ends too early or tells lengths
//! that it does not have is a fault with its place.

use crate::base::language::tr;
use crate::fault::DataFault;

/// Bytes that are read one after the other.
#[derive(Clone, Debug)]
pub(crate) struct ByteReader<'a> {
    bytes: &'a [u8],
    at: usize,
    /// Place of the first byte in the file.
    offset: usize,
    big_endian: bool,
}

macro_rules! numbers {
    ($($name:ident $type:ty),+ $(,)?) => {$(
        /// The next number.
        pub fn $name(&mut self) -> Result<$type, DataFault> {
            let bytes = self.array()?;
            Ok(if self.big_endian { <$type>::from_be_bytes(bytes) } else { <$type>::from_le_bytes(bytes) })
        }
    )+};
}

impl<'a> ByteReader<'a> {
    /// From the first byte on; `offset` is its place in the file.
    pub fn new(bytes: &'a [u8], offset: usize) -> Self {
        Self { bytes, at: 0, offset, big_endian: false }
    }

    /// The same with the other order of bytes in a number.
    pub fn ordered(mut self, big_endian: bool) -> Self {
        self.big_endian = big_endian;
        self
    }

    /// The place in the file.
    pub fn place(&self) -> usize {
        self.offset + self.at
    }

    /// How many bytes are left.
    pub fn left(&self) -> usize {
        self.bytes.len() - self.at
    }

    pub fn is_big_endian(&self) -> bool {
        self.big_endian
    }

    /// The next bytes.
    pub fn take(&mut self, count: usize) -> Result<&'a [u8], DataFault> {
        let end = self.at.checked_add(count).filter(|end| *end <= self.bytes.len());
        let Some(end) = end else {
            return Err(DataFault::at(
                self.place(),
                tr!("the file ends {left} bytes behind it", left = self.left()),
                tr!("{count} bytes", count = count),
            ));
        };
        let taken = &self.bytes[self.at..end];
        self.at = end;
        Ok(taken)
    }

    /// Leaves bytes out; those that are missing at the end of the file are no fault.
    pub fn skip(&mut self, count: usize) {
        self.at = self.at.saturating_add(count).min(self.bytes.len());
    }

    fn array<const N: usize>(&mut self) -> Result<[u8; N], DataFault> {
        let mut array = [0; N];
        array.copy_from_slice(self.take(N)?);
        Ok(array)
    }

    numbers!(u8 u8, u16 u16, u32 u32, u64 u64, i32 i32, i64 i64, f32 f32, f64 f64);

    /// A fault here.
    pub fn fault(&self, found: impl Into<String>, expected: impl Into<String>) -> DataFault {
        DataFault::at(self.place(), found, expected)
    }
}
