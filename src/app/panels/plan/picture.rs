//! What the map shows of the problem itself, worked out once: the force surface as an image with
//! all that is not allowed in grey, the lines of equal force, and the boundaries of the seven
//! constraints.

use egui::{Color32, ColorImage, Context, TextureHandle, TextureOptions, lerp};

use super::polyline::joined;
use crate::app::format::round_step;
use crate::app::theme::Palette;
use crate::study::plan::contour::Segment;
use crate::study::plan::field::PlanField;
use crate::study::plan::problem::{CUTTING_SPEED_M_MIN, FEED_PER_TOOTH_MM, Problem};

/// Samples over the cutting speed and over the feed per tooth.
pub const SAMPLES: [usize; 2] = [89, 67];
/// Pixels of the image for one step of the samples.
const FINER: usize = 4;
/// Approximate number of lines of equal force.
const FORCE_LINES: f64 = 9.0;

/// A line over cutting speed in m/min and feed per tooth in mm.
pub type Polyline = Vec<[f64; 2]>;

/// The boundary of a constraint.
pub struct Boundary {
    /// Its pieces; none where it lies outside the map.
    pub lines: Vec<Polyline>,
    /// Whether the constraint is kept somewhere on the map.
    pub kept_somewhere: bool,
}

/// Name of the image among the textures.
const NAME: &str = "force map";

/// See the head of this file.
pub struct Picture {
    field: PlanField,
    range_n: [f64; 2],
    boundaries: [Boundary; 7],
    force_lines: Vec<(f64, Vec<Polyline>)>,
    /// The image, and whether it is the dark one.
    texture: Option<(bool, TextureHandle)>,
}

impl Picture {
    /// The picture of a problem.
    #[must_use]
    pub fn new(problem: &Problem) -> Self {
        let field = PlanField::new(problem, SAMPLES[0], SAMPLES[1]);
        let ends = |axis: &[f64]| axis[axis.len() - 1] - axis[0];
        let near = [1e-9 * ends(&field.cutting_speed_m_min), 1e-9 * ends(&field.feed_per_tooth_mm)];
        let line = |segments: Vec<Segment>| joined(segments, near);
        let boundaries = std::array::from_fn(|i| Boundary {
            lines: line(field.boundary(i)),
            kept_somewhere: field.excess[i].iter().any(|excess| *excess <= 0.0),
        });
        let range_n = field.force_n.iter().fold([f64::INFINITY, 0.0], |[low, high], force| {
            [f64::min(low, *force), f64::max(high, *force)]
        });
        let step_n = round_step((range_n[1] - range_n[0]) / FORCE_LINES).unwrap_or(f64::INFINITY);
        let count = (range_n[1] / step_n).floor() as u32;
        let levels = (1..=count).map(|k| f64::from(k) * step_n);
        let levels = levels.filter(|level| *level > range_n[0]);
        let force_lines = levels.map(|level| (level, line(field.force_line(level)))).collect();
        Self { boundaries, force_lines, range_n, field, texture: None }
    }

    /// The boundary of a constraint by its number in the list of seven.
    #[must_use]
    pub fn boundary(&self, constraint: usize) -> &Boundary {
        &self.boundaries[constraint]
    }

    /// Lines of equal force with their force in N.
    #[must_use]
    pub fn force_lines(&self) -> &[(f64, Vec<Polyline>)] {
        &self.force_lines
    }

    /// The part of the map that holds allowed cuts, with some room around it: ranges of cutting
    /// speed in m/min and feed per tooth in mm.
    #[must_use]
    pub fn allowed(&self) -> Option<[[f64; 2]; 2]> {
        let columns = SAMPLES[0];
        let mut ranges = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        for i in (0..self.field.violation.len()).filter(|i| self.field.violation[*i] == 0.0) {
            let (x, y) = (
                self.field.cutting_speed_m_min[i % columns],
                self.field.feed_per_tooth_mm[i / columns],
            );
            for (range, value) in ranges.iter_mut().zip([x, y]) {
                *range = [range[0].min(value), range[1].max(value)];
            }
        }
        // A step around it, for the boundary lies between two samples; and a little of what lies
        // beyond the edge of the map.
        let wider = |[low, high]: [f64; 2], axis: &[f64], whole: [f64; 2]| {
            let room = 1.5 * (axis[1] - axis[0]) + 0.05 * (high - low);
            let edge = 0.04 * (high - low + room);
            [(low - room).max(whole[0] - edge), (high + room).min(whole[1] + edge)]
        };
        let field = &self.field;
        let found = ranges[0][0] <= ranges[0][1];
        found.then(|| {
            [
                wider(ranges[0], &field.cutting_speed_m_min, CUTTING_SPEED_M_MIN),
                wider(ranges[1], &field.feed_per_tooth_mm, FEED_PER_TOOTH_MM),
            ]
        })
    }

    /// The samples.
    #[must_use]
    pub fn field(&self) -> &PlanField {
        &self.field
    }

    /// Least and largest force on the map, N.
    #[must_use]
    pub fn range_n(&self) -> [f64; 2] {
        self.range_n
    }

    /// The colour of a force in N, where it is allowed and where not.
    #[must_use]
    pub fn color(&self, palette: &Palette, force_n: f64, allowed: bool) -> Color32 {
        let [low, high] = self.range_n;
        let fraction =
            ((force_n - low) / (high - low).max(f64::MIN_POSITIVE)).clamp(0.0, 1.0) as f32;
        let [from, to] = if allowed { palette.force } else { palette.barred };
        let mix = |from: u8, to: u8| lerp(f32::from(from)..=f32::from(to), fraction).round() as u8;
        Color32::from_rgb(mix(from.r(), to.r()), mix(from.g(), to.g()), mix(from.b(), to.b()))
    }

