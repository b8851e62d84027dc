//! The sheet that lists all keys, and what fingers do: it fits the window, and shows that it can be scrolled where it does not.

use egui::{Align2, Context, Key, KeyboardShortcut, Label, RichText, ScrollArea, Ui, Vec2, vec2};

use super::{DIGITS, Host, Reach, named, screen_key, table};
use crate::app::about;
use crate::app::bar;
use crate::app::command::{Command, HandCommand, SessionCommand, ShellCommand};
use crate::app::theme;
use crate::app::widgets::window;
use crate::base::language::{text, tr};

/// Largest size of its content, points, and what its title and the edges of the window take.
const LARGEST: Vec2 = vec2(440.0, 620.0);
/// See [`LARGEST`].
const AROUND: Vec2 = vec2(40.0, 72.0);
/// Width of the keys' names, points, and where it is narrow.
const NAMES: [f32; 2] = [170.0, 120.0];

/// What is done without a key of the table.
const OTHERS: [(&str, &str); 8] = [
    ("?", text!("This sheet")),
    ("Esc", text!("Close what lies on top")),
    (text!("Tab, Enter"), text!("The next control; press it, or end a number")),
    (text!("Arrow keys"), text!("Move the slider or turn the knob that has the focus")),
    (text!("Wheel, or a drag around"), text!("Turn the operator's knob under the pointer")),
    (text!("Double-click on a plot"), text!("Fit")),
    (text!("Drag on a plot"), text!("Zoom")),
    (text!("Right-click on a setting"), text!("Back to its default")),
];

/// What fingers do.
const GESTURES: [(&str, &str); 6] = [
    (text!("Swipe"), text!("Scroll, wherever it begins")),
    (text!("Drag across"), text!("Move a slider or a number")),
    (text!("Drag around"), text!("Turn the operator's knob")),
    (text!("Pinch a plot"), text!("Zoom")),
    (text!("Double tap a plot"), text!("Fit")),
    (text!("Long press"), text!("What it means; the menu of a setting")),
];

/// The line of the screens' keys.
fn screens_line(ctx: &Context, reach: &Reach<'_>) -> Option<(String, &'static str)> {
    let count = reach.screens.len();
    let name = |order: usize| screen_key(order, reach.place).map(|keys| named(ctx, &keys));
    let last = count.min(DIGITS.len()).checked_sub(1)?;
    let keys = format!("{} … {}", name(0)?, name(last)?);
    let doing = if count > DIGITS.len() {
        tr("The first screens; the others by their tabs")
    } else {
        tr("The screens")
    };
    Some((keys, doing))
}

/// Shows the sheet while it is `open`.
pub fn sheet(ctx: &Context, reach: &Reach<'_>, open: &mut bool, commands: &mut Vec<Command>) {
    let room = ctx.content_rect().size() - AROUND;
    let size = LARGEST.min(room).max(Vec2::splat(80.0));
    let title = text!("Keys and gestures");
    // The same window in every language.
    let window = egui::Window::new(tr(title))
        .id(egui::Id::unique(title))
        .collapsible(false)
        .resizable(false)
        .default_size(size)
        .anchor(Align2::CENTER_CENTER, Vec2::ZERO);
    window::closable(ctx, title, window, Some(size.x), open, |ui| {
        ui.spacing_mut().scroll = theme::solid_bars();
        let area = ScrollArea::vertical().max_height(size.y).auto_shrink([false, true]);
        area.show(ui, |ui| {
            ease(ui, commands);
            lines(ui, reach);
        });
    });
}

/// What the program is, and what makes it easier to look at.
fn ease(ui: &mut Ui, commands: &mut Vec<Command>) {
    ui.add(Label::new(tr(about::WHAT_IT_IS)).wrap());
    ui.label(RichText::new(tr!("Version {number}", number = env!("CARGO_PKG_VERSION"))).weak());
    ui.add_space(4.0);
    let ctx = ui.ctx().clone();
    let mut large = theme::is_large(&ctx);
    if ui.checkbox(&mut large, tr("Large type, for a projector")).changed() {
        commands.push(Command::Shell(ShellCommand::Projector(large)));
    }
    ui.horizontal_wrapped(|ui| bar::languages(ui, commands));
    let mut still = theme::is_still(&ctx);
    let help = tr(
        "Windows and lists come without gliding; the masses of the machine stand until they are set in \
                   motion. The cut goes on: Space stops it.",
    );
    if ui.checkbox(&mut still, tr("Less motion")).on_hover_text(help).changed() {
        commands.push(Command::Shell(ShellCommand::LessMotion(still)));
    }
    ui.add_space(4.0);
}

fn lines(ui: &mut Ui, reach: &Reach<'_>) {
    let names = if ui.available_width() < LARGEST.x { NAMES[1] } else { NAMES[0] };
    let line = |ui: &mut Ui, keys: &str, doing: &str| {
        ui.horizontal_top(|ui| {
            let left = egui::Layout::left_to_right(egui::Align::TOP);
            ui.allocate_ui_with_layout(vec2(names, 16.0), left, |ui| {
                ui.set_width(names);
                ui.add(Label::new(RichText::new(keys).strong()).wrap());
            });
            ui.add(Label::new(tr(doing)).wrap());
        });
    };
    // What is at hand comes first.
    let by_fingers = theme::fingers(ui.ctx());
    let gestures = |ui: &mut Ui| {
        ui.label(RichText::new(tr("Fingers")).heading());
        for (gesture, doing) in GESTURES {
            line(ui, tr(gesture), doing);
        }
    };
    if by_fingers {
        gestures(ui);
        ui.label(RichText::new(tr("Keys")).heading());
    }
    for shortcut in table(reach.place) {
        // Those of the timeline only where there is one.
        let of_timeline = matches!(
            shortcut.command,
            Command::Playback(_)
                | Command::Session(SessionCommand::Disturb(_))
                | Command::Session(SessionCommand::Hand(HandCommand::Turn(_)))
        );
        if reach.timeline || !of_timeline {
            line(ui, &named(ui.ctx(), &shortcut.keys), shortcut.doing);
        }
    }
    if let Some((keys, doing)) = screens_line(ui.ctx(), reach) {
        line(ui, &keys, doing);
    }
    for (keys, doing) in OTHERS {
        line(ui, tr(keys), doing);
    }
    match reach.place {
        Host::Window => {}
        Host::Page => {
            line(ui, tr("Esc, then Tab"), tr("Out of the console, to the browser"));
            let back = KeyboardShortcut::new(egui::Modifiers::ALT, Key::ArrowLeft);
            line(ui, &named(ui.ctx(), &back), tr("The browser's own: the page before"));
        }
    }
    if !by_fingers {
        gestures(ui);
    }
}
