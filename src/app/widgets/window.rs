//! A window over a screen: it can be moved on the desktop and takes the screen of a phone; Escape
//! closes it.

use egui::{
    Align, Button, Context, Id, Key, Label, Layout, Modifiers, Rect, RichText, ScrollArea, Ui,
    Vec2, vec2,
};

use super::super::theme;
use super::icon::{self, Icon};
use super::touch;
use crate::base::language::tr;

/// Where a window may stand.
#[derive(Clone, Copy, Debug)]
pub struct WindowPlace {
    /// The rectangle of the screen that it is over.
    pub screen: Rect,
    /// Whether that is as narrow as a phone's.
    pub narrow: bool,
    /// Width and height of its content at first, points.
    pub size: [f32; 2],
    /// Share of a phone's screen that it takes, from below: what it acts on stays in sight above.
    pub share: f32,
}

fn shown_id() -> Id {
    Id::unique("a window is shown")
}

/// Whether a window was shown in this frame or the last: Escape is for it, before what lies around it.
#[must_use]
pub fn is_shown(ctx: &Context) -> bool {
    let last = ctx.data(|data| data.get_temp::<u64>(shown_id()));
    last.is_some_and(|last| last + 1 >= ctx.cumulative_frame_nr())
}

/// Shows the window `title`, in English, while it is `open`.
pub fn show(
    ctx: &Context,
    title: &str,
    place: WindowPlace,
    open: &mut bool,
    body: impl FnOnce(&mut Ui),
) {
    /// Height of the title with its margins, points.
    const TITLE: f32 = 44.0;
    /// Distance from the screen's top at most, points.
    const LOWER: f32 = 84.0;
    /// Least size of the content, points.
    const LEAST: Vec2 = vec2(160.0, 80.0);
    if !*open {
        return;
    }
    let frame = ctx.cumulative_frame_nr();
    ctx.data_mut(|data| data.insert_temp(shown_id(), frame));
    if !ctx.egui_wants_keyboard_input()
        && ctx.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Escape))
    {
        *open = false;
    }
    let fingers = theme::fingers(ctx);
    // The same window in every language.
    let window = egui::Window::new(tr(title)).id(Id::unique(title));
    let window = window.collapsible(false).vscroll(!fingers);
    let screen = place.screen;
    let window = if place.narrow {
        let taken = screen.with_min_y(screen.bottom() - place.share * screen.height());
        let size = (taken.size() - vec2(14.0, TITLE + 4.0)).max(LEAST);
        window.resizable(false).fixed_pos(taken.min).fixed_size(size)
    } else {
        let [width, height] = place.size;
        let width = width.min(screen.width() - 16.0);
        let height = height.min(screen.height() - TITLE - 8.0).max(LEAST.y);
        // Below the head of the screen where there is room.
        let top = (screen.height() - height - TITLE).clamp(4.0, LOWER);
        let at = screen.min + vec2(theme::CONTROLS_WIDTH + 40.0, top);
        window.default_pos(at).default_size(vec2(width, height)).constrain_to(screen)
    };
    closable(ctx, title, window, None, open, |ui| {
        if fingers {
            // What is too wide for a phone is moved across.
            ScrollArea::both().auto_shrink([false, true]).show(ui, body);
        } else {
            body(ui);
        }
    });
}

/// Shows no more of the window `title`, in English, than a line at the foot of the screen, while it is `open`: what it says, a
/// button, and the one that closes it. Whether the button was pressed.
pub fn line(
    ctx: &Context,
    title: &str,
    place: WindowPlace,
    open: &mut bool,
    (said, button): (&str, &str),
) -> bool {
    /// Height of the line with its margins, points.
    const LINE: f32 = 62.0;
    let mut pressed = false;
    if !*open {
        return pressed;
    }
    let taken = place.screen.with_min_y(place.screen.bottom() - LINE);
    let size = vec2(taken.width() - 14.0, LINE - 18.0);
    let window = egui::Window::new(tr(title)).id(Id::unique(format!("line of {title}")));
    let window = window.title_bar(false).collapsible(false).resizable(false);
    window.fixed_pos(taken.min).fixed_size(size).show(ctx, |ui| {
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let name = tr("Close window");
            *open &= !icon::button(ui, Icon::Close, name, name, true).clicked();
            pressed = ui.add(Button::new(button).min_size(touch::least(ui))).clicked();
            let said = Label::new(RichText::new(said)).truncate();
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| ui.add(said));
        });
    });
    pressed
}

/// Shows a window `width` points wide while it is `open`, with a button that closes it and is large enough
/// for a finger where one presses.
pub fn closable(
    ctx: &Context,
    title: &str,
    window: egui::Window<'_>,
    width: Option<f32>,
    open: &mut bool,
    body: impl FnOnce(&mut Ui),
) {
    let sized = |ui: &mut Ui| width.into_iter().for_each(|width| ui.set_width(width));
    if !theme::fingers(ctx) {
        window.open(open).show(ctx, |ui| {
            sized(ui);
            body(ui);
        });
        return;
    }
    if !*open {
        return;
    }
    window.title_bar(false).show(ctx, |ui| {
        sized(ui);
        ui.horizontal(|ui| {
            ui.heading(tr(title));
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                let name = tr("Close window");
                *open &= !icon::button(ui, Icon::Close, name, name, true).clicked();
            });
        });
        body(ui);
    });
}
