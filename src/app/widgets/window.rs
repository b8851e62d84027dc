//! A window over a screen: it can be moved on the desktop and takes the screen of a phone; Escape
//! closes it.

use egui::{Context, Key, Modifiers, Rect, Ui, Vec2, vec2};

use super::super::theme;

/// Where a window may stand.
#[derive(Clone, Copy, Debug)]
pub struct WindowPlace {
    /// The rectangle of the screen that it is over.
    pub screen: Rect,
    /// Whether that is as narrow as a phone's.
    pub narrow: bool,
    /// Height of its content at first, points.
    pub height: f32,
}

/// Shows the window `title` while it is `open`.
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
    if !ctx.egui_wants_keyboard_input()
        && ctx.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Escape))
    {
        *open = false;
    }
    let window = egui::Window::new(title).open(open).collapsible(false).vscroll(true);
    let screen = place.screen;
    let window = if place.narrow {
        let size = (screen.size() - vec2(14.0, TITLE + 4.0)).max(LEAST);
        window.resizable(false).fixed_pos(screen.min).fixed_size(size)
    } else {
        let width = theme::OVERLAY_WIDTH.min(screen.width() - 16.0);
        let height = place.height.min(screen.height() - TITLE - 8.0).max(LEAST.y);
        // Below the head of the screen where there is room.
        let top = (screen.height() - height - TITLE).clamp(4.0, LOWER);
        let at = screen.min + vec2(theme::CONTROLS_WIDTH + 40.0, top);
        window.default_pos(at).default_size(vec2(width, height)).constrain_to(screen)
    };
    window.show(ctx, body);
}
