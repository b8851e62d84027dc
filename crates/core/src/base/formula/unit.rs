//! Units of measurement as people write them: `mm/min`, `1/min`, `N/mm^2`, `µm`, `N mm`, or nothing.

use std::fmt;

use crate::base::language::tr;
use crate::base::math;

/// Base quantities: length, mass, time, temperature, current, Brinell hardness; last the logarithm of the
/// factor to the base units m, kg, s, K, A, HB.
pub(super) const QUANTITIES: usize = 7;
const FACTOR: usize = QUANTITIES - 1;
const BASE: [&str; FACTOR] = ["m", "kg", "s", "K", "A", "HB"];

/// A unit as powers of the base quantities, with its factor: multiplication adds, a power multiplies.
pub(super) type Powers = [f64; QUANTITIES];

/// Symbol, factor to base units, powers of length, mass, time, temperature, current, hardness; whether it
/// takes prefixes.
const SYMBOLS: [(&str, f64, [i8; FACTOR], bool); 25] = [
    ("m", 1.0, [1, 0, 0, 0, 0, 0], true),
    ("g", 1e-3, [0, 1, 0, 0, 0, 0], true),
    ("s", 1.0, [0, 0, 1, 0, 0, 0], true),
    ("min", 60.0, [0, 0, 1, 0, 0, 0], false),
    ("h", 3600.0, [0, 0, 1, 0, 0, 0], false),
    ("K", 1.0, [0, 0, 0, 1, 0, 0], true),
    ("A", 1.0, [0, 0, 0, 0, 1, 0], true),
    ("V", 1.0, [2, 1, -3, 0, -1, 0], true),
    ("HB", 1.0, [0, 0, 0, 0, 0, 1], false),
    ("N", 1.0, [1, 1, -2, 0, 0, 0], true),
    ("Pa", 1.0, [-1, 1, -2, 0, 0, 0], true),
    ("bar", 1e5, [-1, 1, -2, 0, 0, 0], false),
    ("J", 1.0, [2, 1, -2, 0, 0, 0], true),
    ("W", 1.0, [2, 1, -3, 0, 0, 0], true),
    ("Hz", 1.0, [0, 0, -1, 0, 0, 0], true),
    ("rpm", 1.0 / 60.0, [0, 0, -1, 0, 0, 0], false),
    ("L", 1e-3, [3, 0, 0, 0, 0, 0], true),
    ("l", 1e-3, [3, 0, 0, 0, 0, 0], true),
    ("t", 1e3, [0, 1, 0, 0, 0, 0], false),
    ("in", 0.0254, [1, 0, 0, 0, 0, 0], false),
    ("rad", 1.0, [0; FACTOR], false),
    ("deg", math::PI / 180.0, [0; FACTOR], false),
    ("°", math::PI / 180.0, [0; FACTOR], false),
    ("%", 0.01, [0; FACTOR], false),
    ("rev", 1.0, [0; FACTOR], false),
];

const PREFIXES: [(char, f64); 11] = [
    ('n', 1e-9),
    ('u', 1e-6),
    ('µ', 1e-6),
    ('μ', 1e-6),
    ('m', 1e-3),
    ('c', 1e-2),
    ('d', 1e-1),
    ('h', 1e2),
    ('k', 1e3),
    ('M', 1e6),
    ('G', 1e9),
];

/// A unit of measurement.
#[derive(Clone, Debug, PartialEq)]
pub struct Unit {
    text: String,
    pub(super) powers: Powers,
    /// The symbols it was written with.
    pub(super) symbols: Vec<(String, Powers)>,
}

/// As it was written.
impl fmt::Display for Unit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

impl Unit {
    /// The unit of a ratio: nothing, or `1`.
    #[must_use]
    pub fn none() -> Self {
        Self { text: String::new(), powers: [0.0; QUANTITIES], symbols: Vec::new() }
    }

