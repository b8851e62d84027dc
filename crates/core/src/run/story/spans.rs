//! What lasts for a while and is seen in the state flags: limits, ranges of models, chatter. Short gaps
//! are closed, since noise and a swing take a command to its limit and off it again and again.

use super::super::closed_loop::limits;
use super::super::diagram::Names;
use super::super::one_run::Run;
use super::super::scenario::Scenario;
use super::super::signals::{FLAGS, Row, flag};
use super::effects::Moment;
use super::figures::{Figures, LimitReached, LimitedCommand, ModelInput, RangeLeft, RangedInput};
use super::means::{deviation, shaken_deviation};
use super::scan::Scan;
use super::{EventKind, StoryEvent, chatter, words};
use crate::base::stats;
use crate::base::units::percent_from_ratio;
use crate::blocks::cutting::tool_path::ToolPath;

/// Gaps up to this are closed for limits and ranges, s (chosen).
const GAP_S: f64 = 5.0;

/// A span with the scenario as it stands where it begins.
struct Lasting<'a> {
    rows: &'a [Row],
    bit: u32,
    scenario: &'a Scenario,
    /// Every how many rows one is looked at.
    stride: usize,
    /// Time between rows, s.
    row_s: f64,
}

impl<'a> Lasting<'a> {
    fn first(&self) -> &'a Row {
        &self.rows[0]
    }

    /// Looked at for figures: one row of each control period, and the first.
    fn flagged(&self) -> impl Iterator<Item = &Row> {
        self.rows.iter().step_by(self.stride).filter(|row| row.has(self.bit))
    }

    fn share_percent(&self) -> f64 {
        let looked_at = self.rows.len().div_ceil(self.stride);
        percent_from_ratio(self.flagged().count() as f64 / looked_at as f64)
    }
}

/// The events of flags.
pub(super) fn tell(run: &Run, scan: &Scan, rows: &[Row], so_far: bool) -> Vec<StoryEvent> {
    let mut events = Vec::new();
    for (bit, command) in [
        (flag::FEED_SATURATED, LimitedCommand::Feed),
        (flag::SPEED_SATURATED, LimitedCommand::SpindleSpeed),
    ] {
        each(run, scan, rows, bit, |lasting, _| {
            events.extend([false, true].into_iter().filter_map(|upper| {
                let (reached, [first, last]) = limit_reached(lasting, command, upper)?;
                let sentence = words::limit(&reached, lasting.scenario);
                let figures = Figures::Limit(reached);
                Some(event(EventKind::Saturation, [first, last], figures, sentence))
            }));
        });
    }
    let mut surface: Vec<[f64; 2]> = Vec::new();
    for (number, bit) in [
        (1, flag::K1_OUTSIDE),
        (2, flag::K2_OUTSIDE),
        (3, flag::K3_OUTSIDE),
        (4, flag::K4_OUTSIDE),
        (5, flag::K5_OUTSIDE),
        (6, flag::K6_OUTSIDE),
    ] {
        each(run, scan, rows, bit, |lasting, last| {
            let [from_s, to_s] = [lasting.first().time_s, last.time_s];
            // Model 6 is model 5 with the vibration: it is told of where model 5 is not.
            let told = surface.iter().any(|[from, to]| *from <= to_s && from_s <= *to);
            if number == 6 && told {
                return;
            }
            if number == 5 {
                surface.push([from_s, to_s]);
            }
            let left = range_left(lasting, number);
            let sentence = words::outside(&left);
            let ends = [lasting.first(), last];
            events.push(event(EventKind::OutsideModel, ends, Figures::Outside(left), sentence));
        });
    }
    let row_s = run.recording().row_s();
    for span in chatter::spans(scan, rows, row_s) {
        let found = chatter::chatter(span, scan, rows, row_s, so_far);
        let sentence = words::chatter(&found);
        let ends = [&rows[span.first], &rows[span.last]];
        events.push(event(EventKind::Chatter, ends, Figures::Chatter(found), sentence));
    }
    events
}

