//! Entries of a legend: a sample of the line in its colour and style, and its name. A click shows
//! or hides the entry's curve; fingers get all of a legend as one target, which opens the switches as a list.

use egui::{
    Color32, Id, Painter, Popup, PopupCloseBehavior, Pos2, Rect, Response, Role, Sense, Shape,
    Stroke, Ui, WidgetInfo, vec2,
};
use egui_plot::{LineStyle, MarkerShape};

use super::super::theme::{self, Look, Palette};
use crate::base::language::tr;

const SAMPLE: f32 = 18.0;

/// An entry that was drawn.
pub struct LegendEntry {
    /// Where it stands.
    pub response: Response,
    /// Whether it was pressed, here or in the list of its legend.
    pub pressed: bool,
}

/// The legend whose entries are being drawn for fingers: their names, and whether they are hidden.
#[derive(Clone, Default)]
struct Listed {
    entries: Vec<(String, bool)>,
    /// The one that was pressed in the list of the frame before.
    pressed: Option<String>,
}

fn listed() -> Id {
    Id::unique("legend being drawn")
}

/// A legend in as many lines as it needs, `title` for the list of its switches.
pub fn row(ui: &mut Ui, title: &str, add: impl FnOnce(&mut Ui)) {
    if !theme::fingers(ui.ctx()) {
        ui.horizontal_wrapped(add);
        return;
    }
    let id = ui.scope_id().with(("legend", title));
    let pressed = ui.data_mut(|data| data.remove_temp::<String>(id));
    let begun = Listed { pressed, ..Listed::default() };
    ui.data_mut(|data| data.insert_temp(listed(), begun));
    let row = |ui: &mut Ui| {
        // As low as its text: all of it is the target.
        ui.spacing_mut().interact_size.y = 14.0;
        ui.horizontal_wrapped(add).response.rect
    };
    let rect = ui.scope(row).inner;
    let entries =
        ui.data_mut(|data| data.remove_temp::<Listed>(listed())).unwrap_or_default().entries;
    if entries.is_empty() {
        return;
    }
    let missing = theme::FINGER - rect.height();
    if missing > 0.0 {
        ui.allocate_space(vec2(0.0, missing - ui.spacing().item_spacing.y));
    }
    let target = rect.with_max_y(rect.bottom().max(rect.top() + theme::FINGER));
    let response = ui.interact(target, id, Sense::click());
    let name = tr!("Lines of {title}", title = title);
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, name.clone()));
    let list = Popup::menu(&response).close_behavior(PopupCloseBehavior::CloseOnClickOutside);
    list.show(|ui| {
        for (name, hidden) in entries {
            let mut shown = !hidden;
            if ui.checkbox(&mut shown, &name).changed() {
                ui.data_mut(|data| data.insert_temp(id, name));
            }
        }
    });
}

/// The entry of a line; a click shows or hides it.
pub fn entry(ui: &mut Ui, name: &str, look: Look, hidden: bool) -> LegendEntry {
    let (stroke, style) = look.line(Palette::at(ui));
    let entry = entry_of(ui, name, hidden, stroke.color, |painter, rect, color| {
        line(painter, rect, Stroke { color, ..stroke }, style);
    });
    let help = if hidden { tr("Show this line") } else { tr("Hide this line") };
    LegendEntry { response: entry.response.on_hover_text(help), ..entry }
}

