//! Feed-drive transfer functions of the papers, discretised exactly.
//!
//! ```text
//! 2007 eq. 1  f_a/f_c = Ki Kip Kt / (Je La s^3 + Je (R + KH Kip) s^2 + Kt (Kp Kip + Kb) s + Kt Ki Kip)
//! 2007 eq. 2  f_a/f_c = 497000 / ((s + 14.0) (s^2 + 155 s + 35500))   (printed with a sum: errata 2)
//! 2007 eq. 3  f_a/f_c = 14.0 / (s + 14.0)
//! 2013 eq. 1  f_a/f_c = 1 / (0.001024 s^2 + 0.064 s + 1)
//! measured    second order, natural frequency 3 Hz, critically damped (0.394 s to 0.5 %)
//! ```
//!
//! Each has unit gain and no zeros, so x' = A x + B u in companion form; the step over dt with
//! held input is x+ = e^{A dt} x + (integral of e^{A s} B) u, both blocks of one matrix
//! exponential. Time is scaled by 100 rad/s to keep the matrix balanced. The dead time is a
//! property of the command channel and stands in `blocks/cnc/dead_time.rs`.

use nalgebra::Matrix4;

use crate::base::math::TAU;

/// Longest dead time that a machine can have and a controller can predict, s.
pub const DEAD_TIME_MAX_S: f64 = 0.5;

crate::choice! {
    /// A feed drive.
    pub enum FeedDriveKind {
        /// 2007 eq. 1 with the constants of Table 1: third order, poles -16.07 and -76.46 +- 174.34i.
        Eq1Of2007 = "2007_eq1", "2007 eq. 1 (Table 1)";
        /// 2007 eq. 2: third order, poles -14 and -77.5 +- 171.74i.
        Eq2Of2007 = "2007_eq2", "2007 eq. 2";
        /// 2007 eq. 3: first order, 14 rad/s; the one the paper simulates with.
        Eq3Of2007 = "2007_eq3", "2007 eq. 3";
        /// 2013 eq. 1 and 2005 Fig. 3: second order, 31.25 rad/s, critically damped.
        SecondOrder2013 = "2013_eq1", "2013 eq. 1";
        /// The step response measured in 2005 and 2013: natural frequency 3 Hz, settled after 0.4 s.
        Measured3Hz = "measured_3hz", "measured, 3 Hz";
    }
}

impl FeedDriveKind {
    /// The dead time in s that the source gives with this drive.
    #[must_use]
    pub fn published_dead_time_s(self) -> f64 {
        match self {
            Self::Eq1Of2007 | Self::Eq2Of2007 | Self::Eq3Of2007 => 0.08,
            Self::SecondOrder2013 | Self::Measured3Hz => 0.04,
        }
    }

    /// The denominator's coefficients a0, a1, .. of s^n + .. + a1 s + a0 and its order n.
    #[must_use]
    pub fn denominator(self) -> ([f64; 3], usize) {
        match self {
            Self::Eq1Of2007 => {
                // Table 1: V/(rad s), V/(rad s), V/A, ohm, N m/A, N m s^2, -, H, V/(rad/s).
                let (ki, kp, kh, r, kt) = (8.2, 0.4944, 0.007, 0.15, 0.165);
                let (je, kip, la, kb) = (0.0146, 7.5429, 1.20e-3, 0.38);
                let lead = je * la;
                let a0 = kt * ki * kip / lead;
                let a1 = kt * (kp * kip + kb) / lead;
                let a2 = je * (r + kh * kip) / lead;
                ([a0, a1, a2], 3)
            }
            Self::Eq2Of2007 => ([14.0 * 35500.0, 35500.0 + 14.0 * 155.0, 155.0 + 14.0], 3),
            Self::Eq3Of2007 => ([14.0, 0.0, 0.0], 1),
            Self::SecondOrder2013 => ([1.0 / 0.001_024, 0.064 / 0.001_024, 0.0], 2),
            Self::Measured3Hz => {
                let omega = TAU * 3.0;
                ([omega * omega, 2.0 * omega, 0.0], 2)
            }
        }
    }
}

/// Scale of time in rad/s that keeps the companion matrix balanced.
const SCALE: f64 = 100.0;

/// A drive discretised exactly for one step length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExactDrive {
    order: usize,
    /// e^{A dt}, row by row.
    phi: [[f64; 3]; 3],
    /// The input's coefficients, (integral of e^{A s}) B.
    gamma: [f64; 3],
}

/// State of a drive: output (mm/min) and its scaled derivatives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DriveState([f64; 3]);

impl DriveState {
    /// At rest at a constant feed.
    #[must_use]
    pub fn settled(feed_mm_min: f64) -> Self {
        Self([feed_mm_min, 0.0, 0.0])
    }

    /// The drive's output, mm/min.
    #[must_use]
    pub fn feed_mm_min(&self) -> f64 {
        self.0[0]
    }
}

impl ExactDrive {
    /// Discretises `kind` for steps of `dt_s` seconds.
    #[must_use]
    pub fn new(kind: FeedDriveKind, dt_s: f64) -> Self {
        let (a, order) = kind.denominator();
        Self::of(a, order, dt_s)
    }

