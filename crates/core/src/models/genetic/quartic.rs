//! A polynomial of fourth degree (2013 eq. 3), and its use on the range where it rises.

use super::Valued;

/// y = c0 + c1 x + c2 x^2 + c3 x^3 + c4 x^4.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quartic {
    /// Coefficients c0..c4.
    pub coefficients: [f64; 5],
}

impl Quartic {
    /// y at `x`.
    #[must_use]
    pub fn at(&self, x: f64) -> f64 {
        let [c0, c1, c2, c3, c4] = self.coefficients;
        c0 + x * (c1 + x * (c2 + x * (c3 + x * c4)))
    }

    /// dy/dx at `x`.
    #[must_use]
    pub fn slope(&self, x: f64) -> f64 {
        let [_, c1, c2, c3, c4] = self.coefficients;
        c1 + x * (2.0 * c2 + x * (3.0 * c3 + x * 4.0 * c4))
    }

    /// y at `x`, continued with the end slopes outside `low..=high` and marked there.
    #[must_use]
    pub fn continued(&self, x: f64, [low, high]: [f64; 2]) -> Valued {
        let inside = x.max(low).min(high);
        Valued::new(self.at(inside) + self.slope(inside) * (x - inside), x == inside)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_and_slopes_are_those_of_the_polynomial() {
        let quartic = Quartic { coefficients: [1.0, -2.0, 3.0, -4.0, 5.0] };
        assert_eq!(quartic.at(2.0), 1.0 - 4.0 + 12.0 - 32.0 + 80.0);
        assert_eq!(quartic.slope(2.0), -2.0 + 12.0 - 48.0 + 160.0);
        let beyond = quartic.continued(3.0, [1.0, 2.0]);
        assert_eq!((beyond.value, beyond.valid), (57.0 + 122.0, false));
    }
}
