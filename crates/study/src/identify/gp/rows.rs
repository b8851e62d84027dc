//! The rows that a formula is fitted to.

use super::template::extend;
use crate::base::formula::CompiledFormula;
use crate::base::math;
use crate::base::rng::Stream;

/// Inputs and target, a column each.
#[derive(Clone, Debug, PartialEq)]
pub struct DataRows {
    /// The inputs.
    pub inputs: Vec<Vec<f64>>,
    /// The target.
    pub target: Vec<f64>,
}

/// Up to so many rows, the error of prediction is worked out by leaving each row out.
pub const FEW_ROWS: usize = 64;

impl DataRows {
    /// Number of rows.
    #[must_use]
    pub fn len(&self) -> usize {
        self.target.len()
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.target.is_empty()
    }

    /// The rows of which `keep` says so.
    #[must_use]
    pub fn only(&self, keep: impl Fn(usize) -> bool) -> Self {
        let column = |column: &Vec<f64>| {
            column.iter().enumerate().filter(|(row, _)| keep(*row)).map(|(_, x)| *x).collect()
        };
        Self { inputs: self.inputs.iter().map(column).collect(), target: column(&self.target) }
    }

    /// Least and largest value of each input.
    #[must_use]
    pub fn ranges(&self) -> Vec<[f64; 2]> {
        self.inputs.iter().map(|column| math::extent(column.iter().copied())).collect()
    }

    /// Which inputs are positive in every row.
    #[must_use]
    pub fn positive(&self) -> Vec<bool> {
        self.ranges().iter().map(|[low, _]| *low > 0.0).collect()
    }

    /// Sum of the squares of the target about its mean.
    #[must_use]
    pub fn spread(&self) -> f64 {
        let mean = self.target.iter().sum::<f64>() / self.len() as f64;
        self.target.iter().map(|y| (y - mean) * (y - mean)).sum()
    }

    /// At most `most` rows, evenly spread over the order of the rows.
    #[must_use]
    pub fn sample(&self, most: usize) -> Self {
        let n = self.len();
        if n <= most {
            return self.clone();
        }
        let chosen: Vec<usize> = (0..most).map(|i| i * n / most).collect();
        self.only(|row| chosen.binary_search(&row).is_ok())
    }
}

/// A range widened by `share` of its width on both sides; what is `positive` or all negative stays so.
#[must_use]
pub fn widened([low, high]: [f64; 2], positive: bool, share: f64) -> [f64; 2] {
    let by = share * (high - low);
    let below = low - by;
    let low = if positive && below <= 0.0 { 0.5 * low } else { below };
    let above = high + by;
    [low, if high < 0.0 && above >= 0.0 { 0.5 * high } else { above }]
}

/// Points at which a formula must have values: in the box of the rows, and about it.
#[derive(Clone, Debug)]
pub struct Probes {
    /// Columns.
    pub inputs: Vec<Vec<f64>>,
    /// How many of the points, the first ones, lie in the box.
    pub inside: usize,
    /// Values that a formula may take in the box.
    pub bounds: [f64; 2],
}

impl Probes {
    /// The probes of some rows, of which the last columns are formulas of the others.
    #[must_use]
    pub fn new(rows: &DataRows, parts: &[CompiledFormula], positive: &[bool]) -> Self {
        let mut ranges = rows.ranges();
        ranges.truncate(rows.inputs.len() - parts.len());
        let stream = Stream::new(0, "identify.gp.probes");
        let (inside, around) = (40, 24);
        let column = |(input, range): (usize, &[f64; 2])| {
            let at = |point: usize, [low, high]: [f64; 2]| {
                let share = stream.uniform((input * 1000 + point) as u64);
                low + (high - low) * share
            };
            let wide = widened(*range, positive[input], 0.3);
            let mut column: Vec<f64> = (0..inside).map(|point| at(point, *range)).collect();
            if ranges.len() == 1 {
                // One input: evenly spread, so that no pole between two rows is missed.
                for (point, x) in column.iter_mut().enumerate() {
                    *x = range[0] + (range[1] - range[0]) * (point as f64 + 0.5) / inside as f64;
                }
            }
            for point in 0..around {
                // The corners first.
                let corner = wide[(point >> (input % 4)) & 1];
                column.push(if point < 16 { corner } else { at(500 + point, wide) });
            }
            column
        };
        let mut inputs = ranges.iter().enumerate().map(column).collect();
        extend(&mut inputs, parts);
        let [low, high] = math::extent(rows.target.iter().copied());
        let room = 2.0 * (high - low);
        Self { inputs, inside, bounds: [low - room, high + room] }
    }
}
