//! The text of a file: UTF-8, with or without a byte order mark, or UTF-16 with one. Any other encoding is
//! named, with what to do; nothing is guessed. And which known name a mistyped one is most like.

use crate::base::language::{text, tr};

/// Bytes from the start in which UTF-16 without its mark is looked for.
const LOOKED_AT: usize = 512;

/// The text that bytes stand for, without a byte order mark.
///
/// ```
/// use steadycut_core::base::text::decode;
///
/// assert_eq!(decode(b"\xef\xbb\xbfRa").as_deref(), Ok("Ra"));
/// assert_eq!(decode(b"\xff\xfeR\0a\0").as_deref(), Ok("Ra"));
/// assert!(decode(b"Fr\xe4sen").unwrap_err().contains("Latin-1"));
/// ```
///
/// # Errors
/// Names the encoding that the bytes seem to have, or says that they are no text.
pub fn decode(bytes: &[u8]) -> Result<String, String> {
    match bytes {
        [0xff, 0xfe, 0, 0, ..] | [0, 0, 0xfe, 0xff, ..] => {
            Err(tr("it is UTF-32: save it as UTF-8").to_owned())
        }
        [0xff, 0xfe, rest @ ..] => utf_16(rest, u16::from_le_bytes),
        [0xfe, 0xff, rest @ ..] => utf_16(rest, u16::from_be_bytes),
        [0xef, 0xbb, 0xbf, rest @ ..] | rest => utf_8(rest),
    }
}

fn utf_16(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> Result<String, String> {
    let (pairs, rest) = bytes.as_chunks();
    let units: Vec<u16> = pairs.iter().map(|pair| unit(*pair)).collect();
    let whole = String::from_utf16(&units).ok().filter(|_| rest.is_empty());
    whole.ok_or_else(|| tr("it is UTF-16 with half a character in it: save it as UTF-8").to_owned())
}

fn utf_8(bytes: &[u8]) -> Result<String, String> {
    if let Some(problem) = unmarked_utf_16(bytes) {
        return Err(tr(problem).to_owned());
    }
    // An archive, which the files of spreadsheets are too.
    if bytes.starts_with(b"PK\x03\x04") {
        let problem = tr("it is no text but an archive or a spreadsheet: save its table as CSV");
        return Err(problem.to_owned());
    }
    // Other control characters than those that move on stand in no text of any encoding.
    let control = |byte: &u8| *byte < b' ' && !b"\t\n\r\x0c\x1b".contains(byte);
    if let Some(at) = bytes.iter().position(control) {
        let byte = format!("{:02x}", bytes[at]);
        let line = line(bytes, at);
        return Err(tr!("it is no text: byte 0x{byte} in line {line}", byte = byte, line = line));
    }
    std::str::from_utf8(bytes).map(str::to_owned).map_err(|error| {
        let at = error.valid_up_to();
        let (byte, line) = (bytes[at], line(bytes, at));
        let shown = format!("{byte:02x}");
        // Where Latin-1 has no letters, Windows has some of its own.
        match byte {
            0xa0.. => tr!(
                "it is not UTF-8 (byte 0x{byte} in line {line}) but perhaps Latin-1 or \
                 Windows-1252, where it is {letter}: save it as UTF-8",
                byte = shown,
                line = line,
                letter = format!("{:?}", char::from(byte))
            ),
            _ => tr!(
                "it is not UTF-8 (byte 0x{byte} in line {line}) but perhaps Windows-1252: save it \
                 as UTF-8",
                byte = shown,
                line = line
            ),
        }
    })
}

/// What is said of UTF-16 without its mark: most characters of settings and tables are ASCII, so every
/// second byte is zero.
fn unmarked_utf_16(bytes: &[u8]) -> Option<&'static str> {
    let looked_at = &bytes[..bytes.len().min(LOOKED_AT) / 2 * 2];
    let zeros = |from: usize| looked_at.iter().skip(from).step_by(2).filter(|x| **x == 0).count();
    // Of the bytes at every second place, most.
    let many = looked_at.len() / 4 + 1;
    match [zeros(0), zeros(1)] {
        [0, odd] if odd >= many => {
            Some(text!("it is UTF-16 (little endian) without a byte order mark: save it as UTF-8"))
        }
        [even, 0] if even >= many => {
            Some(text!("it is UTF-16 (big endian) without a byte order mark: save it as UTF-8"))
        }
        _ => None,
    }
}

