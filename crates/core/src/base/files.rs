//! Files of structures, read and written by serde: an error names the entry by its path, its value,
//! what is allowed, and the line.

use std::io::{self, Write};

use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::error::Category;
use serde_json::ser::{Formatter, Serializer};

use crate::base::language::{text, tr};

/// serde's words for what it expected, and those of people who know no Rust.
const WORDS: [(&str, &str); 7] = [
    ("f64", text!("a number")),
    ("u32", text!("a whole number from 0 to 4294967295")),
    ("u64", text!("a whole number from 0 on")),
    ("usize", text!("a whole number from 0 on")),
    ("a sequence", text!("a list")),
    ("an array of length 3", text!("a list of 3 numbers")),
    ("a map", text!("a table")),
];

/// One of serde's messages; what it has no words for here stays as it is.
fn plain(message: &str) -> String {
    let named = |start: &str| message.strip_prefix(start)?.rsplit_once(", expected ");
    if let Some(field) = message.strip_prefix("missing field ") {
        return tr!("missing field {field}", field = field);
    }
    if let Some((field, known)) = named("unknown field ") {
        return match known.strip_prefix("one of ") {
            Some(known) => {
                tr!("unknown field {field}, expected one of {known}", field = field, known = known)
            }
            None => tr!("unknown field {field}, expected {known}", field = field, known = known),
        };
    }
    let in_words = |expected: &str| WORDS.iter().find(|(word, _)| *word == expected);
    if let Some((found, expected)) = named("invalid type: ") {
        return match in_words(expected) {
            Some((_, allowed)) => tr!(
                "invalid type: {found}, allowed is {allowed}",
                found = found,
                allowed = tr(allowed)
            ),
            None => tr!(
                "invalid type: {found}, expected {expected}",
                found = found,
                expected = expected
            ),
        };
    }
    if let Some((found, expected)) = named("invalid value: ") {
        return match in_words(expected) {
            Some((_, allowed)) => tr!(
                "invalid value: {found}, allowed is {allowed}",
                found = found,
                allowed = tr(allowed)
            ),
            None => tr!(
                "invalid value: {found}, expected {expected}",
                found = found,
                expected = expected
            ),
        };
    }
    if let Some((found, expected)) = named("invalid length ") {
        return match in_words(expected) {
            Some((_, allowed)) => tr!(
                "invalid length {found}, allowed is {allowed}",
                found = found,
                allowed = tr(allowed)
            ),
            None => tr!(
                "invalid length {found}, expected {expected}",
                found = found,
                expected = expected
            ),
        };
    }
    message.to_owned()
}

/// The text of an error at a path; `.` is the whole file.
fn explain(path: &str, message: &str) -> String {
    let message = message.trim_end();
    // JSON's messages end with their place; a value with such words in it has more behind them.
    let placed = message.rsplit_once(" at line ").and_then(|(problem, place)| {
        let (line, column) = place.split_once(" column ")?;
        let [line, column] = [line, column].map(|x| x.parse::<usize>().ok());
        Some((problem, line?, column?))
    });
    let message = match placed {
        Some((problem, line, column)) => tr!(
            "{problem} at line {line} column {column}",
            problem = plain(problem),
            line = line,
            column = column
        ),
        None => plain(message),
    };
    if path == "." { message } else { format!("`{path}`: {message}") }
}

fn not_json(error: &serde_json::Error) -> String {
    tr!("not JSON: {problem}", problem = error.to_string())
}

/// Reads a structure from the text of a JSON file.
///
/// # Errors
/// See the head of the module.
pub fn from_json<T: DeserializeOwned>(text: &str) -> Result<T, String> {
    let mut reader = serde_json::Deserializer::from_str(text);
    let found = serde_path_to_error::deserialize(&mut reader).map_err(|error| {
        let path = error.path().to_string();
        let error = error.into_inner();
        match error.classify() {
            Category::Data => explain(&path, &error.to_string()),
            Category::Io | Category::Syntax | Category::Eof => not_json(&error),
        }
    })?;
    reader.end().map_err(|error| not_json(&error))?;
    Ok(found)
}

/// Reads a structure from the text of a TOML file.
///
/// # Errors
/// See the head of the module.
pub fn from_toml<T: DeserializeOwned>(text: &str) -> Result<T, String> {
    let placed = |message: String, error: &toml::de::Error| {
        let at = error.span().map(|span| span.start.min(text.len()));
        match at {
            None => message,
            Some(at) => {
                let lines = text.as_bytes()[..at].iter().filter(|byte| **byte == b'\n').count();
                tr!("{problem} at line {line}", problem = message, line = lines + 1)
            }
        }
    };
    let whole = |error: toml::de::Error| {
        placed(tr!("not TOML: {problem}", problem = error.message()), &error)
    };
    let reader = toml::Deserializer::parse(text).map_err(whole)?;
    serde_path_to_error::deserialize(reader).map_err(|error| {
        let path = error.path().to_string();
        let error = error.into_inner();
        placed(explain(&path, error.message()), &error)
    })
}

