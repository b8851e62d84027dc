//! A cut as a mission or an answer changes it, read like a scenario file.

use crate::base::language::tr;
use crate::run::edits::Edits;
use crate::run::scenario::Scenario;
use crate::run::scenario_file;

/// A scenario with settings put over it, by groups as in a scenario file, and changes during the cut.
///
/// # Errors
/// As a scenario file: names the setting, the value and what is allowed.
pub(super) fn changed(
    base: &Scenario,
    set: &toml::Table,
    edits: &[toml::Value],
) -> Result<(Scenario, Edits), String> {
    let of_cut =
        |error: &dyn std::fmt::Display| tr!("`set` or `edits`: {error}", error = error.to_string());
    let text = scenario_file::write(base, &Edits::none());
    let mut document: toml::Table =
        text.parse().map_err(|error: toml::de::Error| of_cut(&error))?;
    for (group, settings) in set {
        let toml::Value::Table(settings) = settings else {
            let problem = tr("allowed are tables of settings, as in a scenario file");
            return Err(format!("`set.{group}`: {problem}"));
        };
        merge(&mut document, group, settings);
    }
    if !edits.is_empty() {
        document.insert("edits".to_owned(), toml::Value::Array(edits.to_vec()));
    }
    scenario_file::parse(&document.to_string()).map_err(|error| of_cut(&error))
}

/// Puts settings over those of a group, and of the groups in it.
fn merge(document: &mut toml::Table, group: &str, settings: &toml::Table) {
    let entry = document.entry(group).or_insert_with(|| toml::Value::Table(toml::Table::new()));
    let Some(table) = entry.as_table_mut() else { return };
    for (key, value) in settings {
        match value.as_table() {
            Some(inner) => merge(table, key, inner),
            None => {
                table.insert(key.clone(), value.clone());
            }
        }
    }
}