    /// Discretises a drive of its own denominator, as [`FeedDriveKind::denominator`] gives one: unit gain, no zeros, order
    /// 1 to 3.
    #[must_use]
    pub fn of(a: [f64; 3], order: usize, dt_s: f64) -> Self {
        let order = order.clamp(1, 3);
        let mut matrix = Matrix4::<f64>::zeros();
        for i in 1..order {
            matrix[(i - 1, i)] = SCALE;
        }
        let mut scale = 1.0;
        for i in (0..order).rev() {
            // Row of the highest derivative, in scaled states x_i = d^i f / SCALE^i.
            matrix[(order - 1, i)] = -a[i] / scale;
            scale *= SCALE;
        }
        matrix[(order - 1, 3)] = a[0] / (scale / SCALE);
        let exponential = (matrix * dt_s).exp();
        let mut exact = Self { order, phi: [[0.0; 3]; 3], gamma: [0.0; 3] };
        for i in 0..3 {
            for j in 0..3 {
                exact.phi[i][j] = exponential[(i, j)];
            }
            exact.gamma[i] = exponential[(i, 3)];
        }
        exact
    }

    /// One step with the command `command_mm_min` held over it.
    #[inline]
    pub fn advance(&self, state: &mut DriveState, command_mm_min: f64) {
        let x = state.0;
        let row = |i: usize| {
            let [p, q, r] = self.phi[i];
            p * x[0] + q * x[1] + r * x[2] + self.gamma[i] * command_mm_min
        };
        state.0 = match self.order {
            1 => [self.phi[0][0] * x[0] + self.gamma[0] * command_mm_min, 0.0, 0.0],
            2 => [
                self.phi[0][0] * x[0] + self.phi[0][1] * x[1] + self.gamma[0] * command_mm_min,
                self.phi[1][0] * x[0] + self.phi[1][1] * x[1] + self.gamma[1] * command_mm_min,
                0.0,
            ],
            _ => [row(0), row(1), row(2)],
        };
    }

    /// The bits of all coefficients, for the test that they are equal natively and in wasm.
    #[must_use]
    pub fn coefficient_bits(&self) -> Vec<u64> {
        self.phi.iter().flatten().chain(&self.gamma).map(|x| x.to_bits()).collect()
    }
}

#[cfg(test)]
#[expect(clippy::disallowed_methods, reason = "the reference is independent of base::math")]
mod tests {
    use super::*;

    /// Roots of each denominator, found independently of the discretisation.
    fn analytic_step(kind: FeedDriveKind, t: f64) -> f64 {
        match kind {
            FeedDriveKind::Eq3Of2007 => 1.0 - (-14.0 * t).exp(),
            FeedDriveKind::SecondOrder2013 => {
                let p = 31.25;
                1.0 - (1.0 + p * t) * (-p * t).exp()
            }
            FeedDriveKind::Measured3Hz => {
                let p = TAU * 3.0;
                1.0 - (1.0 + p * t) * (-p * t).exp()
            }
            FeedDriveKind::Eq1Of2007 | FeedDriveKind::Eq2Of2007 => {
                let ([a0, a1, a2], _) = kind.denominator();
                // Real root by bisection, then the quadratic factor by division.
                let (mut low, mut high) = (-100.0_f64, 0.0_f64);
                for _ in 0..200 {
                    let s = 0.5 * (low + high);
                    if ((s + a2) * s + a1) * s + a0 > 0.0 { high = s } else { low = s }
                }
                let p = -0.5 * (low + high);
                let (b, c) = (a2 - p, a0 / p);
                let (sigma, omega) = (b / 2.0, (c - b * b / 4.0).sqrt());
                // Partial fractions of a0 / (s (s + p) ((s + sigma)^2 + omega^2)).
                let r1 = -a0 / (p * ((sigma - p) * (sigma - p) + omega * omega));
                // 1 + r1 e^{-pt} + e^{-sigma t} (k cos + m sin), from y(0) = y'(0) = 0.
                let k = -1.0 - r1;
                let m = (p * r1 + sigma * k) / omega;
                let (sin, cos) = (omega * t).sin_cos();
                1.0 + r1 * (-p * t).exp() + (-sigma * t).exp() * (k * cos + m * sin)
            }
        }
    }

    #[test]
    fn step_responses_meet_the_analytic_solutions() {
        for kind in FeedDriveKind::ALL {
            for dt in [1e-4, 1e-3, 2e-2] {
                let exact = ExactDrive::new(*kind, dt);
                let mut state = DriveState::settled(0.0);
                for k in 1..=(0.6 / dt) as u32 {
                    exact.advance(&mut state, 1.0);
                    let t = f64::from(k) * dt;
                    let error = (state.feed_mm_min() - analytic_step(*kind, t)).abs();
                    assert!(error < 1e-9, "{} at {t} s: {error:e}", kind.id());
                }
            }
        }
    }

    #[test]
    fn the_second_order_drive_meets_the_published_step() {
        // 2005 Fig. 4: 7 -> 22 mm/s; the values at these times are given in mm/s.
        let exact = ExactDrive::new(FeedDriveKind::SecondOrder2013, 1e-3);
        let mut state = DriveState::settled(7.0);
        let golden = [(20, 8.953), (50, 13.943), (100, 19.281), (200, 21.790), (400, 21.9993)];
        for k in 1..=400 {
            exact.advance(&mut state, 22.0);
            if let Some((_, feed)) = golden.iter().find(|(at, _)| *at == k) {
                assert!((state.feed_mm_min() - feed).abs() < 6e-4, "{k} ms");
            }
        }
    }

    #[test]
    fn table_1_gives_the_poles_that_the_errata_state() {
        let ([a0, a1, a2], _) = FeedDriveKind::Eq1Of2007.denominator();
        assert!(
            (a0 - 582_508.0).abs() < 1.0
                && (a1 - 38_699.7).abs() < 0.1
                && (a2 - 169.0).abs() < 0.01
        );
    }
}
