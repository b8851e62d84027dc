//! The cutting models K1..K6 of SDNRP 2007 (Cus, Zuperl, Kiker: genetic-programming models) in
//! the three calibrations.
//!
//! As printed (Ra in um, F in N, f in mm/min, n in 1/min):
//!
//! ```text
//! K1     F_d = 293 - 593 / sqrt(39.37 Ra)                    (eq. 4)
//! K2     f   = 25.4 (189 - 5926160 / F^2)                    (eq. 5)
//! K3     n   = sqrt(30064193 - 2.28 F^3)                     (eq. 6)
//! K4     F   = 286.44 - 5.82e-10 n^3 - 8973 ln(0.039 f) / f  (eq. 7)
//! K5=K6  Ra  = 0.0254 (593 / (293 - F))^2                    (eq. 8)
//! ```
//!
//! Departures. K4's least force over the feed is at f = e / 0.039 = 69.7 mm/min; below it the
//! printed formula turns round, so the model ends there: the force is held and the answer marked
//! invalid. So is a speed below half of the least one in Table 3. K4 restored: intercept 253.66 in place of 286.44, which gives all ten rows of Table 3
//! within 0.75 N. K1, K2, K3 and K5 identified: quadratics fitted by `steadycut identify tables`,
//! continued with their end slopes; K5 is the exact inverse of K1, so Ra is floored at 0.

use std::sync::LazyLock;

use super::Valued;
use super::curve::Curve;
use crate::base::math;

crate::choice! {
    /// Where the coefficients of a model set come from.
    pub enum Calibration {
        /// The equations exactly as printed in the paper.
        Printed = "printed", "as printed";
        /// The printed form with the fewest coefficients corrected (K4's intercept).
        Restored = "restored", "restored";
        /// Re-identified from the paper's own Table 3 by `steadycut identify tables`.
        Identified = "identified", "identified";
    }
}

/// K4 as printed: intercept in N.
pub const K4_INTERCEPT_PRINTED_N: f64 = 286.44;
/// K4 restored: the intercept in N that meets all ten rows of Table 3 within 0.75 N.
pub const K4_INTERCEPT_RESTORED_N: f64 = 253.66;
/// Coefficient of n^3 in K4, N min^3.
pub const K4_SPEED: f64 = 5.82e-10;
/// Coefficient of ln(0.039 f) / f in K4, N mm/min.
pub const K4_FEED: f64 = 8973.0;
/// Millimetres to inches as the paper rounds it.
pub const K4_INCH: f64 = 0.039;
/// The feed of K4's least force, e / 0.039 mm/min: below it the model ends.
pub const FEED_MIN_MM_MIN: f64 = math::E / K4_INCH;
/// The speed below which K4 is not used: half of the least speed in Table 3 (chosen). A controller
/// that asks for more force than the cut can give must not stop the spindle.
pub const SPEED_MIN_RPM: f64 = 412.5;
/// Above this force the printed K5 runs into its pole at 293 N; it is continued with its slope.
const K5_PRINTED_MAX_N: f64 = 263.0;
/// Below this force the printed K2 asks for a negative feed: sqrt(5926160 / 189) N.
pub const K2_PRINTED_MIN_N: f64 = 177.074_402_217;
/// Above this force the radicand of the printed K3 is negative: (30064193 / 2.28)^(1/3) N.
pub const K3_PRINTED_MAX_N: f64 = 236.249_863_8;
/// Least reference force that a target roughness can ask for, N: keeps relative errors defined
/// where the printed K1 turns negative.
pub const FORCE_REF_MIN_N: f64 = 10.0;

/// K1 and its inverse K5 = K6.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ForceRoughness {
    /// 2007 eq. 4 and eq. 8.
    Printed,
    /// F as a quadratic in Ra.
    Identified(Curve),
}

/// K2: feed command from force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FeedLaw {
    /// 2007 eq. 5.
    Printed,
    /// A quadratic in the force.
    Identified(Curve),
}

