//! The file of a layout, which stands beside the data: versioned TOML. Every entry may be left out and is guessed then;
//! an unknown one is refused.
//!
//! ```toml
//! version = 1
//! separator = "semicolon"
//! decimal = "comma"
//! names = ["Time", "Fx", "Fy", "Fz"]
//! units = ["s", "N", "N", "N"]
//! ```

use std::fmt::Write;

use super::{DataLayout, LAYOUT_KEYS};
use crate::base::language::tr;

/// Version of the format.
pub const LAYOUT_VERSION: i64 = 1;

/// What the name of a layout's file has behind the name of the data's: `cut.csv.layout.toml`.
pub const LAYOUT_ENDING: &str = ".layout.toml";

impl DataLayout {
    /// Reads the text of a layout's file.
    ///
    /// # Errors
    /// It is no TOML, with the line; it has another version; an entry is unknown, or has a value that is not allowed.
    pub fn read(text: &str) -> Result<Self, String> {
        let table: toml::Table = crate::base::files::from_toml(text)?;
        match table.get("version").map(toml::Value::as_integer) {
            Some(Some(LAYOUT_VERSION)) => {}
            Some(_) => {
                return Err(tr!("`version` must be {version}", version = LAYOUT_VERSION));
            }
            None => return Err(tr!("`{key}` is missing", key = "version")),
        }
        let mut layout = Self::default();
        for (key, value) in table.iter().filter(|(key, _)| *key != "version") {
            match value {
                toml::Value::Array(list) => {
                    let texts: Option<Vec<String>> =
                        list.iter().map(|x| x.as_str().map(str::to_owned)).collect();
                    let texts = texts.ok_or_else(|| {
                        tr!(
                            "`{path}` cannot be {value}: allowed is {allowed}",
                            path = key,
                            value = value.to_string().chars().take(60).collect::<String>(),
                            allowed = tr("a list of texts")
                        )
                    })?;
                    layout.set_list(key, texts)?;
                }
                toml::Value::String(text) => layout.set(key, text)?,
                toml::Value::Integer(_)
                | toml::Value::Float(_)
                | toml::Value::Boolean(_)
                | toml::Value::Datetime(_)
                | toml::Value::Table(_) => layout.set(key, &value.to_string())?,
            }
        }
        Ok(layout)
    }

    /// The text of the layout's file, every entry with what it says.
    #[must_use]
    pub fn write(&self) -> String {
        let mut text = format!(
            "# How a file of measured data is laid out, as far as it is not guessed.\n\
             version = {LAYOUT_VERSION}\n"
        );
        for (key, value) in self.entries() {
            let about = LAYOUT_KEYS.iter().find(|(known, _)| *known == key).map_or("", |x| x.1);
            let list = match key {
                "names" => self.names.as_ref(),
                "units" => self.units.as_ref(),
                _ => None,
            };
            let quoted = |text: &String| toml::Value::String(text.clone()).to_string();
            let value = match (key, list) {
                (_, Some(list)) => {
                    format!("[{}]", list.iter().map(quoted).collect::<Vec<_>>().join(", "))
                }
                ("names_line" | "units_line" | "first_line" | "rate_hz", None) => value,
                (_, None) => quoted(&value),
            };
            // Into memory: it does not fail.
            let _ = writeln!(text, "# {about}\n{key} = {value}");
        }
        text
    }
}
