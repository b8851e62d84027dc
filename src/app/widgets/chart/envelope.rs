//! A curve as charts draw it: a line, and where its points lie closer than can be told apart, one band between its
//! extremes. A noisy line has a corner at every point, which costs eight vertices; the band has four every two
//! points of the screen, and shows the same.

use std::ops::{Range, RangeInclusive};

use egui::epaint::{BandPoint, BandShape};
use egui::{Color32, Pos2, Rangef, Shape, Stroke, Ui};
use egui_plot::{
    ClosestElem, Line, LineStyle, PlotBounds, PlotGeometry, PlotItem, PlotItemBase, PlotPoints,
    PlotTransform,
};

/// Width of what is drawn as one column of a band, at least and at most, points of the screen: two are needed to
/// see a difference, and with more than that between its points a curve is a line.
const COLUMN: Rangef = Rangef { min: 2.0, max: 5.0 };
/// So many points of the screen may be between the extremes of two columns of a band, or as many as both columns
/// are high: a larger jump is drawn as what it is, a step.
const JUMP: f32 = 3.0;
/// Fewer columns than these are drawn as a line.
const SHORTEST: usize = 4;

/// A curve without gaps.
pub(super) struct Curve {
    line: Line<'static>,
    stroke: Stroke,
    style: LineStyle,
}

impl Curve {
    /// A curve through points in the plot's values.
    pub(super) fn new(
        name: &str,
        points: Vec<[f64; 2]>,
        (stroke, style): (Stroke, LineStyle),
    ) -> Self {
        let line = Line::new(name.to_owned(), PlotPoints::from(points));
        // The plot's own bands would fill the area below a step.
        Self { line: line.stroke(stroke).style(style).allow_band(false), stroke, style }
    }
}

impl PlotItem for Curve {
    fn shapes(&self, ui: &Ui, transform: &PlotTransform, shapes: &mut Vec<Shape>) {
        let PlotGeometry::Points(points) = self.line.geometry() else { return };
        let places: Vec<Pos2> = points.iter().map(|p| transform.position_from_point(p)).collect();
        let width = self.stroke.width * if self.highlighted() { 2.0 } else { 1.0 };
        for part in parts(&places) {
            match part {
                Part::Line(range) => {
                    let part = points[range].iter().map(|p| [p.x, p.y]).collect::<Vec<_>>();
                    let line = Line::new("", PlotPoints::from(part)).allow_band(false);
                    let line = line.stroke(Stroke::new(width, self.stroke.color)).style(self.style);
                    line.shapes(ui, transform, shapes);
                }
                Part::Band(mut band) => {
                    for point in &mut band {
                        point.y = point.y.expand(0.5 * width);
                    }
                    let dashes = dashes(band, self.style, self.stroke.width);
                    let filled = |dash| BandShape::filled(dash, self.stroke.color).into();
                    shapes.extend(dashes.into_iter().map(filled));
                }
            }
        }
    }

    fn initialize(&mut self, x_range: RangeInclusive<f64>) {
        self.line.initialize(x_range);
    }

    fn color(&self) -> Color32 {
        self.stroke.color
    }

    fn geometry(&self) -> PlotGeometry<'_> {
        self.line.geometry()
    }

    fn bounds(&self) -> PlotBounds {
        self.line.bounds()
    }

    fn base(&self) -> &PlotItemBase {
        self.line.base()
    }

    fn base_mut(&mut self) -> &mut PlotItemBase {
        self.line.base_mut()
    }

    fn find_closest(&self, point: Pos2, transform: &PlotTransform) -> Option<ClosestElem> {
        self.line.find_closest(point, transform)
    }
}

/// A part of a curve.
#[derive(Debug, PartialEq)]
enum Part {
    /// A line through these points.
    Line(Range<usize>),
    /// A band of extremes.
    Band(Vec<BandPoint>),
}

/// Points that lie in one column of the screen.
struct Column {
    points: Range<usize>,
    y: Rangef,
}

