//! Cuts that do not change: forces over a revolution, regeneration settled.

use super::kienzle::Kienzle;
use super::{Cutter, Sliced, steady};
use crate::base::math;

/// Steps of a static cut in a revolution (rounded down to whole steps a tooth).
const STEPS_PER_REV: usize = 720;
/// Most revolutions until the regeneration of a static cut has settled; three or four are usual.
const MAX_REVS: usize = 20;
/// Revolutions after which a static cut has settled: a loop gain of 0.1 leaves 1e-5 of the force. Always as many, so that the
/// forces have slopes.
const SETTLED_REVS: usize = 5;

/// A cut that does not change: feed and depths.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StaticCut {
    /// Feed per tooth, mm.
    pub feed_per_tooth_mm: f64,
    /// Axial depth A_D, mm.
    pub axial_depth_mm: f64,
    /// Nominal radial depth R_D, mm: the side wall lies at y_e = R(A_D) - R_D.
    pub radial_depth_mm: f64,
}

/// Forces of a static cut, regeneration settled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StaticPeak {
    /// Fx, Fy, Fz in N at the instant of the largest F_xy.
    pub components_n: [f64; 3],
    /// That largest F_xy = sqrt(Fx^2 + Fy^2), N.
    pub fxy_n: f64,
    /// Mean of F_xy over the revolution, N.
    pub mean_fxy_n: f64,
}

/// The cutter in a static cut.
struct Turning<'a> {
    sliced: Sliced,
    law: &'a Kienzle,
    cut: &'a StaticCut,
    wall_mm: f64,
}

impl<'a> Turning<'a> {
    fn new(cutter: &Cutter, law: &'a Kienzle, cut: &'a StaticCut) -> Self {
        Self {
            sliced: Sliced::new(cutter, cut.axial_depth_mm),
            wall_mm: cutter.radius_mm(cut.axial_depth_mm) - cut.radial_depth_mm,
            law,
            cut,
        }
    }

    /// The force at step number `step` of a revolution at an angle of the spindle; `forces` are those of the last
    /// revolution and of this one so far, and `gain` in mm/N bends the tool.
    fn force_n(&self, forces: &[[f64; 3]], step: usize, angle_rad: f64, gain: f64) -> [f64; 3] {
        let (steps, teeth) = (forces.len(), self.sliced.teeth());
        let per_tooth = steps / teeth;
        let last = forces[(step + steps - 1) % steps];
        let mut advances = steady(self.cut.feed_per_tooth_mm);
        for (i, [x, y]) in advances[..teeth].iter_mut().enumerate() {
            let before = forces[(step + 2 * steps - 1 - (i + 1) * per_tooth) % steps];
            *x += gain * (last[0] - before[0]);
            *y += gain * (last[1] - before[1]);
        }
        let depth_mm = self.cut.axial_depth_mm;
        let depth_at = |_: f64, y_mm: f64| if y_mm >= self.wall_mm { depth_mm } else { 0.0 };
        self.sliced.forces(self.law, angle_rad, &advances, depth_at).forces_n
    }
}

/// Turns the cutter through a static cut until the regeneration has settled.
#[must_use]
pub fn static_peak(cutter: &Cutter, law: &Kienzle, cut: &StaticCut) -> StaticPeak {
    let turning = Turning::new(cutter, law, cut);
    let teeth = turning.sliced.teeth();
    let steps = STEPS_PER_REV / teeth * teeth;
    // Forces of the last revolution; the first turns with a rigid tool.
    let mut forces = vec![[0.0; 3]; steps];
    let mut peak = StaticPeak { components_n: [0.0; 3], fxy_n: 0.0, mean_fxy_n: 0.0 };
    for rev in 0..MAX_REVS {
        let before = peak.fxy_n;
        peak = StaticPeak { components_n: [0.0; 3], fxy_n: 0.0, mean_fxy_n: 0.0 };
        let gain = if rev == 0 { 0.0 } else { cutter.compliance_mm_n };
        for step in 0..steps {
            let angle = math::TAU * step as f64 / steps as f64;
            let force = turning.force_n(&forces, step, angle, gain);
            forces[step] = force;
            let fxy = (force[0] * force[0] + force[1] * force[1]).sqrt();
            peak.mean_fxy_n += fxy / steps as f64;
            if fxy > peak.fxy_n {
                (peak.components_n, peak.fxy_n) = (force, fxy);
            }
        }
        if rev > 0 && (peak.fxy_n - before).abs() <= 1e-7 * peak.fxy_n {
            break;
        }
    }
    peak
}

