//! Files as arguments: `-` is standard input or output, names need not be UTF-8, and nothing is written
//! over what is read. The types say what a command does with a file, so that [`check`] finds them all.

mod check;

use std::ffi::{OsStr, OsString};
use std::fmt::{Display, Formatter};
use std::io::Write;
use std::path::{Path, PathBuf};

use clap::builder::{PathBufValueParser, TypedValueParser, ValueParser, ValueParserFactory};

pub use check::{check, differ, hinted};

use crate::disk::{self, OutFile, WriteError};
use crate::run::presets::PRESETS;
use crate::run::scenario_link;
use crate::study::mission::shipped::MISSIONS;

/// Name of standard input and output.
const STANDARD: &str = "-";

/// A file that is read.
#[derive(Clone, Debug)]
pub struct InPath(PathBuf);

impl InPath {
    /// The file of this name; `-` is standard input.
    #[must_use]
    pub fn new(name: &str) -> Self {
        Self(name.into())
    }

    fn is_stdin(&self) -> bool {
        self.0.as_os_str() == STANDARD
    }

    /// The text of the file.
    ///
    /// # Errors
    /// It cannot be read, or is no text.
    pub fn read(&self) -> Result<String, String> {
        if self.is_stdin() { disk::read_stdin() } else { disk::read_text(&self.0) }
    }

    /// The bytes of a file of measured data.
    ///
    /// # Errors
    /// It cannot be read.
    pub fn measured(&self) -> Result<Vec<u8>, String> {
        let path = (!self.is_stdin()).then_some(self.0.as_path());
        disk::read_measured(path).map_err(|error| format!("{self}: {error}"))
    }

    /// The file beside this one whose name has so much more at its end, whether it is there or not, to be read and
    /// written; none for standard input.
    #[must_use]
    pub fn beside(&self, ending: &str) -> Option<(Self, OutPath)> {
        let name = |path: &Path| {
            let mut name = path.as_os_str().to_owned();
            name.push(ending);
            PathBuf::from(name)
        };
        (!self.is_stdin()).then(|| (Self(name(&self.0)), OutPath(name(&self.0))))
    }

    /// Whether a file is there.
    #[must_use]
    pub fn is_there(&self) -> bool {
        self.is_stdin() || self.0.exists()
    }

    /// The text of the file.
    ///
    /// # Errors
    /// As [`Self::read`], with the file's name.
    pub fn text(&self) -> Result<String, String> {
        self.read().map_err(|error| format!("{self}: {error}"))
    }
}

impl Display for InPath {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        match self.is_stdin() {
            true => f.write_str("standard input"),
            false => self.0.display().fmt(f),
        }
    }
}

/// A preset's name or a scenario file.
#[derive(Clone, Debug)]
pub struct ScenarioPath(OsString);

impl ScenarioPath {
    /// What is meant by a name.
    #[must_use]
    pub fn new(name: &Path) -> Self {
        Self(name.into())
    }

    /// The file; what looks like the name of one is one: it has an ending or a folder, or it is there.
    ///
    /// # Errors
    /// The name, where it is that of a preset or can only be meant as one; a link.
    pub fn source(&self) -> Result<InPath, &str> {
        if let Some(link) = self.link() {
            return Err(link);
        }
        file_or_name(&self.0, |name| PRESETS.iter().any(|preset| preset.name == name))
    }

    /// The text, where a link is meant and no file has its name.
    #[must_use]
    pub fn link(&self) -> Option<&str> {
        self.0.to_str().filter(|text| scenario_link::is_link(text) && !Path::new(text).exists())
    }

    /// Whether it is the preset with this name.
    #[must_use]
    pub fn is_preset(&self, name: &str) -> bool {
        self.source().err() == Some(name)
    }
}

/// The file that is meant, or the name of something shipped; what looks like the name of a file is one: it has an
/// ending or a folder, or it is there.
fn file_or_name(given: &OsStr, is_shipped: impl Fn(&str) -> bool) -> Result<InPath, &str> {
    let path = Path::new(given);
    let name = given.to_str();
    if let Some(name) = name.filter(|name| is_shipped(name)) {
        return Err(name);
    }
    let is_file = given == STANDARD
        || path.extension().is_some()
        || path.components().count() > 1
        || path.exists();
    match name {
        Some(name) if !is_file => Err(name),
        Some(_) | None => Ok(InPath(path.to_owned())),
    }
}

/// A formula as it is written, or the file of a formula's model.
#[derive(Clone, Debug)]
pub struct FormulaPath(OsString);

impl FormulaPath {
    /// The file, or the text of a formula; a name that ends like a model's file, or that is there, is one, for
    /// a formula may hold a full stop or a slash.
    ///
    /// # Errors
    /// The text.
    pub fn source(&self) -> Result<InPath, String> {
        let path = Path::new(&self.0);
        let ending =
            path.extension().is_some_and(|ending| ["toml", "json"].iter().any(|e| ending == *e));
        let is_file = self.0.as_os_str() == STANDARD || ending || path.is_file();
        match self.0.to_str() {
            Some(text) if !is_file => Err(text.to_owned()),
            Some(_) | None => Ok(InPath(path.to_owned())),
        }
    }
}