/// K3: speed command from force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SpeedLaw {
    /// 2007 eq. 6.
    Printed,
    /// A quadratic in the force.
    Identified(Curve),
}

/// K1..K6 of one calibration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GpModels {
    /// K1 and K5 = K6.
    pub roughness: ForceRoughness,
    /// K2.
    pub feed: FeedLaw,
    /// K3.
    pub speed: SpeedLaw,
    /// K4's intercept, N.
    pub k4_intercept_n: f64,
}

impl GpModels {
    /// The models of a calibration.
    #[must_use]
    pub fn new(calibration: Calibration) -> Self {
        let printed = Self {
            roughness: ForceRoughness::Printed,
            feed: FeedLaw::Printed,
            speed: SpeedLaw::Printed,
            k4_intercept_n: K4_INTERCEPT_PRINTED_N,
        };
        match calibration {
            Calibration::Printed => printed,
            Calibration::Restored => Self { k4_intercept_n: K4_INTERCEPT_RESTORED_N, ..printed },
            Calibration::Identified => *IDENTIFIED,
        }
    }

    /// K1: the desired force F_d in N for a target Ra in um (positive). At least
    /// [`FORCE_REF_MIN_N`]; invalid where that floor or a continuation was used.
    #[must_use]
    pub fn force_from_ra(&self, ra_um: f64) -> Valued {
        let force = match self.roughness {
            ForceRoughness::Printed => {
                Valued::new(293.0 - 593.0 / (39.37 * ra_um).sqrt(), ra_um > 0.0)
            }
            ForceRoughness::Identified(curve) => curve.at(ra_um),
        };
        if force.value >= FORCE_REF_MIN_N { force } else { Valued::new(FORCE_REF_MIN_N, false) }
    }

    /// K5 = K6: the produced Ra in um of a cut with the force in N. Never negative.
    #[must_use]
    #[inline]
    pub fn ra_from_force(&self, force_n: f64) -> Valued {
        let ra = match self.roughness {
            ForceRoughness::Printed => {
                let inside = math::limit(force_n, 0.0, K5_PRINTED_MAX_N);
                let root = 593.0 / (293.0 - inside);
                let ra = 0.0254 * root * root;
                let slope = 2.0 * ra / (293.0 - inside);
                Valued::new(ra + slope * (force_n - inside), force_n == inside)
            }
            ForceRoughness::Identified(curve) => curve.inverse(force_n),
        };
        if ra.value >= 0.0 { ra } else { Valued::new(0.0, false) }
    }

    /// K2: the feed command in mm/min for a force in N. May be negative outside its range, as
    /// printed: the caller limits it.
    #[must_use]
    pub fn feed_from_force(&self, force_n: f64) -> Valued {
        match self.feed {
            FeedLaw::Printed => {
                let force = force_n.max(1.0);
                let feed = 25.4 * (189.0 - 5_926_160.0 / (force * force));
                Valued::new(feed, force_n >= K2_PRINTED_MIN_N)
            }
            FeedLaw::Identified(curve) => curve.at(force_n),
        }
    }

    /// K3: the spindle speed command in 1/min for a force in N; 0 where the printed radicand is
    /// negative.
    #[must_use]
    pub fn speed_from_force(&self, force_n: f64) -> Valued {
        match self.speed {
            SpeedLaw::Printed => {
                let radicand = 30_064_193.0 - 2.28 * force_n * force_n * force_n;
                Valued::new(radicand.max(0.0).sqrt(), radicand >= 0.0)
            }
            SpeedLaw::Identified(curve) => curve.at(force_n),
        }
    }

