//! The machined surface point by point: what every tooth has left of it, and the texture that the
//! feed marks do not explain.
//!
//! ```text
//! tooth k at x_k leaves    y_k(x, y) = z_k + s(x - x_k, y) - s(0, y),  s the outline of the end: for a
//!                          ball s(d, y) = R - (R^2 - d^2 - y^2)^1/2   ([`crate::models::tool::Outline`])
//! the marks are the lowest Y(x, y)  = min over k of y_k(x, y)          (2019, roughness of the profile)
//! texture                  w(x, y)  = sigma_k g(x, y),  sigma_k = (pi/2)^1/2 (Ra^2 - Ra_marks^2)^1/2
//! height                   h        = Y + w
//! ```
//!
//! Heights are counted from the shape that the turning cutter would leave without feed: x along the
//! cut, y across it from the tool's axis, R the ball's radius; an ideal flat has no dish. z_k is what run-out and vibration
//! add at the moment at which tooth k generates the surface. g is a random field of unit variance
//! on a grid of 20 um along the cut and of 0.4 mm across it: marks lie across the feed. Ra of the run
//! is that of the papers' formulas, which is several times what feed marks alone give
//! (4 R_t / (9 3^1/2) with R_t = f_z^2 / (8 R)): the texture makes up the difference (chosen), so that a
//! measured profile has the run's Ra.

use crate::base::math;
use crate::base::rng::Stream;
use crate::models::roughness_trend::CUSP_RATIO;
use crate::models::tool::Outline;

/// Standard deviation of a normal deviate over its mean magnitude: (pi/2)^1/2.
const DEVIATION_OVER_RA: f64 = 1.253_314_137_315_5;
/// Grid of the texture along and across the cut, mm.
const GRID_MM: [f64; 2] = [0.02, 0.4];
/// Half width, in feeds per tooth, of the window searched for the mark that is lowest at a point.
const REACH_TEETH: f64 = 3.0;

/// What a tooth has left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToothMark {
    /// Where along the cut, mm.
    pub x_mm: f64,
    /// Height above the ideal surface, mm.
    pub z_mm: f64,
    /// Ra that the surface has here according to the run, um.
    pub ra_um: f64,
}

/// The surface along a cut.
#[derive(Clone, Debug)]
pub struct Topography {
    outline: Outline,
    texture: Stream,
    marks: Vec<ToothMark>,
    /// Spread of the z_k, mm: how deep a mark may lie below its neighbours.
    deepest_mm: f64,
}

impl Topography {
    /// A surface without a mark, of a cutter with this outline.
    #[must_use]
    pub fn new(outline: Outline, seed: u32) -> Self {
        let texture = Stream::new(u64::from(seed), "surface.texture");
        Self { outline, texture, marks: Vec::new(), deepest_mm: 0.0 }
    }

    /// Adds the mark of the next tooth; one that does not lie further along is left out.
    pub fn push(&mut self, mark: ToothMark) {
        if self.marks.last().is_none_or(|last| mark.x_mm > last.x_mm) {
            self.deepest_mm = self.deepest_mm.max(mark.z_mm.abs());
            self.marks.push(mark);
        }
    }

    /// Marks so far.
    #[must_use]
    pub fn marks(&self) -> &[ToothMark] {
        &self.marks
    }

    /// The outline of the cutter.
    #[must_use]
    pub fn outline(&self) -> &Outline {
        &self.outline
    }

    /// From the first mark to the last one, mm; nothing without marks.
    #[must_use]
    pub fn range_mm(&self) -> Option<[f64; 2]> {
        Some([self.marks.first()?.x_mm, self.marks.last()?.x_mm])
    }

    /// The height in um at a point in mm; nothing where no tooth has been.
    #[must_use]
    pub fn height_um(&self, x_mm: f64, y_mm: f64) -> Option<f64> {
        let [first, last] = self.range_mm()?;
        if !(first..=last).contains(&x_mm) || y_mm.abs() >= self.outline.edge_mm() {
            return None;
        }
        let after = self.marks.partition_point(|mark| mark.x_mm < x_mm).max(1);
        let here = self.marks[after.min(self.marks.len() - 1)];
        let feed_mm = here.x_mm - self.marks[after.min(self.marks.len() - 1) - 1].x_mm;
        // Two marks of a spread of z reach as far as the parabola between them.
        let reach_mm = REACH_TEETH * feed_mm + self.outline.reach_mm(self.deepest_mm);
        let from = self.marks.partition_point(|mark| mark.x_mm < x_mm - reach_mm);
        let mut lowest_mm = f64::INFINITY;
        for mark in self.marks[from..].iter().take_while(|mark| mark.x_mm <= x_mm + reach_mm) {
            lowest_mm = lowest_mm.min(mark.z_mm + self.outline.rise_mm(x_mm - mark.x_mm, y_mm));
        }
        let marks_um = lowest_mm * 1000.0;
        marks_um.is_finite().then(|| marks_um + self.texture_um(x_mm, y_mm, &here, feed_mm))
    }

