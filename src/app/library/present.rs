//! Files that are kept without having been opened: what the present cut has, and files to begin with.

use crate::app::files;
use crate::app::session::Session;
use crate::base::language::tr;
use crate::blocks::control::ControllerKind;
use crate::blocks::control::script::TEMPLATES;
use crate::run::scenario::Scenario;
use crate::run::scenario_file;
use crate::study::library::LibraryKind;
use crate::study::own_file::{structure_file, tool_file};
use crate::study::part::{EXAMPLE_CSV, EXAMPLE_GCODE, PartPath};

/// Kinds that are kept of the present cut.
pub const PRESENT: [LibraryKind; 5] = [
    LibraryKind::Scenario,
    LibraryKind::Tool,
    LibraryKind::Part,
    LibraryKind::Structure,
    LibraryKind::Script,
];

/// Kinds that a file is begun of.
pub const BEGUN: [LibraryKind; 7] = [
    LibraryKind::Tool,
    LibraryKind::Material,
    LibraryKind::Machine,
    LibraryKind::Structure,
    LibraryKind::Part,
    LibraryKind::Program,
    LibraryKind::Script,
];

/// Name and text of a file of what the present cut has.
///
/// # Errors
/// It has none, in words.
pub fn present(kind: LibraryKind, session: &Session) -> Result<(String, String), String> {
    let scenario = session.scenario();
    let called = files::called(scenario, session.edits());
    let source = format!("SteadyCut, scenario {called}");
    match kind {
        LibraryKind::Scenario => {
            let text = scenario_file::write(scenario, session.edits());
            Ok((files::file_name(&called, "toml"), text))
        }
        LibraryKind::Tool => {
            let tool = &scenario.tool;
            let shipped = tool.shipped_alike().map(|shipped| shipped.load().title);
            let title = shipped.unwrap_or_else(|| {
                let shape = tool.shape.label();
                format!("{shape}, {} mm, {} teeth", tool.diameter_mm, tool.teeth)
            });
            Ok((files::file_name(&title, "toml"), tool_file(tool, &title, &source)))
        }
        LibraryKind::Part => {
            let path = PartPath::of(&scenario.workpiece)?;
            Ok((files::file_name(&format!("part of {called}"), "csv"), path.csv()))
        }
        LibraryKind::Structure => {
            let text = structure_file(&scenario.machine.tip_modes, &called, &source);
            let text =
                text.ok_or_else(|| tr("the machine has the papers' five masses").to_owned())?;
            Ok((files::file_name(&format!("structure of {called}"), "toml"), text))
        }
        LibraryKind::Script => {
            let text = script(scenario)?;
            Ok((files::file_name(&format!("script of {called}"), "rhai"), text))
        }
        LibraryKind::Material
        | LibraryKind::Machine
        | LibraryKind::Program
        | LibraryKind::Formula
        | LibraryKind::Mission
        | LibraryKind::Measured
        | LibraryKind::Table
        | LibraryKind::Networks
        | LibraryKind::Search
        | LibraryKind::Result
        | LibraryKind::Unreadable => Err(tr("it is not kept from here").to_owned()),
    }
}

/// The script that controls the cut.
fn script(scenario: &Scenario) -> Result<String, String> {
    if scenario.controller.kind != ControllerKind::Script {
        return Err(tr("no script controls this cut").to_owned());
    }
    Ok(scenario.controller.script.code.text().to_owned())
}

/// Name and text of a file to begin with; none where there is none of its kind.
#[must_use]
pub fn begun(kind: LibraryKind) -> Option<(String, &'static str)> {
    let (ending, text) = match kind {
        LibraryKind::Part => ("csv", EXAMPLE_CSV),
        LibraryKind::Program => ("nc", EXAMPLE_GCODE),
        LibraryKind::Script => ("rhai", TEMPLATES[0].1),
        LibraryKind::Tool
        | LibraryKind::Material
        | LibraryKind::Machine
        | LibraryKind::Structure => ("toml", kind.own()?.template()),
        LibraryKind::Scenario
        | LibraryKind::Formula
        | LibraryKind::Mission
        | LibraryKind::Measured
        | LibraryKind::Table
        | LibraryKind::Networks
        | LibraryKind::Search
        | LibraryKind::Result
        | LibraryKind::Unreadable => return None,
    };
    Some((format!("my-{}.{ending}", kind.id()), text))
}
