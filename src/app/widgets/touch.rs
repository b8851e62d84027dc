//! A finger that begins on a slider or a field may want to scroll: only a drag that goes across more than
//! along changes a value, everything else scrolls what the widget stands in.

use egui::style::ScrollAnimation;
use egui::{Id, Pos2, Response, Ui, vec2};

use super::zoom::by_touch;

/// Least width and height of what a finger is to hit, points.
pub const TARGET: f32 = 44.0;
/// Way of a finger before it is known where it goes, points.
const DECIDED_AFTER: f32 = 8.0;
/// How much more it has to go across than along to change a value.
const ACROSS: f32 = 1.5;

/// A finger on its way.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Swipe {
    /// Where it began.
    from: Pos2,
    /// Whether it goes across; none while that is open.
    across: Option<bool>,
}

impl Swipe {
    fn to(self, at: Pos2) -> Self {
        let way = at - self.from;
        let decided = || way.length() > DECIDED_AFTER;
        let across = self.across.or_else(|| decided().then(|| way.x.abs() > ACROSS * way.y.abs()));
        Self { across, ..self }
    }
}

/// The swipe that is going on or has just ended.
fn swipe(ui: &Ui) -> Swipe {
    let id = Id::unique("swipe");
    let before = ui.data(|data| data.get_temp::<Swipe>(id));
    let (from, at, began) = ui.input(|input| {
        let pointer = &input.pointer;
        (pointer.press_origin(), pointer.latest_pos(), pointer.any_pressed())
    });
    let now = match (from, at, before) {
        (Some(from), Some(at), Some(before)) if before.from == from => before.to(at),
        (Some(from), Some(at), _) => Swipe { from, across: None }.to(at),
        // Lifted in this frame; or put down as well, which is a tap.
        (_, _, Some(before)) if !began => before,
        (_, _, _) => Swipe::default(),
    };
    if before != Some(now) {
        ui.data_mut(|data| data.insert_temp(id, now));
    }
    now
}

/// Gives a slider or field back the value `before` that it had, unless it is dragged across, by the mouse, or
/// changed by keys; a finger that goes along scrolls.
pub fn only_across<T>(ui: &Ui, response: &Response, value: &mut T, before: T) {
    let held = response.is_pointer_button_down_on() || response.dragged();
    let let_go = response.drag_stopped() || response.clicked();
    if !by_touch(ui) || !(held || let_go) {
        return;
    }
    let swipe = swipe(ui);
    if swipe.across == Some(true) {
        return;
    }
    *value = before;
    if swipe.across == Some(false) && held {
        let delta = vec2(0.0, ui.input(|input| input.pointer.delta().y));
        ui.scroll_with_delta_animation(delta, ScrollAnimation::none());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::pos2;

    #[test]
    fn a_swipe_is_decided_once_and_across_only_where_it_is_mostly_so() {
        let begun = Swipe { from: pos2(100.0, 100.0), across: None };
        assert_eq!(begun.to(pos2(103.0, 104.0)).across, None);
        assert_eq!(begun.to(pos2(115.0, 400.0)).across, Some(false));
        assert_eq!(begun.to(pos2(110.0, 109.0)).across, Some(false));
        let across = begun.to(pos2(112.0, 103.0));
        assert_eq!(across.across, Some(true));
        assert_eq!(across.to(pos2(112.0, 300.0)).across, Some(true), "it stays so");
    }
}