/// Forces F_x, F_y, F_z in N of a static cut, regeneration settled, at the given angles of the spindle over a
/// revolution, in rad: ascending, nearly even, and as many for every tooth. No force without an angle for each tooth.
#[must_use]
pub fn static_turn(
    cutter: &Cutter,
    law: &Kienzle,
    cut: &StaticCut,
    angles_rad: &[f64],
) -> Vec<[f64; 3]> {
    let turning = Turning::new(cutter, law, cut);
    let mut forces = vec![[0.0; 3]; angles_rad.len()];
    if angles_rad.len() < turning.sliced.teeth() {
        return forces;
    }
    let revs = if cutter.compliance_mm_n == 0.0 { 1 } else { SETTLED_REVS };
    for rev in 0..revs {
        let gain = if rev == 0 { 0.0 } else { cutter.compliance_mm_n };
        for (step, angle) in angles_rad.iter().enumerate() {
            forces[step] = turning.force_n(&forces, step, *angle, gain);
        }
    }
    forces
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::mechanistic::CK45;

    fn peak(feed: f64, axial: f64, radial: f64, runout_mm: f64) -> StaticPeak {
        let law = Kienzle::new(&CK45, 80.0, 12.0, 200.0);
        let cut =
            StaticCut { feed_per_tooth_mm: feed, axial_depth_mm: axial, radial_depth_mm: radial };
        static_peak(&Cutter::two_teeth(16.0, runout_mm, 0.1), &law, &cut)
    }

    #[test]
    fn the_force_grows_with_the_published_powers_of_the_feed() {
        for (feed, expected) in [(0.02, 0.80), (0.08, 0.828), (0.16, 0.837)] {
            let [low, high] = [0.99, 1.01].map(|part| peak(part * feed, 2.0, 4.0, 0.0).fxy_n);
            let exponent = math::ln(high / low) / math::ln(1.01 / 0.99);
            assert!((exponent - expected).abs() < 0.01, "{feed}: {exponent}");
        }
    }

    #[test]
    fn a_turn_at_given_angles_has_the_peak_of_the_static_cut() {
        let law = Kienzle::new(&CK45, 80.0, 12.0, 200.0);
        let cut = StaticCut { feed_per_tooth_mm: 0.08, axial_depth_mm: 2.0, radial_depth_mm: 4.0 };
        for compliance_mm_n in [0.0, 2e-5] {
            let cutter = Cutter { compliance_mm_n, ..Cutter::two_teeth(16.0, 0.003, 0.1) };
            let angles: Vec<f64> = (0..720).map(|i| math::TAU * f64::from(i) / 720.0).collect();
            let forces = static_turn(&cutter, &law, &cut, &angles);
            let across = forces.iter().map(|[x, y, _]| (x * x + y * y).sqrt()).fold(0.0, f64::max);
            let expected = static_peak(&cutter, &law, &cut).fxy_n;
            assert!((across / expected - 1.0).abs() < 1e-5, "{across} {expected}");
        }
        assert_eq!(static_turn(&Cutter::two_teeth(16.0, 0.0, 0.1), &law, &cut, &[1.0]), [[0.0; 3]]);
    }

    #[test]
    fn run_out_makes_the_teeth_cut_unequally_around_the_same_mean() {
        let (even, odd) = (peak(0.08, 2.0, 4.0, 0.0), peak(0.08, 2.0, 4.0, 0.003));
        assert!(odd.fxy_n > 1.05 * even.fxy_n && odd.fxy_n < 1.09 * even.fxy_n);
        // The feed of a turn is the same; thin chips of the tooth further in cost a little more per volume.
        let mean = odd.mean_fxy_n / even.mean_fxy_n;
        assert!((mean - 1.0).abs() < 5e-3, "{mean}");
    }
}
