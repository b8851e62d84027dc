//! The force surface as a body in space: how it is turned on the screen, and its skin.

use egui::{Color32, Mesh, Pos2, Rect};

use super::picture::{Picture, SAMPLES};
use crate::app::theme::Palette;
use crate::base::math::{cos, sin};
use crate::study::plan::problem::{CUTTING_SPEED_M_MIN, FEED_PER_TOOTH_MM};

/// Height of the body as a fraction of its width.
const HEIGHT: f64 = 0.62;

/// From cutting speed, feed per tooth and force to the screen: seen from far away, turned about
/// the vertical axis, from above.
#[derive(Clone, Copy, Debug)]
pub struct Space {
    middle: Pos2,
    scale: f64,
    turn: [f64; 2],
    tilt: [f64; 2],
    force_n: f64,
}

impl Space {
    /// The body in a rectangle, turned and tilted by angles in radians; `force_n` is the force at
    /// its top.
    #[must_use]
    pub fn new(rect: Rect, turn_rad: f64, tilt_rad: f64, force_n: f64) -> Self {
        // As large as it can be however it is turned: the diagonal of its floor is 1.41.
        let scale = f64::from(rect.width() / 1.5).min(f64::from(rect.height() / 1.56));
        let turn = [cos(turn_rad), sin(turn_rad)];
        Self { middle: rect.center(), scale, turn, tilt: [cos(tilt_rad), sin(tilt_rad)], force_n }
    }

    /// The place of a point of cutting speed in m/min, feed per tooth in mm and force in N.
    #[must_use]
    pub fn at(&self, [speed, feed]: [f64; 2], force_n: f64) -> Pos2 {
        let fraction = |[low, high]: [f64; 2], value: f64| (value - low) / (high - low) - 0.5;
        let (x, y) = (fraction(CUTTING_SPEED_M_MIN, speed), fraction(FEED_PER_TOOTH_MM, feed));
        let z = HEIGHT * (force_n / self.force_n - 0.5);
        let [c, s] = self.turn;
        let (right, away) = (x * c - y * s, x * s + y * c);
        let up = away * self.tilt[1] + z * self.tilt[0];
        self.middle + egui::vec2((right * self.scale) as f32, -(up * self.scale) as f32)
    }

    /// Whether larger cutting speeds, and larger feeds per tooth, lie farther away.
    #[must_use]
    pub fn farther(&self) -> [bool; 2] {
        [self.turn[1] > 0.0, self.turn[0] > 0.0]
    }

    /// The skin of the surface, and the plane of the force limit through it where `limit` gives
    /// its force in N and its colour; what is nearer is drawn over what is farther.
    #[must_use]
    pub fn skin(
        &self,
        picture: &Picture,
        palette: &Palette,
        limit: Option<(f64, Color32)>,
    ) -> Mesh {
        let field = picture.field();
        let [columns, rows] = SAMPLES;
        let mut mesh = Mesh::default();
        let point = |i: usize| {
            [field.cutting_speed_m_min[i % columns], field.feed_per_tooth_mm[i / columns]]
        };
        for i in 0..columns * rows {
            let allowed = field.violation[i] == 0.0;
            let color = picture.color(palette, field.force_n[i], allowed);
            mesh.colored_vertex(self.at(point(i), field.force_n[i]), color);
        }
        if let Some((limit_n, color)) = limit {
            for i in 0..columns * rows {
                mesh.colored_vertex(self.at(point(i), limit_n), color);
            }
        }
        let order = |count: usize, away: bool| -> Vec<usize> {
            // The farthest first.
            if away { (0..count).rev().collect() } else { (0..count).collect() }
        };
        let [speed_away, feed_away] = self.farther();
        for row in order(rows - 1, feed_away) {
            for column in order(columns - 1, speed_away) {
                let i = row * columns + column;
                let mut cell = |first: usize| {
                    let corner = |k: usize| (first + k) as u32;
                    mesh.add_triangle(corner(0), corner(1), corner(columns));
                    mesh.add_triangle(corner(1), corner(columns), corner(columns + 1));
                };
                match limit {
                    None => cell(i),
                    Some((limit_n, _)) => {
                        // The upper one of the two is the nearer one.
                        let plane = columns * rows + i;
                        let below = field.force_n[i] < limit_n;
                        for first in if below { [i, plane] } else { [plane, i] } {
                            cell(first);
                        }
                    }
                }
            }
        }
        mesh
    }
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

    #[test]
    fn the_body_stays_in_its_rectangle_however_it_is_turned() {
        let rect = Rect::from_min_max(pos2(10.0, 20.0), pos2(410.0, 320.0));
        for turn in 0..16 {
            for tilt in 0..5 {
                let (turn_rad, tilt_rad) = (0.4 * f64::from(turn), 0.3 * f64::from(tilt) + 0.2);
                let space = Space::new(rect, turn_rad, tilt_rad, 1000.0);
                for speed in CUTTING_SPEED_M_MIN {
                    for feed in FEED_PER_TOOTH_MM {
                        for force_n in [0.0, 1000.0] {
                            assert!(rect.contains(space.at([speed, feed], force_n)));
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn what_lies_farther_away_is_drawn_higher() {
        let rect = Rect::from_min_max(pos2(0.0, 0.0), pos2(400.0, 300.0));
        for turn in 0..16 {
            let space = Space::new(rect, 0.2 + 0.4 * f64::from(turn), 0.6, 1000.0);
            let low = space.at([CUTTING_SPEED_M_MIN[0], FEED_PER_TOOTH_MM[0]], 0.0);
            let by_speed = space.at([CUTTING_SPEED_M_MIN[1], FEED_PER_TOOTH_MM[0]], 0.0);
            let by_feed = space.at([CUTTING_SPEED_M_MIN[0], FEED_PER_TOOTH_MM[1]], 0.0);
            assert_eq!(space.farther(), [by_speed.y < low.y, by_feed.y < low.y]);
            assert!(space.at([CUTTING_SPEED_M_MIN[0], FEED_PER_TOOTH_MM[0]], 500.0).y < low.y);
        }
        assert_eq!(top(800.0, Some(1000.0)), 1000.0);
        assert_eq!(
            [top(800.0, Some(2000.0)), top(800.0, Some(300.0)), top(800.0, None)],
            [800.0; 3]
        );
    }
}
