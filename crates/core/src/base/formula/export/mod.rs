//! A formula for other programs.
//!
//! Rust and C give the same bits as [`Formula::value`] where the formula has no `sin`, `cos` or `tanh`, which
//! are those of the platform; the others agree but for rounding.

mod code;
mod equation;
mod latex;

use super::{Formula, text};

crate::choice! {
    /// What a formula is written for.
    pub enum FormulaLanguage {
        /// Text that this program reads again.
        Text = "text", "Text";
        /// LaTeX, for a formula set in mathematics.
        Latex = "latex", "LaTeX";
        /// A function in Rust.
        Rust = "rust", "Rust";
        /// A function in C (C99).
        C = "c", "C";
        /// A function in Python 3.
        Python = "python", "Python";
        /// A formula of a spreadsheet (LibreOffice Calc); the inputs stand in row 2, from column A on.
        Spreadsheet = "spreadsheet", "Spreadsheet";
    }
}

impl Formula {
    /// The formula in another language. `name` is that of the function, where there is one; characters that
    /// a name cannot have there become underscores, of the inputs too.
    ///
    /// ```
    /// use steadycut_core::base::formula::{Formula, FormulaLanguage};
    ///
    /// let formula = Formula::parse("2 * a^3 - ln(b) / a", &["a", "b"]).unwrap();
    /// let latex = formula.export(FormulaLanguage::Latex, "");
    /// assert_eq!(latex, r"2\, a^{3} - \frac{\ln\left(b\right)}{a}");
    /// assert_eq!(formula.export(FormulaLanguage::Spreadsheet, ""), "=2*A2^3-LN(B2)/A2");
    /// ```
    #[must_use]
    pub fn export(&self, language: FormulaLanguage, name: &str) -> String {
        match language {
            FormulaLanguage::Text => text::print(self).0,
            FormulaLanguage::Latex => latex::latex(self),
            FormulaLanguage::Rust => code::rust(self, name),
            FormulaLanguage::C => code::c(self, name),
            FormulaLanguage::Python => code::python(self, name),
            FormulaLanguage::Spreadsheet => code::spreadsheet(self),
        }
    }
}