/// The number of the line of a byte.
fn line(bytes: &[u8], at: usize) -> usize {
    1 + bytes[..at].iter().filter(|byte| **byte == b'\n').count()
}

/// The name among `names` that is most like `name`, if it is at least so like it: 0 for nothing in common, 1 for
/// the same, by Jaro and Winkler, whatever the case.
///
/// ```
/// use steadycut_core::base::text::nearest;
///
/// assert_eq!(nearest("feed_mm", ["feed_mm_min", "force_n"], 0.8), Some("feed_mm_min"));
/// assert_eq!(nearest("xyz", ["feed_mm_min", "force_n"], 0.8), None);
/// ```
#[must_use]
pub fn nearest<'a>(
    name: &str,
    names: impl IntoIterator<Item = &'a str>,
    least_likeness: f64,
) -> Option<&'a str> {
    let name = name.to_lowercase();
    names
        .into_iter()
        .map(|known| (strsim::jaro_winkler(&name, &known.to_lowercase()), known))
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .filter(|(likeness, _)| *likeness > least_likeness)
        .map(|(_, known)| known)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn any_bytes_are_read_or_named(bytes in proptest::collection::vec(any::<u8>(), 0..64)) {
            if let Err(problem) = decode(&bytes) {
                prop_assert!(problem.starts_with("it is "), "{}", problem);
            }
        }

        #[test]
        fn any_text_is_read_as_it_was_written(text in r"\PC{0,40}") {
            let marked = format!("\u{feff}{text}");
            prop_assert_eq!(decode(marked.as_bytes()), Ok(text.clone()));
            prop_assert_eq!(decode(&utf_16(&marked, u16::to_le_bytes)), Ok(text.clone()));
            prop_assert_eq!(decode(&utf_16(&marked, u16::to_be_bytes)), Ok(text));
        }
    }

    /// A text as UTF-16.
    fn utf_16(text: &str, unit: fn(u16) -> [u8; 2]) -> Vec<u8> {
        text.encode_utf16().flat_map(unit).collect()
    }

    #[test]
    fn every_encoding_that_says_what_it_is_is_read() {
        for text in ["version = 1\n", "name = \"Fräsen µm 🛠\"\r\n", ""] {
            let marked = format!("\u{feff}{text}");
            assert_eq!(decode(text.as_bytes()).as_deref(), Ok(text));
            assert_eq!(decode(marked.as_bytes()).as_deref(), Ok(text));
            assert_eq!(decode(&utf_16(&marked, u16::to_le_bytes)).as_deref(), Ok(text));
            assert_eq!(decode(&utf_16(&marked, u16::to_be_bytes)).as_deref(), Ok(text));
        }
    }

    #[test]
    fn every_other_encoding_is_named() {
        let text = "version = 1\nname = \"Fräsen\"\n";
        let half = [0xff, 0xfe, b'a', 0, 0x00, 0xd8];
        let utf_32: Vec<u8> =
            format!("\u{feff}{text}").chars().flat_map(|c| u32::from(c).to_le_bytes()).collect();
        let latin_1: Vec<u8> = text.chars().map(|c| c as u8).collect();
        for (bytes, parts) in [
            (utf_16(text, u16::to_le_bytes), ["UTF-16", "little", "byte order mark"]),
            (utf_16(text, u16::to_be_bytes), ["UTF-16", "big", "byte order mark"]),
            (utf_16("x", u16::to_le_bytes), ["UTF-16", "little", ""]),
            (half.to_vec(), ["UTF-16", "half a character", ""]),
            (half[..5].to_vec(), ["UTF-16", "half a character", ""]),
            (utf_32, ["UTF-32", "", ""]),
            (latin_1, ["Latin-1", "0xe4 in line 2", "'ä'"]),
            (b"price in \x80".to_vec(), ["Windows-1252", "0x80 in line 1", ""]),
        ] {
            let error = decode(&bytes).unwrap_err();
            for part in parts.iter().chain(&["save it as UTF-8"]) {
                assert!(error.contains(part), "{part}: {error}");
            }
        }
        assert!(decode(b"PK\x03\x04\x14\0").unwrap_err().contains("spreadsheet"));
        assert!(decode(b"\x1f\x8b\x08\0").unwrap_err().contains("no text: byte 0x1f in line 1"));
        assert!(decode(b"a\nb\0").unwrap_err().contains("no text: byte 0x00 in line 2"));
    }
}