/// The entry of anything that can be shown and hidden: `sample` paints it into a small rectangle
/// in the colour given to it.
pub fn entry_of(
    ui: &mut Ui,
    name: &str,
    hidden: bool,
    color: Color32,
    sample: impl FnOnce(&Painter, Rect, Color32),
) -> LegendEntry {
    let palette = Palette::at(ui);
    let fingers = theme::fingers(ui.ctx());
    let sense = if fingers { Sense::hover() } else { Sense::click() };
    let (rect, response) = named(ui, name, palette.weak, sense);
    if fingers {
        response.widget_info(|| WidgetInfo::labeled(Role::Label, true, name));
    } else {
        response.widget_info(|| WidgetInfo::selected(Role::CheckBox, true, !hidden, name));
    }
    let place = rect.with_max_x(rect.left() + SAMPLE);
    sample(ui.painter(), place, if hidden { palette.line } else { color });
    if hidden {
        // Struck out rather than faint: it is a switch, and must be read.
        let struck = Stroke::new(1.0, palette.weak);
        ui.painter().hline(rect.x_range(), rect.center().y, struck);
    }
    if response.has_focus() {
        let focus = Stroke::new(1.0, palette.accent);
        ui.painter().rect_stroke(rect.expand(2.0), 2.0, focus, egui::StrokeKind::Outside);
    }
    let mut pressed = response.clicked();
    if fingers && ui.is_visible() {
        ui.data_mut(|data| {
            let list = data.get_temp_mut_or_default::<Listed>(listed());
            pressed |= list.pressed.as_deref() == Some(name);
            list.entries.push((name.to_owned(), hidden != pressed));
        });
    }
    LegendEntry { response, pressed }
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

/// The name of points that are always shown, beside one of them as the plot draws it.
pub fn points(ui: &mut Ui, name: &str, color: Color32, shape: MarkerShape) -> Response {
    sample_of(ui, name, color, |painter, rect, color| {
        painter.extend(point(rect.center(), shape, color));
    })
}

/// A point as plots draw it.
fn point(at: Pos2, shape: MarkerShape, color: Color32) -> Vec<Shape> {
    /// Half the size of a point, points.
    const HALF: f32 = 4.5;
    let place = |[x, y]: [f32; 2]| at + HALF * vec2(x, y);
    let filled = |corners: &[[f32; 2]]| {
        let corners = corners.iter().map(|corner| place(*corner)).collect();
        vec![Shape::convex_polygon(corners, color, Stroke::NONE)]
    };
    let bars = |bars: &[[f32; 2]]| -> Vec<Shape> {
        let bar = |end: &[f32; 2]| {
            let ends = [place(*end), place(end.map(|x| -x))];
            Shape::line_segment(ends, Stroke::new(1.6, color))
        };
        bars.iter().map(bar).collect()
    };
    match shape {
        MarkerShape::Circle => vec![Shape::circle_filled(at, 0.85 * HALF, color)],
        MarkerShape::Diamond => filled(&[[0.0, -1.1], [1.1, 0.0], [0.0, 1.1], [-1.1, 0.0]]),
        MarkerShape::Square => filled(&[[-0.8, -0.8], [0.8, -0.8], [0.8, 0.8], [-0.8, 0.8]]),
        MarkerShape::Cross => bars(&[[0.8, 0.8], [0.8, -0.8]]),
        MarkerShape::Plus => bars(&[[1.0, 0.0], [0.0, 1.0]]),
        MarkerShape::Up => filled(&[[0.0, -1.0], [0.9, 0.6], [-0.9, 0.6]]),
        MarkerShape::Down => filled(&[[0.0, 1.0], [0.9, -0.6], [-0.9, -0.6]]),
        MarkerShape::Left => filled(&[[-1.0, 0.0], [0.6, -0.9], [0.6, 0.9]]),
        MarkerShape::Right => filled(&[[1.0, 0.0], [-0.6, -0.9], [-0.6, 0.9]]),
        MarkerShape::Asterisk => bars(&[[0.0, 1.0], [0.87, 0.5], [0.87, -0.5]]),
    }
}

/// Whether an entry with this name stands in one line of the row.
#[must_use]
pub fn has_room(ui: &Ui, name: &str) -> bool {
    let font = egui::TextStyle::Small.resolve(ui.style());
    let text = ui.painter().layout_no_wrap(name.to_owned(), font, Color32::PLACEHOLDER);
    text.size().x <= widest(ui)
}

/// Most that a name is wide in a line, points.
fn widest(ui: &Ui) -> f32 {
    (ui.max_rect().width() - SAMPLE - 4.0).max(SAMPLE)
}

/// Writes a name with room for a sample at its left.
fn named(ui: &mut Ui, name: &str, ink: Color32, sense: Sense) -> (Rect, Response) {
    let font = egui::TextStyle::Small.resolve(ui.style());
    // A name that is longer than the row goes on in the next line: nothing makes the screen wider than it is.
    let text = ui.painter().layout(name.to_owned(), font, ink, widest(ui));
    let size = vec2(SAMPLE + 4.0 + text.size().x, text.size().y.max(14.0));
    let (rect, response) = ui.allocate_exact_size(size, sense);
    let at = rect.right_center() - vec2(text.size().x, 0.5 * text.size().y);
    ui.painter().galley(at, text, ink);
    (rect, response)
}

fn line(painter: &Painter, rect: Rect, stroke: Stroke, style: LineStyle) {
    let ends = [rect.left_center(), rect.right_center()];
    painter.extend(match style {
        LineStyle::Solid => vec![Shape::line_segment(ends, stroke)],
        LineStyle::Dashed { length } => Shape::dashed_line(&ends, stroke, length.min(6.0), 3.0),
        LineStyle::Dotted { spacing } => {
            Shape::dotted_line(&ends, stroke.color, spacing, stroke.width * 0.7)
        }
    });
}
