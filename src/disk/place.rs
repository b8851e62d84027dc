//! Where a file that is written comes to stand.

use std::fs::{Metadata, OpenOptions};
use std::io::{Error, ErrorKind, Result};
use std::path::{Path, PathBuf};

/// Links that are followed one after the other; more go round in a circle.
const MOST_LINKS: usize = 40;

/// Where a file comes to stand.
pub enum Place {
    /// The new file takes the place of what stands there, if anything does.
    File {
        /// The place, links followed: they stay and lead to the new file.
        path: PathBuf,
        /// What stands there.
        before: Option<Metadata>,
    },
    /// A device, a pipe, or a file that is open already: it is written to as it is.
    Stream(PathBuf),
}

impl Place {
    /// The place that a path leads to.
    ///
    /// # Errors
    /// A folder stands there, a file that may not be written, or links that lead nowhere.
    pub fn of(path: &Path) -> Result<Self> {
        if path.as_os_str().is_empty() {
            return Err(Error::new(ErrorKind::InvalidInput, "a name is needed"));
        }
        let Some(path) = followed(path)? else {
            return Ok(Self::Stream(path.to_owned()));
        };
        let before = match std::fs::metadata(&path) {
            Ok(found) => Some(found),
            Err(error) if error.kind() == ErrorKind::NotFound => None,
            Err(error) => return Err(error),
        };
        let names_folder = path.as_os_str().as_encoded_bytes().ends_with(b"/");
        match &before {
            Some(found) if found.is_dir() => return Err(ErrorKind::IsADirectory.into()),
            Some(found) if !found.is_file() => return Ok(Self::Stream(path)),
            // A new file beside it would take its place without asking for the right to write it.
            Some(_) => drop(OpenOptions::new().write(true).open(&path)?),
            None if names_folder => return Err(ErrorKind::IsADirectory.into()),
            None => {}
        }
        Ok(Self::File { path, before })
    }
}

/// The end of a chain of symbolic links, whether anything stands there or not. None for what the system
/// has open under a number: its name leads to a file that may have lost its own.
fn followed(path: &Path) -> Result<Option<PathBuf>> {
    let mut path = path.to_owned();
    for _ in 0..MOST_LINKS {
        let open = ["/proc", "/dev/fd", "/dev/stdin", "/dev/stdout", "/dev/stderr"];
        if open.iter().any(|name| path.starts_with(name)) {
            return Ok(None);
        }
        match std::fs::read_link(&path) {
            Ok(target) => path = folder_of(&path).join(target),
            // What is no link, or not there, is the end; a faulty folder is found when it is used.
            Err(_) => return Ok(Some(path)),
        }
    }
    Err(Error::new(ErrorKind::InvalidInput, "symbolic links that lead back to themselves"))
}

/// The folder that a file stands in.
pub fn folder_of(path: &Path) -> &Path {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    folder.unwrap_or(Path::new("."))
}
