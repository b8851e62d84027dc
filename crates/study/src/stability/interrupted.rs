//! The interrupted cut by semi-discretisation (Insperger and Stepan), on the reduced machine.
//!
//! Within a tooth period the number of teeth in the cut, w, is piecewise constant: one part with a
//! tooth more, one with a tooth less. A part with teeth is divided into equal intervals; in each
//! the delayed displacement is a straight line between its nodes and the rest is exact:
//!
//! ```text
//! u = C x + F / k3 ,  F = -beta (C x - u_T) ,  beta = w kappa / (1 + w kappa / k3)
//! x' = (A - beta B C) x + beta B u_T(t)
//! ```
//!
//! The delay is the period, so a node's delayed value is the same node one period before: the map
//! of (x, nodes) over a period is a matrix, and the cut is stable where its spectral radius is
//! below 1. A part without teeth is one matrix exponential.

use nalgebra::SMatrix;

use super::{StabilityCut, least_unstable, lobes};
use crate::base::math;
use crate::models::structure::reduction::Reduction;

/// Longest interval, s: some sixty for a period of the spindle's mode.
const INTERVAL_S: f64 = 1.5e-4;
/// Fewest and most intervals of a part, as long as they are no longer than [`COARSEST_S`].
const INTERVALS: [usize; 2] = [16, 64];
/// Longest interval of a slow and wide cut, s: some twenty for a period of the spindle's mode, which holds the
/// limit within 2 %.
const COARSEST_S: f64 = 4e-4;
/// Squarings of the period's matrix: the radius is that of 2^SQUARINGS periods.
const SQUARINGS: i32 = 11;

type Matrix8 = SMatrix<f64, 8, 8>;
type Row8 = SMatrix<f64, 1, 8>;
type Column8 = SMatrix<f64, 8, 1>;

/// The reduced machine in real modal coordinates (Re q, Im q).
struct Modal {
    a: Matrix8,
    b: Column8,
    c: Row8,
    feedthrough: f64,
}

impl Modal {
    fn new(reduction: &Reduction) -> Self {
        let (mut a, mut b, mut c) = (Matrix8::zeros(), Column8::zeros(), Row8::zeros());
        for (r, (pole, residue)) in reduction.poles.iter().zip(&reduction.residues).enumerate() {
            let (re, im) = (2 * r, 2 * r + 1);
            a[(re, re)] = pole.re;
            a[(re, im)] = -pole.im;
            a[(im, re)] = pole.im;
            a[(im, im)] = pole.re;
            b[re] = 1.0;
            c[re] = 2.0 * residue.re;
            c[im] = -2.0 * residue.im;
        }
        Self { a, b, c, feedthrough: reduction.feedthrough_m_n }
    }
}

/// A part of the tooth period with the same number of teeth.
struct Part {
    /// Intervals; one where no tooth cuts.
    intervals: usize,
    /// beta; 0 where no tooth cuts.
    beta: f64,
    /// x after an interval, of x before.
    across: Matrix8,
    /// .. of the delayed displacement at the interval's start.
    of_start: Column8,
    /// .. of its rise over the interval.
    of_rise: Column8,
}

impl Part {
    fn new(modal: &Modal, length_s: f64, kappa: f64) -> Self {
        let beta = kappa / (1.0 + kappa * modal.feedthrough);
        let wanted = (length_s / INTERVAL_S).ceil() as usize;
        let fewest = (length_s / COARSEST_S).ceil() as usize;
        let intervals = match kappa > 0.0 {
            true => wanted.clamp(INTERVALS[0], INTERVALS[1]).max(fewest),
            false => 1,
        };
        let mut matrix = SMatrix::<f64, 10, 10>::zeros();
        let length_s = length_s / intervals as f64;
        let closed = (modal.a - modal.b * modal.c * beta) * length_s;
        for i in 0..8 {
            for j in 0..8 {
                matrix[(i, j)] = closed[(i, j)];
            }
            matrix[(i, 8)] = modal.b[i] * (beta * length_s);
        }
        matrix[(8, 9)] = 1.0;
        let exponential = matrix.exp();
        Self {
            intervals,
            beta,
            across: exponential.fixed_view::<8, 8>(0, 0).into_owned(),
            of_start: exponential.fixed_view::<8, 1>(0, 8).into_owned(),
            of_rise: exponential.fixed_view::<8, 1>(0, 9).into_owned(),
        }
    }

    fn nodes(&self) -> usize {
        if self.beta > 0.0 { self.intervals + 1 } else { 0 }
    }

    /// Carries `x` through the part and puts its new displacements in place of the old `nodes`.
    fn pass(&self, modal: &Modal, x: &mut Column8, nodes: &mut [f64]) {
        if nodes.is_empty() {
            *x = self.across * *x;
            return;
        }
        let fraction = self.beta * modal.feedthrough;
        let mut before = nodes[0];
        nodes[0] = (1.0 - fraction) * (modal.c * *x)[0] + fraction * before;
        for node in &mut nodes[1..] {
            *x = self.across * *x + self.of_start * before + self.of_rise * (*node - before);
            before = *node;
            *node = (1.0 - fraction) * (modal.c * *x)[0] + fraction * before;
        }
    }
}

