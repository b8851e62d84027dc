//! The whole state in a link: what differs from the default scenario, as a query string after
//! `#`: `v=1&target.ra_um=0.9&at.3.5.plant.wear_factor=1.2` (the last is an edit at 3.5 s). The many edits of a
//! drag are one part (`series.rs`). Where that is shorter, all that follows the version is packed: `v=1&z=` and
//! the text of `packed.rs`.

mod series;

use std::borrow::Cow;

use percent_encoding::{AsciiSet, NON_ALPHANUMERIC, percent_decode_str, utf8_percent_encode};

use super::edits::{Edit, Edits};
use super::packed::{pack, unpack};
use super::scenario::{FORMAT_VERSION, Scenario, companion, parse_value};
use crate::base::language::{text, tr};
use crate::base::settings::SettingError;

/// Longest link text that is read, bytes, packed and unpacked.
const MAX_BYTES: usize = 2_000_000;
/// What stands before the packed part.
const PACKED: &str = "z=";
const TWICE: &str = text!("it is packed twice");
/// All but letters, digits and these.
const ESCAPED: AsciiSet =
    NON_ALPHANUMERIC.remove(b'-').remove(b'_').remove(b'.').remove(b'~').remove(b',');

fn format_error(problem: impl Into<String>) -> SettingError {
    SettingError::Format { what: tr("link").to_owned(), problem: problem.into() }
}

fn encode(text: &str) -> String {
    utf8_percent_encode(text, &ESCAPED).to_string()
}

/// A part of a link without its percent signs.
///
/// # Errors
/// A percent sign without two hexadecimal digits, or bytes that are not UTF-8.
pub fn decode(text: &str) -> Result<String, SettingError> {
    let bytes = text.as_bytes();
    let hex = |at: usize| bytes.get(at).is_some_and(u8::is_ascii_hexdigit);
    // The library leaves a broken escape as it stands; here it is an error.
    if (0..bytes.len()).any(|at| bytes[at] == b'%' && !(hex(at + 1) && hex(at + 2))) {
        return Err(format_error(tr("a % without two hexadecimal digits")));
    }
    let decoded = percent_decode_str(text).decode_utf8();
    decoded.map(Cow::into_owned).map_err(|_| format_error(tr("text that is not UTF-8")))
}

/// Reads the part of a link after `#`.
///
/// ```
/// use steadycut_core::run::{edits::Edits, presets, scenario_link};
///
/// let scenario = presets::load("table3-5").unwrap();
/// let link = scenario_link::write(&scenario, &Edits::none());
/// assert_eq!(scenario_link::parse(&link).unwrap(), (scenario, Edits::none()));
/// ```
///
/// What stands before `#`, the page's address, is passed over. A link that cannot be read as it is may have been
/// mangled where it was sent: then the marks of the text around it are taken off.
///
/// # Errors
/// A missing or unknown version, an unknown setting, or a value outside its range.
pub fn parse(link: &str) -> Result<(Scenario, Edits), SettingError> {
    let fragment = link.split_once('#').map_or(link, |(_, fragment)| fragment);
    parse_exactly(fragment).or_else(|error| {
        let mended = mended(fragment);
        if mended == fragment { Err(error) } else { parse_exactly(&mended).map_err(|_| error) }
    })
}

/// Whether a text is meant as a link: an address, or its part from `#` on.
#[must_use]
pub fn is_link(text: &str) -> bool {
    let starts = ["http://", "https://", "#v=", "v=", "#mission", "#embed"];
    starts.iter().any(|start| text.starts_with(start))
}

/// A link without the marks that mails, chats and web pages put around it or into it.
#[must_use]
pub fn mended(fragment: &str) -> String {
    let around = |c: char| c.is_whitespace() || "<>()[]{}\"'`.,;:!?".contains(c);
    fragment.replace("&amp;", "&").trim_matches(around).to_owned()
}

