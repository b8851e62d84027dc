//! The card of the controller: its law with the values of the moment.

use super::formula::number;
use super::live::Live;
use super::models::{feed, speed};
use crate::base::units::ratio_from_percent;
use crate::blocks::control::division::Divided;
use crate::blocks::control::mrac::Adapted;
use crate::blocks::control::{ControllerKind, FeedSpeed};
use crate::blocks::cutting::tool_path::ToolPath;
use crate::models::genetic::GeneticModels;
use crate::models::unks::UnksStart;
use crate::run::scenario::Scenario;
use crate::run::signals::{Row, flag};

/// The controller's law with its models 2 and 3.
pub fn controller(belief: &GeneticModels, row: &Row, scenario: &Scenario) -> Vec<Live> {
    let (desired, measured) = (row.force_ref_n, row.force_measured_n);
    match scenario.controller.kind {
        ControllerKind::ConstantFeed => {
            let cut = ToolPath::cut_of(&scenario.workpiece, row.position_mm);
            let program = scenario.programmed(cut);
            let settings = &scenario.constant_feed;
            let line = |symbol: &str, percent: f64, programmed: f64, unit: &str| {
                let result = programmed * ratio_from_percent(percent);
                Live::everywhere(
                    format!("{symbol}_c = override · {symbol}_p"),
                    format!(
                        "{symbol}_c = {} % · {} = {} {unit}",
                        number(percent),
                        number(programmed),
                        number(result)
                    ),
                )
            };
            vec![
                line("f", settings.feed_percent, program.feed_mm_min, "mm/min"),
                line("n", settings.speed_percent, program.speed_rpm, "1/min"),
            ]
        }
        ControllerKind::Sdnrp => {
            let kp = scenario.sdnrp.kp;
            let setpoint = desired + kp * (desired - measured);
            let law = Live::everywhere(
                format!("F_s = F_d + {} (F_d - F_m)", number(kp)),
                format!(
                    "F_s = {d} + {} ({d} - {}) = {} N",
                    number(kp),
                    number(measured),
                    number(setpoint),
                    d = number(desired),
                ),
            );
            vec![law, feed(belief, setpoint), speed(belief, setpoint)]
        }
        ControllerKind::Tracking => {
            let (gain, k) = (row.gain_estimate, belief.set.letter());
            let settings = &scenario.tracking;
            let lambda_s =
                settings.response_s + settings.dead_time_share * scenario.belief.dead_time_s;
            let mut lines = vec![
                Live::everywhere(
                    format!(
                        "g follows F_m / {k}4(predicted f, n) with a time constant of {} s",
                        number(lambda_s)
                    ),
                    format!("g = {}  (F_m = {} N)", number(gain), number(measured)),
                ),
                Live::everywhere(
                    "u = F_d / g",
                    format!(
                        "u = {} / {} = {} N",
                        number(desired),
                        number(gain),
                        number(desired / gain)
                    ),
                ),
                Live {
                    formula: format!(
                        "f_c, n_c from {k}4(f_c, n_c) = u on the line of {k}2 and {k}3"
                    ),
                    values: format!(
                        "f_c = {} mm/min, n_c = {} 1/min",
                        number(row.feed_command_mm_min),
                        number(row.spindle_command_rpm)
                    ),
                    range: format!("{k}3 and the inverse of {k}4 within their ranges"),
                    valid: !row.has(flag::K2_OUTSIDE | flag::K3_OUTSIDE),
                },
            ];
            if scenario.cnc.override_quantised {
                lines.push(rounding(row, scenario));
            }
            lines
        }
        _ => force_law(row, scenario),
    }
}

/// The force controllers of 2005: the law, and the normalised force that it saw.
fn force_law(row: &Row, scenario: &Scenario) -> Vec<Live> {
    let y = row.force_measured_n / row.force_ref_n;
    let seen = Live::everywhere(
        "y = F_m / F_{ref}",
        format!(
            "y = {} / {} = {}",
            number(row.force_measured_n),
            number(row.force_ref_n),
            number(y)
        ),
    );
    let sent = format!("u = {} %", number(row.feed_override_percent));
    let gain = number(row.gain_estimate);
    let law = match scenario.controller.kind {
        ControllerKind::Proportional => {
            let kp = number(scenario.proportional.kp);
            Live::everywhere(format!("u = 1 + {kp} (1 - y) + Ki Σ(1 - y)"), sent)
        }
        ControllerKind::AdjustablePi => {
            let [kp, ki] = [scenario.adjustable_pi.kp, scenario.adjustable_pi.ki].map(number);
            Live::everywhere(
                format!("u grows by [{kp} (e - e_{{before}}) + {ki} e] / K,  e = 1 - y"),
                format!("{sent}, K = {gain}"),
            )
        }
        ControllerKind::Mrac => match scenario.mrac.adapted {
            Adapted::Landau => Live::everywhere("u from five adapted parameters θ φ", sent),
            Adapted::Gain => Live::everywhere("u = r / K", format!("{sent}, K = {gain}")),
        },
        ControllerKind::Unks if scenario.unks.start == UnksStart::Cold => {
            Live::everywhere("u = e^{NM-2} + NM-R(F_{ref}, F_m) - 1", sent)
        }
        ControllerKind::Unks => Live::everywhere(
            "u = a_0 e^{NM-2} · internal loop + w_{ext} (NM-R(F_{ref}, F_m) - 1)",
            sent,
        ),
        ControllerKind::Preview => {
            let margin = number(scenario.preview.margin_mm);
            let exponent = number(scenario.preview.exponent);
            let aim = number(ratio_from_percent(scenario.preview.aim_percent));
            Live::everywhere(
                format!("u = [{aim} / (g · max K(x_h ± {margin} mm))]^{{1/{exponent}}}"),
                format!("{sent}, g = {gain}"),
            )
        }
        _ => {
            let formula = match scenario.division.divided {
                Divided::Programmed => "u = 1 / y".to_owned(),
                Divided::Actual => "u = u_a / y".to_owned(),
                Divided::Command => {
                    format!("u = u_{{before}} y^{{-{}}}", number(scenario.division.exponent))
                }
            };
            Live::everywhere(formula, sent)
        }
    };
    vec![seen, law]
}

/// Tracking with whole percents: what rounding takes is not lost.
fn rounding(row: &Row, scenario: &Scenario) -> Live {
    let cut = ToolPath::cut_of(&scenario.workpiece, row.position_mm);
    let FeedSpeed { feed_mm_min, speed_rpm } = scenario.programmed(cut);
    let [feed, speed] =
        [feed_mm_min, speed_rpm].map(|programmed| number(programmed * ratio_from_percent(1.0)));
    Live::everywhere(
        "what rounding to whole % takes is added to the next request: the mean is as asked",
        format!("1 % is {feed} mm/min and {speed} 1/min"),
    )
}
