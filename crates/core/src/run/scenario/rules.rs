//! Rules between settings: a table, one row a rule. From it come the checks, what an edit must be
//! checked with, and `steadycut list`.

use super::groups::Settings;
use crate::base::language::{decimal, tr};
use crate::base::settings::SettingError;
use crate::blocks::cutting::tool_path::ToolPath;
use crate::blocks::cutting::workpiece::Workpiece;
use crate::models::disturbances::{CHATTER_RESOLVED, DEEPEST_MM};
use crate::models::genetic::{Calibration, ModelSet};
use crate::models::tip_modes::{TipAxis, TipModes};

/// Most rows that a run may record: a row takes 184 bytes, and 256 more where steps are left out; a console holds up to four recordings,
/// and a page in the browser has 4 GiB at most.
pub const MAX_ROWS: f64 = if cfg!(target_arch = "wasm32") { 1_000_000.0 } else { 4_000_000.0 };

/// Settings on the way to a scenario.
pub struct Candidate<'a> {
    pub(super) settings: &'a Settings,
    /// Whether the machine is to stand in the running cut and cannot be reduced for it.
    pub(super) overdamped: bool,
}

/// A rule between settings.
pub struct Rule {
    /// The settings that it joins; the first one is what is refused.
    pub paths: &'static [&'static str],
    /// The rule in words.
    pub words: &'static str,
    /// Whether the settings keep it.
    keeps: fn(&Candidate<'_>) -> bool,
    /// The value that breaks it, and what is allowed.
    broken: fn(&Settings) -> [String; 2],
}

