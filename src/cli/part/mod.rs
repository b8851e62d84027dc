//! `steadycut part`: a part of one's own from a table or from G-code.

pub mod args;

use std::io::Write;
use std::process::ExitCode;

use args::{
    IntoScenarioArgs, PartArgs, PartFromCsvArgs, PartFromGcodeArgs, PartToCsvArgs, PartWhat,
};
use serde_json::{Value as Json, json};

use super::files::{InPath, OutPath, differ, report};
use super::scenarios::{apply, load};
use super::{Outcome, given, progress};
use crate::base::settings::Value;
use crate::run::edits::Edits;
use crate::run::scenario::{Scenario, param};
use crate::run::scenario_file;
use crate::study::part::PartPath;
use crate::study::part::gcode::GCodeProgram;
use crate::study::part::milling::{MilledPart, MillingJob};
use crate::study::uses::Reader;

/// What a part says of a scenario; time and rows besides, where they are not said.
const SAID: [&str; 6] = [
    "workpiece.cuts",
    "workpiece.length_mm",
    "workpiece.axial_depth_mm",
    "workpiece.radial_depth_mm",
    "workpiece.depth_steps",
    "workpiece.radial_steps",
];
/// Endings of programs: `--part` takes tables.
const PROGRAMS: [&str; 6] = [".nc", ".ngc", ".gcode", ".tap", ".cnc", ".mpf"];

pub fn execute(args: &PartArgs) -> Outcome {
    match &args.what {
        PartWhat::FromGcode(args) => from_gcode(args),
        PartWhat::FromCsv(args) => from_csv(args),
        PartWhat::ToCsv(args) => to_csv(args),
    }
}

/// Reads the table of a path.
fn read(file: &InPath) -> Result<PartPath, String> {
    let name = file.to_string().to_lowercase();
    if PROGRAMS.iter().any(|ending| name.ends_with(ending)) {
        return Err(format!(
            "{file} is a program: steadycut part from-gcode {file} --blank X,Y,Z --out part.csv makes a table of it"
        ));
    }
    PartPath::read(&file.text()?).map_err(|problem| format!("{file}: {problem}"))
}

/// Takes the part of `--part`, if there is one; what came with it is told on standard error.
pub fn take(
    scenario: &mut Scenario,
    part: Option<&InPath>,
    sets: &[String],
) -> Result<(), Box<dyn std::error::Error>> {
    let Some(file) = part else { return Ok(()) };
    for told in put("--part", scenario, &read(file)?, sets)? {
        eprintln!("{file}: {told}");
    }
    Ok(())
}

/// The same for a scenario with changes during its run, of which all have to go with the part.
pub fn take_with(
    scenario: &mut Scenario,
    edits: Edits,
    part: Option<&InPath>,
    sets: &[String],
) -> Result<Edits, Box<dyn std::error::Error>> {
    if part.is_none() {
        return Ok(edits);
    }
    take(scenario, part, sets)?;
    let (fitted, unfit) = edits.fitted(scenario);
    match unfit.first() {
        None => Ok(fitted),
        Some(unfit) => Err(format!("--part: {unfit}").into()),
    }
}

/// Refuses the part of `--part` where a command makes cuts of its own, and says why.
pub fn refuse(reader: Reader, part: Option<&InPath>, why: &str) -> Result<(), String> {
    let Some(file) = part else { return Ok(()) };
    Err(format!("--part {file}: `{}` has no use for it: {why}", reader.label()))
}

/// Puts a path into a scenario that has the `--set`s already; gives what came with it.
fn put(
    option: &str,
    scenario: &mut Scenario,
    path: &PartPath,
    sets: &[String],
) -> Result<Vec<String>, Box<dyn std::error::Error>> {
    given::once(option, &SAID, sets)?;
    let taken = path.to_scenario(scenario)?;
    let mut changes: Vec<(String, Value)> = Vec::new();
    for (path, value) in taken.changes {
        // Time and rows that are said are obeyed.
        let is_said = sets.iter().any(|set| {
            let said = set.split_once('=').map_or(set.as_str(), |(path, _)| path);
            param(said).is_ok_and(|param| param.path == path)
        });
        if !is_said {
            changes.push((path, value));
        }
    }
    scenario.set_all(&changes)?;
    Ok(taken.told)
}

/// The scenario that a part goes into, with what is set; refuses changes during its run.
fn scenario(into: &IntoScenarioArgs) -> Result<(Scenario, Edits), Box<dyn std::error::Error>> {
    let (mut scenario, edits) = load(&into.scenario)?;
    apply(&mut scenario, &into.set)?;
    Ok((scenario, edits))
}

/// Saves the scenario with its part.
fn save(
    into: &IntoScenarioArgs,
    scenario: &Scenario,
    edits: &Edits,
) -> Result<(), Box<dyn std::error::Error>> {
    let Some(path) = &into.save else { return Ok(()) };
    let (fitted, unfit) = edits.fitted(scenario);
    if let Some(unfit) = unfit.first() {
        return Err(unfit.to_string().into());
    }
    Ok(path.write(&scenario_file::write(scenario, &fitted))?)
}

