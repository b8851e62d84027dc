//! How numbers, units and times are written for people: the one place for number formats. A negative number has the
//! sign minus (U+2212), and no line is broken between a number and its unit; files, links and the command line have
//! neither.

use crate::base::language::{self, Language, tr};
use crate::base::math::{ln, pow};
use crate::run::signals::{Row, flag};

/// A unit for people: the tables write it in plain letters.
#[must_use]
pub fn unit(unit: &str) -> String {
    unit.replace("um", "µm").replace("cm^3", "cm³").replace("cm3", "cm³").replace("deg", "°")
}

/// The sign of a negative number.
pub const MINUS: char = '\u{2212}';
/// The space that no line is broken at.
const FIRM: char = '\u{a0}';

/// A number that was written with a hyphen before it, with the sign minus.
#[must_use]
pub fn signed(number: String) -> String {
    match number.strip_prefix('-') {
        Some(size) => format!("{MINUS}{size}"),
        None => number,
    }
}

/// A number, written already, with its unit.
#[must_use]
pub fn beside(number: String, unit: &str) -> String {
    if unit.is_empty() { number } else { format!("{number}{FIRM}{unit}") }
}

/// Units behind numbers, as people read them.
const UNITS: &[&str] = &[
    "%", "µm", "mm", "mm²", "m", "mm/min", "m/min", "mm/s", "s", "ms", "min", "N", "kN", "N/mm²",
    "N/µm", "1/min", "Hz", "kHz", "kW", "W", "HB", "cm³", "cm³/min", "kg", "°C", "rad/s",
];

/// A sentence that was made elsewhere, for people: with the sign minus, and numbers that keep to their units. What
/// stands between grave accents is meant to be typed, and stays.
#[must_use]
pub fn typeset(sentence: &str) -> String {
    let mut out = String::with_capacity(sentence.len() + 8);
    for (place, part) in sentence.split('`').enumerate() {
        if place > 0 {
            out.push('`');
        }
        if place % 2 == 1 {
            out.push_str(part);
            continue;
        }
        let part = micrometres(part);
        let mut before = None;
        for (at, c) in part.char_indices() {
            let rest = &part[at + c.len_utf8()..];
            let digit_before = before.is_some_and(|c: char| c.is_ascii_digit());
            let digit_after = rest.starts_with(|c: char| c.is_ascii_digit());
            let begins =
                before.is_none_or(|c: char| c.is_whitespace() || "([\u{201e}\u{201c}=".contains(c));
            out.push(match c {
                '-' if begins && digit_after => MINUS,
                ' ' if digit_before && unit_leads(rest) => FIRM,
                other => other,
            });
            before = Some(c);
        }
    }
    out
}

/// Micrometres behind numbers as people write them. In German the same letters are a word, with another one behind it.
fn micrometres(part: &str) -> String {
    let mut out = String::with_capacity(part.len() + 2);
    let german = language::chosen() == Language::German;
    let mut rest = part;
    while let Some(at) = rest.find(" um") {
        let (before, after) = (&rest[..at], &rest[at + " um".len()..]);
        let ends = |c: char| ",;:.)]".contains(c) || !german && c.is_whitespace();
        let is_unit =
            before.ends_with(|c: char| c.is_ascii_digit()) && after.chars().next().is_none_or(ends);
        out.push_str(before);
        out.push_str(if is_unit { " µm" } else { " um" });
        rest = after;
    }
    out.push_str(rest);
    out
}

/// A typeset text as keys write it; none where it is that already.
#[must_use]
pub fn typed(text: &str) -> Option<String> {
    text.contains([MINUS, FIRM]).then(|| text.replace(MINUS, "-").replace(FIRM, " "))
}

/// Whether a text begins with a unit.
fn unit_leads(text: &str) -> bool {
    let ends = |c: char| c.is_whitespace() || ",;:.)]\u{201d}".contains(c);
    let word = text.split(ends).next().unwrap_or("");
    UNITS.contains(&word)
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
    let text = language::fixed(value, decimals);
    if text.trim_start_matches(['-', '0', '.', ',']).is_empty() {
        text.trim_start_matches('-').to_owned()
    } else {
        signed(text)
    }
}

/// A value with its unit.
#[must_use]
pub fn quantity(value: f64, unit_text: &str) -> String {
    let unit = if unit_text == "-" { String::new() } else { unit(unit_text) };
    beside(number(value, unit_text), &unit)
}

/// A deviation in percent with its sign; one that rounds to zero has no minus.
#[must_use]
pub fn deviation(percent: f64) -> String {
    let value = number(percent, "%");
    beside(if value.starts_with(MINUS) { value } else { format!("+{value}") }, "%")
}

/// An override in percent with its unit; a quantised one is a whole number.
#[must_use]
pub fn override_percent(value: f64, quantised: bool) -> String {
    if quantised { beside(format!("{value:.0}"), "%") } else { quantity(value, "%") }
}

/// A value of any size with about four significant digits and its unit: where a quantity's usual
/// digits would hide a small one.
#[must_use]
pub fn fine(value: f64, unit_text: &str) -> String {
    // A frequency response in m/N would be nothing but zeros.
    if value != 0.0 && value.abs() < 1e-3 {
        let number = language::decimal(format!("{value:.2e}")).replace('-', &MINUS.to_string());
        return beside(number, &unit(unit_text));
    }
    let decimals = match value.abs() {
        size if size >= 1000.0 || size == 0.0 => 0,
        size if size >= 100.0 => 1,
        size if size >= 10.0 => 2,
        size if size >= 0.1 => 3,
        _ => 4,
    };
    beside(signed(language::fixed(value, decimals)), &unit(unit_text))
}

