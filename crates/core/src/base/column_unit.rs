//! Units of columns as the headers of tables have them: behind the name, in brackets, or as its ending.

use super::formula::Unit;

/// Endings of column names that tell a unit, the longer ones first.
pub const ENDINGS: [(&str, &str); 22] = [
    ("_mm3_min", "mm^3/min"),
    ("_cm3_min", "cm^3/min"),
    ("_n_mm2", "N/mm^2"),
    ("_mm_min", "mm/min"),
    ("_mm_rev", "mm"),
    ("_m_min", "m/min"),
    ("_um_n", "um/N"),
    ("_m_n", "m/N"),
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

/// How units stand behind the names of columns in lab books and exports, beside those that [`Unit`] reads.
const SPELLINGS: [(&str, &str); 6] = [
    ("U/min", "1/min"),
    ("rev/min", "1/min"),
    ("mm/U", "mm"),
    ("mm/rev", "mm"),
    ("-", "1"),
    ("--", "1"),
];

/// A name and the text of the unit that stands behind it: `Force [N]`, `n (1/min)`, `Ra / um`, `Feed in mm/min`.
#[must_use]
pub fn parted(column: &str) -> Option<(&str, &str)> {
    let column = column.trim();
    let in_brackets = [('[', ']'), ('(', ')'), ('{', '}'), ('<', '>')].into_iter();
    let in_brackets = in_brackets.filter_map(|(open, close)| {
        let (name, unit) = column.strip_suffix(close)?.rsplit_once(open)?;
        Some((name, unit))
    });
    let behind_words = [" / ", " in ", ", "].into_iter();
    let behind_words = behind_words.filter_map(|word| column.rsplit_once(word));
    let parts = in_brackets.chain(behind_words).map(|(name, unit)| (name.trim_end(), unit.trim()));
    parts.into_iter().find(|(name, unit)| !name.is_empty() && spelled(unit).is_some())
}

/// A unit as it stands in a header.
#[must_use]
pub fn spelled(text: &str) -> Option<Unit> {
    let known = SPELLINGS.iter().find(|(spelling, _)| *spelling == text);
    let text = known.map_or(text, |(_, unit)| unit);
    // Without a text it would be the unit of a plain number, which nobody has told.
    Unit::parse(text).ok().filter(|_| !text.is_empty())
}

/// The unit that a column's name ends with, or that stands behind it.
#[must_use]
pub fn by_name(column: &str) -> Option<Unit> {
    let behind = parted(column).and_then(|(_, unit)| spelled(unit));
    let by_ending = || {
        let column = column.to_lowercase();
        let ending = ENDINGS.iter().find(|(ending, _)| column.ends_with(ending));
        ending.and_then(|(_, unit)| Unit::parse(unit).ok())
    };
    behind.or_else(by_ending)
}

/// A column's name without the ending that tells its unit.
#[must_use]
pub fn without_unit(column: &str) -> &str {
    if let Some((name, _)) = parted(column) {
        return name;
    }
    let lower = column.to_lowercase();
    let ending = ENDINGS.iter().find(|(ending, _)| lower.ends_with(ending));
    // Where small letters are as long as large ones.
    let length = ending.map_or(0, |(ending, _)| ending.len());
    let bare = column.len().checked_sub(length).and_then(|end| column.get(..end));
    bare.filter(|bare| !bare.is_empty()).unwrap_or(column)
}
