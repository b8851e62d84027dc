//! On the desktop: a folder.

use std::path::{Path, PathBuf};

use super::shelf::{Shelf, Shelved, ShelvedFile};
use crate::base::language::tr;
use crate::disk::own_folder::{self, OwnFolder};

/// A user's own folder.
pub struct FolderShelf(OwnFolder);

impl FolderShelf {
    /// That of this user, if the system names a place for it.
    #[must_use]
    pub fn of_user() -> Option<Self> {
        OwnFolder::of_user().map(Self)
    }

    /// One whose choice stands in the folder `home`.
    #[must_use]
    pub fn with_home(home: PathBuf) -> Self {
        Self(OwnFolder::with_home(home))
    }
}

impl Shelf for FolderShelf {
    fn place(&self) -> Option<String> {
        Some(self.0.place().display().to_string())
    }

    fn list(&self) -> Result<Shelved, String> {
        let found = own_folder::list(&self.0.place())?;
        let files = found.files.into_iter().map(|file| {
            let own_folder::FolderFile { name, bytes, changed, problem } = file;
            ShelvedFile { name, bytes, changed, problem }
        });
        Ok(Shelved { files: files.collect(), remarks: found.remarks })
    }

    fn read(&self, name: &str) -> Result<Vec<u8>, String> {
        own_folder::read_in(&self.0.place(), name)
    }

    fn keep(&self, name: &str, bytes: &[u8]) -> Result<String, String> {
        own_folder::keep_in(&self.0.place(), name, bytes).map_err(|error| error.to_string())
    }

    fn remove(&self, name: &str) -> Result<(), String> {
        Err(tr!("{name}: remove it from its folder, as any other file", name = name))
    }

    fn can_remove(&self) -> bool {
        false
    }

    fn choose(&self, folder: &str) -> Result<(), String> {
        self.0.choose(Path::new(folder))
    }

    fn path(&self, name: &str) -> Option<PathBuf> {
        Some(own_folder::place_in(&self.0.place(), name))
    }
}
