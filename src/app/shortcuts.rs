//! The keyboard: one table gives the keys and the sheet that lists them. The first nine screens have
//! a key each; there is no end to how many there may be. A browser keeps some keys for itself: a page has
//! others for the same.

mod named;
mod sheet;

use std::sync::LazyLock;

use egui::{Context, Event, Id, Key, KeyboardShortcut, Modifiers};

use crate::base::language::text;
use crate::models::disturbances::Disturbance;

use super::command::{
    Command, FileCommand, HandCommand, PlaybackCommand, SessionCommand, ShellCommand,
};
pub use named::named;
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
    /// Whether the operator mode is on: the keys of its knob act.
    pub operator: bool,
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

/// The keys that drop a disturbance into the running cut, with what they do.
const DROPS: [(Key, &str, Disturbance); 10] = [
    (Key::H, text!("Drop a hard spot into the cut"), Disturbance::HardSpot),
    (Key::G, text!("Drop a gap into the cut"), Disturbance::Gap),
    (Key::D, text!("Drop a depth step into the cut"), Disturbance::DepthStep),
    (Key::W, text!("Let the wear jump"), Disturbance::WearJump),
    (Key::B, text!("Break a tooth"), Disturbance::BrokenTooth),
    (Key::C, text!("Drop a burst of chatter into the cut"), Disturbance::ChatterBurst),
    (Key::S, text!("Let the sensor drop out"), Disturbance::SensorDropout),
    (Key::R, text!("Let the sensor drift"), Disturbance::SensorDrift),
    (Key::T, text!("Make the dead time longer for a while"), Disturbance::DeadTime),
    (Key::O, text!("Turn the override by hand for a while"), Disturbance::Operator),
];

/// Key and name of the switch of the operator mode.
const OPERATOR: (Key, &str) =
    (Key::M, text!("Drive the cut by hand: the operator's knob, on or off"));

/// What opens the search.
const FIND: Command = Command::Shell(ShellCommand::ShowSearch(true));

/// Clicks of the knob that Page Up and Page Down are.
pub const PAGE_CLICKS: i32 = 5;

/// The keys of the knob in operator mode, with what they do and by how many clicks.
const KNOB: [(Key, &str, i32); 5] = [
    (Key::Plus, text!("Turn the operator's knob up"), 1),
    (Key::Equals, text!("Turn the operator's knob up"), 1),
    (Key::Minus, text!("Turn the operator's knob down"), -1),
    (Key::PageUp, text!("Turn the operator's knob far up"), PAGE_CLICKS),
    (Key::PageDown, text!("Turn the operator's knob far down"), -PAGE_CLICKS),
];

/// Name of [`PlaybackCommand::TryAgain`].
pub const TRY_AGAIN: &str = text!("Back to before it went wrong");

/// Name of [`SessionCommand::CutAgain`].
pub const CUT_AGAIN: &str = text!("Apply from the start");

/// The keys of a window or a page: made once, since every frame asks for some of them.
fn table(place: Host) -> &'static [Shortcut] {
    static OF_WINDOW: LazyLock<Vec<Shortcut>> = LazyLock::new(|| all_of(Host::Window));
    static OF_PAGE: LazyLock<Vec<Shortcut>> = LazyLock::new(|| all_of(Host::Page));
    match place {
        Host::Window => &OF_WINDOW,
        Host::Page => &OF_PAGE,
    }
}

fn all_of(place: Host) -> Vec<Shortcut> {
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
    let mut all = vec![
        shortcut(
            none,
            Key::Space,
            text!("Play or pause; after the end: again"),
            Command::Playback(PlaybackCommand::TogglePlay),
        ),
        shortcut(
            ctrl,
            Key::ArrowRight,
            text!("One control sample on"),
            Command::Playback(PlaybackCommand::Step(1)),
        ),
        shortcut(
            ctrl,
            Key::ArrowLeft,
            text!("One control sample back"),
            Command::Playback(PlaybackCommand::Step(-1)),
        ),
        shortcut(
            shift,
            Key::ArrowRight,
            text!("1 s on"),
            Command::Playback(PlaybackCommand::SeekBy(1.0)),
        ),
        shortcut(
            shift,
            Key::ArrowLeft,
            text!("1 s back"),
            Command::Playback(PlaybackCommand::SeekBy(-1.0)),
        ),
        shortcut(
            none,
            Key::ArrowRight,
            text!("0.1 s on"),
            Command::Playback(PlaybackCommand::SeekBy(0.1)),
        ),
        shortcut(
            none,
            Key::ArrowLeft,
            text!("0.1 s back"),
            Command::Playback(PlaybackCommand::SeekBy(-0.1)),
        ),
        shortcut(shift, Key::Home, CUT_AGAIN, Command::Session(SessionCommand::CutAgain)),
        shortcut(
            none,
            Key::Home,
            text!("To the start"),
            Command::Playback(PlaybackCommand::SeekTo(0.0)),
        ),
        shortcut(
            none,
            Key::End,
            text!("To the end"),
            Command::Playback(PlaybackCommand::SeekToEnd),
        ),
        shortcut(ctrl | shift, Key::Z, text!("Redo"), Command::Session(SessionCommand::Redo)),
        shortcut(ctrl, Key::Z, text!("Undo"), Command::Session(SessionCommand::Undo)),
        shortcut(ctrl, Key::Y, text!("Redo"), Command::Session(SessionCommand::Redo)),
        shortcut(
            none,
            Key::Slash,
            text!("Find a setting, scenario, screen, command or word"),
            FIND,
        ),
        shortcut(ctrl, Key::O, text!("Open a scenario file"), Command::File(FileCommand::Open)),
        shortcut(
            ctrl,
            Key::S,
            text!("Save the scenario with its edits"),
            Command::File(FileCommand::Save),
        ),
        shortcut(
            own,
            Key::E,
            text!("Export all signals as CSV"),
            Command::File(FileCommand::ExportCsv),
        ),
        shortcut(
            own,
            Key::L,
            text!("Copy a link to this state"),
            Command::File(FileCommand::CopyLink),
        ),
    ];
    all.push(shortcut(
        none,
        Key::Backspace,
        TRY_AGAIN,
        Command::Playback(PlaybackCommand::TryAgain),
    ));
    let drops =
        DROPS.iter().map(|(key, doing, kind)| shortcut(none, *key, doing, Command::drop(*kind)));
    all.extend(drops);
    all.push(shortcut(none, OPERATOR.0, OPERATOR.1, Command::hand(HandCommand::Toggle)));
    let turn = |clicks| Command::hand(HandCommand::Turn(clicks));
    all.extend(KNOB.iter().map(|(key, doing, clicks)| shortcut(none, *key, doing, turn(*clicks))));
    all
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
    let keys = table(place).iter().find(|shortcut| shortcut.command == *command);
    keys.map_or(String::new(), |found| format!(" ({})", named(ctx, &found.keys)))
}

