//! Structure files: versioned TOML, the modes at one tool's tip. Unknown entries are refused.
//!
//! ```toml
//! version = 1
//! title = "Spindle 2, holder HSK 63, cutter 12 mm"
//! source = "impact test of the 3rd of May"
//!
//! [[mode]]
//! direction = "x"                   # x along the feed, y across it
//! frequency_hz = 922.0              # natural frequency
//! damping_ratio = 0.011             # share of the critical damping
//! mass_kg = 0.03993                 # modal mass, or stiffness_n_m in its place
//! ```

use std::fmt::Write;

use serde::Deserialize;

use super::{TipAxis, TipMode, TipModes};
use crate::base::files::{from_toml, line_of_entry};
use crate::base::language::tr;
use crate::base::math::TAU;
use crate::base::settings::SettingError;

/// Version of the format.
pub const TIP_FILE_VERSION: i64 = 1;
/// Most characters of title and source.
const MAX_CHARS: usize = 400;

/// A structure as its file describes it.
#[derive(Clone, Debug, PartialEq)]
pub struct TipModesFile {
    /// What it is called.
    pub title: String,
    /// Where its values come from.
    pub source: String,
    /// The modes, at least one.
    pub modes: TipModes,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Whole {
    version: i64,
    title: String,
    source: String,
    mode: Vec<Entry>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Entry {
    direction: String,
    frequency_hz: f64,
    damping_ratio: f64,
    mass_kg: Option<f64>,
    stiffness_n_m: Option<f64>,
}

fn fault(problem: String) -> SettingError {
    SettingError::Format { what: tr("structure file").to_owned(), problem }
}

/// That an entry is refused, in its line: the `nth` of its name, counted from 0.
fn refused(text: &str, key: &str, nth: usize, value: &str, allowed: &str) -> SettingError {
    let line = line_of_entry(text, key, nth).unwrap_or(1);
    fault(tr!(
        "line {line}: `{entry}` cannot be {value}: allowed is {allowed}",
        line = line,
        entry = key,
        value = value,
        allowed = allowed
    ))
}

/// Whether a mode has an entry of this name.
fn has(entry: &Entry, key: &str) -> bool {
    match key {
        "mass_kg" => entry.mass_kg.is_some(),
        "stiffness_n_m" => entry.stiffness_n_m.is_some(),
        _ => true,
    }
}

/// The mode at `nth`, counted from 0, of all `entries`.
fn mode(text: &str, entries: &[Entry], nth: usize) -> Result<TipMode, SettingError> {
    let entry = &entries[nth];
    // Of those that have the entry.
    let refused = |key: &str, value: &str, allowed: &str| {
        let before = entries[..nth].iter().filter(|entry| has(entry, key)).count();
        refused(text, key, before, value, allowed)
    };
    let Some(axis) = TipAxis::from_id(&entry.direction) else {
        let found: String = entry.direction.chars().take(40).collect();
        return Err(refused("direction", &found, tr("x or y")));
    };
    let omega = TAU * entry.frequency_hz;
    let mass_kg = match (entry.mass_kg, entry.stiffness_n_m) {
        (Some(mass_kg), None) => mass_kg,
        (None, Some(stiffness_n_m)) => stiffness_n_m / (omega * omega),
        (Some(_), Some(_)) | (None, None) => {
            return Err(fault(tr!(
                "mode {place}: one of `mass_kg` and `stiffness_n_m` is wanted, not both and not neither",
                place = nth + 1
            )));
        }
    };
    let (frequency_hz, damping_ratio) = (entry.frequency_hz, entry.damping_ratio);
    let mode = TipMode { axis, frequency_hz, damping_ratio, mass_kg };
    match (mode.out_of_range(), entry.stiffness_n_m) {
        (None, _) => Ok(mode),
        (Some(("mass_kg", _, [low, high])), Some(stiffness_n_m)) => {
            let allowed = tr!(
                "what makes a modal mass from {low} to {high} kg at this frequency",
                low = low,
                high = high
            );
            Err(refused("stiffness_n_m", &stiffness_n_m.to_string(), &allowed))
        }
        (Some((key, value, [low, high])), _) => {
            let allowed = tr!("a number from {low} to {high}", low = low, high = high);
            Err(refused(key, &value.to_string(), &allowed))
        }
    }
}

impl TipModesFile {
    /// Reads a structure file.
    ///
    /// # Errors
    /// Names line and entry of what is missing, unknown, of the wrong type or outside its range, with the value and
    /// what is allowed.
    pub fn parse(text: &str) -> Result<Self, SettingError> {
        let whole: Whole = from_toml(text).map_err(fault)?;
        if whole.version != TIP_FILE_VERSION {
            let allowed = TIP_FILE_VERSION.to_string();
            return Err(refused(text, "version", 0, &whole.version.to_string(), &allowed));
        }
        for (key, words) in [("title", &whole.title), ("source", &whole.source)] {
            let chars = words.chars().count();
            if !(1..=MAX_CHARS).contains(&chars) {
                let value = tr!("text of {n} characters", n = chars);
                let allowed = tr!("text of 1 to {n} characters", n = MAX_CHARS);
                return Err(refused(text, key, 0, &value, &allowed));
            }
        }
        if whole.mode.is_empty() {
            return Err(fault(
                tr("there is no mode: at least one `[[mode]]` is wanted").to_owned(),
            ));
        }
        let modes = (0..whole.mode.len()).map(|nth| mode(text, &whole.mode, nth));
        let modes = TipModes::new(modes.collect::<Result<_, _>>()?).map_err(fault)?;
        Ok(Self { title: whole.title, source: whole.source, modes })
    }

    /// The text of the file: what [`Self::parse`] reads back, to the bit.
    #[must_use]
    pub fn write(&self) -> String {
        let quoted = |text: &str| toml::Value::String(text.to_owned()).to_string();
        let mut text = format!(
            "# The structure at the tool's tip: modes with natural frequency in Hz, damping ratio and modal mass in kg.\n\
             # x is the direction of feed, y the one across it.\n\
             version = {TIP_FILE_VERSION}\ntitle = {}\nsource = {}\n",
            quoted(&self.title),
            quoted(&self.source)
        );
        for mode in self.modes.all() {
            let TipMode { axis, frequency_hz, damping_ratio, mass_kg } = mode;
            // Into memory: it does not fail.
            let _ = write!(
                text,
                "\n[[mode]]\ndirection = \"{}\"\nfrequency_hz = {frequency_hz:?}\n\
                 damping_ratio = {damping_ratio:?}\nmass_kg = {mass_kg:?}\n",
                axis.id()
            );
        }
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const EXAMPLE: &str = include_str!("../../../../../assets/structures/slender-cutter.toml");

    #[test]
    fn a_file_comes_back_as_it_was_written() {
        let file = TipModesFile::parse(EXAMPLE).unwrap();
        assert_eq!(file.modes.all().len(), 2);
        assert_eq!(TipModesFile::parse(&file.write()), Ok(file));
    }

    #[test]
    fn stiffness_stands_for_mass() {
        let text = EXAMPLE.replacen("mass_kg = 0.03993", "stiffness_n_m = 1340040.6", 1);
        assert_ne!(text, EXAMPLE);
        let mass_kg = TipModesFile::parse(&text).unwrap().modes.all()[0].mass_kg;
        assert!((mass_kg / 0.03993 - 1.0).abs() < 1e-5, "{mass_kg}");
    }

    #[test]
    fn faults_name_line_entry_value_and_range() {
        let message = |from: &str, to: &str| {
            let text = EXAMPLE.replacen(from, to, 1);
            assert_ne!(text, EXAMPLE, "{from}");
            TipModesFile::parse(&text).unwrap_err().to_string()
        };
        for (from, to, wanted) in [
            ("version = 1", "version = 2", ["line ", "`version`", "2", "allowed is 1"]),
            ("\"x\"", "\"z\"", ["line 11", "`direction`", "z", "x or y"]),
            ("922.0", "0.5", ["line 12", "`frequency_hz`", "0.5", "1 to 20000"]),
            ("922.0", "\"fast\"", ["frequency_hz", "fast", "a number", "line 12"]),
            ("mass_kg", "weight_kg", ["weight_kg", "unknown", "line", "mass_kg"]),
            ("mass_kg = 0.03993", "", ["mode 1", "`mass_kg`", "`stiffness_n_m`", "neither"]),
            ("mass_kg = 0.03993", "stiffness_n_m = -3", ["line 14", "`stiffness_n_m`", "-3", "kg"]),
            ("title = ", "titel = ", ["titel", "unknown", "title", "line"]),
        ] {
            let text = message(from, to);
            assert!(wanted.iter().all(|part| text.contains(part)), "{to}: {text}");
        }
        assert!(TipModesFile::parse("version = ").is_err());
        let none = "version = 1\ntitle = \"a\"\nsource = \"b\"\nmode = []\n";
        assert!(TipModesFile::parse(none).unwrap_err().to_string().contains("no mode"));
    }
}
