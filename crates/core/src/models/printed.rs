//! Equations as their sources print them.

/// An equation as its source prints it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Printed {
    /// The formula, in plain text with `_{}` and `^{}`.
    pub formula: &'static str,
    /// Paper and equation number, or why there is none.
    pub source: &'static str,
}

impl Printed {
    /// A formula with its source.
    #[must_use]
    pub const fn new(formula: &'static str, source: &'static str) -> Self {
        Self { formula, source }
    }
}
