//! The English texts of the program as keys: the words with the names of their values.

/// How a value is written, after the colon of its place.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Spec {
    digits: Option<usize>,
    signed: bool,
}

impl Spec {
    /// `.1`, `+.1` or nothing; other forms count as nothing.
    fn read(text: &str) -> Self {
        let (signed, rest) = match text.strip_prefix('+') {
            Some(rest) => (true, rest),
            None => (false, text),
        };
        let digits = rest.strip_prefix('.').and_then(|digits| digits.parse().ok());
        Self { digits, signed }
    }

    pub(super) fn number(self, value: f64) -> String {
        match (self.digits, self.signed) {
            (Some(digits), true) => format!("{value:+.digits$}"),
            (Some(digits), false) => format!("{value:.digits$}"),
            (None, true) => format!("{value:+}"),
            (None, false) => format!("{value}"),
        }
    }
}

/// The parts of a text of [`format!`]: words, and places with their names.
enum Part<'a> {
    Words(&'a str),
    Brace(&'static str),
    Place { name: &'a str, spec: Spec },
}

fn parts(text: &str) -> Vec<Part<'_>> {
    let mut parts = Vec::new();
    let mut rest = text;
    while let Some(at) = rest.find(['{', '}']) {
        if at > 0 {
            parts.push(Part::Words(&rest[..at]));
        }
        let brace = &rest[at..];
        rest = if let Some(after) = brace.strip_prefix("{{") {
            parts.push(Part::Brace("{"));
            after
        } else if let Some(after) = brace.strip_prefix("}}") {
            parts.push(Part::Brace("}"));
            after
        } else {
            let Some(end) = brace.find('}').filter(|end| *end > 0) else {
                parts.push(Part::Words(brace));
                return parts;
            };
            let place = &brace[1..end];
            let (name, spec) = place.split_once(':').unwrap_or((place, ""));
            parts.push(Part::Place { name, spec: Spec::read(spec) });
            &brace[end + 1..]
        };
    }
    if !rest.is_empty() {
        parts.push(Part::Words(rest));
    }
    parts
}

/// A text with values as catalogues are searched by it: places by their names alone (`{share}`).
#[must_use]
pub fn plain_words(text: &str) -> String {
    let mut plain = String::with_capacity(text.len());
    for part in parts(text) {
        match part {
            Part::Words(words) => plain.push_str(words),
            Part::Brace(brace) => plain.push_str(brace),
            Part::Place { name, .. } => {
                plain.push('{');
                plain.push_str(name);
                plain.push('}');
            }
        }
    }
    plain
}

/// Names of the values that a text has places for.
#[must_use]
pub fn placeholders(text: &str) -> Vec<&str> {
    specs(text).into_iter().map(|(name, _)| name).collect()
}

/// How a text writes its values, by their names, in the order of their places.
pub(super) fn specs(text: &str) -> Vec<(&str, Spec)> {
    let places = parts(text).into_iter().filter_map(|part| match part {
        Part::Place { name, spec } => Some((name, spec)),
        Part::Words(_) | Part::Brace(_) => None,
    });
    places.collect()
}
