//! The ball-end cutter in space: ball and shank, striped along its flutes so that it can be seen
//! turning.

use egui::Color32;

use crate::app::scene::mesh::Mesh;
use crate::blocks::cutting::tool::R216_16B20_040;

/// Length of the shank that is drawn, mm.
const SHANK_MM: f32 = 26.0;
/// Faces around, and rings of the ball.
const AROUND: usize = 96;
const RINGS: usize = 9;
/// Turn of the stripes from the tip to the end of the shank, rad.
const TWIST_RAD: f32 = 1.6;

/// Adds the cutter at a place along the cut, turned by `turn_rad`.
pub fn draw(mesh: &mut Mesh, x_mm: f32, turn_rad: f32, colors: [Color32; 2]) {
    let radius = 0.5 * R216_16B20_040.diameter_mm as f32;
    // Height, radius of the ring, and upward part of its normal.
    let mut rings: Vec<[f32; 3]> = (0..=RINGS)
        .map(|i| {
            let angle = std::f32::consts::FRAC_PI_2 * i as f32 / RINGS as f32;
            [radius - radius * angle.cos(), radius * angle.sin(), -angle.cos()]
        })
        .collect();
    rings.push([0.55 * SHANK_MM, radius, 0.0]);
    rings.push([SHANK_MM, radius, 0.0]);
    let teeth = R216_16B20_040.teeth as f32;
    let mut before: Option<Vec<u32>> = None;
    for [z, r, up] in rings {
        let side = (1.0 - up * up).max(0.0).sqrt();
        let corners: Vec<u32> = (0..=AROUND)
            .map(|k| {
                let angle = std::f32::consts::TAU * k as f32 / AROUND as f32;
                let (sin, cos) = angle.sin_cos();
                let phase = teeth * (angle - turn_rad - TWIST_RAD * z / SHANK_MM);
                let flute = phase.cos() > 0.72;
                let color = if flute { colors[1] } else { colors[0] };
                mesh.corner([x_mm + r * cos, r * sin, z], [side * cos, side * sin, up], color)
            })
            .collect();
        if let Some(before) = before.replace(corners.clone()) {
            mesh.strip(&before, &corners);
        }
    }
    let lid: Vec<u32> = (0..=AROUND)
        .map(|k| {
            let (sin, cos) = (std::f32::consts::TAU * k as f32 / AROUND as f32).sin_cos();
            let place = [x_mm + radius * cos, radius * sin, SHANK_MM];
            mesh.corner(place, [0.0, 0.0, 1.0], colors[0])
        })
        .collect();
    for pair in lid[1..].windows(2) {
        mesh.triangle(lid[0], pair[0], pair[1]);
    }
}