    /// Reads a unit: symbols with prefixes, joined by a space, `*` or `·`; what stands behind a `/` is divided
    /// by, up to the next one of these; `^2`, `^-1`, `²`, `³` and `mm2` are powers.
    ///
    /// ```
    /// use steadycut_core::base::formula::Unit;
    ///
    /// assert!(Unit::parse("N/mm^2").unwrap().is_same(&Unit::parse("MPa").unwrap()));
    /// assert!(!Unit::parse("um").unwrap().is_same(&Unit::parse("mm").unwrap()));
    /// assert!(Unit::parse("furlong").unwrap_err().contains("`furlong`"));
    /// ```
    ///
    /// # Errors
    /// Names the part that is no unit, and those that are known.
    pub fn parse(text: &str) -> Result<Self, String> {
        let text = text.trim();
        let mut unit = Self { text: text.to_owned(), ..Self::none() };
        let mut sign = 1.0;
        let mut rest = text;
        while !rest.is_empty() {
            let end = rest.find([' ', '*', '·', '/']).unwrap_or(rest.len());
            if end > 0 {
                let (powers, symbol) = factor(&rest[..end])?;
                unit.powers = plus(unit.powers, powers, sign);
                unit.symbols.extend(symbol);
                sign = 1.0;
            }
            if rest[end..].starts_with('/') {
                if rest.len() == end + 1 {
                    return Err(tr!("the unit `{unit}` ends with `/`", unit = text));
                }
                sign = -1.0;
            }
            rest = rest[end..].trim_start_matches([' ', '*', '·']);
            rest = rest.strip_prefix('/').unwrap_or(rest).trim_start();
        }
        Ok(unit)
    }

    /// Whether both measure the same in the same size.
    #[must_use]
    pub fn is_same(&self, other: &Self) -> bool {
        is_none(plus(self.powers, other.powers, -1.0))
    }
}

/// a + factor b.
pub(super) fn plus(a: Powers, b: Powers, factor: f64) -> Powers {
    std::array::from_fn(|i| a[i] + factor * b[i])
}

/// Whether it is the unit of a plain number, but for rounding.
pub(super) fn is_none(powers: Powers) -> bool {
    powers.iter().all(|power| power.abs() < 1e-9)
}

/// One symbol with prefix and power; no symbol for `1`.
fn factor(text: &str) -> Result<(Powers, Option<(String, Powers)>), String> {
    if text == "1" {
        return Ok(([0.0; QUANTITIES], None));
    }
    let marks = |c: char| c == '^' || c.is_ascii_digit() || "-⁻²³".contains(c);
    let end = text.find(marks).unwrap_or(text.len());
    let (symbol, power) = text.split_at(end);
    let power = match power.strip_prefix('^').unwrap_or(power) {
        "" => Ok(1.0),
        "²" => Ok(2.0),
        "³" => Ok(3.0),
        power => power.parse::<f64>(),
    };
    let power = power.ok().filter(|power| power.abs() <= 100.0);
    let Some(power) = power else {
        return Err(tr!("`{unit}` is no unit: a power is a number, as in mm^2", unit = text));
    };
    let powers = symbol_powers(symbol).ok_or_else(|| {
        let known: Vec<&str> = SYMBOLS.iter().map(|(symbol, ..)| *symbol).collect();
        tr!("`{unit}` is no unit: known are {known}", unit = symbol, known = known.join(", "))
    })?;
    let symbol = (symbol.to_owned(), powers);
    Ok((plus([0.0; QUANTITIES], powers, power), Some(symbol)))
}

fn symbol_powers(text: &str) -> Option<Powers> {
    let find = |text: &str| SYMBOLS.iter().find(|(symbol, ..)| *symbol == text);
    let (entry, prefix) = match find(text) {
        Some(entry) => (entry, 1.0),
        None => {
            let first = text.chars().next()?;
            let (_, prefix) = PREFIXES.iter().find(|(prefix, _)| *prefix == first)?;
            (find(&text[first.len_utf8()..]).filter(|entry| entry.3)?, *prefix)
        }
    };
    let (_, factor, quantities, _) = entry;
    let mut powers = [0.0; QUANTITIES];
    for (power, quantity) in powers.iter_mut().zip(quantities) {
        *power = f64::from(*quantity);
    }
    powers[FACTOR] = math::ln(factor * prefix);
    Some(powers)
}

