//! In a page: there is no folder, so files are kept in the browser's storage, an entry for each. What is there is the
//! user's: nothing is overwritten, and what does not fit is told before anything is lost.

use std::path::PathBuf;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use super::shelf::{Shelf, Shelved, ShelvedFile};
use crate::base::language::tr;

/// Begin of the names of entries; the file's name follows.
const ENTRY: &str = "steadycut.file/";
/// Most files, the longest one, and most of all together, bytes: browsers keep some 5 MB for all of a page.
const MOST_FILES: usize = 100;
/// See [`MOST_FILES`].
const LONGEST: usize = 500_000;
/// See [`MOST_FILES`].
const MOST_BYTES: usize = 2_000_000;
/// Most characters of a name.
const LONGEST_NAME: usize = 120;
/// Before the text of a file, and before the bytes of another one in base 64.
const TEXT: char = 't';
/// See [`TEXT`].
const BYTES: char = 'b';

/// The entries of a storage: names with texts. A storage may refuse everything.
pub trait Slots: Send + Sync {
    /// The names of all entries; none where the storage is refused.
    fn names(&self) -> Option<Vec<String>>;
    /// The text of an entry.
    fn get(&self, name: &str) -> Option<String>;
    /// Writes an entry; `false` where that is refused or the storage is full, and all is as it was.
    fn put(&self, name: &str, text: &str) -> bool;
    /// Removes an entry; `false` where that is refused.
    fn remove(&self, name: &str) -> bool;
}

/// Files kept in a storage.
pub struct PageShelf<S: Slots>(pub S);

fn denied() -> String {
    tr("the browser refuses this page its storage: no file is kept here").to_owned()
}

/// What stands in the storage for a file.
fn written(bytes: &[u8]) -> String {
    match std::str::from_utf8(bytes) {
        Ok(text) => format!("{TEXT}{text}"),
        Err(_) => format!("{BYTES}{}", STANDARD.encode(bytes)),
    }
}

/// The file that stands there; none where that is spoilt.
fn read(text: &str) -> Option<Vec<u8>> {
    let rest = |sign: char| text.strip_prefix(sign);
    match (rest(TEXT), rest(BYTES)) {
        (Some(text), _) => Some(text.as_bytes().to_vec()),
        (None, Some(bytes)) => STANDARD.decode(bytes).ok(),
        (None, None) => None,
    }
}

impl<S: Slots> PageShelf<S> {
    fn names(&self) -> Result<Vec<String>, String> {
        let all = self.0.names().ok_or_else(denied)?;
        let names = all.iter().filter_map(|name| name.strip_prefix(ENTRY)).map(str::to_owned);
        let mut names: Vec<String> = names.collect();
        names.sort();
        Ok(names)
    }

    /// What all files take.
    fn taken(&self, names: &[String]) -> usize {
        let of = |name: &String| self.0.get(&entry(name)).map_or(0, |text| text.len());
        names.iter().map(of).sum()
    }
}

fn entry(name: &str) -> String {
    format!("{ENTRY}{name}")
}

/// Bytes in kB, up.
fn kb(bytes: usize) -> usize {
    bytes.div_ceil(1000)
}

impl<S: Slots> Shelf for PageShelf<S> {
    fn place(&self) -> Option<String> {
        None
    }

    fn list(&self) -> Result<Shelved, String> {
        let names = self.names()?;
        let taken = kb(self.taken(&names));
        let files = names.into_iter().map(|name| {
            let read = self.0.get(&entry(&name)).as_deref().and_then(read);
            let bytes = read.as_ref().map_or(0, |bytes| bytes.len() as u64);
            let spoilt = || tr("what the browser has kept of it is spoilt").to_owned();
            ShelvedFile { name, bytes, changed: None, problem: read.is_none().then(spoilt) }
        });
        let remark = tr!(
            "{taken} kB of {most} kB are taken. Whoever clears the browser's data of this page removes these files: \
             download what matters.",
            taken = taken,
            most = kb(MOST_BYTES)
        );
        Ok(Shelved { files: files.collect(), remarks: vec![remark] })
    }

