//! Triangles with colours, as the graphics adapter takes them.

use egui::Color32;

use super::camera::{Point, cross, minus};

/// Bytes of a corner: place, normal, colour.
pub const CORNER_BYTES: usize = 28;

/// Corners and triangles.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Corners, [`CORNER_BYTES`] each.
    pub corners: Vec<u8>,
    /// Triangles, three numbers of corners each.
    pub triangles: Vec<u32>,
    /// Triangles that are seen through, by the opacity of their corners' colours: drawn after the
    /// others and over each other in their order.
    pub glass: Vec<u32>,
    count: u32,
}

impl Mesh {
    /// Adds a corner and gives back its number. A normal of zero makes it shine by itself.
    pub fn corner(&mut self, place: Point, normal: Point, color: Color32) -> u32 {
        for x in place.iter().chain(&normal) {
            self.corners.extend_from_slice(&x.to_ne_bytes());
        }
        self.corners.extend_from_slice(&color.to_array());
        self.count += 1;
        self.count - 1
    }

    /// Adds a triangle between corners.
    pub fn triangle(&mut self, a: u32, b: u32, c: u32) {
        self.triangles.extend_from_slice(&[a, b, c]);
    }

    /// Adds a triangle that is seen through.
    pub fn pane(&mut self, a: u32, b: u32, c: u32) {
        self.glass.extend_from_slice(&[a, b, c]);
    }

    /// Adds a flat four-cornered face, counted anticlockwise as seen from outside.
    pub fn face(&mut self, places: [Point; 4], color: Color32) {
        let normal = cross(minus(places[1], places[0]), minus(places[3], places[0]));
        let length = super::camera::dot(normal, normal).sqrt();
        if length <= 0.0 {
            return;
        }
        let normal = normal.map(|x| x / length);
        let [a, b, c, d] = places.map(|place| self.corner(place, normal, color));
        self.triangle(a, b, c);
        self.triangle(a, c, d);
    }

    /// Joins two rows of corners of equal length to a strip.
    pub fn strip(&mut self, first: &[u32], second: &[u32]) {
        for (a, b) in first.windows(2).zip(second.windows(2)) {
            self.triangle(a[0], a[1], b[1]);
            self.triangle(a[0], b[1], b[0]);
        }
    }
}
