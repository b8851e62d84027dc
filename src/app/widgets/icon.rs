//! Buttons with painted signs: no font needs to hold them.

use egui::{
    Color32, Painter, Pos2, Rect, Response, Role, Sense, Shape, Stroke, Ui, WidgetInfo, vec2,
};

/// A sign.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Icon {
    /// A triangle to the right.
    Play,
    /// Two bars.
    Pause,
    /// A triangle to the left before a bar.
    Restart,
    /// A triangle to the right before a bar.
    Step,
    /// Two triangles to the right before a bar.
    End,
    /// An arrow bent back to the left.
    Undo,
    /// An arrow bent on to the right.
    Redo,
    /// The sun.
    Light,
    /// The moon.
    Dark,
    /// Three bars.
    Menu,
    /// A cross.
    Close,
    /// A sheet with two lines.
    Message,
    /// Two sheets.
    Copy,
    /// A loudspeaker with waves.
    Sound,
    /// A loudspeaker with a cross.
    Silence,
}

/// A button with a sign on it, its name for screen readers, and a tooltip.
pub fn button(ui: &mut Ui, icon: Icon, name: &str, help: &str, enabled: bool) -> Response {
    let side = ui.spacing().interact_size.y.max(26.0);
    let sense = if enabled { Sense::click() } else { Sense::hover() };
    let (rect, response) = ui.allocate_exact_size(vec2(side + 4.0, side), sense);
    response.widget_info(|| WidgetInfo::labeled(Role::Button, enabled, name));
    if ui.is_rect_visible(rect) {
        let visuals = *ui.style().interact(&response);
        let (fill, color) = if enabled {
            (visuals.weak_bg_fill, visuals.fg_stroke.color)
        } else {
            (Color32::TRANSPARENT, ui.visuals().weak_text_color())
        };
        let color = if enabled { color } else { color.gamma_multiply(0.5) };
        let painter = ui.painter();
        painter.rect(
            rect,
            visuals.corner_radius,
            fill,
            visuals.bg_stroke,
            egui::StrokeKind::Inside,
        );
        if response.has_focus() {
            let focus = ui.visuals().selection.stroke;
            painter.rect_stroke(rect, visuals.corner_radius, focus, egui::StrokeKind::Inside);
        }
        let square = Rect::from_center_size(rect.center(), egui::Vec2::splat(14.0));
        paint(painter, icon, square, color, ui.visuals().panel_fill);
    }
    response.on_hover_text(help)
}

/// Paints a sign into a square.
pub fn paint(painter: &Painter, icon: Icon, square: Rect, color: Color32, ground: Color32) {
    let at = |x: f32, y: f32| -> Pos2 { square.lerp_inside(vec2(x, y)) };
    let stroke = Stroke::new(2.0, color);
    let triangle = |points: [Pos2; 3]| {
        painter.add(Shape::convex_polygon(points.to_vec(), color, Stroke::NONE));
    };
    let bar = |left: f32, right: f32| {
        painter.rect_filled(Rect::from_min_max(at(left, 0.05), at(right, 0.95)), 1.0, color);
    };
    match icon {
        Icon::Play => triangle([at(0.15, 0.0), at(1.0, 0.5), at(0.15, 1.0)]),
        Icon::Pause => {
            bar(0.12, 0.4);
            bar(0.6, 0.88);
        }
        Icon::Restart => {
            bar(0.0, 0.18);
            triangle([at(1.0, 0.05), at(0.25, 0.5), at(1.0, 0.95)]);
        }
        Icon::Step => {
            triangle([at(0.0, 0.05), at(0.75, 0.5), at(0.0, 0.95)]);
            bar(0.82, 1.0);
        }
        Icon::End => {
            triangle([at(0.0, 0.1), at(0.42, 0.5), at(0.0, 0.9)]);
            triangle([at(0.42, 0.1), at(0.84, 0.5), at(0.42, 0.9)]);
            bar(0.86, 1.0);
        }
        Icon::Undo | Icon::Redo => {
            let x = |x: f32| if icon == Icon::Undo { x } else { 1.0 - x };
            let points =
                [(0.2, 0.35), (0.65, 0.35), (0.9, 0.5), (0.9, 0.75), (0.65, 0.9), (0.3, 0.9)];
            let line = points.map(|(px, y)| at(x(px), y));
            painter.add(Shape::line(line.to_vec(), stroke));
            triangle([at(x(0.4), 0.0), at(x(0.0), 0.35), at(x(0.4), 0.7)]);
        }
        Icon::Light => {
            painter.circle_filled(square.center(), 3.6, color);
            // Eight rays: the directions of a compass rose.
            const D: f32 = std::f32::consts::FRAC_1_SQRT_2;
            let rays = [(1.0, 0.0), (D, D), (0.0, 1.0), (-D, D)];
            for (x, y) in rays.into_iter().flat_map(|(x, y)| [(x, y), (-x, -y)]) {
                let ray = [square.center() + vec2(x, y) * 5.2, square.center() + vec2(x, y) * 7.5];
                painter.line_segment(ray, Stroke::new(1.5, color));
            }
        }
        Icon::Dark => {
            painter.circle_filled(square.center(), 6.5, color);
            painter.circle_filled(at(0.72, 0.3), 5.2, ground);
        }
        Icon::Menu => {
            for y in [0.15, 0.5, 0.85] {
                painter.line_segment([at(0.0, y), at(1.0, y)], stroke);
            }
        }
        Icon::Close => {
            painter.line_segment([at(0.15, 0.15), at(0.85, 0.85)], stroke);
            painter.line_segment([at(0.85, 0.15), at(0.15, 0.85)], stroke);
        }
        Icon::Message => {
            let sheet = Rect::from_min_max(at(0.0, 0.08), at(1.0, 0.92));
            painter.rect_stroke(sheet, 2.0, stroke, egui::StrokeKind::Inside);
            for y in [0.38, 0.62] {
                painter.line_segment([at(0.25, y), at(0.75, y)], Stroke::new(1.5, color));
            }
        }
        Icon::Sound | Icon::Silence => {
            let cone =
                [(0.0, 0.34), (0.2, 0.34), (0.5, 0.08), (0.5, 0.92), (0.2, 0.66), (0.0, 0.66)];
            let cone = cone.map(|(x, y)| at(x, y));
            // Its outline turns inwards at the neck: two convex parts.
            painter.rect_filled(Rect::from_min_max(cone[0], cone[4]), 0.0, color);
            let front = [cone[1], cone[2], cone[3], cone[4]];
            painter.add(Shape::convex_polygon(front.to_vec(), color, Stroke::NONE));
            let thin = Stroke::new(1.5, color);
            if icon == Icon::Silence {
                painter.line_segment([at(0.66, 0.34), at(1.0, 0.68)], thin);
                painter.line_segment([at(0.66, 0.68), at(1.0, 0.34)], thin);
            } else {
                for (x, y) in [(0.66, 0.3), (0.8, 0.14)] {
                    let wave = [at(x, y), at(x + 0.16, 0.5), at(x, 1.0 - y)];
                    painter.add(Shape::line(wave.to_vec(), thin));
                }
            }
        }
        Icon::Copy => {
            let sheet =
                |left: f32, top: f32| Rect::from_min_max(at(left, top), at(left + 0.62, top + 0.7));
            let thin = Stroke::new(1.5, color);
            painter.rect_stroke(sheet(0.32, 0.02), 1.5, thin, egui::StrokeKind::Inside);
            painter.rect(sheet(0.06, 0.28), 1.5, ground, thin, egui::StrokeKind::Inside);
        }
    }
}
