//! The force surface as a body in space: where its points stand, and the triangles of its skin, of the
//! planes that cut it and of its floor.

use egui::{Color32, Pos2, Rect};

use super::picture::{Picture, SAMPLES};
use crate::app::scene::camera::{Camera, Point};
use crate::app::scene::mesh::Mesh;
use crate::app::theme::Palette;
use crate::study::plan::problem::{CUTTING_SPEED_M_MIN, FEED_PER_TOOTH_MM};

/// Width of the body along either axis of its floor, and its height, in lengths of its own space.
const WIDTH: f32 = 100.0;
const HEIGHT: f32 = 62.0;
/// Width of the lines around the floor.
const LINE: f32 = 0.4;
/// A normal of zero: a colour shines by itself, so that it is that of the scale.
const BARE: Point = [0.0; 3];

/// From cutting speed, feed per tooth and force to space and to the screen.
#[derive(Clone, Copy, Debug)]
pub struct Space {
    rect: Rect,
    camera: Camera,
    top_n: f64,
}

impl Space {
    /// The body in a rectangle, seen from where `camera` is turned and tilted to; `top_n` is the force
    /// at its top in N.
    #[must_use]
    pub fn new(rect: Rect, camera: Camera, top_n: f64) -> Self {
        let mut space = Self { rect, camera, top_n };
        let half = 0.5 * WIDTH;
        let bounds = [[-half, -half, 0.0], [half, half, HEIGHT]];
        // Of one size however it is turned: as large as the circle around its floor.
        let radius = half * std::f32::consts::SQRT_2;
        let around = (0..16).map(|i| std::f32::consts::TAU * i as f32 / 16.0);
        let points: Vec<Point> = around
            .flat_map(|angle| {
                let (sin, cos) = angle.sin_cos();
                [0.0, HEIGHT].map(|z| [radius * cos, radius * sin, z])
            })
            .collect();
        space.camera.fit(bounds, &points, rect.aspect_ratio());
        space
    }

    /// The eye.
    #[must_use]
    pub fn camera(&self) -> &Camera {
        &self.camera
    }

    fn point(&self, [speed, feed]: [f64; 2], force_n: f64) -> Point {
        let along = |[low, high]: [f64; 2], value: f64| {
            WIDTH * (((value - low) / (high - low)) as f32 - 0.5)
        };
        let (x, y) = (along(CUTTING_SPEED_M_MIN, speed), along(FEED_PER_TOOTH_MM, feed));
        [x, y, HEIGHT * (force_n / self.top_n) as f32]
    }

    /// The place on the screen of a point of cutting speed in m/min, feed per tooth in mm and force in
    /// N.
    #[must_use]
    pub fn at(&self, place: [f64; 2], force_n: f64) -> Pos2 {
        let at = self.camera.on_screen(self.rect, self.point(place, force_n));
        // The eye stands outside the body: nothing of it is behind.
        at.unwrap_or(self.rect.center())
    }

    /// Whether larger cutting speeds, and larger feeds per tooth, lie farther away.
    #[must_use]
    pub fn farther(&self) -> [bool; 2] {
        let back = self.camera.backwards();
        [back[0] < 0.0, back[1] < 0.0]
    }

    /// The skin of the surface in the colours of the map.
    pub fn skin(&self, mesh: &mut Mesh, picture: &Picture, palette: &Palette) {
        let field = picture.field();
        let row = |mesh: &mut Mesh, row: usize| -> Vec<u32> {
            let of_row = |column: usize| row * SAMPLES[0] + column;
            let place =
                |column: usize| [field.cutting_speed_m_min[column], field.feed_per_tooth_mm[row]];
            let corner = |column: usize| {
                let (force_n, allowed) =
                    (field.force_n[of_row(column)], field.violation[of_row(column)] == 0.0);
                let color = picture.color(palette, force_n, allowed);
                mesh.corner(self.point(place(column), force_n), BARE, color)
            };
            (0..SAMPLES[0]).map(corner).collect()
        };
        let mut before = row(mesh, 0);
        for number in 1..SAMPLES[1] {
            let next = row(mesh, number);
            mesh.strip(&before, &next);
            before = next;
        }
    }

