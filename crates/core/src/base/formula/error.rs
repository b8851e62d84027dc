//! What is wrong with a formula, with its place.

use std::ops::Range;

use crate::base::language::tr;

/// Characters shown on either side of a fault in a long line.
const SHOWN: usize = 60;

/// Why a text is no formula.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{}\n{picture}", told(*column, problem))]
pub struct FormulaError {
    /// The column of the fault, from 1, in characters.
    pub column: usize,
    /// What stands there and what was expected.
    pub problem: String,
    /// The text with a line of carets below the fault.
    pub picture: String,
}

/// The first line.
fn told(column: usize, problem: &str) -> String {
    tr!("column {column}: {problem}", column = column, problem = problem)
}

impl FormulaError {
    /// A fault at bytes of a text.
    pub(super) fn new(text: &str, at: Range<usize>, problem: String) -> Self {
        let before = text[..at.start].chars().count();
        let width = text[at.clone()].chars().count().max(1);
        // A line break or tab would shift the carets.
        let shown = |c: char| if c.is_control() { ' ' } else { c };
        let first = before.saturating_sub(SHOWN);
        let line: String = text.chars().map(shown).skip(first).take(2 * SHOWN).collect();
        let carets = "^".repeat(width.min(2 * SHOWN - (before - first)));
        let picture = format!("  {}\n  {}{carets}", line.trim_end(), " ".repeat(before - first));
        Self { column: before + 1, problem, picture }
    }
}
