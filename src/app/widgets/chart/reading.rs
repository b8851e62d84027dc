//! The value of a signal at the playhead, as a number beside the title of its chart.

use egui::{Role, Sense, Ui, WidgetInfo, vec2};

use super::content::{ChartCurve, index};
use crate::app::format;
use crate::app::theme::{self, Palette};
use crate::base::language::tr;
use crate::run::signals::{Row, SIGNALS, flag};

/// Its width grows in these steps, points, so that its neighbours do not move while digits change.
const WIDTH_STEP: f32 = 24.0;

/// The value of a curve in a row, in the curve's colour.
pub(super) fn reading(ui: &mut Ui, curve: &ChartCurve, row: &Row, write: fn(f64, &str) -> String) {
    let signal = &SIGNALS[index(curve.signal)];
    // In the air there is no force either.
    let text = match (signal.value)(row) {
        None => format::none(row).to_owned(),
        Some(_) if row.has(flag::AIR) && matches!(signal.unit, "um" | "N") => "-".to_owned(),
        Some(value) => format::continued(write(value, signal.unit), row, curve.signal),
    };
    let (stroke, _) = curve.look.line(Palette::at(ui));
    let font = theme::value().resolve(ui.style());
    let galley = ui.painter().layout_no_wrap(text.clone(), font, stroke.color);
    let width = (galley.size().x / WIDTH_STEP).ceil() * WIDTH_STEP;
    let (rect, response) = ui.allocate_exact_size(vec2(width, galley.size().y), Sense::hover());
    let said = tr!("{signal} at the playhead: {value}", signal = tr(signal.label), value = text);
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, said.clone()));
    // Twice, a pixel apart: the fonts have no bold cut.
    let pixel = 1.0 / ui.pixels_per_point();
    ui.painter().galley(rect.left_top(), galley.clone(), stroke.color);
    ui.painter().galley(rect.left_top() + vec2(pixel, 0.0), galley, stroke.color);
    response.on_hover_text(said);
}
