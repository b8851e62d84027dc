//! `steadycut run`: one scenario, its metrics, its signals as CSV.

use std::io::Write;
use std::process::ExitCode;

use serde::Serialize;

use super::args::RunArgs;
use super::files::{InPath, report};
use super::scenarios::{apply, load, load_networks};
use super::twin::{TwinCut, TwinTold};
use super::{Outcome, given, own, part, profile, progress, story};
use crate::base::settings::Value;
use crate::blocks::control::ControllerKind;
use crate::blocks::control::script::ScriptProgram;
use crate::blocks::cutting::tool_path::ToolPath;
use crate::models::formula_model::FormulaModel;
use crate::models::genetic::{Calibration, FormulaSettings};
use crate::run::edits::Edits;
use crate::run::job::Job;
use crate::run::metrics::Metrics;
use crate::run::one_run::{End, Run};
use crate::run::presets;
use crate::run::revolution::RevolutionJob;
use crate::run::run_to::RunTo;
use crate::run::scenario::Scenario;
use crate::run::story::{Story, StoryEvent};
use crate::study::export::csv;
use crate::study::uses::Reader;

/// The JSON object of a run; with `--story` also its events, as `story`, and with `--twin` what it is compared with.
#[derive(Serialize)]
struct Report<'a> {
    scenario: &'a str,
    #[serde(flatten)]
    end: Ended<'a>,
    #[serde(flatten)]
    metrics: &'a Metrics,
    ticks: u64,
    digest: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    story: Option<Vec<StoryEvent>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    twin: Option<TwinTold>,
}

/// Why a run is over: `end`, an id of [`End`], `end_details` and, for people, `end_text`.
#[derive(Serialize)]
pub struct Ended<'a> {
    #[serde(flatten)]
    end: &'a End,
    end_text: String,
}

impl<'a> Ended<'a> {
    /// The end of a run.
    pub fn new(end: &'a End) -> Self {
        Self { end, end_text: end.to_string() }
    }
}

/// Takes the formulas of `--formula`, and the calibrations that ask for those of models: the controller's, and the
/// plant's where it is one of the models that the plant has.
fn own_formulas(args: &RunArgs, scenario: &mut Scenario) -> Result<(), Box<dyn std::error::Error>> {
    let mut changes: Vec<(String, Value)> = Vec::new();
    let mut calibrations: Vec<&str> = Vec::new();
    for (role, file) in &args.formula {
        let path = if role.contains('.') { role.clone() } else { format!("formula.{role}") };
        if changes.iter().any(|(known, _)| *known == path) {
            return Err(format!("--formula {role} was given twice").into());
        }
        given::once("--formula", &[&path], &args.set)?;
        // Told with its place before it becomes a setting.
        let text = file.text()?;
        FormulaModel::parse(&text).map_err(|error| format!("{file}: {error}"))?;
        changes.push((path, Value::Text(text)));
        if FormulaSettings::OF_MODELS.contains(&role.as_str()) {
            calibrations.push("belief.calibration");
        }
        if FormulaSettings::OF_PLANT.contains(&role.as_str()) {
            calibrations.push("plant.calibration");
        }
    }
    given::once("--formula", &calibrations, &args.set)?;
    let given: Vec<String> = changes.iter().map(|(path, _)| path.clone()).collect();
    calibrations.sort_unstable();
    calibrations.dedup();
    for path in calibrations {
        changes.push((path.to_owned(), Value::Text(Calibration::Formula.id().to_owned())));
    }
    scenario.set_all(&changes)?;
    for path in given {
        if let Some(because) = scenario.unused(&path)? {
            return Err(format!("--formula: a run has no use for `{path}`: {because}").into());
        }
    }
    Ok(())
}

/// Takes the script of `--script`, and lets it control.
pub fn own_script(
    file: Option<&InPath>,
    sets: &[String],
    scenario: &mut Scenario,
) -> Result<(), Box<dyn std::error::Error>> {
    let Some(file) = file else { return Ok(()) };
    given::once("--script", &["controller.kind", "controller.script.code"], sets)?;
    // Told with its line before it becomes a setting.
    let text = file.text()?;
    ScriptProgram::read(&text).map_err(|problem| format!("{file}: {problem}"))?;
    scenario.set_all(&[
        ("controller.kind".to_owned(), Value::Text(ControllerKind::Script.id().to_owned())),
        ("controller.script.code".to_owned(), Value::Text(text)),
    ])?;
    Ok(())
}

