//! Force coefficients, run-out and angle from the forces of a steady cut, tooth by tooth.

use std::fmt::Write as _;

use super::data::at;
use super::outcome::{FitEstimate, FitOutcome, FitPlot, left_over};
use super::request::{FitFault, FitOption, FitOptionKind, FitRequest, FitRole, FitValue, WITHIN};
use super::{FitAbout, FitAtWork, MeasuredFit};
use crate::base::language::{fixed, in_english, text, tr};
use crate::base::rng::Stream;
use crate::base::settings::Value;
use crate::blocks::control::ControllerKind;
use crate::identify::force::{
    ForceAxis, ForceRecording, ForceSearch, RecordedCut, identified_scenario,
};
use crate::models::tool::ShippedTool;
use crate::run::edits::Edits;
use crate::run::one_run::Run;
use crate::run::revolution::{MAX_TURNS, revolution};
use crate::run::scenario::Scenario;

/// The fit.
#[derive(Debug)]
pub struct ForceFromData;

const fn force(
    option: &'static str,
    label: &'static str,
    about: &'static str,
    names: &'static [&'static str],
    words: &'static [&'static str],
) -> FitRole {
    FitRole { option, label, about, what: text!("a force"), unit: "N", needed: false, names, words }
}

/// Along the feed.
pub const FX: FitRole = force(
    "fx",
    text!("Force along the feed"),
    text!("The channel with the force on the tool along the feed, in N or kN."),
    &["fx_n", "fx"],
    &["fx", "force_x", "kraft_x", "sila_x"],
);
/// Across the feed.
pub const FY: FitRole = force(
    "fy",
    text!("Force across the feed"),
    text!(
        "The channel with the force on the tool across the feed, towards where teeth enter the cut."
    ),
    &["fy_n", "fy"],
    &["fy", "force_y", "kraft_y", "sila_y"],
);
/// Along the axis.
pub const FZ: FitRole = force(
    "fz",
    text!("Force along the axis"),
    text!("The channel with the force on the tool along its axis, away from the tip."),
    &["fz_n", "fz"],
    &["fz", "force_z", "kraft_z", "sila_z"],
);
/// Its size across the tool.
pub const ACROSS: FitRole = force(
    "across",
    text!("Size across the tool"),
    text!(
        "The channel with the size of the force across the tool, sqrt(Fx^2 + Fy^2), where its components were not recorded."
    ),
    &[],
    &[],
);
/// The forces on the workpiece.
pub const ON_WORKPIECE: FitOption = FitOption {
    option: "on-workpiece",
    label: text!("Forces on the workpiece"),
    about: text!(
        "The forces are those on the workpiece, as of a dynamometer below it: their signs are turned."
    ),
    unit: "",
    kind: FitOptionKind::Switch,
};
/// Another cutter.
pub const TOOL: FitOption = FitOption {
    option: "tool",
    label: text!("Cutter"),
    about: text!("Another cutter than the scenario's."),
    unit: "",
    kind: FitOptionKind::Choice(tools),
};

fn tools() -> Vec<(&'static str, String)> {
    let own = ("", tr("the scenario's").to_owned());
    let shipped = ShippedTool::ALL.iter().map(|tool| (tool.id(), tr(tool.label()).to_owned()));
    std::iter::once(own).chain(shipped).collect()
}

const fn other(
    option: &'static str,
    label: &'static str,
    about: &'static str,
    unit: &'static str,
    path: &'static str,
) -> FitOption {
    FitOption { option, label, about, unit, kind: FitOptionKind::Setting(path) }
}

/// Another feed.
pub const OTHER_FEED: FitOption = other(
    "feed",
    text!("Feed"),
    text!("Another feed than the scenario's, mm/min."),
    "mm/min",
    "program.feed_mm_min",
);
/// Another spindle speed.
pub const OTHER_SPEED: FitOption = other(
    "speed",
    text!("Spindle speed"),
    text!("Another spindle speed than the scenario's, 1/min."),
    "1/min",
    "program.spindle_rpm",
);
/// Another axial depth.
pub const AXIAL_DEPTH: FitOption = other(
    "axial-depth",
    text!("Axial depth"),
    text!("Another axial depth than the scenario's, mm."),
    "mm",
    "workpiece.axial_depth_mm",
);
/// Another radial depth.
pub const RADIAL_DEPTH: FitOption = other(
    "radial-depth",
    text!("Radial depth"),
    text!("Another radial depth than the scenario's, mm; a slot has that of the whole cutter."),
    "mm",
    "workpiece.radial_depth_mm",
);

const fn hold(option: &'static str, label: &'static str) -> FitOption {
    FitOption {
        option,
        label,
        about: text!(
            "Keep exponents of Kienzle's laws as the steel has them, where the cut does not tell them."
        ),
        unit: "",
        kind: FitOptionKind::Switch,
    }
}

