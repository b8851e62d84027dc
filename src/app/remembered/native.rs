//! On the desktop: a file in the folder that the system has for such.

use std::path::PathBuf;

use super::Keeper;

/// Name of the file.
const NAME: &str = "remembered.json";

/// The user's folder for data of programs.
pub struct Folder(Option<PathBuf>);

impl Folder {
    /// That of this user, if the system names one.
    #[must_use]
    pub fn of_user() -> Self {
        Self(crate::disk::own_folder::user_folder())
    }
}

impl Keeper for Folder {
    fn kept(&self) -> Option<String> {
        crate::disk::read_text(&self.0.as_ref()?.join(NAME)).ok()
    }

    fn keep(&self, text: &str) -> bool {
        self.0.as_ref().is_some_and(|folder| {
            crate::disk::make_folder(folder).is_ok()
                && crate::disk::write(&folder.join(NAME), text.as_bytes()).is_ok()
        })
    }
}