/// The text of a unit in the given symbols, as far as they reach; otherwise in base units with a factor.
pub(super) fn text(powers: Powers, symbols: &[(String, Powers)]) -> String {
    if is_none(powers) {
        return "1".to_owned();
    }
    if let Some(exponents) = in_symbols(powers, symbols, QUANTITIES) {
        return join(1.0, symbols.iter().map(|(symbol, _)| symbol.as_str()).zip(exponents));
    }
    if let Some(exponents) = in_symbols(powers, symbols, FACTOR) {
        let size: f64 = exponents.iter().zip(symbols).map(|(x, (_, p))| x * p[FACTOR]).sum();
        let factor = math::exp(powers[FACTOR] - size);
        return join(factor, symbols.iter().map(|(symbol, _)| symbol.as_str()).zip(exponents));
    }
    join(math::exp(powers[FACTOR]), BASE.into_iter().zip(powers))
}

fn join<'a>(factor: f64, parts: impl Iterator<Item = (&'a str, f64)> + Clone) -> String {
    let shown = |power: f64| {
        let rounded = (power * 1e6).round() / 1e6;
        if rounded == 1.0 { String::new() } else { format!("^{rounded}") }
    };
    let list = |sign: f64| {
        let parts = parts.clone().filter(move |(_, power)| power * sign > 1e-9);
        parts.map(|(symbol, power)| format!("{symbol}{}", shown(power * sign))).collect::<Vec<_>>()
    };
    let (above, below) = (list(1.0), list(-1.0));
    let mut words = Vec::new();
    if (factor - 1.0).abs() > 1e-9 {
        words.push(short(factor));
    }
    words.extend(above);
    if words.is_empty() {
        words.push("1".to_owned());
    }
    let below: String = below.iter().map(|symbol| format!("/{symbol}")).collect();
    format!("{}{below}", words.join(" "))
}

/// The powers of symbols that make up the first `rows` of a unit, by elimination: of symbols that the earlier
/// ones make up, none is used.
fn in_symbols(target: Powers, symbols: &[(String, Powers)], rows: usize) -> Option<Vec<f64>> {
    let mut used: Vec<usize> = Vec::new();
    // Rows of [columns of the used symbols | target], reduced as symbols are added.
    let mut reduced: Vec<(usize, Powers)> = Vec::new();
    for (index, (_, powers)) in symbols.iter().enumerate() {
        let mut column = *powers;
        for (pivot, earlier) in &reduced {
            let factor = column[*pivot] / earlier[*pivot];
            column = plus(column, *earlier, -factor);
        }
        let pivot = (0..rows).max_by(|a, b| column[*a].abs().total_cmp(&column[*b].abs()))?;
        if column[pivot].abs() > 1e-9 {
            reduced.push((pivot, column));
            used.push(index);
        }
    }
    // Each reduced column is a symbol less some of the earlier ones: solve from the last to the first.
    let mut exponents = vec![0.0; symbols.len()];
    let mut amounts = vec![0.0; reduced.len()];
    let mut rest = target;
    for (place, (pivot, column)) in reduced.iter().enumerate() {
        amounts[place] = rest[*pivot] / column[*pivot];
        rest = plus(rest, *column, -amounts[place]);
    }
    if rest[..rows].iter().any(|x| x.abs() > 1e-9) {
        return None;
    }
    for place in (0..reduced.len()).rev() {
        let index = used[place];
        exponents[index] = amounts[place];
        // What the reduction took from this symbol's column goes back to the earlier ones.
        let mut column = symbols[index].1;
        for earlier in 0..place {
            let (pivot, vector) = reduced[earlier];
            let factor = column[pivot] / vector[pivot];
            column = plus(column, vector, -factor);
            amounts[earlier] -= factor * amounts[place];
        }
    }
    Some(exponents)
}

/// A factor with at most nine digits.
fn short(x: f64) -> String {
    let rounded = format!("{x:.8e}").parse().unwrap_or(x);
    super::text::number(rounded)
}
