//! Files of the command line and of the console on the desktop: what is read is text of any encoding that
//! says what it is, what is written is whole or not there.

mod growing;
mod out_file;
pub mod own_folder;
mod place;

use std::fs::File;
use std::io::{Error, ErrorKind, Read};
use std::path::{Path, PathBuf};

pub use growing::abandon;
pub use out_file::{OutFile, WriteError, can_fill, write, write_new};

use crate::base::text::decode;

/// Longest file that is read, bytes: ten times the largest that any reader takes.
const MAX_BYTES: u64 = 40_000_000;
/// Longest file of measured data that is read, bytes: some 50 million rows of text.
const MAX_MEASURED: u64 = 2_000_000_000;

/// The bytes of a file.
///
/// # Errors
/// It cannot be read, or is longer than any file that this program has a use for.
pub fn read(path: &Path) -> std::io::Result<Vec<u8>> {
    bytes(File::open(path)?, MAX_BYTES)
}

/// The bytes of a file of measured data, which may be longer than others; without a path those on standard input.
///
/// # Errors
/// As [`read`].
pub fn read_measured(path: Option<&Path>) -> std::io::Result<Vec<u8>> {
    match path {
        Some(path) => bytes(File::open(path)?, MAX_MEASURED),
        None => bytes(std::io::stdin().lock(), MAX_MEASURED),
    }
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
    decode(&bytes(std::io::stdin().lock(), MAX_BYTES).map_err(|error| error.to_string())?)
}

/// Most files of a folder that are looked for, and how deep folders may lie in it.
const MOST_FILES: usize = 1000;
/// See [`MOST_FILES`].
const MOST_DEEP: usize = 8;

/// The files of a folder and of those in it.
///
/// # Errors
/// It cannot be read, or holds more than any folder that this program has a use for.
pub fn files_in(folder: &Path) -> std::io::Result<Vec<PathBuf>> {
    let (mut files, mut folders) = (Vec::new(), vec![(folder.to_owned(), 0)]);
    while let Some((folder, deep)) = folders.pop() {
        for entry in std::fs::read_dir(&folder)? {
            let path = entry?.path();
            if std::fs::metadata(&path)?.is_dir() {
                folders.push((path, deep + 1));
            } else {
                files.push(path);
            }
        }
        if files.len() > MOST_FILES || folders.iter().any(|(_, deep)| *deep > MOST_DEEP) {
            let problem =
                format!("more than {MOST_FILES} files, or folders in it {MOST_DEEP} deep");
            return Err(Error::new(ErrorKind::FileTooLarge, problem));
        }
    }
    files.sort();
    Ok(files)
}

/// Makes a folder, with those that it lies in, if it is not there.
///
/// # Errors
/// It cannot be made.
pub fn make_folder(path: &Path) -> std::io::Result<()> {
    std::fs::create_dir_all(path)
}

/// Removes a file; one that is not there is as good as removed.
///
/// # Errors
/// It is still there.
pub fn remove(path: &Path) -> std::io::Result<()> {
    match std::fs::remove_file(path) {
        Err(error) if error.kind() != ErrorKind::NotFound => Err(error),
        Ok(()) | Err(_) => Ok(()),
    }
}

/// All that comes, but not without end: a device may never stop.
fn bytes(from: impl Read, most: u64) -> std::io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let read = from.take(most + 1).read_to_end(&mut bytes)?;
    if read as u64 > most {
        let problem = format!("more than {most} bytes");
        return Err(Error::new(ErrorKind::FileTooLarge, problem));
    }
    Ok(bytes)
}
