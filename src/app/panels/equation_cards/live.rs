//! The equations of a block at one moment: the formula of the active calibration, then with the
//! values put in. Every result comes from the model or the row, never from the text.

use super::Block;
use super::formula::{number, sum};
use super::models::{controller, cutting, k1, k5};
use crate::base::model::gp::{Calibration, GpModels};
use crate::base::units::percent_from_ratio;
use crate::run::scenario::Scenario;
use crate::run::signals::{Row, flag};

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

/// One equation with its live values.
#[derive(Clone, Debug, PartialEq)]
pub struct Live {
    /// The formula with the coefficients that are in use.
    pub formula: String,
    /// The same with the values of the moment and the result.
    pub values: String,
    /// Where it holds; empty for an equation that holds everywhere.
    pub range: String,
    /// Whether the values lie within that range.
    pub valid: bool,
}

impl Live {
    /// An equation that holds everywhere.
    pub(super) fn everywhere(formula: impl Into<String>, values: impl Into<String>) -> Self {
        let (formula, values) = (formula.into(), values.into());
        Self { formula, values, range: String::new(), valid: true }
    }
}

impl Block {
    /// Whose models the block computes with and their calibration; `None` for a block without.
    #[must_use]
    pub fn calibration(self, scenario: &Scenario) -> Option<(&'static str, Calibration)> {
        match self {
            Self::Reference | Self::Controller => {
                Some(("the controller's belief", scenario.belief.calibration))
            }
            Self::Cutting | Self::Surface | Self::SurfaceDynamic => {
                Some(("the plant", scenario.plant.calibration))
            }
            _ => None,
        }
    }
}

/// The equations of `block` at this moment.
#[must_use]
pub fn live(block: Block, moment: &Moment<'_>) -> Vec<Live> {
    let Moment { row, scenario, delayed } = *moment;
    let belief = GpModels::new(scenario.belief.model_set, scenario.belief.calibration);
    match block {
        Block::Reference => vec![k1(&belief, row)],
        Block::Controller => controller(&belief, row, scenario),
        Block::Override => override_limits(row, scenario),
        Block::DeadTime => dead_time(row, scenario, delayed),
        Block::FeedDrive => vec![feed_drive(row, scenario, delayed[0])],
        Block::SpindleDrive => vec![spindle_drive(row, scenario, delayed[1])],
        Block::Cutting => cutting(row, scenario),
        Block::Dynamic => vec![dynamic(row, scenario)],
        Block::Dynamometer => vec![dynamometer(row, scenario)],
        Block::Surface => vec![k5(scenario, row.force_n, "Ra", "F")],
        Block::SurfaceDynamic => {
            vec![k5(scenario, row.force_dyn_n, "Ra_{dyn}", "F_{dyn}")]
        }
    }
}

fn override_limits(row: &Row, scenario: &Scenario) -> Vec<Live> {
    let cnc = &scenario.cnc;
    let (low, high) = (cnc.override_min_percent, cnc.override_max_percent);
    let line = |symbol: &str, command: f64, programmed: f64, bit: u32, unit: &str| Live {
        formula: format!("{symbol}_c = limit({symbol}, {low}..{high} %) of {symbol}_p"),
        values: format!(
            "{symbol}_c = {} % · {} = {} {unit}",
            number(percent_from_ratio(command / programmed)),
            number(programmed),
            number(command)
        ),
        range: format!(
            "{} to {} {unit}",
            number(cnc.range(programmed)[0]),
            number(cnc.range(programmed)[1])
        ),
        valid: !row.has(bit),
    };
    let program = &scenario.program;
    vec![
        line("f", row.feed_command_mm_min, program.feed_mm_min, flag::FEED_SATURATED, "mm/min"),
        line("n", row.spindle_command_rpm, program.spindle_rpm, flag::SPEED_SATURATED, "1/min"),
    ]
}

fn dead_time(row: &Row, scenario: &Scenario, delayed: [f64; 2]) -> Vec<Live> {
    let dead_s = scenario.cnc.dead_time_s;
    let line = |symbol: &str, now: f64, then: f64, unit: &str| {
        Live::everywhere(
            format!("{symbol}_c delayed by {} s", number(dead_s)),
            format!("in {}, out {} {unit}", number(now), number(then)),
        )
    };
    vec![
        line("f", row.feed_command_mm_min, delayed[0], "mm/min"),
        line("n", row.spindle_command_rpm, delayed[1], "1/min"),
    ]
}