/// Spectral radius of the cut's map over a tooth period: above 1 it chatters. Speed and depth are
/// positive.
#[must_use]
pub fn multiplier(cut: &StabilityCut, speed_rpm: f64, depth_mm: f64) -> f64 {
    let modal = Modal::new(&cut.reduction);
    let period_s = cut.period_s(speed_rpm);
    let teeth = cut.engagement.mean_teeth();
    let whole = teeth.floor();
    let kappa = cut.stiffness_per_mm * depth_mm;
    let parts = [(teeth - whole, whole + 1.0), (1.0 - (teeth - whole), whole)];
    let parts: Vec<Part> = parts
        .iter()
        .filter(|(fraction, _)| *fraction > 0.0)
        .map(|(fraction, teeth)| Part::new(&modal, fraction * period_s, teeth * kappa))
        .collect();
    let size = 8 + parts.iter().map(Part::nodes).sum::<usize>();
    // Column by column: what a period makes of each unit state.
    let mut map = vec![0.0; size * size];
    for column in 0..size {
        let mut state = vec![0.0; size];
        state[column] = 1.0;
        let mut x = Column8::from_column_slice(&state[..8]);
        let mut rest = &mut state[8..];
        for part in &parts {
            let (nodes, others) = rest.split_at_mut(part.nodes());
            part.pass(&modal, &mut x, nodes);
            rest = others;
        }
        state[..8].copy_from_slice(x.as_slice());
        for (row, value) in state.into_iter().enumerate() {
            map[row * size + column] = value;
        }
    }
    spectral_radius(map, size)
}

/// Spectral radius of a `size` x `size` matrix A, row by row: |A^2n| / |A^n| is its n-th power.
fn spectral_radius(mut matrix: Vec<f64>, size: usize) -> f64 {
    let mut product = vec![0.0; size * size];
    // ln |A^n| for the last two n; `matrix` is A^n over a factor, whose logarithm is `factored`.
    let (mut before, mut last, mut factored) = (0.0, 0.0, 0.0);
    for squaring in 0..=SQUARINGS {
        let norm = matrix.iter().map(|x| x * x).sum::<f64>().sqrt();
        if norm == 0.0 || !norm.is_finite() {
            return norm;
        }
        (before, last) = (last, factored + math::ln(norm));
        if squaring == SQUARINGS {
            break;
        }
        matrix.iter_mut().for_each(|x| *x /= norm);
        factored = 2.0 * last;
        product.fill(0.0);
        for (row, out) in matrix.chunks_exact(size).zip(product.chunks_exact_mut(size)) {
            for (factor, other) in row.iter().zip(matrix.chunks_exact(size)) {
                for (sum, x) in out.iter_mut().zip(other) {
                    *sum += factor * x;
                }
            }
        }
        std::mem::swap(&mut matrix, &mut product);
    }
    math::exp((last - before) / f64::from(1 << (SQUARINGS - 1)))
}

/// Least unstable depth in mm at `speed_rpm` up to `highest_mm`.
#[must_use]
pub fn limit_mm(cut: &StabilityCut, speed_rpm: f64, highest_mm: f64) -> Option<f64> {
    let start_mm = cut.depth_mm(lobes::at_any_speed(cut).stiffness_n_m);
    least_unstable(start_mm, highest_mm, |depth| multiplier(cut, speed_rpm, depth))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::math::PI;
    use crate::models::structure::engagement::EngagementAngles;
    use crate::run::scenario::Scenario;

    fn cut() -> StabilityCut {
        StabilityCut::new(&Scenario::default()).unwrap()
    }

    #[test]
    fn the_radius_is_that_of_known_matrices() {
        // A rotation by 0.3 rad times 0.98, and a Jordan block beside it.
        let (c, s) = (0.98 * math::cos(0.3), 0.98 * math::sin(0.3));
        let rows = vec![c, -s, 0.0, 0.0, s, c, 0.0, 0.0, 0.0, 0.0, 0.9, 5.0, 0.0, 0.0, 0.0, 0.9];
        assert!((spectral_radius(rows, 4) - 0.98).abs() < 1e-3);
        assert!((spectral_radius(vec![2.0, 1.0, 0.0, 3.0], 2) - 3.0).abs() < 1e-9);
        assert_eq!(spectral_radius(vec![0.0; 4], 2), 0.0);
    }

    #[test]
    fn without_interruption_it_is_the_lobes() {
        // Two teeth over half a turn each: always one in the cut.
        let mut cut = cut();
        cut.engagement = EngagementAngles { teeth: 2, angle_rad: PI };
        for (speed, share) in [(400.0, 0.02), (800.0, 0.02), (1591.549, 0.01), (2500.0, 0.01)] {
            let exact = cut.depth_mm(lobes::limit(&cut, speed).unwrap().stiffness_n_m);
            let found = limit_mm(&cut, speed, 100.0).unwrap();
            assert!((found / exact - 1.0).abs() < share, "{speed}: {found} {exact}");
        }
    }

    #[test]
    fn without_a_cut_the_slowest_mode_decays() {
        let cut = cut();
        let period = cut.period_s(1591.549);
        let decay = math::exp(cut.reduction.poles[0].re * period);
        assert!((multiplier(&cut, 1591.549, 1e-9) / decay - 1.0).abs() < 2e-3);
        assert!(multiplier(&cut, 1591.549, 2.0) < 1.0);
        assert!(multiplier(&cut, 1591.549, 60.0) > 1.0);
    }
}
