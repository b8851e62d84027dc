//! What a file of a kind says of itself, by the reader of its kind.

use std::sync::Arc;

use super::kind::LibraryKind;
use super::{LibraryHas, script_changes};
use crate::base::language::tr;
use crate::base::text::decode;
use crate::blocks::control::script::ScriptProgram;
use crate::csv_table::CsvCells;
use crate::formula_place::FormulaPlace;
use crate::measured::layout::DataLayout;
use crate::measured::reader::read;
use crate::mission::{Mission, MissionResult};
use crate::models::formula_model::FormulaModel;
use crate::models::tip_modes::TipModesFile;
use crate::models::tool::ToolFile;
use crate::models::unks::Stored;
use crate::own_file::{MachineFile, MaterialFile, OwnFile, OwnFileKind, OwnLimits, OwnTransfer};
use crate::part::PartPath;
use crate::part::gcode::GCodeProgram;
use crate::run::scenario::Scenario;
use crate::run::scenario_file;

/// Names that stand in a line at most; of more, how many there are.
const MOST_NAMES: usize = 4;

/// What a file says of itself.
#[derive(Default)]
pub(super) struct Facts {
    /// What it is called; may be empty.
    pub title: String,
    /// What it describes, in a line.
    pub facts: String,
    /// What a scenario has that uses it.
    pub has: LibraryHas,
}

fn told(error: impl std::fmt::Display) -> String {
    error.to_string()
}

/// Names beside each other, the first of many.
fn listed(names: &[String]) -> String {
    let shown = names.iter().take(MOST_NAMES).map(String::as_str).collect::<Vec<_>>().join(", ");
    match names.len().saturating_sub(MOST_NAMES) {
        0 => shown,
        more => tr!("{names} and {more} more", names = shown, more = more),
    }
}

impl Facts {
    /// Of a file of this kind.
    ///
    /// # Errors
    /// What is wrong with it, in the words of its reader.
    pub fn of(kind: LibraryKind, contents: &[u8]) -> Result<Self, String> {
        if kind == LibraryKind::Measured {
            return Self::of_measured(contents);
        }
        let text = decode(contents)?;
        match kind {
            LibraryKind::Tool
            | LibraryKind::Material
            | LibraryKind::Machine
            | LibraryKind::Structure => Self::of_own(&text),
            LibraryKind::Part => {
                let path = PartPath::read(&text)?;
                let mut changes = path.to_scenario(&Scenario::default())?.changes;
                // What comes with it depends on the scenario that takes it.
                changes.retain(|(path, _)| path.starts_with("workpiece."));
                let [deepest, _] = path.deepest_mm();
                let facts = tr!(
                    "{length:.1} mm long, at most {depth:.2} mm deep",
                    length = path.length_mm,
                    depth = deepest
                );
                Ok(Self { facts, has: LibraryHas::of(&changes)?, ..Self::default() })
            }
            LibraryKind::Program => {
                let moves = GCodeProgram::read(&text)?.moves.len();
                Ok(Self { facts: tr!("{n} moves", n = moves), ..Self::default() })
            }
            LibraryKind::Script => {
                ScriptProgram::read(&text).map_err(told)?;
                let facts = tr!("{n} lines", n = text.lines().count());
                Ok(Self { facts, has: LibraryHas::of(&script_changes(&text))?, ..Self::default() })
            }
            LibraryKind::Scenario => {
                let (scenario, edits) = scenario_file::parse(&text).map_err(told)?;
                let facts = tr!(
                    "{controller}, {length:.1} mm",
                    controller = tr(scenario.controller.kind.label()),
                    length = scenario.workpiece.length_mm
                );
                let title = scenario.info.name.clone();
                Ok(Self { title, facts, has: LibraryHas::Whole(Arc::new((scenario, edits))) })
            }
            LibraryKind::Formula => {
                let model = FormulaModel::parse(&text)?;
                let output = &model.output().name;
                let facts = format!("{output} = {}", model.formula());
                let fits = |place: &FormulaPlace| place.value(&model).is_ok();
                let places = FormulaPlace::ALL.iter().copied().filter(fits).collect();
                let has = LibraryHas::Formula(model.write_line(), places);
                Ok(Self { facts, has, ..Self::default() })
            }
            LibraryKind::Mission => {
                let Mission { title, about, .. } = Mission::read(&text).map_err(told)?;
                Ok(Self { title, facts: about, ..Self::default() })
            }
            LibraryKind::Table => {
                let names = CsvCells::whole(&text)?.names().to_vec();
                Ok(Self { facts: listed(&names), ..Self::default() })
            }
            LibraryKind::Networks => {
                Stored::parse(&text)?;
                Ok(Self::default())
            }
            LibraryKind::Result => {
                MissionResult::read(&text)?;
                Ok(Self::default())
            }
            LibraryKind::Search => Ok(Self::default()),
            LibraryKind::Unreadable => {
                // Its line, where it is no TOML.
                crate::base::files::from_toml::<toml::Table>(&text)?;
                Err(tr("it is none of the files that this program reads").to_owned())
            }
            LibraryKind::Measured => Self::of_measured(contents),
        }
    }

