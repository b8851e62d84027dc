//! What stands above the values: names and units of the columns, the sample rate, and what else a program says of a
//! measurement.

use super::cells::{bare, cells};
use super::guess::Writing;
use crate::base::column_unit;
use crate::layout::FieldSeparator;

/// Longest unit in square brackets, characters.
const MAX_UNIT: usize = 16;
/// Most lines of the head that are kept as facts, and the longest of them, characters.
const MAX_FACTS: usize = 60;
const MAX_FACT: usize = 200;

/// The cells of a line of the head, as many as there are columns. A sign of a comment at its start is left out, and so
/// are cells that no column has.
pub(super) fn header(line: &str, writing: Writing, columns: usize) -> Option<Vec<String>> {
    let line = line.trim_start_matches(['#', '%']);
    let of = |separator: FieldSeparator| {
        let mut found: Vec<String> =
            cells(line, separator).into_iter().map(str::to_owned).collect();
        while found.len() > columns && found.last().is_some_and(String::is_empty) {
            found.pop();
        }
        found
    };
    let fits =
        |found: &Vec<String>| found.len() == columns && found.iter().any(|cell| !cell.is_empty());
    let own = of(writing.separator);
    if fits(&own) {
        return Some(own);
    }
    // Names behind the last column, as of a comment that no line has.
    let more = own.len() > columns && own[..columns].iter().all(|name| !name.is_empty());
    if more && writing.separator != FieldSeparator::Blank {
        return Some(own[..columns].to_vec());
    }
    if writing.separator == FieldSeparator::Blank {
        let wide: Vec<String> = line
            .split("  ")
            .flat_map(|part| part.split('\t'))
            .map(|part| bare(part).to_owned())
            .filter(|part| !part.is_empty())
            .collect();
        if fits(&wide) {
            return Some(wide);
        }
        // `Time [s] Fx [N]`: a unit belongs to the name before it.
        let mut joined: Vec<String> = Vec::new();
        for part in own {
            match joined.last_mut() {
                Some(name) if bracketed(&part).is_some() => *name = format!("{name} {part}"),
                Some(_) | None => joined.push(part),
            }
        }
        if fits(&joined) {
            return Some(joined);
        }
    }
    let others = FieldSeparator::ALL.iter().filter(|other| **other != FieldSeparator::Blank);
    others.map(|other| of(*other)).find(fits).filter(|_| columns > 1)
}

/// What stands in brackets, if that is all.
fn bracketed(cell: &str) -> Option<&str> {
    let inside = [('[', ']'), ('(', ')'), ('{', '}'), ('<', '>')]
        .into_iter()
        .find_map(|(open, close)| cell.strip_prefix(open)?.strip_suffix(close))?;
    (inside.chars().count() <= MAX_UNIT && !inside.contains(['[', ']', '(', ')']))
        .then(|| inside.trim())
}

/// The units in a line of the head, if it has units and nothing else.
pub(super) fn units(cells: &[String]) -> Option<Vec<String>> {
    let unit = |cell: &String| match bracketed(cell) {
        Some(inside) => Some(inside.to_owned()),
        None if cell.is_empty() || ["-", "1", "%", "counts"].contains(&cell.as_str()) => {
            Some(cell.clone())
        }
        None => column_unit::spelled(cell).map(|_| cell.clone()),
    };
    let filled = cells.iter().any(|cell| !cell.is_empty() && cell.parse::<f64>().is_err());
    cells.iter().map(unit).collect::<Option<Vec<String>>>().filter(|_| filled)
}

/// A column's name and unit: `Fx [N]`, `Fx (N)`, `Fx / N`, `Fx_N`.
pub(super) fn named(title: &str) -> (String, String) {
    let title = title.trim();
    if let Some((name, unit)) = column_unit::parted(title) {
        return (name.to_owned(), unit.to_owned());
    }
    // In square brackets stand units that are not known here, too.
    let in_square = title.strip_suffix(']').and_then(|title| title.rsplit_once('['));
    if let Some((name, unit)) = in_square
        && !name.trim().is_empty()
        && unit.chars().count() <= MAX_UNIT
    {
        return (name.trim().to_owned(), unit.trim().to_owned());
    }
    let name = column_unit::without_unit(title);
    match column_unit::by_name(title) {
        // Behind a name of one or two letters, as `F_n`, a small letter is more likely an index.
        Some(unit)
            if name != title
                && (name.chars().count() > 2 || title.ends_with(&unit.to_string())) =>
        {
            (name.to_owned(), unit.to_string())
        }
        Some(_) | None => (title.to_owned(), String::new()),
    }
}