    fn texture_um(&self, x_mm: f64, y_mm: f64, mark: &ToothMark, feed_mm: f64) -> f64 {
        let marks_ra_um = CUSP_RATIO * 1000.0 * self.outline.cusp_at_mm(feed_mm, y_mm);
        let rest = math::positive(mark.ra_um * mark.ra_um - marks_ra_um * marks_ra_um).sqrt();
        DEVIATION_OVER_RA * rest * self.field(x_mm / GRID_MM[0], y_mm / GRID_MM[1])
    }

    /// The random field at a point of its grid: between its nodes bilinear, scaled to unit variance.
    fn field(&self, x: f64, y: f64) -> f64 {
        let (column, row) = (x.floor(), y.floor());
        let (u, v) = (x - column, y - row);
        let node = |i: i64, j: i64| {
            // Two numbers of 32 bits make the counter; they wrap far outside any part.
            let word = |n: i64| (n as u64) & 0xffff_ffff;
            self.texture.normal((word(column as i64 + i) << 32) | word(row as i64 + j))
        };
        let along = |j: i64| (1.0 - u) * node(0, j) + u * node(1, j);
        let value = (1.0 - v) * along(0) + v * along(1);
        let scale = |t: f64| (1.0 - t) * (1.0 - t) + t * t;
        value / (scale(u) * scale(v)).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn even(feed_mm: f64, ra_um: f64, z_mm: impl Fn(usize) -> f64) -> Topography {
        let mut surface = Topography::new(Outline::ball(8.0), 1);
        for k in 0..400 {
            surface.push(ToothMark { x_mm: k as f64 * feed_mm, z_mm: z_mm(k), ra_um });
        }
        surface
    }

    /// Ra in um over whole feeds, no filter.
    fn ra_um(surface: &Topography, from_mm: f64, length_mm: f64, y_mm: f64) -> f64 {
        let n = 20_000;
        let heights: Vec<f64> = (0..n)
            .map(|i| from_mm + length_mm * (f64::from(i) + 0.5) / f64::from(n))
            .map(|x| surface.height_um(x, y_mm).unwrap())
            .collect();
        let mean = heights.iter().sum::<f64>() / f64::from(n);
        heights.iter().map(|h| (h - mean).abs()).sum::<f64>() / f64::from(n)
    }

    #[test]
    fn feed_marks_have_the_roughness_of_the_exact_circle() {
        // f = 0.2 mm, R = 8 mm: Ra 1.60380086805511e-4 mm.
        let ra = ra_um(&even(0.2, 0.0, |_| 0.0), 10.0, 4.0, 0.0);
        assert!((ra / 0.160_380_086_8 - 1.0).abs() < 1e-4, "{ra}");
        // Across the cut the cutter's circle is smaller, and the marks are higher.
        let side = ra_um(&even(0.2, 0.0, |_| 0.0), 10.0, 4.0, 4.0);
        assert!((side / ra - 8.0 / 48.0_f64.sqrt()).abs() < 1e-3, "{side}");
    }

    #[test]
    fn run_out_shows_and_one_tooth_disappears_when_it_is_large() {
        // f = 0.1 mm, R = 8 mm, e = 0.3 um: Ra 1.141531254977513e-4 mm.
        let ra = ra_um(&even(0.1, 0.0, |k| 0.0003 * (k % 2) as f64), 10.0, 4.0, 0.0);
        assert!((ra / 0.114_153_125_5 - 1.0).abs() < 1e-3, "{ra}");
        let one = ra_um(&even(0.1, 0.0, |k| 0.0007 * (k % 2) as f64), 10.0, 4.0, 0.0);
        assert!((one / 0.160_375_074_8 - 1.0).abs() < 1e-3, "{one}");
    }

    #[test]
    fn the_texture_brings_the_surface_to_the_roughness_of_the_run() {
        for (feed, ra_run) in [(0.05, 0.8), (0.135, 0.8), (0.2, 0.4)] {
            let surface = even(feed, ra_run, |_| 0.0);
            let ra = ra_um(&surface, 2.0, 16.0, 0.0);
            assert!((ra / ra_run - 1.0).abs() < 0.06, "{feed}: {ra} against {ra_run}");
        }
    }

    #[test]
    fn there_is_no_height_where_no_tooth_has_been() {
        let surface = even(0.1, 0.8, |_| 0.0);
        assert_eq!(surface.height_um(-0.01, 0.0), None);
        assert_eq!(surface.height_um(1.0, 8.0), None);
        assert_eq!(Topography::new(Outline::ball(8.0), 1).height_um(0.0, 0.0), None);
        assert_eq!(surface.height_um(f64::NAN, 0.0), None);
    }
}
