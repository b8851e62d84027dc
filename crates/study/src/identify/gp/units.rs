//! Units of the columns, and formulas that are right in them.

use super::node::Sum;
use super::written::{Columns, formula};
use crate::base::formula::{Formula, NumberUnits, Unit};

/// Endings of column names that tell a unit, the longer ones first.
const ENDINGS: [(&str, &str); 20] = [
    ("_mm3_min", "mm^3/min"),
    ("_cm3_min", "cm^3/min"),
    ("_n_mm2", "N/mm^2"),
    ("_mm_min", "mm/min"),
    ("_mm_rev", "mm"),
    ("_m_min", "m/min"),
    ("_mm_s", "mm/s"),
    ("_m_s", "m/s"),
    ("_rpm", "1/min"),
    ("_mpa", "MPa"),
    ("_min", "min"),
    ("_kn", "kN"),
    ("_nm", "N m"),
    ("_kw", "kW"),
    ("_hz", "Hz"),
    ("_um", "um"),
    ("_mm", "mm"),
    ("_n", "N"),
    ("_w", "W"),
    ("_s", "s"),
];

/// The unit that a column's name ends with.
#[must_use]
pub fn by_name(column: &str) -> Option<Unit> {
    let column = column.to_lowercase();
    let ending = ENDINGS.iter().find(|(ending, _)| column.ends_with(ending));
    ending.and_then(|(_, unit)| Unit::parse(unit).ok())
}

/// A column's name without the ending that tells its unit.
#[must_use]
pub fn without_unit(column: &str) -> &str {
    let lower = column.to_lowercase();
    let ending = ENDINGS.iter().find(|(ending, _)| lower.ends_with(ending));
    // Where small letters are as long as large ones.
    let length = ending.map_or(0, |(ending, _)| ending.len());
    let bare = column.len().checked_sub(length).and_then(|end| column.get(..end));
    bare.filter(|bare| !bare.is_empty()).unwrap_or(column)
}

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
}
