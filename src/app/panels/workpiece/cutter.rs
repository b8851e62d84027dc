//! The cutter in space: its end and shank, striped along its flutes so that it can be seen
//! turning.

use egui::Color32;

use crate::app::scene::camera::Point;
use crate::app::scene::mesh::Mesh;
use crate::models::tool::Tool;

/// Length of the shank that is drawn, mm.
pub const SHANK_MM: f32 = 26.0;
/// Faces around, and rings of the ball or corner.
const AROUND: usize = 96;
const RINGS: usize = 9;
/// Turn of the stripes from the tip to the end of the shank, rad.
const TWIST_RAD: f32 = 1.6;

/// Adds the cutter with its tip at a place, mm, turned by `turn_rad`.
pub fn draw(mesh: &mut Mesh, tool: &Tool, tip: Point, turn_rad: f32, colors: [Color32; 2]) {
    let [x0, y0, z0] = tip;
    let outline = tool.outline();
    let [radius, flat, corner] =
        [outline.edge_mm(), outline.flat_mm(), outline.corner_radius_mm].map(|x| x as f32);
    // Height, radius of the ring, and upward part of its normal.
    let mut rings: Vec<[f32; 3]> = Vec::new();
    if flat > 0.0 {
        rings.extend([[0.0, 0.0, -1.0], [0.0, flat, -1.0]]);
    }
    rings.extend((0..=RINGS).map(|i| {
        let angle = std::f32::consts::FRAC_PI_2 * i as f32 / RINGS as f32;
        [corner - corner * angle.cos(), flat + corner * angle.sin(), -angle.cos()]
    }));
    rings.push([(0.55 * SHANK_MM).max(corner), radius, 0.0]);
    rings.push([SHANK_MM, radius, 0.0]);
    let teeth = tool.teeth as f32;
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
                mesh.corner(
                    [x0 + r * cos, y0 + r * sin, z0 + z],
                    [side * cos, side * sin, up],
                    color,
                )
            })
            .collect();
        if let Some(before) = before.replace(corners.clone()) {
            mesh.strip(&before, &corners);
        }
    }
    let lid: Vec<u32> = (0..=AROUND)
        .map(|k| {
            let (sin, cos) = (std::f32::consts::TAU * k as f32 / AROUND as f32).sin_cos();
            let place = [x0 + radius * cos, y0 + radius * sin, z0 + SHANK_MM];
            mesh.corner(place, [0.0, 0.0, 1.0], colors[0])
        })
        .collect();
    for pair in lid[1..].windows(2) {
        mesh.triangle(lid[0], pair[0], pair[1]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cutter_turns_about_its_axis_and_has_normals_of_length_one() {
        let mut meshes = [0.0, 0.7].map(|turn_rad| {
            let mut mesh = Mesh::default();
            draw(
                &mut mesh,
                &Tool::default(),
                [12.0, 0.0, 0.0],
                turn_rad,
                [Color32::BLACK, Color32::WHITE],
            );
            mesh
        });
        let numbers = |mesh: &Mesh| -> Vec<[f32; 6]> {
            let corners = mesh.corners.chunks_exact(crate::app::scene::mesh::CORNER_BYTES);
            let number = |bytes: &[u8], i: usize| {
                f32::from_ne_bytes(bytes[4 * i..4 * i + 4].try_into().unwrap())
            };
            corners.map(|bytes| std::array::from_fn(|i| number(bytes, i))).collect()
        };
        let [still, turned] = &mut meshes;
        for ([x, y, z, nx, ny, nz], other) in numbers(still).into_iter().zip(numbers(turned)) {
            assert!(((nx * nx + ny * ny + nz * nz).sqrt() - 1.0).abs() < 1e-3);
            assert!(
                (x - 12.0).hypot(y) <= 8.001 && (-0.001..=SHANK_MM).contains(&z),
                "{x} {y} {z}"
            );
            assert_eq!([x, y, z], other[..3], "only the colours turn");
        }
        assert_ne!(still.corners, turned.corners);
    }
}
