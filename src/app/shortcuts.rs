//! The keyboard: one table gives the keys and the sheet that lists them. The first nine screens have
//! a key each; there is no end to how many there may be. A browser keeps some keys for itself: a page has
//! others for the same.

mod sheet;

use egui::{Context, Event, Key, KeyboardShortcut, Modifiers};

use super::command::{Command, FileCommand, PlaybackCommand, SessionCommand, ShellCommand};
pub use sheet::sheet;

/// Where the console runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Host {
    /// In a window of its own.
    Window,
    /// In a page of a browser, to which Ctrl with a digit, L and E belong.
    Page,
}

impl Host {
    /// Where this program runs.
    pub const HERE: Self = if cfg!(target_arch = "wasm32") { Self::Page } else { Self::Window };
}

/// What the keys can reach now.
#[derive(Clone, Copy, Debug)]
pub struct Reach<'a> {
    /// Where the console runs.
    pub place: Host,
    /// Ids of the screens, in the order of their tabs.
    pub screens: &'a [&'static str],
    /// Whether the run's timeline is on the screen.
    pub timeline: bool,
}

/// A key with what it does.
struct Shortcut {
    keys: KeyboardShortcut,
    doing: &'static str,
    command: Command,
}

impl Shortcut {
    /// Whether it acts too while a slider, a button or another widget has the focus: arrows, Home and End
    /// belong to that widget.
    fn acts_anywhere(&self) -> bool {
        let KeyboardShortcut { modifiers, logical_key } = self.keys;
        let arrow = matches!(logical_key, Key::ArrowLeft | Key::ArrowRight | Key::Home | Key::End);
        modifiers.command || !arrow
    }
}

fn table(place: Host) -> Vec<Shortcut> {
    let shortcut = |modifiers, key, doing, command| Shortcut {
        keys: KeyboardShortcut::new(modifiers, key),
        doing,
        command,
    };
    let (none, shift, ctrl) = (Modifiers::NONE, Modifiers::SHIFT, Modifiers::COMMAND);
    // A page's own keys where the browser has another use for those with Ctrl.
    let own = match place {
        Host::Window => ctrl,
        Host::Page => none,
    };
    // Keys with more modifiers stand before the same keys with fewer.
    vec![
        shortcut(
            none,
            Key::Space,
            "Play or pause; after the end: again",
            Command::Playback(PlaybackCommand::TogglePlay),
        ),
        shortcut(
            ctrl,
            Key::ArrowRight,
            "One control sample on",
            Command::Playback(PlaybackCommand::Step(1)),
        ),
        shortcut(
            ctrl,
            Key::ArrowLeft,
            "One control sample back",
            Command::Playback(PlaybackCommand::Step(-1)),
        ),
        shortcut(shift, Key::ArrowRight, "1 s on", Command::Playback(PlaybackCommand::SeekBy(1.0))),
        shortcut(
            shift,
            Key::ArrowLeft,
            "1 s back",
            Command::Playback(PlaybackCommand::SeekBy(-1.0)),
        ),
        shortcut(
            none,
            Key::ArrowRight,
            "0.1 s on",
            Command::Playback(PlaybackCommand::SeekBy(0.1)),
        ),
        shortcut(
            none,
            Key::ArrowLeft,
            "0.1 s back",
            Command::Playback(PlaybackCommand::SeekBy(-0.1)),
        ),
        shortcut(none, Key::Home, "To the start", Command::Playback(PlaybackCommand::SeekTo(0.0))),
        shortcut(none, Key::End, "To the end", Command::Playback(PlaybackCommand::SeekToEnd)),
        shortcut(ctrl | shift, Key::Z, "Redo", Command::Session(SessionCommand::Redo)),
        shortcut(ctrl, Key::Z, "Undo", Command::Session(SessionCommand::Undo)),
        shortcut(ctrl, Key::Y, "Redo", Command::Session(SessionCommand::Redo)),
        shortcut(
            none,
            Key::Slash,
            "Find a setting, scenario, screen, command or word",
            Command::Shell(ShellCommand::ShowSearch(true)),
        ),
        shortcut(ctrl, Key::O, "Open a scenario file", Command::File(FileCommand::Open)),
        shortcut(
            ctrl,
            Key::S,
            "Save the scenario with its edits",
            Command::File(FileCommand::Save),
        ),
        shortcut(own, Key::E, "Export all signals as CSV", Command::File(FileCommand::ExportCsv)),
        shortcut(own, Key::L, "Copy a link to this state", Command::File(FileCommand::CopyLink)),
    ]
}

