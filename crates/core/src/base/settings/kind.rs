//! What a setting may hold.

use serde::Serialize;

use super::{Editor, Structured};

use crate::base::language::tr;

/// One option of a closed choice.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Choice {
    /// Its name in files and on the command line.
    pub id: &'static str,
    /// Its name for people.
    pub label: &'static str,
    /// What it is, with its source.
    pub doc: &'static str,
}

/// What a setting may hold.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Kind {
    /// A finite real number within the range.
    Float {
        /// Least value allowed.
        min: f64,
        /// Largest value allowed.
        max: f64,
    },
    /// A whole number within the range.
    Int {
        /// Least value allowed.
        min: i64,
        /// Largest value allowed.
        max: i64,
    },
    /// `true` or `false`.
    Bool,
    /// One of the listed ids.
    Choice {
        /// The options.
        options: &'static [Choice],
    },
    /// Text of at most this many characters.
    Text {
        /// Most characters allowed.
        max_chars: usize,
    },
    /// What a type of its own describes: it names its kind itself.
    #[serde(untagged)]
    Structured(Structured),
}

impl Kind {
    /// Whether its value is a formula of one's own, or none.
    #[must_use]
    pub fn takes_formula(&self) -> bool {
        matches!(self, Self::Structured(shape) if matches!(shape.editor(), Editor::Formula(_)))
    }

    /// What is allowed, in words, with the unit.
    #[must_use]
    pub fn allowed(&self, unit: &str) -> String {
        let unit_behind = if unit.is_empty() { String::new() } else { format!(" {unit}") };
        match self {
            Self::Float { min, max } => tr!(
                "a number from {min} to {max}{unit}",
                min = *min,
                max = *max,
                unit = unit_behind
            ),
            Self::Int { min, max } => tr!(
                "a whole number from {min} to {max}{unit}",
                min = *min,
                max = *max,
                unit = unit_behind
            ),
            Self::Bool => tr("true or false").to_owned(),
            Self::Choice { options } => {
                let ids: Vec<&str> = options.iter().map(|option| option.id).collect();
                tr!("one of {ids}", ids = ids.join(", "))
            }
            Self::Text { max_chars } => tr!("text of at most {n} characters", n = *max_chars),
            Self::Structured(shape) => shape.allowed(unit),
        }
    }

    /// A bound of a structured kind by its name.
    #[must_use]
    pub fn bound(&self, name: &str) -> Option<f64> {
        let Self::Structured(shape) = self else { return None };
        shape.bounds().into_iter().find(|(bound, _)| *bound == name).map(|(_, bound)| bound)
    }
}
