//! An orbit camera: it looks at a point from a distance, turned about the vertical and tilted.
//! Right-handed, z up, lengths in mm.

use egui::{Pos2, Rect, Vec2, pos2};

/// A place or a direction.
pub type Point = [f32; 3];
/// A matrix by columns.
pub type Matrix = [[f32; 4]; 4];

/// Angle of view from top to bottom, rad.
const VIEW_RAD: f32 = 0.6;
/// Turn and tilt per point of a drag, rad.
const PER_POINT: f32 = 0.008;
/// Largest fraction of the picture that the fitted object takes.
const FITTED: f32 = 0.9;
/// The tilts allowed, rad: from just above the ground to nearly from above.
const TILT: [f32; 2] = [0.06, 1.5];

/// Where the eye is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// What is looked at.
    pub target: Point,
    /// Distance of the eye from it.
    pub distance: f32,
    /// Turn about the vertical, rad.
    pub turn_rad: f32,
    /// How far above the ground it looks down from, rad.
    pub tilt_rad: f32,
}

/// a - b.
#[must_use]
pub fn minus(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// Scalar product.
#[must_use]
pub fn dot(a: Point, b: Point) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Vector product.
#[must_use]
pub fn cross(a: Point, b: Point) -> Point {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The same direction with length one.
#[must_use]
pub fn unit(a: Point) -> Point {
    let length = dot(a, a).sqrt().max(f32::MIN_POSITIVE);
    a.map(|x| x / length)
}

impl Camera {
    /// From the target to the eye, length one.
    #[must_use]
    pub fn backwards(&self) -> Point {
        let (sin, cos) = self.tilt_rad.sin_cos();
        [cos * self.turn_rad.sin(), -cos * self.turn_rad.cos(), sin]
    }

    /// To the right and upwards on the screen.
    fn axes(&self) -> [Point; 2] {
        let right = [self.turn_rad.cos(), self.turn_rad.sin(), 0.0];
        [right, cross(self.backwards(), right)]
    }

    /// The eye.
    #[must_use]
    pub fn eye(&self) -> Point {
        let back = self.backwards();
        [0, 1, 2].map(|i| self.target[i] + self.distance * back[i])
    }

    /// From the world to the screen, by columns; `aspect` is width over height.
    #[must_use]
    pub fn projection(&self, aspect: f32) -> Matrix {
        let back = self.backwards();
        let [right, up] = self.axes();
        let eye = self.eye();
        let (near, far) = (0.02 * self.distance, 20.0 * self.distance + 1000.0);
        let scale = 1.0 / (0.5 * VIEW_RAD).tan();
        // Rows: x and y of the screen, depth from 0 to 1, and the distance that divides them.
        let row =
            |axis: Point, by: f32| [by * axis[0], by * axis[1], by * axis[2], -by * dot(axis, eye)];
        let depth = far / (near - far);
        let mut z = row(back, depth);
        z[3] += near * depth;
        let rows = [row(right, scale / aspect), row(up, scale), z, row(back, -1.0)];
        [0, 1, 2, 3].map(|column| rows.map(|row| row[column]))
    }

    /// Where a point of the world stands on the screen; nothing behind the eye.
    #[must_use]
    pub fn on_screen(&self, rect: Rect, point: Point) -> Option<Pos2> {
        let m = self.projection(rect.aspect_ratio());
        let [x, y, _, w] = [0, 1, 2, 3].map(|row| {
            m[0][row] * point[0] + m[1][row] * point[1] + m[2][row] * point[2] + m[3][row]
        });
        (w > 0.0).then(|| {
            let (x, y) = (0.5 + 0.5 * x / w, 0.5 - 0.5 * y / w);
            pos2(rect.left() + x * rect.width(), rect.top() + y * rect.height())
        })
    }

    /// Where the ray through a place on the screen meets the level `z`; nothing if it does not.
    #[must_use]
    pub fn on_level(&self, rect: Rect, at: Pos2, z: f32) -> Option<[f32; 2]> {
        let half = (0.5 * VIEW_RAD).tan();
        let x = (2.0 * (at.x - rect.left()) / rect.width() - 1.0) * half * rect.aspect_ratio();
        let y = (1.0 - 2.0 * (at.y - rect.top()) / rect.height()) * half;
        let (back, [right, up], eye) = (self.backwards(), self.axes(), self.eye());
        let ray = [0, 1, 2].map(|i| x * right[i] + y * up[i] - back[i]);
        let times = (z - eye[2]) / ray[2];
        (times.is_finite() && times > 0.0)
            .then(|| [eye[0] + times * ray[0], eye[1] + times * ray[1]])
    }

    /// Looks at the middle of a box from the nearest place that shows all of `points` in a picture of
    /// width over height `aspect`.
    pub fn fit(&mut self, [low, high]: [Point; 2], points: &[Point], aspect: f32) {
        self.target = [0, 1, 2].map(|i| 0.5 * (low[i] + high[i]));
        let mut range = [1.0, 1e6_f32];
        // Halves the range of its logarithm.
        for _ in 0..40 {
            self.distance = (range[0] * range[1]).sqrt();
            let unit = Rect::from_min_max(pos2(-aspect, -1.0), pos2(aspect, 1.0));
            let seen = unit.scale_from_center(FITTED);
            let all = points
                .iter()
                .all(|point| self.on_screen(unit, *point).is_some_and(|at| seen.contains(at)));
            range[usize::from(all)] = self.distance;
        }
        self.distance = range[1];
    }

    /// Turns it by a drag, points.
    pub fn orbit(&mut self, drag: Vec2) {
        self.turn_rad -= PER_POINT * drag.x;
        self.tilt_rad = (self.tilt_rad + PER_POINT * drag.y).clamp(TILT[0], TILT[1]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn camera() -> Camera {
        Camera { target: [10.0, -3.0, 2.0], distance: 80.0, turn_rad: 0.7, tilt_rad: 0.5 }
    }

    #[test]
    fn the_target_stands_in_the_middle_and_up_is_up() {
        let rect = Rect::from_min_size(pos2(20.0, 40.0), Vec2::new(300.0, 200.0));
        let middle = camera().on_screen(rect, [10.0, -3.0, 2.0]).unwrap();
        assert!((middle - rect.center()).length() < 0.01, "{middle:?}");
        let above = camera().on_screen(rect, [10.0, -3.0, 9.0]).unwrap();
        assert!(above.y < middle.y - 5.0 && (above.x - middle.x).abs() < 0.01, "{above:?}");
        assert_eq!(camera().on_screen(rect, camera().eye().map(|x| 2.0 * x)), None);
    }

    #[test]
    fn a_place_on_the_screen_leads_back_to_the_point_that_stands_there() {
        let rect = Rect::from_min_size(pos2(20.0, 40.0), Vec2::new(300.0, 200.0));
        for point in [[10.0, -3.0, 2.0], [14.0, 1.0, 2.0], [-2.0, -9.0, 2.0]] {
            let at = camera().on_screen(rect, point).unwrap();
            let [x, y] = camera().on_level(rect, at, 2.0).unwrap();
            assert!((x - point[0]).abs() < 0.01 && (y - point[1]).abs() < 0.01, "{point:?}");
        }
        let sky = camera().on_level(rect, pos2(170.0, -4000.0), 2.0);
        assert_eq!(sky, None);
    }

    #[test]
    fn what_is_fitted_is_seen_and_fills_the_picture() {
        for (aspect, length) in [(1.3, 200.0), (0.4, 200.0), (1.3, 20_000.0), (1.0, 5.0)] {
            let corners = [[0.0, -4.0, -4.0], [length, 10.0, 3.0]];
            let points: Vec<Point> =
                (0..8).map(|i| [0, 1, 2].map(|k| corners[i >> k & 1][k])).collect();
            let mut camera = camera();
            camera.fit(corners, &points, aspect);
            let rect = Rect::from_min_max(pos2(-aspect, -1.0), pos2(aspect, 1.0));
            let reach = |camera: &Camera| {
                let places = points.iter().map(|p| camera.on_screen(rect, *p).unwrap());
                places.map(|at| (at.x / aspect).abs().max(at.y.abs())).fold(0.0, f32::max)
            };
            assert!((reach(&camera) - FITTED).abs() < 0.01, "{}", reach(&camera));
        }
    }

    #[test]
    fn what_is_nearer_has_the_smaller_depth() {
        let m = camera().projection(1.5);
        let depth = |point: Point| {
            let [z, w] = [2, 3].map(|row| {
                m[0][row] * point[0] + m[1][row] * point[1] + m[2][row] * point[2] + m[3][row]
            });
            z / w
        };
        let eye = camera().eye();
        let towards = |fraction: f32| {
            [0, 1, 2].map(|i| camera().target[i] + fraction * (eye[i] - camera().target[i]))
        };
        let (near, far) = (depth(towards(0.5)), depth(towards(0.0)));
        assert!(0.0 < near && near < far && far < 1.0, "{near} {far}");
    }
}
