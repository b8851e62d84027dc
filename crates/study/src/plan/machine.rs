//! Limits of machine and process, read from a file, each with a mark of where it comes from.

use serde::{Deserialize, Serialize};

use crate::base::files::from_toml;
use crate::base::language::text;
use crate::base::settings::SettingError;
use crate::blocks::cnc::feed_override::Cnc;

/// The shipped file: the papers' machine, for which no public limits were found.
pub const HELLER_BEA_01: &str = include_str!("../../../../assets/machines/heller_bea_01.toml");

/// Longest name, characters.
const MAX_NAME: usize = 80;

/// Where a value comes from, the least certain first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Deserialize, Serialize)]
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
            Self::Placeholder => text!("placeholder"),
            Self::Chosen => text!("chosen"),
            Self::Given => text!("given"),
        }
    }
}

/// A value with its source.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields, expecting = "{ value = a number, source = \"given\" }")]
pub struct Sourced {
    /// The value, in the unit of the field's name.
    pub value: f64,
    /// Where it comes from.
    pub source: Source,
}

macro_rules! machine {
    ($( $(#[doc = $doc:literal])+ $field:ident: [$min:literal, $max:literal]; )+) => {
        /// Limits of a machine and of the process on it.
        #[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
        #[serde(deny_unknown_fields)]
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
                let machine: Self = from_toml(text).map_err(fault)?;
                if machine.name.chars().count() > MAX_NAME {
                    return Err(fault(format!("`name` must be text of at most {MAX_NAME} characters")));
                }
                $( within(stringify!($field), machine.$field.value, $min, $max)?; )+
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

fn within(key: &str, value: f64, min: f64, max: f64) -> Result<(), SettingError> {
    if value >= min && value <= max {
        return Ok(());
    }
    Err(fault(format!("`{key}.value` cannot be {value}: allowed is a number from {min} to {max}")))
}

impl MachineLimits {
    /// The papers' machine with placeholders for its limits.
    #[must_use]
    pub fn heller_bea_01() -> Self {
        Self::parse(HELLER_BEA_01).expect("the shipped machine file is checked by a test")
    }

    /// The same as far as the machine of a scenario goes. What the scenario limits stands in the place of a placeholder;
    /// of two limits that are known the narrower one counts.
    #[must_use]
    pub fn within(&self, cnc: &Cnc) -> Self {
        let none = Cnc::default();
        let own = |now: &mut Sourced, value: f64, none: f64, narrower: fn(f64, f64) -> f64| {
            if value == none {
                return;
            }
            let narrowed = narrower(now.value, value);
            if now.source == Source::Placeholder || narrowed != now.value {
                *now = Sourced { value, source: Source::Given };
            }
        };
        let mut machine = self.clone();
        own(&mut machine.feed_max_mm_min, cnc.feed_max_mm_min, none.feed_max_mm_min, f64::min);
        own(&mut machine.speed_min_rpm, cnc.speed_min_rpm, none.speed_min_rpm, f64::max);
        own(&mut machine.speed_max_rpm, cnc.speed_max_rpm, none.speed_max_rpm, f64::min);
        machine
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
        assert!(message("ra_max_um", "ra_most_um").contains("unknown field `ra_most_um`"));
        assert!(
            message("power_max_kw = { value = 10.0, source = \"placeholder\" }\n", "")
                .contains("`power_max_kw`")
        );
        assert!(message("name =", "speed = 3\nname =").contains("`speed`"));
        assert!(MachineLimits::parse("name = ").is_err());
    }
}
