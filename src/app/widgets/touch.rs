//! A finger that begins on a slider or a field may want to scroll: only a drag that goes across more than
//! along changes a value, everything else scrolls what the widget stands in. And what is pressed has room for
//! a finger.

use egui::style::ScrollAnimation;
use egui::text::{LayoutJob, TextWrapping};
use egui::{
    Button, Grid, Id, Label, Pos2, Response, Role, TextStyle, Ui, Vec2, WidgetInfo, WidgetText,
    pos2, vec2,
};

use super::super::theme;
use super::focus::pointer_only;
use super::zoom::by_touch;

/// Way of a finger before it is known where it goes, points.
const DECIDED_AFTER: f32 = 8.0;
/// How much more it has to go across than along to change a value.
const ACROSS: f32 = 1.5;

/// A finger on its way.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Swipe {
    /// Where it began.
    from: Pos2,
    /// When, s: the next one may begin at the very same place.
    since_s: f64,
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
        let from = pointer.press_origin().zip(pointer.press_start_time());
        (from, pointer.latest_pos(), pointer.any_pressed())
    });
    let now = match (from, at, before) {
        (Some(begin), Some(at), Some(before)) if (before.from, before.since_s) == begin => {
            before.to(at)
        }
        (Some((from, since_s)), Some(at), _) => Swipe { from, since_s, across: None }.to(at),
        // Lifted in this frame; or put down as well, which is a tap.
        (_, _, Some(before)) if !began => before,
        (_, _, _) => Swipe::default(),
    };
    if before != Some(now) {
        ui.data_mut(|data| data.insert_temp(id, now));
    }
    now
}

/// Rows of a table may be so low, points, but for fingers that press what stands in them.
pub fn low_rows(ui: &mut Ui, height: f32) {
    if !theme::fingers(ui.ctx()) {
        ui.spacing_mut().interact_size.y = height;
    }
}

/// Least size of a button whose text is short: none, but for fingers.
#[must_use]
pub fn least(ui: &Ui) -> Vec2 {
    if theme::fingers(ui.ctx()) { Vec2::splat(theme::FINGER) } else { Vec2::ZERO }
}

/// A choice of several, for [`least`].
pub fn choice(ui: &mut Ui, chosen: bool, text: impl Into<WidgetText>) -> Response {
    let least = least(ui);
    ui.add(Button::selectable(chosen, text.into()).min_size(least))
}

/// A table with rows as high as what stands in them.
pub fn grid(ui: &Ui, id: impl egui::AsIdSalt) -> Grid {
    /// Least height of a row where fingers would have it higher, points.
    const ROW: f32 = 18.0;
    let grid = Grid::new(id);
    if theme::fingers(ui.ctx()) { grid.min_row_height(ROW) } else { grid }
}

/// A button that is small beside others, but for fingers.
pub fn small<'a>(ui: &Ui, button: Button<'a>) -> Button<'a> {
    if theme::fingers(ui.ctx()) { button.min_size(least(ui)) } else { button.small() }
}

/// The name of a setting at its left, which is pressed for its menu: as high as what stands beside it.
pub fn name(ui: &mut Ui, text: &str) -> Response {
    if !theme::fingers(ui.ctx()) {
        return ui.add(Label::new(text).truncate().sense(pointer_only(false)));
    }
    let font = TextStyle::Body.resolve(ui.style());
    let color = ui.visuals().text_color();
    let mut job = LayoutJob::simple_singleline(text.to_owned(), font, color);
    job.wrap = TextWrapping::truncate_at_width(ui.available_width());
    let galley = ui.painter().layout_job(job);
    let least = ui.spacing().interact_size;
    let (rect, response) = ui.allocate_exact_size(galley.size().max(least), pointer_only(false));
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, text));
    let at = pos2(rect.left(), rect.center().y - 0.5 * galley.size().y);
    ui.painter().galley(at, galley, color);
    response
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

/// Hands the swipe of a finger that goes along, over an area that is only scrolled across, on to what it stands in;
/// `area` is the id of the area.
pub fn hand_on(ui: &Ui, area: Id) {
    if !by_touch(ui) || ui.ctx().dragged_id() != Some(area.with("area")) {
        return;
    }
    if swipe(ui).across == Some(false) {
        let delta = vec2(0.0, ui.input(|input| input.pointer.delta().y));
        ui.scroll_with_delta_animation(delta, ScrollAnimation::none());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_swipe_is_decided_once_and_across_only_where_it_is_mostly_so() {
        let begun = Swipe { from: pos2(100.0, 100.0), since_s: 1.0, across: None };
        assert_eq!(begun.to(pos2(103.0, 104.0)).across, None);
        assert_eq!(begun.to(pos2(115.0, 400.0)).across, Some(false));
        assert_eq!(begun.to(pos2(110.0, 109.0)).across, Some(false));
        let across = begun.to(pos2(112.0, 103.0));
        assert_eq!(across.across, Some(true));
        assert_eq!(across.to(pos2(112.0, 300.0)).across, Some(true), "it stays so");
    }
}