pub fn execute(args: &RunArgs) -> Outcome {
    let (mut scenario, edits) = load(&args.scenario)?;
    let brought = own::take(
        &mut scenario,
        Some(&args.own_cut),
        Some(&args.own_machine),
        Some(&args.own_structure),
    )?;
    apply(&mut scenario, &args.set)?;
    part::take(&mut scenario, args.part.as_ref(), &args.set)?;
    if let Some(path) = &args.networks {
        if scenario.controller.kind != ControllerKind::Unks {
            let kind = scenario.controller.kind.id();
            return Err(format!(
                "--networks: `controller.kind` is {kind}, which has no networks; \
                 --set controller.kind=unks chooses the one that has"
            )
            .into());
        }
        given::once("--networks", &given::LEARNED, &args.set)?;
        load_networks(&mut scenario, path)?;
    }
    own_formulas(args, &mut scenario)?;
    own_script(args.script.as_ref(), &args.set, &mut scenario)?;
    if let Some(kind) = args.twin {
        given::once("--twin", &["twin.kind"], &args.set)?;
        scenario.set("twin.kind", Value::Text(kind.id().to_owned()))?;
    }
    let beside = args.story || args.twin.is_some();
    let reader = match (args.profile, args.revolution) {
        (Some(_), _) => Reader::RunProfile,
        (None, Some(_)) => Reader::RunRevolution,
        (None, None) if beside => Reader::RunTwin,
        (None, None) => Reader::Run,
    };
    // Edits of the file must still fit the changed scenario.
    let (checked, unfit) = edits.fitted(&scenario);
    if let Some(unfit) = unfit.first() {
        return Err(unfit.to_string().into());
    }
    own::all_used(reader, &scenario, &checked, &args.set, &brought)?;
    if let Some(at_s) = args.revolution {
        return print_revolution(&scenario, &checked, at_s);
    }
    if let Some(line) = args.profile {
        return profile::execute(&scenario, &checked, line, args.cut, args.json);
    }
    let mut out = report(args.json, args.out.as_ref())?;
    let mut run = Run::new(&scenario, &checked);
    progress::work(&mut run, "run", args.json)?;

    let beside = beside.then(|| TwinCut::of(&run, args.json)).transpose()?;
    let story =
        beside.as_ref().filter(|_| args.story).map(|twin| Story::of(&run, Some(twin.run())));
    let twin = beside.as_ref().filter(|_| args.twin.is_some()).map(|twin| twin.told(&run));
    let (metrics, end) = (run.metrics(), end_of(&run)?);
    if args.json {
        let report = Report {
            scenario: &scenario.info.name,
            end: Ended::new(end),
            metrics: &metrics,
            ticks: run.ticks(),
            digest: run.recording().digest(),
            story: story.map(|story| story.events),
            twin,
        };
        writeln!(out, "{}", serde_json::to_string_pretty(&report)?)?;
    } else {
        print_metrics(&mut out, &scenario, &run, &metrics, end)?;
        if let Some(twin) = &twin {
            twin.print(&mut out)?;
        }
        if let Some(story) = &story {
            story::print(&mut out, story)?;
        }
    }
    if let Some(path) = &args.out {
        let mut file = path.create()?;
        csv::write(&mut file, run.recording()).map_err(|error| file.failed(error))?;
        file.keep()?;
        if !args.json {
            writeln!(out, "signals written to {path}")?;
        }
    }
    // A fault is a failure of the run, not of the program: its own exit code.
    Ok(if end.failed() { ExitCode::from(1) } else { ExitCode::SUCCESS })
}

/// The forces within the last revolution before `at_s`, as CSV.
fn print_revolution(scenario: &Scenario, edits: &Edits, at_s: f64) -> Outcome {
    let refused = |problem: String| format!("--revolution {at_s}: {problem}");
    if !(0.0..=scenario.run.duration_s).contains(&at_s) {
        let longest = scenario.run.duration_s;
        return Err(refused(format!("allowed is a time from 0 to {longest} s")).into());
    }
    let at = scenario.ticks(at_s);
    let mut way = RunTo::new(scenario, edits, at);
    progress::work(&mut way, "run", false)?;
    let run = way.run();
    if run.ticks() < at {
        let end_s = run.ticks() as f64 * scenario.dt_s();
        return Err(refused(format!("the run ends at {end_s:.3} s ({})", end_of(run)?)).into());
    }
    let mut job = RevolutionJob::new(run, at_s, 1, None);
    progress::work(&mut job, "revolution", false)?;
    let found = job.partial().ok_or_else(|| {
        let needed = "`plant.force_model = \"mechanistic\"` and plant steps of at most 0.1 ms";
        refused(format!("the force is not simulated tooth by tooth there; that takes {needed}"))
    })?;
    csv::write_samples(&mut std::io::stdout().lock(), &found.samples)?;
    Ok(ExitCode::SUCCESS)
}

