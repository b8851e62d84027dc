//! The surface of a blank as triangles: its heights over a grid, and its sides.

use egui::Color32;

use crate::app::scene::camera::{Point, unit};
use crate::app::scene::mesh::Mesh;
use crate::study::part::carved::{CarvedBlank, CutBy};

/// Adds it; what no feed move has cut has the stock's colour, the rest that of its place on the way in mm.
pub fn draw(mesh: &mut Mesh, carved: &CarvedBlank, stock: Color32, color: &dyn Fn(f64) -> Color32) {
    let map = carved.map();
    let (blank, [columns, rows]) = (map.blank(), map.cells());
    let bottom = blank.corner_mm[2] as f32;
    let at = |i: usize, index: usize, count: usize| {
        let (corner, size) = (blank.corner_mm[i], blank.size_mm[i]);
        // The outermost cells reach to the sides.
        let share = match index {
            0 => 0.0,
            _ if index + 1 == count => 1.0,
            _ => (index as f64 + 0.5) / count as f64,
        };
        (corner + share * size) as f32
    };
    let xs: Vec<f32> = (0..columns).map(|column| at(0, column, columns)).collect();
    let ys: Vec<f32> = (0..rows).map(|row| at(1, row, rows)).collect();
    let height =
        |column: usize, row: usize| map.height_mm([column, row]).map_or(bottom, |z| z as f32);
    // One colour for all cells of a piece.
    let mut known: Vec<Option<Color32>> = Vec::new();
    let mut color_of = |cell: usize| match carved.cut_by(cell) {
        CutBy::Nothing | CutBy::Rapid => stock,
        CutBy::Piece(piece) => {
            if known.len() <= piece {
                known.resize(piece + 1, None);
            }
            *known[piece].get_or_insert_with(|| carved.piece_end_mm(piece).map_or(stock, &color))
        }
    };
    let mut before: Option<Vec<u32>> = None;
    for row in 0..rows {
        let corners: Vec<u32> = (0..columns)
            .map(|column| {
                let [left, right] = [column.saturating_sub(1), (column + 1).min(columns - 1)];
                let [front, back] = [row.saturating_sub(1), (row + 1).min(rows - 1)];
                let slope = |rise: f32, run: f32| if run > 0.0 { rise / run } else { 0.0 };
                let along = slope(height(right, row) - height(left, row), xs[right] - xs[left]);
                let across =
                    slope(height(column, back) - height(column, front), ys[back] - ys[front]);
                let place = [xs[column], ys[row], height(column, row)];
                mesh.corner(place, unit([-along, -across, 1.0]), color_of(row * columns + column))
            })
            .collect();
        if let Some(before) = before.replace(corners.clone()) {
            for column in 0..columns.saturating_sub(1) {
                let cells =
                    [(column, row - 1), (column + 1, row - 1), (column, row), (column + 1, row)];
                // Where all is cut through nothing is left.
                if cells.iter().all(|(column, row)| height(*column, *row) <= bottom) {
                    continue;
                }
                let (a, b) = (before[column], before[column + 1]);
                let (c, d) = (corners[column], corners[column + 1]);
                mesh.triangle(a, b, d);
                mesh.triangle(a, d, c);
            }
        }
    }
    let top = |column: usize, row: usize| [xs[column], ys[row], height(column, row)];
    let front = (0..columns).map(|column| top(column, 0));
    side(mesh, front.collect(), bottom, [0.0, -1.0, 0.0], stock);
    let back = (0..columns).map(|column| top(column, rows - 1));
    side(mesh, back.collect(), bottom, [0.0, 1.0, 0.0], stock);
    let left = (0..rows).map(|row| top(0, row));
    side(mesh, left.collect(), bottom, [-1.0, 0.0, 0.0], stock);
    let right = (0..rows).map(|row| top(columns - 1, row));
    side(mesh, right.collect(), bottom, [1.0, 0.0, 0.0], stock);
}

