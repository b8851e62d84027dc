//! The cut on measured modes by semi-discretisation (Insperger and Stepan 2004, Updated semi-discretization method for
//! periodic delay-differential equations with discrete delay, of first order).
//!
//! ```text
//! q' = A(S) q + B(S) u_T(t) ,  u = C q       S its mean over an interval, u_T a straight line between two nodes
//! ```
//!
//! A stretch of the period with the same teeth in the cut is divided into equal intervals, so that S jumps at nodes
//! only; one without teeth is a single interval. The delay is the period, so that the delayed value at a node is that of
//! the same node one period before: the cut is stable where the spectral radius of the map of (q, nodes) is below 1.

use super::TipCut;
use super::linear::radius;
use crate::base::dense::exponential;
use crate::base::math::TAU;
use crate::stability::least_unstable;

/// Intervals to a period of the highest mode: the multiplier is then good to some 0.15 % at a multiplier of 1.4, less below.
const INTERVALS_PER_PERIOD: f64 = 40.0;
/// Fewest intervals to a tooth period.
const FEWEST: f64 = 40.0;
/// Fewest intervals of a stretch in the cut.
const FEWEST_OF_STRETCH: usize = 8;

/// An interval as a map: rows of the new state over the state, the delayed values at its begin and their rise.
struct Interval {
    rows: Vec<f64>,
}

/// The intervals of a tooth period.
struct PeriodMap {
    /// Numbers of the state.
    states: usize,
    /// Directions.
    count: usize,
    /// Direction of each mode.
    places: Vec<usize>,
    /// Each stretch's intervals; whether it cuts.
    stretches: Vec<(Vec<Interval>, bool)>,
}

impl PeriodMap {
    fn new(cut: &TipCut, speed_rpm: f64, depth_mm: f64, longest_s: f64) -> Self {
        let modes = cut.placed_modes();
        let directions = cut.directions();
        let (states, count) = (2 * modes.len(), directions.len());
        let size = states + 2 * count;
        let omega = TAU * speed_rpm / 60.0;
        let stiffness = cut.stiffness_n_m(depth_mm);
        let interval = |cutting: &[u32], rad: [f64; 2]| {
            let length_s = (rad[1] - rad[0]) / omega;
            let mean = cut.mean(cutting, rad);
            let mut matrix = vec![0.0; size * size];
            for (r, (mode, place)) in modes.iter().enumerate() {
                let (w, zeta) = (mode.omega_rad_s(), mode.damping_ratio);
                // Displacement, and velocity over w.
                let (x, v) = (2 * r, 2 * r + 1);
                matrix[x * size + v] = w * length_s;
                matrix[v * size + x] = -w * length_s;
                matrix[v * size + v] = -2.0 * zeta * w * length_s;
                let push = stiffness * length_s / (mode.mass_kg * w);
                for (other, direction) in directions.iter().enumerate() {
                    let factor = push * mean[directions[*place]][*direction];
                    matrix[v * size + states + other] += factor;
                    for (s, (_, of)) in modes.iter().enumerate() {
                        if *of == other {
                            matrix[v * size + 2 * s] -= factor;
                        }
                    }
                }
            }
            for other in 0..count {
                matrix[(states + other) * size + states + count + other] = 1.0;
            }
            let mut rows = exponential(&matrix, size);
            rows.truncate(states * size);
            Interval { rows }
        };
        let stretches = cut.stretches().into_iter().map(|stretch| {
            let [from, to] = stretch.rad;
            let cuts = !stretch.cutting.is_empty() && stiffness > 0.0;
            let wanted = ((to - from) / omega / longest_s).ceil() as usize;
            let intervals = if cuts { wanted.max(FEWEST_OF_STRETCH) } else { 1 };
            let at = |i: usize| from + (to - from) * i as f64 / intervals as f64;
            let parts = (0..intervals).map(|i| interval(&stretch.cutting, [at(i), at(i + 1)]));
            (parts.collect(), cuts)
        });
        let stretches = stretches.collect();
        Self { states, count, places: modes.iter().map(|(_, place)| *place).collect(), stretches }
    }

    /// Numbers of state and nodes.
    fn size(&self) -> usize {
        let cutting = self.stretches.iter().filter(|(_, cuts)| *cuts);
        self.states + cutting.map(|(parts, _)| (parts.len() + 1) * self.count).sum::<usize>()
    }

    /// Where the tip stands.
    fn displaced(&self, state: &[f64], node: &mut [f64]) {
        node.fill(0.0);
        for (r, place) in self.places.iter().enumerate() {
            node[*place] += state[2 * r];
        }
    }

    /// State and nodes one period later.
    fn apply(&self, from: &[f64]) -> Vec<f64> {
        let (states, count) = (self.states, self.count);
        let mut out = from.to_vec();
        let (state, nodes) = out.split_at_mut(states);
        let before = &from[states..];
        let mut next = vec![0.0; states];
        let mut node = 0;
        for (parts, cuts) in &self.stretches {
            if *cuts {
                self.displaced(state, &mut nodes[node * count..(node + 1) * count]);
            }
            for part in parts {
                for (value, row) in next.iter_mut().zip(part.rows.chunks_exact(states + 2 * count))
                {
                    let own = row[..states].iter().zip(&*state).map(|(a, x)| a * x).sum::<f64>();
                    let mut sum = own;
                    if *cuts {
                        for other in 0..count {
                            let old = before[node * count + other];
                            let rise = before[(node + 1) * count + other] - old;
                            sum += row[states + other] * old + row[states + count + other] * rise;
                        }
                    }
                    *value = sum;
                }
                state.copy_from_slice(&next);
                if *cuts {
                    node += 1;
                    self.displaced(state, &mut nodes[node * count..(node + 1) * count]);
                }
            }
            node += usize::from(*cuts);
        }
        out
    }
}

/// Spectral radius of the cut's map over a tooth period with intervals of at most `longest_s`: above 1 it chatters. Speed
/// and depth are positive.
#[must_use]
pub fn multiplier_by(cut: &TipCut, speed_rpm: f64, depth_mm: f64, longest_s: f64) -> f64 {
    let map = PeriodMap::new(cut, speed_rpm, depth_mm, longest_s);
    radius(map.size(), |from| map.apply(from))
}

/// The same with intervals that resolve the highest mode.
#[must_use]
pub fn multiplier(cut: &TipCut, speed_rpm: f64, depth_mm: f64) -> f64 {
    let resolved_s = 1.0 / (INTERVALS_PER_PERIOD * cut.highest_hz());
    let longest_s = resolved_s.min(cut.period_s(speed_rpm) / FEWEST);
    multiplier_by(cut, speed_rpm, depth_mm, longest_s)
}

/// Least unstable depth in mm at `speed_rpm` up to `highest_mm`.
#[must_use]
pub fn limit_mm(cut: &TipCut, speed_rpm: f64, highest_mm: f64) -> Option<f64> {
    let start_mm = super::zero_order::at_any_speed_mm(cut);
    least_unstable(start_mm, highest_mm, |depth| multiplier(cut, speed_rpm, depth))
}
