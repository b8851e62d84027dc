//! The limit as the running cut shows it: whether a disturbance grows from tooth to tooth.
//!
//! The cut is the one of the loop, step by step ([`ModalResponse`]), without its static force and without
//! loss of contact, so that what is left is the disturbance itself. Its energy is compared between
//! two windows far enough apart for the fastest growing part to stand alone.

use super::{StabilityCut, least_unstable, lobes};
use crate::base::math::{self, TAU};
use crate::blocks::machine::response::{CutForce, ModalResponse};

/// Tooth periods before the first window.
const SETTLING: u32 = 60;
/// Tooth periods of a window.
const WINDOW: u32 = 40;
/// Tooth periods from window to window.
const DISTANCE: u32 = 160;
/// Beyond this size, m per N of the first push, the answer is known.
const GROWN_M: f64 = 1.0;

/// How the teeth's windows enter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ForcedTeeth {
    /// Their mean number, all the time.
    Mean,
    /// As they come and go.
    Interrupted,
}

/// Factor by which a disturbance grows from one tooth period to the next, for steps of `dt_s`.
#[must_use]
pub fn growth(
    cut: &StabilityCut,
    teeth: ForcedTeeth,
    speed_rpm: f64,
    depth_mm: f64,
    dt_s: f64,
) -> f64 {
    let period_s = cut.period_s(speed_rpm);
    let kappa = cut.stiffness_per_mm * depth_mm;
    let mut response = ModalResponse::new(&cut.reduction, dt_s, period_s).holding_contact();
    let turn_rad = TAU * speed_rpm / 60.0 * dt_s;
    let step_at = |period: u32| (f64::from(period) * period_s / dt_s) as u32;
    let end = step_at(SETTLING + DISTANCE + WINDOW);
    let windows = [SETTLING, SETTLING + DISTANCE].map(|from| step_at(from)..step_at(from + WINDOW));
    let mut energy = [0.0; 2];
    for step in 0..end {
        let teeth = match teeth {
            ForcedTeeth::Mean => cut.engagement.mean_teeth(),
            ForcedTeeth::Interrupted => {
                let from = turn_rad * f64::from(step);
                cut.engagement.means(from, from + turn_rad).teeth
            }
        };
        let force = CutForce {
            static_n: if step == 0 { 1.0 } else { 0.0 },
            stiffness_n_m: kappa * teeth,
            damping_n_s_m: 0.0,
            delay_s: period_s,
        };
        let x = response.update(&force).displacement_m;
        if x.abs() > GROWN_M || x.is_nan() {
            return f64::INFINITY;
        }
        for (window, energy) in windows.iter().zip(&mut energy) {
            if window.contains(&step) {
                *energy += x * x;
            }
        }
    }
    let [first, second] = energy;
    if first > 0.0 {
        math::exp(math::ln((second / first).max(f64::MIN_POSITIVE)) / f64::from(2 * DISTANCE))
    } else {
        0.0
    }
}

/// Least unstable depth in mm at `speed_rpm` up to `highest_mm`, for steps of `dt_s`.
#[must_use]
pub fn limit_mm(
    cut: &StabilityCut,
    teeth: ForcedTeeth,
    speed_rpm: f64,
    dt_s: f64,
    highest_mm: f64,
) -> Option<f64> {
    let start_mm = cut.depth_mm(lobes::at_any_speed(cut).stiffness_n_m);
    least_unstable(start_mm, highest_mm, |depth| growth(cut, teeth, speed_rpm, depth, dt_s))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::run::scenario::Scenario;
    use crate::stability::interrupted::multiplier;

    fn cut() -> StabilityCut {
        StabilityCut::new(&Scenario::default()).unwrap()
    }

    #[test]
    fn the_steps_limit_is_off_by_what_is_stated() {
        let cut = cut();
        let speed = 1591.549;
        let exact = cut.depth_mm(lobes::limit(&cut, speed).unwrap().stiffness_n_m);
        for (dt_s, stated) in [(1e-3, 7.4), (5e-4, 1.7), (2e-4, 0.27), (1e-4, 0.067)] {
            let limit = limit_mm(&cut, ForcedTeeth::Mean, speed, dt_s, 100.0).unwrap();
            let percent = 100.0 * (limit / exact - 1.0);
            assert!((percent - stated).abs() < 0.06 + 0.03 * stated, "{dt_s}: {percent} %");
        }
    }

    #[test]
    fn disturbances_grow_as_the_semi_discretisation_says() {
        for (quality, depth) in [(5.0, 0.5), (5.0, 2.0), (5.0, 7.9), (17.0, 2.0), (17.0, 7.9)] {
            let mut scenario = Scenario::default();
            scenario.change(|s| s.machine.spindle_quality = quality).unwrap();
            let cut = StabilityCut::new(&scenario).unwrap();
            let expected = multiplier(&cut, 1591.549, depth);
            let found = growth(&cut, ForcedTeeth::Interrupted, 1591.549, depth, 1e-4);
            assert!((found / expected - 1.0).abs() < 0.01, "{quality} {depth}: {found} {expected}");
            // The papers' cut is quiet on either machine; deep and lightly damped, it chatters.
            assert_eq!(found > 1.0, quality > 10.0 && depth > 5.0, "{quality} {depth}: {found}");
        }
    }

    #[test]
    fn a_disturbance_decays_with_the_machine_where_nothing_is_cut() {
        let cut = cut();
        let period = cut.period_s(1591.549);
        let decay = math::exp(cut.reduction.poles[0].re * period);
        let found = growth(&cut, ForcedTeeth::Interrupted, 1591.549, 1e-9, 1e-4);
        assert!((found / decay - 1.0).abs() < 1e-3, "{found} {decay}");
    }
}