/// The commands that have a key, each once, with what they do.
pub fn commands(place: Host) -> Vec<(&'static str, Command)> {
    let mut all: Vec<(&'static str, Command)> = Vec::new();
    for Shortcut { doing, command, .. } in table(place) {
        if all.iter().all(|(_, other)| other != command) {
            all.push((*doing, command.clone()));
        }
    }
    all
}

/// Where the events are kept that come with the next frame.
fn typed_after() -> Id {
    Id::unique("typed after the key that opens the search")
}

/// Whether what has the focus is pressed by Space, as a button is and a slider is not: then that is all that Space does.
fn is_pressed_by_space(ctx: &Context) -> bool {
    let focused = ctx.memory(|memory| memory.focused());
    let focused = focused.and_then(|id| ctx.read_response(id));
    focused.is_some_and(|response| response.enabled() && response.sense.senses_click())
}

/// The commands of the keys pressed in this frame. A text that is being written has all keys; what belongs
/// to Alt is the system's or the browser's.
pub fn read(ctx: &Context, reach: &Reach<'_>, commands: &mut Vec<Command>) {
    let typed = ctx.data_mut(|data| data.remove_temp::<Vec<Event>>(typed_after()));
    ctx.input_mut(|input| input.events.splice(0..0, typed.into_iter().flatten()).for_each(drop));
    if ctx.text_edit_focused() {
        return;
    }
    // An open menu has the keys that choose in it.
    let menu = egui::Popup::is_any_open(ctx);
    let focused = ctx.egui_wants_keyboard_input();
    let pressed_by_space = is_pressed_by_space(ctx);
    let screens = reach.screens.iter().enumerate().filter_map(|(order, id)| {
        let command = Command::Shell(ShellCommand::ShowScreen(id));
        Some((screen_key(order, reach.place)?, command))
    });
    let sheet = KeyboardShortcut::new(Modifiers::NONE, Key::Questionmark);
    let sheet = (sheet, Command::Shell(ShellCommand::ShowShortcuts(true)));
    let all = table(reach.place).iter().filter(|shortcut| {
        let there = match shortcut.command {
            Command::Session(SessionCommand::Hand(HandCommand::Turn(_))) => {
                reach.operator && reach.timeline && !menu
            }
            Command::Playback(_) | Command::Session(SessionCommand::Disturb(_)) => {
                reach.timeline && !menu
            }
            Command::Session(_) | Command::File(_) | Command::Shell(_) | Command::Library(_) => {
                true
            }
        };
        let pressed = pressed_by_space && shortcut.keys.logical_key == Key::Space;
        there && !pressed && (!focused || shortcut.acts_anywhere())
    });
    let all: Vec<(KeyboardShortcut, Command)> = screens
        .chain([sheet])
        .chain(all.map(|shortcut| (shortcut.keys, shortcut.command.clone())))
        .collect();
    // What is typed right after the key that opens the search is for its field, which is there from the next frame on;
    // the key's own sign is for nobody.
    let (mut opens, mut own_sign, mut typed) = (false, false, Vec::new());
    ctx.input_mut(|input| {
        if input.modifiers.alt {
            return;
        }
        // In the order in which they were pressed: slow drawing puts several into one frame.
        input.events.retain(|event| {
            let of_keys = matches!(event, Event::Key { .. } | Event::Text(_));
            if opens && of_keys {
                let own = matches!(event, Event::Text(_)) && std::mem::take(&mut own_sign);
                typed.extend((!own).then(|| event.clone()));
                return false;
            }
            let Event::Key { key, pressed: true, modifiers, .. } = event else { return true };
            let meant = all.iter().find(|(keys, _)| {
                keys.logical_key == *key && modifiers.matches_logically(keys.modifiers)
            });
            commands.extend(meant.map(|(_, command)| command.clone()));
            opens = meant.is_some_and(|(_, command)| *command == FIND);
            own_sign = opens && !modifiers.command;
            meant.is_none()
        });
    });
    if !typed.is_empty() {
        ctx.data_mut(|data| data.insert_temp(typed_after(), typed));
        ctx.request_repaint();
    }
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
