//! Min-max pyramids of the recorded signals: what a plot draws of an hour at 1 kHz. The extremes
//! of every bucket are exact, so that no force peak is lost.

use crate::run::signals::{Row, SIGNALS, flag};

/// Rows in a bucket of the first level.
const FIRST: usize = 8;
/// Buckets of a level in one of the next.
const FACTOR: usize = 2;

/// Rows in a bucket of a level; level 0 are the rows themselves.
fn rows_in_bucket(level: usize) -> usize {
    (1..level).fold(if level == 0 { 1 } else { FIRST }, |size, _| size * FACTOR)
}

/// Least and largest value of a bucket.
pub type MinMax = [f64; 2];

fn join(a: MinMax, b: &MinMax) -> MinMax {
    [a[0].min(b[0]), a[1].max(b[1])]
}

const NOTHING: MinMax = [f64::INFINITY, f64::NEG_INFINITY];

/// The pyramid of one signal: only full buckets are kept.
#[derive(Clone, Debug, Default)]
pub struct Trace {
    levels: Vec<Vec<MinMax>>,
}

impl Trace {
    fn truncate(&mut self, rows: usize) {
        for (i, level) in self.levels.iter_mut().enumerate() {
            level.truncate(rows / rows_in_bucket(i + 1));
        }
    }

    /// Updates the coarser levels from the first one after rows were added; `rows` is their number now.
    fn grow(&mut self, rows: usize) {
        for depth in 1.. {
            let full = rows / rows_in_bucket(depth + 1);
            if full == 0 {
                break;
            }
            if self.levels.len() == depth {
                self.levels.push(Vec::new());
            }
            for bucket in self.levels[depth].len()..full {
                let span = bucket * FACTOR..(bucket + 1) * FACTOR;
                let extremes = self.levels[depth - 1][span].iter().fold(NOTHING, join);
                self.levels[depth].push(extremes);
            }
        }
    }
}

/// The extremes of all signals over some rows. Row by row, all signals at once: memory is read in
/// its order, and the comparisons need no branches: what a row has no value of is NaN and compares as neither.
fn extremes(rows: &[Row]) -> [MinMax; Row::LEN] {
    let mut least = [f64::INFINITY; Row::LEN];
    let mut most = [f64::NEG_INFINITY; Row::LEN];
    for row in rows {
        for ((value, least), most) in drawn(row).into_iter().zip(&mut least).zip(&mut most) {
            *least = if value < *least { value } else { *least };
            *most = if value > *most { value } else { *most };
        }
    }
    std::array::from_fn(|i| [least[i], most[i]])
}

/// All values of a row, NaN where it has none.
fn drawn(row: &Row) -> [f64; Row::LEN] {
    let mut values = row.values();
    // Only without a chip, or outside a model, is there a signal without a value.
    if row.has(flag::AIR | flag::OUTSIDE) {
        for (value, signal) in values.iter_mut().zip(SIGNALS) {
            *value = (signal.value)(row).unwrap_or(f64::NAN);
        }
    }
    values
}

/// Rows whose state flags are joined into one.
pub const FLAG_ROWS: usize = 128;

/// The pyramids of all signals of one recording, and its state flags.
#[derive(Clone, Debug)]
pub struct Traces {
    traces: Vec<Trace>,
    flags: Vec<u32>,
    row_s: f64,
    rows: usize,
}

impl Traces {
    /// None yet, of a recording with a row every `row_s` seconds.
    #[must_use]
    pub fn new(row_s: f64) -> Self {
        let traces = vec![Trace::default(); SIGNALS.len()];
        Self { traces, flags: Vec::new(), row_s, rows: 0 }
    }

    /// Forgets what was read from row number `rows` on.
    pub fn truncate(&mut self, rows: usize) {
        if rows < self.rows {
            self.rows = rows;
            self.traces.iter_mut().for_each(|trace| trace.truncate(rows));
            self.flags.truncate(rows / FLAG_ROWS);
        }
    }

    /// Takes in the rows that came since; `rows` are all rows of the recording.
    pub fn extend(&mut self, rows: &[Row]) {
        let done = self.traces[0].levels.first().map_or(0, Vec::len);
        for bucket in rows.chunks_exact(FIRST).skip(done) {
            for (trace, extremes) in self.traces.iter_mut().zip(extremes(bucket)) {
                if trace.levels.is_empty() {
                    trace.levels.push(Vec::new());
                }
                trace.levels[0].push(extremes);
            }
        }
        self.traces.iter_mut().for_each(|trace| trace.grow(rows.len()));
        for bucket in rows.chunks_exact(FLAG_ROWS).skip(self.flags.len()) {
            self.flags.push(bucket.iter().fold(0, |bits, row| bits | row.state_flags as u32));
        }
        self.rows = rows.len();
    }

    /// All state flags that occur in each full bucket of [`FLAG_ROWS`] rows.
    #[must_use]
    pub fn flags(&self) -> &[u32] {
        &self.flags
    }

