//! `steadycut identify force`.

use std::io::Write;
use std::process::ExitCode;

use clap::Args;
use serde_json::{Value, json};

use super::Outcome;
use super::args::one_of;
use super::files::{OutPath, ScenarioPath, report};
use super::identify_data::{DataArgs, settings_json, tell_settings, told, value_json};
use super::scenarios::load;
use crate::models::tool::ShippedTool;
use crate::study::identify::fits::force::{
    ACROSS, AXIAL_DEPTH, FX, FY, FZ, HOLD, ON_WORKPIECE, OTHER_FEED, OTHER_SPEED, RADIAL_DEPTH,
    TOOL, cut_of, recorded,
};
use crate::study::identify::fits::{FitFault, FitRequest, FitValue};
use crate::study::identify::force::{
    ForceFit, ForceRecording, identified_scenario, identify_force,
};

/// Arguments of `identify force`.
#[derive(Debug, Args)]
#[command(
    after_help = "Sample data: steadycut run SCENARIO --revolution AT_S > forces.csv has the channels fx_n, fy_n, fz_n \
    of a turn. The spindle speed need not be right to the last digit: within 0.5 % the one is found at which the turns \
    repeat. The cut is that of the model: up milling along a straight wall, steady."
)]
pub struct IdentifyForceArgs {
    /// The recording of a steady cut, from within it.
    #[command(flatten)]
    pub data: DataArgs,
    /// The channel with the force on the tool along the feed, in N or kN.
    #[arg(long, value_name = "CHANNEL", required_unless_present_any = ["fy", "fz", "across"])]
    pub fx: Option<String>,
    /// The channel with the force on the tool across the feed, towards where teeth enter the cut.
    #[arg(long, value_name = "CHANNEL")]
    pub fy: Option<String>,
    /// The channel with the force on the tool along its axis, away from the tip.
    #[arg(long, value_name = "CHANNEL")]
    pub fz: Option<String>,
    /// The channel with the size of the force across the tool, sqrt(Fx^2 + Fy^2), where its components were not recorded.
    #[arg(long, value_name = "CHANNEL", conflicts_with_all = ["fx", "fy"])]
    pub across: Option<String>,
    /// The forces are those on the workpiece, as of a dynamometer below it: their signs are turned.
    #[arg(long)]
    pub on_workpiece: bool,
    /// The scenario with cutter, cut and steel: tool, program.feed_mm_min, program.spindle_rpm, workpiece.axial_depth_mm,
    /// workpiece.radial_depth_mm, plant.slice_mm; its force is simulated tooth by tooth.
    #[arg(long, value_name = "PRESET|FILE|LINK")]
    pub scenario: ScenarioPath,
    /// Another cutter than the scenario's.
    #[arg(long, value_name = "TOOL", value_parser = one_of(ShippedTool::ALL, ShippedTool::id))]
    pub tool: Option<ShippedTool>,
    /// Another feed than the scenario's, mm/min.
    #[arg(long, value_name = "MM_MIN")]
    pub feed: Option<f64>,
    /// Another spindle speed than the scenario's, 1/min.
    #[arg(long, value_name = "RPM")]
    pub speed: Option<f64>,
    /// Another axial depth than the scenario's, mm.
    #[arg(long, value_name = "MM")]
    pub axial_depth: Option<f64>,
    /// Another radial depth than the scenario's, mm; a slot has that of the whole cutter.
    #[arg(long, value_name = "MM")]
    pub radial_depth: Option<f64>,
    /// Keep exponents of Kienzle's laws as the steel has them, where the cut does not tell them.
    #[arg(long, value_name = "c,r,a", value_delimiter = ',', value_parser = ["c", "r", "a"])]
    pub hold: Vec<String>,
    /// Where to write the scenario with what was identified, source and intervals in comments: `steadycut run FILE.toml`.
    #[arg(long, value_name = "FILE.toml")]
    pub out: Option<OutPath>,
    /// Print one JSON object, with the force over a turn.
    #[arg(long)]
    pub json: bool,
}

/// What is asked.
fn request(args: &IdentifyForceArgs) -> Result<FitRequest, Box<dyn std::error::Error>> {
    let (scenario, edits) = load(&args.scenario)?;
    let mut request = args.data.request(scenario, edits)?;
    for (role, name) in [(FX, &args.fx), (FY, &args.fy), (FZ, &args.fz), (ACROSS, &args.across)] {
        request = request.with_channel(&role, name.as_ref());
    }
    for (option, value) in [
        (OTHER_FEED, args.feed),
        (OTHER_SPEED, args.speed),
        (AXIAL_DEPTH, args.axial_depth),
        (RADIAL_DEPTH, args.radial_depth),
    ] {
        request = request.with_value(&option, value.map(FitValue::Number));
    }
    for (option, letter) in HOLD.iter().zip(["c", "r", "a"]) {
        let held = args.hold.iter().any(|name| name == letter);
        request = request.with_value(option, held.then_some(FitValue::On));
    }
    let tool = args.tool.map(|tool| FitValue::Id(tool.id().to_owned()));
    let on_workpiece = args.on_workpiece.then_some(FitValue::On);
    Ok(request.with_value(&TOOL, tool).with_value(&ON_WORKPIECE, on_workpiece))
}

