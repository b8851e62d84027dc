//! A zip of files (PKWARE's APPNOTE 6.3.3), deflated. There is no time in it, so that the same files give the same bytes.

use miniz_oxide::deflate::compress_to_vec;

use super::page::NamedFiles;
use crate::base::crc32::crc32;

/// Level of deflation: on from it there is little to gain, at twice the time.
const LEVEL: u8 = 7;
/// The first day that a zip can name, 1980-01-01, in the bits of MS-DOS.
const FIRST_DAY: u16 = (1 << 5) | 1;
/// Version that a reader needs: deflation and folders.
const NEEDED: u16 = 20;
/// Names are UTF-8.
const UTF8: u16 = 1 << 11;
/// The way of packing.
const DEFLATED: u16 = 8;

/// The bytes of a zip.
///
/// # Errors
/// More files or bytes than the format holds without its extension for large ones.
pub fn zipped(files: &NamedFiles) -> Result<Vec<u8>, String> {
    let too_large = |_| "the package is too large for a zip of 4 GB or 65535 files".to_owned();
    let (mut zip, mut directory) = (Vec::new(), Vec::new());
    for (name, bytes) in files {
        let packed = compress_to_vec(bytes, LEVEL);
        let at = u32::try_from(zip.len()).map_err(too_large)?;
        let sizes = [packed.len(), bytes.len()].map(u32::try_from);
        let [packed_size, size] = sizes;
        let name_size = u16::try_from(name.len()).map_err(too_large)?;
        // What both headers say of a file.
        let mut entry = Vec::new();
        for number in [NEEDED, UTF8, DEFLATED, 0, FIRST_DAY] {
            entry.extend(number.to_le_bytes());
        }
        for number in [crc32(bytes), packed_size.map_err(too_large)?, size.map_err(too_large)?] {
            entry.extend(number.to_le_bytes());
        }
        entry.extend(name_size.to_le_bytes());
        // No extra field.
        entry.extend(0_u16.to_le_bytes());
        zip.extend(b"PK\x03\x04");
        zip.extend(&entry);
        zip.extend(name.as_bytes());
        zip.extend(packed);
        directory.extend(b"PK\x01\x02");
        directory.extend(NEEDED.to_le_bytes());
        directory.extend(&entry);
        // No comment, the first disk, no attributes.
        directory.extend([0; 10]);
        directory.extend(at.to_le_bytes());
        directory.extend(name.as_bytes());
    }
    let at = u32::try_from(zip.len()).map_err(too_large)?;
    let size = u32::try_from(directory.len()).map_err(too_large)?;
    let count = u16::try_from(files.len()).map_err(too_large)?;
    zip.extend(directory);
    zip.extend(b"PK\x05\x06\0\0\0\0");
    for number in [count, count] {
        zip.extend(number.to_le_bytes());
    }
    for number in [size, at] {
        zip.extend(number.to_le_bytes());
    }
    zip.extend(0_u16.to_le_bytes());
    Ok(zip)
}
