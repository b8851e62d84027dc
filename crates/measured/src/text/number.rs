//! Numbers as instruments, spreadsheets and programs write them.

use crate::layout::{DecimalMark, ThousandsMark};

/// Powers of ten that a double holds exactly.
const POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16,
    1e17, 1e18, 1e19, 1e20, 1e21, 1e22,
];
/// Whole numbers up to this are doubles exactly.
const EXACT: u64 = 1 << 53;
/// Digits of which every number is a whole one of 64 bits.
const MAX_DIGITS: usize = 19;

/// What instruments write where they have no value.
const MISSING: [&str; 10] =
    ["", "nan", "na", "n/a", "-", "--", "null", "1.#qnan", "-1.#ind", "1.#ind"];

/// The plain number that bytes begin with, and how many they are: digits, a decimal sign, an exponent. None where it
/// takes more than one exact multiplication or division to be right to the last bit (Clinger's fast path), or where
/// there is no plain number.
#[inline]
pub(super) fn leading(bytes: &[u8], decimal: u8) -> Option<(f64, usize)> {
    let negative = bytes.first() == Some(&b'-');
    let mut at = usize::from(negative || bytes.first() == Some(&b'+'));
    let start = at;
    let mut whole: u64 = 0;
    let mut digit = |at: usize| {
        let digit = bytes.get(at)?.wrapping_sub(b'0');
        (digit < 10).then(|| whole = whole.wrapping_mul(10).wrapping_add(u64::from(digit)))
    };
    while digit(at).is_some() {
        at += 1;
    }
    let mut digits = at - start;
    let mut power: i32 = 0;
    if bytes.get(at) == Some(&decimal) {
        let point = at + 1;
        at = point;
        while digit(at).is_some() {
            at += 1;
        }
        let behind = at - point;
        // A comma behind a number may be no decimal sign.
        if behind == 0 && decimal == b',' {
            return None;
        }
        digits += behind;
        power = -i32::try_from(behind).ok()?;
    }
    if digits == 0 || digits > MAX_DIGITS || whole > EXACT {
        return None;
    }
    if let Some(b'e' | b'E') = bytes.get(at) {
        let sign = bytes.get(at + 1);
        let from = at + 1 + usize::from(matches!(sign, Some(b'-' | b'+')));
        let count =
            bytes[from.min(bytes.len())..].iter().take(4).take_while(|x| x.is_ascii_digit());
        let exponent: i32 =
            std::str::from_utf8(bytes.get(from..from + count.count())?).ok()?.parse().ok()?;
        power += if sign == Some(&b'-') { -exponent } else { exponent };
        at = from;
        while bytes.get(at).is_some_and(u8::is_ascii_digit) {
            at += 1;
        }
        if at - from > 4 {
            return None;
        }
    }
    let size = *POWERS.get(usize::try_from(power.unsigned_abs()).ok()?)?;
    let value = if power < 0 { whole as f64 / size } else { whole as f64 * size };
    Some((if negative { -value } else { value }, at))
}

/// The number in a cell, not a number where the cell says that there is none; nothing where it is something else.
pub(super) fn number(cell: &str, decimal: DecimalMark, thousands: ThousandsMark) -> Option<f64> {
    if let Some((value, used)) = leading(cell.as_bytes(), decimal.byte())
        && used == cell.len()
    {
        return Some(value);
    }
    if cell.len() <= 8 {
        let lower = cell.to_ascii_lowercase().replace(',', ".");
        if MISSING.contains(&lower.as_str()) {
            return Some(f64::NAN);
        }
        if ["inf", "+inf", "-inf"].contains(&lower.as_str()) {
            return lower.parse().ok();
        }
    }
    let cell = match thousands {
        ThousandsMark::None => cell.to_owned(),
        ThousandsMark::Point
        | ThousandsMark::Comma
        | ThousandsMark::Blank
        | ThousandsMark::Apostrophe => without_thousands(cell, decimal, thousands)?,
    };
    // As [`leading`]: a comma behind a number may be no decimal sign.
    let behind = cell.rsplit_once(',').map_or("0", |(_, behind)| behind);
    if decimal == DecimalMark::Comma && !behind.starts_with(|sign: char| sign.is_ascii_digit()) {
        return None;
    }
    let plain: Option<String> = cell
        .chars()
        .map(|sign| match sign {
            '0'..='9' | '+' | '-' | 'e' | 'E' => Some(sign),
            // Fortran's double precision.
            'd' | 'D' => Some('e'),
            // The sign minus.
            '\u{2212}' => Some('-'),
            sign if sign == char::from(decimal.byte()) => Some('.'),
            _ => None,
        })
        .collect();
    plain?.parse().ok()
}