fn parse_exactly(fragment: &str) -> Result<(Scenario, Edits), SettingError> {
    if fragment.len() > MAX_BYTES {
        return Err(format_error(tr!(
            "{n} bytes; at most {most} are read",
            n = fragment.len(),
            most = MAX_BYTES
        )));
    }
    check_version(fragment)?;
    let packed: Vec<&str> =
        fragment.split('&').filter_map(|part| part.strip_prefix(PACKED)).collect();
    let unpacked = match packed[..] {
        [] => String::new(),
        [packed] => unpack(packed, MAX_BYTES).map_err(format_error)?,
        _ => return Err(format_error(tr(TWICE))),
    };
    if unpacked.split('&').any(|part| part.starts_with(PACKED)) {
        return Err(format_error(tr(TWICE)));
    }
    let plain = fragment.split('&').filter(|part| !part.starts_with(PACKED));
    let (mut changes, mut edits) = (Vec::new(), Vec::new());
    for part in unpacked.split('&').chain(plain).filter(|part| !part.is_empty()) {
        let (key, value) = part
            .split_once('=')
            .ok_or_else(|| format_error(tr!("`{part}` is not name=value", part = clip(part))))?;
        let (key, value) = (decode(key)?, decode(value)?);
        if key == "v" {
            continue;
        }
        if let Some(path) = key.strip_prefix(series::KEY) {
            edits.extend(series::read(path, &value).map_err(format_error)?);
        } else if let Some(edit) = key.strip_prefix("at.") {
            edits.push(parse_edit(edit, &value)?);
        } else {
            changes.push((key.clone(), parse_value(&key, &value)?));
        }
    }
    let mut scenario = Scenario::default();
    scenario.set_all(&changes)?;
    let mut list = Edits::none();
    for edit in edits {
        list.push(&scenario, edit)?;
    }
    Ok((scenario, list))
}

/// The version comes first: a link from another version may hold anything.
fn check_version(fragment: &str) -> Result<(), SettingError> {
    match fragment.split('&').find_map(|part| part.strip_prefix("v=")) {
        Some(v) if v == FORMAT_VERSION.to_string() => Ok(()),
        Some(v) => {
            let problem = tr!(
                "version {version}; this program reads {known}",
                version = clip(v),
                known = FORMAT_VERSION
            );
            Err(format_error(problem))
        }
        None => Err(format_error(tr!("`v={version}` is missing", version = FORMAT_VERSION))),
    }
}

fn clip(text: &str) -> String {
    text.chars().take(60).collect()
}

fn parse_edit(key: &str, value: &str) -> Result<Edit, SettingError> {
    // `3.5.plant.wear_factor`: the time ends where the first letter after a dot begins.
    let split = key
        .char_indices()
        .find(|(i, c)| *i > 0 && c.is_ascii_alphabetic() && key[..*i].ends_with('.'))
        .map(|(i, _)| i)
        .ok_or_else(|| format_error(tr!("`at.{key}` names no setting", key = clip(key))))?;
    let at_s = key[..split - 1]
        .parse()
        .map_err(|_| format_error(tr!("`at.{key}` has no time in seconds", key = clip(key))))?;
    let path = key[split..].to_owned();
    let value = parse_value(&path, value)?;
    Ok(Edit { at_s, path, value })
}

/// Writes the part of a link after `#`; reading it back gives the same scenario and edits.
#[must_use]
pub fn write(scenario: &Scenario, edits: &Edits) -> String {
    let mut parts = Vec::new();
    // Reading a material or a drive brings its companion, so those are left out by that value.
    let choices = scenario.default_for_choices();
    let chosen = choices.difference(&Scenario::default()).into_iter();
    let chosen = chosen.filter(|(param, _)| companion(&param.path).is_some());
    for (param, value) in chosen.chain(scenario.difference(&choices)) {
        parts.push(format!("{}={}", param.path, encode(&value.to_string())));
    }
    let mut left = edits.list();
    while let [first, ..] = left {
        if let Some((key, value, count)) = series::write(left) {
            parts.push(format!("{key}={value}"));
            left = &left[count..];
        } else {
            let value = encode(&first.value.to_string());
            parts.push(format!("at.{}.{}={value}", first.at_s, first.path));
            left = &left[1..];
        }
    }
    let version = format!("v={FORMAT_VERSION}");
    if parts.is_empty() {
        return version;
    }
    let plain = parts.join("&");
    let packed = format!("{PACKED}{}", pack(&plain));
    let shorter = if packed.len() < plain.len() { packed } else { plain };
    format!("{version}&{shorter}")
}
