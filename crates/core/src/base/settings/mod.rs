//! Settings as data: one table entry per setting serves the scenario file, the link, `--set`, the
//! editor widgets, the list, validation and the fuzz tests.
//!
//! A settings struct is declared with [`settings!`](crate::settings!), a closed choice with
//! [`choice!`](crate::choice!), a value of several numbers by implementing [`Structure`] for its type.
//! Everything that changes a setting goes through [`Group::set`], which refuses what is outside the
//! declared range, so a struct never holds a bad value.

mod error;
mod field;
mod kind;
mod macros;
mod structure;
#[cfg(test)]
mod tests;
mod value;

pub use error::SettingError;
pub use field::{Field, Group, Spec};
pub use kind::{Choice, Kind};
pub use structure::{Column, Editor, FormulaShape, Numbers, Rows, Shape, Structure, Structured};
pub use value::Value;
