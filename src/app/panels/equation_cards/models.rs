//! The cards of the models K1 to K6 and of the controllers that use them.

use super::formula::{
    curve_formula, curve_inverse, curve_inverse_formula, curve_with, number, polynomial,
    quartic_with,
};
use super::live::Live;
use crate::app::theme;
use crate::base::model::force_formula::{FEED_MIN_MM_MIN, INCH, SPEED_MIN_RPM};
use crate::base::model::gp::{
    FORCE_REF_MIN_N, FeedLaw, ForceRoughness, GpModels, M2_RESTORED_RANGE_N, SpeedLaw,
};
use crate::base::model::gp_2007::{K2_MIN_N, K3_MAX_N};
use crate::base::model::gp_2013;
use crate::base::units::ratio_from_percent;
use crate::blocks::control::ControllerKind;
use crate::blocks::cutting::process::Process;
use crate::blocks::cutting::workpiece::{AXIAL_DEPTH_2007_MM, RADIAL_DEPTH_2007_MM};
use crate::run::scenario::Scenario;
use crate::run::signals::{Row, flag};

/// K1 at the target.
pub fn k1(belief: &GpModels, row: &Row) -> Live {
    let ra = row.ra_target_um;
    let force = belief.force_from_ra(ra);
    let result = format!("{} N", number(force.value));
    let floored = |text: String| {
        let at_floor = force.value == FORCE_REF_MIN_N;
        if at_floor { format!("max({}, {text})", number(FORCE_REF_MIN_N)) } else { text }
    };
    let (formula, values, range) = match belief.roughness {
        ForceRoughness::K1K5 => (
            "F_d = 293 - 593 / √(39.37 Ra)".to_owned(),
            format!(
                "F_d = {} = {result}",
                floored(format!("293 - 593 / √(39.37 · {})", number(ra)))
            ),
            format!("F_d at least {} N", number(FORCE_REF_MIN_N)),
        ),
        ForceRoughness::M1M5 { .. } => (
            "F_d = 69.306 Ra^3 - 270.18 Ra^2 + 398.82 Ra + 14.875".to_owned(),
            format!(
                "F_d = {} = {result}",
                floored(format!(
                    "69.306 · {ra}^3 - 270.18 · {ra}^2 + 398.82 · {ra} + 14.875",
                    ra = number(ra)
                ))
            ),
            format!(
                "Ra {} to {} {}",
                gp_2013::RA_RANGE_UM[0],
                gp_2013::RA_RANGE_UM[1],
                theme::unit("um")
            ),
        ),
        ForceRoughness::Curve(curve) => (
            format!("F_d = {}", curve_formula(&curve, "Ra")),
            format!("F_d = {} = {result}", floored(curve_with(&curve, ra))),
            format!(
                "Ra {} to {} {}; straight on beyond",
                number(curve.low),
                number(curve.high),
                theme::unit("um")
            ),
        ),
    };
    Live { formula, values, range, valid: force.valid }
}

fn k2(belief: &GpModels, force_n: f64) -> Live {
    let feed = belief.feed_from_force(force_n);
    let result = format!("{} mm/min", number(feed.value));
    let force = number(force_n);
    let (formula, values, range) = match belief.feed {
        FeedLaw::K2 => (
            "f_c = 25.4 (189 - 5926160 / F_s^2)".to_owned(),
            format!("f_c = 25.4 (189 - 5926160 / {force}^2) = {result}"),
            format!("F_s from {} N on; below it the feed is negative", number(K2_MIN_N)),
        ),
        FeedLaw::M2 => (
            format!("f_c = {}", polynomial(&gp_2013::M2.coefficients, "F_s", " ")),
            format!("f_c = {} = {result}", polynomial(&gp_2013::M2.coefficients, &force, " · ")),
            "where f_c is positive and rises with F_s".to_owned(),
        ),
        FeedLaw::M2Restored(quartic) => (
            format!("f_c = {}", polynomial(&quartic.coefficients, "F_s", " ")),
            format!("f_c = {} = {result}", quartic_with(&quartic, force_n, M2_RESTORED_RANGE_N)),
            format!(
                "F_s {} to {} N; straight on beyond",
                M2_RESTORED_RANGE_N[0], M2_RESTORED_RANGE_N[1]
            ),
        ),
        FeedLaw::Curve(curve) => (
            format!("f_c = {}", curve_formula(&curve, "F_s")),
            format!("f_c = {} = {result}", curve_with(&curve, force_n)),
            format!("F_s {} to {} N; straight on beyond", number(curve.low), number(curve.high)),
        ),
    };
    Live { formula, values, range, valid: feed.valid }
}

