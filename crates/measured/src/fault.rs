//! What is wrong with a file of measured data: where, what stands there, and what was expected.

use std::fmt::{self, Display, Formatter};

use crate::base::language::tr;

/// Longest piece of a file that a fault shows, characters.
const MAX_SHOWN: usize = 40;

/// Where in a file a fault is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FaultPlace {
    /// The file as a whole.
    File,
    /// A line of a text, from 1.
    Line(u64),
    /// A cell of a text: its line and column, both from 1, and the column's name.
    Cell {
        /// Line, from 1.
        line: u64,
        /// Column, from 1.
        column: usize,
        /// The column's name.
        name: String,
    },
    /// A byte of a binary file, from 0.
    Byte(usize),
    /// Something in the file by its name.
    Entry(String),
}

/// What is wrong with a file of measured data.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DataFault {
    /// Where.
    pub place: FaultPlace,
    /// What stands there.
    pub found: String,
    /// What was expected there.
    pub expected: String,
}

impl DataFault {
    /// A fault at a place.
    pub fn new(place: FaultPlace, found: impl Into<String>, expected: impl Into<String>) -> Self {
        Self { place, found: found.into(), expected: expected.into() }
    }

    /// A fault at a byte of a binary file.
    pub fn at(byte: usize, found: impl Into<String>, expected: impl Into<String>) -> Self {
        Self::new(FaultPlace::Byte(byte), found, expected)
    }

    /// A fault of the file as a whole.
    pub fn of_file(found: impl Into<String>, expected: impl Into<String>) -> Self {
        Self::new(FaultPlace::File, found, expected)
    }
}

impl Display for DataFault {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let what = match (self.found.as_str(), self.expected.as_str()) {
            (found, "") => found.to_owned(),
            (found, expected) => {
                tr!("{found}; expected is {expected}", found = found, expected = expected)
            }
        };
        let told = match &self.place {
            FaultPlace::File => what,
            FaultPlace::Line(line) => tr!("line {line}: {what}", line = *line, what = what),
            FaultPlace::Cell { line, column, name } => tr!(
                "line {line}, column {column} ({name}): {what}",
                line = *line,
                column = *column,
                name = name,
                what = what
            ),
            FaultPlace::Byte(byte) => tr!("byte {byte}: {what}", byte = *byte, what = what),
            FaultPlace::Entry(name) => format!("`{name}`: {what}"),
        };
        f.write_str(&told)
    }
}

impl std::error::Error for DataFault {}

/// A piece of a file as a fault shows it: short, and in quotes.
pub(crate) fn shown(piece: &str) -> String {
    let short: String = piece.chars().take(MAX_SHOWN).collect();
    let dots = if short.len() < piece.len() { "..." } else { "" };
    format!("`{}{dots}`", short.escape_debug())
}
