//! The cutting models M1..M6 of the 2013 control strategy (Cus, Zuperl: genetic-programming
//! models) as printed (Ra in um, F in N, f in mm/min, n in 1/min):
//!
//! ```text
//! M1     F = 69.306 Ra^3 - 270.18 Ra^2 + 398.82 Ra + 14.875                    (eq. 2)
//! M2     f = 10^-5 F^4 - 0.01 F^3 + 2.7568 F^2 - 333.75 F + 15348              (eq. 3)
//! M3     n = 7641.3 exp(-0.004 F)                                              (eq. 4)
//! M4     F = 265.11 (1 - 2.0e-12 n^3 - 31.32 ln(0.039 f) / f)                  (eq. 5)
//! M5=M6  Ra = 0.0001 F^2 - 0.0341 F + 3.018                                    (eq. 6)
//! ```
//!
//! Eq. 3 prints "10^05", which can only be 10^-5. Restored: M2's two leading coefficients, M3's
//! exponent and M5's leading coefficient get their lost digits back; each is documented at its
//! constant. Identified (`steadycut identify tables --paper 2013`): M1 a straight line, M5 its
//! exact inverse, M2 a quadratic, M3 an exponential, M4 in its printed form with its printed speed
//! coefficient, fitted jointly on the closed loop's equilibria.

use super::Valued;
use super::exponential::Exponential;
use super::force_formula::ForceFormula;
use super::quartic::Quartic;

/// Least and largest Ra of the published Table 1, um, desired and produced: the printed M1's range.
pub const RA_RANGE_UM: [f64; 2] = [0.40, 1.11];
/// Least and largest final force of Table 1, N: the range of the printed M2 to M5.
pub const FORCE_RANGE_N: [f64; 2] = [157.5, 188.1];

/// M2 as printed, with 10^-5.
pub const M2: Quartic = Quartic { coefficients: [15348.0, -333.75, 2.7568, -0.01, 1e-5] };
/// M2 restored: rounded to "10^-5" and "0.01" the printed one gives negative feeds of thousands.
/// With these leading coefficients it gives the final feeds of Table 3 of 2007 from its desired
/// forces within 2.3 %.
pub const M2_RESTORED: Quartic =
    Quartic { coefficients: [15348.0, -333.75, 2.7568, -1.015_767e-2, 1.426_371e-5] };
/// M3 as printed.
pub const M3: Exponential = Exponential { scale_rpm: 7641.3, rate_per_n: -0.004 };
/// M3 restored: with -0.0071 it gives the final speeds of Table 1 from its initial forces within
/// 4.7 %; as printed about 3700 1/min against 2200 1/min.
pub const M3_RESTORED: Exponential = Exponential { rate_per_n: -0.0071, ..M3 };
/// M4 as printed.
pub const M4: ForceFormula =
    ForceFormula { intercept_n: 265.11, speed: 265.11 * 2.0e-12, feed: 265.11 * 31.32 };
/// Leading coefficient of M5 as printed, um/N^2.
pub const M5_LEADING: f64 = 0.0001;
/// The same with its lost digits, um/N^2: least squares over Table 1; it still misses the table
/// by up to 0.19 um, since the rest of the printed equation does not fit.
pub const M5_LEADING_RESTORED: f64 = 0.000_120_25;

fn inside(x: f64, range: [f64; 2]) -> bool {
    x >= range[0] && x <= range[1]
}

/// M1: force in N from Ra in um.
pub(super) fn m1(ra_um: f64) -> Valued {
    let force = 14.875 + ra_um * (398.82 + ra_um * (-270.18 + ra_um * 69.306));
    Valued::new(force, inside(ra_um, RA_RANGE_UM))
}

/// M5 = M6: Ra in um from force in N. Below its least value, at F = 0.0341 / (2 leading), the
/// equation turns round: it is evaluated as printed and marked.
#[inline]
pub(super) fn m5(force_n: f64, leading: f64) -> Valued {
    let ra = 3.018 + force_n * (-0.0341 + force_n * leading);
    let rising = 2.0 * leading * force_n > 0.0341;
    Valued::new(ra, rising && inside(force_n, FORCE_RANGE_N))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_printed_equations_give_the_values_that_the_errata_state() {
        assert!((m1(0.40).value - 135.6).abs() < 0.05, "against 164.5 N in the table");
        for force in [157.5, 176.0, 188.1] {
            assert!(M2.at(force) < -1000.0, "negative feeds of thousands");
            assert!((3500.0..4200.0).contains(&M3.at(force)), "about 3700 1/min");
            let ra = m5(force, M5_LEADING).value;
            assert!(ra > 0.10 && ra < 0.15, "0.11..0.14 um: {ra}");
        }
        assert!(!m5(160.0, M5_LEADING).valid && m5(180.0, M5_LEADING).valid, "turns round");
    }

    #[test]
    fn m4_as_printed_is_too_high_at_the_table_s_own_final_values() {
        let force = M4.at(264.92, 2350.0).value;
        assert!((force - (157.5 + 27.5)).abs() < 0.1, "row 1: {force}");
    }
}
