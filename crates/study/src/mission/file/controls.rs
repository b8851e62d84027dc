//! What a mission lets be changed, as its file says it.

use std::collections::BTreeMap;

use serde::Deserialize;
use toml::Spanned;

use super::Reader;
use crate::base::language::tr;
use crate::base::settings::{Kind, Value};
use crate::mission::Controls;
use crate::run::scenario::{Scenario, param};

#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields, expecting = "open, locked and options")]
pub(super) struct ControlsText {
    #[serde(default)]
    open: Vec<Spanned<String>>,
    #[serde(default)]
    locked: Vec<Spanned<String>>,
    #[serde(default)]
    options: BTreeMap<String, Spanned<Vec<Spanned<String>>>>,
}

impl Reader<'_> {
    /// The settings that are open or locked, and the options that are offered of those that are choices.
    pub(super) fn controls(
        &self,
        text: &ControlsText,
        scenario: &Scenario,
    ) -> Result<Controls, String> {
        let open = self.settings("controls.open", &text.open)?;
        let locked = self.settings("controls.locked", &text.locked)?;
        let mut options = BTreeMap::new();
        for (path, list) in &text.options {
            let entry = format!("controls.options.{path}");
            let path = param(path)
                .map(|param| param.path.clone())
                .map_err(|error| self.at(&entry, list, &error.to_string()))?;
            if !open.contains(&path) {
                let problem = tr!(
                    "is not open: allowed are settings of `controls.open`: {open}",
                    open = open.join(", ")
                );
                return Err(self.at(&entry, list, &problem));
            }
            let offered = self.offered(&entry, &path, list, scenario)?;
            options.insert(path, offered);
        }
        Ok(Controls { open, locked, options })
    }

    /// The options that are offered of a choice: two at least, that of the mission's own cut among them.
    fn offered(
        &self,
        entry: &str,
        path: &str,
        list: &Spanned<Vec<Spanned<String>>>,
        scenario: &Scenario,
    ) -> Result<Vec<String>, String> {
        let spec = &param(path).map_err(|error| self.at(entry, list, &error.to_string()))?.spec;
        let Kind::Choice { options } = &spec.allowed else {
            return Err(self.at(
                entry,
                list,
                tr("is no choice: allowed are settings with options"),
            ));
        };
        let all: Vec<&str> = options.iter().map(|option| option.id).collect();
        let mut offered: Vec<String> = Vec::new();
        for id in list.get_ref() {
            let id = self.one_of(entry, id, &all)?;
            if !offered.iter().any(|other| other == id) {
                offered.push(id.to_owned());
            }
        }
        if offered.len() < 2 {
            let problem = tr!(
                "offers {count} options: allowed are 2 at least, of {list}",
                count = offered.len(),
                list = all.join(", ")
            );
            return Err(self.at(entry, list, &problem));
        }
        if let Ok(Value::Text(own)) = scenario.get(path)
            && !offered.contains(&own)
        {
            let problem = tr!(
                "lacks `{own}`: that of the mission's own cut is among those that are offered",
                own = own
            );
            return Err(self.at(entry, list, &problem));
        }
        Ok(offered)
    }
}
