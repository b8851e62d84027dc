//! How a file is laid out: what a person says of it, and with that what was guessed of the rest. The same entries in
//! both, so that each guess that is shown can be overruled by its name, and be kept in a file beside the data.

mod entries;
mod file;
mod marks;

pub use entries::LAYOUT_KEYS;
pub use file::{LAYOUT_ENDING, LAYOUT_VERSION};
pub use marks::{DecimalMark, FieldSeparator, TextEncoding, ThousandsMark};

/// A file's layout. An entry without a value is guessed; in the layout of data that were read, it has no meaning for
/// their format.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DataLayout {
    /// Encoding of a text.
    pub encoding: Option<TextEncoding>,
    /// What stands between the values of a text.
    pub separator: Option<FieldSeparator>,
    /// The decimal sign of a text.
    pub decimal: Option<DecimalMark>,
    /// What stands between the thousands of a text's numbers.
    pub thousands: Option<ThousandsMark>,
    /// The line of a text with the names of the columns, from 1; 0 for none.
    pub names_line: Option<u64>,
    /// The line of a text with the units of the columns, from 1; 0 for none.
    pub units_line: Option<u64>,
    /// The first line of a text with values, from 1.
    pub first_line: Option<u64>,
    /// What of the file is read, by its name in the list of its contents.
    pub variable: Option<String>,
    /// Names of the columns in the place of the file's.
    pub names: Option<Vec<String>>,
    /// Units of the columns in the place of the file's; an empty one for none.
    pub units: Option<Vec<String>>,
    /// The column with the times, by its name or number from 1; `none` for none.
    pub time: Option<String>,
    /// Samples in a second, where no column has the times.
    pub rate_hz: Option<f64>,
}

impl DataLayout {
    /// What `over` says, and what this says of the rest.
    #[must_use]
    pub fn overruled_by(&self, over: &Self) -> Self {
        let (under, over) = (self.clone(), over.clone());
        Self {
            encoding: over.encoding.or(under.encoding),
            separator: over.separator.or(under.separator),
            decimal: over.decimal.or(under.decimal),
            thousands: over.thousands.or(under.thousands),
            names_line: over.names_line.or(under.names_line),
            units_line: over.units_line.or(under.units_line),
            first_line: over.first_line.or(under.first_line),
            variable: over.variable.or(under.variable),
            names: over.names.or(under.names),
            units: over.units.or(under.units),
            time: over.time.or(under.time),
            rate_hz: over.rate_hz.or(under.rate_hz),
        }
    }
}

#[cfg(test)]
mod tests;