fn feed_drive(row: &Row, scenario: &Scenario, command: f64) -> Live {
    let kind = scenario.feed_drive.kind;
    let ([a0, a1, a2], order) = kind.denominator();
    let polynomial = match order {
        1 => sum(&[(1.0, "s"), (a0, "")]),
        2 => sum(&[(1.0, "s^2"), (a1, "s"), (a0, "")]),
        _ => sum(&[(1.0, "s^3"), (a2, "s^2"), (a1, "s"), (a0, "")]),
    };
    Live::everywhere(
        format!("f_a / f_c = {} / ({polynomial})  ({})", number(a0), kind.label()),
        format!("f_c = {} gives f_a = {} mm/min", number(command), number(row.feed_mm_min)),
    )
}

fn spindle_drive(row: &Row, scenario: &Scenario, command: f64) -> Live {
    let drive = &scenario.spindle_drive;
    let (tau, rate) = (drive.time_constant_s, drive.rate_rpm_s);
    let asked = (command - row.spindle_rpm) / tau;
    let slope = asked.max(-rate).min(rate);
    Live {
        formula: format!("n_a' = limit((n_c - n_a) / {} s, ± {} rpm/s)", number(tau), number(rate)),
        values: format!(
            "n_a' = limit(({} - {}) / {}) = {} rpm/s",
            number(command),
            number(row.spindle_rpm),
            number(tau),
            number(slope.round())
        ),
        range: format!("a straight ramp beyond {} 1/min of error", number(rate * tau)),
        valid: asked == slope,
    }
}

fn dynamic(row: &Row, scenario: &Scenario) -> Live {
    let noise = &scenario.noise;
    let share = if row.force_n > 0.0 { row.force_dyn_n / row.force_n - 1.0 } else { 0.0 };
    Live::everywhere(
        format!(
            "level {}: band {} %, ripple {} %, inhomogeneity {} %",
            number(noise.level),
            number(noise.band_percent),
            number(noise.ripple_percent),
            number(noise.inhomogeneity_percent)
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
    Live::everywhere(
        format!("F_m = F_{{dyn}} + noise of {} N (standard deviation)", number(deviation)),
        format!(
            "F_m = {} N, held since the last sample; F_{{dyn}} now {} N",
            number(row.force_measured_n),
            number(row.force_dyn_n)
        ),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blocks::control::ControllerKind;
    use crate::run::edits::Edits;
    use crate::run::one_run::Run;
    use crate::run::presets;

    /// The number before the unit at the end of an equation's values.
    fn result(live: &Live) -> f64 {
        let after = live.values.rsplit(" = ").next().unwrap_or_default();
        let text = after.split(' ').next().unwrap_or_default();
        text.parse().unwrap_or_else(|_| panic!("no number ends {:?}", live.values))
    }

    fn near(live: &Live, value: f64) {
        let shown = result(live);
        assert!((shown - value).abs() <= 2e-3 * value.abs() + 1e-9, "{live:?}: {value}");
    }

    #[test]
    fn cards_show_what_the_run_recorded() {
        for calibration in Calibration::ALL {
            let mut scenario = presets::load("table3-5").expect("shipped");
            scenario.belief.calibration = *calibration;
            scenario.plant.calibration = *calibration;
            scenario.plant.wear_factor = 1.1;
            let run = Run::complete(&scenario, &Edits::none());
            let row = run.recording().rows().last().expect("a row");
            let delayed = [row.feed_command_mm_min, row.spindle_command_rpm];
            let moment = Moment { row, scenario: &scenario, delayed };
            near(&live(Block::Reference, &moment)[0], row.force_ref_n);
            near(&live(Block::Controller, &moment)[0], row.force_setpoint_n);
            let limits = live(Block::Override, &moment);
            near(&limits[0], row.feed_command_mm_min);
            near(&limits[1], row.spindle_command_rpm);
            near(&live(Block::FeedDrive, &moment)[0], row.feed_mm_min);
            near(&live(Block::Cutting, &moment)[1], row.force_n);
            near(&live(Block::Surface, &moment)[0], row.ra_um);
            near(&live(Block::SurfaceDynamic, &moment)[0], row.ra_dyn_um);
            for block in [Block::Reference, Block::Surface] {
                let lamp = block.card().lamps[0].bit;
                assert_eq!(live(block, &moment)[0].valid, !row.has(lamp), "{calibration:?}");
            }
        }
    }

    #[test]
    fn every_controller_explains_itself() {
        for kind in ControllerKind::ALL {
            let mut scenario = presets::load("depth-step").expect("shipped");
            scenario.controller.kind = *kind;
            let row = Row { gain_estimate: 1.0, force_ref_n: 180.0, ..Row::default() };
            let moment = Moment { row: &row, scenario: &scenario, delayed: [0.0; 2] };
            for card in super::super::CARDS {
                let lines = live(card.block, &moment);
                assert!(!lines.is_empty(), "{}", card.title);
                assert!(lines.iter().all(|line| !line.values.contains("NaN")), "{lines:?}");
            }
        }
    }
}
