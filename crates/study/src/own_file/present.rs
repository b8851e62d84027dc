//! Files of what a scenario has now, to be kept and taken again.

use crate::base::language::in_english;
use crate::base::settings::{Group, Value};
use crate::models::tip_modes::{TipModes, TipModesFile};
use crate::models::tool::{EndShape, Tool};

/// The text of a cutter's file: what [`super::OwnFile::read`] reads back, to the bit. What may be left out is left out
/// where it says nothing.
#[must_use]
pub fn tool_file(tool: &Tool, title: &str, source: &str) -> String {
    let quoted = |text: &str| toml::Value::String(text.to_owned()).to_string();
    let mut text = format!("version = 1\ntitle = {}\nsource = {}\n", quoted(title), quoted(source));
    for spec in Tool::specs() {
        let no_corner = spec.key == "corner_radius_mm" && tool.shape != EndShape::BullNose;
        if spec.key == "name" || no_corner {
            continue;
        }
        let value = match tool.get(spec.key) {
            Some(Value::Text(text)) => quoted(&text),
            Some(Value::Float(x)) => format!("{x:?}"),
            Some(Value::Int(x)) => x.to_string(),
            Some(Value::Bool(x)) => x.to_string(),
            // A cutter has no lists.
            Some(Value::List(_)) | None => continue,
        };
        let allowed = in_english(|| spec.allowed.allowed(spec.unit));
        text.push_str(&format!("{} = {value}    # {allowed}\n", spec.key));
    }
    text
}

/// The text of a structure's file; none where there are no modes.
#[must_use]
pub fn structure_file(modes: &TipModes, title: &str, source: &str) -> Option<String> {
    let file = || TipModesFile {
        title: title.to_owned(),
        source: source.to_owned(),
        modes: modes.clone(),
    };
    (!modes.is_empty()).then(|| file().write())
}
