//! Limits of machine and process, read from a file, each with a mark of where it comes from.

use serde::Serialize;

use crate::base::settings::SettingError;

/// The shipped file: the papers' machine, for which no public limits were found.
pub const HELLER_BEA_01: &str = include_str!("../../../../assets/machines/heller_bea_01.toml");

/// Where a value comes from, the least certain first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Source {
    /// No public data found: to be replaced by the owner of a real machine.
    Placeholder,
    /// A limit of the process that was chosen.
    Chosen,
    /// From a data sheet or from the user.
    Given,
}

impl Source {
    /// The mark in files and reports.
    #[must_use]
    pub fn id(self) -> &'static str {
        match self {
            Self::Placeholder => "placeholder",
            Self::Chosen => "chosen",
            Self::Given => "given",
        }
    }

    fn from_id(id: &str) -> Option<Self> {
        [Self::Placeholder, Self::Chosen, Self::Given].into_iter().find(|source| source.id() == id)
    }
}

/// A value with its source.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Sourced {
    /// The value, in the unit of the field's name.
    pub value: f64,
    /// Where it comes from.
    pub source: Source,
}

macro_rules! machine {
    ($( $(#[doc = $doc:literal])+ $field:ident: [$min:literal, $max:literal]; )+) => {
        /// Limits of a machine and of the process on it.
        #[derive(Clone, Debug, PartialEq, Serialize)]
        pub struct MachineLimits {
            /// Name of the machine.
            pub name: String,
            $( $(#[doc = $doc])+ pub $field: Sourced, )+
        }

        impl MachineLimits {
            /// Reads a machine file.
            ///
            /// # Errors
            /// Names the entry that is missing, unknown, not a number or outside its range.
            pub fn parse(text: &str) -> Result<Self, SettingError> {
                let mut table: toml::Table =
                    text.parse().map_err(|error: toml::de::Error| fault(error.to_string()))?;
                let machine = Self {
                    name: name(&mut table)?,
                    $( $field: entry(&mut table, stringify!($field), $min, $max)?, )+
                };
                if let Some(key) = table.keys().next() {
                    let known = ["name" $(, stringify!($field))+].join(", ");
                    return Err(fault(format!("unknown entry `{key}`; there are {known}")));
                }
                machine.check()?;
                Ok(machine)
            }
        }
    };
}

machine! {
    /// Least spindle speed, 1/min.
    speed_min_rpm: [1.0, 100000.0];
    /// Largest spindle speed, 1/min.
    speed_max_rpm: [1.0, 100000.0];
    /// Largest power of the spindle motor, kW.
    power_max_kw: [0.01, 1000.0];
    /// Efficiency between motor and cutter.
    spindle_efficiency: [0.05, 1.0];
    /// Least feed, mm/min.
    feed_min_mm_min: [0.1, 100000.0];
    /// Largest feed, mm/min.
    feed_max_mm_min: [0.1, 100000.0];
    /// Largest roughness Ra that feed and cutter may leave, um.
    ra_max_um: [0.01, 100.0];
    /// Largest deflection of the cutter's tip, mm.
    deflection_max_mm: [0.0001, 10.0];
    /// Least tool life, min.
    least_tool_life_min: [0.1, 100000.0];
}

fn fault(problem: String) -> SettingError {
    SettingError::Format { what: "machine file".to_owned(), problem }
}

fn name(table: &mut toml::Table) -> Result<String, SettingError> {
    match table.remove("name") {
        Some(toml::Value::String(name)) if name.chars().count() <= 80 => Ok(name),
        Some(_) => Err(fault("`name` must be text of at most 80 characters".to_owned())),
        None => Err(fault("`name` is missing".to_owned())),
    }
}

fn entry(table: &mut toml::Table, key: &str, min: f64, max: f64) -> Result<Sourced, SettingError> {
    let form = format!("`{key}` must be written {{ value = a number, source = \"given\" }}");
    let Some(found) = table.remove(key) else {
        return Err(fault(format!("`{key}` is missing: {form}")));
    };
    let toml::Value::Table(mut parts) = found else {
        return Err(fault(form));
    };
    let (value, source) = (parts.remove("value"), parts.remove("source"));
    if let Some(other) = parts.keys().next() {
        return Err(fault(format!("`{key}.{other}` is unknown; {form}")));
    }
    let value = match value {
        Some(toml::Value::Float(value)) => value,
        Some(toml::Value::Integer(value)) => value as f64,
        _ => return Err(fault(form)),
    };
    if !(value >= min && value <= max) {
        let problem = format!("`{key}` cannot be {value}: allowed is a number from {min} to {max}");
        return Err(fault(problem));
    }
    let source = source.as_ref().and_then(toml::Value::as_str).and_then(Source::from_id);
    let source = source.ok_or_else(|| {
        fault(format!("`{key}.source` must be one of placeholder, chosen, given"))
    })?;
    Ok(Sourced { value, source })
}

impl MachineLimits {
    /// The papers' machine with placeholders for its limits.
    #[must_use]
    pub fn heller_bea_01() -> Self {
        Self::parse(HELLER_BEA_01).expect("the shipped machine file is checked by a test")
    }

    fn check(&self) -> Result<(), SettingError> {
        for (low, high, keys) in [
            (self.speed_min_rpm, self.speed_max_rpm, ["speed_min_rpm", "speed_max_rpm"]),
            (self.feed_min_mm_min, self.feed_max_mm_min, ["feed_min_mm_min", "feed_max_mm_min"]),
        ] {
            if low.value >= high.value {
                let (least, largest) = (low.value, high.value);
                let [low, high] = keys;
                let problem =
                    format!("`{low}` cannot be {least}: allowed is below `{high}`, {largest}");
                return Err(fault(problem));
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_limit_of_the_shipped_machine_pretends_to_be_data() {
        let machine = MachineLimits::heller_bea_01();
        let json = serde_json::to_value(&machine).unwrap();
        let entries = json.as_object().unwrap();
        assert_eq!(entries.len(), 10);
        for (key, entry) in entries.iter().filter(|(key, _)| *key != "name") {
            let process = ["ra_max_um", "deflection_max_mm", "least_tool_life_min"];
            let mark = if process.contains(&key.as_str()) { "chosen" } else { "placeholder" };
            assert_eq!(entry["source"], mark, "{key}");
        }
    }

    #[test]
    fn faulty_files_are_refused_by_name() {
        let message = |from: &str, to: &str| {
            let text = HELLER_BEA_01.replacen(from, to, 1);
            assert_ne!(text, HELLER_BEA_01, "{from}");
            MachineLimits::parse(&text).unwrap_err().to_string()
        };
        let text = message("4500.0", "-1");
        assert!(text.contains("speed_max_rpm") && text.contains("-1") && text.contains("100000"));
        assert!(message("value = 10.0,", "value = nan,").contains("power_max_kw"));
        assert!(message("\"chosen\"", "\"guessed\"").contains("ra_max_um.source"));
        assert!(message("value = 0.05", "worth = 0.05").contains("deflection_max_mm"));
        assert!(message("2000.0", "5").contains("feed_min_mm_min"));
        assert!(message("ra_max_um", "ra_most_um").contains("`ra_max_um` is missing"));
        assert!(message("name =", "speed = 3\nname =").contains("`speed`"));
        assert!(MachineLimits::parse("name = ").is_err());
    }
}
