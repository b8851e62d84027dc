//! What a person said of the layout of measured data, for the next file of the same instrument: by a signature of its
//! columns, and natively in a file beside the data, which the command reads as well.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::file::MeasuredFile;
use crate::base::language::tr;
use crate::base::text::decode;
use crate::measured::layout::{DataLayout, LAYOUT_ENDING};

/// Most layouts that are kept; the one that was used longest ago goes first.
const MOST: usize = 60;
/// Longest text of one, bytes.
const LONGEST: usize = 20_000;
/// Bytes of a file that could not be read without its layout, of which its signature is made.
const BEGIN: usize = 2000;
/// Its lines.
const LINES: usize = 2;

/// Where the layout of a file comes from that was not guessed alone.
#[derive(Clone, Debug, PartialEq)]
pub enum LayoutMemory {
    /// All of it was guessed.
    Guessed,
    /// It was said for another file with the same columns.
    Alike,
    /// It stands in the file beside the data.
    Beside,
    /// It was said here, and is remembered.
    Said,
    /// A layout that was said for a file with the same columns does not go with this one; in words.
    NotAlike(String),
}

/// Layouts by the signatures of the files that they were said for, the one that was used last at the end.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct KnownLayouts(Vec<(String, DataLayout)>);

impl KnownLayouts {
    /// Those that were kept; what cannot be read is left out.
    #[must_use]
    pub fn of(kept: &[[String; 2]]) -> Self {
        let read = |[signature, text]: &[String; 2]| {
            Some((signature.clone(), DataLayout::read(text).ok()?))
        };
        let mut all: Vec<_> = kept.iter().filter_map(read).collect();
        all.drain(..all.len().saturating_sub(MOST));
        Self(all)
    }

    /// Signatures with the texts of their layouts, to be kept.
    #[must_use]
    pub fn kept(&self) -> Vec<[String; 2]> {
        self.0.iter().map(|(signature, layout)| [signature.clone(), layout.write()]).collect()
    }

    /// The layout that was said for files of a signature.
    #[must_use]
    pub fn get(&self, signature: &str) -> Option<&DataLayout> {
        self.0.iter().find(|(known, _)| known == signature).map(|(_, layout)| layout)
    }

    /// Keeps a layout for files of a signature; one that says nothing is forgotten, one that is too long is not kept.
    pub fn put(&mut self, signature: &str, layout: &DataLayout) {
        self.0.retain(|(known, _)| known != signature);
        if *layout != DataLayout::default() && layout.write().len() <= LONGEST {
            self.0.push((signature.to_owned(), layout.clone()));
            let over = self.0.len().saturating_sub(MOST);
            self.0.drain(..over);
        }
    }
}

/// FNV-1a over 64 bits, as 16 digits.
fn hash(text: &str) -> String {
    let step = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    format!("{:016x}", text.bytes().fold(0xcbf2_9ce4_8422_2325, step))
}

/// What the next file of the same instrument has in common with this one, from how it is read where nothing is said: its
/// format with names and units of its columns. Where it names none, its own name counts as well, but for the digits that
/// count recordings; where it cannot be read, its first lines without their numbers.
#[must_use]
pub fn signature(guessed: &MeasuredFile) -> String {
    let without_digits = |text: &str| -> String {
        text.chars().filter(|sign| !sign.is_ascii_digit() && !"+-".contains(*sign)).collect()
    };
    match guessed.contents() {
        Ok(read) => {
            let layout = &read.data.layout;
            let list = |list: &Option<Vec<String>>| list.clone().unwrap_or_default().join("\t");
            let named = layout.names_line != Some(0);
            let name = if named { String::new() } else { without_digits(&guessed.name) };
            let parts = [read.data.format.id(), &list(&layout.names), &list(&layout.units), &name];
            hash(&parts.join("\n"))
        }
        Err(_) => {
            let bytes = guessed.bytes();
            let begin = &bytes[..bytes.len().min(BEGIN)];
            // A letter that is cut in two at the end tells nothing.
            let text =
                decode(begin).unwrap_or_else(|_| String::from_utf8_lossy(begin).into_owned());
            let lines: Vec<String> = text.lines().take(LINES).map(without_digits).collect();
            hash(&format!("unread\n{}", lines.join("\n")))
        }
    }
}

/// Where the layout of the data at a path is remembered.
#[must_use]
pub fn beside(path: &Path) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(LAYOUT_ENDING);
    PathBuf::from(name)
}

/// The layout that stands beside the data at a path, as the command reads it; none where there is none.
#[cfg(not(target_arch = "wasm32"))]
fn read_beside(path: Option<&Path>) -> Option<Result<DataLayout, String>> {
    let place = beside(path?);
    if !place.is_file() {
        return None;
    }
    let read = crate::disk::read_text(&place).and_then(|text| DataLayout::read(&text));
    Some(read.map_err(|why| format!("{}: {why}", place.display())))
}

/// A page has no files beside others.
#[cfg(target_arch = "wasm32")]
fn read_beside(_: Option<&Path>) -> Option<Result<DataLayout, String>> {
    None
}

