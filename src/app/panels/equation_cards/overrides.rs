//! The card of the overrides DNCFRO and DNCSPO: limits, whole percents, rate.

use super::formula::number;
use crate::base::equation::Live;
use crate::base::language::tr;
use crate::base::units::percent_from_ratio;
use crate::blocks::cutting::tool_path::ToolPath;
use crate::run::closed_loop::limits;
use crate::run::scenario::Scenario;
use crate::run::signals::{Row, flag};

/// One channel at the moment.
struct Channel {
    /// What the paper calls the override.
    name: &'static str,
    symbol: char,
    unit: &'static str,
    programmed: f64,
    range: [f64; 2],
    command: f64,
    percent: f64,
    saturated: bool,
    rate_limited: bool,
}

/// Both channels: each with its limits and, where they are switched on, whole percents and rate.
pub fn overrides(row: &Row, scenario: &Scenario) -> Vec<Live> {
    let cut = ToolPath::cut_of(&scenario.workpiece, row.position_mm);
    let (program, limits) = (scenario.programmed(cut), limits(scenario, cut));
    let feed = Channel {
        name: "DNCFRO",
        symbol: 'f',
        unit: "mm/min",
        programmed: program.feed_mm_min,
        range: limits.feed_mm_min,
        command: row.feed_command_mm_min,
        percent: row.feed_override_percent,
        saturated: row.has(flag::FEED_SATURATED),
        rate_limited: row.has(flag::FEED_RATE_LIMITED),
    };
    let spindle = Channel {
        name: "DNCSPO",
        symbol: 'n',
        unit: "1/min",
        programmed: program.speed_rpm,
        range: limits.speed_rpm,
        command: row.spindle_command_rpm,
        percent: row.spindle_override_percent,
        saturated: row.has(flag::SPEED_SATURATED),
        rate_limited: row.has(flag::SPEED_RATE_LIMITED),
    };
    let channels = [feed, spindle];
    let mut lines: Vec<Live> = channels.iter().map(|c| command(c, scenario)).collect();
    if scenario.cnc.override_rate_limited {
        lines.extend(channels.iter().map(|channel| ramp(channel, scenario)));
    }
    lines
}

/// The command that is sent, within its limits.
fn command(channel: &Channel, scenario: &Scenario) -> Live {
    let Channel { name, symbol, unit, programmed, .. } = *channel;
    let [low, high] = channel.range.map(|limit| number(percent_from_ratio(limit / programmed)));
    let limited = format!("limit({symbol} / {symbol}_p, {low}..{high} %)");
    let wanted = if scenario.cnc.override_rate_limited { tr("ramp") } else { &limited };
    let sent = if scenario.cnc.override_quantised {
        tr!("round({wanted}) to whole %", wanted = wanted)
    } else {
        wanted.to_owned()
    };
    let [least, most] = channel.range.map(number);
    Live {
        formula: format!("{symbol}_c = {name} · {symbol}_p,  {name} = {sent}"),
        values: format!(
            "{symbol}_c = {} % · {} = {} {unit}",
            number(channel.percent),
            number(programmed),
            number(channel.command)
        ),
        range: tr!(
            "{symbol} {low} to {high} {unit}",
            symbol = symbol,
            low = least,
            high = most,
            unit = unit
        ),
        valid: !channel.saturated,
    }
}

/// The ramp to what is wanted.
fn ramp(channel: &Channel, scenario: &Scenario) -> Live {
    let Channel { name, symbol, programmed, .. } = *channel;
    let rate = scenario.cnc.override_rate_percent_s;
    let period_s = scenario.control_period_s();
    let [low, high] = channel.range.map(|limit| number(percent_from_ratio(limit / programmed)));
    let [rate, period, step] = [rate, period_s, rate * period_s].map(number);
    let values = if channel.rate_limited {
        tr!(
            "rate T = {rate} %/s · {period} s = {step} %: {name} is on its way",
            rate = rate,
            period = period,
            step = step,
            name = name
        )
    } else {
        tr!(
            "rate T = {rate} %/s · {period} s = {step} %: {name} is arrived",
            rate = rate,
            period = period,
            step = step,
            name = name
        )
    };
    Live {
        formula: tr!(
            "ramp' = limit(wanted - ramp, ± rate T),  wanted = limit({symbol} / {symbol}_p, \
             {low}..{high} %)",
            symbol = symbol,
            low = low,
            high = high
        ),
        values,
        range: tr!("{name} reaches what is wanted within a period", name = name),
        valid: !channel.rate_limited,
    }
}
