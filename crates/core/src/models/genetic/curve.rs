//! A quadratic on a range, continued with its end slopes: monotone over all inputs if it is
//! monotone on the range, so a command computed from it never turns round.

use super::Valued;

/// y = c0 + c1 x + c2 x^2 for `low <= x <= high`, straight lines with the end slopes outside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Curve {
    /// Coefficients c0, c1, c2.
    pub coefficients: [f64; 3],
    /// Lower end of the fitted range.
    pub low: f64,
    /// Upper end of the fitted range.
    pub high: f64,
}

impl Curve {
    fn on_range(&self, x: f64) -> f64 {
        let [c0, c1, c2] = self.coefficients;
        c0 + x * (c1 + x * c2)
    }

    /// Slope dy/dx on the range (at an end: the slope of the continuation).
    #[must_use]
    pub fn slope(&self, x: f64) -> f64 {
        let [_, c1, c2] = self.coefficients;
        c1 + 2.0 * c2 * x.max(self.low).min(self.high)
    }

    /// Whether the curve keeps one strict direction over its whole range.
    #[must_use]
    pub fn is_monotone(&self) -> bool {
        self.low < self.high && self.slope(self.low) * self.slope(self.high) > 0.0
    }

    /// y at `x`.
    #[must_use]
    #[inline]
    pub fn at(&self, x: f64) -> Valued {
        let inside = x.max(self.low).min(self.high);
        // Inside the range the second term is exactly zero.
        let y = self.on_range(inside) + self.slope(inside) * (x - inside);
        Valued::new(y, x == inside)
    }

    /// The x whose y is given: the exact inverse of [`Self::at`] for a rising curve.
    #[must_use]
    #[inline]
    pub fn inverse(&self, y: f64) -> Valued {
        let [c0, c1, c2] = self.coefficients;
        let (at_low, at_high) = (self.on_range(self.low), self.on_range(self.high));
        if y < at_low {
            return Valued::new(self.low + (y - at_low) / self.slope(self.low), false);
        }
        if y > at_high {
            return Valued::new(self.high + (y - at_high) / self.slope(self.high), false);
        }
        // The stable form of the root: no division by c2, which may be small.
        let discriminant = (c1 * c1 - 4.0 * c2 * (c0 - y)).max(0.0);
        Valued::new(2.0 * (y - c0) / (c1 + discriminant.sqrt()), true)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_inverse_is_exact_inside_and_outside_the_range() {
        let curve = Curve { coefficients: [142.734, 53.572, -11.889], low: 0.38, high: 1.52 };
        assert!(curve.is_monotone());
        for i in -100..400 {
            let x = f64::from(i) * 0.01;
            let y = curve.at(x);
            assert!((curve.inverse(y.value).value - x).abs() < 1e-12, "x = {x}");
            assert_eq!(y.valid, (0.38..=1.52).contains(&x));
        }
    }

    #[test]
    fn the_continuation_is_smooth_and_monotone() {
        let curve = Curve { coefficients: [1.0, 1.0, -0.1], low: 0.0, high: 3.0 };
        let mut before = curve.at(-10.0).value;
        for i in -999..2000 {
            let y = curve.at(f64::from(i) * 0.01).value;
            assert!(y > before);
            before = y;
        }
    }
}
