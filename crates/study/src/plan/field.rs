//! The problem sampled on a grid over cutting speed and feed per tooth: the picture that the swarm
//! flies over, and the best place by exhaustive search to compare it with.

use super::contour::{Samples, Segment, contour};
use super::problem::{CUTTING_SPEED_M_MIN, FEED_PER_TOOTH_MM, Problem};
use super::score::Score;

/// Samples on a grid, row by row: index = row x columns + column, a column per cutting speed, a
/// row per feed per tooth.
#[derive(Clone, Debug, PartialEq)]
pub struct PlanField {
    /// Cutting speeds of the columns, m/min.
    pub cutting_speed_m_min: Vec<f64>,
    /// Feeds per tooth of the rows, mm.
    pub feed_per_tooth_mm: Vec<f64>,
    /// Force, N.
    pub force_n: Vec<f64>,
    /// Objective.
    pub value: Vec<f64>,
    /// Sum of relative violations; 0 is feasible.
    pub violation: Vec<f64>,
    /// For each constraint how far its value lies outside its limits, relative to the limit;
    /// negative inside, so that the boundary is where it is 0.
    pub excess: [Vec<f64>; 7],
}

/// `count` values from `low` to `high`, both ends exact; one value where they are equal.
fn axis([low, high]: [f64; 2], count: usize) -> Vec<f64> {
    if low == high || count < 2 {
        return vec![low];
    }
    let step = |i: usize| low + (high - low) * (i as f64 / (count - 1) as f64);
    (0..count - 1).map(step).chain([high]).collect()
}

impl PlanField {
    /// Samples the whole domain on `columns` x `rows` points, also where the speed is fixed.
    #[must_use]
    pub fn new(problem: &Problem, columns: usize, rows: usize) -> Self {
        let mut field = Self {
            cutting_speed_m_min: axis(CUTTING_SPEED_M_MIN, columns),
            feed_per_tooth_mm: axis(FEED_PER_TOOTH_MM, rows),
            force_n: Vec::new(),
            value: Vec::new(),
            violation: Vec::new(),
            excess: Default::default(),
        };
        for &feed_per_tooth_mm in &field.feed_per_tooth_mm {
            for &cutting_speed_m_min in &field.cutting_speed_m_min {
                let point = [cutting_speed_m_min, feed_per_tooth_mm];
                let (cut, score) = (problem.cut(point), problem.score(point));
                field.force_n.push(cut.force_n);
                field.value.push(score.value);
                field.violation.push(score.violation);
                let each = problem.bounds().iter().zip(cut.values()).zip(&mut field.excess);
                for ((bounds, value), samples) in each {
                    samples.push(bounds.excess(value));
                }
            }
        }
        field
    }

    fn samples<'a>(&'a self, values: &'a [f64]) -> Samples<'a> {
        Samples { xs: &self.cutting_speed_m_min, ys: &self.feed_per_tooth_mm, values }
    }

    /// The boundary of a constraint (its number in the list of seven) as segments over cutting
    /// speed in m/min and feed per tooth in mm; empty where it lies outside the domain.
    #[must_use]
    pub fn boundary(&self, constraint: usize) -> Vec<Segment> {
        contour(&self.samples(&self.excess[constraint]), 0.0)
    }

    /// The line of equal force.
    #[must_use]
    pub fn force_line(&self, force_n: f64) -> Vec<Segment> {
        contour(&self.samples(&self.force_n), force_n)
    }
}

/// The best point of an exhaustive search and its score.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GridBest {
    /// Cutting speed in m/min and feed per tooth in mm.
    pub point: [f64; 2],
    /// Its score.
    pub score: Score,
    /// Evaluations that it took.
    pub evaluations: u64,
}

/// How often the search zooms in, each time to a few steps of the grid before.
const ZOOMS: usize = 4;
/// Points of a zoomed axis.
const ZOOMED: usize = 33;

/// The best point on a grid of `columns` speeds x `rows` feeds, refined: the best feed is zoomed
/// in on in every column, then the neighbourhood of the best column, so that a narrow ridge along a
/// constraint is followed to its top.
#[must_use]
pub fn exhaustive(problem: &Problem, columns: usize, rows: usize) -> GridBest {
    let [mut speeds, feeds] = problem.range();
    let mut best: Option<GridBest> = None;
    let mut evaluations = 0;
    for zoom in 0..=ZOOMS {
        let grid = axis(speeds, if zoom == 0 { columns } else { ZOOMED });
        for &speed in &grid {
            let found = best_feed(problem, speed, feeds, rows, &mut evaluations);
            if best.is_none_or(|best| found.score.beats(best.score)) {
                best = Some(found);
            }
        }
        if let (Some(best), [first, second, ..]) = (best, grid.as_slice()) {
            let near = 2.0 * (second - first);
            let [low, high] = problem.range()[0];
            speeds = [(best.point[0] - near).max(low), (best.point[0] + near).min(high)];
        } else {
            break;
        }
    }
    let best = best.expect("every axis has at least one point");
    GridBest { evaluations, ..best }
}

fn best_feed(
    problem: &Problem,
    speed: f64,
    whole: [f64; 2],
    rows: usize,
    evaluations: &mut u64,
) -> GridBest {
    let mut feeds = whole;
    let mut best: Option<GridBest> = None;
    for zoom in 0..=ZOOMS {
        let grid = axis(feeds, if zoom == 0 { rows.max(2) } else { ZOOMED });
        for &feed in &grid {
            let (point, score) = ([speed, feed], problem.score([speed, feed]));
            if best.is_none_or(|best| score.beats(best.score)) {
                best = Some(GridBest { point, score, evaluations: 0 });
            }
        }
        *evaluations += grid.len() as u64;
        let (step, middle) = (grid[1] - grid[0], best.map_or(whole[0], |best| best.point[1]));
        feeds = [(middle - 2.0 * step).max(whole[0]), (middle + 2.0 * step).min(whole[1])];
    }
    best.expect("every axis has at least one point")
}
