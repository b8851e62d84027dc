//! Peak picking, then least squares on real and imaginary parts.

use super::{MeasuredResponse, ResponseFit};
use crate::base::cholesky;
use crate::base::language::tr;
use crate::base::math::{self, TAU};
use crate::identify::estimate::LinearisedFit;
use crate::models::structure::Complex;
use crate::models::tip_modes::{TipAxis, TipMode, TipModes};

/// Most modes that are fitted.
const MOST_MODES: usize = 8;
/// A peak counts from this share of the largest one on (chosen).
const LEAST_PEAK: f64 = 0.02;
/// Between two peaks the response falls below this share of the smaller one (chosen).
const VALLEY: f64 = 0.7;
/// Damping to begin with where a peak's half width is not in the recording (chosen).
const USUAL_DAMPING: f64 = 0.03;
/// Most steps of the fit, and the step of its differences, of parameters of size one.
const STEPS: u32 = 200;
const DIFFERENCE: f64 = 1e-6;
/// Improvement of the sum of squares that ends it.
const IMPROVED: f64 = 1e-12;

/// Parameters of a mode: natural frequency in Hz, damping ratio, 1/m in 1/kg.
type Parameters = [f64; 3];

fn value(modes: &[Parameters], residual: f64, f_hz: f64) -> Complex {
    let w = TAU * f_hz;
    modes.iter().fold(Complex::from(residual), |sum, [f_r, zeta, a]| {
        let w_r = TAU * f_r;
        sum + Complex::from(*a) / Complex::new(w_r * w_r - w * w, 2.0 * zeta * w_r * w)
    })
}

/// The largest peaks of -Im G, as modes to begin with, by frequency.
fn peaks(of: &MeasuredResponse, count: Option<usize>) -> Vec<Parameters> {
    let height: Vec<f64> = of.response_m_n.iter().map(|g| -g.im).collect();
    let highest = height.iter().copied().fold(0.0, f64::max);
    let is_peak = |i: &usize| {
        let here = height[*i];
        here >= LEAST_PEAK * highest && here > height[i - 1] && here >= height[i + 1]
    };
    let mut found: Vec<usize> = (1..height.len() - 1).filter(is_peak).collect();
    // The largest first: a smaller one with no valley before a larger one is its noise.
    found.sort_by(|a, b| height[*b].total_cmp(&height[*a]));
    let half_width = |at: usize| {
        let outside = |i: &usize| height[*i] < 0.5 * height[at];
        let right = (at..height.len()).find(outside);
        let left = (0..at).rev().find(outside);
        left.zip(right).map(|(left, right)| of.frequency_hz[right] - of.frequency_hz[left])
    };
    let mut kept: Vec<(usize, Parameters)> = Vec::new();
    for at in found {
        let f_hz = of.frequency_hz[at];
        let zeta = half_width(at).map_or(USUAL_DAMPING, |width| 0.5 * width / f_hz);
        let zeta = math::limit(zeta, 2e-4, 0.5);
        let apart = |(known, _): &(usize, Parameters)| {
            let between = &height[at.min(*known)..=at.max(*known)];
            between.iter().copied().fold(f64::INFINITY, f64::min) < VALLEY * height[at]
        };
        if kept.len() < count.unwrap_or(MOST_MODES) && kept.iter().all(apart) {
            // -Im G = a / (2 zeta w^2).
            let w = TAU * f_hz;
            kept.push((at, [f_hz, zeta, 2.0 * zeta * w * w * height[at]]));
        }
    }
    let mut kept: Vec<Parameters> = kept.into_iter().map(|(_, mode)| mode).collect();
    kept.sort_by(|a, b| a[0].total_cmp(&b[0]));
    kept
}

/// Parameters of size one around a start: logarithms of each, and the residual in the largest response.
struct Around<'a> {
    of: &'a MeasuredResponse,
    start: &'a [Parameters],
    size: f64,
}

