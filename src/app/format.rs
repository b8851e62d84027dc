//! How numbers, units and times are written for people: the one place for number formats.

use crate::base::math::{ln, pow};
use crate::run::signals::{Row, flag};

/// A unit for people: the tables write it in plain letters.
#[must_use]
pub fn unit(unit: &str) -> String {
    unit.replace("um", "µm").replace("cm^3", "cm³").replace("cm3", "cm³").replace("deg", "°")
}

/// A value with the number of digits that suits its unit, without the unit.
#[must_use]
pub fn number(value: f64, unit: &str) -> String {
    let decimals = match unit {
        "um" => 3,
        "s" | "mm" | "ms" | "cm^3" | "-" => 2,
        "kW" => 2,
        "N" | "%" | "deg" | "min" | "m/min" | "cm3/min" => 1,
        _ => 0,
    };
    // No negative zero.
    let text = format!("{value:.decimals$}");
    if text.trim_start_matches(['-', '0', '.']).is_empty() {
        text.trim_start_matches('-').to_owned()
    } else {
        text
    }
}

/// A value with its unit.
#[must_use]
pub fn quantity(value: f64, unit_text: &str) -> String {
    let unit = if unit_text == "-" { String::new() } else { unit(unit_text) };
    format!("{} {unit}", number(value, unit_text)).trim_end().to_owned()
}

/// A deviation in percent with its sign; one that rounds to zero has no minus.
#[must_use]
pub fn deviation(percent: f64) -> String {
    let value = number(percent, "%");
    if value.starts_with('-') { format!("{value} %") } else { format!("+{value} %") }
}

/// An override in percent with its unit; a quantised one is a whole number.
#[must_use]
pub fn override_percent(value: f64, quantised: bool) -> String {
    if quantised { format!("{value:.0} %") } else { quantity(value, "%") }
}

/// A value of any size with about four significant digits and its unit: where a quantity's usual
/// digits would hide a small one.
#[must_use]
pub fn fine(value: f64, unit_text: &str) -> String {
    let decimals = match value.abs() {
        size if size >= 1000.0 || size == 0.0 => 0,
        size if size >= 100.0 => 1,
        size if size >= 10.0 => 2,
        size if size >= 0.1 => 3,
        _ => 4,
    };
    format!("{value:.decimals$} {}", unit(unit_text)).trim_end().to_owned()
}

/// The decimal logarithm.
#[must_use]
pub fn log10(x: f64) -> f64 {
    ln(x) / std::f64::consts::LN_10
}

/// The next round step (1, 2 or 5 times a power of ten) at or above `raw`; none where that is not
/// a positive number.
#[must_use]
pub fn round_step(raw: f64) -> Option<f64> {
    if !(raw.is_finite() && raw > 0.0) {
        return None;
    }
    let decade = pow(10.0, log10(raw).floor());
    let factors = [1.0, 2.0, 5.0, 10.0];
    Some(factors.map(|f| f * decade).into_iter().find(|s| *s >= raw).unwrap_or(raw))
}

/// A time on the scale of the run: `12.34 s`, `1:02.3 min`.
#[must_use]
pub fn time(time_s: f64) -> String {
    if time_s < 600.0 {
        format!("{time_s:.2} s")
    } else {
        let minutes = (time_s / 60.0).floor();
        format!("{minutes:.0}:{:04.1} min", time_s - 60.0 * minutes)
    }
}

/// A time of a length of time: `12.34 / 56.71 s`.
#[must_use]
pub fn time_of(time_s: f64, length_s: f64) -> String {
    let length = time(length_s);
    if length_s < 600.0 {
        format!("{time_s:.2} / {length}")
    } else {
        format!("{} / {length}", time(time_s))
    }
}

/// What stands in the place of a value that a row has none of.
#[must_use]
pub fn none(row: &Row) -> &'static str {
    if row.has(flag::AIR) { "no contact" } else { "outside model" }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_read_well() {
        assert_eq!(quantity(0.8123, "um"), "0.812 µm");
        assert_eq!(quantity(-0.004, "%"), "0.0 %");
        assert_eq!(quantity(1.0, "-"), "1.00");
        assert_eq!([deviation(-0.004), deviation(-5.77)], ["+0.0 %", "-5.8 %"]);
        assert_eq!(fine(0.11658, "mm"), "0.117 mm");
        assert_eq!(fine(0.005_63, "mm"), "0.0056 mm");
        assert_eq!(fine(2434.3, "1/min"), "2434 1/min");
        assert_eq!(time(61.25), "61.25 s");
        assert_eq!(time(3599.5), "59:59.5 min");
    }
}