fn k3(belief: &GpModels, force_n: f64) -> Live {
    let speed = belief.speed_from_force(force_n);
    let result = format!("{} 1/min", number(speed.value));
    let force = number(force_n);
    let (formula, values, range) = match belief.speed {
        SpeedLaw::K3 => (
            "n_c = √(30064193 - 2.28 F_s^3)".to_owned(),
            if speed.valid {
                format!("n_c = √(30064193 - 2.28 · {force}^3) = {result}")
            } else {
                format!("n_c = √(max(0, 30064193 - 2.28 · {force}^3)) = {result}")
            },
            format!("F_s up to {} N; above it there is no root", number(K3_MAX_N)),
        ),
        SpeedLaw::Exponential(law, [low, high]) => (
            format!("n_c = {} e^{{{} F_s}}", number(law.scale_rpm), number(law.rate_per_n)),
            format!(
                "n_c = {} e^{{{} · {force}}} = {result}",
                number(law.scale_rpm),
                number(law.rate_per_n)
            ),
            format!("F_s {} to {} N", number(low), number(high)),
        ),
        SpeedLaw::Curve(curve) => (
            format!("n_c = {}", curve_formula(&curve, "F_s")),
            format!("n_c = {} = {result}", curve_with(&curve, force_n)),
            format!("F_s {} to {} N; straight on beyond", number(curve.low), number(curve.high)),
        ),
    };
    Live { formula, values, range, valid: speed.valid }
}

