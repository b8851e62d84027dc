//! What happens where the desktop has no file dialog: then the dialog is "cancelled" at once.

use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use crate::base::language::text;
use crate::disk;

/// Nobody cancels a dialog faster.
const FASTEST_HAND: Duration = Duration::from_millis(300);
/// Numbers that are tried for a free name.
const MOST_COPIES: usize = 1000;

/// What is said where no dialog could be opened to choose a file.
pub const NO_DIALOG_TO_OPEN: &str = text!(
    "No file dialog is available: drag a scenario file onto the window, or start with `steadycut --scenario FILE`."
);

/// The time at which a dialog was asked for.
pub struct Opened(Instant);

impl Opened {
    #[expect(clippy::disallowed_methods, reason = "how long a dialog was open is no simulation")]
    pub fn now() -> Self {
        Self(Instant::now())
    }

    /// Whether a dialog that is closed now was never there.
    pub fn was_never_shown(&self) -> bool {
        self.0.elapsed() < FASTEST_HAND
    }
}

/// Writes a new file into a folder, under the name or the first free one like it.
pub fn save(folder: &Path, name: &str, bytes: &[u8]) -> std::io::Result<PathBuf> {
    let (stem, extension) = name.rsplit_once('.').unwrap_or((name, ""));
    for copy in 1..=MOST_COPIES {
        let name = if copy == 1 { name.to_owned() } else { format!("{stem}-{copy}.{extension}") };
        let path = folder.join(name);
        match disk::write_new(&path, bytes) {
            Ok(()) => return Ok(path),
            Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
            Err(error) => return Err(error),
        }
    }
    Err(ErrorKind::AlreadyExists.into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_overwritten() {
        let folder = std::env::temp_dir().join(format!("steadycut-save-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let first = save(&folder, "a.b.toml", b"1").unwrap();
        let second = save(&folder, "a.b.toml", b"2").unwrap();
        assert_eq!(first, folder.join("a.b.toml"));
        assert_eq!(second, folder.join("a.b-2.toml"));
        assert_eq!(std::fs::read(first).unwrap(), b"1");
        assert_eq!(std::fs::read(second).unwrap(), b"2");
        std::fs::remove_dir_all(&folder).unwrap();
        assert!(save(&folder, "a.toml", b"3").is_err());
    }
}
