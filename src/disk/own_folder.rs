//! A user's own folder of files: where it is, what stands in it, and new files in it.
//!
//! It is the folder `files` among the user's data of this program, unless another one was chosen; the choice stands in a
//! file of one line beside it, so that the command line and the console have the same.

use std::fs::Metadata;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use super::{MAX_BYTES, bytes, make_folder, write, write_new};
use crate::base::language::tr;

/// Name of the folder that is taken where none was chosen.
const USUAL: &str = "files";
/// Name of the file with the choice.
const CHOICE: &str = "files-folder.txt";
/// Longest path that is read of it, bytes.
const MOST_PATH: u64 = 10_000;
/// Most files that are listed.
pub const MOST_LISTED: usize = 300;
/// How deep folders are looked into.
const MOST_DEEP: usize = 4;
/// Most entries of all folders that are looked at: a folder may hold anything.
const MOST_SEEN: usize = 10_000;
/// Numbers that are tried for a free name.
const MOST_COPIES: usize = 1000;

/// The user's folder for data of this program, if the system names one.
#[must_use]
pub fn user_folder() -> Option<PathBuf> {
    let var = |name: &str| {
        let value = std::env::var_os(name).map(PathBuf::from);
        value.filter(|path| path.is_absolute())
    };
    let base = if cfg!(target_os = "windows") {
        var("APPDATA")
    } else if cfg!(target_os = "macos") {
        var("HOME").map(|home| home.join("Library/Application Support"))
    } else {
        var("XDG_DATA_HOME").or_else(|| var("HOME").map(|home| home.join(".local/share")))
    };
    base.map(|base| base.join("steadycut"))
}

/// Where a user's own files are. See the head of this file.
#[derive(Clone, Debug)]
pub struct OwnFolder {
    home: PathBuf,
}

/// A file of a folder.
#[derive(Clone, Debug, PartialEq)]
pub struct FolderFile {
    /// Its name within the folder, parted by `/`.
    pub name: String,
    /// Its length, bytes.
    pub bytes: u64,
    /// When it was changed last, where the system knows.
    pub changed: Option<SystemTime>,
    /// Why it cannot be read.
    pub problem: Option<String>,
}

/// What stands in a folder.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FolderContents {
    /// Its files, by their names.
    pub files: Vec<FolderFile>,
    /// What was left out, in sentences.
    pub remarks: Vec<String>,
}

impl OwnFolder {
    /// That of this user, if the system names a place for it.
    #[must_use]
    pub fn of_user() -> Option<Self> {
        user_folder().map(|home| Self { home })
    }

    /// One whose choice stands in this folder.
    #[must_use]
    pub fn with_home(home: PathBuf) -> Self {
        Self { home }
    }

    /// The folder that is taken where none was chosen.
    #[must_use]
    pub fn usual(&self) -> PathBuf {
        self.home.join(USUAL)
    }

    /// The folder, which need not be there yet. A choice that cannot be read counts as none.
    #[must_use]
    pub fn place(&self) -> PathBuf {
        let file = std::fs::File::open(self.home.join(CHOICE)).ok();
        let read = file.and_then(|file| bytes(file, MOST_PATH).ok());
        let text = read.and_then(|bytes| String::from_utf8(bytes).ok());
        let chosen = text.map(|text| PathBuf::from(text.trim_end_matches(['\n', '\r'])));
        chosen.filter(|path| path.is_absolute()).unwrap_or_else(|| self.usual())
    }

    /// Takes another folder from now on.
    ///
    /// # Errors
    /// It is no folder, its path does not begin at the root or is no text, or the choice cannot be kept.
    pub fn choose(&self, folder: &Path) -> Result<(), String> {
        let shown = folder.display().to_string();
        let text = folder.to_str().filter(|text| !text.contains(['\n', '\r']));
        let Some(text) = text else {
            return Err(tr!("{folder}: the path is no plain text", folder = shown));
        };
        if !folder.is_absolute() {
            let root = if cfg!(windows) { "C:\\" } else { "/" };
            return Err(tr!(
                "{folder}: allowed is a path from the root on, as {root}\u{2026}",
                folder = shown,
                root = root
            ));
        }
        // The usual one is made with its first file.
        if !folder.is_dir() && folder != self.usual() {
            return Err(tr!("{folder}: there is no such folder", folder = shown));
        }
        let kept = make_folder(&self.home).map_err(|error| error.to_string()).and_then(|()| {
            write(&self.home.join(CHOICE), format!("{text}\n").as_bytes())
                .map_err(|error| error.to_string())
        });
        kept.map_err(|why| tr!("the choice of the folder is not kept: {why}", why = why))
    }
}

