//! The keyboard: one table gives the keys and the sheet that lists them.

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

/// The sheet that lists all keys.
pub fn sheet(ctx: &Context, screens: &[&'static str], open: &mut bool) {
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
                let screens = KeyboardShortcut::new(Modifiers::COMMAND, DIGITS[screens.len() - 1]);
                let first = KeyboardShortcut::new(Modifiers::COMMAND, DIGITS[0]);
                let keys =
                    format!("{} … {}", ctx.format_shortcut(&first), ctx.format_shortcut(&screens));
                line(keys, "The screens");
                line("?".to_owned(), "This sheet");
                line("Double-click on a plot".to_owned(), "Fit");
                line("Drag on a plot".to_owned(), "Zoom");
                line("Right-click on a setting".to_owned(), "Back to its default");
            });
        });
}