/// A line of the head as a name and what it says.
fn fact(line: &str) -> Option<(String, String)> {
    let line = line.trim().trim_start_matches(['#', '%', '*']).trim();
    let at = line.find(['\t', ';', ':', '=', ','])?;
    let name = bare(&line[..at]).trim_end_matches([':', '=']).trim().to_owned();
    let value = line[at + 1..].trim_matches(['\t', ';', ':', '=', ',', ' ', '"']).to_owned();
    let short = |text: String| text.chars().take(MAX_FACT).collect::<String>();
    (!name.is_empty() && !value.is_empty()).then(|| (short(name), short(value)))
}

/// What the head says, line by line.
pub(super) fn facts(head: &[&str]) -> Vec<(String, String)> {
    head.iter().filter_map(|line| fact(line)).take(MAX_FACTS).collect()
}

/// Samples in a second, if the head tells them.
pub(super) fn rate_hz(facts: &[(String, String)]) -> Option<f64> {
    facts.iter().find_map(|(name, value)| {
        let name = name.to_lowercase();
        let first = value.split(['\t', ';', ' ']).find(|part| !part.is_empty())?;
        let number: f64 = first.replace(',', ".").parse().ok()?;
        let about = |words: &[&str]| words.iter().any(|word| name.contains(word));
        let sampling = about(&["sampl", "scan", "abtast", "vzor", "acqui", "messrate"]);
        let text = format!("{name} {}", value.to_lowercase());
        let rate = match () {
            () if sampling && about(&["rate", "freq", "frek"]) => match text.contains("khz") {
                true => number * 1000.0,
                false => number,
            },
            () if name == "delta_x"
                || sampling && about(&["interval", "period", "time", "zeit"]) =>
            {
                1.0 / if text.contains("ms") { number / 1000.0 } else { number }
            }
            () => return None,
        };
        Some(rate).filter(|rate| rate.is_finite() && *rate > 0.0)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_stand_behind_names_in_many_ways() {
        for (title, name, unit) in [
            ("Fx [N]", "Fx", "N"),
            ("Fx (N)", "Fx", "N"),
            ("Fx_N", "Fx", "N"),
            ("Fx / N", "Fx", "N"),
            ("time_s", "time", "s"),
            ("acc [g_n]", "acc", "g_n"),
            ("F_n", "F_n", ""),
            ("Fx", "Fx", ""),
            ("Force (mean)", "Force (mean)", ""),
            ("[N]", "[N]", ""),
        ] {
            assert_eq!(named(title), (name.to_owned(), unit.to_owned()), "{title}");
        }
    }

    #[test]
    fn a_line_of_units_has_nothing_else() {
        let of = |cells: &[&str]| units(&cells.iter().map(|x| (*x).to_owned()).collect::<Vec<_>>());
        assert_eq!(
            of(&["[s]", "(N)", "V", ""]),
            Some(["s", "N", "V", ""].map(str::to_owned).to_vec())
        );
        for cells in [&["Zeit", "Fx"][..], &["s", "Fx"], &["", ""], &["1", "2"]] {
            assert_eq!(of(cells), None, "{cells:?}");
        }
    }

    #[test]
    fn the_sample_rate_is_found_in_the_head() {
        for (line, rate) in [
            ("Sampling rate [Hz]:\t25000", Some(25_000.0)),
            ("Abtastrate;25,6 kHz", Some(25_600.0)),
            ("Delta_X\t0.00004\t0.00004", Some(25_000.0)),
            ("Sample interval (ms): 0.04", Some(25_000.0)),
            ("Spindle rate: 5", None),
            ("Sampling rate: unknown", None),
            ("Sampling rate: 0", None),
        ] {
            let told = rate_hz(&facts(&[line]));
            assert!(told.map(|x| x.round()) == rate, "{line}: {told:?}");
        }
    }
}
