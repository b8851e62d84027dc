//! Files that are not whole yet. They stand beside their place under a name of their own, and leave nothing
//! where they are given up, not even where the program is ended from outside.

use std::ffi::OsString;
use std::fs::{File, Metadata};
use std::io::{Error, Result, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use tempfile::{Builder, NamedTempFile, TempPath};

use super::place::folder_of;

/// Those that are there now.
static ALL: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

fn all() -> MutexGuard<'static, Vec<PathBuf>> {
    ALL.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Removes all files that are not whole, because the program ends now.
pub fn abandon() {
    for path in all().drain(..) {
        // One that is in its place by now has this name no more.
        let _ = std::fs::remove_file(path);
    }
}

/// A file that is not whole yet.
pub struct Growing {
    file: File,
    /// None once it is in its place.
    path: Option<TempPath>,
    name: PathBuf,
}

impl Growing {
    /// Begins a file beside its place.
    ///
    /// # Errors
    /// There is no such folder, or no right to make a file in it.
    pub fn beside(place: &Path) -> Result<Self> {
        let folder = folder_of(place);
        let mut start = OsString::from(".");
        start.push(place.file_name().unwrap_or_default());
        start.push(".");
        let mut builder = Builder::new();
        builder.prefix(&start).suffix(".part");
        // The umask decides, as for any new file; without this it would be the owner's alone.
        #[cfg(unix)]
        let builder = builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
        // Locked until it is known: the program may be ended at any moment.
        let mut known = all();
        let made = builder.tempfile_in(folder).map_err(|error| {
            let folder = folder.display();
            Error::new(error.kind(), format!("no file can be made in {folder}: {}", plain(&error)))
        });
        let (file, path) = made.map(NamedTempFile::into_parts)?;
        let name = path.to_path_buf();
        known.push(name.clone());
        Ok(Self { file, path: Some(path), name })
    }

    /// Puts the file into its place, with the rights of the one `before`.
    ///
    /// # Errors
    /// It is not safely on the disk, or cannot be put there.
    pub fn put(mut self, place: &Path, before: Option<&Metadata>) -> Result<()> {
        // A disk may say only now that it is full.
        self.file.sync_all()?;
        before.map_or(Ok(()), |before| like(&self.file, before))?;
        let path = self.path.take();
        path.map_or(Ok(()), |path| path.persist(place).map_err(|error| error.error))
    }

    /// Puts the file into its place if nothing stands there.
    ///
    /// # Errors
    /// As [`Self::put`], or something stands there.
    pub fn put_new(mut self, place: &Path) -> Result<()> {
        self.file.sync_all()?;
        let path = self.path.take();
        path.map_or(Ok(()), |path| path.persist_noclobber(place).map_err(|error| error.error))
    }
}

impl Write for Growing {
    fn write(&mut self, bytes: &[u8]) -> Result<usize> {
        self.file.write(bytes)
    }

    fn flush(&mut self) -> Result<()> {
        self.file.flush()
    }
}

impl Drop for Growing {
    fn drop(&mut self) {
        // First the file, then its entry: nothing is left where the program is ended between them.
        drop(self.path.take());
        all().retain(|name| *name != self.name);
    }
}

/// The system's words, without the name that follows them, of a file that nobody has asked for.
fn plain(error: &Error) -> String {
    let text = error.to_string();
    text.split(" at path ").next().unwrap_or_default().to_owned()
}

/// Gives a file the rights of another one, and its owner as far as that is allowed.
#[cfg(unix)]
fn like(file: &File, before: &Metadata) -> Result<()> {
    use std::os::unix::fs::{MetadataExt, fchown};
    // Only root may give a file away, but every member of a group may give it to the group.
    if fchown(file, Some(before.uid()), Some(before.gid())).is_err() {
        let _ = fchown(file, None, Some(before.gid()));
    }
    file.set_permissions(before.permissions())
}

#[cfg(not(unix))]
fn like(_: &File, _: &Metadata) -> Result<()> {
    Ok(())
}