    fn read(&self, name: &str) -> Result<Vec<u8>, String> {
        let text = self.0.get(&entry(name));
        let gone = || tr("it is not kept any more").to_owned();
        let spoilt = || tr("what the browser has kept of it is spoilt").to_owned();
        read(&text.ok_or_else(gone)?).ok_or_else(spoilt)
    }

    fn keep(&self, name: &str, bytes: &[u8]) -> Result<String, String> {
        let text = written(bytes);
        if bytes.len() > LONGEST {
            return Err(tr!(
                "it has {size} kB: at most {most} kB of a file are kept in a browser",
                size = kb(bytes.len()),
                most = kb(LONGEST)
            ));
        }
        let names = self.names()?;
        let (stem, ending) = name.rsplit_once('.').unwrap_or((name, ""));
        // What tells the kind is not cut off.
        let room = LONGEST_NAME.saturating_sub(ending.chars().count() + 1);
        let stem: String = stem.chars().take(room).collect();
        let ending: String = ending.chars().take(LONGEST_NAME).collect();
        let copies = (1..=MOST_FILES + 1).map(|copy| match copy {
            1 if ending.is_empty() => stem.clone(),
            1 => format!("{stem}.{ending}"),
            copy if ending.is_empty() => format!("{stem}-{copy}"),
            copy => format!("{stem}-{copy}.{ending}"),
        });
        let mut free = None;
        for copy in copies {
            match self.0.get(&entry(&copy)) {
                Some(there) if there == text => return Ok(copy),
                Some(_) => {}
                None => {
                    free = Some(copy);
                    break;
                }
            }
        }
        let Some(free) = free.filter(|_| names.len() < MOST_FILES) else {
            return Err(tr!(
                "{n} files are kept already, and no more can be: delete some first",
                n = names.len()
            ));
        };
        let (taken, more) = (self.taken(&names), text.len());
        if taken + more > MOST_BYTES {
            return Err(tr!(
                "{taken} kB of {most} kB are taken, and it has {size} kB: delete some first",
                taken = kb(taken),
                most = kb(MOST_BYTES),
                size = kb(more)
            ));
        }
        // What was put is asked for again: private windows may take it and forget it at once.
        if !self.0.put(&entry(&free), &text) || self.0.get(&entry(&free)).as_ref() != Some(&text) {
            return Err(tr(
                "the browser has no room for it or refuses it; what is kept already is as it was",
            )
            .to_owned());
        }
        Ok(free)
    }

    fn remove(&self, name: &str) -> Result<(), String> {
        match self.0.remove(&entry(name)) {
            true => Ok(()),
            false => Err(denied()),
        }
    }

    fn can_remove(&self) -> bool {
        true
    }

    fn choose(&self, folder: &str) -> Result<(), String> {
        Err(tr!("{folder}: a page has no folders", folder = folder))
    }

    fn path(&self, _: &str) -> Option<PathBuf> {
        None
    }
}

/// The local storage of this page.
#[cfg(target_arch = "wasm32")]
pub struct LocalSlots;

#[cfg(target_arch = "wasm32")]
impl LocalSlots {
    fn storage() -> Option<web_sys::Storage> {
        web_sys::window()?.local_storage().ok().flatten()
    }
}

#[cfg(target_arch = "wasm32")]
impl Slots for LocalSlots {
    fn names(&self) -> Option<Vec<String>> {
        let storage = Self::storage()?;
        let count = storage.length().ok()?;
        Some((0..count).filter_map(|i| storage.key(i).ok().flatten()).collect())
    }

    fn get(&self, name: &str) -> Option<String> {
        Self::storage()?.get_item(name).ok().flatten()
    }

    fn put(&self, name: &str, text: &str) -> bool {
        Self::storage().is_some_and(|storage| storage.set_item(name, text).is_ok())
    }

