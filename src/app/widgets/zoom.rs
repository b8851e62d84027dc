//! How a range of time is chosen in a chart: with the mouse it is dragged over; fingers that drag
//! scroll the page, and two of them zoom.

use egui::Ui;

use super::super::theme::Palette;

/// Whether the last pointer was a finger rather than a mouse. A mouse shows itself by moving with
/// no button down, which it does before every drag; until then the drags belong to the page, for
/// what takes a drag is settled before the finger is seen.
#[must_use]
pub fn by_touch(ui: &Ui) -> bool {
    let id = egui::Id::unique("by touch");
    let before = ui.data(|data| data.get_temp(id)).unwrap_or(true);
    let now = ui.input(|input| {
        let has = |of: fn(&egui::Event) -> bool| input.events.iter().any(of);
        let touched = has(|event| matches!(event, egui::Event::Touch { .. }));
        let moved = has(|event| matches!(event, egui::Event::PointerMoved(_)));
        touched || (before && (!moved || input.pointer.any_down()))
    });
    if now != before {
        ui.data_mut(|data| data.insert_temp(id, now));
    }
    now
}

/// The range of the horizontal axis that the user has just zoomed to: dragged over, or zoomed with
/// wheel or fingers. `drag` keeps where a drag over a range began, in points.
pub fn zoom(
    ui: &Ui,
    plot: &egui_plot::PlotResponse<()>,
    range: [f64; 2],
    drag: &mut Option<f32>,
) -> Option<[f64; 2]> {
    /// A drag over less is a click with a trembling hand, points.
    const LEAST: f32 = 6.0;
    let response = &plot.response;
    let frame = *plot.transform.frame();
    if by_touch(ui) {
        *drag = None;
    } else if response.drag_started() {
        *drag = ui.input(|input| input.pointer.press_origin()).map(|at| at.x);
    }
    if let (Some(from), Some(to)) = (*drag, response.interact_pointer_pos()) {
        let ends = [from.min(to.x), from.max(to.x)].map(|x| frame.x_range().clamp(x));
        if response.drag_stopped() {
            *drag = None;
            let time = |x: f32| plot.transform.value_from_position(egui::pos2(x, frame.top())).x;
            return (ends[1] - ends[0] >= LEAST).then(|| ends.map(time));
        } else if response.dragged() {
            let [left, right] = ends.map(|x| egui::pos2(x, frame.top()));
            let marked = egui::Rect::from_min_max(left, egui::pos2(right.x, frame.bottom()));
            let color = Palette::at(ui).accent;
            ui.painter().rect_filled(marked, 0.0, color.gamma_multiply(0.2));
        }
    }
    // What differs from what was asked for is the zoom of wheel or fingers.
    let bounds = plot.transform.bounds().range_x();
    let now = [*bounds.start(), *bounds.end()];
    let off = 1e-6 * (range[1] - range[0]);
    let differs = (now[0] - range[0]).abs() > off || (now[1] - range[1]).abs() > off;
    differs.then_some(now)
}