pub fn execute(args: &IdentifyForceArgs) -> Outcome {
    let mut out = report(args.json, args.out.as_ref())?;
    let file = &args.data.data;
    let request = request(args)?;
    let told_fault = |fault: FitFault| args.data.told(&fault);
    let scenario = cut_of(&request).map_err(told_fault)?;
    let edits = request.edits.clone();
    let (recording, cut) = recorded(&request, &scenario).map_err(told_fault)?;
    let fit = identify_force(&recording, &cut).map_err(|problem| format!("{file}: {problem}"))?;
    let source = format!("from {file}");
    let (settings, text) = identified_scenario(&scenario, &edits, &fit, &source)?;
    if let Some(path) = &args.out {
        path.write(&text)?;
    }
    if args.json {
        let told = fit_json(&fit, &recording, settings_json(&settings), &file.to_string());
        writeln!(out, "{}", serde_json::to_string_pretty(&told)?)?;
        return Ok(ExitCode::SUCCESS);
    }
    writeln!(
        out,
        "{file}: {} samples, {:.1} turns at {:.2} 1/min, laid over {} places of a turn\n\
         Kienzle's laws k h^-m of this cut, h in mm; +- is half a 95 % interval\n",
        fit.samples, fit.turns, fit.speed_rpm, fit.places
    )?;
    for law in &fit.laws {
        let letter = law.letter;
        writeln!(out, "  k_{letter}1.1       {}", told(law.k_n_mm2, 1, "N/mm^2"))?;
        writeln!(out, "  m_{letter}          {}", told(law.exponent, 4, ""))?;
        let at = format!("{:.3} mm", fit.reference_mm);
        writeln!(out, "  k_{letter}({at}) {}", told(law.at_reference_n_mm2, 1, "N/mm^2"))?;
    }
    for (j, runout) in fit.runout_um.iter().enumerate() {
        writeln!(out, "  tooth {}      {}", j + 1, told(*runout, 3, "um out of the mean"))?;
    }
    writeln!(out, "  axis shifted {}", told(fit.shift_um, 3, "um (tool.runout_um)"))?;
    writeln!(out, "  first angle  {}", told(fit.phase_deg, 3, "deg"))?;
    writeln!(
        out,
        "  left         {:.3} N rms; R^2 {:.5}; condition {:.0}",
        fit.rest_n, fit.r2, fit.condition
    )?;
    for note in fit.notes() {
        writeln!(out, "\nnote: {note}")?;
    }
    tell_settings(&mut out, &settings, args.out.as_ref())?;
    Ok(ExitCode::SUCCESS)
}

fn fit_json(fit: &ForceFit, recording: &ForceRecording, settings: Value, file: &str) -> Value {
    let laws: Vec<Value> = fit
        .laws
        .iter()
        .map(|law| {
            json!({
                "letter": law.letter.to_string(),
                "k_n_mm2": value_json(law.k_n_mm2),
                "exponent": value_json(law.exponent),
                "at_reference_n_mm2": value_json(law.at_reference_n_mm2),
                "seen": law.seen,
            })
        })
        .collect();
    let column = |pick: &dyn Fn(&[[f64; 2]]) -> f64| {
        fit.turn.iter().map(|(_, pairs)| pick(pairs)).collect::<Vec<f64>>()
    };
    let forces: Vec<Value> = recording
        .forces
        .iter()
        .enumerate()
        .map(|(c, (axis, _))| {
            json!({
                "force": axis.id(),
                "measured_n": column(&|pairs| pairs[c][0]),
                "model_n": column(&|pairs| pairs[c][1]),
            })
        })
        .collect();
    json!({
        "data": file,
        "samples": fit.samples,
        "turns": fit.turns,
        "places": fit.places,
        "period_s": recording.period_s,
        "speed_rpm": fit.speed_rpm,
        "laws": laws,
        "reference_mm": fit.reference_mm,
        "runout_um": fit.runout_um.iter().map(|x| value_json(*x)).collect::<Vec<Value>>(),
        "shift_um": value_json(fit.shift_um),
        "shift_rest_um": fit.shift_rest_um,
        "phase_deg": value_json(fit.phase_deg),
        "rest_n": fit.rest_n,
        "r2": fit.r2,
        "repeated_r2": fit.repeated_r2,
        "misfit": fit.misfit,
        "condition": fit.condition,
        "not_apart": fit.not_apart,
        "notes": fit.notes(),
        "settings": settings,
        "turn": {
            "angle_deg": fit.turn.iter().map(|(angle, _)| *angle).collect::<Vec<f64>>(),
            "forces": forces,
        },
    })
}
