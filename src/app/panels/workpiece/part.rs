//! The part in space: stock with its steps, the channel that the ball has cut so far, and the fine
//! surface in it, its heights drawn larger by a factor. x along the cut, y across it from the
//! tool's axis, z upwards from the lowest point of the ball, all in mm.

mod faces;
#[cfg(test)]
mod tests;

use egui::Color32;

use crate::app::scene::camera::{Point, unit};
use crate::app::scene::mesh::Mesh;
use crate::blocks::cutting::tool_path::met_mm;
use crate::blocks::surface::topography::Topography;
use crate::models::part::CutPath;
use crate::models::tool::Outline;

/// Stock in front of the wall, behind the channel, below the ball and before an open cut, mm.
const FRONT_MM: f32 = 4.0;
const BEHIND_MM: f32 = 6.0;
const BELOW_MM: f32 = 4.0;
const BEFORE_MM: f32 = 8.0;
/// How much lower the stock in front of the wall is: an earlier cut took it, mm.
const STEP_MM: f32 = 0.6;
/// Rows of the fine surface across the cut.
const ROWS: usize = 13;

/// What is drawn.
pub struct Part<'a> {
    /// The cut.
    pub cut: &'a CutPath,
    /// Its surface so far.
    pub surface: &'a Topography,
    /// The tool's axis, mm.
    pub tool_mm: f32,
    /// Where the fine surface is drawn point by point, mm; beyond, smooth.
    pub window_mm: [f32; 2],
    /// Factor of the heights.
    pub times: f32,
    /// Colour of the stock.
    pub stock: Color32,
    /// Colour of the machined surface at a place along the cut.
    pub color: &'a dyn Fn(f32) -> Color32,
}

/// A section of constant depth and wall.
#[derive(Clone, Copy)]
struct Section {
    from: f32,
    to: f32,
    depth: f32,
    wall: f32,
    /// Where the cutter meets the surface.
    edge: f32,
}

/// The largest and the smallest corner of the part, mm.
pub fn bounds(cut: &CutPath, outline: &Outline) -> [Point; 2] {
    let sections = sections(cut, outline);
    let [front, back] = borders(&sections);
    let from = sections.first().map_or(0.0, |s| s.from);
    let to = sections.last().map_or(1.0, |s| s.to);
    let top = sections.iter().map(|s| s.depth).fold(0.0, f32::max);
    [[from, front, -BELOW_MM], [to, back, top]]
}

fn sections(cut: &CutPath, outline: &Outline) -> Vec<Section> {
    let mut begins = cut.steps_mm();
    if let Some(first) = begins.first_mut().filter(|_| cut.is_open()) {
        *first = f64::from(-BEFORE_MM);
    }
    let ends = begins.iter().skip(1).copied().chain([cut.length_mm()]);
    let sections = begins.iter().zip(ends).map(|(from, to)| {
        let [depth_mm, wall_mm] = cut.section_at(0.5 * (from + to));
        let edge = met_mm(outline, depth_mm) as f32;
        let [depth, wall] = [depth_mm, wall_mm].map(|x| x as f32);
        Section { from: *from as f32, to: to as f32, depth, wall: wall.min(edge), edge }
    });
    sections.collect()
}

/// Where the stock ends in front and behind.
fn borders(sections: &[Section]) -> [f32; 2] {
    let deepest = sections.iter().map(|s| s.edge).fold(1.0, f32::max);
    [sections.iter().map(|s| s.wall).fold(0.0, f32::min) - FRONT_MM, deepest + BEHIND_MM]
}

impl Part<'_> {
    /// Height of the cutter's outline above its lowest point at a distance from its axis.
    pub fn outline(&self, off: f32) -> f32 {
        self.surface.outline().height_mm(f64::from(off)) as f32
    }

    /// Upward normal of that outline at a place from the axis.
    fn normal(&self, [ahead, y]: [f32; 2], height: f32) -> Point {
        let (outline, off) = (self.surface.outline(), ahead.hypot(y));
        let beyond = outline.beyond_mm(f64::from(off)) as f32;
        let fraction = if beyond > 0.0 { beyond / off } else { 0.0 };
        // A sharp corner is all flat.
        let up = (outline.corner_radius_mm as f32 - height).max(1e-3);
        unit([-ahead * fraction, -y * fraction, up])
    }

    /// Height drawn at a point of the machined surface, mm.
    pub fn height(&self, x: f32, y: f32) -> f32 {
        let fine = self.surface.height_um(f64::from(x), f64::from(y)).unwrap_or(0.0);
        self.outline(y) + self.times * fine as f32 / 1000.0
    }

    /// Adds it to `mesh`.
    pub fn draw(&self, mesh: &mut Mesh) {
        let sections = sections(self.cut, self.surface.outline());
        let borders = borders(&sections);
        for section in &sections {
            self.stock(mesh, section, borders);
            self.machined(mesh, section);
            self.being_cut(mesh, section);
        }
        for pair in sections.windows(2) {
            self.step(mesh, pair[0].to, Some(&pair[0]), Some(&pair[1]), borders);
        }
        if let (Some(first), Some(last)) = (sections.first(), sections.last()) {
            self.step(mesh, first.from, None, Some(first), borders);
            self.step(mesh, last.to, Some(last), None, borders);
        }
    }
}
