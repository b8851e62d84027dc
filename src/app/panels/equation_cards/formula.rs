//! Formulas as text, and their typesetting with raised and lowered parts.

use egui::text::{LayoutJob, TextFormat};
use egui::{Align, Color32, FontId};

use crate::base::model::curve::Curve;
use crate::base::model::quartic::Quartic;

/// A number with four digits that count and no useless zeros after the point.
#[must_use]
pub fn number(x: f64) -> String {
    let magnitude = x.abs();
    let decimals = match magnitude {
        m if m >= 1000.0 => 0,
        m if m >= 100.0 => 1,
        m if m >= 10.0 => 2,
        m if m >= 0.01 || m == 0.0 => 3,
        m if m >= 1e-4 => 5,
        _ => return format!("{x:.2e}"),
    };
    let text = format!("{x:.decimals$}");
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

/// A coefficient: six digits that count.
fn coefficient(x: f64) -> String {
    let decimals = match x.abs() {
        m if m >= 1000.0 => 1,
        m if m >= 1.0 => 3,
        _ => 5,
    };
    format!("{x:.decimals$}")
}

/// A coefficient with all its digits; a small one as a power of ten.
#[must_use]
pub fn exact(x: f64) -> String {
    if x == 0.0 || x.abs() >= 1e-4 {
        return format!("{x}");
    }
    let text = format!("{x:e}");
    let (digits, power) = text.split_once('e').unwrap_or((&text, "0"));
    if digits == "1" { format!("10^{{{power}}}") } else { format!("{digits}·10^{{{power}}}") }
}

/// Terms joined with their signs; a factor 1 before a symbol is left out.
#[must_use]
pub fn sum(terms: &[(f64, &str)]) -> String {
    let mut text = String::new();
    for (i, (factor, symbol)) in terms.iter().enumerate() {
        let sign = match (i, *factor < 0.0) {
            (0, false) => "",
            (0, true) => "-",
            (_, false) => " + ",
            (_, true) => " - ",
        };
        text.push_str(sign);
        let size = factor.abs();
        if symbol.is_empty() {
            text.push_str(&number(size));
        } else if size == 1.0 {
            text.push_str(symbol);
        } else {
            text.push_str(&format!("{} {symbol}", number(size)));
        }
    }
    text
}

fn quadratic(coefficients: [f64; 3], x: &str, times: &str) -> String {
    let [c0, c1, c2] = coefficients;
    let sign = |c: f64| if c < 0.0 { '-' } else { '+' };
    format!(
        "{} {} {}{times}{x} {} {}{times}{x}^2",
        coefficient(c0),
        sign(c1),
        coefficient(c1.abs()),
        sign(c2),
        coefficient(c2.abs()),
    )
}

/// A polynomial, its highest power first, as the paper writes it.
#[must_use]
pub fn polynomial(coefficients: &[f64], x: &str, times: &str) -> String {
    let mut text = String::new();
    for (power, factor) in coefficients.iter().enumerate().rev() {
        let sign = match (text.is_empty(), *factor < 0.0) {
            (true, false) => "",
            (true, true) => "-",
            (false, false) => " + ",
            (false, true) => " - ",
        };
        let size = exact(factor.abs());
        text.push_str(&match power {
            0 => format!("{sign}{size}"),
            1 => format!("{sign}{size}{times}{x}"),
            _ => format!("{sign}{size}{times}{x}^{power}"),
        });
    }
    text
}

/// The quartic with a value put in; beyond its range its straight continuation.
#[must_use]
pub fn quartic_with(quartic: &Quartic, x: f64, [low, high]: [f64; 2]) -> String {
    let inside = x.max(low).min(high);
    if x == inside {
        return polynomial(&quartic.coefficients, &number(x), " · ");
    }
    format!(
        "{} + {} ({} - {})",
        number(quartic.at(inside)),
        number(quartic.slope(inside)),
        number(x),
        number(inside)
    )
}

/// The curve over the symbol `x`.
#[must_use]
pub fn curve_formula(curve: &Curve, x: &str) -> String {
    quadratic(curve.coefficients, x, " ")
}

/// The curve with a value put in; beyond its range its straight continuation.
#[must_use]
pub fn curve_with(curve: &Curve, x: f64) -> String {
    let inside = x.max(curve.low).min(curve.high);
    if x == inside {
        return quadratic(curve.coefficients, &number(x), " · ");
    }
    format!(
        "{} + {} ({} - {})",
        number(curve.at(inside).value),
        number(curve.slope(inside)),
        number(x),
        number(inside)
    )
}

fn inverse_text(curve: &Curve, y: &str) -> String {
    let [c0, c1, c2] = curve.coefficients;
    let sign = if c2 < 0.0 { '-' } else { '+' };
    let [c0, c1, c2] = [c0, c1, c2.abs()].map(coefficient);
    format!("2 ({y} - {c0}) / ({c1} + √({c1}^2 {sign} 4 · {c2} ({y} - {c0})))")
}

/// The curve's inverse over the symbol `y`.
#[must_use]
pub fn curve_inverse_formula(curve: &Curve, y: &str) -> String {
    inverse_text(curve, y)
}

/// The curve's inverse with a value put in; beyond its range its straight continuation.
#[must_use]
pub fn curve_inverse(curve: &Curve, y: f64) -> String {
    let end = if y < curve.at(curve.low).value {
        curve.low
    } else if y > curve.at(curve.high).value {
        curve.high
    } else {
        return inverse_text(curve, &number(y));
    };
    let at_end = number(curve.at(end).value);
    format!("{} + ({} - {at_end}) / {}", number(end), number(y), number(curve.slope(end)))
}

#[derive(Clone, Copy, PartialEq)]
enum Level {
    Base,
    Lowered,
    Raised,
}

/// The runs of a formula: text and level.
fn runs(formula: &str) -> Vec<(String, Level)> {
    let mut runs: Vec<(String, Level)> = Vec::new();
    let mut push = |c: char, level: Level| match runs.last_mut() {
        Some((text, last)) if *last == level => text.push(c),
        _ => runs.push((c.to_string(), level)),
    };
    let mut rest = formula.chars().peekable();
    while let Some(c) = rest.next() {
        let level = match c {
            '_' => Level::Lowered,
            '^' => Level::Raised,
            _ => {
                push(c, Level::Base);
                continue;
            }
        };
        match rest.next() {
            Some('{') => rest.by_ref().take_while(|c| *c != '}').for_each(|c| push(c, level)),
            // `A_D` in lists of words stays one letter; so do all short indices.
            Some(c) => push(c, level),
            None => push(c, Level::Base),
        }
    }
    runs
}

/// A formula set in `size` points.
#[must_use]
pub fn typeset(formula: &str, size: f32, color: Color32) -> LayoutJob {
    let mut job = LayoutJob::default();
    for (text, level) in runs(formula) {
        let (scale, valign) = match level {
            Level::Base => (1.0, Align::Center),
            Level::Lowered => (0.7, Align::BOTTOM),
            Level::Raised => (0.68, Align::TOP),
        };
        let font_id = FontId::proportional(size * scale);
        job.append(&text, 0.0, TextFormat { font_id, color, valign, ..TextFormat::default() });
    }
    job
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_four_digits() {
        let shown = [0.0, 0.81, 12.345, 324.61, 2201.4, -3.0, 0.00012].map(number);
        assert_eq!(shown, ["0", "0.81", "12.35", "324.6", "2201", "-3", "0.00012"]);
    }

    #[test]
    fn continuations_are_written_as_the_model_computes_them() {
        let curve = Curve { coefficients: [142.734, 53.572, -11.889], low: 0.38, high: 1.52 };
        assert_eq!(curve_with(&curve, 0.5), "142.734 + 53.572 · 0.5 - 11.889 · 0.5^2");
        assert!(curve_with(&curve, 2.0).ends_with("(2 - 1.52)"));
        assert!(curve_inverse(&curve, 400.0).starts_with("1.52 + (400 - "));
        assert_eq!(sum(&[(1.0, "s^2"), (-2.0, "s"), (5.0, "")]), "s^2 - 2 s + 5");
    }

    #[test]
    fn indices_and_powers_are_found() {
        let texts: Vec<String> = runs("F_{dyn} = n^3").into_iter().map(|(text, _)| text).collect();
        assert_eq!(texts, ["F", "dyn", " = n", "3"]);
        assert_eq!(typeset("f_c", 14.0, Color32::WHITE).text, "fc");
    }
}
