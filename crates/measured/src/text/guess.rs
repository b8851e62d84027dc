//! What separates the values of a text, which decimal sign it has, and where its values begin: what most lines of the
//! file are numbers with. What a person says is taken as it is.

use std::cmp::Reverse;
use std::collections::BTreeMap;

use super::cells::cells;
use super::clock::clock;
use super::number::number;
use crate::layout::{DataLayout, DecimalMark, FieldSeparator, ThousandsMark};

/// Lines from the start in which values must begin.
pub(super) const HEAD_LINES: usize = 5000;
/// Lines that are tried at the start, at the end of the head, and spread over the rest of the file.
const TRIED: usize = 60;
const SPREAD: usize = 200;
/// Most bytes of lines that are tried in every way.
const MAX_TRIED: usize = 1_000_000;
/// Lines behind the first with values that must have values, too.
const SURE: usize = 3;

/// How the values of a text are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Writing {
    pub separator: FieldSeparator,
    pub decimal: DecimalMark,
    pub thousands: ThousandsMark,
}

/// What stands in a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Holds {
    /// Numbers.
    Numbers,
    /// Times of day or dates.
    Clock,
    /// Something else, which is not read.
    Words,
}

/// What was guessed of a text.
#[derive(Clone, Debug)]
pub(super) struct Guess {
    pub writing: Writing,
    /// Columns.
    pub columns: usize,
    /// Index of the first line with values.
    pub first: usize,
    /// What stands in the columns.
    pub holds: Vec<Holds>,
    /// The other way in which the values may be meant, if there is one.
    pub doubt: Option<Writing>,
}

/// A line's cells: how many, how many of them with something, with numbers.
#[derive(Clone, Copy, Debug)]
struct Counted {
    cells: usize,
    filled: usize,
    numbers: usize,
    /// With times of day or dates.
    times: usize,
}

impl Writing {
    /// All that can be meant, the most usual first.
    fn all(said: &DataLayout) -> Vec<Self> {
        use FieldSeparator as S;
        use {DecimalMark as D, ThousandsMark as T};
        let mut all = Vec::new();
        for thousands in [T::None, T::Point, T::Comma, T::Blank, T::Apostrophe] {
            for separator in [S::Tab, S::Semicolon, S::Comma, S::Blank] {
                for decimal in [D::Point, D::Comma] {
                    let same = [(D::Point, T::Point), (D::Comma, T::Comma)];
                    let fits = said.separator.is_none_or(|x| x == separator)
                        && said.decimal.is_none_or(|x| x == decimal)
                        && said.thousands.is_none_or(|x| x == thousands)
                        && !same.contains(&(decimal, thousands))
                        && (separator, thousands) != (S::Blank, T::Blank);
                    if fits {
                        all.push(Self { separator, decimal, thousands });
                    }
                }
            }
        }
        all
    }

    /// Whether a comma both separates and is the decimal sign.
    pub fn is_one_sign(self) -> bool {
        (self.separator, self.decimal) == (FieldSeparator::Comma, DecimalMark::Comma)
    }

    /// The cell's number, as this is meant.
    pub fn number(self, cell: &str) -> Option<f64> {
        number(cell, self.decimal, self.thousands)
    }

    fn counted(self, line: &str) -> Counted {
        // Blanks beside stronger separators separate nothing.
        if self.separator == FieldSeparator::Blank
            && line.contains(['\t', ';'])
            && !line.trim().is_empty()
        {
            let tabs_alone = !line.contains(';') && line.contains("  ");
            if !tabs_alone {
                return Counted { cells: 0, filled: 1, numbers: 0, times: 0 };
            }
        }
        // Decimal commas between separating ones stand in quotes.
        let unquoted = self.is_one_sign() && !line.contains('"');
        if unquoted && line.contains(',') {
            return Counted { cells: 0, filled: 1, numbers: 0, times: 0 };
        }
        let cells = cells(line, self.separator);
        let filled = cells.iter().filter(|cell| !cell.is_empty());
        let numbers = filled.clone().filter(|cell| self.number(cell).is_some()).count();
        let times = filled.clone().filter(|cell| clock(cell).is_some()).count();
        Counted { cells: cells.len(), filled: filled.count(), numbers, times }
    }
}

