//! The keyboard: one table gives the keys and the sheet that lists them. The first nine screens have
//! a key each; there is no end to how many there may be.

use egui::{Context, Key, KeyboardShortcut, Modifiers};

use super::command::{Command, FileCommand, PlaybackCommand, SessionCommand, ShellCommand};

/// A key with what it does.
struct Shortcut {
    keys: KeyboardShortcut,
    doing: &'static str,
    command: Command,
}

fn table() -> Vec<Shortcut> {
    let shortcut = |modifiers, key, doing, command| Shortcut {
        keys: KeyboardShortcut::new(modifiers, key),
        doing,
        command,
    };
    let (none, shift, ctrl) = (Modifiers::NONE, Modifiers::SHIFT, Modifiers::COMMAND);
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
        shortcut(ctrl, Key::O, "Open a scenario file", Command::File(FileCommand::Open)),
        shortcut(
            ctrl,
            Key::S,
            "Save the scenario with its edits",
            Command::File(FileCommand::Save),
        ),
        shortcut(ctrl, Key::E, "Export all signals as CSV", Command::File(FileCommand::ExportCsv)),
        shortcut(ctrl, Key::L, "Copy a link to this state", Command::File(FileCommand::CopyLink)),
    ]
}

/// The keys of the screens, with Ctrl. Ctrl+0 is none of them: it resets the zoom.
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

/// The key that shows the screen at this place in the order of the tabs, with Ctrl; the tenth and
/// those after it have none and are shown by their tabs.
#[must_use]
pub fn screen_key(place: usize) -> Option<Key> {
    DIGITS.get(place).copied()
}

/// The line of the sheet that says how the screens are shown, where there are `count` of them.
fn screens_line(ctx: &Context, count: usize) -> Option<(String, &'static str)> {
    let name = |key| ctx.format_shortcut(&KeyboardShortcut::new(Modifiers::COMMAND, key));
    let last = *DIGITS.get(..count).unwrap_or(&DIGITS).last()?;
    let keys = format!("{} … {}", name(DIGITS[0]), name(last));
    let doing = if count > DIGITS.len() {
        "The first screens; the others by their tabs"
    } else {
        "The screens"
    };
    Some((keys, doing))
}

/// The commands of the keys pressed in this frame. Keys without Ctrl belong to the widget that has
/// the focus, all keys to a text that is being written.
pub fn read(ctx: &Context, screens: &[&'static str], commands: &mut Vec<Command>) {
    if ctx.text_edit_focused() {
        return;
    }
    let focused = ctx.egui_wants_keyboard_input();
    ctx.input_mut(|input| {
        for (key, id) in DIGITS.into_iter().zip(screens) {
            if input.consume_key(Modifiers::COMMAND, key) {
                commands.push(Command::Shell(ShellCommand::ShowScreen(id)));
            }
        }
        if input.key_pressed(Key::Questionmark) && !focused {
            commands.push(Command::Shell(ShellCommand::ShowShortcuts(true)));
        }
        for shortcut in table() {
            let free = shortcut.keys.modifiers.command || !focused;
            if free && input.consume_shortcut(&shortcut.keys) {
                commands.push(shortcut.command);
            }
        }
    });
}

/// The sheet that lists all keys, for this number of screens.
pub fn sheet(ctx: &Context, screens: usize, open: &mut bool) {
    egui::Window::new("Keyboard")
        .open(open)
        .collapsible(false)
        .resizable(false)
        .anchor(egui::Align2::CENTER_CENTER, egui::Vec2::ZERO)
        .vscroll(true)
        .default_height(600.0)
        .show(ctx, |ui| {
            egui::Grid::new("keys").num_columns(2).spacing([24.0, 5.0]).show(ui, |ui| {
                let mut line = |keys: String, doing: &str| {
                    ui.strong(keys);
                    ui.label(doing);
                    ui.end_row();
                };
                for shortcut in table() {
                    line(ctx.format_shortcut(&shortcut.keys), shortcut.doing);
                }
                if let Some((keys, doing)) = screens_line(ctx, screens) {
                    line(keys, doing);
                }
                line("?".to_owned(), "This sheet");
                line("Double-click on a plot".to_owned(), "Fit");
                line("Drag on a plot".to_owned(), "Zoom");
                line("Right-click on a setting".to_owned(), "Back to its default");
            });
        });
}