/// All rules, in the order in which they are checked.
pub const RULES: &[Rule] = &[
    Rule {
        paths: &["plant.calibration", "plant.model_set", "formula.force", "formula.ra"],
        words: "own formulas of the plant's models are given where it is to cut by them",
        keeps: |c| {
            let Settings { plant, formula, .. } = c.settings;
            plant.calibration != Calibration::Formula
                || plant.model_set == ModelSet::Milling2005
                || formula.force.get().is_some()
                || formula.ra.get().is_some()
        },
        broken: |_| {
            [
                tr("formula without a formula for the plant").to_owned(),
                tr("formula together with `formula.force` or `formula.ra`: set both at once, or first \
                    the formula and last take it away")
                .to_owned(),
            ]
        },
    },
    Rule {
        paths: &[
            "belief.calibration",
            "belief.model_set",
            "formula.force_of_ra",
            "formula.feed",
            "formula.speed",
            "formula.force",
            "formula.ra",
        ],
        words: "own formulas are given where the controller is to believe in them",
        keeps: |c| {
            let Settings { belief, formula, .. } = c.settings;
            belief.calibration != Calibration::Formula
                || belief.model_set == ModelSet::Milling2005
                || !formula.has_no_model()
        },
        broken: |_| {
            [
                tr("formula without a formula").to_owned(),
                tr("formula together with one of `formula.force_of_ra`, `formula.feed`, \
                    `formula.speed`, `formula.force`, `formula.ra`: set both at once, or first the \
                    formula and last take it away")
                .to_owned(),
            ]
        },
    },
    Rule {
        paths: &["cnc.speed_min_rpm", "cnc.speed_max_rpm"],
        words: "the machine's least spindle speed is not above its largest",
        keeps: |c| c.settings.cnc.speed_min_rpm <= c.settings.cnc.speed_max_rpm,
        broken: |s| {
            [
                decimal(format!("{} 1/min", s.cnc.speed_min_rpm)),
                tr!("at most `cnc.speed_max_rpm`, {most} 1/min", most = s.cnc.speed_max_rpm),
            ]
        },
    },
    Rule {
        paths: &["plant.force_model", "run.control_period_ms", "run.steps_per_control"],
        words: "tooth by tooth the plant step is short enough to meet every tooth",
        keeps: |c| c.settings.dt_s() <= c.settings.plant.force_model.longest_step_s(),
        broken: |s| {
            let (model, longest_s) = (s.plant.force_model, s.plant.force_model.longest_step_s());
            let steps = (s.control_period_s() / longest_s).ceil();
            [
                tr!("{model} with plant steps of {step} s", model = model.id(), step = s.dt_s()),
                tr!(
                    "plant steps of at most {longest} s: `run.steps_per_control` from {steps} on \
                     (576 give 28.8 kHz)",
                    longest = longest_s,
                    steps = steps
                ),
            ]
        },
    },
    Rule {
        paths: &["machine.tip_modes", "machine.coupled"],
        words: "measured modes in the running cut are 1 to 4 across the feed, slow enough for its steps",
        keeps: |c| !c.settings.machine.coupled || tip_modes_run(&c.settings.machine.tip_modes),
        broken: |s| {
            let across = s.machine.tip_modes.along(TipAxis::Y).count();
            [
                tr!("{n} modes across the feed with `machine.coupled` = true", n = across),
                tr!(
                    "1 to 4 modes across the feed (axis 1) there, of at most {most} Hz: ten steps of 0.1 ms to a \
                     period",
                    most = MOST_TIP_HZ
                ),
            ]
        },
    },
    Rule {
        paths: &[
            "machine.parameters",
            "machine.coupled",
            "machine.variant",
            "machine.spindle_quality",
        ],
        words: "a machine in the running cut has no overdamped modes",
        keeps: |c| !c.overdamped,
        broken: |s| {
            let parameters = s.machine.parameters.id();
            [
                tr!(
                    "{parameters} with `machine.coupled` = true (overdamped modes)",
                    parameters = parameters
                ),
                tr("D or T in a coupled run").to_owned(),
            ]
        },
    },
    Rule {
        paths: &["wear.adjust_speed", "machine.coupled"],
        words: "the speed is adjusted by the sound of a machine in the cut",
        keeps: |c| !c.settings.wear.adjust_speed || c.settings.machine.coupled,
        broken: |_| {
            [
                tr("true without the machine's sound").to_owned(),
                tr("true with `machine.coupled` = true").to_owned(),
            ]
        },
    },
    Rule {
        paths: &["controller.unks.networks", "controller.unks.start"],
        words: "networks belong to the start, and so to the law, that they were learned with",
        keeps: |c| {
            let unks = &c.settings.controller.unks;
            unks.networks.get().is_none_or(|stored| stored.start == unks.start)
        },
        broken: |s| {
            let unks = &s.controller.unks;
            let start = unks.networks.get().map_or("none", |stored| stored.start.id());
            [
                tr!("networks of the start `{start}`", start = start),
                tr!(
                    "networks of `controller.unks.start`, {wanted}, or none; set both together",
                    wanted = unks.start.id()
                ),
            ]
        },
    },
    Rule {
        paths: &["tool.corner_radius_mm", "tool.diameter_mm", "tool.shape"],
        words: "the corner of a bull nose is at most half its diameter",
        keeps: |c| c.settings.tool.corner_too_large_mm().is_none(),
        broken: |s| {
            [
                decimal(format!("{} mm", s.tool.corner_radius_mm)),
                tr!(
                    "at most half of `tool.diameter_mm`, {half} mm",
                    half = 0.5 * s.tool.diameter_mm
                ),
            ]
        },
    },
    Rule {
        paths: &[
            "workpiece.radial_depth_mm",
            "workpiece.radial_steps",
            "tool.diameter_mm",
            "workpiece.cuts",
        ],
        words: "the path is not wider than the cutter",
        keeps: |c| {
            let Settings { workpiece, tool, .. } = c.settings;
            !workpiece.cuts.is_empty() || widest_mm(workpiece) <= tool.diameter_mm
        },
        broken: |s| {
            [
                decimal(format!("{} mm", widest_mm(&s.workpiece))),
                tr!("at most `tool.diameter_mm`, {diameter} mm", diameter = s.tool.diameter_mm),
            ]
        },
    },
    Rule {
        paths: &["disturbances.broken_teeth", "tool.teeth"],
        words: "a cutter keeps a tooth",
        keeps: |c| {
            let Settings { disturbances, tool, .. } = c.settings;
            (disturbances.broken_teeth.zones().len() as u32) < tool.teeth
        },
        broken: |s| {
            let (most, teeth) = (s.tool.teeth - 1, s.tool.teeth);
            [
                tr!("{n} broken teeth", n = s.disturbances.broken_teeth.zones().len()),
                tr!(
                    "at most {most}, one fewer than `tool.teeth`, {teeth}",
                    most = most,
                    teeth = teeth
                ),
            ]
        },
    },
    Rule {
        paths: &["disturbances.broken_teeth", "machine.coupled"],
        words: "a machine in the running cut has all its teeth",
        keeps: |c| {
            let Settings { disturbances, machine, .. } = c.settings;
            !machine.coupled || disturbances.broken_teeth.zones().is_empty()
        },
        broken: |s| {
            [
                tr!(
                    "{n} with `machine.coupled` = true",
                    n = s.disturbances.broken_teeth.zones().len()
                ),
                tr("none there: the machine's regeneration and the marks of the teeth count every tooth")
                    .to_owned(),
            ]
        },
    },
    Rule {
        paths: &[
            "disturbances.chatter_hz",
            "disturbances.chatter_bursts",
            "run.control_period_ms",
            "run.steps_per_control",
        ],
        words: "plant steps are short enough to show the chatter",
        keeps: |c| {
            let bursts = c.settings.disturbances.chatter_bursts.zones();
            bursts.is_empty() || c.settings.disturbances.chatter_hz <= most_chatter_hz(c.settings)
        },
        broken: |s| {
            [
                tr!(
                    "{frequency} Hz with bursts and plant steps of {step} s",
                    frequency = s.disturbances.chatter_hz,
                    step = s.dt_s()
                ),
                tr!(
                    "at most {most:.1} Hz, three steps to a period; more `run.steps_per_control` allow more",
                    most = most_chatter_hz(s)
                ),
            ]
        },
    },
    Rule {
        paths: &[
            "disturbances.depth_steps",
            "disturbances.gaps",
            "workpiece.axial_depth_mm",
            "workpiece.depth_steps",
            "workpiece.cuts",
        ],
        words: "a part that surprises is nowhere deeper than a cut may be",
        keeps: |c| {
            c.settings.disturbances.depth_steps.zones().is_empty()
                || deepest_mm(c.settings) <= DEEPEST_MM
        },
        broken: |s| {
            [
                tr!("so much: the cut would be {deepest} mm deep", deepest = deepest_mm(s)),
                tr!(
                    "what leaves it at most {most} mm deep everywhere, with \
                     `workpiece.axial_depth_mm` or the depth of the cuts",
                    most = DEEPEST_MM
                ),
            ]
        },
    },
    Rule {
        paths: &["noise.band_low_hz", "noise.band_high_hz"],
        words: "the band begins below its end",
        keeps: |c| c.settings.noise.band_low_hz < c.settings.noise.band_high_hz,
        broken: |s| {
            [
                decimal(format!("{} Hz", s.noise.band_low_hz)),
                tr!("below `noise.band_high_hz`, {high} Hz", high = s.noise.band_high_hz),
            ]
        },
    },
    Rule {
        paths: &["run.record_every", "run.steps_per_control"],
        words: "every control sample is recorded",
        keeps: |c| c.settings.run.steps_per_control.is_multiple_of(c.settings.run.record_every),
        broken: |s| {
            let steps = s.run.steps_per_control;
            [
                s.run.record_every.to_string(),
                tr!(
                    "a divisor of `run.steps_per_control`, {steps}: every control sample is recorded",
                    steps = steps
                ),
            ]
        },
    },
    Rule {
        paths: &[
            "run.duration_s",
            "run.control_period_ms",
            "run.steps_per_control",
            "run.record_every",
        ],
        words: "the rows of a run fit into memory",
        keeps: |c| c.settings.run.duration_s / row_s(c.settings) <= MAX_ROWS,
        broken: |s| {
            let (row_s, longest_s) = (row_s(s), MAX_ROWS * row_s(s));
            [
                decimal(format!("{} s", s.run.duration_s)),
                tr!(
                    "at most {longest} s with a row every {row} s ({rows} rows); record less often \
                     with `run.record_every`",
                    longest = longest_s,
                    row = row_s,
                    rows = MAX_ROWS
                ),
            ]
        },
    },
];

