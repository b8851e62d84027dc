//! Files of a user's own: cutter, structure, material, machine. Each is read, checked, and becomes settings of a
//! scenario, so that a run stays a pure function of its scenario.

mod entry;
mod limits;
mod machine;
mod material;
mod present;

pub use limits::OwnLimits;
pub use machine::{MachineFile, OwnTransfer};
pub use material::MaterialFile;
pub use present::{structure_file, tool_file};

use crate::base::language::tr;
use crate::base::settings::{Group, SettingError, Structure, Value};
use crate::models::tip_modes::TipModesFile;
use crate::models::tool::{Tool, ToolFile};

/// Version of the formats that begin here.
pub const OWN_FILE_VERSION: i64 = 1;

steadycut_core::choice! {
    /// What a file of one's own describes.
    pub enum OwnFileKind {
        /// A cutter, as the files in assets/tools.
        Tool = "tool", "cutter";
        /// The structure at the tool's tip as modes.
        Structure = "structure", "structure at the tool's tip";
        /// A material by Kienzle's constants.
        Material = "material", "material";
        /// Feed drive, spindle drive, dead time and limits of a machine.
        Machine = "machine", "machine";
    }
}

impl OwnFileKind {
    /// A file of this kind with every entry explained, to begin with.
    #[must_use]
    pub fn template(self) -> &'static str {
        match self {
            Self::Tool => include_str!("../../../../assets/tools/template.toml"),
            Self::Structure => include_str!("../../../../assets/structures/slender-cutter.toml"),
            Self::Material => include_str!("../../../../assets/materials/c60-example.toml"),
            Self::Machine => include_str!("../../../../assets/drives/example.toml"),
        }
    }

    /// What a file says it is by its entries; none where it is none of these.
    #[must_use]
    pub fn recognised(file: &str) -> Option<Self> {
        // Scenarios have sections of these names, too; but they name none of these entries at their top.
        let table: toml::Table = file.parse().ok()?;
        let has = |key: &str| table.contains_key(key);
        let limits = || has("title") && table.get("limits").is_some_and(toml::Value::is_table);
        let drive = |key: &str| {
            let inner = table.get(key).and_then(toml::Value::as_table);
            inner.is_some_and(|inner| {
                (inner.contains_key("poles") || inner.contains_key("denominator")) && has("title")
            })
        };
        if has("diameter_mm") && has("teeth") {
            Some(Self::Tool)
        } else if has("mode") && has("version") {
            Some(Self::Structure)
        } else if has("kc11_n_mm2") {
            Some(Self::Material)
        } else if has("poles") || drive("feed_drive") || drive("spindle_drive") || limits() {
            Some(Self::Machine)
        } else {
            None
        }
    }
}

/// A file of one's own, read: what it is called and the settings that it makes.
#[derive(Clone, Debug, PartialEq)]
pub struct OwnFile {
    /// What it describes.
    pub kind: OwnFileKind,
    /// What it is called.
    pub title: String,
    /// Where its values come from.
    pub source: String,
    /// The settings that it makes, by their paths.
    pub changes: Vec<(String, Value)>,
}

impl OwnFile {
    /// Reads a file of a kind.
    ///
    /// # Errors
    /// Names line, entry and value, and what is allowed.
    pub fn parse(kind: OwnFileKind, file: &str) -> Result<Self, SettingError> {
        let of = |title: String, source: String, changes| Self { kind, title, source, changes };
        Ok(match kind {
            OwnFileKind::Tool => {
                let ToolFile { title, source, tool } = ToolFile::parse(file)?;
                of(title, source, tool_changes(&tool))
            }
            OwnFileKind::Structure => {
                let TipModesFile { title, source, modes } = TipModesFile::parse(file)?;
                of(title, source, vec![("machine.tip_modes".to_owned(), Structure::write(&modes))])
            }
            OwnFileKind::Material => {
                let read = MaterialFile::parse(file)?;
                let changes = read.changes()?;
                of(read.title, read.source, changes)
            }
            OwnFileKind::Machine => {
                let read = MachineFile::parse(file)?;
                let changes = read.changes();
                of(read.title, read.source, changes)
            }
        })
    }

    /// Reads a file that says itself what it is.
    ///
    /// # Errors
    /// As [`Self::parse`]; it is none of these.
    pub fn read(file: &str) -> Result<Self, SettingError> {
        match OwnFileKind::recognised(file) {
            Some(kind) => Self::parse(kind, file),
            None => Err(SettingError::Format {
                what: tr("file of your own").to_owned(),
                problem: tr(
                    "it is none of a cutter (diameter_mm, teeth), a structure ([[mode]]), a material (kc11_n_mm2), \
                     a machine ([feed_drive], poles or [limits])",
                )
                .to_owned(),
            }),
        }
    }
}

/// All settings of a cutter but which shipped one it is.
fn tool_changes(tool: &Tool) -> Vec<(String, Value)> {
    let keys = Tool::specs().into_iter().map(|spec| spec.key).filter(|key| *key != "name");
    keys.filter_map(|key| Some((format!("tool.{key}"), tool.get(key)?))).collect()
}

#[cfg(test)]
mod tests;
