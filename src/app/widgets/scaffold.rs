//! What the screens are built on: settings beside the rest where there is room, one scrolled column
//! where there is none, and the time that a frame stands for.

use egui::scroll_area::{DragScroll, ScrollSource};
use egui::{CentralPanel, Context, Frame, Margin, Panel as SidePanel, ScrollArea, Ui};

use super::super::theme;
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

/// What is left of a wide screen beside its panels.
pub fn middle(ui: &mut Ui, add: impl FnOnce(&mut Ui)) {
    CentralPanel::no_frame().frame(wide()).show(ui, add);
}

/// A column that is scrolled: fingers scroll it from the first touch on; the drags of a mouse belong to
/// what stands in it.
pub fn column(ui: &Ui, id: &str) -> ScrollArea {
    let drag = if by_touch(ui) { DragScroll::Always } else { DragScroll::Never };
    let source = ScrollSource { drag, ..ScrollSource::default() };
    ScrollArea::vertical().id_salt(id).scroll_source(source).auto_shrink([false, false])
}