    /// K4: the force in N at the model's own process conditions (Ck45, A_D 2 mm, R_D 3 mm, sharp
    /// tool) from feed in mm/min and speed in 1/min. Never negative.
    #[must_use]
    #[inline]
    pub fn force(&self, feed_mm_min: f64, speed_rpm: f64) -> Valued {
        let feed = feed_mm_min.max(FEED_MIN_MM_MIN);
        let force = self.k4_intercept_n
            - K4_SPEED * speed_rpm * speed_rpm * speed_rpm
            - K4_FEED * math::ln(K4_INCH * feed) / feed;
        let valid = feed == feed_mm_min && force >= 0.0 && speed_rpm >= SPEED_MIN_RPM;
        Valued::new(math::positive(force), valid)
    }

    /// The feed in mm/min at which K4 gives `force_n` at `speed_rpm`: the inverse of
    /// [`Self::force`] over the feed, limited to `feed_max_mm_min`; `near_mm_min` is a guess that
    /// only saves time. Invalid where the force is out of reach within these feeds.
    #[must_use]
    pub fn feed_for_force(
        &self,
        force_n: f64,
        speed_rpm: f64,
        feed_max_mm_min: f64,
        near_mm_min: f64,
    ) -> Valued {
        let speed_term = K4_SPEED * speed_rpm * speed_rpm * speed_rpm;
        // ln(0.039 f) / f must equal `ratio`; over f > e / 0.039 it falls from 0.039 / e to 0.
        let ratio = (self.k4_intercept_n - speed_term - force_n) / K4_FEED;
        if ratio >= K4_INCH / math::E {
            return Valued::new(FEED_MIN_MM_MIN, false);
        }
        let error_at = |feed: f64, log: f64| log / feed - ratio;
        let feed_max = feed_max_mm_min.max(FEED_MIN_MM_MIN);
        if error_at(feed_max, math::ln(K4_INCH * feed_max)) >= 0.0 {
            return Valued::new(feed_max, false);
        }
        // Newton's method inside a bracket; bisects when it leaves it.
        let (mut low, mut high) = (FEED_MIN_MM_MIN, feed_max);
        let inside = near_mm_min > low && near_mm_min < high;
        let mut feed = if inside { near_mm_min } else { (low * high).sqrt() };
        for _ in 0..60 {
            let log = math::ln(K4_INCH * feed);
            let error = error_at(feed, log);
            if error > 0.0 {
                low = feed;
            } else {
                high = feed;
            }
            let newton = feed - error * feed * feed / (1.0 - log);
            let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
            if (next - feed).abs() <= 1e-10 * feed {
                return Valued::new(next, true);
            }
            feed = next;
        }
        Valued::new(feed, true)
    }
}

/// The shipped model file, written by `steadycut identify tables`.
pub const IDENTIFIED_FILE: &str = include_str!("../../../assets/models/identified_2007.toml");

static IDENTIFIED: LazyLock<GpModels> = LazyLock::new(|| {
    parse_model_file(IDENTIFIED_FILE).expect("the shipped model file is checked by a test")
});

