//! The equations of a block at one moment: the formula of the active calibration, then with the
//! values put in. Every result comes from the model or the row, never from the text.

use super::Block;
use super::control::controller;
use super::formula::{number, sum};
use super::machine::{marks, vibration};
use super::models::{desired_force, roughness};
use super::overrides::overrides;
pub use crate::base::equation::Live;
use crate::base::language::tr;
use crate::base::units::percent_from_ratio;
use crate::models::formula_model::FormulaModel;
use crate::models::structure::RoughnessFrom;
use crate::models::transfer::TransferPoles;
use crate::run::explanation::{explain_force, of_own};
use crate::run::scenario::Scenario;
use crate::run::signals::Row;

/// The state of the loop that a card is filled from.
#[derive(Clone, Copy, Debug)]
pub struct Moment<'a> {
    /// The row at the playhead.
    pub row: &'a Row,
    /// The scenario with all edits up to the playhead.
    pub scenario: &'a Scenario,
    /// What leaves the dead-time queue: feed command in mm/min and speed command in 1/min.
    pub delayed: [f64; 2],
}

/// The equations of `block` at this moment.
#[must_use]
pub fn live(block: Block, moment: &Moment<'_>) -> Vec<Live> {
    let Moment { row, scenario, delayed } = *moment;
    let belief = scenario.believed();
    let plant = scenario.of_plant();
    match block {
        Block::Reference => vec![desired_force(&belief, row)],
        Block::Controller => controller(&belief, row, scenario),
        Block::Override => overrides(row, scenario),
        Block::DeadTime => dead_time(row, scenario, delayed),
        Block::FeedDrive => {
            let own = scenario.feed_drive.curve.get();
            let own = own.map(|own| reached(own, ["f_{rest}", "f_c"], delayed[0]));
            own.into_iter().chain([feed_drive(row, scenario, delayed[0])]).collect()
        }
        Block::SpindleDrive => {
            let own = scenario.spindle_drive.curve.get();
            let own = own.map(|own| reached(own, ["n_{rest}", "n_c"], delayed[1]));
            own.into_iter().chain([spindle_drive(row, scenario, delayed[1])]).collect()
        }
        Block::Cutting => explain_force(scenario, row),
        Block::Dynamic if scenario.machine.coupled => {
            vec![dynamic(row, scenario), vibration(row, scenario)]
        }
        Block::Dynamic => vec![dynamic(row, scenario)],
        Block::Dynamometer => vec![dynamometer(row, scenario)],
        Block::Surface => vec![roughness(&plant, row.force_n, "Ra", "F")],
        Block::SurfaceDynamic
            if scenario.machine.coupled
                && scenario.machine.roughness_from == RoughnessFrom::Vibration =>
        {
            vec![marks(row)]
        }
        Block::SurfaceDynamic => {
            vec![roughness(&plant, row.force_dyn_n, "Ra_{dyn}", "F_{dyn}")]
        }
    }
}

fn dead_time(row: &Row, scenario: &Scenario, delayed: [f64; 2]) -> Vec<Live> {
    let dead_s = scenario.cnc.dead_time_s;
    let line = |symbol: &str, now: f64, then: f64, unit: &str| {
        Live::everywhere(
            tr!("{symbol}_c delayed by {time} s", symbol = symbol, time = number(dead_s)),
            tr!("in {now}, out {then} {unit}", now = number(now), then = number(then), unit = unit),
        )
    };
    vec![
        line("f", row.feed_command_mm_min, delayed[0], "mm/min"),
        line("n", row.spindle_command_rpm, delayed[1], "1/min"),
    ]
}

/// What a drive reaches at rest, by a formula of one's own.
fn reached(own: &FormulaModel, [symbol, input]: [&str; 2], command: f64) -> Live {
    of_own(own, symbol, &[(input, command)], own.at(&[command]))
}

