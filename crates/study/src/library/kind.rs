//! What a file is: by the ending of its name, and by what it says of itself where several kinds share one.

use crate::base::language::text;
use crate::base::text::decode;
use crate::measured::layout::{DataLayout, LAYOUT_ENDING};
use crate::measured::reader::read;
use crate::mission::{Mission, MissionResult};
use crate::own_file::OwnFileKind;
use crate::part::PartPath;

/// Endings of tables as text.
pub const TABLES: [&str; 2] = ["csv", "tsv"];
/// Endings of files that only a spreadsheet reads.
pub const SPREADSHEETS: [&str; 3] = ["xlsx", "xls", "ods"];
/// Endings of programs of milling machines.
pub const PROGRAMS: [&str; 6] = ["nc", "ngc", "gcode", "tap", "cnc", "mpf"];
/// Endings of controllers' scripts.
pub const SCRIPTS: [&str; 1] = ["rhai"];
/// Endings of files of measured data, which are nothing else.
pub const MEASURED: [&str; 8] = ["mat", "tdms", "parquet", "h5", "hdf5", "dat", "asc", "lvm"];
/// Endings of texts that may be measured data.
pub const TEXTS: [&str; 1] = ["txt"];
/// Endings of what this program writes itself.
const OWN: [&str; 2] = ["toml", "json"];

steadycut_core::choice! {
    /// What a file is.
    pub enum LibraryKind {
        /// A cutter.
        Tool = "tool", "cutter";
        /// A material.
        Material = "material", "material";
        /// Drives and limits of a machine.
        Machine = "machine", "machine";
        /// The structure at the tool's tip.
        Structure = "structure", "structure at the tool's tip";
        /// A part as a table of depths.
        Part = "part", "part";
        /// A program of a milling machine.
        Program = "program", "program (G-code)";
        /// A controller's script.
        Script = "script", "script";
        /// A scenario.
        Scenario = "scenario", "scenario";
        /// A formula's model.
        Formula = "formula", "formula";
        /// A mission.
        Mission = "mission", "mission";
        /// Measured data.
        Measured = "measured", "measured data";
        /// A table in which formulas are searched for.
        Table = "table", "table";
        /// Networks of UNKS.
        Networks = "networks", "networks";
        /// A saved search for a formula.
        Search = "search", "saved search";
        /// What a mission came to.
        Result = "result", "result of a mission";
        /// Nothing that can be told.
        Unreadable = "unreadable", "not readable";
    }
}

/// Whether a name ends, behind its last full stop, with one of these.
#[must_use]
pub fn ends_with_one_of(name: &str, endings: &[&str]) -> bool {
    let ending = name.rsplit_once('.').map(|(_, ending)| ending);
    ending.is_some_and(|ending| endings.iter().any(|known| ending.eq_ignore_ascii_case(known)))
}

/// Whether the program has a use for files of such a name. Layouts stand beside measured data and are read with them.
pub(super) fn can_be_taken(name: &str) -> bool {
    let known: [&[&str]; 7] =
        [&TABLES, &SPREADSHEETS, &PROGRAMS, &SCRIPTS, &MEASURED, &TEXTS, &OWN];
    !name.ends_with(LAYOUT_ENDING) && known.iter().any(|endings| ends_with_one_of(name, endings))
}

impl LibraryKind {
    /// The name of several of it, for people.
    #[must_use]
    pub fn several(self) -> &'static str {
        match self {
            Self::Tool => text!("Cutters"),
            Self::Material => text!("Materials"),
            Self::Machine => text!("Machines"),
            Self::Structure => text!("Structures at the tool's tip"),
            Self::Part => text!("Parts"),
            Self::Program => text!("Programs (G-code)"),
            Self::Script => text!("Scripts"),
            Self::Scenario => text!("Scenarios"),
            Self::Formula => text!("Formulas"),
            Self::Mission => text!("Missions"),
            Self::Measured => text!("Measured data"),
            Self::Table => text!("Tables"),
            Self::Networks => text!("Networks of UNKS"),
            Self::Search => text!("Saved searches"),
            Self::Result => text!("Results of missions"),
            Self::Unreadable => text!("Not readable"),
        }
    }

    /// The kind of a file of one's own.
    #[must_use]
    pub fn of_own(kind: OwnFileKind) -> Self {
        match kind {
            OwnFileKind::Tool => Self::Tool,
            OwnFileKind::Structure => Self::Structure,
            OwnFileKind::Material => Self::Material,
            OwnFileKind::Machine => Self::Machine,
        }
    }

    /// The kind of file of one's own, where it is one.
    #[must_use]
    pub fn own(self) -> Option<OwnFileKind> {
        OwnFileKind::ALL.iter().copied().find(|kind| Self::of_own(*kind) == self)
    }

    /// The kind that a file is opened as. A table with times may be measured data as well:
    /// [`Self::looked_into`] tells that.
    #[must_use]
    pub fn opened_as(name: &str, contents: &[u8]) -> Self {
        if ends_with_one_of(name, &SPREADSHEETS) {
            return Self::Table;
        }
        if ends_with_one_of(name, &TABLES) {
            let is_part = decode(contents).is_ok_and(|text| PartPath::is_meant_by(&text));
            return if is_part { Self::Part } else { Self::Table };
        }
        if ends_with_one_of(name, &MEASURED) {
            return Self::Measured;
        }
        if ends_with_one_of(name, &PROGRAMS) {
            return Self::Program;
        }
        if ends_with_one_of(name, &SCRIPTS) {
            return Self::Script;
        }
        match decode(contents) {
            Ok(text) if ends_with_one_of(name, &["json"]) => Self::of_json(&text),
            Ok(text) => Self::of_toml(&text),
            Err(_) => Self::Unreadable,
        }
    }

    /// The kind of a file, where what can be measured data is read as such.
    #[must_use]
    pub fn looked_into(name: &str, contents: &[u8]) -> Self {
        let opened = Self::opened_as(name, contents);
        let is_text = ends_with_one_of(name, &TEXTS);
        let may_be = opened == Self::Table && ends_with_one_of(name, &TABLES)
            || is_text && !decode(contents).is_ok_and(|text| text.parse::<toml::Table>().is_ok());
        if may_be && is_measured(contents) { Self::Measured } else { opened }
    }

    fn of_json(text: &str) -> Self {
        let read = serde_json::from_str::<serde_json::Value>(text);
        let has = |key: &str| read.as_ref().is_ok_and(|file| file.get(key).is_some());
        if has("formula") && has("inputs") {
            Self::Formula
        } else if MissionResult::is_meant_by(text) {
            Self::Result
        } else if crate::identify::gp::state::GpState::is_meant_by(text) {
            Self::Search
        } else {
            Self::Networks
        }
    }

    fn of_toml(text: &str) -> Self {
        if Mission::is_meant_by(text) {
            return Self::Mission;
        }
        let Ok(table) = text.parse::<toml::Table>() else { return Self::Unreadable };
        if table.contains_key("formula") && table.contains_key("inputs") {
            return Self::Formula;
        }
        OwnFileKind::recognised(text).map_or(Self::Scenario, Self::of_own)
    }
}

/// Whether a table tells when its values were measured.
fn is_measured(contents: &[u8]) -> bool {
    let data = read(contents, &DataLayout::default());
    data.is_ok_and(|data| data.channels.iter().any(|channel| channel.times.at(0).is_some()))
}
