//! Files of measured data, read against what is known of them from elsewhere.

mod hdf5;
mod peaks;
mod samples;
mod spoilt;
mod texts;
mod written;

use steadycut_measured::layout::DataLayout;
use steadycut_measured::reader::{MeasuredData, read};

/// A file of the folder `tests/data`.
fn sample(name: &str) -> Vec<u8> {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(name);
    std::fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// A layout of these entries.
fn layout(entries: &[(&str, &str)]) -> DataLayout {
    let mut layout = DataLayout::default();
    entries.iter().for_each(|(key, value)| layout.set(key, value).unwrap());
    layout
}

/// What is read of bytes of which nothing is said.
fn guessed(bytes: &[u8]) -> MeasuredData {
    read(bytes, &DataLayout::default()).unwrap_or_else(|error| panic!("{error}"))
}

/// An entry of the layout that was found.
fn entry(data: &MeasuredData, key: &str) -> String {
    let entries = data.layout.entries();
    entries.into_iter().find(|(name, _)| *name == key).map(|(_, value)| value).unwrap_or_default()
}
