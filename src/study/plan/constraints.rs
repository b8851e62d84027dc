//! The seven constraints of the plan. The papers say that there are seven and cite a list that is
//! not available; these are the usual ones for milling, and chosen. Machine limits come from the
//! machine file, where they are marked as placeholders.

use serde::Serialize;

use super::machine::{Machine, Source};

/// What is said of every one of them.
pub const ORIGIN: &str = "chosen: the papers cite their list of seven without giving it";
/// A constraint binds where its value lies within this share of its limit (chosen).
pub const BINDING_SHARE: f64 = 0.005;

/// One of the seven, in words.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Constraint {
    /// Name in reports and files.
    pub id: &'static str,
    /// Name for people.
    pub label: &'static str,
    /// Unit of value and limits.
    pub unit: &'static str,
    /// Formula of the value.
    pub formula: &'static str,
    /// Why it is there.
    pub why: &'static str,
}

/// The seven, in the order of every array of values, limits and excesses.
pub const CONSTRAINTS: [Constraint; 7] = [
    Constraint {
        id: "speed",
        label: "Spindle speed",
        unit: "1/min",
        formula: "n = 1000 v_c / (pi D)",
        why: "The spindle turns neither slower nor faster.",
    },
    Constraint {
        id: "feed",
        label: "Feed",
        unit: "mm/min",
        formula: "f = f_z z n",
        why: "The feed drives move neither slower nor faster.",
    },
    Constraint {
        id: "force",
        label: "Cutting force",
        unit: "N",
        formula: "F = sqrt(F_x^2 + F_y^2), from the network",
        why: "Roughness follows the force: above the reference force of the target Ra (or a limit \
              of one's own) the surface gets rougher than it should.",
    },
    Constraint {
        id: "power",
        label: "Spindle power",
        unit: "kW",
        formula: "P = |F_y| v_c / (60000 eta)",
        why: "The spindle motor must turn the cutter against the force.",
    },
    Constraint {
        id: "roughness",
        label: "Roughness of the feed marks",
        unit: "um",
        formula: "Ra = 5 x 318 (z f_z)^2 / (4 D)",
        why: "Feed marks grow with the square of the feed. 318 f^2 / (4 D) is the form of \
              Tolouei-Rad and Bidhendi; the factor 5 and z f_z (run-out: one tooth cuts it all) \
              are chosen.",
    },
    Constraint {
        id: "deflection",
        label: "Cutter deflection",
        unit: "mm",
        formula: "delta = 64 F L^3 / (3 pi E D^4)",
        why: "A bent cutter leaves the contour.",
    },
    Constraint {
        id: "tool_life",
        label: "Tool life",
        unit: "min",
        formula: "T = 60 (80 / v_c)^4 (0.08 / f_z)^0.8 (2 / A_D)^0.4",
        why: "The edges must last. Taylor's law with the constants of the preset table_2005.",
    },
];

/// Number of the force constraint in [`CONSTRAINTS`].
pub const FORCE: usize = 2;

/// The limits of one constraint; infinite where there is none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Least value allowed.
    pub low: f64,
    /// Largest value allowed.
    pub high: f64,
    /// Where the limits come from.
    pub source: Source,
}

impl Bounds {
    /// How far `value` lies outside its limits, relative to the limit; negative inside.
    #[must_use]
    #[inline]
    pub fn excess(&self, value: f64) -> f64 {
        let over = (value - self.high) / self.high;
        let under = (self.low - value) / self.low;
        // Where there is no limit the quotient is NaN or -1, and the other one decides.
        if under > over || over.is_nan() { under } else { over }
    }

    /// How much `value` violates its limits, relative to the limit; 0 inside.
    #[must_use]
    #[inline]
    pub fn violation(&self, value: f64) -> f64 {
        if value > self.high {
            (value - self.high) / self.high
        } else if value < self.low {
            (self.low - value) / self.low
        } else {
            0.0
        }
    }
}

/// The limits of all seven, with the force limit in N.
#[must_use]
pub fn bounds(machine: &Machine, force_max_n: f64) -> [Bounds; 7] {
    let between = |low: f64, high: f64, source| Bounds { low, high, source };
    let at_most = |high: f64, source| Bounds { low: f64::NEG_INFINITY, high, source };
    let m = machine;
    [
        between(m.speed_min_rpm.value, m.speed_max_rpm.value, m.speed_max_rpm.source),
        between(m.feed_min_mm_min.value, m.feed_max_mm_min.value, m.feed_max_mm_min.source),
        at_most(force_max_n, Source::Given),
        at_most(m.power_max_kw.value, m.power_max_kw.source),
        at_most(m.ra_max_um.value, m.ra_max_um.source),
        at_most(m.deflection_max_mm.value, m.deflection_max_mm.source),
        between(m.least_tool_life_min.value, f64::INFINITY, m.least_tool_life_min.source),
    ]
}

/// A constraint at one cut.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Checked {
    /// The constraint in words.
    #[serde(flatten)]
    pub constraint: Constraint,
    /// Its value at the cut.
    pub value: f64,
    /// Least value allowed.
    pub low: Option<f64>,
    /// Largest value allowed.
    pub high: Option<f64>,
    /// Where the limits come from.
    pub source: Source,
    /// Violation relative to the limit; 0 where it is kept.
    pub violation: f64,
    /// Distance to the nearest limit in percent of it; negative where it is violated.
    pub margin_percent: f64,
    /// Whether it stands at its limit or beyond.
    pub binding: bool,
}

/// All seven at their values.
#[must_use]
pub fn check(bounds: &[Bounds; 7], values: &[f64; 7]) -> [Checked; 7] {
    std::array::from_fn(|i| {
        let (bounds, value) = (bounds[i], values[i]);
        let excess = bounds.excess(value);
        let limit = |x: f64| x.is_finite().then_some(x);
        Checked {
            constraint: CONSTRAINTS[i],
            value,
            low: limit(bounds.low),
            high: limit(bounds.high),
            source: bounds.source,
            violation: bounds.violation(value),
            margin_percent: crate::base::units::percent_from_ratio(-excess),
            binding: excess > -BINDING_SHARE,
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn excess_is_relative_to_the_limit_that_is_nearer() {
        let both = Bounds { low: 100.0, high: 4500.0, source: Source::Given };
        assert_eq!([both.excess(5400.0), both.violation(5400.0)], [0.2, 0.2]);
        assert_eq!([both.excess(50.0), both.violation(50.0)], [0.5, 0.5]);
        assert_eq!([both.excess(4500.0), both.violation(4500.0)], [0.0, 0.0]);
        assert!(both.excess(4000.0) < 0.0 && both.violation(4000.0) == 0.0);
        let [.., force, _, _, _, life] = bounds(&Machine::heller_bea_01(), 665.0);
        assert_eq!(force.excess(332.5), -0.5);
        assert_eq!(life.excess(15.0), 0.5);
        assert_eq!(life.excess(f64::INFINITY), f64::NEG_INFINITY);
        assert_eq!(life.excess(60.0), -1.0);
    }
}
