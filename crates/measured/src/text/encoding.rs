//! The characters of a text in any of the encodings that instruments write.

use std::borrow::Cow;

use crate::base::language::tr;
use crate::fault::DataFault;
use crate::layout::TextEncoding;

/// Bytes from the start in which UTF-16 without its mark, and what is no text, is looked for.
const LOOKED_AT: usize = 4096;

/// What Windows-1252 has in the place of Latin-1's control characters from 0x80 on; what it does not have either stays.
const WINDOWS: [char; 32] = [
    '€', '\u{81}', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{8d}', 'Ž', '\u{8f}',
    '\u{90}', '‘', '’', '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{9d}', 'ž', 'Ÿ',
];

/// The text of a file, in the encoding that is said or that it seems to have. Lines end with a line feed, or with a
/// carriage return before it.
///
/// # Errors
/// It is no text, or not of the encoding that is said.
pub(super) fn decode(
    bytes: &[u8],
    said: Option<TextEncoding>,
) -> Result<(Cow<'_, str>, TextEncoding), DataFault> {
    let encoding = said.unwrap_or_else(|| seeming(bytes));
    let text = match encoding {
        TextEncoding::Utf8 => {
            let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
            let text = std::str::from_utf8(bytes).map_err(|error| {
                let at = error.valid_up_to();
                let found = tr!("byte {byte} is no UTF-8", byte = format!("0x{:02x}", bytes[at]));
                DataFault::at(at, found, tr("UTF-8, or another encoding: latin-1"))
            })?;
            Cow::Borrowed(text)
        }
        TextEncoding::Utf16Le => Cow::Owned(utf_16(bytes, u16::from_le_bytes)?),
        TextEncoding::Utf16Be => Cow::Owned(utf_16(bytes, u16::from_be_bytes)?),
        TextEncoding::Latin1 => Cow::Owned(bytes.iter().map(|byte| latin_1(*byte)).collect()),
    };
    let looked_at = &text.as_bytes()[..text.len().min(LOOKED_AT)];
    let control = |byte: &u8| *byte < b' ' && !b"\t\n\r\x0c\x1a".contains(byte);
    if let Some(at) = looked_at.iter().position(control) {
        let found = tr!("byte {byte} stands in no text", byte = format!("0x{:02x}", looked_at[at]));
        return Err(DataFault::at(at, found, tr("text, MATLAB v5 or v7.3, HDF5, TDMS or Parquet")));
    }
    // Old programs end lines with a carriage return alone.
    let text = match looked_at.contains(&b'\r') && !text.contains('\n') {
        true => Cow::Owned(text.replace('\r', "\n")),
        false => text,
    };
    Ok((text, encoding))
}

fn latin_1(byte: u8) -> char {
    match byte {
        0x80..=0x9f => WINDOWS[usize::from(byte) - 0x80],
        _ => char::from(byte),
    }
}

fn utf_16(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> Result<String, DataFault> {
    let (pairs, rest) = bytes.as_chunks();
    let units = pairs.iter().map(|pair| unit(*pair)).skip_while(|unit| *unit == 0xfeff);
    let mut text = String::with_capacity(bytes.len() / 2);
    for (index, character) in char::decode_utf16(units).enumerate() {
        let half = |_| {
            let found = tr("half a character of UTF-16").to_owned();
            DataFault::at(2 * index, found, tr("UTF-16, or another encoding: utf-8 or latin-1"))
        };
        text.push(character.map_err(half)?);
    }
    match rest {
        [] => Ok(text),
        _ => {
            Err(DataFault::at(bytes.len() - 1, tr("half a character of UTF-16"), tr("a whole one")))
        }
    }
}

/// The encoding that bytes seem to have: by their mark, by the zeros of UTF-16, or by being UTF-8 throughout.
fn seeming(bytes: &[u8]) -> TextEncoding {
    match bytes {
        [0xff, 0xfe, ..] => return TextEncoding::Utf16Le,
        [0xfe, 0xff, ..] => return TextEncoding::Utf16Be,
        [0xef, 0xbb, 0xbf, ..] => return TextEncoding::Utf8,
        _ => {}
    }
    let looked_at = &bytes[..bytes.len().min(LOOKED_AT) / 2 * 2];
    let zeros = |from: usize| looked_at.iter().skip(from).step_by(2).filter(|x| **x == 0).count();
    let many = looked_at.len() / 4 + 1;
    match [zeros(0), zeros(1)] {
        [0, odd] if odd >= many => TextEncoding::Utf16Le,
        [even, 0] if even >= many => TextEncoding::Utf16Be,
        _ if std::str::from_utf8(bytes).is_ok() => TextEncoding::Utf8,
        _ => TextEncoding::Latin1,
    }
}