/// The columns of a curve, which are as wide as two of its points are apart as a rule.
fn columns(places: &[Pos2]) -> Option<Vec<Column>> {
    let mut steps: Vec<f32> = places.windows(2).map(|pair| pair[1].x - pair[0].x).collect();
    if steps.is_empty() {
        return None;
    }
    let middle = steps.len() / 2;
    let apart = *steps.select_nth_unstable_by(middle, f32::total_cmp).1;
    let width = (2.2 * apart).max(COLUMN.min);
    if width > COLUMN.max {
        return None;
    }
    let mut columns: Vec<Column> = Vec::with_capacity(places.len() / 2);
    for (i, place) in places.iter().enumerate() {
        match columns.last_mut() {
            Some(column) if place.x - places[column.points.start].x < width => {
                column.points.end = i + 1;
                column.y.extend_to(place.y);
            }
            _ => columns.push(Column { points: i..i + 1, y: Rangef::point(place.y) }),
        }
    }
    Some(columns)
}

trait Extend {
    fn extend_to(&mut self, y: f32);
}

impl Extend for Rangef {
    fn extend_to(&mut self, y: f32) {
        *self = Self::new(self.min.min(y), self.max.max(y));
    }
}

/// Whether two columns, one after the other, belong to the same band.
fn joined(places: &[Pos2], [left, right]: [&Column; 2]) -> bool {
    let gap = places[right.points.start].x - places[left.points.end - 1].x;
    let jump = (right.y.min - left.y.max).max(left.y.min - right.y.max);
    let most = left.y.span().min(right.y.span()).max(JUMP);
    left.points.len() > 1 && right.points.len() > 1 && gap <= COLUMN.max && jump <= most
}

/// A curve cut into lines and bands, which touch one another.
fn parts(places: &[Pos2]) -> Vec<Part> {
    let Some(columns) = columns(places) else {
        return vec![Part::Line(0..places.len())];
    };
    let mut parts = Vec::new();
    // Where the line begins that has not been drawn yet.
    let mut line = 0;
    for run in columns.chunk_by(|left, right| joined(places, [left, right])) {
        if run.len() < SHORTEST {
            continue;
        }
        let (first, last) = (run[0].points.start, run[run.len() - 1].points.end - 1);
        if first > line {
            parts.push(Part::Line(line..first + 1));
        }
        parts.push(Part::Band(band(places, run)));
        line = last;
    }
    if line + 1 < places.len() || parts.is_empty() {
        parts.push(Part::Line(line..places.len()));
    }
    parts
}

/// The extremes of columns, which reach half of what is between two of them.
fn band(places: &[Pos2], run: &[Column]) -> Vec<BandPoint> {
    let last = run.len() - 1;
    let reach = |i: usize| {
        let neighbours = [i.checked_sub(1), (i < last).then_some(i + 1)];
        let mut y = run[i].y;
        for other in neighbours.into_iter().flatten().map(|k| run[k].y) {
            if other.min > run[i].y.max {
                y.extend_to(0.5 * (other.min + run[i].y.max));
            }
            if other.max < run[i].y.min {
                y.extend_to(0.5 * (other.max + run[i].y.min));
            }
        }
        let (from, to) = (places[run[i].points.start].x, places[run[i].points.end - 1].x);
        let x = if i == 0 {
            from
        } else if i == last {
            to
        } else {
            0.5 * (from + to)
        };
        BandPoint::new(x, y)
    };
    (0..run.len()).map(reach).collect()
}

/// A band cut along its length as the style cuts a line.
fn dashes(band: Vec<BandPoint>, style: LineStyle, stroke_width: f32) -> Vec<Vec<BandPoint>> {
    let (on, period) = match style {
        LineStyle::Solid => return vec![band],
        LineStyle::Dashed { length } => (length, length * std::f32::consts::GOLDEN_RATIO),
        // Dots are circles of twice the stroke's width.
        LineStyle::Dotted { spacing } => (2.0 * stroke_width, spacing.max(3.0 * stroke_width)),
    };
    let [Some(first), Some(last)] = [band.first(), band.last()].map(|end| end.map(|p| p.x)) else {
        return Vec::new();
    };
    let count = ((last - first) / period).ceil() as usize;
    let dash = |k: usize| {
        let from = first + k as f32 * period;
        let to = (from + on).min(last);
        let inside = band.iter().copied().filter(|p| p.x > from && p.x < to);
        [at(&band, from)].into_iter().chain(inside).chain([at(&band, to)]).collect()
    };
    (0..count).map(dash).collect()
}