/// A drive of one's own: K over the product of its lags, what it was asked for and what it does.
fn own_drive(
    poles: &TransferPoles,
    gain: f64,
    symbol: &str,
    [command, actual]: [f64; 2],
    unit: &str,
) -> Live {
    let pole = |[re, im]: &[f64; 2]| match *im == 0.0 {
        true => number(*re),
        false => format!("{} ± {}i", number(*re), number(*im)),
    };
    let poles: Vec<String> = poles.all().iter().map(pole).collect();
    Live::everywhere(
        format!(
            "{symbol}_a / {symbol}_c = {} / Π (1 - s / p_i)  (p = {})",
            number(gain),
            poles.join(", ")
        ),
        tr!(
            "{symbol}_c = {command} gives {symbol}_a = {actual} {unit}",
            symbol = symbol,
            command = number(command),
            actual = number(actual),
            unit = unit
        ),
    )
}

fn feed_drive(row: &Row, scenario: &Scenario, command: f64) -> Live {
    let own = &scenario.feed_drive;
    if !own.poles.is_empty() {
        return own_drive(&own.poles, own.gain, "f", [command, row.feed_mm_min], "mm/min");
    }
    let kind = scenario.feed_drive.kind;
    let ([a0, a1, a2], order) = kind.denominator();
    let polynomial = match order {
        1 => sum(&[(1.0, "s"), (a0, "")]),
        2 => sum(&[(1.0, "s^2"), (a1, "s"), (a0, "")]),
        _ => sum(&[(1.0, "s^3"), (a2, "s^2"), (a1, "s"), (a0, "")]),
    };
    Live::everywhere(
        format!("f_a / f_c = {} / ({polynomial})  ({})", number(a0), tr(kind.label())),
        tr!(
            "f_c = {command} gives f_a = {feed} mm/min",
            command = number(command),
            feed = number(row.feed_mm_min)
        ),
    )
}

fn spindle_drive(row: &Row, scenario: &Scenario, command: f64) -> Live {
    let drive = &scenario.spindle_drive;
    if !drive.poles.is_empty() {
        return own_drive(&drive.poles, drive.gain, "n", [command, row.spindle_rpm], "1/min");
    }
    let (tau, rate) = (drive.time_constant_s, drive.rate_rpm_s);
    let asked = (command - row.spindle_rpm) / tau;
    let slope = asked.max(-rate).min(rate);
    Live {
        formula: format!(
            "n_a' = limit((n_c - n_a) / {} s, ± {} 1/min/s)",
            number(tau),
            number(rate)
        ),
        values: format!(
            "n_a' = limit(({} - {}) / {}) = {} 1/min/s",
            number(command),
            number(row.spindle_rpm),
            number(tau),
            number(slope.round())
        ),
        range: tr!("a straight ramp beyond {error} 1/min of error", error = number(rate * tau)),
        valid: asked == slope,
    }
}

fn dynamic(row: &Row, scenario: &Scenario) -> Live {
    let noise = &scenario.noise;
    let share = if row.force_n > 0.0 { row.force_dyn_n / row.force_n - 1.0 } else { 0.0 };
    Live::everywhere(
        tr!(
            "level {level}: band {band} %, ripple {ripple} %, inhomogeneity {inhomogeneity} %",
            level = number(noise.level),
            band = number(noise.band_percent),
            ripple = number(noise.ripple_percent),
            inhomogeneity = number(noise.inhomogeneity_percent)
        ),
        format!(
            "F_{{dyn}} = {} · (1 + {} %) = {} N",
            number(row.force_n),
            number(percent_from_ratio(share)),
            number(row.force_dyn_n)
        ),
    )
}

fn dynamometer(row: &Row, scenario: &Scenario) -> Live {
    let deviation = scenario.noise.level * scenario.noise.sensor_n;
    let symbol = "F_{dyn}";
    Live::everywhere(
        tr!(
            "F_m = {symbol} + noise of {deviation} N (standard deviation)",
            symbol = symbol,
            deviation = number(deviation)
        ),
        tr!(
            "F_m = {measured} N, held since the last sample; {symbol} now {force} N",
            measured = number(row.force_measured_n),
            symbol = symbol,
            force = number(row.force_dyn_n)
        ),
    )
}

#[cfg(test)]
mod repeat;
#[cfg(test)]
mod tests;
