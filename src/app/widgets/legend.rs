//! A clickable entry of a legend: a sample of the line in its colour and style, and its name.

use egui::{Response, Role, Sense, Stroke, Ui, WidgetInfo};
use egui_plot::LineStyle;

use super::super::theme::{Look, Palette};

const SAMPLE: f32 = 18.0;

/// The entry; a click shows or hides the line.
pub fn entry(ui: &mut Ui, name: &str, look: Look, hidden: bool) -> Response {
    let palette = Palette::at(ui);
    let (stroke, style) = look.line(palette);
    let font = egui::TextStyle::Small.resolve(ui.style());
    let color = if hidden { palette.line } else { palette.weak };
    let text = ui.painter().layout_no_wrap(name.to_owned(), font, color);
    let size = egui::vec2(SAMPLE + 4.0 + text.size().x, text.size().y.max(14.0));
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    response.widget_info(|| WidgetInfo::selected(Role::CheckBox, true, !hidden, name));
    let stroke = Stroke { color: if hidden { palette.line } else { stroke.color }, ..stroke };
    let ends = [rect.left_center(), rect.left_center() + egui::vec2(SAMPLE, 0.0)];
    let shapes = match style {
        LineStyle::Solid => vec![egui::Shape::line_segment(ends, stroke)],
        LineStyle::Dashed { length } => {
            egui::Shape::dashed_line(&ends, stroke, length.min(6.0), 3.0)
        }
        LineStyle::Dotted { spacing } => {
            egui::Shape::dotted_line(&ends, stroke.color, spacing, stroke.width * 0.7)
        }
    };
    ui.painter().extend(shapes);
    let at = rect.right_center() - egui::vec2(text.size().x, 0.5 * text.size().y);
    ui.painter().galley(at, text, color);
    if response.has_focus() {
        let focus = Stroke::new(1.0, palette.accent);
        ui.painter().rect_stroke(rect.expand(2.0), 2.0, focus, egui::StrokeKind::Outside);
    }
    let doing = if hidden { "Show" } else { "Hide" };
    response.on_hover_text(format!("{doing} this line"))
}
