//! Equations as text with the values of a moment put in, and the numbers in them.
//!
//! Formulas are plain text; `_d` or `_{dyn}` marks a subscript and `^2` a superscript.

use crate::base::language::decimal;

/// One equation with its live values.
#[derive(Clone, Debug, PartialEq)]
pub struct Live {
    /// The formula with the coefficients that are in use.
    pub formula: String,
    /// The same with the values of the moment and the result.
    pub values: String,
    /// Where it holds; empty for an equation that holds everywhere.
    pub range: String,
    /// Whether the values lie within that range.
    pub valid: bool,
}

impl Live {
    /// An equation that holds everywhere.
    pub fn everywhere(formula: impl Into<String>, values: impl Into<String>) -> Self {
        let (formula, values) = (formula.into(), values.into());
        Self { formula, values, range: String::new(), valid: true }
    }
}

/// A number with four digits that count and no useless zeros after the point, as the chosen language writes it.
#[must_use]
pub fn number(x: f64) -> String {
    let magnitude = x.abs();
    let decimals = match magnitude {
        m if m >= 1000.0 => 0,
        m if m >= 100.0 => 1,
        m if m >= 10.0 => 2,
        m if m >= 0.01 || m == 0.0 => 3,
        m if m >= 1e-4 => 5,
        _ => return decimal(format!("{x:.2e}")),
    };
    let text = format!("{x:.decimals$}");
    if text.contains('.') {
        decimal(text.trim_end_matches('0').trim_end_matches('.').to_owned())
    } else {
        text
    }
}