    /// The points of a signal (its index in the table of signals) between two times, NaN where it has no
    /// value, at most some `8 * buckets` of them, and never beyond row number `end`. `rows` gives single values where
    /// a bucket is too coarse; without it the first level is the finest.
    #[must_use]
    pub fn points(
        &self,
        signal: usize,
        [from_s, to_s]: [f64; 2],
        end: usize,
        buckets: usize,
        rows: Option<&[Row]>,
    ) -> Vec<[f64; 2]> {
        let end = end.min(self.rows);
        let row_at = |time_s: f64| (time_s / self.row_s).clamp(0.0, self.rows as f64) as usize;
        // One row more on either side, so that the line leaves the picture at its edge.
        let mut first = row_at(from_s).saturating_sub(1);
        let last = (row_at(to_s) + 2).min(end);
        let span = last.saturating_sub(first);
        let levels = &self.traces[signal].levels;
        // Single rows while there are at most 8 a bucket; from then on two points a bucket.
        let mut depth = usize::from(span > 8 * buckets.max(1));
        while depth > 0 && depth < levels.len() && span / rows_in_bucket(depth) > 2 * buckets {
            depth += 1;
        }
        let mut points = Vec::with_capacity(2 * span / rows_in_bucket(depth) + 64);
        // What a level's full buckets leave over at the end is drawn from the finer levels.
        for depth in (1..=depth.max(usize::from(rows.is_none()))).rev() {
            let Some(level) = levels.get(depth - 1) else { continue };
            let size = rows_in_bucket(depth);
            let full = (first / size)..(last / size).min(level.len());
            if full.is_empty() {
                continue;
            }
            for bucket in full.clone() {
                let start_s = (bucket * size) as f64 * self.row_s;
                let half_s = 0.5 * size as f64 * self.row_s;
                let [min, max] = level[bucket];
                let [min, max] = if min > max { [f64::NAN; 2] } else { [min, max] };
                points.extend([[start_s, min], [start_s + half_s, max]]);
            }
            first = full.end * size;
        }
        if let Some(rows) = rows {
            let value = SIGNALS[signal].value;
            let times = (first..last).map(|i| i as f64 * self.row_s);
            let known = rows.get(first..last).unwrap_or(&[]);
            points.extend(
                times.zip(known).map(|(time_s, row)| [time_s, value(row).unwrap_or(f64::NAN)]),
            );
        }
        points
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows(count: usize) -> Vec<Row> {
        let wave = |i: usize| ((i * 7919) % 1013) as f64;
        (0..count).map(|i| Row { force_n: wave(i), ..Row::default() }).collect()
    }

    fn force() -> usize {
        SIGNALS.iter().position(|signal| signal.id == "force_n").unwrap()
    }

    #[test]
    fn the_extremes_of_every_bucket_are_exact() {
        let rows = rows(5000);
        let mut traces = Traces::new(0.001);
        // In slices, cut back and taken in again: the same as at once.
        traces.extend(&rows[..3333]);
        traces.truncate(1234);
        traces.extend(&rows);
        for (i, level) in traces.traces[force()].levels.iter().enumerate() {
            let size = rows_in_bucket(i + 1);
            assert_eq!(level.len(), rows.len() / size);
            for (bucket, extremes) in level.iter().enumerate() {
                let values = rows[bucket * size..(bucket + 1) * size].iter().map(|r| r.force_n);
                let exact = values.fold(NOTHING, |m, x| join(m, &[x, x]));
                assert_eq!(*extremes, exact);
            }
        }
    }

    #[test]
    fn what_has_no_value_is_no_point_at_any_distance() {
        let ra = SIGNALS.iter().position(|signal| signal.id == "ra_um").unwrap();
        let air = f64::from(flag::AIR);
        let row = |i: usize| match i {
            40_000..80_000 => Row { state_flags: air, ..Row::default() },
            _ => Row { ra_um: 0.8, ..Row::default() },
        };
        let rows: Vec<Row> = (0..120_000).map(row).collect();
        let mut traces = Traces::new(0.001);
        traces.extend(&rows);
        for (range, buckets) in [([0.0, 120.0], 300), ([39.9, 40.1], 300), ([0.0, 120.0], 40)] {
            let points = traces.points(ra, range, usize::MAX, buckets, Some(&rows));
            assert!(points.iter().all(|[_, y]| *y == 0.8 || y.is_nan()));
            assert!(points.iter().any(|[_, y]| y.is_nan()));
            let middle = points.iter().filter(|[t, _]| (45.0..75.0).contains(t));
            assert!(middle.into_iter().all(|[_, y]| y.is_nan()));
        }
    }

    #[test]
    fn few_points_keep_the_peak_and_never_pass_the_playhead() {
        let mut rows = rows(200_000);
        rows[123_456].force_n = 9999.0;
        let mut traces = Traces::new(0.001);
        traces.extend(&rows);
        let all = traces.points(force(), [0.0, 200.0], usize::MAX, 500, Some(&rows));
        assert!(all.len() <= 8 * 500, "{}", all.len());
        assert!(all.iter().any(|[_, force]| *force == 9999.0));
        let some = traces.points(force(), [0.0, 200.0], 100_000, 500, Some(&rows));
        assert!(some.iter().all(|[time_s, _]| *time_s < 100.0));
        let close = traces.points(force(), [1.0, 1.1], usize::MAX, 500, Some(&rows));
        assert!((100..110).contains(&close.len()), "{}", close.len());
    }
}
