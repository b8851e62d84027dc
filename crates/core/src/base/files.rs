//! Files of structures, read and written by serde: an error names the entry by its path, its value,
//! what is allowed, and the line.

use std::io::{self, Write};

use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::error::Category;
use serde_json::ser::{Formatter, Serializer};

/// serde's words for what it expected, and those of people who know no Rust.
const WORDS: [(&str, &str); 7] = [
    ("f64", "a number"),
    ("u32", "a whole number from 0 to 4294967295"),
    ("u64", "a whole number from 0 on"),
    ("usize", "a whole number from 0 on"),
    ("a sequence", "a list"),
    ("an array of length 3", "a list of 3 numbers"),
    ("a map", "a table"),
];

/// The text of an error at a path; `.` is the whole file.
fn explain(path: &str, message: &str) -> String {
    let mut message = message.trim_end().to_owned();
    for (word, plain) in WORDS {
        for end in ["", " at line"] {
            let (from, to) = (format!("expected {word}{end}"), format!("allowed is {plain}{end}"));
            if end.is_empty() && message.ends_with(&from) || !end.is_empty() {
                message = message.replace(&from, &to);
            }
        }
    }
    if path == "." { message } else { format!("`{path}`: {message}") }
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
            Category::Io | Category::Syntax | Category::Eof => format!("not JSON: {error}"),
        }
    })?;
    reader.end().map_err(|error| format!("not JSON: {error}"))?;
    Ok(found)
}

/// Reads a structure from the text of a TOML file.
///
/// # Errors
/// See the head of the module.
pub fn from_toml<T: DeserializeOwned>(text: &str) -> Result<T, String> {
    let line = |error: &toml::de::Error| {
        let at = error.span().map(|span| span.start.min(text.len()));
        at.map_or(String::new(), |at| {
            let lines = text.as_bytes()[..at].iter().filter(|byte| **byte == b'\n').count();
            format!(" at line {}", lines + 1)
        })
    };
    let whole = |error: toml::de::Error| format!("not TOML: {}{}", error.message(), line(&error));
    let reader = toml::Deserializer::parse(text).map_err(whole)?;
    serde_path_to_error::deserialize(reader).map_err(|error| {
        let path = error.path().to_string();
        let error = error.into_inner();
        format!("{}{}", explain(&path, error.message()), line(&error))
    })
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
