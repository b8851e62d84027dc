//! Files that commands write: whole or not at all. They grow beside their place and are moved there at
//! their end, so that neither Ctrl+C nor a full disk leaves half of one, or spoils the one before.

use std::fs::File;
use std::io::{BufWriter, Error, ErrorKind, Write};
use std::path::{Path, PathBuf};

/// A file that is being written.
pub struct OutFile {
    path: PathBuf,
    /// Where it grows; none once it is in its place.
    growing: Option<PathBuf>,
    file: BufWriter<File>,
}

/// Says which file it is about.
fn named(path: &Path, error: &Error) -> String {
    format!("{}: {error}", path.display())
}

impl OutFile {
    /// Begins a file; what stands at `path` stays until [`Self::keep`].
    ///
    /// # Errors
    /// Nothing can be written there.
    pub fn create(path: &Path) -> Result<Self, String> {
        // What is no file is not replaced: a pipe or a device is written to as it is.
        let replaced = std::fs::metadata(path).map_or(Ok(true), |found| match found.is_dir() {
            true => Err(Error::from(ErrorKind::IsADirectory)),
            false => Ok(found.is_file()),
        });
        let growing = match replaced.map_err(|error| named(path, &error))? {
            true => {
                let mut name = path.file_name().unwrap_or_default().to_owned();
                name.push(format!(".{}.part", std::process::id()));
                Some(path.with_file_name(name))
            }
            false => None,
        };
        let file = File::create(growing.as_deref().unwrap_or(path));
        let file = BufWriter::new(file.map_err(|error| named(path, &error))?);
        Ok(Self { path: path.to_owned(), growing, file })
    }

    /// Puts the whole file into its place.
    ///
    /// # Errors
    /// It cannot be written to its end, or not be put there.
    pub fn keep(mut self) -> Result<(), String> {
        let written = self.file.flush().and_then(|()| match &self.growing {
            Some(growing) => std::fs::rename(growing, &self.path),
            None => Ok(()),
        });
        written.map_err(|error| named(&self.path, &error))?;
        self.growing = None;
        Ok(())
    }
}

impl Write for OutFile {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        self.file.write(bytes)
    }

    fn flush(&mut self) -> std::io::Result<()> {
        self.file.flush()
    }
}

impl Drop for OutFile {
    fn drop(&mut self) {
        if let Some(growing) = &self.growing {
            // It is of no use, and the reason has been reported.
            let _ = std::fs::remove_file(growing);
        }
    }
}

/// Writes a text as a file.
///
/// # Errors
/// As [`OutFile::create`] and [`OutFile::keep`].
pub fn write(path: &Path, text: &str) -> Result<(), String> {
    let mut file = OutFile::create(path)?;
    file.write_all(text.as_bytes()).map_err(|error| named(path, &error))?;
    file.keep()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_whole_or_not_there_and_the_one_before_stays_until_then() {
        let folder = std::env::temp_dir().join(format!("steadycut-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let path = folder.join("out.csv");
        let files = || std::fs::read_dir(&folder).unwrap().count();
        write(&path, "before").unwrap();
        let mut half = OutFile::create(&path).unwrap();
        half.write_all(b"half of wh").unwrap();
        assert_eq!(files(), 2);
        drop(half);
        assert_eq!((files(), std::fs::read_to_string(&path).unwrap().as_str()), (1, "before"));
        write(&path, "after").unwrap();
        assert_eq!((files(), std::fs::read_to_string(&path).unwrap().as_str()), (1, "after"));
        assert!(write(&folder, "x").unwrap_err().contains("directory"));
        assert!(write(&folder.join("no/such"), "x").is_err());
        std::fs::remove_dir_all(&folder).unwrap();
    }
}
