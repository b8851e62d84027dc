//! The marks on the map: particles, their own bests, the best place of all, the programmed values.

use egui::{Color32, Painter, Pos2, Shape, Stroke, vec2};

use super::layers::{Layers, MapLayer};
use super::search::Found;
use crate::app::theme::Palette;

/// What moves on the map.
pub struct Moving<'a> {
    /// Where the particles are drawn.
    pub positions: &'a [[f64; 2]],
    /// The programmed values as cutting speed in m/min and feed per tooth in mm, where they lie on
    /// the map.
    pub programmed: Option<[f64; 2]>,
    /// The place whose values are kept in sight.
    pub pinned: Option<[f64; 2]>,
}

/// A particle: full where the cut is allowed.
pub fn particle(painter: &Painter, at: Pos2, feasible: bool, palette: &Palette) {
    const RADIUS: f32 = 3.4;
    if feasible {
        painter.circle(at, RADIUS, palette.text, Stroke::new(1.0, palette.card));
    } else {
        painter.circle(at, RADIUS, Color32::TRANSPARENT, Stroke::new(1.3, palette.text));
    }
}

/// The best place of one particle.
pub fn own_best(painter: &Painter, at: Pos2, palette: &Palette) {
    painter.circle_filled(at, 1.8, palette.text.gamma_multiply(0.45));
}

/// The best place of all: a star, full once the search has ended.
pub fn best(painter: &Painter, at: Pos2, ended: bool, palette: &Palette) {
    // A star of five points: the corners of a pentagon and those between them.
    const CORNERS: [[f32; 2]; 5] =
        [[0.0, -1.0], [0.951, -0.309], [0.588, 0.809], [-0.588, 0.809], [-0.951, -0.309]];
    const RADIUS: f32 = 9.0;
    let corner = |i: usize| vec2(CORNERS[i % 5][0], CORNERS[i % 5][1]);
    let mut points = Vec::with_capacity(10);
    for i in 0..5 {
        let inner = (corner(i) + corner(i + 1)) * 0.5;
        points.push(at + corner(i) * RADIUS);
        points.push(at + inner * (0.5 * RADIUS));
    }
    let fill = if ended { palette.warn } else { palette.card };
    // Not convex: filled from its middle, piece by piece.
    for i in 0..points.len() {
        let piece = vec![at, points[i], points[(i + 1) % points.len()]];
        painter.add(Shape::convex_polygon(piece, fill, Stroke::NONE));
    }
    painter.add(Shape::closed_line(points, Stroke::new(1.4, palette.text)));
}

/// The programmed values: a diamond.
pub fn programmed(painter: &Painter, at: Pos2, palette: &Palette) {
    let corners = [vec2(0.0, -7.0), vec2(7.0, 0.0), vec2(0.0, 7.0), vec2(-7.0, 0.0)];
    let points = corners.map(|corner| at + corner).to_vec();
    painter.add(Shape::convex_polygon(points, palette.card, Stroke::new(2.0, palette.accent)));
}

/// All marks; `at` gives the place on the screen of a cutting speed in m/min and a feed per tooth
/// in mm.
pub fn all(
    painter: &Painter,
    palette: &Palette,
    found: &Found,
    layers: &Layers,
    moving: &Moving<'_>,
    at: &dyn Fn([f64; 2]) -> Pos2,
) {
    let stage = found.stage();
    if layers.show(MapLayer::OwnBests) {
        for place in &stage.own_bests {
            own_best(painter, at(*place), palette);
        }
    }
    if layers.show(MapLayer::Particles) {
        // Judged where it is drawn: between two iterations that is neither's place.
        for place in moving.positions {
            let feasible = found.problem.score(*place).feasible();
            particle(painter, at(*place), feasible, palette);
        }
    }
    if let Some(point) = moving.programmed
        && layers.show(MapLayer::Programmed)
    {
        programmed(painter, at(point), palette);
    }
    if layers.show(MapLayer::Best) {
        best(painter, at(stage.best), stage.counts.done, palette);
    }
    if let Some(point) = moving.pinned {
        painter.circle_stroke(at(point), 6.0, Stroke::new(2.0, palette.bad));
    }
}
