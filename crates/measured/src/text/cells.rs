//! A line as cells.

use crate::layout::FieldSeparator;

/// Most columns that a text may have.
pub(super) const MAX_COLUMNS: usize = 10_000;

/// Where the cell that begins here ends, and where the next one begins; none at the end of the line. Blanks before
/// `at` are taken already. A separator within quotes separates nothing.
pub(super) fn cell_end(
    line: &[u8],
    at: usize,
    separator: FieldSeparator,
) -> (usize, Option<usize>) {
    let mut end = at;
    if line.get(at) == Some(&b'"') {
        end = match line[at + 1..].iter().position(|byte| *byte == b'"') {
            Some(length) => at + 1 + length + 1,
            None => at,
        };
    }
    while line.get(end).is_some_and(|byte| !separator.is(*byte)) {
        end += 1;
    }
    if end >= line.len() {
        return (end, None);
    }
    let mut next = end + 1;
    if separator == FieldSeparator::Blank {
        next += line[next..].iter().take_while(|byte| separator.is(**byte)).count();
        // Blanks at the end of a line are no separator.
        if next >= line.len() {
            return (end, None);
        }
    }
    (end, Some(next))
}

/// A cell without blanks around it and without its quotes.
pub(super) fn bare(cell: &str) -> &str {
    let cell = cell.trim();
    cell.strip_prefix('"').and_then(|cell| cell.strip_suffix('"')).map_or(cell, str::trim)
}

/// The cells of a line; more than [`MAX_COLUMNS`] by one at most.
pub(super) fn cells(line: &str, separator: FieldSeparator) -> Vec<&str> {
    let line = line.trim_end_matches(['\r', '\n']);
    let line = if separator == FieldSeparator::Blank { line.trim() } else { line };
    let mut cells = Vec::new();
    let mut at = Some(0);
    while let Some(from) = at.filter(|_| cells.len() <= MAX_COLUMNS) {
        let blanks = line.as_bytes()[from..].iter().take_while(|byte| **byte == b' ').count();
        let (end, next) = cell_end(line.as_bytes(), from + blanks, separator);
        cells.push(bare(&line[from..end]));
        at = next;
    }
    cells
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_parted_and_quotes_keep_together() {
        use FieldSeparator as S;
        for (line, separator, expected) in [
            ("a;b;;c\r\n", S::Semicolon, vec!["a", "b", "", "c"]),
            ("  1   2\t3  ", S::Blank, vec!["1", "2", "3"]),
            ("\"1,5\", \"a \",x", S::Comma, vec!["1,5", "a", "x"]),
            ("1,2,", S::Comma, vec!["1", "2", ""]),
            ("\t1\t", S::Tab, vec!["", "1", ""]),
            ("", S::Tab, vec![""]),
            ("\"open,1", S::Comma, vec!["\"open", "1"]),
            ("\"é\",ü", S::Comma, vec!["é", "ü"]),
        ] {
            assert_eq!(cells(line, separator), expected, "{line}");
        }
        assert_eq!(cells(&",".repeat(20_000), S::Comma).len(), MAX_COLUMNS + 1);
    }
}
