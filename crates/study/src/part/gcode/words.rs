//! The words of a line of G-code (RS-274, ISO 6983-1): a letter and a number.

use crate::base::language::tr;

/// A letter with its number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Word {
    /// The letter, large.
    pub(super) letter: char,
    /// The number.
    pub(super) value: f64,
}

impl Word {
    /// The word as it is written, without zeros that say nothing.
    pub(super) fn text(self) -> String {
        format!("{}{}", self.letter, self.value)
    }

    /// Its number in tenths, as G-codes are told apart (G90.1); none where it has more digits.
    pub(super) fn tenths(self) -> Option<i64> {
        let tenths = self.value * 10.0;
        (tenths.fract().abs() < 1e-9 && tenths.abs() < 1e6).then(|| tenths.round() as i64)
    }
}

/// The line without comments, in brackets or behind a semicolon.
fn code(line: &str) -> Result<String, String> {
    let (mut code, mut rest) = (String::new(), line);
    while let Some(at) = rest.find(['(', ';']) {
        code.push_str(&rest[..at]);
        if rest[at..].starts_with(';') {
            return Ok(code);
        }
        let end = rest[at..].find(')').ok_or_else(|| tr("a comment has no end").to_owned())?;
        rest = &rest[at + end + 1..];
    }
    code.push_str(rest);
    Ok(code)
}

/// The words of a line.
pub(super) fn words(line: &str) -> Result<Vec<Word>, String> {
    let code = code(line)?;
    let code = code.trim();
    // The mark at both ends of a tape.
    if code.is_empty() || code.starts_with('%') {
        return Ok(Vec::new());
    }
    let mut words = Vec::new();
    let mut letters = code.char_indices().filter(|(_, c)| !c.is_whitespace()).peekable();
    while let Some((_, letter)) = letters.next() {
        if !letter.is_ascii_alphabetic() {
            return Err(tr!(
                "`{code}`: `{sign}` is no letter of a word; variables, expressions, block skips and O-words are not \
                 followed",
                code = code.chars().take(40).collect::<String>(),
                sign = letter
            ));
        }
        let mut number = String::new();
        while let Some((_, c)) = letters.next_if(|(_, c)| c.is_ascii_digit() || "+-.".contains(*c))
        {
            number.push(c);
        }
        let value = number.parse::<f64>().ok().filter(|value| value.is_finite());
        let value = value.ok_or_else(|| {
            tr!(
                "`{letter}` is followed by `{number}`: allowed is a number",
                letter = letter,
                number = number
            )
        })?;
        words.push(Word { letter: letter.to_ascii_uppercase(), value: value + 0.0 });
    }
    Ok(words)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(line: &str) -> Vec<String> {
        words(line).unwrap().into_iter().map(Word::text).collect()
    }

    #[test]
    fn words_are_read_with_and_without_spaces_and_comments() {
        assert_eq!(
            read("N10 G01X-1.50 y.5(in the air)Z 2 ; done G0"),
            ["N10", "G1", "X-1.5", "Y0.5", "Z2"]
        );
        assert_eq!(read("g90.1 f+300."), ["G90.1", "F300"]);
        for none in ["", "%", "% 1001", "(all of it)", "; G1 X1"] {
            assert!(read(none).is_empty(), "{none}");
        }
    }

    #[test]
    fn what_is_no_word_is_refused() {
        for (line, named) in [
            ("G1 X", "X"),
            ("G1 X1.2.3", "1.2.3"),
            ("#1=5", "#"),
            ("/G1 X1", "/"),
            ("G1 X[1+2]", "X"),
            ("G1 (no end", "comment"),
            ("G1 X1e5", "E"),
            ("G1 X--1", "--1"),
        ] {
            match words(line) {
                Err(error) => assert!(error.contains(named), "{line}: {error}"),
                // E is a letter like any other here; the reader of the program refuses the axis.
                Ok(words) => {
                    assert!(words.iter().any(|word| word.letter == 'E'), "{line}: {words:?}")
                }
            }
        }
    }
}