/// Which exponents are kept, by the letters of their laws.
pub const HOLD: [FitOption; 3] = [
    hold("hold-c", text!("Keep m_c of the steel")),
    hold("hold-r", text!("Keep m_r of the steel")),
    hold("hold-a", text!("Keep m_a of the steel")),
];

/// The cut that was recorded: the scenario as the options have it.
///
/// # Errors
/// A value that a setting does not take; a part of several sections without the depths of the one that was recorded.
pub fn cut_of(request: &FitRequest) -> Result<Scenario, FitFault> {
    let mut scenario = request.scenario.clone();
    if let Some(id) = request.id(&TOOL).filter(|id| !id.is_empty()) {
        let set = scenario.set("tool.name", Value::Text(id.to_owned()));
        set.map_err(|error| FitFault::at(TOOL.option, error.to_string()))?;
    }
    for option in [OTHER_FEED, OTHER_SPEED, AXIAL_DEPTH, RADIAL_DEPTH] {
        if let (FitOptionKind::Setting(path), Some(value)) = (option.kind, request.number(&option)?)
        {
            let set = scenario.set(path, Value::Float(value));
            set.map_err(|error| FitFault::at(option.option, error.to_string()))?;
        }
    }
    if !scenario.workpiece.cuts.is_empty() {
        let said = |option: &FitOption| {
            request
                .values
                .iter()
                .any(|(name, value)| *name == option.option && matches!(value, FitValue::Number(_)))
        };
        if !said(&AXIAL_DEPTH) || !said(&RADIAL_DEPTH) {
            let text = tr!(
                "{scenario}: `workpiece.cuts` has several sections: give --axial-depth and --radial-depth of the one that was recorded",
                scenario = scenario.info.name
            );
            return Err(FitFault::at(AXIAL_DEPTH.option, text));
        }
        let none = Value::List(Vec::new());
        scenario.set("workpiece.cuts", none).map_err(|error| error.to_string())?;
    }
    Ok(scenario)
}

/// The recorded forces of a request, and the cut that they are of.
///
/// # Errors
/// As [`cut_of`]; channels that are not there, no forces, not even in time, not whole, or of different times.
pub fn recorded(
    request: &FitRequest,
    scenario: &Scenario,
) -> Result<(ForceRecording, RecordedCut), FitFault> {
    let named = |problem: String| format!("{}: {problem}", scenario.info.name);
    let mut cut = RecordedCut::of(scenario).map_err(named)?;
    for (held, option) in cut.held_exponents.iter_mut().zip(&HOLD) {
        *held = request.is_on(option);
    }
    let sign = if request.is_on(&ON_WORKPIECE) { -1.0 } else { 1.0 };
    let asked = [
        (FX, ForceAxis::X, sign),
        (FY, ForceAxis::Y, sign),
        (FZ, ForceAxis::Z, sign),
        (ACROSS, ForceAxis::Across, 1.0),
    ];
    let within = request.span(&WITHIN)?;
    let mut first = None;
    let mut forces = Vec::new();
    for (role, axis, sign) in asked {
        let Some(channel) = request.even(&role)? else { continue };
        let values = at(&channel.within(within), &channel.values);
        forces.push((axis, values.iter().map(|x| sign * x).collect()));
        match &first {
            None => first = Some(channel),
            Some(first) => channel.goes_with(first)?,
        }
    }
    let period_s = first.map_or(0.0, |channel| 1.0 / channel.rate_hz);
    Ok((ForceRecording { period_s, forces }, cut))
}

/// The fit while it is worked at.
#[derive(Clone, Debug)]
pub struct ForceAtWork {
    search: ForceSearch,
    axes: Vec<ForceAxis>,
    file: String,
    scenario: Scenario,
    edits: Edits,
}

impl MeasuredFit for ForceFromData {
    const ABOUT: FitAbout = FitAbout {
        title: text!("Forces"),
        finds: text!(
            "Coefficients of the force model tooth by tooth (Kienzle's laws), the run-out of every tooth and the angle of the spindle."
        ),
        needs: text!(
            "Forces along and across the feed, or along the axis, of a steady cut over one turn of the spindle at least, some 60 samples a turn and more; the scenario is simulated tooth by tooth and has the cutter and the cut."
        ),
        sample: "steadycut run experiment-1 --revolution 2.5 > forces.csv",
        timed: true,
        roles: &[FX, FY, FZ, ACROSS],
        options: &[
            ON_WORKPIECE,
            TOOL,
            OTHER_FEED,
            OTHER_SPEED,
            AXIAL_DEPTH,
            RADIAL_DEPTH,
            HOLD[0],
            HOLD[1],
            HOLD[2],
            WITHIN,
        ],
        most_steps: 8,
    };
    type Work = ForceAtWork;

