//! What the screens are built on: settings beside the rest where there is room, one scrolled column
//! where there is none, and the time that a frame stands for.

use egui::scroll_area::{DragScroll, ScrollSource};
use egui::{
    Align, AsIdSalt, CentralPanel, Context, Frame, Id, Layout, Margin, Panel as SidePanel, Rect,
    ScrollArea, Ui, UiBuilder,
};

use super::super::theme;
use super::touch;
use super::zoom::by_touch;

/// Most real time that one frame stands for, s: after a pause of the machine all goes on where it was.
const LONGEST_FRAME_S: f64 = 0.25;

/// The real time that this frame stands for, s.
#[must_use]
pub fn frame_s(ctx: &Context) -> f64 {
    ctx.input(|input| f64::from(input.stable_dt)).min(LONGEST_FRAME_S)
}

/// The margin of a part of a wide screen.
pub fn wide() -> Frame {
    Frame::new().inner_margin(Margin::symmetric(12, 8))
}

/// The margin of a narrow screen.
pub fn narrow() -> Frame {
    Frame::new().inner_margin(Margin::symmetric(8, 4))
}

/// The settings at the left of a wide screen, scrolled by themselves.
pub fn controls(ui: &mut Ui, id: &'static str, add: impl FnOnce(&mut Ui)) {
    let panel = SidePanel::left(id).exact_size(theme::CONTROLS_WIDTH);
    panel.resizable(false).frame(wide()).show(ui, |ui| {
        ScrollArea::vertical().auto_shrink([false, false]).show(ui, add);
    });
}

/// The same without a scroll of its own: for what has a foot.
pub fn controls_unscrolled(ui: &mut Ui, id: &'static str, add: impl FnOnce(&mut Ui)) {
    let panel = SidePanel::left(id).exact_size(theme::CONTROLS_WIDTH);
    panel.resizable(false).frame(wide()).show(ui, add);
}

/// A part at the foot of what is left, as high as it was in the frame before: it is drawn, and Tab comes to it, after
/// what stands above it, and stays where it is however long that is.
pub struct Foot {
    id: Id,
    rect: Rect,
    /// Height of all that there was room in.
    most: f32,
}

impl Foot {
    /// At the foot of `left`, of which it takes its room.
    pub fn of(ui: &Ui, left: &mut Rect, id: &'static str) -> Self {
        let id = Id::unique(id);
        let height = ui.data(|data| data.get_temp::<f32>(id)).unwrap_or(0.0);
        let (whole, gap) = (*left, ui.spacing().item_spacing.y);
        let top = (whole.bottom() - height).max(whole.top());
        if height > 0.0 {
            left.max.y = (top - gap).max(whole.top());
        }
        let rect = Rect::from_min_max(egui::pos2(whole.left(), top), whole.right_bottom());
        Self { id, rect, most: whole.height() }
    }

    /// Draws it.
    pub fn show<T>(self, ui: &mut Ui, add: impl FnOnce(&mut Ui) -> T) -> T {
        let layout = Layout::top_down(Align::Min);
        // As much as there is: how high it is, it says itself.
        let room = Rect::from_min_size(self.rect.min, egui::vec2(self.rect.width(), self.most));
        let mut foot = ui.new_child(UiBuilder::new().max_rect(room).layout(layout));
        if self.rect.height() <= 0.0 {
            // It has no place yet.
            foot.set_invisible();
        }
        let given = add(&mut foot);
        let height = foot.min_rect().height();
        if (height - self.rect.height()).abs() > 0.5 {
            ui.data_mut(|data| data.insert_temp(self.id, height));
            ui.ctx().request_repaint();
        }
        given
    }
}

/// What is left of a wide screen beside its panels.
pub fn middle(ui: &mut Ui, add: impl FnOnce(&mut Ui)) {
    CentralPanel::no_frame().frame(wide()).show(ui, add);
}

/// A column that is scrolled: fingers scroll it from the first touch on; the drags of a mouse belong to
/// what stands in it.
pub fn column(ui: &Ui, id: impl AsIdSalt) -> ScrollArea {
    let drag = if by_touch(ui) { DragScroll::Always } else { DragScroll::Never };
    let source = ScrollSource { drag, ..ScrollSource::default() };
    ScrollArea::vertical().id_salt(id).scroll_source(source).auto_shrink([false, false])
}

/// What may be wider than its room, and is moved across then: a finger that goes along scrolls the page.
pub fn across(ui: &mut Ui, id: impl AsIdSalt, add: impl FnOnce(&mut Ui)) {
    let output = ScrollArea::horizontal().id_salt(id).show(ui, add);
    touch::hand_on(ui, output.id);
}
