//! Comparing points under constraints (Deb 2000).

use serde::Serialize;

/// A relative gain below this counts as none.
const GAIN: f64 = 1e-4;

/// What is known of a point: its value, to be made large, and how much it violates constraints.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Score {
    /// The value.
    pub value: f64,
    /// Sum of relative violations; 0 is feasible.
    pub violation: f64,
}

impl Score {
    /// Whether no constraint is violated.
    #[must_use]
    #[inline]
    pub fn feasible(self) -> bool {
        self.violation == 0.0
    }

    /// Deb's rules: feasible beats infeasible, among feasible ones the value decides, among
    /// infeasible ones the violation.
    #[must_use]
    #[inline]
    pub fn beats(self, other: Self) -> bool {
        if self.violation == other.violation {
            self.value > other.value
        } else {
            self.violation < other.violation
        }
    }

    /// Whether the step from `before` to here counts as progress: a relative gain of 1e-4.
    #[must_use]
    pub fn gains_on(self, before: Self) -> bool {
        if before.feasible() {
            self.value > before.value + GAIN * before.value.abs()
        } else {
            self.violation < before.violation * (1.0 - GAIN)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn feasible_first_then_value_or_violation() {
        let score = |value, violation| Score { value, violation };
        assert!(score(1.0, 0.0).beats(score(9.0, 0.1)));
        assert!(score(2.0, 0.0).beats(score(1.0, 0.0)) && !score(1.0, 0.0).beats(score(2.0, 0.0)));
        assert!(score(1.0, 0.1).beats(score(9.0, 0.2)));
        assert!(score(1.0, 0.0).gains_on(score(9.0, 0.1)), "becoming feasible is progress");
        assert!(score(1.001, 0.0).gains_on(score(1.0, 0.0)));
        assert!(!score(1.000_01, 0.0).gains_on(score(1.0, 0.0)));
        assert!(!score(9.0, 0.1).gains_on(score(1.0, 0.1)), "a better value does not help there");
    }
}
