//! Buttons that drop a disturbance: a painted sign, its name, and what it does.

use egui::{
    Color32, Painter, Rect, Response, Role, Sense, Shape, Stroke, Ui, Vec2, WidgetInfo, pos2, vec2,
};

use super::super::framed;
use super::super::theme;
use crate::base::language::tr;
use crate::models::disturbances::Disturbance;

/// Side of the sign, points.
const SIGN: f32 = 14.0;
/// Room beside it, points.
const GAP: f32 = 4.5;

/// What a kind does, for tooltips.
#[must_use]
pub fn help(kind: Disturbance) -> &'static str {
    let option = Disturbance::OPTIONS.iter().find(|option| option.id == kind.id());
    option.map_or("", |option| tr(option.doc))
}

/// Its name where there is little room.
fn short(kind: Disturbance) -> &'static str {
    match kind {
        Disturbance::DeadTime => tr("Dead time"),
        Disturbance::Operator => tr("Operator"),
        Disturbance::HardSpot
        | Disturbance::Gap
        | Disturbance::DepthStep
        | Disturbance::WearJump
        | Disturbance::BrokenTooth
        | Disturbance::ChatterBurst
        | Disturbance::SensorDropout
        | Disturbance::SensorDrift => tr(kind.label()),
    }
}

/// A button with the sign alone, of this size; its name and what it does stand in the tooltip. Where it is not
/// open it is greyed, and says why.
pub fn sign(ui: &mut Ui, kind: Disturbance, size: Vec2, keys: &str) -> Response {
    let closed = framed::closed(ui.ctx(), kind.path());
    let (rect, response) = ui.allocate_exact_size(size, sense(closed.is_some()));
    let name = tr!("Drop {disturbance}", disturbance = tr(kind.in_text()));
    let enabled = ui.is_enabled() && closed.is_none();
    response.widget_info(|| WidgetInfo::labeled(Role::Button, enabled, &name));
    if ui.is_rect_visible(rect) {
        let visuals = ui.style().interact(&response);
        let (corner, inside) = (visuals.corner_radius, egui::StrokeKind::Inside);
        let painter = ui.painter();
        // Framed as it is pressed or pointed at: eleven frames in a row are more to draw than to see.
        if response.hovered() || response.is_pointer_button_down_on() {
            painter.rect(rect, corner, visuals.weak_bg_fill, visuals.bg_stroke, inside);
        }
        if response.has_focus() {
            painter.rect_stroke(rect, corner, ui.visuals().selection.stroke, inside);
        }
        let square = Rect::from_center_size(rect.center(), Vec2::splat(SIGN));
        let color = greyed(ui, closed.is_some(), visuals.fg_stroke.color);
        paint(painter, kind, square, Stroke::new(1.6, color));
    }
    response.on_hover_text(match closed {
        Some(closed) => format!("{}: {}\n{closed}", tr(kind.label()), help(kind)),
        None => format!("{}{keys}: {}", tr(kind.label()), help(kind)),
    })
}

/// A button of this width; `chosen` where it stays pressed. Where it is not open it is greyed, and says why.
pub fn button(ui: &mut Ui, kind: Disturbance, width: f32, chosen: bool, more: &str) -> Response {
    let closed = framed::closed(ui.ctx(), kind.path());
    let height = ui.spacing().interact_size.y.max(26.0);
    let (rect, response) = ui.allocate_exact_size(vec2(width, height), sense(closed.is_some()));
    let name = tr!("Drop {disturbance}", disturbance = tr(kind.in_text()));
    let enabled = ui.is_enabled() && closed.is_none();
    response.widget_info(|| WidgetInfo::selected(Role::Button, enabled, chosen, &name));
    if ui.is_rect_visible(rect) {
        let visuals = ui.style().interact_selectable(&response, chosen);
        let (corner, stroke) = (visuals.corner_radius, visuals.bg_stroke);
        let inside = egui::StrokeKind::Inside;
        ui.painter().rect(rect, corner, visuals.weak_bg_fill, stroke, inside);
        if response.has_focus() {
            let focus = ui.visuals().selection.stroke;
            ui.painter().rect_stroke(rect, corner, focus, inside);
        }
        let color = greyed(ui, closed.is_some(), visuals.fg_stroke.color);
        let left = rect.left() + GAP + 0.5 * SIGN;
        let square = Rect::from_center_size(pos2(left, rect.center().y), Vec2::splat(SIGN));
        paint(ui.painter(), kind, square, Stroke::new(1.6, color));
        let font = egui::TextStyle::Button.resolve(ui.style());
        let from = square.right() + GAP;
        let room = Rect::from_min_max(pos2(from, rect.top()), rect.right_bottom());
        let text = ui.painter().layout_no_wrap(short(kind).to_owned(), font, color);
        let at = pos2(from, rect.center().y - 0.5 * text.size().y);
        ui.painter().with_clip_rect(room).galley(at, text, color);
    }
    response.on_hover_text(match closed {
        Some(closed) => format!("{}\n{closed}", help(kind)),
        None => format!("{} {more}", help(kind)),
    })
}

