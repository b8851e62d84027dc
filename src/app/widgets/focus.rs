//! Where Tab goes on: from nowhere it goes to the first control of the screen, which is what is used most, and
//! from its last one to the bar around it. A number that was ended with Enter, and a slider that was dragged, have the focus no
//! more, so that the keys go to the playhead; the next Tab goes on from there all the same.

use egui::{Context, FocusDirection, Id, Key, Rect, Response, Sense, Ui};

fn place() -> Id {
    Id::unique("where tab goes on")
}

/// Clicks, and drags as well, without being a stop of Tab: for what the keyboard reaches in another way.
#[must_use]
pub fn pointer_only(drags: bool) -> Sense {
    if drags { Sense::CLICK | Sense::DRAG } else { Sense::CLICK }
}

fn start() -> Id {
    Id::unique("start of the screen")
}

/// To be called before the controls of a screen: from nowhere, Tab goes on to the first of them.
pub fn begin_screen(ui: &Ui) {
    // A stop only while Tab passes it: nobody shall rest on it.
    if ui.memory(|memory| memory.has_focus(start())) {
        let nothing = Rect::from_min_size(ui.max_rect().min, egui::Vec2::ZERO);
        ui.interact(nothing, start(), Sense::FOCUSABLE);
    }
}

/// Takes the focus from a widget; the next Tab goes on from it.
pub fn leave(response: &Response) {
    response.surrender_focus();
    remember(response);
}

/// The next Tab goes on from a widget that has just lost the focus.
pub fn remember(response: &Response) {
    response.ctx.data_mut(|data| data.insert_temp(place(), response.id));
}

/// Lets Tab go on from the widget that was left last; to be called before the widgets of a frame. It has the
/// focus for one frame, and gives it on in the next.
pub fn resume(ctx: &Context) {
    let focused = ctx.memory(|memory| memory.focused());
    let waiting = Id::unique("tab that waits");
    if let Some(back) = ctx.data_mut(|data| data.remove_temp::<bool>(waiting)) {
        // Escape, pressed since, wants the focus nowhere.
        if ctx.input(|input| input.key_pressed(Key::Escape)) {
            return ctx.memory_mut(|memory| memory.move_focus(FocusDirection::None));
        }
        let direction = if back { FocusDirection::Previous } else { FocusDirection::Next };
        return ctx.memory_mut(|memory| memory.move_focus(direction));
    }
    let left = ctx.data(|data| data.get_temp::<Id>(place())).unwrap_or_else(start);
    let (pressed, back) = ctx.input(|input| {
        let plain = !input.modifiers.command && !input.modifiers.alt;
        (plain && input.key_pressed(Key::Tab), input.modifiers.shift)
    });
    if focused.is_none() && pressed {
        ctx.memory_mut(|memory| {
            memory.move_focus(FocusDirection::None);
            memory.request_focus(left);
        });
        ctx.data_mut(|data| data.insert_temp(waiting, back));
        ctx.request_repaint();
    }
    if focused.is_some() || pressed {
        ctx.data_mut(|data| data.remove::<Id>(place()));
    }
}
