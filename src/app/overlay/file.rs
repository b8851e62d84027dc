//! A file of measured data as it was read, with what a person says of its layout.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::layouts::{LayoutMemory, signature};
use crate::base::language::tr;
use crate::measured::channel::{ChannelSummary, MeasuredChannel};
use crate::measured::layout::{DataLayout, DecimalMark, FieldSeparator};
use crate::measured::reader::{DataFormat, MeasuredData, read};

/// In the layout, the name of the column with the times where none has them.
pub const NO_TIMES: &str = "none";

/// See the head of this file. Copies share what it holds.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredFile {
    /// Its name.
    pub name: String,
    bytes: Arc<[u8]>,
    said: DataLayout,
    read: Result<Arc<ReadFile>, String>,
    /// Where it is in the file system, where it is in one.
    path: Option<PathBuf>,
    /// Where its layout comes from.
    memory: LayoutMemory,
    /// What files like it have in common with it, once that was worked out.
    alike: Option<Arc<str>>,
}

/// What was read of it.
#[derive(Debug, PartialEq)]
pub struct ReadFile {
    /// Layout and channels.
    pub data: MeasuredData,
    /// Least, mean and largest of each channel.
    pub summaries: Vec<ChannelSummary>,
}

impl MeasuredFile {
    /// Reads a file whose layout is guessed but for what is said of it.
    #[must_use]
    pub fn read(name: String, bytes: Arc<[u8]>, said: DataLayout) -> Self {
        let read = read(&bytes, &said).map_err(|fault| fault.to_string()).map(|data| {
            let summaries = data.channels.iter().map(MeasuredChannel::summary).collect();
            Arc::new(ReadFile { data, summaries })
        });
        let (path, memory, alike) = (None, LayoutMemory::Guessed, None);
        Self { name, bytes, said, read, path, memory, alike }
    }

    /// The same file read again with these entries of its layout said.
    ///
    /// # Errors
    /// Names the entry, its value and what is allowed.
    pub fn with(&self, entries: &[(&str, &str)]) -> Result<Self, String> {
        let mut said = self.said.clone();
        for (key, value) in entries {
            said.set(key, value)?;
        }
        Ok(self.read_as(said, LayoutMemory::Said))
    }

    /// The same file read again with its times in this column, or in none and at a sample rate in Hz.
    #[must_use]
    pub fn with_times(&self, column: &str, rate_hz: Option<f64>) -> Self {
        let (time, rate_hz) = (Some(column.to_owned()), rate_hz.filter(|_| column == NO_TIMES));
        let said = DataLayout { time, rate_hz, ..self.said.clone() };
        self.read_as(said, LayoutMemory::Said)
    }

    /// The same file read again with no record of it chosen.
    #[must_use]
    pub fn with_records_as_they_come(&self) -> Self {
        let said = DataLayout { variable: None, ..self.said.clone() };
        self.read_as(said, LayoutMemory::Said)
    }

    /// The same file read again as before.
    #[must_use]
    pub fn again(&self) -> Self {
        self.read_as(self.said.clone(), self.memory.clone())
    }

    /// The same file with nothing said of its layout.
    #[must_use]
    pub fn guessed_again(&self) -> Self {
        self.read_as(DataLayout::default(), LayoutMemory::Guessed)
    }

    /// The same file read again by a layout that comes from somewhere.
    pub(super) fn read_as(&self, said: DataLayout, memory: LayoutMemory) -> Self {
        let (path, alike) = (self.path.clone(), self.alike.clone());
        let read = Self::read(self.name.clone(), Arc::clone(&self.bytes), said);
        Self { path, memory, alike, ..read }
    }

    /// The same file, which stands there, with what files like it have in common with it.
    pub(super) fn at(self, path: Option<PathBuf>, alike: Arc<str>) -> Self {
        Self { path, alike: Some(alike), ..self }
    }

    /// The same file, whose layout comes from there.
    pub(super) fn known_by(self, memory: LayoutMemory) -> Self {
        Self { memory, ..self }
    }

    /// The same file, whose layout beside it cannot be read.
    pub(super) fn refused(self, why: String) -> Self {
        Self { read: Err(why), memory: LayoutMemory::Beside, ..self }
    }

    /// What a person has said of its layout.
    #[must_use]
    pub fn said(&self) -> &DataLayout {
        &self.said
    }

    /// Where its layout comes from.
    #[must_use]
    pub fn memory(&self) -> &LayoutMemory {
        &self.memory
    }

    /// What files like it have in common with it: see [`signature`].
    #[must_use]
    pub fn alike(&self) -> Arc<str> {
        self.alike.clone().unwrap_or_else(|| signature(&self.guessed_again()).into())
    }

    /// Where it is in the file system, where it is in one.
    #[must_use]
    pub fn path(&self) -> Option<&Path> {
        self.path.as_deref()
    }

    /// What was read of it, or what is wrong with it: the place, what stands there, and what was expected.
    pub fn contents(&self) -> Result<&Arc<ReadFile>, &str> {
        self.read.as_ref().map_err(String::as_str)
    }