/// What is not open is looked at only.
fn sense(closed: bool) -> Sense {
    if closed { Sense::hover() } else { Sense::click() }
}

/// The colour of what is drawn, faded where it is not open.
fn greyed(ui: &Ui, closed: bool, color: Color32) -> Color32 {
    if closed { color.gamma_multiply(ui.visuals().disabled_alpha()) } else { color }
}

/// Width of each of `columns` buttons beside each other.
#[must_use]
pub fn width(ui: &Ui, columns: usize) -> f32 {
    let gaps = (columns - 1) as f32 * ui.spacing().item_spacing.x;
    ((ui.available_width() - gaps) / columns as f32).max(theme::FINGER)
}

/// Paints the sign of a kind into a square.
pub fn paint(painter: &Painter, kind: Disturbance, square: Rect, stroke: Stroke) {
    let at = |x: f32, y: f32| square.min + vec2(x * square.width(), y * square.height());
    let line = |points: &[(f32, f32)]| {
        let points = points.iter().map(|(x, y)| at(*x, *y)).collect();
        painter.add(Shape::line(points, stroke));
    };
    let radius = |share: f32| share * square.width();
    match kind {
        Disturbance::HardSpot => {
            line(&[(0.0, 0.7), (1.0, 0.7)]);
            painter.circle_filled(at(0.5, 0.5), radius(0.24), stroke.color);
        }
        Disturbance::Gap => {
            line(&[(0.0, 0.35), (0.32, 0.35), (0.32, 0.9)]);
            line(&[(1.0, 0.35), (0.68, 0.35), (0.68, 0.9)]);
        }
        Disturbance::DepthStep => line(&[(0.0, 0.75), (0.5, 0.75), (0.5, 0.3), (1.0, 0.3)]),
        Disturbance::WearJump => {
            line(&[(0.0, 0.85), (0.45, 0.75), (0.45, 0.35), (1.0, 0.2)]);
        }
        Disturbance::BrokenTooth => {
            painter.circle_stroke(at(0.5, 0.5), radius(0.3), stroke);
            line(&[(0.7, 0.3), (1.0, 0.0)]);
            line(&[(0.0, 0.7), (0.3, 1.0)]);
            line(&[(0.0, 1.0), (0.3, 0.7)]);
        }
        Disturbance::ChatterBurst => line(&[
            (0.0, 0.5),
            (0.15, 0.5),
            (0.27, 0.1),
            (0.42, 0.9),
            (0.58, 0.1),
            (0.73, 0.9),
            (0.85, 0.5),
            (1.0, 0.5),
        ]),
        Disturbance::SensorDropout => {
            line(&[(0.0, 0.25), (0.3, 0.25), (0.3, 0.85), (0.7, 0.85), (0.7, 0.25), (1.0, 0.25)])
        }
        Disturbance::SensorDrift => line(&[(0.0, 0.8), (0.25, 0.8), (0.75, 0.25), (1.0, 0.25)]),
        Disturbance::DeadTime => {
            painter.circle_stroke(at(0.5, 0.5), radius(0.45), stroke);
            line(&[(0.5, 0.22), (0.5, 0.5), (0.72, 0.62)]);
        }
        Disturbance::Operator => {
            line(&[(0.0, 0.55), (1.0, 0.55)]);
            painter.circle_filled(at(0.32, 0.55), radius(0.2), stroke.color);
            line(&[(0.8, 0.2), (0.8, 0.9)]);
        }
    }
}
