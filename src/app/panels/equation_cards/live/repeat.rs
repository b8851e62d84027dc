//! For tests: calculates what a formula with values says, the way a reader would by hand.

use crate::base::math;

/// The value of a formula of numbers: `+ - · / ^ % √ ln exp e max pow`, and factors that stand side by
/// side.
pub fn repeated(text: &str) -> f64 {
    let mut reader = Reader { text, rest: text };
    let value = reader.sum();
    assert!(reader.rest.trim().is_empty(), "{text:?} is not read from {:?} on", reader.rest);
    value
}

struct Reader<'a> {
    text: &'a str,
    rest: &'a str,
}

impl Reader<'_> {
    fn take(&mut self, token: &str) -> bool {
        match self.rest.trim_start().strip_prefix(token) {
            Some(rest) => {
                self.rest = rest;
                true
            }
            None => false,
        }
    }

    fn must(&mut self, token: &str) {
        assert!(self.take(token), "{token:?} is missing in {:?} before {:?}", self.text, self.rest);
    }

    fn sum(&mut self) -> f64 {
        let mut value = self.product();
        loop {
            if self.take("+") {
                value += self.product();
            } else if self.take("-") {
                value -= self.product();
            } else {
                return value;
            }
        }
    }

    fn product(&mut self) -> f64 {
        let mut value = self.power();
        loop {
            if self.take("·") {
                value *= self.power();
            } else if self.take("/") {
                value /= self.power();
            } else if self.rest.trim_start().starts_with(['(', '√', 'l', 'e']) {
                value *= self.power();
            } else {
                return value;
            }
        }
    }

    fn power(&mut self) -> f64 {
        let base = self.factor();
        if self.take("%") {
            return base / 100.0;
        }
        if !self.take("^") {
            return base;
        }
        if self.take("{") {
            let exponent = self.sum();
            self.must("}");
            return math::pow(base, exponent);
        }
        math::pow(base, self.factor())
    }

    fn factor(&mut self) -> f64 {
        if self.take("-") {
            return -self.power();
        }
        if self.take("√") {
            return self.factor().sqrt();
        }
        if self.take("max(") {
            let first = self.sum();
            self.must(",");
            let second = self.sum();
            self.must(")");
            return first.max(second);
        }
        if self.take("ln") {
            return math::ln(self.factor());
        }
        if self.take("(") {
            let inside = self.sum();
            self.must(")");
            return inside;
        }
        if self.take("exp") {
            return math::exp(self.factor());
        }
        if self.take("pow(") {
            let base = self.sum();
            self.must(",");
            let exponent = self.sum();
            self.must(")");
            return math::power(base, exponent);
        }
        if self.take("e") {
            return std::f64::consts::E;
        }
        let rest = self.rest.trim_start();
        let end = rest.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(rest.len());
        let number = rest[..end].parse();
        self.rest = &rest[end..];
        number.unwrap_or_else(|_| panic!("no number in {:?} at {rest:?}", self.text))
    }
}

#[test]
fn formulas_are_calculated_as_they_are_read() {
    for (text, value) in [
        ("1 + 2 · 3 - 4 / 2", 5.0),
        ("2 (3 - 1) / 4 · 3^2", 9.0),
        ("√(max(0, 2 - 9)) + 10^{-2} · 50 %", 0.005),
        ("3 ln(e) / 2 + √9", 4.5),
        ("exp(2 - 2) + pow(2, 1 + 2)", 9.0),
    ] {
        assert!((repeated(text) - value).abs() < 1e-12, "{text}");
    }
}