/// The line of a TOML text, counted from 1, in which the `nth` entry named `key` stands, counted from 0; none where
/// there are not so many. Dotted and quoted keys are not looked into.
#[must_use]
pub fn line_of_entry(text: &str, key: &str, nth: usize) -> Option<usize> {
    let names = |line: &str| {
        line.trim_start().strip_prefix(key).is_some_and(|rest| rest.trim_start().starts_with('='))
    };
    let lines = text.lines().enumerate().filter(|(_, line)| names(line));
    lines.map(|(line, _)| line + 1).nth(nth)
}

/// How a JSON text is laid out.
#[derive(Clone, Copy, Debug)]
pub enum JsonLayout {
    /// All in one line.
    Line,
    /// Every field of the outermost object in a line of its own, so far from the margin.
    FieldALine(&'static str),
}

/// The text of a JSON file.
///
/// # Panics
/// Never for structures of numbers, text, lists and fields: these can all be written.
#[must_use]
pub fn to_json(value: &impl Serialize, layout: JsonLayout) -> String {
    let mut text = Vec::new();
    let fields = Fields { layout, depth: 0 };
    let mut writer = Serializer::with_formatter(&mut text, fields);
    value.serialize(&mut writer).expect("plain data can be written");
    String::from_utf8(text).expect("JSON is UTF-8")
}

struct Fields {
    layout: JsonLayout,
    depth: u32,
}

impl Formatter for Fields {
    fn begin_object<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.depth += 1;
        writer.write_all(b"{")
    }

    fn end_object<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.depth -= 1;
        match self.layout {
            JsonLayout::FieldALine(_) if self.depth == 0 => writer.write_all(b"\n}\n"),
            JsonLayout::FieldALine(_) | JsonLayout::Line => writer.write_all(b"}"),
        }
    }

    fn begin_object_key<W: ?Sized + Write>(
        &mut self,
        writer: &mut W,
        first: bool,
    ) -> io::Result<()> {
        if !first {
            writer.write_all(b",")?;
        }
        match self.layout {
            JsonLayout::FieldALine(margin) if self.depth == 1 => write!(writer, "\n{margin}"),
            JsonLayout::FieldALine(_) | JsonLayout::Line => Ok(()),
        }
    }

    fn begin_object_value<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        writer.write_all(b": ")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde::Deserialize;

    #[derive(Debug, Deserialize, PartialEq, Serialize)]
    #[serde(deny_unknown_fields)]
    struct Inner {
        values: [f64; 3],
    }

    #[derive(Debug, Deserialize, PartialEq, Serialize)]
    #[serde(deny_unknown_fields)]
    struct Outer {
        count: u32,
        inner: Inner,
    }

    #[test]
    fn what_is_written_is_read() {
        let outer = Outer { count: 2, inner: Inner { values: [1.0, -0.5, 1e-9] } };
        let line = to_json(&outer, JsonLayout::Line);
        assert_eq!(line, "{\"count\": 2,\"inner\": {\"values\": [1.0,-0.5,1e-9]}}");
        let fields = to_json(&outer, JsonLayout::FieldALine("  "));
        assert_eq!(fields, "{\n  \"count\": 2,\n  \"inner\": {\"values\": [1.0,-0.5,1e-9]}\n}\n");
        assert_eq!(from_json::<Outer>(&line).as_ref(), Ok(&outer));
        assert_eq!(from_json::<Outer>(&fields).as_ref(), Ok(&outer));
        let toml = "count = 2\n[inner]\nvalues = [1, -0.5, 1e-9]\n";
        assert_eq!(from_toml::<Outer>(toml), Ok(outer));
    }

    #[test]
    fn an_error_names_entry_value_allowed_and_line() {
        let json = |text: &str| from_json::<Outer>(text).unwrap_err();
        let toml = |text: &str| from_toml::<Outer>(text).unwrap_err();
        for (error, parts) in [
            (json("{\"count\": -2}"), ["`count`", "-2", "0 to 4294967295", "line 1"]),
            (
                json("{\"count\": 2, \"inner\":\n{\"values\": [1, null, 2]}}"),
                ["`inner.values[1]`", "null", "allowed is a number", "line 2"],
            ),
            (
                toml("count = 2\n[inner]\nvalues = [1.0, 2.0, \"x\"]"),
                ["`inner.values[2]`", "\"x\"", "allowed is a number", "line 3"],
            ),
            (toml("count = 2\ncuont = 3\n"), ["`cuont`", "`count`", "`inner`", "line 2"]),
            (toml("count = 2\n"), ["missing", "`inner`", "", ""]),
            (toml("count = \n"), ["not TOML", "line 1", "", ""]),
            (json("{\"count\": 1e999}"), ["not JSON", "line 1", "", ""]),
            (json("{\"count\": 1,\"inner\":{\"values\":[1,2,3]}} x"), ["not JSON", "", "", ""]),
        ] {
            for part in parts {
                assert!(error.contains(part), "{part}: {error}");
            }
        }
    }
}
