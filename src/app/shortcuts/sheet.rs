//! The sheet that lists all keys, and what fingers do: it fits the window, and shows that it can be scrolled where it does not.

use egui::{Align2, Context, Key, KeyboardShortcut, Label, RichText, ScrollArea, Ui, Vec2, vec2};

use super::{DIGITS, Host, Reach, screen_key, table};
use crate::app::command::Command;
use crate::app::theme;
use crate::app::widgets::window;

/// Largest size of its content, points, and what its title and the edges of the window take.
const LARGEST: Vec2 = vec2(440.0, 620.0);
/// See [`LARGEST`].
const AROUND: Vec2 = vec2(40.0, 72.0);
/// Width of the keys' names, points, and where it is narrow.
const NAMES: [f32; 2] = [170.0, 120.0];

/// What is done without a key of the table.
const OTHERS: [(&str, &str); 7] = [
    ("?", "This sheet"),
    ("Esc", "Close what lies on top"),
    ("Tab, Enter", "The next control; press it, or end a number"),
    ("Arrow keys", "Move the slider that has the focus"),
    ("Double-click on a plot", "Fit"),
    ("Drag on a plot", "Zoom"),
    ("Right-click on a setting", "Back to its default"),
];

/// What fingers do.
const GESTURES: [(&str, &str); 5] = [
    ("Swipe", "Scroll, wherever it begins"),
    ("Drag across", "Move a slider or a number"),
    ("Pinch a plot", "Zoom"),
    ("Double tap a plot", "Fit"),
    ("Long press", "What it means; the menu of a setting"),
];

/// The line of the screens' keys.
fn screens_line(ctx: &Context, reach: &Reach<'_>) -> Option<(String, &'static str)> {
    let count = reach.screens.len();
    let name = |order: usize| screen_key(order, reach.place).map(|keys| ctx.format_shortcut(&keys));
    let last = count.min(DIGITS.len()).checked_sub(1)?;
    let keys = format!("{} … {}", name(0)?, name(last)?);
    let doing = if count > DIGITS.len() {
        "The first screens; the others by their tabs"
    } else {
        "The screens"
    };
    Some((keys, doing))
}

/// Shows the sheet while it is `open`.
pub fn sheet(ctx: &Context, reach: &Reach<'_>, open: &mut bool) {
    let room = ctx.content_rect().size() - AROUND;
    let size = LARGEST.min(room).max(Vec2::splat(80.0));
    let title = "Keys and gestures";
    let window = egui::Window::new(title)
        .collapsible(false)
        .resizable(false)
        .default_size(size)
        .anchor(Align2::CENTER_CENTER, Vec2::ZERO);
    window::closable(ctx, title, window, Some(size.x), open, |ui| {
        ui.spacing_mut().scroll = theme::solid_bars();
        let area = ScrollArea::vertical().max_height(size.y).auto_shrink([false, true]);
        area.show(ui, |ui| lines(ui, reach));
    });
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
            ui.add(Label::new(doing).wrap());
        });
    };
    // What is at hand comes first.
    let by_fingers = theme::fingers(ui.ctx());
    let gestures = |ui: &mut Ui| {
        ui.label(RichText::new("Fingers").heading());
        for (gesture, doing) in GESTURES {
            line(ui, gesture, doing);
        }
    };
    if by_fingers {
        gestures(ui);
        ui.label(RichText::new("Keys").heading());
    }
    for shortcut in table(reach.place) {
        // Those of the timeline only where there is one.
        if reach.timeline || !matches!(shortcut.command, Command::Playback(_)) {
            line(ui, &ui.ctx().format_shortcut(&shortcut.keys), shortcut.doing);
        }
    }
    if let Some((keys, doing)) = screens_line(ui.ctx(), reach) {
        line(ui, &keys, doing);
    }
    for (keys, doing) in OTHERS {
        line(ui, keys, doing);
    }
    match reach.place {
        Host::Window => {}
        Host::Page => {
            line(ui, "Esc, then Tab", "Out of the console, to the browser");
            let back = KeyboardShortcut::new(egui::Modifiers::ALT, Key::ArrowLeft);
            line(ui, &ui.ctx().format_shortcut(&back), "The browser's own: the page before");
        }
    }
    if !by_fingers {
        gestures(ui);
    }
}
