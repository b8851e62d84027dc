//! A folder of one's own: what each of its files is, what it says of itself, or what is wrong with it.
//!
//! Bytes come in, nothing here opens a file: the command line and the console read a folder by `disk`, a page what it keeps
//! itself, and all of them ask [`LibraryFile::of`].

mod facts;
mod kind;

pub use kind::{
    LibraryKind, MEASURED, PROGRAMS, SCRIPTS, SPREADSHEETS, TABLES, TEXTS, ends_with_one_of,
};

use std::sync::Arc;

use crate::base::language::tr;
use crate::base::settings::{Field, Value};
use crate::blocks::control::ControllerKind;
use crate::formula_place::FormulaPlace;
use crate::run::edits::Edits;
use crate::run::scenario::Scenario;
use facts::Facts;

/// Largest file that is looked into for the list, bytes: some hundred times what any file but one of measured data takes.
pub const MOST_LOOKED_INTO: u64 = 4_000_000;

/// A file of a folder of one's own.
#[derive(Clone, Debug, PartialEq)]
pub struct LibraryFile {
    /// Its name within the folder, parted by `/`.
    pub name: String,
    /// What it is.
    pub kind: LibraryKind,
    /// Its length, bytes.
    pub bytes: u64,
    /// What it calls itself; empty where it has no name but its file's.
    pub title: String,
    /// What it describes, in a line.
    pub facts: String,
    /// What is wrong with it: line, entry, value and what is allowed, as far as they are known.
    pub fault: Option<String>,
    /// What a scenario that uses it has.
    pub has: LibraryHas,
}

/// What a scenario has that uses a file.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum LibraryHas {
    /// That cannot be told.
    #[default]
    Unknown,
    /// Settings with these values.
    Settings(Vec<(String, Value)>),
    /// It is this one, with these edits.
    Whole(Arc<(Scenario, Edits)>),
    /// The model of a formula, as settings write it, at one of the places that it can stand at by its units.
    Formula(String, Vec<FormulaPlace>),
}

impl LibraryHas {
    /// Settings, with their values as a scenario has them that takes them.
    ///
    /// # Errors
    /// No scenario takes them.
    fn of(changes: &[(String, Value)]) -> Result<Self, String> {
        let mut taken = Scenario::default();
        taken.set_all(changes).map_err(|error| error.to_string())?;
        let paths = changes.iter().map(|(path, _)| path.clone());
        let values: Result<Vec<(String, Value)>, _> =
            paths.map(|path| taken.get(&path).map(|value| (path, value))).collect();
        values.map(Self::Settings).map_err(|error| error.to_string())
    }
}

impl LibraryFile {
    /// A file by its name, its length and what `read` gives of it; none where the program has no use for files of such a
    /// name. What is too long to be looked into is not read.
    #[must_use]
    pub fn of(
        name: &str,
        bytes: u64,
        read: impl FnOnce() -> Result<Vec<u8>, String>,
    ) -> Option<Self> {
        if !kind::can_be_taken(name) {
            return None;
        }
        if bytes > MOST_LOOKED_INTO {
            return Some(Self::not_looked_into(name, bytes));
        }
        Some(match read() {
            Ok(contents) => Self::read(name, &contents),
            Err(why) => {
                Self { fault: Some(why), ..Self::new(name, LibraryKind::Unreadable, bytes) }
            }
        })
    }

    fn new(name: &str, kind: LibraryKind, bytes: u64) -> Self {
        Self {
            name: name.to_owned(),
            kind,
            bytes,
            title: String::new(),
            facts: String::new(),
            fault: None,
            has: LibraryHas::Unknown,
        }
    }

    fn not_looked_into(name: &str, bytes: u64) -> Self {
        let size = bytes as f64 / 1e6;
        if ends_with_one_of(name, &MEASURED) || ends_with_one_of(name, &TABLES) {
            let facts = tr!("{size:.1} MB, not looked into", size = size);
            return Self { facts, ..Self::new(name, LibraryKind::Measured, bytes) };
        }
        let fault = tr!(
            "{size:.1} MB: files of its kind have at most {most} MB",
            size = size,
            most = MOST_LOOKED_INTO / 1_000_000
        );
        Self { fault: Some(fault), ..Self::new(name, LibraryKind::Unreadable, bytes) }
    }

    /// Reads a file that the program takes.
    fn read(name: &str, contents: &[u8]) -> Self {
        let kind = LibraryKind::looked_into(name, contents);
        let file = Self::new(name, kind, contents.len() as u64);
        match Facts::of(kind, contents) {
            Ok(Facts { title, facts, has }) => Self { title, facts, has, ..file },
            Err(fault) => Self { fault: Some(fault), ..file },
        }
    }

    /// Whether a cut uses it, where that can be told: by its settings as they are now, and as a whole with its edits.
    #[must_use]
    pub fn is_in_use(&self, now: &Scenario, whole: (&Scenario, &Edits)) -> Option<bool> {
        match &self.has {
            LibraryHas::Unknown => None,
            LibraryHas::Settings(settings) => {
                let has =
                    |(path, value): &(String, Value)| now.get(path).is_ok_and(|now| now == *value);
                Some(settings.iter().all(has))
            }
            LibraryHas::Whole(own) => Some(own.0 == *whole.0 && own.1 == *whole.1),
            LibraryHas::Formula(text, places) => {
                let has = |place: &FormulaPlace| {
                    now.get(&place.path()).is_ok_and(|now| now == Value::Text(text.clone()))
                };
                Some(places.iter().any(has))
            }
        }
    }
}

/// The settings of a scenario that runs a controller's script.
#[must_use]
pub fn script_changes(script: &str) -> Vec<(String, Value)> {
    vec![
        ("controller.script.code".to_owned(), Value::Text(script.to_owned())),
        ("controller.kind".to_owned(), ControllerKind::Script.to_value()),
    ]
}

#[cfg(test)]
mod tests;