/// The band at a place within it.
fn at(band: &[BandPoint], x: f32) -> BandPoint {
    let right = band.partition_point(|point| point.x < x).clamp(1, band.len() - 1);
    let (a, b) = (band[right - 1], band[right]);
    let part = if b.x > a.x { ((x - a.x) / (b.x - a.x)).clamp(0.0, 1.0) } else { 0.0 };
    let mix = |from: f32, to: f32| from + part * (to - from);
    BandPoint::new(x, Rangef::new(mix(a.y.min, b.y.min), mix(a.y.max, b.y.max)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::pos2;

    /// Every point of the curve lies in a part, bands at the place of its column.
    fn covers(places: &[Pos2]) {
        let parts = parts(places);
        let within = |part: &Part, i: usize, p: &Pos2| match part {
            Part::Line(range) => range.contains(&i),
            Part::Band(band) => {
                let near = band.iter().filter(|b| (b.x - p.x).abs() <= COLUMN.max);
                let mut near = near.map(|b| b.y);
                near.any(|y| y.expand(0.01).contains(p.y))
            }
        };
        for (i, place) in places.iter().enumerate() {
            assert!(parts.iter().any(|part| within(part, i, place)), "{i}: {place:?}");
        }
    }

    /// Independent from point to point (the hash PCG).
    fn noise(i: usize) -> f32 {
        let x = (i as u32).wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
        let x = ((x >> ((x >> 28) + 4)) ^ x).wrapping_mul(277_803_737);
        ((x >> 22) ^ x) as f32 / u32::MAX as f32
    }

    #[test]
    fn dense_noise_is_a_band_of_its_extremes() {
        for apart in [0.25, 0.5, 1.0, 2.0] {
            let noisy: Vec<Pos2> =
                (0..800).map(|i| pos2(apart * i as f32, 100.0 + 40.0 * noise(i))).collect();
            covers(&noisy);
            let parts = parts(&noisy);
            // Single points may be out of reach of the columns beside them.
            let line = |part: &Part| match part {
                Part::Line(range) => range.len(),
                Part::Band(_) => 0,
            };
            let left: usize = parts.iter().map(line).sum();
            assert!(left < 80, "{apart}: {left} of 800 points are a line");
            let columns = |part: &Part| match part {
                Part::Line(_) => 0,
                Part::Band(band) => band.len(),
            };
            let columns: usize = parts.iter().map(columns).sum();
            assert!(columns as f32 <= 800.0 * apart / COLUMN.min + 2.0, "{apart}: {columns}");
        }
    }

    #[test]
    fn steps_levels_and_single_points_stay_lines() {
        // A level is two points far apart.
        let step = [pos2(0.0, 50.0), pos2(200.0, 50.0), pos2(201.0, 90.0), pos2(400.0, 90.0)];
        assert_eq!(parts(&step), [Part::Line(0..4)]);
        assert_eq!(parts(&step[..1]), [Part::Line(0..1)]);
        // A step within noise is a line between two bands.
        let level = |i: usize| if i < 400 { 50.0 } else { 200.0 };
        let noisy: Vec<Pos2> =
            (0..800).map(|i| pos2(0.5 * i as f32, level(i) + 9.0 * noise(i))).collect();
        covers(&noisy);
        let parts = parts(&noisy);
        let [Part::Band(_), Part::Line(line), Part::Band(_)] = &parts[..] else {
            panic!("{} parts", parts.len())
        };
        assert!(line.len() <= 3 && noisy[line.start].y < 60.0 && noisy[line.end - 1].y >= 200.0);
    }

    #[test]
    fn a_dashed_band_has_gaps_and_stays_within() {
        let flat = |x: f32| BandPoint::new(x, Rangef::new(10.0, 20.0));
        let band: Vec<BandPoint> = (0..=50).map(|i| flat(2.0 * i as f32)).collect();
        let cut = dashes(band.clone(), LineStyle::Dashed { length: 6.0 }, 1.2);
        let length: f32 = cut.iter().map(|dash| dash[dash.len() - 1].x - dash[0].x).sum();
        assert!((length / 100.0 - 1.0 / std::f32::consts::GOLDEN_RATIO).abs() < 0.05, "{length}");
        assert!(cut.iter().flatten().all(|p| p.y == Rangef::new(10.0, 20.0) && p.x <= 100.0));
        assert_eq!(dashes(band.clone(), LineStyle::Solid, 1.2), [band]);
    }
}