fn from_gcode(args: &PartFromGcodeArgs) -> Outcome {
    let mut out = report(args.json, args.out.as_ref().or(args.into.save.as_ref()))?;
    let outputs: Vec<OutPath> = args.out.iter().chain(&args.into.save).cloned().collect();
    differ(&outputs)?;
    let (mut scenario, edits) = load(&args.into.scenario)?;
    if let Some(tool) = args.tool {
        given::once("--tool", &["tool.name"], &args.into.set)?;
        scenario.set("tool.name", Value::Text(tool.id().to_owned()))?;
    }
    apply(&mut scenario, &args.into.set)?;
    let wrong = |problem: String| format!("{}: {problem}", args.file);
    let program = GCodeProgram::read(&args.file.text()?).map_err(wrong)?;
    let mut job =
        MillingJob::new(&program, args.blank, scenario.tool.outline(), args.step).map_err(wrong)?;
    progress::work(&mut job, "milling", args.json)?;
    let part = job.part().ok_or("the program is not over")?;
    if let Some(path) = &args.out {
        path.write(&part.csv())?;
    }
    let mut remarks = part.remarks();
    let path = part.path();
    if args.into.save.is_some() {
        remarks.extend(put("--blank", &mut scenario, &path, &args.into.set)?);
        save(&args.into, &scenario, &edits)?;
    }
    if args.json {
        let mut told = told_as_json(&path, &remarks);
        told["steps"] = json!(part.rows.len());
        told["removed_mm3"] = json!(part.removed_mm3);
        told["counted_mm3"] = json!(part.counted_mm3);
        told["rapids_through_material"] = json!(part.rapids);
        told["plunges"] = json!(part.plunges);
        writeln!(out, "{}", serde_json::to_string_pretty(&told)?)?;
        return Ok(ExitCode::SUCCESS);
    }
    print(&mut out, &path, &[])?;
    print_volumes(&mut out, part)?;
    for remark in &remarks {
        writeln!(out, "  {remark}")?;
    }
    Ok(ExitCode::SUCCESS)
}

fn print_volumes(out: &mut dyn Write, part: &MilledPart) -> std::io::Result<()> {
    let MilledPart { removed_mm3, counted_mm3, .. } = part;
    writeln!(
        out,
        "  removed         {removed_mm3:.1} mm3 by the map, {counted_mm3:.1} mm3 as a_p a_e s"
    )
}

fn from_csv(args: &PartFromCsvArgs) -> Outcome {
    let mut out = report(args.json, args.into.save.as_ref())?;
    let (mut scenario, edits) = scenario(&args.into)?;
    let path = read(&args.file)?;
    let told = put("the table", &mut scenario, &path, &args.into.set)?;
    save(&args.into, &scenario, &edits)?;
    if args.json {
        writeln!(out, "{}", serde_json::to_string_pretty(&told_as_json(&path, &told))?)?;
    } else {
        print(&mut out, &path, &told)?;
    }
    Ok(ExitCode::SUCCESS)
}

fn to_csv(args: &PartToCsvArgs) -> Outcome {
    let (scenario, edits) = load(&args.scenario)?;
    if let Some(edit) = edits.list().iter().find(|edit| edit.path.starts_with("workpiece.")) {
        return Err(format!(
            "`{}` changes at {} s: the table would not say it",
            edit.path, edit.at_s
        )
        .into());
    }
    let text = PartPath::of(&scenario.workpiece)?.csv();
    match &args.out {
        Some(path) => path.write(&text)?,
        None => std::io::stdout().lock().write_all(text.as_bytes())?,
    }
    Ok(ExitCode::SUCCESS)
}

fn told_as_json(path: &PartPath, remarks: &[String]) -> Json {
    let [axial_mm, radial_mm] = path.deepest_mm();
    json!({
        "length_mm": path.length_mm,
        "stretches": path.stretches.len(),
        "air_mm": path.air_mm(),
        "axial_max_mm": axial_mm,
        "radial_max_mm": radial_mm,
        "remarks": remarks,
    })
}

fn print(out: &mut dyn Write, path: &PartPath, remarks: &[String]) -> std::io::Result<()> {
    let [axial_mm, radial_mm] = path.deepest_mm();
    writeln!(out, "path of {:.3} mm in {} stretches", path.length_mm, path.stretches.len())?;
    writeln!(out, "  air             {:.3} mm", path.air_mm())?;
    writeln!(out, "  axial depth     up to {axial_mm:.3} mm")?;
    writeln!(out, "  radial depth    up to {radial_mm:.3} mm")?;
    for remark in remarks {
        writeln!(out, "  {remark}")?;
    }
    Ok(())
}
