//! Entries of a legend: a sample of the line in its colour and style, and its name. A click shows
//! or hides the entry's curve.

use egui::{Color32, Painter, Rect, Response, Role, Sense, Stroke, Ui, WidgetInfo};
use egui_plot::LineStyle;

use super::super::theme::{Look, Palette};

const SAMPLE: f32 = 18.0;

/// The entry of a line; a click shows or hides it.
pub fn entry(ui: &mut Ui, name: &str, look: Look, hidden: bool) -> Response {
    let (stroke, style) = look.line(Palette::at(ui));
    let response = entry_of(ui, name, hidden, stroke.color, |painter, rect, color| {
        line(painter, rect, Stroke { color, ..stroke }, style);
    });
    response.on_hover_text(if hidden { "Show this line" } else { "Hide this line" })
}

/// The entry of anything that can be shown and hidden: `sample` paints it into a small rectangle
/// in the colour given to it.
pub fn entry_of(
    ui: &mut Ui,
    name: &str,
    hidden: bool,
    color: Color32,
    sample: impl FnOnce(&Painter, Rect, Color32),
) -> Response {
    let palette = Palette::at(ui);
    let ink = if hidden { palette.line } else { palette.weak };
    let (rect, response) = named(ui, name, ink, Sense::click());
    response.widget_info(|| WidgetInfo::selected(Role::CheckBox, true, !hidden, name));
    let place = rect.with_max_x(rect.left() + SAMPLE);
    sample(ui.painter(), place, if hidden { palette.line } else { color });
    if response.has_focus() {
        let focus = Stroke::new(1.0, palette.accent);
        ui.painter().rect_stroke(rect.expand(2.0), 2.0, focus, egui::StrokeKind::Outside);
    }
    response
}

/// The name of a line that is always shown.
pub fn sample(ui: &mut Ui, name: &str, look: Look) -> Response {
    let palette = Palette::at(ui);
    let (stroke, style) = look.line(palette);
    let (rect, response) = named(ui, name, palette.weak, Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, name));
    line(ui.painter(), rect.with_max_x(rect.left() + SAMPLE), stroke, style);
    response
}

/// The name of marks that are always shown; `sample` paints one into a small rectangle.
pub fn sample_of(
    ui: &mut Ui,
    name: &str,
    color: Color32,
    sample: impl FnOnce(&Painter, Rect, Color32),
) -> Response {
    let (rect, response) = named(ui, name, Palette::at(ui).weak, Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, name));
    sample(ui.painter(), rect.with_max_x(rect.left() + SAMPLE), color);
    response
}

/// Writes a name with room for a sample at its left.
fn named(ui: &mut Ui, name: &str, ink: Color32, sense: Sense) -> (Rect, Response) {
    let font = egui::TextStyle::Small.resolve(ui.style());
    let text = ui.painter().layout_no_wrap(name.to_owned(), font, ink);
    let size = egui::vec2(SAMPLE + 4.0 + text.size().x, text.size().y.max(14.0));
    let (rect, response) = ui.allocate_exact_size(size, sense);
    let at = rect.right_center() - egui::vec2(text.size().x, 0.5 * text.size().y);
    ui.painter().galley(at, text, ink);
    (rect, response)
}

fn line(painter: &Painter, rect: Rect, stroke: Stroke, style: LineStyle) {
    let ends = [rect.left_center(), rect.right_center()];
    painter.extend(match style {
        LineStyle::Solid => vec![egui::Shape::line_segment(ends, stroke)],
        LineStyle::Dashed { length } => {
            egui::Shape::dashed_line(&ends, stroke, length.min(6.0), 3.0)
        }
        LineStyle::Dotted { spacing } => {
            egui::Shape::dotted_line(&ends, stroke.color, spacing, stroke.width * 0.7)
        }
    });
}
