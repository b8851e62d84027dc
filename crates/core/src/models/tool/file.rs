//! Tool files: versioned TOML, one cutter each. Every entry is wanted but the corner radius, which only a
//! bull nose has, and what the cutter stands; unknown ones are refused.
//!
//! ```toml
//! version = 1
//! title = "Square end mill 12 mm, 4 flutes"
//! source = "where its dimensions come from"
//! shape = "square"                  # ball, bull_nose or square
//! diameter_mm = 12.0
//! teeth = 4
//! helix_deg = 30.0
//! rake_deg = 10.0
//! overhang_mm = 36.0                # free length from the holder
//! elastic_modulus_n_mm2 = 5.8e5
//! compliance_um_n = 0.02            # of tool and holder, in the regeneration
//! runout_um = 3.0                   # the axis is shifted by so much towards tooth 0
//! chip_max_mm = 0.6                 # may be left out: the thickest chip that a tooth stands
//! force_max_n = 4000.0              # may be left out: the largest force that it stands
//! ```

use super::{EndShape, Tool};
use crate::base::files::line_of_entry;
use crate::base::language::tr;
use crate::base::settings::{Group, SettingError, Value};

/// Version of the format.
pub const FORMAT_VERSION: i64 = 1;
/// Most characters of title and source.
const MAX_CHARS: usize = 400;

/// A cutter as its file describes it.
#[derive(Clone, Debug, PartialEq)]
pub struct ToolFile {
    /// What it is called.
    pub title: String,
    /// Where its values come from.
    pub source: String,
    /// The cutter; its `name` stays at the default.
    pub tool: Tool,
}

fn fault(problem: String) -> SettingError {
    SettingError::Format { what: tr("tool file").to_owned(), problem }
}

fn text(table: &mut toml::Table, key: &str) -> Result<String, SettingError> {
    match table.remove(key) {
        Some(toml::Value::String(text)) if (1..=MAX_CHARS).contains(&text.chars().count()) => {
            Ok(text)
        }
        Some(_) => {
            Err(fault(tr!("`{key}` must be text of 1 to {n} characters", key = key, n = MAX_CHARS)))
        }
        None => Err(fault(tr!("`{key}` is missing", key = key))),
    }
}

/// The value of an entry in transit; written out for messages where it can be none.
fn value(found: &toml::Value) -> Option<Value> {
    match found {
        toml::Value::Integer(x) => Some(Value::Int(*x)),
        toml::Value::Float(x) => Some(Value::Float(*x)),
        toml::Value::String(x) => Some(Value::Text(x.clone())),
        toml::Value::Boolean(_)
        | toml::Value::Array(_)
        | toml::Value::Datetime(_)
        | toml::Value::Table(_) => None,
    }
}

fn refused(text: &str, key: &str, found: &toml::Value, allowed: &str) -> SettingError {
    let found: String = found.to_string().chars().take(60).collect();
    fault(tr!(
        "line {line}: `{entry}` cannot be {value}: allowed is {allowed}",
        line = line_of_entry(text, key, 0).unwrap_or(1),
        entry = key,
        value = found,
        allowed = allowed
    ))
}

impl ToolFile {
    /// Reads a tool file.
    ///
    /// # Errors
    /// Names the entry that is missing, unknown, of the wrong type or outside its range, with its line and
    /// what is allowed.
    pub fn parse(toml: &str) -> Result<Self, SettingError> {
        let mut table: toml::Table =
            toml.parse().map_err(|error: toml::de::Error| fault(error.to_string()))?;
        match table.remove("version") {
            Some(toml::Value::Integer(FORMAT_VERSION)) => {}
            Some(other) => {
                return Err(refused(toml, "version", &other, &FORMAT_VERSION.to_string()));
            }
            None => {
                return Err(fault(tr!(
                    "`version = {version}` is missing",
                    version = FORMAT_VERSION
                )));
            }
        }
        let (title, source) = (text(&mut table, "title")?, text(&mut table, "source")?);
        let mut tool = Tool::default();
        let specs: Vec<_> = Tool::specs().into_iter().filter(|spec| spec.key != "name").collect();
        for spec in &specs {
            let allowed = || spec.allowed.allowed(spec.unit);
            let Some(found) = table.remove(spec.key) else {
                let no_corner = spec.key == "corner_radius_mm" && tool.shape != EndShape::BullNose;
                // What it stands may be unknown: then it stands anything.
                if no_corner || ["chip_max_mm", "force_max_n"].contains(&spec.key) {
                    continue;
                }
                return Err(fault(tr!(
                    "`{key}` is missing: {allowed}",
                    key = spec.key,
                    allowed = allowed()
                )));
            };
            value(&found)
                .and_then(|value| tool.set(spec.key, &value, &spec.allowed))
                .ok_or_else(|| refused(toml, spec.key, &found, &allowed()))?;
        }
        if let Some(key) = table.keys().next() {
            let known: Vec<&str> = specs.iter().map(|spec| spec.key).collect();
            let known = known.join(", ");
            let problem = tr!(
                "unknown entry `{key}`; there are version, title, source, {known}",
                key = key,
                known = known
            );
            return Err(fault(problem));
        }
        if let Some(most) = tool.corner_too_large_mm() {
            let problem = tr!(
                "line {line}: `corner_radius_mm` cannot be {radius} mm: allowed is at most half of `diameter_mm`, \
                 {most} mm",
                line = line_of_entry(toml, "corner_radius_mm", 0).unwrap_or(1),
                radius = tool.corner_radius_mm,
                most = most
            );
            return Err(fault(problem));
        }
        Ok(Self { title, source, tool })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::tool::ShippedTool;

    #[test]
    fn faulty_files_are_refused_by_entry_value_and_range() {
        let good = ShippedTool::BullNose16.text();
        let message = |from: &str, to: &str| {
            let text = good.replacen(from, to, 1);
            assert_ne!(text, good, "{from}");
            ToolFile::parse(&text).unwrap_err().to_string()
        };
        for (from, to, wanted) in [
            (
                "diameter_mm = 16.0",
                "diameter_mm = 1.5",
                ["line 8: `diameter_mm`", "1.5", "2 to 50 mm"],
            ),
            ("diameter_mm = 16.0", "diameter_mm = nan", ["`diameter_mm`", "nan", "2 to 50 mm"]),
            ("teeth = 4", "teeth = 2.5", ["`teeth`", "2.5", "1 to 8"]),
            ("teeth = 4", "teeth = true", ["`teeth`", "true", "1 to 8"]),
            ("teeth = 4", "tooth = 4", ["`teeth`", "missing", "1 to 8"]),
            ("\"bull_nose\"", "\"cone\"", ["`shape`", "cone", "ball, bull_nose, square"]),
            ("runout_um", "name = \"a\"\nrunout_um", ["`name`", "unknown", "helix_deg"]),
            ("corner_radius_mm = 2.0", "", ["`corner_radius_mm`", "missing", "0 to 25 mm"]),
            ("corner_radius_mm = 2.0", "corner_radius_mm = 9", ["`corner_radius_mm`", "9", "8 mm"]),
            ("runout_um = 3.0", "runout_um = -1", ["`runout_um`", "-1", "0 to 50 um"]),
            ("version = 1", "version = 2", ["`version`", "2", "1"]),
            ("version = 1", "", ["`version = 1`", "missing", "tool file"]),
            ("title =", "titel =", ["`title`", "missing", "tool file"]),
        ] {
            let text = message(from, to);
            assert!(wanted.iter().all(|part| text.contains(part)), "{to}: {text}");
        }
        assert!(ToolFile::parse("version = ").is_err());
    }
}
