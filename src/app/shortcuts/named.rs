//! Keys by the names that stand on the keyboards of a language.

use egui::{Context, KeyboardShortcut};

use crate::base::language::{catalogue, tr};

/// A key with what is held down with it, as the keyboards of the chosen language name them.
#[must_use]
pub fn named(ctx: &Context, keys: &KeyboardShortcut) -> String {
    let plain = ctx.format_shortcut(keys);
    if catalogue().is_none() {
        return plain;
    }
    // The font may have no sign for it.
    let key = keys.logical_key;
    let written = [key.symbol_or_name(), key.name()].into_iter().find(|key| plain.ends_with(key));
    let Some(key) = written else { return plain };
    let held = &plain[..plain.len() - key.len()];
    let held = held.split_inclusive('+').map(|name| match name.strip_suffix('+') {
        Some(name) => format!("{}+", of_key(name)),
        None => name.to_owned(),
    });
    held.chain([of_key(key).to_owned()]).collect()
}

/// The name of a key; letters, figures and signs are the same everywhere. The words say that a key is meant, since the
/// same are other things elsewhere.
fn of_key(name: &str) -> &str {
    match name {
        "Ctrl" => tr("Ctrl (key)"),
        "Shift" => tr("Shift (key)"),
        "Left" => tr("Left (key)"),
        "Right" => tr("Right (key)"),
        "Up" => tr("Up (key)"),
        "Down" => tr("Down (key)"),
        "Space" => tr("Space (key)"),
        "Home" => tr("Home (key)"),
        "End" => tr("End (key)"),
        "PageUp" => tr("PageUp (key)"),
        "PageDown" => tr("PageDown (key)"),
        "Backspace" => tr("Backspace (key)"),
        other => other,
    }
}
