//! The map in space: the force surface, cut by the plane of the force limit and bounded by the
//! other constraints, as the 2013 paper draws it. It is turned by dragging or by its buttons.

use std::sync::Arc;

use egui::{Align2, Button, Painter, Pos2, Rect, Sense, Shape, Stroke, Ui, Vec2, WidgetInfo, vec2};
use egui_plot::LineStyle;

use super::layers::{Layers, MapLayer};
use super::marks::{self, Moving};
use super::search::Found;
use super::space::{Space, floor_corners, top};
use crate::app::format::{self, round_step};
use crate::app::scene;
use crate::app::scene::camera::Camera;
use crate::app::scene::mesh::Mesh;
use crate::app::theme::{self, Look, Palette};
use crate::app::widgets::touch;
use crate::app::widgets::zoom::by_touch;
use crate::base::language::{decimal, fixed, tr};
use crate::study::plan::constraints::CONSTRAINTS;
use crate::study::plan::problem::{CUTTING_SPEED_M_MIN, FEED_PER_TOOTH_MM};

/// Turn of a button, rad.
const TURN_PER_PRESS: f32 = 0.25;
/// The tilts allowed, rad: from above, for lines and marks then lie on the side that is seen.
const TILT: [f32; 2] = [0.3, 1.4];
/// Opacity of the plane of the force limit, and of the walls of the other constraints.
const PLANE: f32 = 0.28;
const WALL: f32 = 0.16;

/// Where the title of a scale stands from the middle of its edge, points.
const TITLE_OFF: Vec2 = vec2(14.0, 18.0);

/// How it is turned, and the triangles drawn last.
pub struct Relief {
    camera: Camera,
    mesh: Arc<Mesh>,
}

impl Default for Relief {
    fn default() -> Self {
        // Target and distance follow from the room there is.
        let camera = Camera { target: [0.0; 3], distance: 1.0, turn_rad: -0.55, tilt_rad: 0.55 };
        Self { camera, mesh: Arc::default() }
    }
}

impl Relief {
    /// The buttons that turn it.
    pub fn buttons(&mut self, ui: &mut Ui) {
        let help = tr("Turns the surface; so does a drag with the mouse");
        let buttons = [(tr("Turn left"), -TURN_PER_PRESS), (tr("Turn right"), TURN_PER_PRESS)];
        for (name, by) in buttons {
            if ui.add(touch::small(ui, Button::new(name))).on_hover_text(help).clicked() {
                self.camera.turn_rad += by;
            }
        }
    }

    /// Draws it `height` points high.
    pub fn show(
        &mut self,
        ui: &mut Ui,
        found: &Found,
        layers: &Layers,
        moving: &Moving<'_>,
        height: f32,
    ) {
        let palette = Palette::at(ui);
        // Fingers scroll the page.
        let sense = if by_touch(ui) { Sense::hover() } else { Sense::drag() };
        let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), height), sense);
        response.widget_info(|| {
            let [turn, tilt] = [-self.camera.turn_rad, self.camera.tilt_rad].map(f32::to_degrees);
            let name = tr!(
                "Force surface in space, turned by {turn:.0}°, seen {tilt:.0}° from above",
                turn = turn,
                tilt = tilt,
            );
            WidgetInfo::labeled(egui::Role::Figure, true, name)
        });
        self.camera.orbit(response.drag_delta());
        self.camera.tilt_rad = self.camera.tilt_rad.clamp(TILT[0], TILT[1]);
        if !ui.is_rect_visible(rect) {
            return;
        }

        let checked = &found.optimum().constraints;
        let force = CONSTRAINTS.iter().position(|constraint| constraint.id == "force");
        let limit_n = force.and_then(|force| checked[force].high);
        let limit_n = limit_n.filter(|_| force.is_some_and(|f| layers.show(MapLayer::Boundary(f))));
        let top_n = top(found.picture.range_n()[1], limit_n);
        let space = Space::new(rect, self.camera, top_n);
        let force_n = |place: [f64; 2]| found.problem.cut(place).force_n;
        let on_surface = |place: [f64; 2]| space.at(place, force_n(place));
        let shown = || (0..CONSTRAINTS.len()).filter(|n| layers.show(MapLayer::Boundary(*n)));

        let mut mesh = Mesh::default();
        space.floor(&mut mesh, palette.line);
        space.skin(&mut mesh, &found.picture, palette);
        for number in shown() {
            let color = palette.constraints[number];
            if Some(number) == force {
                if let Some(limit_n) = limit_n.filter(|limit| *limit <= top_n) {
                    space.level(&mut mesh, limit_n, color.gamma_multiply(PLANE));
                }
                continue;
            }
            for line in &found.picture.boundary(number).lines {
                space.wall(&mut mesh, line, force_n, color.gamma_multiply(WALL));
            }
        }
        // The same triangles again need not go to the graphics adapter again.
        if *self.mesh != mesh {
            self.mesh = Arc::new(mesh);
        }
        let painter = ui.painter().with_clip_rect(rect);
        let background = ui.visuals().panel_fill;
        let mesh = Arc::clone(&self.mesh);
        painter.add(scene::picture(ui.ctx(), rect, space.camera(), mesh, background));

        scales(&painter, &space, palette, top_n);
        if layers.show(MapLayer::ForceLines) {
            let stroke = Stroke::new(0.8, palette.text.gamma_multiply(0.35));
            for (force_n, lines) in found.picture.force_lines() {
                for line in lines {
                    let points = line.iter().map(|point| space.at(*point, *force_n)).collect();
                    painter.add(Shape::line(points, stroke));
                }
            }
        }
        for number in shown() {
            for line in &found.picture.boundary(number).lines {
                let points: Vec<Pos2> = line.iter().map(|point| on_surface(*point)).collect();
                stroked(&painter, &points, Look::Constraint(number), palette);
            }
        }
        marks::all(&painter, palette, found, layers, moving, &on_surface);
    }
}