/// Words that begin small as a sentence: with a capital and a full stop.
#[must_use]
pub fn sentence(words: &str) -> String {
    let mut letters = words.chars();
    let first = letters.next().map_or(String::new(), |letter| letter.to_uppercase().to_string());
    format!("{first}{}.", letters.as_str())
}

/// A quantity without a decimal that is zero, for round numbers.
#[must_use]
pub fn round_quantity(value: f64, unit_text: &str) -> String {
    let zero = format!("{}0{FIRM}", language::decimal_sign());
    quantity(value, unit_text).replace(&zero, &FIRM.to_string())
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
        beside(language::fixed(time_s, 2), "s")
    } else {
        let minutes = (time_s / 60.0).floor();
        let seconds = language::decimal(format!("{:04.1}", time_s - 60.0 * minutes));
        beside(format!("{minutes:.0}:{seconds}"), "min")
    }
}

/// A time of a length of time: `12.34 / 56.71 s`.
#[must_use]
pub fn time_of(time_s: f64, length_s: f64) -> String {
    let length = time(length_s);
    if length_s < 600.0 {
        format!("{} / {length}", language::fixed(time_s, 2))
    } else {
        format!("{} / {length}", time(time_s))
    }
}

/// What stands in the place of a value that a row has none of.
#[must_use]
pub fn none(row: &Row) -> &'static str {
    if row.has(flag::AIR) { tr("no contact") } else { tr("outside model") }
}

/// A value of a roughness, marked where its model is asked outside its range: there it is continued beyond what was
/// measured, which a bare number does not tell.
#[must_use]
pub fn continued(text: String, row: &Row, signal: &str) -> String {
    let models = match signal {
        "ra_um" => flag::K5_OUTSIDE,
        "ra_dyn_um" => flag::K5_OUTSIDE | flag::K6_OUTSIDE,
        _ => 0,
    };
    if row.has(models) { format!("{CONTINUED} {text}") } else { text }
}

/// The mark of a value that a model gives outside its range.
const CONTINUED: char = '\u{2248}';

/// What is said of that mark beside such a value; empty where none of the rows is outside.
#[must_use]
pub fn continued_help(rows: [&Row; 2]) -> &'static str {
    match rows.iter().any(|row| row.has(flag::K5_OUTSIDE | flag::K6_OUTSIDE)) {
        true => tr(
            "With \u{2248} before it a value lies outside the range of its model: it is continued beyond what was \
             measured.",
        ),
        false => "",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_read_well() {
        let plain = |text: String| {
            assert!(!text.contains([' ', '-']), "{text}");
            text.replace(FIRM, " ").replace(MINUS, "-")
        };
        assert_eq!(plain(quantity(0.8123, "um")), "0.812 µm");
        assert_eq!(plain(quantity(-0.004, "%")), "0.0 %");
        assert_eq!(quantity(1.0, "-"), "1.00");
        assert_eq!([deviation(-0.004), deviation(-5.77)].map(plain), ["+0.0 %", "-5.8 %"]);
        assert_eq!([400.0, 12.5].map(|x| plain(round_quantity(x, "N"))), ["400 N", "12.5 N"]);
        assert_eq!([sentence("žaga je topa"), sentence("")], ["Žaga je topa.", "."]);
        assert_eq!(plain(fine(0.11658, "mm")), "0.117 mm");
        assert_eq!(plain(fine(-0.005_63, "mm")), "-0.0056 mm");
        assert_eq!(plain(fine(2434.3, "1/min")), "2434 1/min");
        assert_eq!(plain(fine(-9.344e-6, "m/N")), "-9.34e-6 m/N");
        assert_eq!(plain(fine(0.0, "N")), "0 N");
        assert_eq!(plain(time(61.25)), "61.25 s");
        assert_eq!(plain(time(3599.5)), "59:59.5 min");
    }

    #[test]
    fn sentences_have_the_sign_minus_and_keep_numbers_to_their_units() {
        for (said, shown) in [
            ("Ra is -3.2 % off (-12 N)", "Ra is \u{2212}3.2\u{a0}% off (\u{2212}12\u{a0}N)"),
            ("from 2 to 5 mm, at 300 mm/min.", "from 2 to 5\u{a0}mm, at 300\u{a0}mm/min."),
            (
                "from 0.05 to 4 um. Ra 2 um, (3 um)",
                "from 0.05 to 4\u{a0}µm. Ra 2\u{a0}µm, (3\u{a0}µm)",
            ),
            ("0.81 um at 5 s", "0.81\u{a0}µm at 5\u{a0}s"),
            ("step 2 of 3, 2013-05, K-1", "step 2 of 3, 2013-05, K-1"),
            ("type `run -5 s` in 5 s", "type `run -5 s` in 5\u{a0}s"),
        ] {
            assert_eq!(typeset(said), shown);
        }
        // In German it is a word.
        language::choose(Language::German);
        let said = typeset("von 3 um 2 mm, rund 5 um die Mitte, 3 um");
        language::choose(Language::English);
        assert_eq!(said, "von 3 um 2\u{a0}mm, rund 5 um die Mitte, 3\u{a0}µm");
    }
}
