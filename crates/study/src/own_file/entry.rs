//! Entries of files of one's own: where they stand, and how they are refused.

use crate::base::language::tr;
use crate::base::settings::SettingError;

/// The line, counted from 1, of the entry `key` in a section of a TOML text; the section "" is what stands before the
/// first one.
fn line_in(text: &str, section: &str, key: &str) -> Option<usize> {
    let mut within = "";
    for (number, line) in (1..).zip(text.lines()) {
        let line = line.trim();
        if let Some(name) = line.strip_prefix('[').and_then(|rest| rest.split(']').next()) {
            within = name.trim();
        } else if within == section
            && line.strip_prefix(key).is_some_and(|rest| rest.trim_start().starts_with('='))
        {
            return Some(number);
        }
    }
    None
}

/// An entry of a file that is being read.
pub(super) struct FileEntry<'a> {
    /// What is read, in words.
    pub what: &'static str,
    /// The file's text.
    pub text: &'a str,
    /// The section that it stands in; "" for none.
    pub section: &'static str,
    /// Its name.
    pub key: &'static str,
}

impl FileEntry<'_> {
    /// That its value is refused, with what is wrong or allowed in words.
    pub fn fault(&self, problem: &str) -> SettingError {
        let line = line_in(self.text, self.section, self.key);
        let problem = match line {
            Some(line) => tr!("line {line}: {problem}", line = line, problem = problem),
            None => problem.to_owned(),
        };
        SettingError::Format { what: tr(self.what).to_owned(), problem }
    }

    /// That a value is refused, with what is allowed.
    pub fn refused(&self, value: &str, allowed: &str) -> SettingError {
        self.fault(&tr!(
            "`{path}` cannot be {value}: allowed is {allowed}",
            path = self.key,
            value = value,
            allowed = allowed
        ))
    }

    /// The number, within its range.
    pub fn number(&self, value: f64, [low, high]: [f64; 2]) -> Result<f64, SettingError> {
        // What is not a number is in no range.
        if (low..=high).contains(&value) {
            return Ok(value);
        }
        let allowed = tr!("a number from {low} to {high}", low = low, high = high);
        Err(self.refused(&value.to_string(), &allowed))
    }

    /// The text, not empty and not longer than a screen has room for.
    pub fn words(&self, value: String) -> Result<String, SettingError> {
        const MOST: usize = 400;
        let count = value.chars().count();
        if (1..=MOST).contains(&count) {
            return Ok(value);
        }
        let found = tr!("text of {n} characters", n = count);
        Err(self.refused(&found, &tr!("text of 1 to {n} characters", n = MOST)))
    }

    /// The version of the format.
    pub fn version(&self, value: i64) -> Result<(), SettingError> {
        let known = super::OWN_FILE_VERSION;
        if value == known {
            return Ok(());
        }
        Err(self.refused(&value.to_string(), &known.to_string()))
    }
}
