//! Files of one's own on the command line: `--tool`, `--structure`, `--material`, `--machine` where a scenario goes in,
//! and `steadycut own`, which begins and checks them, and lists the folder of one's own that the console lists, too.

mod list;

use std::io::Write;
use std::process::ExitCode;

use clap::{Args, Subcommand};
use serde_json::json;

use super::Outcome;
use super::args::one_of;
use super::files::{InFolder, InPath, OutPath};
use super::given;
use crate::run::edits::Edits;
use crate::run::scenario::Scenario;
use crate::study::own_file::{OwnFile, OwnFileKind};
use crate::study::plan::machine::MachineLimits;
use crate::study::uses::Reader;

/// A cutter and a material of one's own.
#[derive(Debug, Default, Args)]
pub struct OwnCutArgs {
    /// A cutter of one's own, as the files in assets/tools; `steadycut own new tool` begins one. `--set` overrules it.
    #[arg(long, value_name = "FILE.toml")]
    pub tool: Option<InPath>,
    /// A material of one's own by Kienzle's constants; `steadycut own new material` begins one. `--set` overrules it.
    #[arg(long, value_name = "FILE.toml")]
    pub material: Option<InPath>,
}

/// Drives and limits of a machine of one's own.
#[derive(Debug, Default, Args)]
pub struct OwnMachineArgs {
    /// Feed drive, spindle drive, dead time and limits of a machine of one's own, or the file that `steadycut identify drive`
    /// writes; `steadycut own new machine` begins one. `--set` overrules it.
    #[arg(long, value_name = "FILE.toml")]
    pub machine: Option<InPath>,
}

/// The structure at the tool's tip.
#[derive(Debug, Default, Args)]
pub struct OwnStructureArgs {
    /// The structure at the tool's tip as measured modes, in the place of the five masses; `steadycut own new structure`
    /// begins one. `--set` overrules it.
    #[arg(long, value_name = "FILE.toml")]
    pub structure: Option<InPath>,
}