/// The highest natural frequency of a measured mode in the running cut, Hz: ten steps of the machine to a period.
const MOST_TIP_HZ: f64 = 1000.0;

/// Whether measured modes, or none, can stand in the running cut.
fn tip_modes_run(modes: &TipModes) -> bool {
    let mut across = modes.along(TipAxis::Y);
    let count = modes.along(TipAxis::Y).count();
    modes.is_empty()
        || ((1..=4).contains(&count) && across.all(|mode| mode.frequency_hz <= MOST_TIP_HZ))
}

/// The highest frequency of a chatter that the plant steps show, Hz.
fn most_chatter_hz(settings: &Settings) -> f64 {
    CHATTER_RESOLVED / settings.dt_s()
}

/// The largest depth of the disturbed part, mm.
fn deepest_mm(settings: &Settings) -> f64 {
    let Settings { workpiece, disturbances, tool, .. } = settings;
    ToolPath::new(workpiece, tool.outline()).disturbed(disturbances).depth_max_mm()
}

/// The largest radial depth of the one path, mm.
fn widest_mm(workpiece: &Workpiece) -> f64 {
    let steps = workpiece.radial_steps.iter().map(|step| step[1]);
    steps.fold(workpiece.radial_depth_mm, f64::max)
}

/// Time between two rows, s.
fn row_s(settings: &Settings) -> f64 {
    settings.dt_s() * f64::from(settings.run.record_every)
}

impl Candidate<'_> {
    /// Checks all rules.
    pub(super) fn check(&self) -> Result<(), SettingError> {
        let Some(rule) = RULES.iter().find(|rule| !(rule.keeps)(self)) else { return Ok(()) };
        let [value, allowed] = (rule.broken)(self.settings);
        Err(SettingError::Refused { path: rule.paths[0].to_owned(), value, allowed })
    }
}

/// Whether a rule joins this setting with others: whether an edit of it is allowed then depends
/// on the base and on other edits.
pub(in crate::run) fn joins(path: &str) -> bool {
    RULES.iter().any(|rule| rule.paths.contains(&path))
}
