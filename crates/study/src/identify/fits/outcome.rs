//! What a fit has found, as it is told before anything of it is taken.

use super::request::FitFault;
use crate::base::language::{fixed, tr};
use crate::base::settings::Value;
use crate::identify::EstimatedValue;

/// A value that was found.
#[derive(Clone, Debug, PartialEq)]
pub struct FitEstimate {
    /// Its name.
    pub name: String,
    /// The value, with half of its 95 % interval.
    pub value: EstimatedValue,
    /// Digits behind the point.
    pub digits: usize,
    /// Its unit.
    pub unit: &'static str,
}

impl FitEstimate {
    /// Of a name.
    pub(super) fn new(
        name: impl Into<String>,
        value: EstimatedValue,
        digits: usize,
        unit: &'static str,
    ) -> Self {
        Self { name: name.into(), value, digits, unit }
    }

    /// The value with its interval, without its unit.
    #[must_use]
    pub fn told(&self) -> String {
        told(self.value, self.digits)
    }
}

/// A value with its interval.
pub(super) fn told(x: EstimatedValue, digits: usize) -> String {
    match x.half {
        Some(half) => format!("{} ± {}", fixed(x.value, digits), fixed(half, digits)),
        None => tr!("{value}, not determined", value = fixed(x.value, digits)),
    }
}

/// A table of what was found, as that of the structures that were compared.
#[derive(Clone, Debug, PartialEq)]
pub struct FitTable {
    /// What it is.
    pub title: String,
    /// Names of its columns.
    pub heads: Vec<String>,
    /// Its rows.
    pub rows: Vec<Vec<String>>,
    /// The row that was taken, where one of them was.
    pub taken: Option<usize>,
}

/// Measured values against the model's.
#[derive(Clone, Debug, PartialEq)]
pub struct FitPlot {
    /// What is plotted.
    pub title: String,
    /// What it is plotted over, and its unit.
    pub over: (String, &'static str),
    /// Unit of the values.
    pub unit: String,
    /// Place, measured, by the model.
    pub points: Vec<[f64; 3]>,
    /// Whether the places follow each other along a curve.
    pub joined: bool,
    /// Whether sizes are told by their ratio: then what is left is, too.
    pub logarithmic: bool,
}

/// Settings by their paths, or why the scenario does not take them.
pub type FittedSettings = Result<Vec<(String, Value)>, String>;

/// What a fit has found.
#[derive(Clone, Debug, PartialEq)]
pub struct FitOutcome {
    /// Of how much data, in a sentence.
    pub summary: String,
    /// Values with intervals.
    pub estimates: Vec<FitEstimate>,
    /// A table beside them.
    pub table: Option<FitTable>,
    /// What is left: names and values.
    pub left: Vec<(String, String)>,
    /// What a person should know, as what these data cannot tell apart.
    pub notes: Vec<String>,
    /// Measured against model.
    pub plots: Vec<FitPlot>,
    /// The settings that it makes, or why the scenario does not take them.
    pub settings: FittedSettings,
    /// The file that the command writes, or why there is none.
    pub file: Result<String, String>,
}

impl FitOutcome {
    /// With settings and file of a scenario that takes both or none.
    pub(super) fn accepted(
        made: Result<(Vec<(String, Value)>, String), crate::base::settings::SettingError>,
    ) -> (FittedSettings, Result<String, String>) {
        match made {
            Ok((settings, file)) => (Ok(settings), Ok(file)),
            Err(error) => (Err(error.to_string()), Err(error.to_string())),
        }
    }
}

/// The root mean square of what is left, and the share that is explained.
pub(super) fn left_over(rest: f64, unit: &str, r2: f64) -> Vec<(String, String)> {
    vec![
        (tr("left over, rms").to_owned(), format!("{} {unit}", number(rest)).trim_end().to_owned()),
        ("R²".to_owned(), fixed(r2, 5)),
    ]
}

/// A number with the digits that count.
pub(super) fn number(x: f64) -> String {
    crate::base::equation::number(x)
}

/// That nothing was found yet.
pub(super) fn nothing_yet() -> FitFault {
    FitFault::from(tr("nothing is fitted yet").to_owned())
}
