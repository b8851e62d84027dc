//! `steadycut list --uses`: which command and which screen uses which setting.

use std::io::Write;
use std::process::ExitCode;

use serde_json::{Map, Value, json};

use super::Outcome;
use crate::run::scenario::{Param, table};
use crate::study::uses::{Reader, Screen, SettingUse};

/// Words with the labels that they hold for.
type Labelled = Vec<(String, Vec<&'static str>)>;

/// Prints the table: every setting with every command and every screen that offers settings.
pub fn print(as_json: bool) -> Outcome {
    let mut out = std::io::stdout().lock();
    if as_json {
        let rows: Vec<Value> = table().iter().map(row).collect();
        writeln!(out, "{}", serde_json::to_string_pretty(&json!({ "settings": rows }))?)?;
        return Ok(ExitCode::SUCCESS);
    }
    writeln!(
        out,
        "Every setting with every command that takes --set, and every screen that offers settings. A\n\
         command refuses a setting that it has no use for; a screen greys it, with the reason."
    )?;
    for param in table() {
        writeln!(out, "\n{}", param.path)?;
        let (mut used, mut refused) = (Labelled::new(), Labelled::new());
        for reader in Reader::ALL {
            let (list, words) = match reader.uses(param) {
                SettingUse::Used { unless } if unless.is_empty() => (&mut used, "used".to_owned()),
                SettingUse::Used { unless } => {
                    (&mut used, format!("used, refused where {}", unless.join("; or ")))
                }
                SettingUse::Refused { because } => (&mut refused, format!("refused: {because}")),
            };
            match list.iter_mut().find(|(known, _)| *known == words) {
                Some((_, labels)) => labels.push(reader.label()),
                None => list.push((words, vec![reader.label()])),
            }
        }
        for (words, labels) in used.into_iter().chain(refused) {
            writeln!(out, "  {}: {words}", labels.join(", "))?;
        }
        for screen in Screen::ALL.iter().filter(|screen| screen.offers(param)) {
            writeln!(out, "  screen {}: {}", screen.label(), words(*screen, param))?;
        }
    }
    Ok(ExitCode::SUCCESS)
}

/// What a screen does with a setting that it offers.
fn words(screen: Screen, param: &Param) -> String {
    let readers = screen.readers();
    let using: Vec<&str> = readers
        .iter()
        .filter(|reader| matches!(reader.uses(param), SettingUse::Used { .. }))
        .map(|reader| reader.label())
        .collect();
    if using.is_empty() {
        let all: Vec<&str> = readers.iter().map(|reader| reader.label()).collect();
        return format!("greyed: {} has no use for it", all.join(", "));
    }
    format!("used by {}, greyed where refused", using.join(", "))
}

fn row(param: &Param) -> Value {
    let mut commands = Map::new();
    for reader in Reader::ALL {
        let found = match reader.uses(param) {
            SettingUse::Used { unless } => json!({ "use": "used", "unless": unless }),
            SettingUse::Refused { because } => json!({ "use": "refused", "because": because }),
        };
        commands.insert(reader.id().to_owned(), found);
    }
    let mut screens = Map::new();
    for screen in Screen::ALL {
        let found = if screen.offers(param) { words(*screen, param) } else { continue };
        screens.insert(screen.id().to_owned(), found.into());
    }
    json!({ "path": param.path, "commands": commands, "screens": screens })
}
