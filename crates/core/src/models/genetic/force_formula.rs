//! The force formula that both papers share: K4 (2007 eq. 7) and M4 (2013 eq. 5).
//!
//! ```text
//! F = c0 - c1 n^3 - c2 ln(0.039 f) / f
//! ```
//!
//! Its least force over the feed is at f = e / 0.039 = 69.7 mm/min; below it the formula turns
//! round, so the model ends there: the force is held and the answer marked invalid. So is a speed
//! below half of the least one in Table 3 of 2007.

use super::Valued;
use crate::base::math;

/// Millimetres to inches as the papers round it.
pub const INCH: f64 = 0.039;
/// The feed of the least force, e / 0.039 mm/min: below it the model ends.
pub const FEED_MIN_MM_MIN: f64 = math::E / INCH;
/// The speed below which the formula is not used: half of the least speed in the published tables
/// (chosen). A controller that asks for more force than the cut can give must not stop the spindle.
pub const SPEED_MIN_RPM: f64 = 412.5;

/// The formula's coefficients.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ForceFormula {
    /// c0, N.
    pub intercept_n: f64,
    /// c1, N min^3.
    pub speed: f64,
    /// c2, N mm/min.
    pub feed: f64,
}

impl ForceFormula {
    /// The force in N at the model's own process conditions (Ck45, A_D 2 mm, R_D 3 mm, sharp
    /// tool) from feed in mm/min and speed in 1/min. Never negative.
    #[must_use]
    #[inline]
    pub fn at(&self, feed_mm_min: f64, speed_rpm: f64) -> Valued {
        let feed = feed_mm_min.max(FEED_MIN_MM_MIN);
        let force = self.intercept_n
            - self.speed * speed_rpm * speed_rpm * speed_rpm
            - self.feed * math::ln(INCH * feed) / feed;
        let valid = feed == feed_mm_min && force >= 0.0 && speed_rpm >= SPEED_MIN_RPM;
        Valued::new(math::positive(force), valid)
    }

    /// The feed in mm/min at which the formula gives `force_n` at `speed_rpm`: the inverse of
    /// [`Self::at`] over the feed, limited to `feed_max_mm_min`; `near_mm_min` is a guess that
    /// only saves time. Invalid where the force is out of reach within these feeds.
    #[must_use]
    pub fn feed_for_force(
        &self,
        force_n: f64,
        speed_rpm: f64,
        feed_max_mm_min: f64,
        near_mm_min: f64,
    ) -> Valued {
        let speed_term = self.speed * speed_rpm * speed_rpm * speed_rpm;
        // ln(0.039 f) / f must equal `ratio`; over f > e / 0.039 it falls from 0.039 / e to 0.
        let ratio = (self.intercept_n - speed_term - force_n) / self.feed;
        if ratio >= INCH / math::E {
            return Valued::new(FEED_MIN_MM_MIN, false);
        }
        let error_at = |feed: f64, log: f64| log / feed - ratio;
        let feed_max = feed_max_mm_min.max(FEED_MIN_MM_MIN);
        if error_at(feed_max, math::ln(INCH * feed_max)) >= 0.0 {
            return Valued::new(feed_max, false);
        }
        // Newton's method inside a bracket; bisects when it leaves it.
        let (mut low, mut high) = (FEED_MIN_MM_MIN, feed_max);
        let inside = near_mm_min > low && near_mm_min < high;
        let mut feed = if inside { near_mm_min } else { (low * high).sqrt() };
        for _ in 0..60 {
            let log = math::ln(INCH * feed);
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

#[cfg(test)]
mod tests {
    use crate::models::genetic::{sdnrp_2007, strategy_2013};

    #[test]
    fn feed_for_force_inverts_the_formula() {
        for formula in [sdnrp_2007::K4_RESTORED, strategy_2013::M4] {
            for feed in [70.0, 100.0, 324.6, 900.0, 2500.0] {
                for speed in [500.0, 2134.0, 3900.0] {
                    let force = formula.at(feed, speed).value;
                    for near in [0.0, 100.0, 2900.0, f64::NAN] {
                        let found = formula.feed_for_force(force, speed, 3000.0, near);
                        let close = (found.value - feed).abs() < 1e-5 * feed;
                        assert!(found.valid && close, "{found:?}");
                    }
                }
            }
            assert!(!formula.feed_for_force(10.0, 2000.0, 3000.0, 300.0).valid);
            assert!(!formula.feed_for_force(1000.0, 2000.0, 3000.0, 300.0).valid);
        }
    }
}