    /// The image in the colours of `palette`; drawn again only where they have changed.
    pub fn texture(&mut self, ctx: &Context, palette: &Palette, dark: bool) -> egui::TextureId {
        // Graphics that were lost took the texture with them; its name is of this image alone.
        let there = |texture: &TextureHandle| {
            let textures = ctx.tex_manager();
            let textures = textures.read();
            textures.meta(texture.id()).is_some_and(|meta| meta.name == NAME)
        };
        match &self.texture {
            Some((drawn, texture)) if *drawn == dark && there(texture) => texture.id(),
            _ => {
                let image = self.image(palette);
                let texture = ctx.load_texture(NAME, image, TextureOptions::LINEAR);
                self.texture.insert((dark, texture)).1.id()
            }
        }
    }

    fn image(&self, palette: &Palette) -> ColorImage {
        let [columns, rows] = SAMPLES;
        // The constraint that is kept least decides.
        let worst: Vec<f64> = (0..columns * rows)
            .map(|i| self.field.excess.iter().map(|e| e[i]).fold(f64::NEG_INFINITY, f64::max))
            .collect();
        let size = [FINER * (columns - 1), FINER * (rows - 1)];
        let mut pixels = Vec::with_capacity(size[0] * size[1]);
        let mix = |from: f64, to: f64, fraction: f64| from + fraction * (to - from);
        for pixel_row in (0..size[1]).rev() {
            let (row, up) = between(pixel_row);
            for pixel in 0..size[0] {
                let (column, right) = between(pixel);
                let i = row * columns + column;
                let at = |values: &[f64]| {
                    let below = mix(values[i], values[i + 1], right);
                    let above = mix(values[i + columns], values[i + columns + 1], right);
                    mix(below, above, up)
                };
                let allowed = at(&worst) <= 0.0;
                pixels.push(self.color(palette, at(&self.field.force_n), allowed));
            }
        }
        ColorImage::new(size, pixels)
    }
}

/// The sample before the middle of a pixel, and how far the pixel lies beyond it.
fn between(pixel: usize) -> (usize, f64) {
    let fraction = ((pixel % FINER) as f64 + 0.5) / FINER as f64;
    (pixel / FINER, fraction)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::settings::Value;
    use crate::run::scenario::Scenario;
    use crate::study::plan::PlanJob;
    use crate::study::plan::constraints::CONSTRAINTS;

    fn picture(changes: &[(&str, Value)]) -> (PlanJob, Picture) {
        let mut scenario = Scenario::default();
        for (path, value) in changes {
            scenario.set(path, value.clone()).unwrap();
        }
        let job = PlanJob::new(&scenario).unwrap();
        let picture = Picture::new(job.problem());
        (job, picture)
    }

    #[test]
    fn the_image_is_grey_exactly_where_the_plan_is_not_allowed() {
        let (job, picture) = picture(&[]);
        let palette = Palette::of(egui::Theme::Light);
        let image = picture.image(palette);
        let [width, height] = image.size;
        let along = |[low, high]: [f64; 2], i: usize, of: usize| {
            low + (high - low) * (i as f64 + 0.5) / of as f64
        };
        let mut wrong = 0;
        for row in (0..height).step_by(7) {
            for column in (0..width).step_by(7) {
                let point = [
                    along(CUTTING_SPEED_M_MIN, column, width),
                    along(FEED_PER_TOOTH_MM, height - 1 - row, height),
                ];
                let feasible = job.problem().score(point).feasible();
                let force_n = job.problem().cut(point).force_n;
                let color = picture.color(palette, force_n, feasible);
                let shown = image.pixels[row * width + column];
                let near = |a: u8, b: u8| a.abs_diff(b) <= 2;
                wrong += usize::from(!near(color.r(), shown.r()) || !near(color.b(), shown.b()));
            }
        }
        // Off by a pixel along the boundaries.
        let seen = height.div_ceil(7) * width.div_ceil(7);
        assert!(wrong * 50 < seen, "{wrong} of {seen}");
    }

    #[test]
    fn boundaries_lie_at_their_limits_or_are_said_to_lie_outside() {
        let (job, shown) = picture(&[("plan.force_max_n", Value::Float(665.0))]);
        let number = |id| CONSTRAINTS.iter().position(|constraint| constraint.id == id).unwrap();
        let force = &shown.boundary(number("force")).lines;
        let limit = job.problem().check([80.0, 0.1])[number("force")].high.unwrap();
        for point in force.iter().flatten() {
            let force_n = job.problem().cut(*point).force_n;
            assert!((force_n / limit - 1.0).abs() < 2e-3, "{force_n} at {point:?}");
        }
        assert!(!force.is_empty());
        let [x, y] = shown.allowed().unwrap();
        let optimum = PlanJob::complete(&Scenario::default()).unwrap().optimum();
        assert!((x[0]..x[1]).contains(&optimum.cutting_speed_m_min), "{x:?}");
        assert!((y[0]..y[1]).contains(&optimum.feed_per_tooth_mm), "{y:?}");
        // Far too much force everywhere.
        let (_, none) = picture(&[
            ("plan.force_limit", Value::Text("fixed".to_owned())),
            ("plan.force_max_n", Value::Float(10.0)),
        ]);
        let force = none.boundary(number("force"));
        assert!(force.lines.is_empty() && !force.kept_somewhere);
        let power = none.boundary(number("power"));
        assert!(power.lines.is_empty() && power.kept_somewhere);
        assert_eq!(none.allowed(), None);
        for (level, lines) in shown.force_lines() {
            assert!(!lines.is_empty() && *level > shown.range_n()[0], "{level}");
        }
        assert!((5..=20).contains(&shown.force_lines().len()));
    }
}