/// The keys of the screens: with Ctrl in a window, alone in a page. 0 is none of them: with Ctrl it resets the
/// zoom.
const DIGITS: [Key; 9] = [
    Key::Num1,
    Key::Num2,
    Key::Num3,
    Key::Num4,
    Key::Num5,
    Key::Num6,
    Key::Num7,
    Key::Num8,
    Key::Num9,
];

/// The key that shows the screen at this place in the order of the tabs; the tenth and those after it have
/// none and are shown by their tabs.
#[must_use]
pub fn screen_key(order: usize, place: Host) -> Option<KeyboardShortcut> {
    let modifiers = match place {
        Host::Window => Modifiers::COMMAND,
        Host::Page => Modifiers::NONE,
    };
    DIGITS.get(order).map(|key| KeyboardShortcut::new(modifiers, *key))
}

/// The key of a command as a tooltip shows it, in brackets; empty where there is none.
#[must_use]
pub fn hint(ctx: &Context, place: Host, command: &Command) -> String {
    let keys = table(place).into_iter().find(|shortcut| shortcut.command == *command);
    keys.map_or(String::new(), |found| format!(" ({})", ctx.format_shortcut(&found.keys)))
}

/// The commands that have a key, each once, with what they do.
pub fn commands(place: Host) -> Vec<(&'static str, Command)> {
    let mut all: Vec<(&'static str, Command)> = Vec::new();
    for Shortcut { doing, command, .. } in table(place) {
        if all.iter().all(|(_, other)| *other != command) {
            all.push((doing, command));
        }
    }
    all
}

/// The commands of the keys pressed in this frame. A text that is being written has all keys; what belongs
/// to Alt is the system's or the browser's.
pub fn read(ctx: &Context, reach: &Reach<'_>, commands: &mut Vec<Command>) {
    if ctx.text_edit_focused() {
        return;
    }
    // An open menu has the keys that choose in it.
    let menu = egui::Popup::is_any_open(ctx);
    let focused = ctx.egui_wants_keyboard_input();
    let screens = reach.screens.iter().enumerate().filter_map(|(order, id)| {
        let command = Command::Shell(ShellCommand::ShowScreen(id));
        Some((screen_key(order, reach.place)?, command))
    });
    let sheet = KeyboardShortcut::new(Modifiers::NONE, Key::Questionmark);
    let sheet = (sheet, Command::Shell(ShellCommand::ShowShortcuts(true)));
    let all = table(reach.place).into_iter().filter(|shortcut| {
        let there = match shortcut.command {
            Command::Playback(_) => reach.timeline && !menu,
            Command::Session(_) | Command::File(_) | Command::Shell(_) => true,
        };
        there && (!focused || shortcut.acts_anywhere())
    });
    let all: Vec<(KeyboardShortcut, Command)> = screens
        .chain([sheet])
        .chain(all.map(|shortcut| (shortcut.keys, shortcut.command)))
        .collect();
    ctx.input_mut(|input| {
        if input.modifiers.alt {
            return;
        }
        // In the order in which they were pressed: slow drawing puts several into one frame.
        input.events.retain(|event| {
            let Event::Key { key, pressed: true, modifiers, .. } = event else { return true };
            let meant = all.iter().find(|(keys, _)| {
                keys.logical_key == *key && modifiers.matches_logically(keys.modifiers)
            });
            commands.extend(meant.map(|(_, command)| command.clone()));
            meant.is_none()
        });
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_key_has_two_meanings_and_a_page_leaves_the_browser_its_own() {
        for place in [Host::Window, Host::Page] {
            let screens = (0..9).filter_map(|order| screen_key(order, place));
            let all: Vec<KeyboardShortcut> =
                table(place).iter().map(|shortcut| shortcut.keys).chain(screens).collect();
            for (i, keys) in all.iter().enumerate() {
                assert!(!all[..i].contains(keys), "{keys:?}");
                let of_the_browser = [Key::E, Key::L].contains(&keys.logical_key)
                    || DIGITS.contains(&keys.logical_key);
                if place == Host::Page && of_the_browser {
                    assert!(!keys.modifiers.any(), "{keys:?}");
                }
            }
        }
    }
}