/// Reads a model file as `steadycut identify tables` writes it.
///
/// # Errors
/// Names the entry that is missing, not a number, or makes a curve that is not monotone.
pub fn parse_model_file(text: &str) -> Result<GpModels, String> {
    let table: toml::Table = text.parse().map_err(|error| format!("not TOML: {error}"))?;
    let number = |name: &str, value: Option<&toml::Value>| -> Result<f64, String> {
        value
            .and_then(|v| v.as_float().or_else(|| v.as_integer().map(|i| i as f64)))
            .filter(|x| x.is_finite())
            .ok_or_else(|| format!("`{name}` must be a finite number"))
    };
    let curve = |name: &str| -> Result<Curve, String> {
        let entry = table.get(name).ok_or_else(|| format!("`{name}` is missing"))?;
        let list = entry.get("coefficients").and_then(toml::Value::as_array);
        let list = list.filter(|list| list.len() == 3);
        let list = list.ok_or_else(|| format!("`{name}.coefficients` must be three numbers"))?;
        let mut coefficients = [0.0; 3];
        for (i, coefficient) in coefficients.iter_mut().enumerate() {
            *coefficient = number(&format!("{name}.coefficients"), list.get(i))?;
        }
        let curve = Curve {
            coefficients,
            low: number(&format!("{name}.low"), entry.get("low"))?,
            high: number(&format!("{name}.high"), entry.get("high"))?,
        };
        if curve.is_monotone() {
            Ok(curve)
        } else {
            Err(format!("`{name}` turns round within {}..{}", curve.low, curve.high))
        }
    };
    let k4 = table.get("k4").and_then(|entry| entry.get("intercept_n"));
    Ok(GpModels {
        roughness: ForceRoughness::Identified(curve("k1")?),
        feed: FeedLaw::Identified(curve("k2")?),
        speed: SpeedLaw::Identified(curve("k3")?),
        k4_intercept_n: number("k4.intercept_n", k4)?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_printed_equations_give_the_values_that_the_errata_state() {
        let printed = GpModels::new(Calibration::Printed);
        assert!((printed.force_from_ra(0.81).value - 188.0).abs() < 0.1);
        assert!((printed.force_from_ra(0.38).value - 139.7).abs() < 0.1);
        assert!(
            !printed.feed_from_force(177.0).valid && printed.feed_from_force(177.0).value < 0.0
        );
        assert!(printed.feed_from_force(177.1).valid && printed.feed_from_force(177.1).value > 0.0);
        assert!((printed.speed_from_force(177.7).value - 4170.0).abs() < 100.0);
        assert!(!printed.speed_from_force(237.0).valid);
        assert!(printed.feed_from_force(K2_PRINTED_MIN_N).value.abs() < 1e-6);
        assert!(printed.speed_from_force(K3_PRINTED_MAX_N).value < 1.0);
        assert!(printed.speed_from_force(K3_PRINTED_MAX_N - 1e-6).valid);
        for force in [100.0, 160.0, 200.0, 250.0] {
            // Only as exactly as 39.37 is 1 / 0.0254.
            let ra = printed.ra_from_force(force).value;
            assert!((printed.force_from_ra(ra).value - force).abs() < 1e-3, "K5 inverts K1");
        }
    }

    #[test]
    fn no_force_makes_a_non_finite_or_negative_roughness() {
        for calibration in Calibration::ALL {
            let models = GpModels::new(*calibration);
            for force in [-1e6, 0.0, 100.0, 262.9, 263.1, 293.0, 400.0, 1e9] {
                let ra = models.ra_from_force(force).value;
                assert!(ra.is_finite() && ra >= 0.0, "{calibration:?} at {force} N: {ra}");
            }
        }
    }

    #[test]
    fn feed_for_force_inverts_k4() {
        let models = GpModels::new(Calibration::Restored);
        for feed in [70.0, 100.0, 324.6, 900.0, 2500.0] {
            for speed in [500.0, 2134.0, 3900.0] {
                let force = models.force(feed, speed).value;
                for near in [0.0, 100.0, 2900.0, f64::NAN] {
                    let found = models.feed_for_force(force, speed, 3000.0, near);
                    assert!(found.valid && (found.value - feed).abs() < 1e-5 * feed, "{found:?}");
                }
            }
        }
        assert!(!models.feed_for_force(10.0, 2000.0, 3000.0, 300.0).valid);
        assert!(!models.feed_for_force(1000.0, 2000.0, 3000.0, 300.0).valid);
    }

    #[test]
    fn model_files_with_faults_are_refused_by_name() {
        let cut = IDENTIFIED_FILE.replacen("[k2]", "[k9]", 1);
        assert!(parse_model_file(&cut).unwrap_err().contains("`k2`"));
        let bad = IDENTIFIED_FILE.replacen("\nlow", "\nlowest", 1);
        assert!(parse_model_file(&bad).unwrap_err().contains(".low"));
        assert!(parse_model_file("not = toml = here").is_err());
    }
}
