//! The one door to a file of measured data: its bytes and what a person says of its layout go in, channels with the
//! whole layout come out.

use crate::assemble::{RawColumn, assemble};
use crate::base::language::tr;
use crate::channel::MeasuredChannel;
use crate::fault::DataFault;
use crate::hdf5;
use crate::layout::DataLayout;
use crate::matlab;
use crate::parquet;
use crate::tdms;
use crate::text;

steadycut_core::choice! {
    /// A format of measured data.
    pub enum DataFormat {
        /// Lines of values, as spreadsheets, data loggers and Kistler's programs export them.
        Text = "text", "text";
        /// MATLAB's files up to version 7, which scipy writes as well.
        Matlab5 = "matlab-5", "MATLAB v5";
        /// MATLAB's files since version 7.3, which are HDF5.
        Matlab73 = "matlab-7.3", "MATLAB v7.3";
        /// HDF5, as h5py, PyTables, pandas and many instruments write it.
        Hdf5 = "hdf5", "HDF5";
        /// LabVIEW's files of channels in groups.
        Tdms = "tdms", "TDMS";
        /// Columns of the Arrow family.
        Parquet = "parquet", "Parquet";
    }
}

/// Something in a file that can be chosen by its name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DataEntry {
    /// The name, as the layout's `variable` takes it.
    pub name: String,
    /// What it is, for people.
    pub about: String,
}

/// What was read of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredData {
    /// The file's format.
    pub format: DataFormat,
    /// As what it was read: what a person said of it, and what was guessed of the rest.
    pub layout: DataLayout,
    /// What the file holds and can be chosen; empty where that are the channels alone.
    pub entries: Vec<DataEntry>,
    /// Single values and texts beside the channels, by their names.
    pub facts: Vec<(String, String)>,
    /// What is remarkable: rows and columns left out, doubts about a guess.
    pub notes: Vec<String>,
    /// The channels.
    pub channels: Vec<MeasuredChannel>,
}

/// What the reader of a format gives.
#[derive(Debug, Default)]
pub(crate) struct RawData {
    pub columns: Vec<RawColumn>,
    /// Samples in a second of all columns that tell nothing themselves.
    pub rate_hz: Option<f64>,
    pub entries: Vec<DataEntry>,
    pub facts: Vec<(String, String)>,
    pub notes: Vec<String>,
}

impl DataFormat {
    /// The format of a file, by its first bytes; what is no other is text.
    ///
    /// # Errors
    /// It is a known format that is not read, or nothing at all.
    pub fn of(bytes: &[u8]) -> Result<Self, DataFault> {
        let readable = || tr("text, MATLAB v5 or v7.3, HDF5, TDMS or Parquet").to_owned();
        let unread = |what: &str| DataFault::of_file(tr(what), readable());
        if bytes.is_empty() {
            return Err(DataFault::of_file(tr("the file is empty"), readable()));
        }
        if bytes.starts_with(b"PAR1") {
            return Ok(Self::Parquet);
        }
        if bytes.starts_with(b"TDSm") {
            return Ok(Self::Tdms);
        }
        if matlab::is(bytes) {
            return Ok(Self::Matlab5);
        }
        if hdf5::begin(bytes).is_some() {
            let is_matlab = bytes.starts_with(b"MATLAB 7.3 MAT-file");
            return Ok(if is_matlab { Self::Matlab73 } else { Self::Hdf5 });
        }
        if bytes.starts_with(b"PK\x03\x04") {
            let what = crate::base::language::text!(
                "it is no text but an archive or a spreadsheet: save its table as CSV"
            );
            return Err(unread(what));
        }
        if bytes.starts_with(b"TDSh") {
            let what = crate::base::language::text!(
                "it is the index of a TDMS file: give the file itself"
            );
            return Err(unread(what));
        }
        Ok(Self::Text)
    }

    /// Entries of a layout that mean nothing for files of this format.
    fn without(self) -> &'static [&'static str] {
        match self {
            Self::Text => &["variable"],
            Self::Parquet => &[
                "encoding",
                "separator",
                "decimal",
                "thousands",
                "names_line",
                "units_line",
                "first_line",
                "variable",
            ],
            Self::Matlab5 | Self::Matlab73 | Self::Hdf5 | Self::Tdms => &[
                "encoding",
                "separator",
                "decimal",
                "thousands",
                "names_line",
                "units_line",
                "first_line",
            ],
        }
    }
}

/// Reads a file; `said` is what a person says of its layout.
///
/// ```
/// use steadycut_measured::layout::DataLayout;
/// use steadycut_measured::reader::read;
///
/// let data = read(b"Zeit;Fx\n[s];[N]\n0,0;1,5\n0,1;2,5\n", &DataLayout::default()).unwrap();
/// assert_eq!(data.channels[0].title(), "Fx [N]");
/// assert_eq!(data.channels[0].values, [1.5, 2.5]);
/// assert_eq!(data.channels[0].times.rate_hz(), Some(10.0));
/// ```
///
/// # Errors
/// What stands in the file, where, and what was expected there; or an entry of the layout that does not go with it.
pub fn read(bytes: &[u8], said: &DataLayout) -> Result<MeasuredData, DataFault> {
    let format = DataFormat::of(bytes)?;
    let given = said.entries();
    if let Some((key, _)) = given.iter().find(|(key, _)| format.without().contains(key)) {
        let found = tr!(
            "`{key}` means nothing for a file of the format {format}",
            key = *key,
            format = format.label()
        );
        return Err(DataFault::of_file(found, ""));
    }
    let mut layout = said.clone();
    let raw = match format {
        DataFormat::Text => text::read(bytes, &mut layout)?,
        DataFormat::Matlab5 => matlab::read(bytes, &mut layout)?,
        DataFormat::Matlab73 => hdf5::read_matlab(bytes, &mut layout)?,
        DataFormat::Hdf5 => hdf5::read(bytes, &mut layout)?,
        DataFormat::Tdms => tdms::read(bytes, &mut layout)?,
        DataFormat::Parquet => parquet::read(bytes)?,
    };
    let RawData { columns, rate_hz, entries, facts, mut notes } = raw;
    let (channels, more) = assemble(columns, &mut layout, rate_hz)?;
    notes.extend(more);
    if channels.is_empty() {
        let found = tr("the file has no column with numbers");
        return Err(DataFault::of_file(found, tr("at least one")));
    }
    Ok(MeasuredData { format, layout, entries, facts, notes, channels })
}
