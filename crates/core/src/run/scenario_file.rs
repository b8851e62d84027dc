//! Scenario files: versioned TOML. Every field is optional but `version`; unknown fields are
//! refused. What is written carries the documentation of every field.

use std::fmt::Write as _;

use super::edits::{Edit, Edits};
use super::scenario::{FORMAT_VERSION, Scenario, is_group, param, table};
use crate::base::language::{in_english, tr};
use crate::base::settings::{SettingError, Value};

fn format_error(problem: impl Into<String>) -> SettingError {
    SettingError::Format { what: tr("scenario file").to_owned(), problem: problem.into() }
}

/// Longest scenario text that is read, bytes.
const MAX_BYTES: usize = 4_000_000;

/// Reads a scenario and its edits.
///
/// ```
/// use steadycut_core::run::scenario_file;
///
/// let text = "version = 1\n[target]\nra_um = 0.6\n";
/// let (scenario, edits) = scenario_file::parse(text).unwrap();
/// assert_eq!(scenario.target.ra_um, 0.6);
/// assert!(edits.list().is_empty());
///
/// let error = scenario_file::parse("version = 1\n[target]\nra_mm = 0.6\n").unwrap_err();
/// assert!(error.to_string().contains("target.ra_um"), "names the nearest field: {error}");
/// ```
///
/// # Errors
/// Not TOML (with line and column), a missing or unknown version, an unknown field (with the
/// nearest known one), or a value outside its range.
pub fn parse(text: &str) -> Result<(Scenario, Edits), SettingError> {
    if text.len() > MAX_BYTES {
        return Err(format_error(tr!(
            "{n} bytes; at most {most} are read",
            n = text.len(),
            most = MAX_BYTES
        )));
    }
    let mut document: toml::Table =
        text.parse().map_err(|error: toml::de::Error| format_error(error.to_string()))?;
    match document.remove("version") {
        Some(toml::Value::Integer(FORMAT_VERSION)) => {}
        Some(other) => {
            let problem = tr!(
                "`version` is {version}; this program reads {known}",
                version = other.to_string(),
                known = FORMAT_VERSION
            );
            return Err(format_error(problem));
        }
        None => {
            let problem = tr!("`version = {version}` is missing", version = FORMAT_VERSION);
            return Err(format_error(problem));
        }
    }
    let edits = document.remove("edits");
    let mut changes = Vec::new();
    flatten("", document, &mut changes)?;
    named_once(&changes)?;
    let mut scenario = Scenario::default();
    scenario.set_all(&changes)?;
    let edits = edits.map_or(Ok(Edits::none()), |list| parse_edits(&scenario, list))?;
    Ok((scenario, edits))
}

/// A setting must not stand there under the name it has and one that it had.
fn named_once(changes: &[(String, Value)]) -> Result<(), SettingError> {
    for (path, _) in changes {
        let now = &param(path)?.path;
        if now != path && changes.iter().any(|(other, _)| other == now) {
            let problem =
                tr!("`{path}` and `{now}` are one setting; keep `{now}`", path = path, now = now);
            return Err(format_error(problem));
        }
    }
    Ok(())
}

fn flatten(
    prefix: &str,
    entries: toml::Table,
    changes: &mut Vec<(String, Value)>,
) -> Result<(), SettingError> {
    for (key, value) in entries {
        let path = if prefix.is_empty() { key } else { format!("{prefix}.{key}") };
        if let toml::Value::Table(inner) = value {
            if !is_group(&path) {
                let path = path.chars().take(80).collect();
                return Err(SettingError::Unknown { path, suggestion: None });
            }
            flatten(&path, inner, changes)?;
        } else {
            let value = value_from_toml(&path, &value)?;
            changes.push((path, value));
        }
    }
    Ok(())
}

