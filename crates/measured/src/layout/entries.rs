//! The entries of a layout by their names: set from a text, told as one.

use super::{DataLayout, DecimalMark, FieldSeparator, TextEncoding, ThousandsMark};
use crate::base::language::tr;
use crate::base::settings::Choice;
use crate::base::text::nearest;

/// The entries of a layout with what each says.
pub const LAYOUT_KEYS: [(&str, &str); 12] = [
    ("encoding", "encoding of a text: utf-8, utf-16le, utf-16be or latin-1"),
    ("separator", "what stands between values: tab, semicolon, comma or blank"),
    ("decimal", "decimal sign: point or comma"),
    ("thousands", "what stands between thousands: none, point, comma, blank or apostrophe"),
    ("names_line", "line with the names of the columns, from 1; 0 for none"),
    ("units_line", "line with their units, from 1; 0 for none"),
    ("first_line", "first line with values, from 1"),
    ("variable", "what of the file is read, by its name in the list of its contents"),
    ("names", "names of the columns in the place of the file's"),
    ("units", "their units in the place of the file's; an empty one for none"),
    ("time", "column with the times, by name or number from 1; none for none"),
    ("rate_hz", "samples in a second, where no column has the times; above 0 to 1e9"),
];

/// Largest line number and longest list that a layout may have.
const MAX_LINE: u64 = 1_000_000_000;
const MAX_NAMES: usize = 10_000;
/// Largest sample rate, 1/s.
const MAX_RATE_HZ: f64 = 1e9;

fn refused(key: &str, value: &str, allowed: &str) -> String {
    let shown: String = value.chars().take(60).collect();
    tr!(
        "`{path}` cannot be {value}: allowed is {allowed}",
        path = key,
        value = shown,
        allowed = allowed
    )
}

fn chosen<T>(
    key: &str,
    value: &str,
    options: &[Choice],
    from_id: impl Fn(&str) -> Option<T>,
) -> Result<Option<T>, String> {
    let ids = || options.iter().map(|option| option.id).collect::<Vec<_>>().join(", ");
    from_id(value).map(Some).ok_or_else(|| refused(key, value, &ids()))
}

fn line(key: &str, value: &str, least: u64) -> Result<Option<u64>, String> {
    let number = value.parse().ok().filter(|line| (least..=MAX_LINE).contains(line));
    let allowed = || format!("{least}..{MAX_LINE}");
    number.map(Some).ok_or_else(|| refused(key, value, &allowed()))
}

impl DataLayout {
    /// Sets an entry from a text; names and units stand with commas between them.
    ///
    /// # Errors
    /// Names the entry, its value and what is allowed; or that there is no such entry, and which there are.
    pub fn set(&mut self, key: &str, value: &str) -> Result<(), String> {
        match key {
            "encoding" => {
                let found = chosen(key, value, TextEncoding::OPTIONS, TextEncoding::from_id);
                self.encoding = found?;
            }
            "separator" => {
                let found = chosen(key, value, FieldSeparator::OPTIONS, FieldSeparator::from_id);
                self.separator = found?;
            }
            "decimal" => {
                self.decimal = chosen(key, value, DecimalMark::OPTIONS, DecimalMark::from_id)?;
            }
            "thousands" => {
                let found = chosen(key, value, ThousandsMark::OPTIONS, ThousandsMark::from_id);
                self.thousands = found?;
            }
            "names_line" => self.names_line = line(key, value, 0)?,
            "units_line" => self.units_line = line(key, value, 0)?,
            "first_line" => self.first_line = line(key, value, 1)?,
            "variable" => self.variable = Some(value.to_owned()),
            "names" | "units" => {
                let list: Vec<String> = value.split(',').map(|x| x.trim().to_owned()).collect();
                self.set_list(key, list)?;
            }
            "time" if value.is_empty() => {
                return Err(refused(key, "``", tr("the name or number of a column, or none")));
            }
            "time" => self.time = Some(value.to_owned()),
            "rate_hz" => {
                let rate = value.parse().ok().filter(|x| *x > 0.0 && *x <= MAX_RATE_HZ);
                let allowed = || tr!("a number above 0, at most {most}", most = MAX_RATE_HZ);
                self.rate_hz = Some(rate.ok_or_else(|| refused(key, value, &allowed()))?);
            }
            unknown => return Err(unknown_key(unknown)),
        }
        Ok(())
    }

    /// Sets an entry that is a list.
    ///
    /// # Errors
    /// As [`Self::set`].
    pub(super) fn set_list(&mut self, key: &str, list: Vec<String>) -> Result<(), String> {
        let wrong = list.len() > MAX_NAMES || key == "names" && list.iter().any(String::is_empty);
        if wrong {
            return Err(refused(key, &list.join(","), tr("a list of names, none of them empty")));
        }
        match key {
            "names" => self.names = Some(list),
            "units" => self.units = Some(list),
            other if LAYOUT_KEYS.iter().any(|(known, _)| *known == other) => {
                return Err(refused(other, &list.join(","), tr("one value, not a list")));
            }
            unknown => return Err(unknown_key(unknown)),
        }
        Ok(())
    }

    /// The entries that have a value, in the order of [`LAYOUT_KEYS`], as [`Self::set`] takes them.
    #[must_use]
    pub fn entries(&self) -> Vec<(&'static str, String)> {
        let line = |line: &Option<u64>| line.map(|line| line.to_string());
        let list = |list: &Option<Vec<String>>| list.as_ref().map(|list| list.join(","));
        let values = [
            self.encoding.map(|x| x.id().to_owned()),
            self.separator.map(|x| x.id().to_owned()),
            self.decimal.map(|x| x.id().to_owned()),
            self.thousands.map(|x| x.id().to_owned()),
            line(&self.names_line),
            line(&self.units_line),
            line(&self.first_line),
            self.variable.clone(),
            list(&self.names),
            list(&self.units),
            self.time.clone(),
            self.rate_hz.map(|x| x.to_string()),
        ];
        let named = LAYOUT_KEYS.iter().zip(values);
        named.filter_map(|((key, _), value)| Some((*key, value?))).collect()
    }
}

fn unknown_key(key: &str) -> String {
    let names = || LAYOUT_KEYS.iter().map(|(key, _)| *key);
    let list = names().collect::<Vec<_>>().join(", ");
    match nearest(key, names(), 0.8) {
        Some(near) => tr!(
            "a layout has no entry `{key}`; did you mean `{near}`? There are {list}",
            key = key,
            near = near,
            list = list
        ),
        None => tr!("a layout has no entry `{key}`; there are {list}", key = key, list = list),
    }
}
