//! The part in space: stock with its steps, the channel that the ball has cut so far, and the fine
//! surface in it, its heights drawn larger by a factor. x along the cut, y across it from the
//! tool's axis, z upwards from the lowest point of the ball, all in mm.

use egui::Color32;

use crate::app::scene::camera::{Point, cross, minus, unit};
use crate::app::scene::mesh::Mesh;
use crate::base::model::part::CutPath;
use crate::blocks::surface::topography::Topography;

/// Stock in front of the wall, behind the channel, below the ball and before an open cut, mm.
const FRONT_MM: f32 = 4.0;
const BEHIND_MM: f32 = 6.0;
const BELOW_MM: f32 = 4.0;
const BEFORE_MM: f32 = 8.0;
/// How much lower the stock in front of the wall is: an earlier cut took it, mm.
const STEP_MM: f32 = 0.6;
/// Columns of the fine surface along the cut, and its rows across.
const COLUMNS: usize = 420;
const ROWS: usize = 13;
/// Columns of the surface that the ball is just cutting.
const FRONT_COLUMNS: usize = 7;

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

/// A stretch of constant depth and wall.
#[derive(Clone, Copy)]
struct Section {
    from: f32,
    to: f32,
    depth: f32,
    wall: f32,
    /// Where the ball meets the surface.
    edge: f32,
}