/// What stands in a folder and in those in it; one that is not there is empty. Names that begin with a full stop are
/// passed over, links to folders are not followed, and nothing is opened.
///
/// # Errors
/// It cannot be read.
pub fn list(folder: &Path) -> Result<FolderContents, String> {
    let told = |error: &std::io::Error| format!("{}: {error}", folder.display());
    match std::fs::metadata(folder) {
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(FolderContents::default()),
        Err(error) => return Err(told(&error)),
        Ok(found) if !found.is_dir() => {
            let folder = folder.display().to_string();
            return Err(tr!("{folder}: it is no folder", folder = folder));
        }
        Ok(_) => {}
    }
    let mut all = FolderContents::default();
    let mut seen = 0;
    let mut folders = vec![(folder.to_owned(), String::new(), 0)];
    while let Some((within, before, deep)) = folders.pop() {
        let entries = match std::fs::read_dir(&within) {
            Ok(entries) => entries,
            Err(error) if deep == 0 => return Err(told(&error)),
            Err(error) => {
                all.remarks.push(format!("{before}: {error}"));
                continue;
            }
        };
        for entry in entries {
            seen += 1;
            if seen > MOST_SEEN {
                all.remarks.push(tr!(
                    "There are more than {n} entries in this folder: the others are not looked at.",
                    n = MOST_SEEN
                ));
                folders.clear();
                break;
            }
            let entry = match entry {
                Ok(entry) => entry,
                Err(error) => {
                    all.remarks.push(format!("{before}: {error}"));
                    continue;
                }
            };
            let last = entry.file_name();
            let Some(plain) = last.to_str() else {
                let name = format!("{before}{}", last.to_string_lossy());
                let problem = tr("its name is no text").to_owned();
                all.files.push(FolderFile {
                    name,
                    bytes: 0,
                    changed: None,
                    problem: Some(problem),
                });
                continue;
            };
            if plain.starts_with('.') {
                continue;
            }
            let name = format!("{before}{plain}");
            let is_link = entry.file_type().is_ok_and(|kind| kind.is_symlink());
            // Of a link: of what it leads to.
            match std::fs::metadata(entry.path()) {
                Ok(found) if found.is_dir() && is_link => all
                    .remarks
                    .push(tr!("{name} is a link to a folder, which is not followed.", name = name)),
                Ok(found) if found.is_dir() && deep + 1 > MOST_DEEP => all.remarks.push(tr!(
                    "{name} lies more than {n} folders deep and is not looked into.",
                    name = name,
                    n = MOST_DEEP
                )),
                Ok(found) if found.is_dir() => {
                    folders.push((entry.path(), format!("{name}/"), deep + 1));
                }
                Ok(found) => all.files.push(of(name, &found)),
                Err(error) => {
                    let problem = Some(error.to_string());
                    all.files.push(FolderFile { name, bytes: 0, changed: None, problem });
                }
            }
        }
    }
    all.files.sort_by(|a, b| a.name.cmp(&b.name));
    if all.files.len() > MOST_LISTED {
        all.remarks.push(tr!(
            "There are {n} files in this folder: the first {most} by name are listed.",
            n = all.files.len(),
            most = MOST_LISTED
        ));
        all.files.truncate(MOST_LISTED);
    }
    Ok(all)
}

fn of(name: String, found: &Metadata) -> FolderFile {
    // A pipe or a device may never end.
    let problem = (!found.is_file()).then(|| tr("it is a pipe or a device, no file").to_owned());
    FolderFile { name, bytes: found.len(), changed: found.modified().ok(), problem }
}

/// The place of a file of a folder, by its name as [`list`] has it.
#[must_use]
pub fn place_in(folder: &Path, name: &str) -> PathBuf {
    name.split('/').fold(folder.to_owned(), |path, part| path.join(part))
}

/// The bytes of a file of a folder.
///
/// # Errors
/// It cannot be read, or is longer than any file that this program has a use for.
pub fn read_in(folder: &Path, name: &str) -> Result<Vec<u8>, String> {
    let path = place_in(folder, name);
    let read = || {
        // As it is now: it may be another thing than when it was listed.
        if !std::fs::metadata(&path)?.is_file() {
            return Err(ErrorKind::Unsupported.into());
        }
        bytes(std::fs::File::open(&path)?, MAX_BYTES)
    };
    read().map_err(|error| error.to_string())
}

/// Writes a new file into a folder, which is made if it is not there, under the name or the first free one like it; gives
/// the name. A file of this name that holds the same already is as good.
///
/// # Errors
/// It cannot be written: then nothing of it is there.
pub fn keep_in(folder: &Path, name: &str, contents: &[u8]) -> std::io::Result<String> {
    make_folder(folder)?;
    for name in copies(name) {
        let path = folder.join(&name);
        match write_new(&path, contents) {
            Ok(()) => return Ok(name),
            Err(error) if error.kind() == ErrorKind::AlreadyExists => {
                let same = std::fs::metadata(&path)
                    .is_ok_and(|found| found.is_file() && found.len() == contents.len() as u64)
                    && std::fs::read(&path).is_ok_and(|there| there == contents);
                if same {
                    return Ok(name);
                }
            }
            Err(error) => return Err(error),
        }
    }
    Err(ErrorKind::AlreadyExists.into())
}

