//! The stability lobes from the frequency response, with the mean number of teeth in the cut.
//!
//! ```text
//! 1 + kappa G(i w) (1 - e^{-i w T}) = 0 :   Im[G (1 - e^{-iwT})] = 0 ,  kappa = -1 / Re[..]
//! ```
//!
//! All chatter frequencies w of one speed are found as changes of sign; the least kappa counts.
//! Whatever the speed, 1 - e^{-iwT} is at most 2 in the worst direction, which gives the limit
//! that holds for all speeds: kappa = 1 / (2 max(-Re G)).

use super::StabilityCut;
use crate::base::math::{self, TAU};
use crate::models::structure::Complex;
use crate::models::structure::frf::Tree;

/// Highest chatter frequency that is looked for, Hz: above it Re G_rel is positive.
const HIGHEST_HZ: f64 = 1500.0;
/// Step of the search as a fraction of 1/T.
const STEP: f64 = 1.0 / 64.0;

/// A limit of the mean cut.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limit {
    /// Mean stiffness of the cut at the limit, N/m.
    pub stiffness_n_m: f64,
    /// Chatter frequency, Hz.
    pub frequency_hz: f64,
}

fn response(cut: &StabilityCut, f_hz: f64) -> Complex {
    Tree::new(&cut.machine, Complex::new(0.0, TAU * f_hz)).relative()
}

/// G (1 - e^{-iwT}) at `f_hz`.
fn loop_gain(cut: &StabilityCut, f_hz: f64, period_s: f64) -> Complex {
    let angle = TAU * f_hz * period_s;
    response(cut, f_hz) * Complex::new(1.0 - math::cos(angle), math::sin(angle))
}

/// The limit at `speed_rpm` > 0; `None` where no depth of cut chatters.
#[must_use]
pub fn limit(cut: &StabilityCut, speed_rpm: f64) -> Option<Limit> {
    let period_s = cut.period_s(speed_rpm);
    let step_hz = (STEP / period_s).min(1.0);
    let steps = (HIGHEST_HZ / step_hz) as u32;
    let mut best: Option<Limit> = None;
    let (mut low_hz, mut low) = (step_hz, loop_gain(cut, step_hz, period_s));
    for i in 2..=steps {
        let high_hz = step_hz * f64::from(i);
        let high = loop_gain(cut, high_hz, period_s);
        if low.re.min(high.re) < 0.0 && (low.im < 0.0) != (high.im < 0.0) {
            let (mut from, mut to) = (low_hz, high_hz);
            for _ in 0..50 {
                let middle = 0.5 * (from + to);
                let same = (loop_gain(cut, middle, period_s).im < 0.0) == (low.im < 0.0);
                if same { from = middle } else { to = middle }
            }
            let frequency_hz = 0.5 * (from + to);
            let stiffness_n_m = -1.0 / loop_gain(cut, frequency_hz, period_s).re;
            let lower = best.is_none_or(|best| stiffness_n_m < best.stiffness_n_m);
            if stiffness_n_m > 0.0 && lower {
                best = Some(Limit { stiffness_n_m, frequency_hz });
            }
        }
        (low_hz, low) = (high_hz, high);
    }
    best
}

/// The limit that holds at every speed.
#[must_use]
pub fn at_any_speed(cut: &StabilityCut) -> Limit {
    let coarse = (1..=(HIGHEST_HZ as u32)).map(f64::from);
    let real = |f_hz: f64| response(cut, f_hz).re;
    let near = coarse.min_by(|x, y| real(*x).total_cmp(&real(*y))).unwrap_or(1.0);
    let fine = (0..=2000).map(|i| near - 1.0 + 1e-3 * f64::from(i));
    let frequency_hz = fine.min_by(|x, y| real(*x).total_cmp(&real(*y))).unwrap_or(near);
    Limit { stiffness_n_m: -0.5 / real(frequency_hz), frequency_hz }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::run::scenario::Scenario;

    fn cut(quality: f64) -> StabilityCut {
        let mut scenario = Scenario::default();
        scenario.change(|s| s.machine.spindle_quality = quality).unwrap();
        StabilityCut::new(&scenario).unwrap()
    }

    #[test]
    fn limits_meet_the_reference() {
        let any = at_any_speed(&cut(5.0));
        assert!((any.stiffness_n_m / 1.865e6 - 1.0).abs() < 3e-4, "{any:?}");
        assert!((any.frequency_hz - 120.35).abs() < 0.03, "{any:?}");
        let any = at_any_speed(&cut(17.0));
        assert!((any.stiffness_n_m / 5.005e5 - 1.0).abs() < 2e-4, "{any:?}");
        let nominal = limit(&cut(5.0), 1591.549).unwrap();
        assert!((nominal.frequency_hz - 140.26).abs() < 0.05, "{nominal:?}");
        assert!((nominal.stiffness_n_m / 3.218_402e6 - 1.0).abs() < 1e-3, "{nominal:?}");
        let sharp = limit(&cut(17.0), 1591.549).unwrap();
        assert!((sharp.stiffness_n_m / 2.283e6 - 1.0).abs() < 1e-3, "{sharp:?}");
    }

    #[test]
    fn no_speed_goes_below_the_limit_of_all_and_slow_ones_come_near() {
        let cut = cut(5.0);
        let any = at_any_speed(&cut).stiffness_n_m;
        let at = |speed| limit(&cut, speed).unwrap().stiffness_n_m;
        for i in 0..60 {
            let speed = 300.0 + 60.0 * f64::from(i);
            assert!(at(speed) >= any * (1.0 - 1e-6), "{speed}");
        }
        assert!(at(120.0) < 1.03 * any);
    }

    #[test]
    fn the_papers_cut_is_stable_on_the_papers_machine() {
        // 2 mm, K_s b = 6.1e6 N/m, direction 0.5, engagement 0.285: 0.87e6 N/m.
        let cut = cut(5.0);
        let kappa = cut.stiffness_per_mm * 2.0 * cut.engagement.mean_teeth();
        assert!((kappa - 0.87e6).abs() < 0.005e6, "{kappa}");
        assert!(kappa < at_any_speed(&cut).stiffness_n_m);
    }
}