impl Part<'_> {
    fn radius(&self) -> f32 {
        self.surface.radius_mm() as f32
    }

    /// Half-width of the ball's cut at a depth.
    fn edge(&self, depth: f32) -> f32 {
        let radius = self.radius();
        let depth = depth.min(radius);
        (depth * (2.0 * radius - depth)).max(0.0).sqrt()
    }

    /// Height of the ball above its lowest point at a distance from its axis.
    fn ball(&self, off: f32) -> f32 {
        let radius = self.radius();
        radius - (radius * radius - off * off).max(0.0).sqrt()
    }

    fn sections(&self) -> Vec<Section> {
        let mut begins = self.cut.steps_mm();
        if let Some(first) = begins.first_mut().filter(|_| self.cut.is_open()) {
            *first = f64::from(-BEFORE_MM);
        }
        let ends = begins.iter().skip(1).copied().chain([self.cut.length_mm()]);
        let sections = begins.iter().zip(ends).map(|(from, to)| {
            let [depth, wall] = self.cut.section_at(0.5 * (from + to)).map(|x| x as f32);
            let edge = self.edge(depth);
            Section { from: *from as f32, to: to as f32, depth, wall: wall.min(edge), edge }
        });
        sections.collect()
    }

    /// The middle of what the camera looks at by itself, and the length of the part, mm.
    pub fn extent(&self) -> [f32; 2] {
        let sections = self.sections();
        [sections.first().map_or(0.0, |s| s.from), sections.last().map_or(1.0, |s| s.to)]
    }

    /// Where across the cut the machined strip lies at a place, mm.
    pub fn strip(&self, x: f32) -> Option<[f32; 2]> {
        let section = self.sections().into_iter().find(|s| (s.from..=s.to).contains(&x))?;
        (section.edge > section.wall).then_some([section.wall, section.edge])
    }

    /// Height drawn at a point of the machined surface, mm.
    pub fn height(&self, x: f32, y: f32) -> f32 {
        let fine = self.surface.height_um(f64::from(x), f64::from(y)).unwrap_or(0.0);
        self.ball(y) + self.times * fine as f32 / 1000.0
    }

    /// Adds it to `mesh`.
    pub fn draw(&self, mesh: &mut Mesh) {
        let sections = self.sections();
        let deepest = sections.iter().map(|s| s.edge).fold(1.0, f32::max);
        let back = deepest + BEHIND_MM;
        let front = sections.iter().map(|s| s.wall).fold(0.0, f32::min) - FRONT_MM;
        for section in &sections {
            self.stock(mesh, section, [front, back]);
            self.machined(mesh, section);
            self.being_cut(mesh, section);
        }
        for pair in sections.windows(2) {
            let (a, b) = (&pair[0], &pair[1]);
            let x = a.to;
            let y = a.edge.max(b.edge).min(back);
            let cut = x <= self.tool_mm;
            let from = if cut { y } else { a.wall.min(b.wall) };
            let [low, high] = [a.depth.min(b.depth), a.depth.max(b.depth)];
            let places = [[x, from, low], [x, back, low], [x, back, high], [x, from, high]];
            mesh.face(if a.depth > b.depth { places } else { turned(places) }, self.stock);
            if !cut && a.wall != b.wall {
                let [near, far] = [a.wall.min(b.wall), a.wall.max(b.wall)];
                let low = -STEP_MM;
                let high = if a.wall < b.wall { a.depth } else { b.depth };
                let places = [[x, near, low], [x, far, low], [x, far, high], [x, near, high]];
                mesh.face(if a.wall < b.wall { places } else { turned(places) }, self.stock);
            }
        }
        self.ends(mesh, &sections, [front, back]);
    }

    /// What no tooth touches, and the stock ahead of the tool.
    fn stock(&self, mesh: &mut Mesh, s: &Section, [front, back]: [f32; 2]) {
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
        let ahead = self.tool_mm.clamp(from, to);
        let wall = |mesh: &mut Mesh, [x0, x1]: [f32; 2], top: f32| {
            let places =
                [[x0, s.wall, floor], [x1, s.wall, floor], [x1, s.wall, top], [x0, s.wall, top]];
            mesh.face(places, color);
        };
        let reach = self.reach(s, s.wall);
        let begins = (ahead + reach).min(to);
        if ahead == from && self.tool_mm + reach <= from {
            flat(mesh, [from, to], [s.wall, s.edge], s.depth);
            wall(mesh, [from, to], s.depth);
        } else if begins < to {
            let begins = begins.max(from);
            wall(mesh, [begins, to], s.depth);
            flat(mesh, [begins, to], [s.wall, s.edge], s.depth);
        }
    }

    /// How far ahead of its axis the ball meets the surface at a distance across.
    fn reach(&self, s: &Section, y: f32) -> f32 {
        (s.edge * s.edge - y * y).max(0.0).sqrt()
    }

    /// The surface behind the tool, fine inside the window and smooth beyond it.
    fn machined(&self, mesh: &mut Mesh, s: &Section) {
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
        let across = |j: usize| s.wall + (s.edge - s.wall) * j as f32 / (ROWS - 1) as f32;
        let place = |x: f32, j: usize| {
            let y = across(j);
            // Its border stays where the stock meets it.
            let fine = !(smooth(x) || j == ROWS - 1);
            [x, y, if fine { self.height(x, y) } else { self.ball(y) }]
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
    fn being_cut(&self, mesh: &mut Mesh, s: &Section) {
        let x = self.tool_mm;
        if x < s.from - s.edge || x > s.to || s.edge <= s.wall {
            return;
        }
        let mut before: Option<Vec<u32>> = None;
        for i in 0..=FRONT_COLUMNS {
            let share = i as f32 / FRONT_COLUMNS as f32;
            let corners: Vec<u32> = (0..ROWS)
                .map(|j| {
                    let y = s.wall + (s.edge - s.wall) * j as f32 / (ROWS - 1) as f32;
                    let ahead = share * self.reach(s, y);
                    let place = [x + ahead, y, self.ball(ahead.hypot(y)).min(s.depth)];
                    let inside = place[0].clamp(s.from, s.to);
                    let normal = unit([-ahead, -y, self.radius() - place[2]]);
                    mesh.corner([inside, y, place[2]], normal, self.stock)
                })
                .collect();
            if let Some(before) = before.replace(corners.clone()) {
                mesh.strip(&before, &corners);
            }
        }
        // From there to the straight edge of the stock ahead.
        let reach = self.reach(s, s.wall);
        let to = (x + reach).min(s.to);
        let flat: Vec<[u32; 2]> = (0..ROWS)
            .map(|j| {
                let y = s.wall + (s.edge - s.wall) * j as f32 / (ROWS - 1) as f32;
                let from = (x + self.reach(s, y)).clamp(s.from, s.to);
                let up = [0.0, 0.0, 1.0];
                let near = mesh.corner([from.min(to), y, s.depth], up, self.stock);
                [near, mesh.corner([to.max(s.from), y, s.depth], up, self.stock)]
            })
            .collect();
        let (near, far): (Vec<u32>, Vec<u32>) = flat.into_iter().map(|[a, b]| (a, b)).unzip();
        mesh.strip(&near, &far);
        // And the wall below it.
        let y = s.wall;
        let steps = FRONT_COLUMNS as f32;
        for i in 0..FRONT_COLUMNS {
            let [a, b] = [i, i + 1].map(|k| {
                let ahead = k as f32 / steps * reach;
                let z = self.ball(ahead.hypot(y)).min(s.depth);
                [(x + ahead).clamp(s.from, s.to), y, z]
            });
            let low = -STEP_MM;
            mesh.face([[a[0], y, low], [b[0], y, low], b, a], self.stock);
        }
    }

    /// The faces at both ends.
    fn ends(&self, mesh: &mut Mesh, sections: &[Section], [front, back]: [f32; 2]) {
        let (Some(first), Some(last)) = (sections.first(), sections.last()) else { return };
        for (s, x, outwards) in [(first, first.from, -1.0_f32), (last, last.to, 1.0)] {
            let cut = x <= self.tool_mm;
            let mut outline = vec![(front, -STEP_MM), (s.wall, -STEP_MM)];
            if cut {
                outline.extend((0..ROWS).map(|j| {
                    let y = s.wall + (s.edge - s.wall) * j as f32 / (ROWS - 1) as f32;
                    (y, self.ball(y))
                }));
            }
            outline.extend([(if cut { s.edge } else { s.wall }, s.depth), (back, s.depth)]);
            for pair in outline.windows(2) {
                let ((y0, z0), (y1, z1)) = (pair[0], pair[1]);
                let low = -BELOW_MM;
                let places = [[x, y0, low], [x, y1, low], [x, y1, z1], [x, y0, z0]];
                mesh.face(if outwards > 0.0 { places } else { turned(places) }, self.stock);
            }
        }
    }
}

/// The same face seen from the other side.
fn turned([a, b, c, d]: [Point; 4]) -> [Point; 4] {
    [b, a, d, c]
}
