//! A rectangular blank as a map of heights, and what a tool takes from it along a short straight piece of its way.
//!
//! The map has the height of the material over the middle of every cell of a grid (z-map; van Hook 1986, Real-time shaded
//! NC milling display). A tool that moves by a piece takes all that stands above its swept surface:
//!
//! ```text
//! z(cell) = z_tip(nearest point of the piece) + h(distance to it),   h the tool's outline
//! ```
//!
//! which is exact for a piece at one height; for a sloping one its end counts too.

use crate::base::language::tr;
use crate::models::tool::Outline;

/// Most cells of a map: 32 MB.
pub const MOST_CELLS: f64 = 4e6;
/// Least and largest size of a blank, mm.
pub const SIZES_MM: [f64; 2] = [1.0, 5000.0];
/// What counts as taken from a cell, mm: less is rounding.
const TAKEN_MM: f64 = 1e-6;

/// A rectangular blank.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Blank {
    /// Its corner with the least x, y and z, mm.
    pub corner_mm: [f64; 3],
    /// Its size along x, y and z, mm.
    pub size_mm: [f64; 3],
}

impl Blank {
    /// A blank whose top is at z = 0 and whose corner is at x = y = 0, where no corner is given.
    ///
    /// # Errors
    /// A size outside [`SIZES_MM`], or a corner that is no number.
    pub fn new(size_mm: [f64; 3], corner_mm: Option<[f64; 3]>) -> Result<Self, String> {
        let [least, most] = SIZES_MM;
        for (size, axis) in size_mm.iter().zip(["X", "Y", "Z"]) {
            if !(least..=most).contains(size) {
                return Err(tr!(
                    "the blank's size along {axis} is {size} mm: allowed is {least} to {most} mm",
                    axis = axis,
                    size = *size,
                    least = least,
                    most = most
                ));
            }
        }
        let corner_mm = corner_mm.unwrap_or([0.0, 0.0, -size_mm[2]]);
        if !corner_mm.iter().all(|x| x.abs() <= 1e6) {
            return Err(tr("the blank's corner has to be three numbers in mm").to_owned());
        }
        Ok(Self { corner_mm, size_mm })
    }

    /// Height of its top, mm.
    #[must_use]
    pub fn top_mm(&self) -> f64 {
        self.corner_mm[2] + self.size_mm[2]
    }

    /// The grid of a map with cells of at most `cell_mm`: their numbers along x and y.
    ///
    /// # Errors
    /// More than [`MOST_CELLS`].
    fn grid(&self, cell_mm: f64) -> Result<[usize; 2], String> {
        let cells = [0, 1].map(|i: usize| (self.size_mm[i] / cell_mm).ceil());
        let all = cells[0] * cells[1];
        if all > MOST_CELLS {
            return Err(tr!(
                "a grid of {cell} mm over the blank has {n} cells: allowed are {most}; a larger step has fewer",
                cell = cell_mm,
                n = all,
                most = MOST_CELLS
            ));
        }
        Ok(cells.map(|cells| cells as usize))
    }
}

/// The heights of a blank.
#[derive(Clone, Debug, PartialEq)]
pub struct HeightMap {
    blank: Blank,
    /// Cells along x and y, and their sizes, mm.
    cells: [usize; 2],
    cell_mm: [f64; 2],
    /// Row by row along x.
    heights_mm: Vec<f64>,
}

/// A cell from which something was taken.
pub(super) struct TakenCell {
    /// Its place among all, row by row along x.
    pub(super) index: usize,
    /// Its height before and after, mm.
    before_mm: f64,
    after_mm: f64,
    /// Where its middle lies from the end of the piece, mm.
    from_end_mm: [f64; 2],
}

/// What a piece has taken.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CutAway {
    /// Volume, mm^3.
    pub removed_mm3: f64,
    /// Height of the highest material above the tip, mm: the axial depth.
    pub axial_mm: f64,
    /// Least and largest place across the feed, from the axis, of what was taken in every strip along it, mm.
    strips: Vec<[f64; 2]>,
}

