//! Units of the columns, and formulas that are right in them.

use super::node::Sum;
use super::written::{Columns, formula};
pub use crate::base::column_unit::{by_name, without_unit};
use crate::base::formula::{Formula, NumberUnits, Unit};

/// The rule that formulas are right in their units.
#[derive(Clone, Debug, PartialEq)]
pub struct UnitRule {
    /// The inputs of the search.
    pub columns: Columns,
    /// Their units.
    pub inputs: Vec<Unit>,
    /// The target's.
    pub output: Unit,
}

impl UnitRule {
    /// The formula's constants with their units, as `value unit`.
    ///
    /// # Errors
    /// The part whose units do not fit.
    pub fn constants(&self, formula: &Formula) -> Result<Vec<String>, String> {
        let checked = formula.check_units(&self.inputs, &self.output, NumberUnits::Solved);
        let checked = checked.map_err(|error| error.to_string())?;
        let told = |constant: &crate::base::formula::ConstantUnit| {
            format!("{} {}", constant.text, constant.unit)
        };
        Ok(checked.constants.iter().map(told).collect())
    }

    /// Whether a formula of the search is right in its units.
    #[must_use]
    pub fn allows(&self, sum: &Sum) -> bool {
        let Ok(formula) = formula(sum, &self.columns) else { return false };
        formula.check_units(&self.inputs, &self.output, NumberUnits::Solved).is_ok()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::column_unit::ENDINGS;

    #[test]
    fn columns_tell_their_units_by_the_ends_of_their_names() {
        for (name, unit) in ENDINGS {
            let told = by_name(&format!("column{name}")).unwrap();
            assert!(told.is_same(&Unit::parse(unit).unwrap()), "{name}");
        }
        assert!(by_name("force").is_none());
        let bare = ["force_final_n", "Feed_MM_min", "force", "_n"].map(without_unit);
        assert_eq!(bare, ["force_final", "Feed", "force", "_n"]);
    }
    #[test]
    fn units_in_brackets_and_behind_words_are_read() {
        for (column, name, unit) in [
            ("Force [N]", "Force", "N"),
            ("n (1/min)", "n", "1/min"),
            ("n(U/min)", "n", "1/min"),
            ("v_f [mm/min]", "v_f", "mm/min"),
            ("Ra / µm", "Ra", "um"),
            ("Feed in mm/min", "Feed", "mm/min"),
            ("Kraft, kN", "Kraft", "kN"),
            ("Spindle speed [rpm]", "Spindle speed", "rpm"),
            ("f_z [mm/rev]", "f_z", "mm"),
            ("ratio [-]", "ratio", "1"),
        ] {
            let told = by_name(column).unwrap_or_else(|| panic!("{column}"));
            assert!(told.is_same(&Unit::parse(unit).unwrap()), "{column}: {told}");
            assert_eq!(without_unit(column), name);
        }
        for column in ["Force (mean)", "share in words", "x []", "[N]", "F (1)2", "a / b"] {
            assert!(by_name(column).is_none(), "{column}");
            assert_eq!(without_unit(column), column);
        }
    }
}
