//! The seven constraints of the plan. The papers say that there are seven and cite a list that is
//! not available; these are the usual ones for milling, and chosen. The machine's limits come from the
//! machine file, where they are marked as placeholders.

use serde::Serialize;

use super::machine::{MachineLimits, Source, Sourced};
use crate::base::language::text;
use crate::base::math::positive;
use crate::base::units::percent_from_ratio;

/// What is said of every one of them.
pub const ORIGIN: &str = text!("chosen: the papers cite their list of seven without giving it");
/// A constraint binds where its value lies within this fraction of its limit (chosen).
pub const BINDING_FRACTION: f64 = 0.005;

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
        label: text!("Spindle speed"),
        unit: "1/min",
        formula: "n = 1000 v_c / (pi D)",
        why: text!("The spindle turns neither slower nor faster."),
    },
    Constraint {
        id: "feed",
        label: text!("Feed"),
        unit: "mm/min",
        formula: "f = f_z z n",
        why: text!("The feed drives move neither slower nor faster."),
    },
    Constraint {
        id: "force",
        label: text!("Cutting force"),
        unit: "N",
        formula: text!("F = sqrt(F_x^2 + F_y^2), from the network"),
        why: text!(
            "Roughness follows the force: above the reference force of the target Ra (or a limit \
              of one's own) the surface gets rougher than it should."
        ),
    },
    Constraint {
        id: "power",
        label: text!("Spindle power"),
        unit: "kW",
        formula: "P = |F_y| v_c / (60000 eta)",
        why: text!("The spindle motor must turn the cutter against the force."),
    },
    Constraint {
        id: "roughness",
        label: text!("Roughness of the feed marks"),
        unit: "um",
        formula: "Ra = 5 x 318 (z f_z)^2 / (4 D)",
        why: text!(
            "Feed marks grow with the square of the feed. 318 f^2 / (4 D) is the form of \
              Tolouei-Rad and Bidhendi; the factor 5 and z f_z (run-out: one tooth cuts it all) \
              are chosen."
        ),
    },
    Constraint {
        id: "deflection",
        label: text!("Cutter deflection"),
        unit: "mm",
        formula: "delta = 64 F L^3 / (3 pi E D^4)",
        why: text!("A bent cutter leaves the contour."),
    },
    Constraint {
        id: "tool_life",
        label: text!("Tool life"),
        unit: "min",
        formula: "T = 60 (80 / v_c)^4 (0.08 / f_z)^0.8 (2 / A_D)^0.4",
        why: text!(
            "The edges must last. Taylor's law with the constants of the preset table_2005."
        ),
    },
];

/// Number of the force constraint in [`CONSTRAINTS`].
pub const FORCE: usize = 2;

/// The limits of one constraint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Least value allowed.
    pub low: Option<f64>,
    /// Largest value allowed.
    pub high: Option<f64>,
    /// Where the limits come from.
    pub source: Source,
    /// Slope and intercept of the excess over the value, below and above.
    under: [f64; 2],
    over: [f64; 2],
}

impl Bounds {
    /// Limits; both positive.
    #[must_use]
    pub fn new(low: Option<f64>, high: Option<f64>, source: Source) -> Self {
        let none = [0.0, f64::NEG_INFINITY];
        let under = low.map_or(none, |low| [-1.0 / low, 1.0]);
        let over = high.map_or(none, |high| [1.0 / high, -1.0]);
        Self { low, high, source, under, over }
    }

    /// How far `value` lies outside its limits, relative to the limit; negative inside.
    #[must_use]
    #[inline]
    pub fn excess(&self, value: f64) -> f64 {
        // No division and no branch: the swarm asks this seven times per evaluation.
        let under = self.under[0] * value + self.under[1];
        let over = self.over[0] * value + self.over[1];
        if under > over { under } else { over }
    }

    /// How much `value` violates its limits, relative to the limit; 0 inside.
    #[must_use]
    #[inline]
    pub fn violation(&self, value: f64) -> f64 {
        positive(self.excess(value))
    }
}

/// The limits of all seven, with the force limit in N; one that follows from two values is as
/// certain as the less certain of them.
#[must_use]
pub fn bounds(machine: &MachineLimits, force_max_n: f64) -> [Bounds; 7] {
    let between = |low: Sourced, high: Sourced| {
        Bounds::new(Some(low.value), Some(high.value), low.source.min(high.source))
    };
    let (power, efficiency) = (machine.power_max_kw, machine.spindle_efficiency);
    let at_most = |high: Sourced| Bounds::new(None, Some(high.value), high.source);
    [
        between(machine.speed_min_rpm, machine.speed_max_rpm),
        between(machine.feed_min_mm_min, machine.feed_max_mm_min),
        Bounds::new(None, Some(force_max_n), Source::Given),
        Bounds::new(None, Some(power.value), power.source.min(efficiency.source)),
        at_most(machine.ra_max_um),
        at_most(machine.deflection_max_mm),
        Bounds::new(
            Some(machine.least_tool_life_min.value),
            None,
            machine.least_tool_life_min.source,
        ),
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
        Checked {
            constraint: CONSTRAINTS[i],
            value,
            low: bounds.low,
            high: bounds.high,
            source: bounds.source,
            violation: bounds.violation(value),
            margin_percent: percent_from_ratio(-excess),
            binding: excess > -BINDING_FRACTION,
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn excess_is_relative_to_the_limit_that_is_nearer() {
        let both = Bounds::new(Some(128.0), Some(4096.0), Source::Given);
        assert_eq!([both.excess(5120.0), both.violation(5120.0)], [0.25, 0.25]);
        assert_eq!([both.excess(64.0), both.violation(64.0)], [0.5, 0.5]);
        assert_eq!([both.excess(4096.0), both.violation(4096.0)], [0.0, 0.0]);
        assert_eq!([both.excess(3072.0), both.violation(3072.0)], [-0.25, 0.0]);
        assert_eq!([both.excess(160.0), both.violation(160.0)], [-0.25, 0.0]);
        let all = bounds(&MachineLimits::heller_bea_01(), 665.0);
        let (force, life) = (all[FORCE], all[6]);
        assert!((force.excess(332.5) + 0.5).abs() < 1e-15);
        assert!((life.excess(15.0) - 0.5).abs() < 1e-15 && life.excess(60.0) < 0.0);
    }

    #[test]
    fn a_limit_is_as_certain_as_the_least_certain_of_its_values() {
        let mut machine = MachineLimits::heller_bea_01();
        for value in
            [&mut machine.speed_max_rpm, &mut machine.feed_max_mm_min, &mut machine.power_max_kw]
        {
            value.source = Source::Given;
        }
        let sources = |machine: &MachineLimits| bounds(machine, 665.0).map(|bounds| bounds.source);
        assert_eq!(sources(&machine)[..2], [Source::Placeholder; 2]);
        assert_eq!(sources(&machine)[3], Source::Placeholder, "the efficiency is one");
        machine.spindle_efficiency.source = Source::Given;
        assert_eq!(sources(&machine)[3], Source::Given);
    }
}