/// A name and those like it: `a.toml`, `a-2.toml`, and so on.
fn copies(name: &str) -> impl Iterator<Item = String> {
    let (stem, ending) = match name.rsplit_once('.') {
        Some((stem, ending)) => (stem.to_owned(), format!(".{ending}")),
        None => (name.to_owned(), String::new()),
    };
    (1..=MOST_COPIES).map(move |copy| match copy {
        1 => format!("{stem}{ending}"),
        copy => format!("{stem}-{copy}{ending}"),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fresh(name: &str) -> PathBuf {
        let folder =
            std::env::temp_dir().join(format!("steadycut-own-{name}-{}", std::process::id()));
        let _ = std::fs::remove_dir_all(&folder);
        folder
    }

    #[test]
    fn the_choice_of_a_folder_is_kept_and_a_wrong_one_refused() {
        let home = fresh("choice");
        let own = OwnFolder::with_home(home.clone());
        assert_eq!(own.place(), home.join("files"));
        let refused = |path: &Path| own.choose(path).unwrap_err();
        assert!(refused(Path::new("files")).contains("root"));
        assert!(refused(&home.join("none")).contains("there is no such folder"));
        let other = home.join("other one");
        std::fs::create_dir_all(&other).unwrap();
        own.choose(&other).unwrap();
        assert_eq!(OwnFolder::with_home(home.clone()).place(), other);
        own.choose(&own.usual()).unwrap();
        assert_eq!(own.place(), own.usual(), "which is not there yet");
        for spoilt in [&b"relative"[..], b"", b"\xff"] {
            std::fs::write(home.join(CHOICE), spoilt).unwrap();
            assert_eq!(own.place(), own.usual());
        }
        std::fs::remove_dir_all(&home).unwrap();
    }

    #[test]
    fn nothing_is_overwritten_and_the_same_is_kept_once() {
        let folder = fresh("keep").join("deep");
        assert_eq!(list(&folder), Ok(FolderContents::default()), "one that is not there is empty");
        assert_eq!(keep_in(&folder, "a.toml", b"1").unwrap(), "a.toml");
        assert_eq!(keep_in(&folder, "a.toml", b"2").unwrap(), "a-2.toml");
        assert_eq!(keep_in(&folder, "a.toml", b"1").unwrap(), "a.toml");
        assert_eq!(keep_in(&folder, "a.toml", b"2").unwrap(), "a-2.toml");
        let names = |folder: &Path| -> Vec<String> {
            list(folder).unwrap().files.into_iter().map(|file| file.name).collect()
        };
        assert_eq!(names(&folder), ["a-2.toml", "a.toml"]);
        assert_eq!(read_in(&folder, "a-2.toml").unwrap(), b"2");
        assert!(keep_in(&folder.join("a.toml"), "b", b"").is_err());
        assert!(list(&folder.join("a.toml")).unwrap_err().contains("it is no folder"));
        std::fs::remove_dir_all(folder.parent().unwrap()).unwrap();
    }

    #[cfg(unix)]
    #[test]
    fn links_depth_number_and_odd_names_are_bounded_and_told() {
        use std::os::unix::ffi::OsStrExt;
        use std::os::unix::fs::symlink;
        let folder = fresh("bounds");
        let deep = folder.join("1/2/3/4/5");
        std::fs::create_dir_all(&deep).unwrap();
        std::fs::write(deep.join("x.toml"), "").unwrap();
        std::fs::write(folder.join("1/2/3/4/y.toml"), "").unwrap();
        std::fs::write(folder.join(".hidden.toml"), "").unwrap();
        std::fs::write(folder.join(std::ffi::OsStr::from_bytes(b"\xff.toml")), "").unwrap();
        symlink(&folder, folder.join("round")).unwrap();
        symlink(folder.join("nowhere"), folder.join("gone.toml")).unwrap();
        symlink(folder.join("1/2/3/4/y.toml"), folder.join("link.toml")).unwrap();
        let found = list(&folder).unwrap();
        let names: Vec<&str> = found.files.iter().map(|file| file.name.as_str()).collect();
        assert_eq!(names, ["1/2/3/4/y.toml", "gone.toml", "link.toml", "\u{fffd}.toml"]);
        let faulty = |name: &str| {
            found.files.iter().find(|file| file.name == name).unwrap().problem.is_some()
        };
        assert!(faulty("gone.toml") && faulty("\u{fffd}.toml") && !faulty("link.toml"));
        let told = found.remarks.join(" ");
        assert!(told.contains("round is a link") && told.contains("1/2/3/4/5 lies"), "{told}");
        for i in 0..=MOST_LISTED {
            std::fs::write(folder.join(format!("n{i:04}.toml")), "").unwrap();
        }
        let found = list(&folder).unwrap();
        assert_eq!(found.files.len(), MOST_LISTED);
        assert!(found.remarks.join(" ").contains("305 files"), "{:?}", found.remarks);
        std::fs::remove_dir_all(&folder).unwrap();
    }
}