/// A number without what stands between its thousands; none if that stands where no thousands are.
fn without_thousands(cell: &str, decimal: DecimalMark, thousands: ThousandsMark) -> Option<String> {
    let end = cell.find([char::from(decimal.byte()), 'e', 'E']).unwrap_or(cell.len());
    let (whole, rest) = cell.split_at(end);
    let groups: Vec<&str> = whole.split(|sign| thousands.is(sign)).collect();
    let right = |(place, group): (usize, &&str)| match place {
        0 => {
            groups.len() == 1
                || (1..=3).contains(&group.trim_start_matches(['-', '+', '\u{2212}']).len())
        }
        _ => group.len() == 3 && group.bytes().all(|byte| byte.is_ascii_digit()),
    };
    let all = groups.iter().enumerate().all(right);
    (all && !rest.contains(|sign| thousands.is(sign))).then(|| groups.concat() + rest)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn point(cell: &str) -> Option<f64> {
        number(cell, DecimalMark::Point, ThousandsMark::None)
    }

    proptest! {
        #[test]
        fn every_number_reads_as_the_usual_parse_reads_it(bits in any::<u64>(), places in 0usize..12) {
            let x = f64::from_bits(bits);
            prop_assume!(x.is_finite());
            for text in [format!("{x}"), format!("{x:e}"), format!("{:.places$}", x % 1e9), format!("{:.places$e}", x)] {
                let usual: f64 = text.parse().unwrap();
                prop_assert_eq!(point(&text).map(f64::to_bits), Some(usual.to_bits()), "{}", &text);
                let comma = text.replace('.', ",");
                let read = number(&comma, DecimalMark::Comma, ThousandsMark::None);
                prop_assert_eq!(read.map(f64::to_bits), Some(usual.to_bits()), "{}", &comma);
            }
        }

        #[test]
        fn any_text_is_a_number_or_not(cell in r"[0-9.,eE+\-' aDn]{0,24}") {
            for decimal in DecimalMark::ALL {
                for thousands in ThousandsMark::ALL {
                    let _ = number(&cell, *decimal, *thousands);
                }
            }
        }
    }

    #[test]
    fn numbers_of_every_country_are_read() {
        let read = |cell, decimal, thousands| number(cell, decimal, thousands);
        use {DecimalMark as D, ThousandsMark as T};
        for (cell, decimal, thousands, expected) in [
            ("1.234.567,5", D::Comma, T::Point, 1_234_567.5),
            ("-1,234.5e3", D::Point, T::Comma, -1_234_500.0),
            ("1 234,5", D::Comma, T::Blank, 1234.5),
            ("12\u{a0}345", D::Comma, T::Blank, 12_345.0),
            ("12\u{202f}345,25", D::Comma, T::Blank, 12_345.25),
            ("1'234.5", D::Point, T::Apostrophe, 1234.5),
            ("1234", D::Point, T::Comma, 1234.0),
            ("\u{2212}0,5", D::Comma, T::None, -0.5),
            ("1.5D-3", D::Point, T::None, 1.5e-3),
            (".5", D::Point, T::None, 0.5),
            ("5.", D::Point, T::None, 5.0),
            ("+7", D::Point, T::None, 7.0),
        ] {
            assert_eq!(read(cell, decimal, thousands), Some(expected), "{cell}");
        }
        for cell in ["", "NaN", "-", "N/A", "1.#QNAN", "-1,#IND"] {
            assert!(point(cell).is_some_and(f64::is_nan), "{cell}");
        }
        assert_eq!(point("-Inf"), Some(f64::NEG_INFINITY));
    }

    #[test]
    fn what_is_no_number_is_none() {
        use {DecimalMark as D, ThousandsMark as T};
        for (cell, decimal, thousands) in [
            ("1,5", D::Point, T::None),
            ("1.5", D::Comma, T::None),
            ("1,", D::Comma, T::None),
            ("12,34", D::Point, T::Comma),
            ("1,2345", D::Point, T::Comma),
            ("1,234,5", D::Point, T::Comma),
            ("1.5 N", D::Point, T::None),
            ("abc", D::Point, T::None),
            ("infinity", D::Point, T::None),
            ("0x10", D::Point, T::None),
            ("1e", D::Point, T::None),
            ("1-2", D::Point, T::None),
        ] {
            assert_eq!(number(cell, decimal, thousands), None, "{cell}");
        }
    }
}