/// The settings of files of one's own, each with the option that brings it.
pub type Brought = Vec<(&'static str, OwnFile)>;

fn read(
    option: &'static str,
    kind: OwnFileKind,
    path: Option<&InPath>,
) -> Result<Option<(&'static str, OwnFile)>, Box<dyn std::error::Error>> {
    let Some(path) = path else { return Ok(None) };
    let file = OwnFile::parse(kind, &path.text()?).map_err(|error| format!("{path}: {error}"))?;
    Ok(Some((option, file)))
}

/// Puts files of one's own into a scenario; what `--set` says comes after them.
pub fn take(
    scenario: &mut Scenario,
    cut: Option<&OwnCutArgs>,
    machine: Option<&OwnMachineArgs>,
    structure: Option<&OwnStructureArgs>,
) -> Result<Brought, Box<dyn std::error::Error>> {
    let files = [
        read("--tool", OwnFileKind::Tool, cut.and_then(|args| args.tool.as_ref()))?,
        read("--material", OwnFileKind::Material, cut.and_then(|args| args.material.as_ref()))?,
        read("--machine", OwnFileKind::Machine, machine.and_then(|args| args.machine.as_ref()))?,
        read(
            "--structure",
            OwnFileKind::Structure,
            structure.and_then(|args| args.structure.as_ref()),
        )?,
    ];
    let brought: Brought = files.into_iter().flatten().collect();
    for (option, file) in &brought {
        scenario.set_all(&file.changes).map_err(|error| format!("{option}: {error}"))?;
    }
    Ok(brought)
}

/// The machine that is planned for: that of a file of limits, as the papers' one; or the papers', as far as the machine
/// goes that a file of one's own puts into the scenario.
pub fn planned_machine(
    scenario: &mut Scenario,
    path: Option<&InPath>,
    brought: &mut Brought,
) -> Result<MachineLimits, Box<dyn std::error::Error>> {
    let Some(path) = path else { return Ok(MachineLimits::heller_bea_01()) };
    let text = path.text()?;
    if OwnFileKind::recognised(&text) != Some(OwnFileKind::Machine) {
        return Ok(MachineLimits::parse(&text).map_err(|error| format!("{path}: {error}"))?);
    }
    let file = OwnFile::parse(OwnFileKind::Machine, &text);
    let file = file.map_err(|error| format!("{path}: {error}"))?;
    scenario.set_all(&file.changes).map_err(|error| format!("--machine: {error}"))?;
    brought.push(("--machine", file));
    Ok(MachineLimits::heller_bea_01())
}

/// Refuses a file of one's own that a command has no use for at all; `scenario` has it already.
pub fn used(
    reader: Reader,
    scenario: &Scenario,
    edits: &Edits,
    brought: &Brought,
) -> Result<(), Box<dyn std::error::Error>> {
    for (option, file) in brought {
        let mut why = None;
        for (path, _) in &file.changes {
            match reader.unused_throughout(scenario, edits, path)? {
                None => {
                    why = None;
                    break;
                }
                Some(because) => why = Some((path, because)),
            }
        }
        if let Some((path, because)) = why {
            let command = reader.label();
            return Err(format!(
                "{option}: `{command}` has no use for it, as for `{path}`: {because}"
            )
            .into());
        }
    }
    Ok(())
}

/// Arguments of `own`.
#[derive(Debug, Args)]
pub struct OwnArgs {
    /// What to do.
    #[command(subcommand)]
    pub what: OwnWhat,
}

/// What `own` does.
#[derive(Debug, Subcommand)]
pub enum OwnWhat {
    /// Print a file to begin with, every entry explained.
    New(OwnNewArgs),
    /// Check a file: what it is, and the settings that it makes.
    Check(OwnCheckArgs),
    /// List a folder of files of one's own: what each is, what it describes, or what is wrong with it.
    List(OwnListArgs),
}

/// Arguments of `own new`.
#[derive(Debug, Args)]
pub struct OwnNewArgs {
    /// What the file describes.
    #[arg(value_parser = one_of(OwnFileKind::ALL, OwnFileKind::id))]
    pub kind: OwnFileKind,
    /// Write it to a file; without it, to standard output.
    #[arg(long, value_name = "FILE.toml")]
    pub out: Option<OutPath>,
}

/// Arguments of `own check`.
#[derive(Debug, Args)]
pub struct OwnCheckArgs {
    /// The file.
    #[arg(value_name = "FILE.toml")]
    pub file: InPath,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Arguments of `own list`.
#[derive(Debug, Args)]
pub struct OwnListArgs {
    /// The folder; without it, the one that the console lists under My files.
    #[arg(value_name = "FOLDER")]
    pub folder: Option<InFolder>,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Runs the command.
pub fn execute(args: &OwnArgs) -> Outcome {
    match &args.what {
        OwnWhat::New(args) => {
            let text = args.kind.template();
            match &args.out {
                Some(path) => path.write(text)?,
                None => write!(std::io::stdout().lock(), "{text}")?,
            }
        }
        OwnWhat::Check(args) => check(args)?,
        OwnWhat::List(args) => list::execute(args)?,
    }
    Ok(ExitCode::SUCCESS)
}

fn check(args: &OwnCheckArgs) -> Result<(), Box<dyn std::error::Error>> {
    let path = &args.file;
    let file = OwnFile::read(&path.text()?).map_err(|error| format!("{path}: {error}"))?;
    // Whether a scenario takes it at all.
    Scenario::default().set_all(&file.changes).map_err(|error| format!("{path}: {error}"))?;
    let mut out = std::io::stdout().lock();
    if args.json {
        let settings: serde_json::Map<String, serde_json::Value> =
            file.changes.iter().map(|(path, value)| (path.clone(), json!(value))).collect();
        let told = json!({
            "kind": file.kind, "title": file.title, "source": file.source, "settings": settings,
        });
        writeln!(out, "{}", serde_json::to_string_pretty(&told)?)?;
        return Ok(());
    }
    writeln!(out, "{path}: {}, {}", file.kind.label(), file.title)?;
    for (path, value) in &file.changes {
        let text = value.to_string();
        // The texts of formulas are of several lines.
        writeln!(out, "  {path} = {}", text.lines().next().unwrap_or_default())?;
    }
    Ok(())
}

/// Refuses `--set`s of a command that reads files of one's own, and files that it has no use for.
pub fn all_used(
    reader: Reader,
    scenario: &Scenario,
    edits: &Edits,
    sets: &[String],
    brought: &Brought,
) -> Result<(), Box<dyn std::error::Error>> {
    if brought.iter().any(|(option, _)| *option == "--tool") {
        given::once("--tool", &["tool.name"], sets)?;
    }
    given::all_used(reader, scenario, edits, sets)?;
    used(reader, scenario, edits, brought)
}