/// A side from its upper edge down to the bottom.
fn side(mesh: &mut Mesh, edge: Vec<Point>, bottom: f32, outwards: Point, stock: Color32) {
    let mut before: Option<[u32; 2]> = None;
    for [x, y, z] in edge {
        let corners =
            [mesh.corner([x, y, bottom], outwards, stock), mesh.corner([x, y, z], outwards, stock)];
        if let Some(before) = before.replace(corners) {
            mesh.strip(&before, &corners);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::scene::mesh::CORNER_BYTES;
    use crate::models::tool::Tool;
    use crate::study::part::blank::Blank;
    use crate::study::part::gcode::GCodeProgram;

    /// A slot 2 mm deep through a blank of 40 x 30 x 5 mm, with the papers' ball of 16 mm, cut to 20 mm of its way.
    fn drawn() -> (CarvedBlank, Mesh) {
        let program = GCodeProgram::read("G0 X0 Y15\nG0 Z-2\nG1 X40 F300\n").unwrap();
        let blank = Blank::new([40.0, 30.0, 5.0], None).unwrap();
        let outline = Tool::default().outline();
        let mut carved = CarvedBlank::new(&program, blank, outline, 0.5).unwrap();
        carved.go_to(20.0, usize::MAX);
        let mut mesh = Mesh::default();
        draw(&mut mesh, &carved, Color32::WHITE, &|s_mm| {
            Color32::from_rgb(s_mm.round() as u8, 0, 0)
        });
        (carved, mesh)
    }

    fn corners(mesh: &Mesh) -> Vec<(Point, Point, Color32)> {
        let number = |bytes: &[u8], i: usize| {
            f32::from_ne_bytes(bytes[4 * i..4 * i + 4].try_into().unwrap())
        };
        let corners = mesh.corners.chunks_exact(CORNER_BYTES);
        let read = |bytes: &[u8]| {
            let [place, normal] = [0, 3].map(|from| [0, 1, 2].map(|i| number(bytes, from + i)));
            (place, normal, Color32::from_rgb(bytes[24], bytes[25], bytes[26]))
        };
        corners.map(read).collect()
    }

    #[test]
    fn it_reaches_to_all_sides_and_has_the_colour_of_where_the_tool_was() {
        let (carved, mesh) = drawn();
        let corners = corners(&mesh);
        let span = |i: usize| {
            let at = corners.iter().map(|(place, ..)| place[i]);
            at.fold([f32::INFINITY, f32::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
        };
        assert_eq!([0, 1, 2].map(span), [[0.0, 40.0], [0.0, 30.0], [-5.0, 0.0]]);
        let [columns, rows] = carved.map().cells();
        for ([x, y, z], [nx, ny, nz], color) in &corners[..columns * rows] {
            assert!(((nx * nx + ny * ny + nz * nz).sqrt() - 1.0).abs() < 1e-3);
            if *color == Color32::WHITE {
                assert!(*z == 0.0, "what no tool has met stands");
            } else {
                assert!(*z < 0.0 && (y - 15.0).abs() < 8.0 && *x < 28.1, "{x} {y} {z}");
                // The ball meets a place last half a way across its cap of 10.6 mm before it is left.
                let behind = f32::from(color.r()) - x;
                assert!((-8.5..=8.5).contains(&behind), "{behind}");
            }
        }
        let most = mesh.triangles.iter().max().copied().unwrap();
        assert!((most as usize) < corners.len() && mesh.triangles.len() < 3 * 100_000);
    }

    #[test]
    fn where_it_is_cut_through_nothing_is_drawn() {
        let through = |depth: &str| {
            let program = format!("G0 X0 Y15\nG0 Z-{depth}\nG1 X40 F300\n");
            let program = GCodeProgram::read(&program).unwrap();
            let blank = Blank::new([40.0, 30.0, 5.0], None).unwrap();
            let outline = Tool::default().outline();
            let mut carved = CarvedBlank::new(&program, blank, outline, 0.5).unwrap();
            carved.go_to(40.0, usize::MAX);
            let mut mesh = Mesh::default();
            draw(&mut mesh, &carved, Color32::WHITE, &|_| Color32::RED);
            mesh.triangles.len()
        };
        assert!(through("9") < through("4.9"));
    }
}
