//! The lobes of the cut on measured modes: S replaced by its mean over the tooth period (Altintas and Budak 1995, zero
//! order).
//!
//! ```text
//! det[ I + b K_t (1 - e^{-iwT}) S_0 G(iw) ] = 0 :   b K_t = -1 / [(1 - e^{-iwT}) L] , real ,  L an eigenvalue of S_0 G
//! ```
//!
//! Whatever the speed, 1 - e^{-iwT} in the worst phase leaves b K_t = 1 / (2 max(-Re L)).

use super::TipCut;
use crate::base::math::{self, TAU};
use crate::models::structure::Complex;
use crate::models::tip_modes::TipAxis;

/// Range of chatter frequencies that is looked at: in the lowest and the highest natural frequency.
const RANGE: [f64; 2] = [0.2, 3.0];
/// Step of the search as a fraction of 1/T, and of the half width of the sharpest mode.
const STEPS: [f64; 2] = [1.0 / 64.0, 0.25];
/// Most frequencies that are looked at.
const MOST: f64 = 400_000.0;

/// A limit of the mean cut.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TipLimit {
    /// Depth, mm.
    pub depth_mm: f64,
    /// Chatter frequency, Hz.
    pub frequency_hz: f64,
}

pub(super) fn root(z: Complex) -> Complex {
    let size = z.norm_sqr().sqrt();
    let re = (0.5 * math::positive(size + z.re)).sqrt();
    let im = (0.5 * math::positive(size - z.re)).sqrt();
    Complex::new(re, if z.im < 0.0 { -im } else { im })
}

/// The eigenvalues of S_0 G at a frequency; the second one is 0 where the tip gives way in one direction only.
fn eigenvalues(cut: &TipCut, s0: &[[f64; 2]; 2], f_hz: f64) -> [Complex; 2] {
    let s = Complex::new(0.0, TAU * f_hz);
    let [gx, gy] = [TipAxis::X, TipAxis::Y].map(|axis| cut.modes.compliance(axis, s));
    let (xx, yy) = (gx * s0[0][0], gy * s0[1][1]);
    let mixed = gx * gy * (s0[0][1] * s0[1][0]);
    let (mean, half) = ((xx + yy) * 0.5, (xx - yy) * 0.5);
    let apart = root(half * half + mixed);
    [mean + apart, mean - apart]
}

/// The same in the order of `before`: each goes on as it came.
fn followed(before: [Complex; 2], now: [Complex; 2]) -> [Complex; 2] {
    let apart = |a: Complex, b: Complex| (a - b).norm_sqr().sqrt();
    let kept = apart(before[0], now[0]) + apart(before[1], now[1]);
    let changed = apart(before[0], now[1]) + apart(before[1], now[0]);
    if changed < kept { [now[1], now[0]] } else { now }
}

/// Frequencies that are looked at, Hz: from, step, how many.
fn frequencies(cut: &TipCut, period_s: f64) -> (f64, f64, u32) {
    let modes = cut.modes.all();
    let lowest = modes.iter().map(|mode| mode.frequency_hz).fold(f64::INFINITY, f64::min);
    let sharpest = modes.iter().map(|mode| mode.frequency_hz * mode.damping_ratio);
    let sharpest = sharpest.fold(f64::INFINITY, f64::min);
    let (from, to) = (RANGE[0] * lowest, RANGE[1] * cut.highest_hz());
    let step = (STEPS[0] / period_s).min(STEPS[1] * sharpest).max((to - from) / MOST);
    (from, step, ((to - from) / step) as u32)
}

/// The limit at `speed_rpm` > 0; none where no depth of cut chatters.
#[must_use]
pub fn limit(cut: &TipCut, speed_rpm: f64) -> Option<TipLimit> {
    let period_s = cut.period_s(speed_rpm);
    let s0 = cut.mean_of_period();
    let (from, step, count) = frequencies(cut, period_s);
    let turned = |f_hz: f64| {
        let angle = TAU * f_hz * period_s;
        Complex::new(1.0 - math::cos(angle), math::sin(angle))
    };
    let mut best: Option<TipLimit> = None;
    let mut low = eigenvalues(cut, &s0, from);
    for i in 1..=count {
        let (low_hz, high_hz) = (from + step * f64::from(i - 1), from + step * f64::from(i));
        let high = followed(low, eigenvalues(cut, &s0, high_hz));
        let branches = low.into_iter().zip(high).enumerate();
        for (branch, (from, to)) in branches {
            let [a, b] = [from * turned(low_hz), to * turned(high_hz)];
            if a.re.min(b.re) >= 0.0 || (a.im < 0.0) == (b.im < 0.0) {
                continue;
            }
            let (mut left, mut right, mut near) = (low_hz, high_hz, low);
            for _ in 0..50 {
                let middle = 0.5 * (left + right);
                near = followed(near, eigenvalues(cut, &s0, middle));
                let same = ((near[branch] * turned(middle)).im < 0.0) == (a.im < 0.0);
                if same { left = middle } else { right = middle }
            }
            let frequency_hz = 0.5 * (left + right);
            let depth_mm = cut.depth_mm(-1.0 / (near[branch] * turned(frequency_hz)).re);
            let lower = best.is_none_or(|best| depth_mm < best.depth_mm);
            if depth_mm > 0.0 && depth_mm.is_finite() && lower {
                best = Some(TipLimit { depth_mm, frequency_hz });
            }
        }
        low = high;
    }
    best
}

/// The depth in mm that is stable at every speed; infinite where the mean cut never chatters.
#[must_use]
pub fn at_any_speed_mm(cut: &TipCut) -> f64 {
    let s0 = cut.mean_of_period();
    let (from, step, count) = frequencies(cut, f64::MIN_POSITIVE);
    let worst = |f_hz: f64| eigenvalues(cut, &s0, f_hz).iter().map(|l| -l.re).fold(0.0, f64::max);
    let coarse = (0..=count).map(|i| from + step * f64::from(i));
    let near = coarse.max_by(|a, b| worst(*a).total_cmp(&worst(*b))).unwrap_or(from);
    let fine = (-500..=500).map(|i| near + step * f64::from(i) / 500.0);
    let most = fine.map(worst).fold(0.0, f64::max);
    cut.depth_mm(1.0 / (2.0 * most))
}
