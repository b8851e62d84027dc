//! The laws that models are made of, as text: over a symbol, and with a value put in as the model
//! computes it, so that whoever repeats the calculation by hand gets the same result.

use super::formula::number;
use crate::base::math;
use crate::models::genetic::curve::Curve;
use crate::models::genetic::exponential::Exponential;
use crate::models::genetic::quartic::Quartic;

/// A coefficient with all its digits; a small one with a power of ten.
fn exact(x: f64) -> String {
    if x == 0.0 || x.abs() >= 1e-4 {
        return format!("{x}");
    }
    let text = format!("{x:e}");
    let (digits, power) = text.split_once('e').unwrap_or((&text, "0"));
    if digits == "1" { format!("10^{{{power}}}") } else { format!("{digits}·10^{{{power}}}") }
}

/// A coefficient with `decimals` digits behind the point, without trailing zeros.
fn rounded(x: f64, decimals: usize) -> String {
    let text = format!("{x:.decimals$}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// A fitted coefficient: six digits that count.
fn coefficient(x: f64) -> String {
    let decimals = match x.abs() {
        m if m >= 1000.0 => 1,
        m if m >= 1.0 => 3,
        _ => 5,
    };
    format!("{x:.decimals$}")
}

fn sign(x: f64) -> char {
    if x < 0.0 { '-' } else { '+' }
}

/// A polynomial c0 + c1 x + .., its highest power first, as the paper of 2013 writes it.
#[must_use]
pub fn polynomial(coefficients: &[f64], x: &str) -> String {
    falling(coefficients, x, " ")
}

/// The polynomial with a value put in.
#[must_use]
pub fn polynomial_with(coefficients: &[f64], x: f64) -> String {
    falling(coefficients, &number(x), " · ")
}

fn falling(coefficients: &[f64], x: &str, times: &str) -> String {
    let mut text = String::new();
    for (power, factor) in coefficients.iter().enumerate().rev() {
        let size = exact(factor.abs());
        text.push_str(&match (text.is_empty(), *factor < 0.0) {
            (true, false) => size,
            (true, true) => format!("-{size}"),
            (false, _) => format!(" {} {size}", sign(*factor)),
        });
        text.push_str(&match power {
            0 => String::new(),
            1 => format!("{times}{x}"),
            _ => format!("{times}{x}^{power}"),
        });
    }
    text
}

/// A straight continuation: from `y` at `end`, with `slope`, to `x`.
#[must_use]
pub fn straight_on(y: f64, slope: f64, x: f64, end: f64) -> String {
    let (sign, size) = (sign(slope), number(slope.abs()));
    format!("{} {sign} {size} ({} - {})", number(y), number(x), number(end))
}

/// The quartic with a value put in; beyond its range its straight continuation.
#[must_use]
pub fn quartic_with(quartic: &Quartic, x: f64, [low, high]: [f64; 2]) -> String {
    let inside = math::limit(x, low, high);
    if x == inside {
        polynomial_with(&quartic.coefficients, x)
    } else {
        straight_on(quartic.at(inside), quartic.slope(inside), x, inside)
    }
}

/// The exponential law over the symbol `x`.
#[must_use]
pub fn exponential(law: &Exponential, x: &str) -> String {
    exponential_of(law, &format!(" {x}"))
}

/// The exponential law with a value put in.
#[must_use]
pub fn exponential_with(law: &Exponential, x: f64) -> String {
    exponential_of(law, &format!(" · {}", number(x)))
}

fn exponential_of(law: &Exponential, times_x: &str) -> String {
    format!("{} e^{{{}{times_x}}}", rounded(law.scale_rpm, 1), rounded(law.rate_per_n, 7))
}

fn quadratic([c0, c1, c2]: [f64; 3], x: &str, times: &str) -> String {
    let line = format!("{} {} {}{times}{x}", coefficient(c0), sign(c1), coefficient(c1.abs()));
    if c2 == 0.0 {
        return line;
    }
    format!("{line} {} {}{times}{x}^2", sign(c2), coefficient(c2.abs()))
}

/// The curve over the symbol `x`.
#[must_use]
pub fn curve_formula(curve: &Curve, x: &str) -> String {
    quadratic(curve.coefficients, x, " ")
}

/// The curve with a value put in; beyond its range its straight continuation.
#[must_use]
pub fn curve_with(curve: &Curve, x: f64) -> String {
    let inside = math::limit(x, curve.low, curve.high);
    if x == inside {
        quadratic(curve.coefficients, &number(x), " · ")
    } else {
        straight_on(curve.at(inside).value, curve.slope(inside), x, inside)
    }
}

/// The curve's inverse over the symbol `y`.
#[must_use]
pub fn curve_inverse_formula(curve: &Curve, y: &str) -> String {
    let [c0, c1, c2] = curve.coefficients;
    let sign = sign(c2);
    let straight = c2 == 0.0;
    let [c0, c1, c2] = [c0, c1, c2.abs()].map(coefficient);
    if straight {
        return format!("({y} - {c0}) / {c1}");
    }
    format!("2 ({y} - {c0}) / ({c1} + √({c1}^2 {sign} 4 · {c2} ({y} - {c0})))")
}

/// The curve's inverse with a value put in; beyond its range its straight continuation.
#[must_use]
pub fn curve_inverse(curve: &Curve, y: f64) -> String {
    let end = if y < curve.at(curve.low).value {
        curve.low
    } else if y > curve.at(curve.high).value {
        curve.high
    } else {
        return curve_inverse_formula(curve, &number(y));
    };
    let at_end = number(curve.at(end).value);
    format!("{} + ({} - {at_end}) / {}", number(end), number(y), number(curve.slope(end)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::genetic::strategy_2013;

    #[test]
    fn continuations_are_written_as_the_model_computes_them() {
        let curve = Curve { coefficients: [142.734, 53.572, -11.889], low: 0.38, high: 1.52 };
        assert_eq!(curve_with(&curve, 0.5), "142.734 + 53.572 · 0.5 - 11.889 · 0.5^2");
        assert!(curve_with(&curve, 2.0).ends_with("(2 - 1.52)"));
        assert!(curve_inverse(&curve, 400.0).starts_with("1.52 + (400 - "));
        let line = Curve { coefficients: [136.65, 53.755, 0.0], low: 0.4, high: 1.11 };
        assert_eq!(curve_formula(&line, "Ra"), "136.650 + 53.755 Ra");
        assert_eq!(curve_inverse_formula(&line, "F"), "(F - 136.650) / 53.755");
        let beyond = quartic_with(&strategy_2013::M2_RESTORED, 140.0, [157.5, 197.0]);
        assert!(beyond.ends_with("(140 - 157.5)"), "{beyond}");
    }

    #[test]
    fn laws_are_written_with_the_digits_of_the_paper() {
        let printed = polynomial(&strategy_2013::M2.coefficients, "F");
        assert_eq!(printed, "10^{-5} F^4 - 0.01 F^3 + 2.7568 F^2 - 333.75 F + 15348");
        assert_eq!(exponential(&strategy_2013::M3, "F"), "7641.3 e^{-0.004 F}");
        assert_eq!(exponential_with(&strategy_2013::M3, 180.0), "7641.3 e^{-0.004 · 180}");
        let restored = polynomial(&strategy_2013::M2_RESTORED.coefficients, "F");
        assert!(restored.starts_with("1.426371·10^{-5} F^4 - 0.01015767 F^3"), "{restored}");
    }
}