/// Why a run is over.
pub fn end_of(run: &Run) -> Result<&End, &'static str> {
    run.end().ok_or("the run is not over")
}

fn shown(value: Option<f64>, text: &dyn Fn(f64) -> String) -> String {
    value.map_or("no contact".to_owned(), text)
}

/// A deviation with what it is one of. That is no setting: edits move the target, and a force that is held belongs to a
/// roughness of its own.
fn deviation_told(percent: f64, produced_um: Option<f64>) -> String {
    let of = produced_um.map(|ra_um| ra_um / (1.0 + percent / 100.0));
    let of = of
        .filter(|um| um.is_finite())
        .map_or(String::new(), |of_um| format!(" of {} um", (of_um * 1e4).round() / 1e4));
    format!("{percent:+.2} %{of}")
}

fn print_metrics(
    out: &mut impl Write,
    scenario: &Scenario,
    run: &Run,
    m: &Metrics,
    end: &End,
) -> std::io::Result<()> {
    writeln!(out, "{} ({})", scenario.info.name, scenario.controller.kind.label())?;
    if !scenario.info.description.is_empty() {
        // What was set otherwise may be other than its text says.
        let shipped = if presets::is_changed(scenario) { "as shipped: " } else { "" };
        writeln!(out, "{shipped}{}", scenario.info.description)?;
    }
    let dead_ticks = scenario.ticks(scenario.cnc.dead_time_s);
    let settled = m.settling_time_s.map_or("not settled".to_owned(), |time_s| {
        format!("{time_s:.3} s, within 2 % of its reference")
    });
    let tolerance = scenario.target.tolerance_percent;
    let not_judged = match m.not_judged_percent {
        Some(share) if share >= 0.05 => format!(", {share:.1} % not judged: outside the model"),
        Some(_) | None => String::new(),
    };
    // With a force and without roughness its model has ended.
    let ra_shown = |value: Option<f64>, text: &dyn Fn(f64) -> String| match m.force_final_n {
        Some(_) => value.map_or("outside model".to_owned(), text),
        None => shown(value, text),
    };
    let lines = [
        ("Ra produced", ra_shown(m.ra_final_um, &|x| format!("{x:.4} um"))),
        ("  deviation", ra_shown(m.ra_deviation_percent, &|x| deviation_told(x, m.ra_final_um))),
        (
            "  in tolerance",
            shown(m.in_tolerance_percent, &|x| {
                let shaken = m.in_tolerance_dyn_percent.map_or(String::new(), |shaken| {
                    format!(" without dynamics, {shaken:.1} % with")
                });
                format!("{x:.1} % of length{shaken} (+-{tolerance} %){not_judged}")
            }),
        ),
        ("force", shown(m.force_final_n, &|x| format!("{x:.2} N"))),
        ("  deviation", shown(m.force_deviation_percent, &|x| format!("{x:+.2} %"))),
        ("  worst after 1 s", shown(m.force_worst_percent, &|x| format!("{x:+.2} %"))),
        ("  largest", format!("{:.2} N", m.max_force_n)),
        ("  normalised std. error", shown(m.normalized_standard_error, &|x| format!("{x:.4}"))),
        ("  over 20 samples", shown(m.normalized_standard_error_20, &|x| format!("{x:.4}"))),
        ("  settling", settled),
        ("  overshoot", shown(m.overshoot_percent, &|x| format!("{x:.2} % of its reference"))),
        ("feed", format!("{:.2} mm/min", m.feed_final_mm_min)),
        ("spindle speed", format!("{:.1} 1/min", m.spindle_final_rpm)),
        ("time of cut", format!("{:.3} s", m.time_of_cut_s)),
        ("path", format!("{:.2} of {} mm", m.path_mm, ToolPath::length_of(&scenario.workpiece))),
        ("metal removed", format!("{:.3} cm3", m.metal_removed_cm3)),
        (
            "scrap",
            format!("{:.2} mm, at {:.2}; the cut at {:.2}", m.scrap_mm, m.scrap_cost, m.cut_cost),
        ),
        ("at a limit", format!("{:.1} % of time", m.saturated_percent)),
        ("models outside range", format!("{:.1} % of time", m.outside_percent)),
        ("dead time", format!("{} s ({dead_ticks} ticks)", dead_ticks as f64 * scenario.dt_s())),
        ("end", end.to_string()),
        ("ticks", run.ticks().to_string()),
        ("digest", run.recording().digest()),
    ];
    for (name, value) in lines {
        writeln!(out, "  {name:<24}{value}")?;
    }
    Ok(())
}