impl HeightMap {
    /// The map of a whole blank with cells of at most `cell_mm`.
    ///
    /// # Errors
    /// Too many cells.
    pub fn new(blank: Blank, cell_mm: f64) -> Result<Self, String> {
        let cells = blank.grid(cell_mm)?;
        let sizes_mm = [0, 1].map(|i: usize| blank.size_mm[i] / cells[i] as f64);
        let heights_mm = vec![blank.top_mm(); cells[0] * cells[1]];
        Ok(Self { blank, cells, cell_mm: sizes_mm, heights_mm })
    }

    /// The blank.
    #[must_use]
    pub fn blank(&self) -> &Blank {
        &self.blank
    }

    /// Numbers of cells along x and y.
    #[must_use]
    pub fn cells(&self) -> [usize; 2] {
        self.cells
    }

    /// The largest side of a cell, mm.
    #[must_use]
    pub fn cell_mm(&self) -> f64 {
        self.cell_mm[0].max(self.cell_mm[1])
    }

    /// Height of a cell, counted from 0 along x and y, mm; none outside the blank.
    #[must_use]
    pub fn height_mm(&self, [x, y]: [usize; 2]) -> Option<f64> {
        let [columns, rows] = self.cells;
        (x < columns && y < rows).then(|| self.heights_mm[y * columns + x])
    }

    /// Heights of all cells, row by row along x, mm.
    pub(super) fn heights_mm(&self) -> &[f64] {
        &self.heights_mm
    }

    /// Volume that was taken from the blank so far, mm^3.
    #[must_use]
    pub fn removed_mm3(&self) -> f64 {
        let top = self.blank.top_mm();
        let depths: f64 = self.heights_mm.iter().map(|height| top - height).sum();
        depths * self.cell_mm[0] * self.cell_mm[1]
    }

    /// The cells of an axis whose middles may lie between two places, mm.
    fn range(&self, axis: usize, low_mm: f64, high_mm: f64) -> std::ops::Range<usize> {
        let place = |at_mm: f64| (at_mm - self.blank.corner_mm[axis]) / self.cell_mm[axis] - 0.5;
        let most = self.cells[axis] as f64;
        let first = place(low_mm).ceil().clamp(0.0, most) as usize;
        let end = (place(high_mm).floor() + 1.0).clamp(0.0, most) as usize;
        first..end.max(first)
    }

    /// Lets a tool's tip go straight from one point to another; adds what it takes, seen along the direction `along`
    /// in x and y (of length 1), to `taken`.
    pub fn cut(
        &mut self,
        outline: &Outline,
        ends: [[f64; 3]; 2],
        along: [f64; 2],
        taken: &mut CutAway,
    ) {
        let radius = outline.edge_mm();
        let (area, cell_mm) = (self.cell_mm[0] * self.cell_mm[1], self.cell_mm());
        let tip = self.tip_mm(ends);
        self.cut_each(outline, ends, |cell: TakenCell| {
            taken.removed_mm3 += (cell.before_mm - cell.after_mm) * area;
            taken.axial_mm = taken.axial_mm.max(cell.before_mm - tip);
            let [ex, ey] = cell.from_end_mm;
            taken.see(ey * along[0] - ex * along[1], radius, cell_mm);
        });
    }

    /// The lowest height of the tip within the blank, mm.
    fn tip_mm(&self, [from, to]: [[f64; 3]; 2]) -> f64 {
        from[2].min(to[2]).max(self.blank.corner_mm[2])
    }