fn value_from_toml(path: &str, value: &toml::Value) -> Result<Value, SettingError> {
    in_transit(value).ok_or_else(|| {
        // An unknown field must be called unknown, whatever its value.
        param(path).map_or_else(
            |unknown| unknown,
            |param| SettingError::Refused {
                path: path.to_owned(),
                value: value.to_string().chars().take(60).collect(),
                allowed: param.spec.allowed.allowed(param.spec.unit),
            },
        )
    })
}

/// The value; no setting is a date or a table.
fn in_transit(value: &toml::Value) -> Option<Value> {
    Some(match value {
        toml::Value::Integer(x) => Value::Int(*x),
        toml::Value::Float(x) => Value::Float(*x),
        toml::Value::Boolean(x) => Value::Bool(*x),
        toml::Value::String(x) => Value::Text(x.clone()),
        toml::Value::Array(list) => {
            Value::List(list.iter().map(in_transit).collect::<Option<_>>()?)
        }
        toml::Value::Datetime(_) | toml::Value::Table(_) => return None,
    })
}

fn parse_edits(scenario: &Scenario, list: toml::Value) -> Result<Edits, SettingError> {
    let shape = || {
        format_error(tr(
            "`edits` must be a list of tables with `at_s` (a number), `path` (text) and `value`",
        ))
    };
    let toml::Value::Array(list) = list else { return Err(shape()) };
    let mut edits = Edits::none();
    for entry in list {
        let entry = entry.as_table().ok_or_else(shape)?;
        if let Some(key) = entry.keys().find(|k| !["at_s", "path", "value"].contains(&k.as_str())) {
            let problem = tr!("unknown field `edits.{key}`; use at_s, path, value", key = key);
            return Err(format_error(problem));
        }
        let at = entry.get("at_s");
        let at_s = at.and_then(|at| at.as_float().or_else(|| at.as_integer().map(|x| x as f64)));
        let at_s = at_s.ok_or_else(shape)?;
        let path = entry.get("path").and_then(toml::Value::as_str).ok_or_else(shape)?.to_owned();
        let value = value_from_toml(&path, entry.get("value").ok_or_else(shape)?)?;
        edits.push(scenario, Edit { at_s, path, value })?;
    }
    Ok(edits)
}

fn literal(value: &Value) -> String {
    match value {
        Value::Text(text) => toml::Value::String(text.clone()).to_string(),
        // {:?} keeps the decimal point, so that a number stays a float in TOML.
        Value::Float(x) => format!("{x:?}"),
        Value::Int(_) | Value::Bool(_) | Value::List(_) => value.to_string(),
    }
}

/// Writes a scenario with all its fields, each with its documentation, unit and range. Reading it
/// back gives the same scenario and edits.
///
/// ```
/// use steadycut_core::run::{edits::Edits, presets, scenario_file};
///
/// let scenario = presets::load("depth-step").unwrap();
/// let text = scenario_file::write(&scenario, &Edits::none());
/// assert_eq!(scenario_file::parse(&text).unwrap(), (scenario, Edits::none()));
/// ```
#[must_use]
pub fn write(scenario: &Scenario, edits: &Edits) -> String {
    let mut text = format!("# SteadyCut scenario\nversion = {FORMAT_VERSION}\n");
    let mut group = "";
    for param in table() {
        if param.group != group {
            group = param.group;
            let _ = write!(text, "\n[{group}]\n");
        }
        let allowed = in_english(|| param.spec.allowed.allowed(param.spec.unit));
        let value = scenario.get(&param.path).expect("the table lists known paths");
        let _ = writeln!(text, "# {} ({allowed})", param.spec.doc.replace('\n', " "));
        let _ = writeln!(text, "{} = {}", param.spec.key, literal(&value));
    }
    for edit in edits.list() {
        let _ = write!(
            text,
            "\n[[edits]]\nat_s = {:?}\npath = {}\nvalue = {}\n",
            edit.at_s,
            literal(&Value::Text(edit.path.clone())),
            literal(&edit.value),
        );
    }
    text
}