/// Goes over the spans of a flag, with their last row.
fn each(run: &Run, scan: &Scan, rows: &[Row], bit: u32, mut tell: impl FnMut(&Lasting<'_>, &Row)) {
    let row_s = run.recording().row_s();
    let stride = run.recording().control_stride();
    let mut moment = Moment::start(run);
    for span in scan.flagged(bit, (GAP_S / row_s) as usize) {
        moment.advance(rows[span.first].time_s);
        let scenario = &moment.scenario;
        let spanned = &rows[span.first..=span.last];
        tell(&Lasting { rows: spanned, bit, scenario, stride, row_s }, &rows[span.last]);
    }
}

fn event(
    id: EventKind,
    [first, last]: [&Row; 2],
    figures: Figures,
    sentence: String,
) -> StoryEvent {
    let (from_s, to_s, position_mm) = (first.time_s, last.time_s, first.position_mm);
    StoryEvent { id, from_s, to_s, position_mm, figures, sentence }
}

/// What stands at the lower or the upper limit in a span, with the first and last row that do.
fn limit_reached<'a>(
    lasting: &Lasting<'a>,
    command: LimitedCommand,
    upper: bool,
) -> Option<(LimitReached, [&'a Row; 2])> {
    let scenario = lasting.scenario;
    let cut = ToolPath::cut_of(&scenario.workpiece, lasting.first().position_mm);
    let limits = limits(scenario, cut);
    let values = |row: &Row| match command {
        LimitedCommand::Feed => (row.feed_command_mm_min, row.feed_override_percent),
        LimitedCommand::SpindleSpeed => (row.spindle_command_rpm, row.spindle_override_percent),
    };
    let [low, high] = match command {
        LimitedCommand::Feed => limits.feed_mm_min,
        LimitedCommand::SpindleSpeed => limits.speed_rpm,
    };
    let there = |row: &&Row| {
        let value = values(row).0;
        row.has(lasting.bit) && upper == ((high - value).abs() < (value - low).abs())
    };
    let first = lasting.rows.iter().find(there)?;
    let last = lasting.rows.iter().rfind(there)?;
    let looked_at = || lasting.rows.iter().filter(there).step_by(lasting.stride);
    let mean = |of: &dyn Fn(&Row) -> f64| stats::mean(looked_at().map(of)).unwrap_or(0.0);
    let target = &scenario.target;
    let deviations = looked_at().filter_map(|row| deviation(row, target.reference));
    let deviation_percent = stats::mean(deviations).map(percent_from_ratio);
    let deviations = looked_at().filter_map(shaken_deviation);
    let deviation_dyn_percent = stats::mean(deviations).map(percent_from_ratio);
    let inside = |percent: f64| percent.abs() <= target.tolerance_percent;
    let count = lasting.rows.iter().filter(there).count();
    let long = (last.time_s - first.time_s) / lasting.row_s + 1.0;
    let reached = LimitReached {
        command,
        upper,
        value: mean(&|row| values(row).0),
        override_percent: mean(&|row| values(row).1),
        share_percent: percent_from_ratio(count as f64 / long).min(100.0),
        deviation_percent,
        in_tolerance: deviation_percent.map(inside),
        deviation_dyn_percent,
        in_tolerance_dyn: deviation_dyn_percent.map(inside),
    };
    Some((reached, [first, last]))
}

/// The value furthest outside a range, where one is outside.
fn furthest(values: impl Iterator<Item = f64>, [low, high]: [f64; 2]) -> Option<f64> {
    let out = |x: f64| (low - x).max(x - high);
    let outside = values.filter(|x| out(*x) > 0.0);
    outside.reduce(|worst, x| if out(x) > out(worst) { x } else { worst })
}

fn range_left(lasting: &Lasting<'_>, number: u32) -> RangeLeft {
    let scenario = lasting.scenario;
    let info = FLAGS.iter().find(|info| info.bit == lasting.bit);
    let model = info.and_then(|info| Names::of(scenario).model_of(info)).unwrap_or_default();
    RangeLeft {
        model,
        number,
        gives: Names::gives(number),
        input: outside_input(lasting, number),
        share_percent: lasting.share_percent(),
    }
}

fn outside_input(lasting: &Lasting<'_>, number: u32) -> Option<RangedInput> {
    let scenario = lasting.scenario;
    let plant = &scenario.plant;
    let of_plant = scenario.of_plant();
    let belief = scenario.believed();
    let input = |name, unit, of: fn(&Row) -> f64, range: [f64; 2]| {
        let value = furthest(lasting.flagged().map(of), range)?;
        Some(RangedInput { name, unit, value, range })
    };
    match number {
        1 => input(ModelInput::TargetRa, "µm", |row| row.ra_target_um, belief.ra_range_um()),
        2 => {
            let range = belief.feed_range_n()?;
            input(ModelInput::ForceAskedFor, "N", |row| row.force_setpoint_n, range)
        }
        3 => input(
            ModelInput::ForceAskedFor,
            "N",
            |row| row.force_setpoint_n,
            belief.speed_range_n(),
        ),
        4 if plant.force_model.is_formula() => {
            let speed = |row: &Row| row.spindle_rpm;
            let [feed, turns] = of_plant.cut_ranges();
            input(ModelInput::Feed, "mm/min", |row| row.feed_mm_min, feed)
                .or_else(|| input(ModelInput::SpindleSpeed, "1/min", speed, turns))
        }
        5 => input(ModelInput::Force, "N", |row| row.force_n, of_plant.roughness_range_n()),
        6 => {
            let range = of_plant.roughness_range_n();
            input(ModelInput::ForceWithDynamics, "N", |row| row.force_dyn_n, range)
                .or_else(|| input(ModelInput::Force, "N", |row| row.force_n, range))
        }
        _ => None,
    }
}