/// A line in the style of its meaning.
fn stroked(painter: &Painter, points: &[Pos2], look: Look, palette: &Palette) {
    let (stroke, style) = look.line(palette);
    painter.extend(match style {
        LineStyle::Solid => vec![Shape::line(points.to_vec(), stroke)],
        LineStyle::Dashed { length } => Shape::dashed_line(points, stroke, length, 0.6 * length),
        LineStyle::Dotted { spacing } => {
            Shape::dotted_line(points, stroke.color, spacing, 0.7 * stroke.width)
        }
    });
}

/// The upright edge at the left, and the scales of edge and floor.
fn scales(painter: &Painter, space: &Space, palette: &Palette, top_n: f64) {
    let [x, y] = [CUTTING_SPEED_M_MIN, FEED_PER_TOOTH_MM];
    let stroke = Stroke::new(1.0, palette.line);
    let floor = floor_corners().map(|corner| space.at(corner, 0.0));
    let left = floor_corners()
        .into_iter()
        .min_by(|a, b| space.at(*a, 0.0).x.total_cmp(&space.at(*b, 0.0).x));
    let font = theme::note(painter.ctx());
    let write = |at: Pos2, anchor: Align2, text: &str| {
        let galley = painter.layout_no_wrap(text.to_owned(), font.clone(), palette.weak);
        // What would stand beyond the edge is moved in.
        let room = painter.clip_rect().shrink2(galley.size());
        let place = anchor.anchor_size(at, galley.size()).min;
        let inside = place.min(room.max).max(painter.clip_rect().min);
        painter.galley(inside, galley, palette.weak);
    };
    if let Some(left) = left {
        painter.line_segment([space.at(left, 0.0), space.at(left, top_n)], stroke);
        for force_n in steps([0.0, top_n], 4.0) {
            let text = format::round_quantity(force_n, "N");
            write(space.at(left, force_n) - vec2(5.0, 0.0), Align2::RIGHT_CENTER, &text);
        }
    }
    // The scales stand along the edges that are nearer.
    let [speed_away, feed_away] = space.farther();
    let near = |[low, high]: [f64; 2], away: bool| if away { low } else { high };
    let (x_near, y_near) = (near(x, speed_away), near(y, feed_away));
    let middle = Rect::from_points(&floor).center();
    let title = |at: Pos2, text: &str| {
        let (anchor, side) = match at.x < middle.x {
            true => (Align2::RIGHT_TOP, -TITLE_OFF.x),
            false => (Align2::LEFT_TOP, TITLE_OFF.x),
        };
        write(at + vec2(side, TITLE_OFF.y), anchor, text);
    };
    for speed in steps(x, 3.0) {
        let at = space.at([speed, y_near], 0.0);
        write(at + vec2(0.0, 3.0), Align2::CENTER_TOP, &decimal(speed.to_string()));
    }
    for feed in steps(y, 3.0) {
        let at = space.at([x_near, feed], 0.0);
        write(at + vec2(0.0, 3.0), Align2::CENTER_TOP, &fixed(feed, 2));
    }
    title(space.at([0.5 * (x[0] + x[1]), y_near], 0.0), tr("cutting speed [m/min]"));
    title(space.at([x_near, 0.5 * (y[0] + y[1])], 0.0), tr("feed per tooth [mm]"));
}

/// Round values in a range, about `count` of them.
fn steps([low, high]: [f64; 2], count: f64) -> Vec<f64> {
    let Some(step) = round_step((high - low) / count) else { return Vec::new() };
    let (first, last) = ((low / step).ceil() as i64, (high / step).floor() as i64);
    (first..=last).map(|k| k as f64 * step).collect()
}