    /// The level plane of a force in N, seen through.
    pub fn level(&self, mesh: &mut Mesh, force_n: f64, color: Color32) {
        let corners =
            floor_corners().map(|place| mesh.corner(self.point(place, force_n), BARE, color));
        mesh.pane(corners[0], corners[1], corners[2]);
        mesh.pane(corners[0], corners[2], corners[3]);
    }

    /// The part above the surface of the upright plane that a constraint cuts it with, seen through;
    /// `line` holds places on the floor, `force_n` gives the surface there.
    pub fn wall(
        &self,
        mesh: &mut Mesh,
        line: &[[f64; 2]],
        force_n: impl Fn([f64; 2]) -> f64,
        color: Color32,
    ) {
        let mut post = |place: [f64; 2]| {
            [force_n(place), self.top_n]
                .map(|force| mesh.corner(self.point(place, force), BARE, color))
        };
        let posts: Vec<[u32; 2]> = line.iter().map(|place| post(*place)).collect();
        for pair in posts.windows(2) {
            mesh.pane(pair[0][0], pair[0][1], pair[1][0]);
            mesh.pane(pair[0][1], pair[1][0], pair[1][1]);
        }
    }

    /// The lines around the floor.
    pub fn floor(&self, mesh: &mut Mesh, color: Color32) {
        let corners = floor_corners().map(|place| self.point(place, 0.0));
        for (i, from) in corners.into_iter().enumerate() {
            let to = corners[(i + 1) % corners.len()];
            // Outwards along both axes, so that the lines meet at the corners.
            let out = |point: Point| [0, 1].map(|k| point[k] + LINE * point[k].signum());
            let [outer_to, outer_from] = [to, from].map(|point| {
                let [x, y] = out(point);
                [x, y, 0.0]
            });
            let numbers =
                [from, to, outer_to, outer_from].map(|place| mesh.corner(place, BARE, color));
            mesh.triangle(numbers[0], numbers[1], numbers[2]);
            mesh.triangle(numbers[0], numbers[2], numbers[3]);
        }
    }
}

/// The corners of the map, in order around it: cutting speed in m/min and feed per tooth in mm.
#[must_use]
pub fn floor_corners() -> [[f64; 2]; 4] {
    let [x, y] = [CUTTING_SPEED_M_MIN, FEED_PER_TOOTH_MM];
    [[x[0], y[0]], [x[1], y[0]], [x[1], y[1]], [x[0], y[1]]]
}

/// A force at which the body ends, N: the largest one on the map, or the limit if that is larger
/// by less than half.
#[must_use]
pub fn top(largest_n: f64, limit_n: Option<f64>) -> f64 {
    let limit_n = limit_n.filter(|limit| *limit > largest_n && *limit < 1.5 * largest_n);
    limit_n.unwrap_or(largest_n)
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::pos2;

    fn space(turn_rad: f32, tilt_rad: f32) -> (Rect, Space) {
        let rect = Rect::from_min_max(pos2(10.0, 20.0), pos2(410.0, 320.0));
        let camera = Camera { target: BARE, distance: 1.0, turn_rad, tilt_rad };
        (rect, Space::new(rect, camera, 1000.0))
    }

    #[test]
    fn the_body_stays_in_its_rectangle_however_it_is_turned() {
        for turn in 0..16 {
            for tilt in 0..5 {
                let (rect, space) = space(0.4 * turn as f32, 0.3 * tilt as f32 + 0.2);
                for place in floor_corners() {
                    for force_n in [0.0, 1000.0] {
                        assert!(rect.contains(space.at(place, force_n)));
                    }
                }
            }
        }
    }

    #[test]
    fn what_lies_farther_away_is_drawn_higher() {
        for turn in 0..16 {
            let (_, space) = space(0.2 + 0.4 * turn as f32, 0.6);
            let [low, by_speed, _, by_feed] = floor_corners().map(|place| space.at(place, 0.0));
            assert_eq!(space.farther(), [by_speed.y < low.y, by_feed.y < low.y], "{turn}");
            assert!(space.at(floor_corners()[0], 500.0).y < low.y);
        }
    }

    #[test]
    fn the_body_ends_at_a_limit_that_is_near() {
        assert_eq!(top(800.0, Some(900.0)), 900.0);
        assert_eq!(top(800.0, Some(665.0)), 800.0);
        assert_eq!(top(800.0, Some(5000.0)), 800.0);
        assert_eq!(top(800.0, None), 800.0);
    }
}