    /// The file's bytes.
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// Whether it tells when its samples were taken, or what is wrong with it.
    #[must_use]
    pub fn is_measured(&self) -> bool {
        self.read.as_ref().map_or(true, |read| has_times(&read.data))
    }
}

/// The sample rate in Hz that every channel has by itself, as in TDMS, where no entry of the layout tells it.
#[must_use]
pub fn common_rate_hz(data: &MeasuredData) -> Option<f64> {
    let mut rates = data.channels.iter().map(|channel| channel.times.rate_hz());
    let first = rates.next()?;
    first.filter(|_| rates.all(|rate| rate == first))
}

fn has_times(data: &MeasuredData) -> bool {
    data.channels.iter().any(|channel| channel.times.at(0).is_some())
}

/// As what a file was read, in a sentence.
#[must_use]
pub fn sentence(data: &MeasuredData) -> String {
    let layout = &data.layout;
    // The others are names.
    let format = match data.format == DataFormat::Text {
        true => tr("Text"),
        false => data.format.label(),
    };
    let mut parts = vec![format.to_owned()];
    parts.extend(layout.separator.map(|separator| {
        match separator {
            FieldSeparator::Tab => tr("tabs between the values"),
            FieldSeparator::Semicolon => tr("semicolons between the values"),
            FieldSeparator::Comma => tr("commas between the values"),
            FieldSeparator::Blank => tr("blanks between the values"),
        }
        .to_owned()
    }));
    parts.extend(layout.decimal.map(|decimal| {
        match decimal {
            DecimalMark::Point => tr("decimal point"),
            DecimalMark::Comma => tr("decimal comma"),
        }
        .to_owned()
    }));
    parts.extend(layout.names_line.map(|line| match line {
        0 => tr("no line with names").to_owned(),
        line => tr!("names in line {line}", line = line),
    }));
    let units = layout.units_line.filter(|line| *line > 0);
    parts.extend(units.map(|line| tr!("units in line {line}", line = line)));
    parts.extend(layout.first_line.map(|line| tr!("values from line {line} on", line = line)));
    let time = layout.time.as_deref().filter(|time| *time != NO_TIMES);
    let times = match (time, layout.rate_hz) {
        (Some(time), _) => tr!("times in the column {column}", column = time),
        (None, Some(rate_hz)) => tr!("{rate} samples in a second", rate = rate_hz),
        (None, None) => match common_rate_hz(data) {
            Some(rate_hz) => tr!("{rate} samples in a second", rate = rate_hz),
            None if has_times(data) => tr("each channel with times of its own").to_owned(),
            None => tr("no times").to_owned(),
        },
    };
    parts.push(times);
    format!("{}.", parts.join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn file(text: &str) -> MeasuredFile {
        MeasuredFile::read("a.csv".to_owned(), text.as_bytes().into(), DataLayout::default())
    }

    #[test]
    fn the_guess_is_told_in_a_sentence_and_another_column_has_the_times() {
        let read = file("Zeit;Fx;n\n[s];[N];[1/min]\n0,0;1,5;1\n0,1;2,5;2\n0,2;3,5;4\n");
        let told = sentence(&read.contents().unwrap().data);
        assert_eq!(
            told,
            "Text, semicolons between the values, decimal comma, names in line 1, units in line 2, values from line 3 \
             on, times in the column Zeit."
        );
        let other = read.with_times("n", None);
        let data = &other.contents().unwrap().data;
        assert_eq!(data.channels[0].name, "Zeit");
        assert_eq!(data.channels[0].times.at(2), Some(4.0));
        let none = read.with_times(NO_TIMES, Some(50.0));
        assert_eq!(none.contents().unwrap().data.channels[1].times.at(50), Some(1.0));
        let error = read.with(&[("decimal", "dot")]).unwrap_err();
        assert!(error.contains("`decimal`") && error.contains("dot"), "{error}");
    }

    #[test]
    fn channels_with_times_of_their_own_tell_their_rate() {
        let bytes: &[u8] = include_bytes!("../../../crates/measured/tests/data/lab.tdms");
        let read = MeasuredFile::read("lab.tdms".to_owned(), bytes.into(), DataLayout::default());
        let data = &read.contents().unwrap().data;
        assert_eq!((data.layout.rate_hz, common_rate_hz(data)), (None, Some(25_000.0)));
        assert_eq!(sentence(data), "TDMS, 25000 samples in a second.");
        let one = read.with(&[("variable", "Force/Fy")]).unwrap();
        assert_eq!(one.contents().unwrap().data.channels.len(), 1);
        let all = one.with_records_as_they_come();
        assert_eq!(all.contents().unwrap().data.channels.len(), 3);
    }

    #[test]
    fn what_tells_no_times_is_a_table() {
        assert!(file("t,Fx\n0.0,1\n0.1,2\n0.2,3\n").is_measured());
        assert!(!file("feed,Fx\n100,1\n90,2\n120,3\n").is_measured());
    }
}
