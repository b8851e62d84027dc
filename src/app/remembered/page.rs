//! In a page: the browser's local storage, which it may refuse.

use super::Keeper;

/// Name of the entry.
const NAME: &str = "steadycut.remembered";

/// The page's local storage.
pub struct PageStorage;

impl PageStorage {
    fn storage() -> Option<web_sys::Storage> {
        web_sys::window()?.local_storage().ok().flatten()
    }
}

impl Keeper for PageStorage {
    fn kept(&self) -> Option<String> {
        Self::storage()?.get_item(NAME).ok().flatten()
    }

    fn keep(&self, text: &str) -> bool {
        Self::storage().is_some_and(|storage| storage.set_item(NAME, text).is_ok())
    }
}