    fn lacks(request: &FitRequest) -> Option<FitFault> {
        let chosen = |role: &FitRole| request.chosen(role).is_some();
        if ![FX, FY, FZ, ACROSS].iter().any(chosen) {
            let text = tr("choose at least one force").to_owned();
            return Some(FitFault::at(FX.option, text));
        }
        if chosen(&ACROSS) && (chosen(&FX) || chosen(&FY)) {
            let text =
                tr("the size across the tool is for recordings without Fx and Fy").to_owned();
            return Some(FitFault::at(ACROSS.option, text));
        }
        None
    }

    fn begin(request: &FitRequest) -> Result<ForceAtWork, FitFault> {
        let scenario = cut_of(request)?;
        let (recording, cut) = recorded(request, &scenario)?;
        Ok(ForceAtWork {
            search: ForceSearch::new(&recording, &cut)?,
            axes: recording.forces.iter().map(|(axis, _)| *axis).collect(),
            file: request.file.clone(),
            scenario,
            edits: request.edits.clone(),
        })
    }

    /// The last turns before the middle of the cut at constant feed.
    fn sample(scenario: &Scenario, seed: u32) -> Result<String, String> {
        /// Noise as a share of the largest force.
        const NOISE: f64 = 0.01;
        RecordedCut::of(scenario)?;
        let steady = scenario
            .with(|s| {
                s.controller.kind = ControllerKind::ConstantFeed;
                s.noise.level = 0.0;
                s.run.duration_s = s.run.duration_s.min(3.0);
            })
            .map_err(|error| error.to_string())?;
        let run = Run::complete(&steady, &Edits::none());
        let end_s = run.ticks() as f64 * steady.dt_s();
        let turns = revolution(&run, 0.8 * end_s, MAX_TURNS);
        let samples = turns.map(|turns| turns.samples).unwrap_or_default();
        let largest = samples.iter().map(|sample| sample.fxy_n()).fold(0.0, f64::max);
        let stream = Stream::new(u64::from(seed), "recorded forces");
        let mut text = "time_s [s],fx_n [N],fy_n [N],fz_n [N]\n".to_owned();
        for (i, sample) in samples.iter().enumerate() {
            let noise = |k: u64| NOISE * largest * stream.normal(3 * i as u64 + k);
            let [x, y, z] =
                [sample.fx_n + noise(0), sample.fy_n + noise(1), sample.fz_n + noise(2)];
            // Into memory: it does not fail.
            let _ = writeln!(text, "{:.7},{x:.3},{y:.3},{z:.3}", sample.time_s);
        }
        Ok(text)
    }
}

impl FitAtWork for ForceAtWork {
    fn step(&mut self) -> bool {
        self.search.step()
    }

    fn outcome(&self) -> Result<FitOutcome, FitFault> {
        let fit = self.search.found()?;
        let mut estimates = Vec::new();
        for law in &fit.laws {
            let letter = law.letter;
            let at = fixed(fit.reference_mm, 3);
            estimates.extend([
                FitEstimate::new(format!("k_{letter}1.1"), law.k_n_mm2, 1, "N/mm^2"),
                FitEstimate::new(format!("m_{letter}"), law.exponent, 4, ""),
                FitEstimate::new(
                    tr!("k_{letter} at {at} mm", letter = letter, at = at),
                    law.at_reference_n_mm2,
                    1,
                    "N/mm^2",
                ),
            ]);
        }
        for (j, runout) in fit.runout_um.iter().enumerate() {
            let name = tr!("tooth {number} out of the mean", number = j + 1);
            estimates.push(FitEstimate::new(name, *runout, 3, "um"));
        }
        estimates.push(FitEstimate::new(tr("shift of the axis"), fit.shift_um, 3, "um"));
        estimates.push(FitEstimate::new(tr("first angle"), fit.phase_deg, 2, "deg"));
        let plot = |(c, axis): (usize, &ForceAxis)| FitPlot {
            title: axis.id().to_owned(),
            over: (tr("angle of the spindle").to_owned(), "deg"),
            unit: "N".to_owned(),
            points: fit
                .turn
                .iter()
                .map(|(angle, pairs)| [*angle, pairs[c][0], pairs[c][1]])
                .collect(),
            joined: true,
            logarithmic: false,
        };
        let source = format!("from {}", self.file);
        let made = in_english(|| identified_scenario(&self.scenario, &self.edits, &fit, &source));
        let (settings, file) = FitOutcome::accepted(made);
        let mut left = left_over(fit.rest_n, "N", fit.r2);
        left.push((tr("condition").to_owned(), fixed(fit.condition, 0)));
        Ok(FitOutcome {
            summary: tr!(
                "{samples} samples, {turns:.1} turns at {speed:.2} 1/min, laid over {places} places of a turn; laws k h^-m of this cut, h in mm",
                samples = fit.samples,
                turns = fit.turns,
                speed = fit.speed_rpm,
                places = fit.places
            ),
            estimates,
            table: None,
            left,
            notes: fit.notes(),
            plots: self.axes.iter().enumerate().map(plot).collect(),
            settings,
            file,
        })
    }
}