impl Around<'_> {
    fn modes(&self, x: &[f64]) -> Vec<Parameters> {
        let triples = self.start.iter().zip(x.chunks_exact(3));
        let far = |start: f64, x: f64| start * math::exp(math::limit(x, -3.0, 3.0));
        triples.map(|(start, x)| [0, 1, 2].map(|i| far(start[i], x[i]))).collect()
    }

    fn residual(&self, x: &[f64]) -> f64 {
        x.last().copied().unwrap_or(0.0) * self.size
    }

    fn differences(&self, x: &[f64]) -> Vec<f64> {
        let (modes, residual) = (self.modes(x), self.residual(x));
        let points = self.of.frequency_hz.iter().zip(&self.of.response_m_n);
        points
            .flat_map(|(f_hz, measured)| {
                let off = (value(&modes, residual, *f_hz) - measured) / self.size;
                [off.re, off.im]
            })
            .collect()
    }
}

fn squares(r: &[f64]) -> f64 {
    r.iter().map(|x| x * x).sum()
}

/// Gauss-Newton steps with Levenberg's damping.
fn fitted(around: &Around<'_>) -> Vec<f64> {
    let count = 3 * around.start.len() + 1;
    let mut x = vec![0.0; count];
    let mut here = around.differences(&x);
    let mut damping = 1e-3;
    for _ in 0..STEPS {
        let slope = |i: usize| -> Vec<f64> {
            let moved = |by: f64| {
                let mut at = x.clone();
                at[i] += by;
                around.differences(&at)
            };
            let (up, down) = (moved(DIFFERENCE), moved(-DIFFERENCE));
            up.iter().zip(&down).map(|(u, d)| (u - d) / (2.0 * DIFFERENCE)).collect()
        };
        let columns: Vec<Vec<f64>> = (0..count).map(slope).collect();
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let right: Vec<f64> = columns.iter().map(|column| -dot(column, &here)).collect();
        let mut improved = false;
        while damping < 1e9 {
            let lower = (0..count).map(|i| {
                let entry = |j: usize| {
                    let scale = if i == j { 1.0 + damping } else { 1.0 };
                    scale * dot(&columns[i], &columns[j])
                };
                (0..=i).map(entry).collect()
            });
            if let Some(step) = cholesky::solve(lower.collect(), right.clone(), 0.0) {
                let next: Vec<f64> = x.iter().zip(&step).map(|(x, step)| x + step).collect();
                let differences = around.differences(&next);
                if squares(&differences) < squares(&here) * (1.0 - IMPROVED) {
                    (x, here) = (next, differences);
                    damping *= 0.2;
                    improved = true;
                    break;
                }
            }
            damping *= 5.0;
        }
        if !improved {
            break;
        }
    }
    x
}

/// Fits modes of a direction: as many as there are peaks, or the largest `count`.
///
/// # Errors
/// The response has too few points, no peak, or a mode that is none (out of the ranges of a mode).
pub fn identify_structure(
    of: &MeasuredResponse,
    axis: TipAxis,
    count: Option<usize>,
) -> Result<ResponseFit, String> {
    of.check()?;
    let start = peaks(of, count);
    if start.is_empty() {
        return Err(tr(
            "the response has no resonance: -Im has no peak above 0; is it displacement over force?",
        )
        .to_owned());
    }
    let size = of.response_m_n.iter().map(|g| g.norm_sqr().sqrt()).fold(0.0, f64::max);
    let around = Around { of, start: &start, size };
    let x = fitted(&around);
    let modes = around.modes(&x);
    let mut order: Vec<usize> = (0..modes.len()).collect();
    order.sort_by(|a, b| modes[*a][0].total_cmp(&modes[*b][0]));
    let linear = LinearisedFit::new(&x, &vec![DIFFERENCE; x.len()], &|x| around.differences(x));
    let estimated = order.iter().map(|r| {
        let of = |i: usize| linear.estimated(&|x| around.modes(x)[*r][i]);
        [of(0), of(1), linear.estimated(&|x| 1.0 / around.modes(x)[*r][2])]
    });
    let estimated = estimated.collect();
    let modes = order.iter().map(|r| modes[*r]).map(|[frequency_hz, damping_ratio, a]| TipMode {
        axis,
        frequency_hz,
        damping_ratio,
        mass_kg: 1.0 / a,
    });
    let modes = TipModes::new(modes.collect())?.all().to_vec();
    let all: f64 = of.response_m_n.iter().map(|g| g.norm_sqr()).sum();
    let rest = (squares(&around.differences(&x)) * size * size / all).sqrt();
    Ok(ResponseFit { modes, residual_m_n: around.residual(&x), rest, estimated })
}