impl Counted {
    /// Whether the line has values: nothing but numbers; or numbers, and with times as many as words.
    fn has_values(self, strict: bool) -> bool {
        match strict {
            true => self.numbers > 0 && self.numbers == self.filled,
            false => self.numbers > 0 && 2 * (self.numbers + self.times) >= self.filled,
        }
    }

    /// Whether it has so many cells, or empty ones more.
    fn fits(self, columns: usize) -> bool {
        self.cells == columns
    }
}

/// Lines of the whole text, evenly spread, whole ones only.
fn spread(text: &str) -> Vec<&str> {
    let mut found = Vec::new();
    for part in 1..=SPREAD {
        let from = text.floor_char_boundary(text.len() / (SPREAD + 1) * part);
        let Some(start) = text[from..].find('\n') else { continue };
        let rest = &text[from + start + 1..];
        if let Some(end) = rest.find('\n') {
            found.push(&rest[..end]);
        }
    }
    found
}

/// Guesses what a text's values are written with; `head` are its first lines, of which those before `from` are known to
/// have no values.
pub(super) fn guess(text: &str, head: &[&str], from: usize, said: &DataLayout) -> Option<Guess> {
    let behind = head.get(from..)?;
    let mut tried: Vec<&str> = behind.iter().take(TRIED).copied().collect();
    tried.extend(behind.iter().skip(TRIED).rev().take(TRIED));
    if behind.len() > 2 * TRIED {
        tried.extend(spread(text));
    }
    let mut left = MAX_TRIED;
    tried.retain(|line| {
        let taken = !line.trim().is_empty() && line.len() <= left;
        left -= if taken { line.len() } else { 0 };
        taken
    });
    // The lines near the start, which tell whether names stand above.
    let mut room = MAX_TRIED;
    let near = head.iter().take_while(|line| {
        let fits = line.len() <= room;
        room = room.saturating_sub(line.len());
        fits
    });
    let near = &head[..near.count().max(from.min(head.len()))];
    let strict = best(&tried, near, from, said, true);
    // Few lines of numbers alone are what is meant only where the text ends with one.
    let last: Vec<&str> =
        text.lines().rev().filter(|line| !line.trim().is_empty()).take(2).collect();
    let meant = |found: &Best| {
        let is = |line: &&str| {
            let counted = found.writing.counted(line);
            counted.fits(found.columns) && counted.has_values(true)
        };
        found.lines * 10 >= tried.len() || last.iter().any(is)
    };
    match strict {
        Some(found) if meant(&found) => Some(finished(&found, &tried, head, from, true)?),
        strict => match best(&tried, near, from, said, false) {
            Some(found) => finished(&found, &tried, head, from, false),
            None => finished(&strict?, &tried, head, from, true),
        },
    }
}

/// A way in which most lines have values.
#[derive(Clone, Debug)]
struct Best {
    writing: Writing,
    lines: usize,
    columns: usize,
    doubt: Option<Writing>,
}

fn best(
    tried: &[&str],
    head: &[&str],
    from: usize,
    said: &DataLayout,
    strict: bool,
) -> Option<Best> {
    let mut ways = Vec::new();
    for (order, writing) in Writing::all(said).into_iter().enumerate() {
        // Lines and numbers by the number of cells.
        let mut by_columns: BTreeMap<usize, [usize; 2]> = BTreeMap::new();
        for counted in tried.iter().map(|line| writing.counted(line)) {
            if counted.has_values(strict) {
                let [lines, numbers] = by_columns.entry(counted.cells).or_default();
                (*lines, *numbers) = (*lines + 1, *numbers + counted.numbers);
            }
        }
        let most = by_columns.into_iter().max_by_key(|(_, [lines, _])| *lines);
        let Some((columns, [lines, numbers])) = most else { continue };
        let header = first_line(writing, columns, head, from, strict).is_some_and(|first| {
            above(head, first).is_some_and(|line| names_fit(line, writing, columns))
        });
        ways.push(((lines, header, columns, numbers, Reverse(order)), writing));
    }
    ways.sort_by_key(|(rank, _)| Reverse(*rank));
    let ((lines, header, columns, ..), writing) = *ways.first()?;
    // A comma between digits alone is both a separator and a decimal sign.
    let doubt = ways.iter().skip(1).find(|((others, other_header, other_columns, ..), other)| {
        *others == lines
            && *other_header == header
            && other.decimal != writing.decimal
            && *other_columns != columns
    });
    Some(Best { writing, lines, columns, doubt: doubt.map(|(_, writing)| *writing) })
}

