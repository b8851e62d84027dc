//! Where files of one's own are kept: a folder on the desktop, the browser's storage in a page.

use std::time::SystemTime;

/// Where files of one's own are kept. What it does may take long: it is asked on threads, or in jobs.
pub trait Shelf: Send + Sync {
    /// Where that is, for people; none where it has no place that they know.
    fn place(&self) -> Option<String>;
    /// Its files.
    ///
    /// # Errors
    /// They cannot be listed, in words.
    fn list(&self) -> Result<Shelved, String>;
    /// The bytes of a file.
    ///
    /// # Errors
    /// It cannot be read, in words.
    fn read(&self, name: &str) -> Result<Vec<u8>, String>;
    /// Keeps a file under its name or the first free one like it, and gives that; nothing is overwritten.
    ///
    /// # Errors
    /// It is not kept, in words; what was kept before is as it was.
    fn keep(&self, name: &str, bytes: &[u8]) -> Result<String, String>;
    /// Removes a file, where the shelf has no other hands to do it.
    ///
    /// # Errors
    /// It is still there, in words.
    fn remove(&self, name: &str) -> Result<(), String>;
    /// Whether files are removed here: in a folder they are removed as any others.
    fn can_remove(&self) -> bool;
    /// Another folder is taken from now on.
    ///
    /// # Errors
    /// It cannot be one, in words.
    fn choose(&self, folder: &str) -> Result<(), String>;
    /// Where a file is in the file system, for what stands beside it.
    fn path(&self, name: &str) -> Option<std::path::PathBuf>;
}

/// A file on a shelf.
#[derive(Clone, Debug, PartialEq)]
pub struct ShelvedFile {
    /// Its name.
    pub name: String,
    /// Its length, bytes.
    pub bytes: u64,
    /// When it was changed last; none where that is not known.
    pub changed: Option<SystemTime>,
    /// Why it cannot be read.
    pub problem: Option<String>,
}

/// What stands on a shelf.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shelved {
    /// Its files, by their names.
    pub files: Vec<ShelvedFile>,
    /// What was left out or is to be known, in sentences.
    pub remarks: Vec<String>,
}