    /// Takes what [`Self::cut`] takes, and tells every cell of it.
    pub(super) fn cut_each(
        &mut self,
        outline: &Outline,
        [from, to]: [[f64; 3]; 2],
        mut tell: impl FnMut(TakenCell),
    ) {
        let radius = outline.edge_mm();
        let bottom = self.blank.corner_mm[2];
        let tip = self.tip_mm([from, to]);
        if tip >= self.blank.top_mm() {
            return;
        }
        let flat = outline.flat_mm();
        let height = |square: f64| {
            if square <= flat * flat { 0.0 } else { outline.height_mm(square.sqrt()) }
        };
        let [dx, dy, dz] = [0, 1, 2].map(|i: usize| to[i] - from[i]);
        let square = dx * dx + dy * dy;
        let per_square = if square > 0.0 { 1.0 / square } else { 0.0 };
        // A level ball leaves most cells below it as they are, which is seen without a root.
        let level_ball = outline.is_ball() && dz == 0.0;
        let columns = self.range(0, from[0].min(to[0]) - radius, from[0].max(to[0]) + radius);
        for row in self.range(1, from[1].min(to[1]) - radius, from[1].max(to[1]) + radius) {
            let y = self.blank.corner_mm[1] + (row as f64 + 0.5) * self.cell_mm[1];
            for column in columns.clone() {
                let before = self.heights_mm[row * self.cells[0] + column];
                if before <= tip {
                    continue;
                }
                let x = self.blank.corner_mm[0] + (column as f64 + 0.5) * self.cell_mm[0];
                let [px, py] = [x - from[0], y - from[1]];
                let [ex, ey] = [x - to[0], y - to[1]];
                let share = if square > 0.0 {
                    ((px * dx + py * dy) * per_square).clamp(0.0, 1.0)
                } else {
                    1.0
                };
                let [ox, oy] = [px - share * dx, py - share * dy];
                let off = ox * ox + oy * oy;
                if off >= radius * radius {
                    continue;
                }
                let below = radius - (before - from[2]);
                if level_ball && below >= 0.0 && below * below >= radius * radius - off {
                    continue;
                }
                let mut after = from[2] + share * dz + height(off);
                let end = ex * ex + ey * ey;
                if dz != 0.0 && end < radius * radius {
                    after = after.min(to[2] + height(end));
                }
                let after = after.max(bottom);
                if before - after <= TAKEN_MM {
                    continue;
                }
                let index = row * self.cells[0] + column;
                self.heights_mm[index] = after;
                tell(TakenCell {
                    index,
                    before_mm: before,
                    after_mm: after,
                    from_end_mm: [ex, ey],
                });
            }
        }
    }
}

impl CutAway {
    /// Number of strips across a tool: each is wider than a cell, so that none is left out between two rows of cells.
    fn count(radius_mm: f64, cell_mm: f64) -> usize {
        ((2.0 * radius_mm / (1.5 * cell_mm)) as usize).max(1)
    }

    /// Something was taken at a place across the feed, from the axis.
    fn see(&mut self, across_mm: f64, radius_mm: f64, cell_mm: f64) {
        let count = Self::count(radius_mm, cell_mm);
        if self.strips.len() != count {
            self.strips = vec![[f64::INFINITY, f64::NEG_INFINITY]; count];
        }
        let place = (0.5 + 0.5 * across_mm / radius_mm) * count as f64;
        let strip = &mut self.strips[(place.max(0.0) as usize).min(count - 1)];
        *strip = [strip[0].min(across_mm), strip[1].max(across_mm)];
    }

    /// Width of what was taken across the feed, without what is left between, mm: the radial depth.
    #[must_use]
    pub fn radial_mm(&self, outline: &Outline, cell_mm: f64) -> f64 {
        let (mut width, mut open): (f64, Option<[f64; 2]>) = (0.0, None);
        for [low, high] in &self.strips {
            if low <= high {
                open = Some([open.map_or(*low, |[low, _]| low), *high]);
            } else if let Some([low, high]) = open.take() {
                width += high - low + cell_mm;
            }
        }
        if let Some([low, high]) = open {
            width += high - low + cell_mm;
        }
        width.min(outline.diameter_mm)
    }
}
