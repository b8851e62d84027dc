//! The faces of the part.

use super::{BELOW_MM, Part, ROWS, STEP_MM, Section};
use crate::app::scene::camera::{Point, cross, minus, unit};
use crate::app::scene::mesh::Mesh;

/// Columns of the fine surface along the cut.
const COLUMNS: usize = 420;
/// Columns of the surface that the ball is just cutting.
const FRONT_COLUMNS: usize = 7;

impl Part<'_> {
    /// What no tooth touches, and the stock ahead of the tool.
    pub(super) fn stock(&self, mesh: &mut Mesh, s: &Section, [front, back]: [f32; 2]) {
        let color = self.stock;
        let bottom = -BELOW_MM;
        let (from, to) = (s.from, s.to);
        let floor = -STEP_MM;
        let flat = |mesh: &mut Mesh, [x0, x1]: [f32; 2], [y0, y1]: [f32; 2], z: f32| {
            mesh.face([[x0, y0, z], [x1, y0, z], [x1, y1, z], [x0, y1, z]], color);
        };
        flat(mesh, [from, to], [front, s.wall], floor);
        mesh.face(
            [[from, front, bottom], [to, front, bottom], [to, front, floor], [from, front, floor]],
            color,
        );
        mesh.face(
            [[to, back, bottom], [from, back, bottom], [from, back, s.depth], [to, back, s.depth]],
            color,
        );
        flat(mesh, [from, to], [s.edge, back], s.depth);
        // Ahead of where the ball is just cutting.
        let begins = (self.tool_mm + self.front(s)).clamp(from, to);
        if begins < to {
            self.wall(mesh, s, [begins, to]);
            flat(mesh, [begins, to], [s.wall, s.edge], s.depth);
        }
    }

    /// The wall of uncut stock.
    fn wall(&self, mesh: &mut Mesh, s: &Section, [x0, x1]: [f32; 2]) {
        let (y, low, high) = (s.wall, -STEP_MM, s.depth);
        mesh.face([[x0, y, low], [x1, y, low], [x1, y, high], [x0, y, high]], self.stock);
    }

    /// How far ahead of its axis the ball meets the section at all.
    fn front(&self, s: &Section) -> f32 {
        self.reach(s, s.wall.max(0.0))
    }

    /// How far ahead of its axis the ball meets the surface at a distance across.
    fn reach(&self, s: &Section, y: f32) -> f32 {
        (s.edge * s.edge - y * y).max(0.0).sqrt()
    }

    /// The surface behind the tool, fine inside the window and smooth beyond it.
    pub(super) fn machined(&self, mesh: &mut Mesh, s: &Section) {
        let to = self.tool_mm.min(s.to);
        if to <= s.from || s.edge <= s.wall {
            return;
        }
        let [near, far] = self.window_mm.map(|x| x.clamp(s.from, to));
        let mut columns: Vec<f32> = vec![s.from];
        if far > near {
            // As dense inside the window as if it were one section.
            let width = self.window_mm[1] - self.window_mm[0];
            let count = ((COLUMNS as f32 * (far - near) / width).ceil() as usize).max(2);
            columns.extend((0..=count).map(|i| near + (far - near) * i as f32 / count as f32));
        }
        columns.push(to);
        columns.dedup();
        let smooth = |x: f32| x < self.window_mm[0] || x > self.window_mm[1];
        let place = |x: f32, j: usize| {
            let y = across(s, j);
            // Its border stays where the stock meets it.
            let fine = !(smooth(x) || j == ROWS - 1);
            [x, y, if fine { self.height(x, y) } else { self.outline(y) }]
        };
        let grid: Vec<[Point; ROWS]> =
            columns.iter().map(|x| std::array::from_fn(|j| place(*x, j))).collect();
        let mut before: Option<Vec<u32>> = None;
        let mut wall: Option<[u32; 2]> = None;
        for (i, column) in grid.iter().enumerate() {
            let (left, right) = (&grid[i.saturating_sub(1)], &grid[(i + 1).min(grid.len() - 1)]);
            let color = (self.color)(columns[i]);
            let corners: Vec<u32> = (0..ROWS)
                .map(|j| {
                    let along = minus(right[j], left[j]);
                    let side = minus(column[(j + 1).min(ROWS - 1)], column[j.saturating_sub(1)]);
                    mesh.corner(column[j], unit(cross(along, side)), color)
                })
                .collect();
            if let Some(before) = before.replace(corners.clone()) {
                mesh.strip(&before, &corners);
            }
            // The wall below it has the same upper edge.
            let [x, y, z] = column[0];
            let outwards = [0.0, -1.0, 0.0];
            let edge = [
                mesh.corner([x, y, -STEP_MM.max(-z)], outwards, self.stock),
                mesh.corner([x, y, z], outwards, self.stock),
            ];
            if let Some(before) = wall.replace(edge) {
                mesh.strip(&before, &edge);
            }
        }
    }

    /// What the front of the ball is just cutting.
    pub(super) fn being_cut(&self, mesh: &mut Mesh, s: &Section) {
        let x = self.tool_mm;
        if x < s.from - s.edge || x > s.to || s.edge <= s.wall {
            return;
        }
        let mut before: Option<Vec<u32>> = None;
        for i in 0..=FRONT_COLUMNS {
            let fraction = i as f32 / FRONT_COLUMNS as f32;
            let corners: Vec<u32> = (0..ROWS)
                .map(|j| {
                    let y = across(s, j);
                    let ahead = fraction * self.reach(s, y);
                    let place = [x + ahead, y, self.outline(ahead.hypot(y)).min(s.depth)];
                    let inside = place[0].clamp(s.from, s.to);
                    let normal = self.normal([ahead, y], place[2]);
                    mesh.corner([inside, y, place[2]], normal, self.stock)
                })
                .collect();
            if let Some(before) = before.replace(corners.clone()) {
                mesh.strip(&before, &corners);
            }
        }
        // From there to the straight edge of the stock ahead.
        let to = (x + self.front(s)).min(s.to);
        let flat: Vec<[u32; 2]> = (0..ROWS)
            .map(|j| {
                let y = across(s, j);
                let from = (x + self.reach(s, y)).clamp(s.from, s.to);
                let up = [0.0, 0.0, 1.0];
                let near = mesh.corner([from.min(to), y, s.depth], up, self.stock);
                [near, mesh.corner([to.max(s.from), y, s.depth], up, self.stock)]
            })
            .collect();
        let (near, far): (Vec<u32>, Vec<u32>) = flat.into_iter().map(|[a, b]| (a, b)).unzip();
        mesh.strip(&near, &far);
        // And the wall below it.
        let (y, reach) = (s.wall, self.reach(s, s.wall));
        let ends = [x + reach, x + self.front(s)].map(|x| x.clamp(s.from, s.to));
        self.wall(mesh, s, ends);
        let steps = FRONT_COLUMNS as f32;
        for i in 0..FRONT_COLUMNS {
            let [a, b] = [i, i + 1].map(|k| {
                let ahead = k as f32 / steps * reach;
                let z = self.outline(ahead.hypot(y)).min(s.depth);
                [(x + ahead).clamp(s.from, s.to), y, z]
            });
            let low = -STEP_MM;
            mesh.face([[a[0], y, low], [b[0], y, low], b, a], self.stock);
        }
    }

    /// The upright face at `x` between what stands before and behind it; none is the air beyond
    /// an end of the part.
    pub(super) fn step(
        &self,
        mesh: &mut Mesh,
        x: f32,
        before: Option<&Section>,
        behind: Option<&Section>,
        [front, back]: [f32; 2],
    ) {
        let both = || before.iter().chain(&behind);
        let mut places = vec![front, back];
        for s in both() {
            // Along the ball its outline is a curve.
            places.extend((0..ROWS).map(|j| across(s, j)));
        }
        places.sort_by(f32::total_cmp);
        places.dedup();
        for pair in places.windows(2) {
            let middle = 0.5 * (pair[0] + pair[1]);
            let top = |s: Option<&Section>, y: f32| match s {
                None => -BELOW_MM,
                Some(s) if middle < s.wall => -STEP_MM,
                Some(s) if middle < s.edge && x <= self.tool_mm => self.outline(y),
                Some(s) => s.depth,
            };
            let outwards = if top(before, middle) > top(behind, middle) { 1.0 } else { -1.0 };
            let corners = [(0, before), (1, before), (1, behind), (0, behind)].map(|(i, s)| {
                mesh.corner([x, pair[i], top(s, pair[i])], [outwards, 0.0, 0.0], self.stock)
            });
            mesh.triangle(corners[0], corners[1], corners[2]);
            mesh.triangle(corners[0], corners[2], corners[3]);
        }
    }
}

/// Row `j` of the machined strip of a section.
fn across(s: &Section, j: usize) -> f32 {
    s.wall + (s.edge - s.wall) * j as f32 / (ROWS - 1) as f32
}