    fn remove(&self, name: &str) -> bool {
        Self::storage().is_some_and(|storage| storage.remove_item(name).is_ok())
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;
    use std::sync::Mutex;

    use super::*;

    /// A storage with so much room, bytes.
    struct Room(Mutex<BTreeMap<String, String>>, usize);

    impl Room {
        fn of(bytes: usize) -> PageShelf<Self> {
            let other = [("steadycut.remembered".to_owned(), "{}".to_owned())];
            PageShelf(Self(Mutex::new(other.into()), bytes))
        }
    }

    impl Slots for Room {
        fn names(&self) -> Option<Vec<String>> {
            (self.1 > 0).then(|| self.0.lock().unwrap().keys().cloned().collect())
        }

        fn get(&self, name: &str) -> Option<String> {
            self.0.lock().unwrap().get(name).cloned().filter(|_| self.1 > 0)
        }

        fn put(&self, name: &str, text: &str) -> bool {
            let mut all = self.0.lock().unwrap();
            let taken: usize = all.values().map(String::len).sum();
            let fits = taken + text.len() <= self.1;
            if fits {
                all.insert(name.to_owned(), text.to_owned());
            }
            fits
        }

        fn remove(&self, name: &str) -> bool {
            self.0.lock().unwrap().remove(name);
            self.1 > 0
        }
    }

    fn names<S: Slots>(shelf: &PageShelf<S>) -> Vec<String> {
        shelf.list().unwrap().files.into_iter().map(|file| file.name).collect()
    }

    #[test]
    fn files_are_kept_read_and_removed_and_nothing_else_is_touched() {
        let shelf = Room::of(10_000_000);
        assert_eq!(names(&shelf), [""; 0]);
        let latin = b"Fr\xe4ser \x00";
        assert_eq!(shelf.keep("ä b.toml", "größer".as_bytes()).unwrap(), "ä b.toml");
        assert_eq!(shelf.keep("x.mat", latin).unwrap(), "x.mat");
        assert_eq!(shelf.keep("x.mat", latin).unwrap(), "x.mat", "the same is kept once");
        assert_eq!(shelf.keep("x.mat", b"other").unwrap(), "x-2.mat", "nothing is overwritten");
        assert_eq!(names(&shelf), ["x-2.mat", "x.mat", "ä b.toml"]);
        assert_eq!(shelf.read("x.mat").unwrap(), latin);
        assert_eq!(shelf.read("ä b.toml").unwrap(), "größer".as_bytes());
        assert_eq!(shelf.list().unwrap().files[1].bytes, latin.len() as u64);
        shelf.remove("x.mat").unwrap();
        assert!(shelf.read("x.mat").unwrap_err().contains("not kept"));
        assert_eq!(names(&shelf), ["x-2.mat", "ä b.toml"]);
        shelf.0.put(&entry("spoilt.toml"), "zzz");
        let listed = shelf.list().unwrap();
        assert!(listed.files[0].problem.is_some() && listed.files[0].name == "spoilt.toml");
        assert!(shelf.0.get("steadycut.remembered").is_some());
    }

    #[test]
    fn what_has_no_room_is_told_and_nothing_is_lost() {
        let full = Room::of(30);
        full.keep("a.toml", b"0123456789").unwrap();
        let why = full.keep("b.toml", &[b'x'; 30]).unwrap_err();
        assert!(why.contains("no room"), "{why}");
        assert_eq!(full.read("a.toml").unwrap(), b"0123456789");
        assert_eq!(names(&full), ["a.toml"]);
        let shelf = Room::of(100_000_000);
        assert!(shelf.keep("a.mat", &vec![b'x'; LONGEST + 1]).unwrap_err().contains("501 kB"));
        for i in 0..4 {
            shelf.keep(&format!("{i}.csv"), &vec![b'0' + i; LONGEST - 10]).unwrap();
        }
        assert!(shelf.keep("4.csv", &vec![b'x'; LONGEST]).unwrap_err().contains("delete some"));
        let many = Room::of(100_000_000);
        for i in 0..MOST_FILES {
            many.keep("a.toml", i.to_string().as_bytes()).unwrap();
        }
        assert!(many.keep("a.toml", b"one more").unwrap_err().contains("100 files"));
        let long = format!("{}.toml", "n".repeat(400));
        let kept = Room::of(9_000_000).keep(&long, b"1").unwrap();
        assert!(kept.len() == LONGEST_NAME && kept.ends_with("n.toml"), "{kept}");
    }

    #[test]
    fn a_storage_that_is_refused_says_so() {
        let shelf = Room::of(0);
        for why in [
            shelf.list().unwrap_err(),
            shelf.keep("a.toml", b"1").unwrap_err(),
            shelf.remove("a.toml").unwrap_err(),
        ] {
            assert!(why.contains("refuses"), "{why}");
        }
    }
}