/// Whether a line has as many cells as there are columns, and no numbers: the names.
fn names_fit(line: &str, writing: Writing, columns: usize) -> bool {
    let counted = writing.counted(line);
    counted.fits(columns) && counted.numbers == 0
}

/// The last line with something in it above another.
fn above<'a>(head: &[&'a str], index: usize) -> Option<&'a str> {
    head[..index].iter().rev().find(|line| !line.trim().is_empty()).copied()
}

/// Index of the first line with values: those behind it must have values, too.
fn first_line(
    writing: Writing,
    columns: usize,
    head: &[&str],
    from: usize,
    strict: bool,
) -> Option<usize> {
    let is = |line: &str| {
        let counted = writing.counted(line);
        counted.fits(columns) && counted.has_values(strict)
    };
    let filled = |index: &usize| !head[*index].trim().is_empty();
    let lines: Vec<usize> = (from..head.len()).filter(filled).collect();
    // Looked at only as far as they are asked for.
    let mut has_values: Vec<bool> = Vec::new();
    let sure = (0..lines.len()).find(|place| {
        let asked = (place + SURE + 1).min(lines.len());
        for line in has_values.len()..asked {
            has_values.push(is(head[lines[line]]));
        }
        has_values[*place..asked].iter().all(|x| *x)
    });
    let mut place = sure.or_else(|| has_values.iter().position(|x| *x))?;
    // Lines above that are mostly numbers hold no names: they are values with one that is spoilt, which is told.
    for before in (0..place).rev() {
        let line = head[lines[before]];
        let counted = writing.counted(line);
        if counted.numbers == 0 || 2 * counted.numbers < counted.filled {
            break;
        }
        let most = 2 * counted.numbers > counted.filled
            || cells(line, writing.separator)
                .first()
                .is_some_and(|cell| writing.number(cell).is_some());
        if counted.fits(columns) && most {
            place = before;
        }
    }
    Some(lines[place])
}

fn finished(
    found: &Best,
    tried: &[&str],
    head: &[&str],
    from: usize,
    strict: bool,
) -> Option<Guess> {
    let Best { writing, columns, doubt, .. } = *found;
    let first = first_line(writing, columns, head, from, strict)?;
    let mut holds = vec![Holds::Numbers; columns];
    if !strict {
        // Numbers, times and words of every column.
        let mut seen = vec![[0_usize; 3]; columns];
        for line in tried {
            let counted = writing.counted(line);
            if !counted.fits(columns) || !counted.has_values(false) {
                continue;
            }
            for (seen, cell) in seen.iter_mut().zip(cells(line, writing.separator)) {
                let kind = match (cell.is_empty(), writing.number(cell), clock(cell)) {
                    (true, _, _) => continue,
                    (false, Some(_), _) => 0,
                    (false, None, Some(_)) => 1,
                    (false, None, None) => 2,
                };
                seen[kind] += 1;
            }
        }
        for (holds, [numbers, times, words]) in holds.iter_mut().zip(seen) {
            *holds = match () {
                () if words > numbers && words >= times => Holds::Words,
                () if times > numbers => Holds::Clock,
                () => Holds::Numbers,
            };
        }
    }
    Some(Guess { writing, columns, first, holds, doubt })
}