/// A file that was read without a word on its layout, with what is remembered of that: what stands beside it, else what
/// was said for a file like it.
#[must_use]
pub fn as_remembered(
    guessed: MeasuredFile,
    path: Option<PathBuf>,
    known: &KnownLayouts,
) -> MeasuredFile {
    let alike: Arc<str> = signature(&guessed).into();
    let guessed = guessed.at(path, Arc::clone(&alike));
    match read_beside(guessed.path()) {
        Some(Ok(layout)) => return guessed.read_as(layout, LayoutMemory::Beside),
        Some(Err(why)) => return guessed.refused(why),
        None => {}
    }
    let Some(layout) = known.get(&alike) else { return guessed };
    let alike = guessed.read_as(layout.clone(), LayoutMemory::Alike);
    match alike.contents() {
        Ok(_) => alike,
        Err(why) => {
            let why = tr!(
                "What was said for a file with the same columns does not go with this one: {why}",
                why = why
            );
            guessed.known_by(LayoutMemory::NotAlike(why))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(name: &str, text: &str) -> MeasuredFile {
        MeasuredFile::read(name.to_owned(), text.as_bytes().into(), DataLayout::default())
    }

    /// A recording of a lab whose second column has the times.
    fn recording(name: &str, begin: i32) -> MeasuredFile {
        let rows = (0..9).map(|i| format!("{};{},5;{}\n", begin + i, 3 * i % 7, 2 * i));
        file(name, &format!("Zeit;Fx;n\n[s];[N];[1/min]\n{}", rows.collect::<String>()))
    }

    fn said(file: &MeasuredFile) -> KnownLayouts {
        let mut known = KnownLayouts::default();
        known.put(&signature(&recording("a.csv", 0)), file.said());
        known
    }

    #[test]
    fn the_next_recording_of_the_same_lab_opens_as_the_last_one_was_said() {
        let first = recording("a.csv", 0).with_times("n", None);
        let known = KnownLayouts::of(&said(&first).kept());
        let next = as_remembered(recording("b.csv", 700), None, &known);
        assert_eq!(next.memory(), &LayoutMemory::Alike);
        assert_eq!(next.contents().unwrap().data.layout.time.as_deref(), Some("n"));
        let other = file("c.csv", "Zeit;Fy;n\n[s];[N];[1/min]\n0;1;2\n1;2;4\n2;1;6\n");
        let other = as_remembered(other, None, &known);
        assert_eq!(other.memory(), &LayoutMemory::Guessed, "another column is another instrument");
        let again = next.guessed_again();
        assert_eq!(again.contents().unwrap().data.layout.time.as_deref(), Some("Zeit"));
        assert_eq!(again.memory(), &LayoutMemory::Guessed);
        // What does not go with it is told, and it is guessed.
        let mut wrong = KnownLayouts::default();
        let time = Some("none such".to_owned());
        let layout = DataLayout { time, ..DataLayout::default() };
        wrong.put(&signature(&recording("a.csv", 0)), &layout);
        let guessed = as_remembered(recording("b.csv", 1), None, &wrong);
        assert!(guessed.contents().is_ok());
        let LayoutMemory::NotAlike(why) = guessed.memory() else {
            panic!("{:?}", guessed.memory())
        };
        assert!(why.contains("none such"), "{why}");
    }

    #[test]
    fn files_without_names_are_told_by_their_own_and_unread_ones_by_their_begin() {
        let rows = "0.0 1.5\n0.1 2.5\n0.2 3.5\n";
        let of = |name: &str| signature(&file(name, rows));
        assert_eq!(of("mill-001.txt"), of("mill-027.txt"));
        assert_ne!(of("mill-001.txt"), of("lathe-001.txt"));
        let unread = |text: &str| signature(&file("a.txt", text));
        assert!(file("a.txt", "no numbers\nhere\n").contents().is_err());
        assert_eq!(unread("no numbers 3\nhere\n"), unread("no numbers 41\nhere\n"));
        assert_ne!(unread("no numbers\nhere\n"), unread("none\nhere\n"));
    }

    #[test]
    fn the_store_is_bounded_and_forgets_what_says_nothing() {
        let mut known = KnownLayouts::default();
        let layout = DataLayout { rate_hz: Some(50.0), ..DataLayout::default() };
        (0..MOST + 3).for_each(|i| known.put(&i.to_string(), &layout));
        assert_eq!(known.kept().len(), MOST);
        assert!(known.get("2").is_none() && known.get("3").is_some());
        known.put("3", &DataLayout::default());
        assert!(known.get("3").is_none());
        let names = Some(vec!["n".repeat(LONGEST)]);
        known.put("4", &DataLayout { names, ..DataLayout::default() });
        assert!(known.get("4").is_none());
        let kept = [["5".to_owned(), "version = 9".to_owned()], ["6".to_owned(), layout.write()]];
        assert_eq!(KnownLayouts::of(&kept).kept().len(), 1, "what cannot be read is left out");
    }
}