/// A shipped mission's id, or the file of a mission.
#[derive(Clone, Debug)]
pub struct MissionPath(OsString);

impl MissionPath {
    /// The file; what has an ending or a folder, or is there, is one.
    ///
    /// # Errors
    /// The id of a shipped mission, or what can only be meant as one.
    pub fn source(&self) -> Result<InPath, &str> {
        file_or_name(&self.0, |name| MISSIONS.iter().any(|mission| mission.id == name))
    }
}

/// A file that is written.
#[derive(Clone, Debug)]
pub struct OutPath(PathBuf);

impl OutPath {
    /// Whether the file is standard output, by any of its names.
    #[must_use]
    pub fn is_stdout(&self) -> bool {
        [STANDARD, "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"]
            .iter()
            .any(|name| *self.0 == **name)
    }

    /// Begins the file.
    ///
    /// # Errors
    /// It cannot be written.
    pub fn create(&self) -> Result<OutFile, WriteError> {
        if self.is_stdout() { Ok(OutFile::stdout()) } else { OutFile::create(&self.0) }
    }

    /// Writes a text as the whole file.
    ///
    /// # Errors
    /// It cannot be written.
    pub fn write(&self, text: &str) -> Result<(), WriteError> {
        self.create()?.keep_text(text)
    }
}

impl Display for OutPath {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        self.0.display().fmt(f)
    }
}

/// A folder whose files are read, with those of the folders in it.
#[derive(Clone, Debug)]
pub struct InFolder(PathBuf);

impl InFolder {
    /// Where it is.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.0
    }

    /// Its files.
    ///
    /// # Errors
    /// It cannot be read.
    fn paths(&self) -> Result<Vec<PathBuf>, String> {
        disk::files_in(&self.0).map_err(|error| format!("{self}: {error}"))
    }

    /// Its files with their names within it, parted by `/`, in the order of these names.
    ///
    /// # Errors
    /// One of them cannot be read, or has a name that is no text.
    pub fn files(&self) -> Result<Vec<(String, Vec<u8>)>, String> {
        let mut files = Vec::new();
        for path in self.paths()? {
            let within = path.strip_prefix(&self.0).unwrap_or(&path);
            let parts: Option<Vec<&str>> = within.iter().map(OsStr::to_str).collect();
            let file = path.display();
            let name = parts.ok_or_else(|| format!("{file}: its name is no text"))?.join("/");
            let bytes = disk::read(&path).map_err(|error| format!("{file}: {error}"))?;
            files.push((name, bytes));
        }
        files.sort();
        Ok(files)
    }
}

impl Display for InFolder {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        self.0.display().fmt(f)
    }
}

/// A folder that files are written into.
#[derive(Clone, Debug)]
pub struct OutFolder(PathBuf);

impl OutFolder {
    /// Writes texts as files of these names, after all of them have grown.
    ///
    /// # Errors
    /// One of them cannot be written: then none of those that are there is touched, unless the disk fails at
    /// the very last.
    pub fn write(&self, files: &[(&str, &str)]) -> Result<(), Box<dyn std::error::Error>> {
        let paths: Vec<OutPath> =
            files.iter().map(|(name, _)| OutPath(self.0.join(name))).collect();
        check::differ(&paths)?;
        let mut grown = Vec::new();
        for (path, (_, text)) in paths.iter().zip(files) {
            let mut file = path.create()?;
            file.write_all(text.as_bytes())
                .and_then(|()| file.flush())
                .map_err(|error| file.failed(error))?;
            grown.push(file);
        }
        Ok(grown.into_iter().try_for_each(OutFile::keep)?)
    }
}

impl Display for OutFolder {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        self.0.display().fmt(f)
    }
}

/// Where the report goes of a command that also writes a file: to standard output, or nowhere where the
/// file goes there.
///
/// # Errors
/// The report is asked for as JSON, and the file goes to standard output too.
pub fn report(json: bool, file: Option<&OutPath>) -> Result<Box<dyn Write>, String> {
    match file.filter(|path| path.is_stdout()) {
        Some(path) if json => Err(format!(
            "--json and a file named {path} both want standard output: leave one of them out"
        )),
        Some(_) => Ok(Box::new(std::io::sink())),
        None => Ok(Box::new(std::io::stdout().lock())),
    }
}

/// Reads arguments as paths, which are never empty.
macro_rules! paths {
    ($($name:ident)+) => {$(
        impl ValueParserFactory for $name {
            type Parser = ValueParser;

            fn value_parser() -> ValueParser {
                PathBufValueParser::new().map(|path| Self(path.into())).into()
            }
        }
    )+};
}
paths!(InPath InFolder ScenarioPath FormulaPath MissionPath OutPath OutFolder);
