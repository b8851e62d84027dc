//! Files of the command line and of the console on the desktop: what is read is text of any encoding that
//! says what it is, what is written is whole or not there.

mod growing;
mod out_file;
mod place;

use std::fs::File;
use std::io::{Error, ErrorKind, Read};
use std::path::Path;

pub use growing::abandon;
pub use out_file::{OutFile, WriteError, can_fill, write, write_new};

use crate::base::text::decode;

/// Longest file that is read, bytes: ten times the largest that any reader takes.
const MAX_BYTES: u64 = 40_000_000;

/// The bytes of a file.
///
/// # Errors
/// It cannot be read, or is longer than any file that this program has a use for.
pub fn read(path: &Path) -> std::io::Result<Vec<u8>> {
    bytes(File::open(path)?)
}

/// The text of a file.
///
/// # Errors
/// As [`read`] and [`decode`].
pub fn read_text(path: &Path) -> Result<String, String> {
    decode(&read(path).map_err(|error| error.to_string())?)
}

/// The text on standard input.
///
/// # Errors
/// As [`read`] and [`decode`].
pub fn read_stdin() -> Result<String, String> {
    decode(&bytes(std::io::stdin().lock()).map_err(|error| error.to_string())?)
}

/// All that comes, but not without end: a device may never stop.
fn bytes(from: impl Read) -> std::io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let read = from.take(MAX_BYTES + 1).read_to_end(&mut bytes)?;
    if read as u64 > MAX_BYTES {
        let problem = format!("more than {MAX_BYTES} bytes");
        return Err(Error::new(ErrorKind::FileTooLarge, problem));
    }
    Ok(bytes)
}
