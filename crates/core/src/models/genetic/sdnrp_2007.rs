//! The cutting models K1..K6 of SDNRP 2007 (Cus, Zuperl, Kiker: genetic-programming models) as
//! printed (Ra in um, F in N, f in mm/min, n in 1/min):
//!
//! ```text
//! K1     F_d = 293 - 593 / sqrt(39.37 Ra)                    (eq. 4)
//! K2     f   = 25.4 (189 - 5926160 / F^2)                    (eq. 5)
//! K3     n   = sqrt(30064193 - 2.28 F^3)                     (eq. 6)
//! K4     F   = 286.44 - 5.82e-10 n^3 - 8973 ln(0.039 f) / f  (eq. 7)
//! K5=K6  Ra  = 0.0254 (593 / (293 - F))^2                    (eq. 8)
//! ```
//!
//! Restored: K4's intercept is 253.66 in place of 286.44, which gives all ten rows of Table 3
//! within 0.75 N. Identified: K1, K2 and K3 are quadratics in `assets/models/identified_2007.toml`,
//! K5 is the exact inverse of K1, K4 is the restored one.

use super::Valued;
use super::force_formula::ForceFormula;
use crate::base::math;

/// K4 as printed.
pub const K4: ForceFormula = ForceFormula { intercept_n: 286.44, speed: 5.82e-10, feed: 8973.0 };
/// K4 restored: the intercept meets all ten rows of Table 3 within 0.75 N.
pub const K4_RESTORED: ForceFormula = ForceFormula { intercept_n: 253.66, ..K4 };
/// Above this force the printed K5 runs into its pole at 293 N; it is continued with its slope.
pub const K5_MAX_N: f64 = 263.0;
/// Below this force the printed K2 asks for a negative feed: sqrt(5926160 / 189) N.
pub const K2_MIN_N: f64 = 177.074_402_217;
/// Above this force the radicand of the printed K3 is negative: (30064193 / 2.28)^(1/3) N.
pub const K3_MAX_N: f64 = 236.249_863_8;

/// K1: force in N from Ra in um.
pub(super) fn k1(ra_um: f64) -> Valued {
    Valued::new(293.0 - 593.0 / (39.37 * ra_um).sqrt(), ra_um > 0.0)
}

/// K2: feed command in mm/min from force in N; negative below [`K2_MIN_N`].
pub(super) fn k2(force_n: f64) -> Valued {
    let force = force_n.max(1.0);
    let feed = 25.4 * (189.0 - 5_926_160.0 / (force * force));
    Valued::new(feed, force_n >= K2_MIN_N)
}

/// K3: spindle speed command in 1/min from force in N; 0 above [`K3_MAX_N`].
pub(super) fn k3(force_n: f64) -> Valued {
    let radicand = 30_064_193.0 - 2.28 * force_n * force_n * force_n;
    Valued::new(radicand.max(0.0).sqrt(), radicand >= 0.0)
}

/// K5 = K6: Ra in um from force in N.
#[inline]
pub(super) fn k5(force_n: f64) -> Valued {
    let inside = math::limit(force_n, 0.0, K5_MAX_N);
    let root = 593.0 / (293.0 - inside);
    let ra = 0.0254 * root * root;
    let slope = 2.0 * ra / (293.0 - inside);
    Valued::new(ra + slope * (force_n - inside), force_n == inside)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_printed_equations_give_the_values_that_the_errata_state() {
        assert!((k1(0.81).value - 188.0).abs() < 0.1);
        assert!((k1(0.38).value - 139.7).abs() < 0.1);
        assert!(!k2(177.0).valid && k2(177.0).value < 0.0);
        assert!(k2(177.1).valid && k2(177.1).value > 0.0);
        assert!((k3(177.7).value - 4170.0).abs() < 100.0);
        assert!(!k3(237.0).valid);
        assert!(k2(K2_MIN_N).value.abs() < 1e-6);
        assert!(k3(K3_MAX_N).value < 1.0 && k3(K3_MAX_N - 1e-6).valid);
        for force in [100.0, 160.0, 200.0, 250.0] {
            // Only as exactly as 39.37 is 1 / 0.0254.
            assert!((k1(k5(force).value).value - force).abs() < 1e-3, "K5 inverts K1");
        }
    }
}
