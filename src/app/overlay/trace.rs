//! The samples of a channel for plots: the extremes of buckets, so that a million of them cost a frame as little as a
//! thousand, and no peak is lost.

use crate::measured::channel::SampleTimes;
use crate::study::over_run::OverRun;

/// Samples in a bucket of the first level.
const FIRST: usize = 8;
/// Buckets of a level in one of the next.
const FACTOR: usize = 2;

/// Samples with the extremes of their buckets.
#[derive(Debug)]
pub struct MeasuredTrace {
    times: SampleTimes,
    values: Vec<f64>,
    /// Least and largest value of every full bucket, level by level; infinite the wrong way round where none has one.
    levels: Vec<Vec<[f64; 2]>>,
}

fn join(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0].min(b[0]), a[1].max(b[1])]
}

const NOTHING: [f64; 2] = [f64::INFINITY, f64::NEG_INFINITY];

impl MeasuredTrace {
    /// Of samples whose times are known and go on.
    #[must_use]
    pub fn new(times: SampleTimes, values: Vec<f64>) -> Self {
        // A sample that is missing is NaN, which is neither less nor more.
        let extremes = |bucket: &[f64]| bucket.iter().fold(NOTHING, |all, x| join(all, [*x, *x]));
        let mut levels: Vec<Vec<[f64; 2]>> =
            vec![values.chunks_exact(FIRST).map(extremes).collect()];
        while let Some(level) = levels.last().filter(|level| level.len() >= FACTOR) {
            let pairs = level.chunks_exact(FACTOR);
            let next = pairs.map(|pair| pair.iter().fold(NOTHING, |all, x| join(all, *x)));
            let next = next.collect();
            levels.push(next);
        }
        Self { times, values, levels }
    }

    /// How many samples there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.values.len()
    }

    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.values.is_empty()
    }

    /// The first sample at or behind a time, s.
    fn sample_at(&self, time_s: f64) -> usize {
        let count = self.values.len();
        match &self.times {
            SampleTimes::Unknown => 0,
            SampleTimes::Even { rate_hz, first_s } => {
                ((time_s - first_s) * rate_hz).ceil().clamp(0.0, count as f64) as usize
            }
            SampleTimes::Given(times) => times.partition_point(|time| *time < time_s).min(count),
        }
    }

    /// Points in the time of a run and in the unit of its signal, where the channel lies at `place`, between two times of
    /// the run, s: at most some `8 * buckets`, NaN where a sample is missing.
    #[must_use]
    pub fn points(
        &self,
        place: &OverRun,
        [from_s, to_s]: [f64; 2],
        buckets: usize,
    ) -> Vec<[f64; 2]> {
        // One sample more on either side, so that the line leaves the picture at its edge.
        let first = self.sample_at(place.measured_s(from_s)).saturating_sub(1);
        let last = (self.sample_at(place.measured_s(to_s)) + 1).min(self.values.len());
        let buckets = buckets.max(1);
        let span = last.saturating_sub(first);
        let at = |sample: usize| place.run_s(self.times.at(sample).unwrap_or(f64::NAN));
        let single = |sample: usize| [at(sample), place.value(self.values[sample])];
        if span <= 8 * buckets {
            return (first..last).map(single).collect();
        }
        let (mut level, mut size) = (0, FIRST);
        while level + 1 < self.levels.len() && span / size > 2 * buckets {
            (level, size) = (level + 1, size * FACTOR);
        }
        let full = first.div_ceil(size)..(last / size).min(self.levels[level].len());
        if full.is_empty() {
            return (first..last).map(single).collect();
        }
        let mut points: Vec<[f64; 2]> = (first..full.start * size).map(single).collect();
        for bucket in full.clone() {
            let [least, most] = self.levels[level][bucket];
            let [least, most] = if least > most { [f64::NAN; 2] } else { [least, most] };
            let (begin, middle) = (bucket * size, bucket * size + size / 2);
            points.push([at(begin), place.value(least)]);
            points.push([at(middle), place.value(most)]);
        }
        points.extend((full.end * size..last).map(single));
        points
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_million_samples_are_few_points_and_keep_their_peak() {
        let mut values: Vec<f64> = (0..1_000_000_u64).map(|i| ((i * 7919) % 1013) as f64).collect();
        values[654_321] = 9999.0;
        values[10] = f64::NAN;
        let even = SampleTimes::Even { rate_hz: 1e5, first_s: 2.0 };
        let given: Vec<f64> = (0..values.len()).map(|i| 2.0 + i as f64 / 1e5).collect();
        let place = OverRun { shift_s: 2.0, scale: 2.0, offset: 1.0 };
        for times in [even, SampleTimes::Given(given.into())] {
            let trace = MeasuredTrace::new(times, values.clone());
            let points = trace.points(&place, [0.0, 10.0], 400);
            assert!(points.len() <= 8 * 400, "{}", points.len());
            let peak = points.iter().find(|[_, y]| *y == (9999.0 - 1.0) / 2.0).unwrap();
            assert!((peak[0] - 6.543_21).abs() < 0.02, "{peak:?}");
            assert!(points.windows(2).all(|pair| pair[0][0] <= pair[1][0]));
            let close = trace.points(&place, [0.0, 0.001], 400);
            assert!((100..105).contains(&close.len()), "{}", close.len());
            assert!(close[10][1].is_nan() && close[11][1] == (values[11] - 1.0) / 2.0);
            assert!(trace.points(&place, [11.0, 12.0], 400).len() <= 1);
        }
        assert!(MeasuredTrace::new(SampleTimes::Unknown, Vec::new()).is_empty());
    }
}
