//! The table of settings: one entry for each, with its path.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use super::groups::build_table;
use super::renamed::{current, was_a_group};
use crate::base::language::decimal;
use crate::base::settings::{Kind, SettingError, Spec, Value};
use crate::base::text::nearest;

/// One entry of the table of settings.
#[derive(Clone, Debug)]
pub struct Param {
    /// Full path, for example `controller.sdnrp.kp`.
    pub path: String,
    /// Path of its group, for example `controller.sdnrp`; empty for the top level.
    pub group: &'static str,
    /// Label, unit, range, default, documentation.
    pub spec: Spec,
}

pub(super) static TABLE: LazyLock<Vec<Param>> = LazyLock::new(build_table);
static INDEX: LazyLock<BTreeMap<&'static str, usize>> =
    LazyLock::new(|| TABLE.iter().enumerate().map(|(i, param)| (param.path.as_str(), i)).collect());

/// All settings, in order.
#[must_use]
pub fn table() -> &'static [Param] {
    &TABLE
}

/// Whether there are settings, or were, whose paths begin with this group.
pub(in crate::run) fn is_group(group: &str) -> bool {
    let prefix = format!("{group}.");
    TABLE.iter().any(|param| param.path.starts_with(&prefix)) || was_a_group(&prefix)
}

/// Index of a path, or of the path that a setting had once.
pub(super) fn index_of(path: &str) -> Result<usize, SettingError> {
    INDEX.get(current(path)).copied().ok_or_else(|| {
        // A long or binary path is cut: the message must stay readable, and the search short.
        let path: String = path.chars().take(80).collect();
        let near = nearest(&path, TABLE.iter().map(|param| param.path.as_str()), 0.8);
        let suggestion = near.map(str::to_owned);
        SettingError::Unknown { path, suggestion }
    })
}

/// The table entry of a path; that of an earlier version will do.
///
/// # Errors
/// [`SettingError::Unknown`] with the nearest known path.
pub fn param(path: &str) -> Result<&'static Param, SettingError> {
    index_of(path).map(|i| &TABLE[i])
}

pub(super) fn refused(param: &Param, value: &Value) -> SettingError {
    let fault = match &param.spec.allowed {
        Kind::Structured(shape) => shape.fault(value),
        Kind::Float { .. }
        | Kind::Int { .. }
        | Kind::Bool
        | Kind::Choice { .. }
        | Kind::Text { .. } => None,
    };
    let text = match (fault, value) {
        (Some(fault), _) => fault,
        (None, Value::Text(text)) => format!("{:?}", text.chars().take(60).collect::<String>()),
        // Written out, 1e300 would be cut to another number.
        (None, Value::Float(x)) if x.abs() >= 1e15 => decimal(format!("{x:e}")),
        (None, other) => {
            let unit = param.spec.unit;
            let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
            let text: String = other.to_string().chars().take(60).collect();
            // The point of a number alone: in a list, commas tell its numbers apart.
            let text = if other.number().is_some() { decimal(text) } else { text };
            format!("{text}{unit}")
        }
    };
    let allowed = param.spec.allowed.allowed(param.spec.unit);
    SettingError::Refused { path: param.path.clone(), value: text, allowed }
}

/// Reads the text of a value as the setting at `path` expects it (command line, link).
///
/// # Errors
/// An unknown path, or text that is no value of the setting's type.
pub fn parse_value(path: &str, text: &str) -> Result<Value, SettingError> {
    let param = param(path)?;
    // Spaces belong to a text.
    let trimmed = text.trim();
    let bad = || refused(param, &Value::Text(trimmed.to_owned()));
    Ok(match &param.spec.allowed {
        Kind::Float { .. } => Value::Float(trimmed.parse().map_err(|_| bad())?),
        Kind::Int { .. } => Value::Int(trimmed.parse().map_err(|_| bad())?),
        Kind::Bool => Value::Bool(trimmed.parse().map_err(|_| bad())?),
        Kind::Choice { .. } => Value::Text(trimmed.to_owned()),
        Kind::Text { .. } => Value::Text(text.to_owned()),
        Kind::Structured(shape) => shape.parse(text).ok_or_else(bad)?,
    })
}
