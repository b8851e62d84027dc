//! Where the fit begins: the angle of the spindle, over a tooth's pitch, at which laws of the starting exponents fit best,
//! without run-out and deflection.

use nalgebra::{Matrix3, Vector3};

use super::fold::Folded;
use super::{ForceAxis, RecordedCut};
use crate::base::math;
use crate::models::mechanistic::{Cutter, Kienzle, static_turn};

/// Angles that are tried in a tooth's pitch.
const ANGLES: usize = 72;
/// Least factor on a starting coefficient: noise must not turn a force round.
const LEAST_FACTOR: f64 = 0.1;
const MOST_FACTOR: f64 = 10.0;

/// Where a fit begins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Start {
    /// Angle of the spindle at the first sample, rad.
    pub phase_rad: f64,
    /// Factors on the three coefficients of the starting law.
    pub factors: [f64; 3],
    /// Weighted sum of squares that is left, N^2.
    pub left: f64,
}

/// Forces over the turn of the starting law, of a coefficient alone or of all.
fn forces(
    folded: &Folded,
    cut: &RecordedCut,
    phase_rad: f64,
    only: Option<usize>,
) -> Vec<[f64; 3]> {
    let cutter = Cutter { compliance_mm_n: 0.0, ..Cutter::new(&cut.tool, 0.0, cut.slice_mm) };
    let mut law: Kienzle = cut.law;
    if let Some(only) = only {
        for (i, k) in law.k_n_mm2.iter_mut().enumerate() {
            *k = if i == only { *k } else { 0.0 };
        }
    }
    let angles: Vec<f64> = folded.angles_rad.iter().map(|angle| angle + phase_rad).collect();
    static_turn(&cutter, &law, &cut.static_cut(), &angles)
}

fn squares(folded: &Folded, model: impl Fn(usize, usize) -> f64) -> f64 {
    let mut sum = 0.0;
    for (c, means) in folded.means_n.iter().enumerate() {
        for (i, (mean, count)) in means.iter().zip(&folded.counts).enumerate() {
            let off = mean - model(c, i);
            sum += count * off * off;
        }
    }
    sum
}

/// The best factors at an angle.
fn at(folded: &Folded, cut: &RecordedCut, phase_rad: f64) -> Start {
    if folded.axes.contains(&ForceAxis::Across) {
        // Not linear in the three: one factor on all.
        let all = forces(folded, cut, phase_rad, None);
        let (mut product, mut square) = (0.0, 0.0);
        for (axis, means) in folded.axes.iter().zip(&folded.means_n) {
            for ((force, mean), count) in all.iter().zip(means).zip(&folded.counts) {
                let force = axis.of(*force);
                product += count * force * mean;
                square += count * force * force;
            }
        }
        let factor = math::limit(product / square, LEAST_FACTOR, MOST_FACTOR);
        let left = squares(folded, |c, i| factor * folded.axes[c].of(all[i]));
        return Start { phase_rad, factors: [factor; 3], left };
    }
    let by: Vec<Vec<[f64; 3]>> =
        (0..3).map(|only| forces(folded, cut, phase_rad, Some(only))).collect();
    let (mut normal, mut right) = (Matrix3::<f64>::zeros(), Vector3::<f64>::zeros());
    for (axis, means) in folded.axes.iter().zip(&folded.means_n) {
        for (i, (mean, count)) in means.iter().zip(&folded.counts).enumerate() {
            let row = [0, 1, 2].map(|k| axis.of(by[k][i]));
            for k in 0..3 {
                right[k] += count * row[k] * mean;
                for l in 0..3 {
                    normal[(k, l)] += count * row[k] * row[l];
                }
            }
        }
    }
    // A little of the starting law, so that what the forces do not tell stays there.
    let hold = 1e-6 * (normal.trace() + f64::MIN_POSITIVE);
    for k in 0..3 {
        normal[(k, k)] += hold;
        right[k] += hold;
    }
    let solved = normal.cholesky().map(|factor| factor.solve(&right));
    let factors = solved.map_or([1.0; 3], |x| {
        [x[0], x[1], x[2]].map(|x| math::limit(x, LEAST_FACTOR, MOST_FACTOR))
    });
    let left = squares(folded, |c, i| {
        (0..3).map(|k| factors[k] * folded.axes[c].of(by[k][i])).sum::<f64>()
    });
    Start { phase_rad, factors, left }
}

/// The best angle in a tooth's pitch, and the best at least a sixth of the pitch away from it.
pub(super) fn starts(folded: &Folded, cut: &RecordedCut) -> Vec<Start> {
    let pitch = math::TAU / f64::from(cut.tool.teeth);
    let all: Vec<Start> =
        (0..ANGLES).map(|k| at(folded, cut, pitch * k as f64 / ANGLES as f64)).collect();
    let best = |far: &dyn Fn(usize) -> bool| {
        (0..ANGLES).filter(|k| far(*k)).min_by(|a, b| all[*a].left.total_cmp(&all[*b].left))
    };
    let Some(first) = best(&|_| true) else { return Vec::new() };
    let away = |k: usize| k.abs_diff(first).min(ANGLES - k.abs_diff(first)) >= ANGLES / 6;
    let second = best(&away);
    std::iter::once(first).chain(second).map(|k| all[k]).collect()
}