    fn of_measured(contents: &[u8]) -> Result<Self, String> {
        let data = read(contents, &DataLayout::default()).map_err(told)?;
        let names: Vec<String> = data.channels.iter().map(|channel| channel.title()).collect();
        Ok(Self { title: data.format.label().to_owned(), facts: listed(&names), ..Self::default() })
    }

    fn of_own(text: &str) -> Result<Self, String> {
        let OwnFile { kind, title, source: _, changes } = OwnFile::read(text).map_err(told)?;
        let facts = match kind {
            OwnFileKind::Tool => {
                let ToolFile { tool, .. } = ToolFile::parse(text).map_err(told)?;
                let (shape, d) = (tr(tool.shape.label()), tool.diameter_mm);
                match tool.teeth {
                    1 => tr!("{shape}, 1 tooth, {d} mm", shape = shape, d = d),
                    n => tr!("{shape}, {n} teeth, {d} mm", shape = shape, n = n, d = d),
                }
            }
            OwnFileKind::Structure => {
                let TipModesFile { modes, .. } = TipModesFile::parse(text).map_err(told)?;
                let hz = || modes.all().iter().map(|mode| mode.frequency_hz);
                let low = hz().fold(f64::INFINITY, f64::min);
                let high = hz().fold(0.0, f64::max);
                match modes.all().len() {
                    1 => tr!("1 mode, {hz:.0} Hz", hz = high),
                    n => tr!("{n} modes, {low:.0} to {high:.0} Hz", n = n, low = low, high = high),
                }
            }
            OwnFileKind::Material => {
                let file = MaterialFile::parse(text).map_err(told)?;
                tr!(
                    "k_c1.1 {kc11} N/mm², m_c {mc}, {hb} HB",
                    kc11 = file.kc11_n_mm2,
                    mc = file.mc,
                    hb = file.hardness_hb
                )
            }
            OwnFileKind::Machine => machine(&MachineFile::parse(text).map_err(told)?),
        };
        Ok(Self { title, facts, has: LibraryHas::of(&changes)? })
    }
}

/// What there is of a machine.
fn machine(file: &MachineFile) -> String {
    let order = |drive: &OwnTransfer| drive.poles.order();
    let parts = [
        file.feed_drive.as_ref().map(|x| tr!("feed drive of order {n}", n = order(x))),
        file.spindle_drive.as_ref().map(|x| tr!("spindle drive of order {n}", n = order(x))),
        file.dead_time_s.map(|s| tr!("dead time {s} s", s = s)),
        file.limits.as_ref().map(limits),
    ];
    parts.into_iter().flatten().collect::<Vec<String>>().join(", ")
}

/// How far a machine goes, by its feed where the file says that.
fn limits(limits: &OwnLimits) -> String {
    match limits.feed_max_mm_min {
        Some(feed) => tr!("limits, at most {feed} mm/min", feed = feed),
        None => tr("limits").to_owned(),
    }
}
