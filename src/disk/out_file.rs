//! Files that are written: whole or not at all. They grow beside their place and are moved there at
//! their end, so that neither an interruption nor a full disk leaves half of one, or spoils the one before.
//! Symbolic links stay and lead to the new file; what else has the old one by a name of its own keeps it.

use std::fs::{File, Metadata, OpenOptions};
use std::io::{BufWriter, Error, ErrorKind, IntoInnerError, Stdout, Write};
use std::path::{Path, PathBuf};

use super::growing::Growing;
use super::place::Place;

/// A file that is being written.
pub struct OutFile {
    name: PathBuf,
    to: Sink,
}

enum Sink {
    File(Box<Beside>),
    /// A device or a pipe.
    Stream(BufWriter<File>),
    Stdout(BufWriter<Stdout>),
}

/// A file that takes its place at its end.
struct Beside {
    growing: BufWriter<Growing>,
    place: PathBuf,
    before: Option<Metadata>,
}

/// Why a file was not written.
#[derive(Debug)]
pub struct WriteError {
    name: PathBuf,
    error: Error,
}

impl WriteError {
    /// Names the file that an error is about.
    #[must_use]
    pub fn new(name: &Path, error: Error) -> Self {
        Self { name: name.to_owned(), error }
    }

    /// Whether the reader of a pipe went away.
    #[must_use]
    pub fn is_broken_pipe(&self) -> bool {
        self.error.kind() == ErrorKind::BrokenPipe
    }
}

impl std::fmt::Display for WriteError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}: {}", self.name.display(), self.error)
    }
}

impl std::error::Error for WriteError {}

impl OutFile {
    /// Begins a file; what stands at `path` stays until [`Self::keep`].
    ///
    /// # Errors
    /// Nothing can be written there.
    pub fn create(path: &Path) -> Result<Self, WriteError> {
        let begun = || match Place::of(path)? {
            Place::File { path: place, before } => {
                let growing = BufWriter::new(Growing::beside(&place)?);
                Ok(Sink::File(Box::new(Beside { growing, place, before })))
            }
            Place::Stream(path) => {
                let stream = OpenOptions::new().write(true).open(path)?;
                Ok(Sink::Stream(BufWriter::new(stream)))
            }
        };
        let to = begun().map_err(|error| WriteError::new(path, error))?;
        Ok(Self { name: path.to_owned(), to })
    }

    /// Standard output as a file.
    #[must_use]
    pub fn stdout() -> Self {
        let to = Sink::Stdout(BufWriter::new(std::io::stdout()));
        Self { name: "standard output".into(), to }
    }

    /// Whether a file can be written, without writing it: so that a wrong name costs no work.
    ///
    /// # Errors
    /// As [`Self::create`].
    pub fn can_be(path: &Path) -> Result<(), WriteError> {
        let looked = || match Place::of(path)? {
            Place::File { path, .. } => Growing::beside(&path).map(drop),
            // A pipe is opened once: its reader takes the end of the first writer for the end of all.
            Place::Stream(_) => Ok(()),
        };
        looked().map_err(|error| WriteError::new(path, error))
    }

    /// An error of writing it, with its name.
    #[must_use]
    pub fn failed(&self, error: Error) -> WriteError {
        WriteError::new(&self.name, error)
    }

    /// Puts the whole file into its place.
    ///
    /// # Errors
    /// It cannot be written to its end, or not be put there.
    pub fn keep(self) -> Result<(), WriteError> {
        let done = match self.to {
            Sink::File(file) => {
                let whole = file.growing.into_inner().map_err(IntoInnerError::into_error);
                whole.and_then(|whole| whole.put(&file.place, file.before.as_ref()))
            }
            Sink::Stream(mut stream) => stream.flush(),
            Sink::Stdout(mut stdout) => stdout.flush(),
        };
        done.map_err(|error| WriteError { name: self.name, error })
    }

    /// Writes the whole text and puts the file into its place.
    ///
    /// # Errors
    /// As [`Self::keep`].
    pub fn keep_text(mut self, text: &str) -> Result<(), WriteError> {
        self.write_all(text.as_bytes()).map_err(|error| self.failed(error))?;
        self.keep()
    }
}

impl Write for OutFile {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        match &mut self.to {
            Sink::File(file) => file.growing.write(bytes),
            Sink::Stream(stream) => stream.write(bytes),
            Sink::Stdout(stdout) => stdout.write(bytes),
        }
    }

    fn flush(&mut self) -> std::io::Result<()> {
        match &mut self.to {
            Sink::File(file) => file.growing.flush(),
            Sink::Stream(stream) => stream.flush(),
            Sink::Stdout(stdout) => stdout.flush(),
        }
    }
}

/// Whether files can be written into a folder, without writing one.
///
/// # Errors
/// It is no folder, or there is no right to make a file in it.
pub fn can_fill(folder: &Path) -> Result<(), WriteError> {
    Growing::beside(&folder.join("file")).map(drop).map_err(|error| WriteError::new(folder, error))
}

/// Writes bytes as a file, in place of the one that may stand there.
///
/// # Errors
/// As [`OutFile::create`] and [`OutFile::keep`].
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), WriteError> {
    let mut file = OutFile::create(path)?;
    file.write_all(bytes).map_err(|error| file.failed(error))?;
    file.keep()
}

/// Writes bytes as a file where nothing stands.
///
/// # Errors
/// Something stands there, or it cannot be written.
pub fn write_new(path: &Path, bytes: &[u8]) -> std::io::Result<()> {
    let mut growing = Growing::beside(path)?;
    growing.write_all(bytes)?;
    growing.put_new(path)
}