/// The controller's law with K2 and K3.
pub fn controller(belief: &GpModels, row: &Row, scenario: &Scenario) -> Vec<Live> {
    let (desired, measured) = (row.force_ref_n, row.force_measured_n);
    match scenario.controller.kind {
        ControllerKind::ConstantFeed => {
            let program = &scenario.program;
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
                line("n", settings.speed_percent, program.spindle_rpm, "1/min"),
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
            vec![law, k2(belief, setpoint), k3(belief, setpoint)]
        }
        ControllerKind::Tracking => {
            let gain = row.gain_estimate;
            let settings = &scenario.tracking;
            let lambda_s =
                settings.response_s + settings.dead_time_share * scenario.belief.dead_time_s;
            vec![
                Live::everywhere(
                    format!(
                        "g follows F_m / K4(predicted f, n) with a time constant of {} s",
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
                    formula: "f_c, n_c from K4(f_c, n_c) = u on the line of K2 and K3".to_owned(),
                    values: format!(
                        "f_c = {} mm/min, n_c = {} 1/min",
                        number(row.feed_command_mm_min),
                        number(row.spindle_command_rpm)
                    ),
                    range: "K3 and the inverse of K4 within their ranges".to_owned(),
                    valid: !row.has(flag::K2_OUTSIDE | flag::K3_OUTSIDE),
                },
            ]
        }
    }
}

/// K4, and what it does not know.
pub fn cutting(row: &Row, scenario: &Scenario) -> Vec<Live> {
    let plant = &scenario.plant;
    let process = Process::new(plant, scenario.workpiece.radial_depth_mm);
    let models = process.models();
    let (feed, speed, depth) = (row.feed_mm_min, row.spindle_rpm, row.axial_depth_mm);
    let k4 = models.force(feed, speed);
    let force = process.update(feed, speed, depth);
    let intercept = number(models.force.intercept_n);
    let [speed_coefficient, feed_coefficient, inch] =
        [models.force.speed * 1e10, models.force.feed, INCH].map(number);
    let f = number(feed.max(FEED_MIN_MM_MIN));
    let model = Live {
        formula: format!(
            "K4 = {intercept} - {speed_coefficient}·10^{{-10}} n^3 - {feed_coefficient} ln({inch} f) / f"
        ),
        values: format!(
            "K4 = {intercept} - {speed_coefficient}·10^{{-10}} · {}^3 - {feed_coefficient} ln({inch} · {f}) / {f} = {} N",
            number(speed),
            number(k4.value)
        ),
        range: format!(
            "f from {} mm/min on (its least force), n from {} 1/min on",
            number(FEED_MIN_MM_MIN),
            number(SPEED_MIN_RPM)
        ),
        valid: k4.valid,
    };
    let engagement = depth * scenario.workpiece.radial_depth_mm;
    let reference = AXIAL_DEPTH_2007_MM * RADIAL_DEPTH_2007_MM;
    let product = Live::everywhere(
        format!("F = K4 · material · (A_D R_D / {} mm^2) · wear", number(reference)),
        format!(
            "F = {} · {} · {} / {} · {} = {} N  ({}, {} HB)",
            number(k4.value),
            number(plant.material.force_factor(plant.hardness_hb)),
            number(engagement),
            number(reference),
            number(plant.wear_factor),
            number(force.value),
            plant.material.label(),
            number(plant.hardness_hb),
        ),
    );
    vec![model, product]
}

/// K5 or K6 at a force, with the symbols of its output and input.
pub fn k5(scenario: &Scenario, force_n: f64, ra_symbol: &str, force_symbol: &str) -> Live {
    let models = GpModels::new(scenario.plant.model_set, scenario.plant.calibration);
    let ra = models.ra_from_force(force_n);
    let force = number(force_n);
    if force_n <= 0.0 {
        let formula = format!("{ra_symbol}: the tool is in the air");
        let values = "no force, so no surface is cut";
        return Live::everywhere(formula, values);
    }
    let result = format!("{} {}", number(ra.value), theme::unit("um"));
    let (formula, values, range) = match models.roughness {
        ForceRoughness::K1K5 => (
            format!("{ra_symbol} = 0.0254 (593 / (293 - {force_symbol}))^2"),
            if ra.valid {
                format!("{ra_symbol} = 0.0254 (593 / (293 - {force}))^2 = {result}")
            } else {
                format!("{ra_symbol} = {result} at {force} N, continued with its end slope")
            },
            format!("{force_symbol} below the pole at 293 N; continued with its slope before it"),
        ),
        ForceRoughness::M1M5 { leading } => {
            let coefficients = [3.018, -0.0341, leading];
            let with = polynomial(&coefficients, &force, " · ");
            let floored = if ra.value > 0.0 { with } else { format!("max(0, {with})") };
            (
                format!("{ra_symbol} = {}", polynomial(&coefficients, force_symbol, " ")),
                format!("{ra_symbol} = {floored} = {result}"),
                format!(
                    "{force_symbol} {} to {} N, above {} N where it turns round",
                    gp_2013::FORCE_RANGE_N[0],
                    gp_2013::FORCE_RANGE_N[1],
                    number(0.0341 / (2.0 * leading))
                ),
            )
        }
        ForceRoughness::Curve(curve) => (
            format!("{ra_symbol} = {}", curve_inverse_formula(&curve, force_symbol)),
            if ra.value > 0.0 {
                format!("{ra_symbol} = {} = {result}", curve_inverse(&curve, force_n))
            } else {
                format!("{ra_symbol} = max(0, {}) = {result}", curve_inverse(&curve, force_n))
            },
            format!(
                "{force_symbol} {} to {} N; straight on beyond",
                number(curve.at(curve.low).value),
                number(curve.at(curve.high).value)
            ),
        ),
    };
    Live { formula, values, range, valid: ra.valid }
}
