//! The cards of models 1, 2, 3, 5 and 6 (K1.. or M1..), each law with its live values and range.

use super::formula::number;
use super::laws::{
    curve_formula, curve_inverse, curve_inverse_formula, curve_with, exponential, exponential_with,
    polynomial, polynomial_with, quartic_with, straight_on,
};
use crate::app::format;
use crate::base::equation::Live;
use crate::base::language::tr;
use crate::base::math;
use crate::models::Valued;
use crate::models::formula_model::FormulaModel;
use crate::models::genetic::sdnrp_2007::{K2_MIN_N, K3_MAX_N, K5_MAX_N};
use crate::models::genetic::strategy_2013;
use crate::models::genetic::{
    FORCE_REF_MIN_N, FeedLaw, ForceRoughness, GeneticModels, M2_RESTORED_RANGE_N, SpeedLaw,
};
use crate::run::signals::Row;

/// Coefficients of M1 (2013 eq. 2), from the constant on.
const M1: [f64; 4] = [14.875, 398.82, -270.18, 69.306];
/// The coefficients of M5 (2013 eq. 6) below its leading one, from the constant on.
const M5: [f64; 2] = [3.018, -0.0341];

/// Formula, the same with values but without its result, and range.
type Law = (String, String, String);

fn from_to(symbol: &str, [low, high]: [f64; 2], unit: &str) -> String {
    tr!(
        "{symbol} {low} to {high} {unit}",
        symbol = symbol,
        low = number(low),
        high = number(high),
        unit = format::unit(unit)
    )
}

/// A range beyond which a law goes straight on.
fn straight_beyond(range: String) -> String {
    tr!("{range}; straight on beyond", range = range)
}

fn live(symbol: &str, (formula, values, range): Law, answer: Valued, unit: &str) -> Live {
    Live {
        formula: format!("{symbol} = {formula}"),
        values: format!("{symbol} = {values} = {} {}", number(answer.value), format::unit(unit)),
        range,
        valid: answer.valid,
    }
}

/// An own formula in the place of a model, at its one input.
fn own(model: &FormulaModel, symbol: &str, unit: &str, x: f64) -> Law {
    let [formula, values] = model.shown(&[symbol], &[x]);
    let range = model.inputs().first().map_or([x, x], |input| [input.range.low, input.range.high]);
    (formula, values, straight_beyond(from_to(symbol, range, unit)))
}

/// Model 1 at the target.
pub fn desired_force(belief: &GeneticModels, row: &Row) -> Live {
    let ra = row.ra_target_um;
    let force = belief.force_from_ra(ra);
    if let Some(model) = &belief.own.force_of_ra {
        let mut law = own(model, "Ra", "um", ra);
        if force.value == FORCE_REF_MIN_N {
            law.1 = format!("max({}, {})", number(FORCE_REF_MIN_N), law.1);
        }
        return live("F_d", law, force, "N");
    }
    let mut law = match belief.roughness {
        ForceRoughness::K1K5 => (
            "293 - 593 / √(39.37 Ra)".to_owned(),
            format!("293 - 593 / √(39.37 · {})", number(ra)),
            tr!("F_d at least {force} N", force = number(FORCE_REF_MIN_N)),
        ),
        ForceRoughness::M1M5 { .. } => (
            polynomial(&M1, "Ra"),
            polynomial_with(&M1, ra),
            from_to("Ra", strategy_2013::RA_RANGE_UM, "um"),
        ),
        ForceRoughness::Curve(curve) => (
            curve_formula(&curve, "Ra"),
            curve_with(&curve, ra),
            straight_beyond(from_to("Ra", [curve.low, curve.high], "um")),
        ),
    };
    if force.value == FORCE_REF_MIN_N {
        law.1 = format!("max({}, {})", number(FORCE_REF_MIN_N), law.1);
    }
    live("F_d", law, force, "N")
}

/// Model 2 at a force.
pub fn feed(belief: &GeneticModels, force_n: f64) -> Live {
    if let Some(model) = &belief.own.feed {
        let law = own(model, "F_s", "N", force_n);
        return live("f_c", law, belief.feed_from_force(force_n), "mm/min");
    }
    let law = match belief.feed {
        FeedLaw::K2 => (
            "25.4 (189 - 5926160 / F_s^2)".to_owned(),
            format!("25.4 (189 - 5926160 / {}^2)", number(force_n.max(1.0))),
            tr!("F_s from {force} N on; below it the feed is negative", force = number(K2_MIN_N)),
        ),
        FeedLaw::M2 => (
            polynomial(&strategy_2013::M2.coefficients, "F_s"),
            polynomial_with(&strategy_2013::M2.coefficients, force_n),
            tr("F_s where the feed is positive and rises with it").to_owned(),
        ),
        FeedLaw::M2Restored(quartic) => (
            polynomial(&quartic.coefficients, "F_s"),
            quartic_with(&quartic, force_n, M2_RESTORED_RANGE_N),
            straight_beyond(from_to("F_s", M2_RESTORED_RANGE_N, "N")),
        ),
        FeedLaw::Curve(curve) => (
            curve_formula(&curve, "F_s"),
            curve_with(&curve, force_n),
            straight_beyond(from_to("F_s", [curve.low, curve.high], "N")),
        ),
    };
    live("f_c", law, belief.feed_from_force(force_n), "mm/min")
}

/// Model 3 at a force.
pub fn speed(belief: &GeneticModels, force_n: f64) -> Live {
    let answer = belief.speed_from_force(force_n);
    if let Some(model) = &belief.own.speed {
        return live("n_c", own(model, "F_s", "N", force_n), answer, "1/min");
    }
    let law = match belief.speed {
        SpeedLaw::K3 => {
            let radicand = format!("30064193 - 2.28 · {}^3", number(force_n));
            (
                "√(30064193 - 2.28 F_s^3)".to_owned(),
                if answer.valid {
                    format!("√({radicand})")
                } else {
                    format!("√(max(0, {radicand}))")
                },
                tr!("F_s up to {force} N; above it there is no root", force = number(K3_MAX_N)),
            )
        }
        SpeedLaw::Exponential(law, range) => (
            exponential(&law, "F_s"),
            exponential_with(&law, force_n),
            tr!("{range}; goes on beyond", range = from_to("F_s", range, "N")),
        ),
        SpeedLaw::Curve(curve) => (
            curve_formula(&curve, "F_s"),
            curve_with(&curve, force_n),
            straight_beyond(from_to("F_s", [curve.low, curve.high], "N")),
        ),
    };
    live("n_c", law, answer, "1/min")
}

/// Model 5 or 6 at a force, with the symbols of its output and input.
pub fn roughness(plant: &GeneticModels, force_n: f64, ra_symbol: &str, force_symbol: &str) -> Live {
    if force_n <= 0.0 {
        let formula = tr!("{symbol}: the tool is in the air", symbol = ra_symbol);
        return Live::everywhere(formula, tr("no force, so no surface is cut"));
    }
    let ra = plant.ra_from_force(force_n);
    if let Some(model) = &plant.own.ra {
        let mut law = own(model, force_symbol, "N", force_n);
        if ra.value == 0.0 {
            law.1 = format!("max(0, {})", law.1);
        }
        return live(ra_symbol, law, ra, "um");
    }
    let mut law = match plant.roughness {
        ForceRoughness::K1K5 => k5(plant, force_n, force_symbol),
        ForceRoughness::M1M5 { leading } => m5(leading, force_n, force_symbol),
        ForceRoughness::Curve(curve) => {
            let ends = [curve.low, curve.high].map(|ra| curve.at(ra).value);
            (
                curve_inverse_formula(&curve, force_symbol),
                curve_inverse(&curve, force_n),
                straight_beyond(from_to(force_symbol, ends, "N")),
            )
        }
    };
    if ra.value == 0.0 {
        law.1 = format!("max(0, {})", law.1);
    }
    live(ra_symbol, law, ra, "um")
}

/// K5, beyond its end continued with the model's end slope.
fn k5(plant: &GeneticModels, force_n: f64, symbol: &str) -> Law {
    let values = if force_n <= K5_MAX_N {
        format!("0.0254 (593 / (293 - {}))^2", number(force_n))
    } else {
        let end = plant.ra_from_force(K5_MAX_N).value;
        straight_on(end, 2.0 * end / (293.0 - K5_MAX_N), force_n, K5_MAX_N)
    };
    let range = from_to(symbol, [0.0, K5_MAX_N], "N");
    let range = tr!("{range}; straight on beyond, before its pole at 293 N", range = range);
    (format!("0.0254 (593 / (293 - {symbol}))^2"), values, range)
}

/// M5, which turns round where its slope is zero.
fn m5(leading: f64, force_n: f64, symbol: &str) -> Law {
    let coefficients = [M5[0], M5[1], leading];
    let turns_n = -M5[1] / (2.0 * leading);
    let [low, high] = strategy_2013::FORCE_RANGE_N;
    let low = math::limit(turns_n, low, high);
    (
        polynomial(&coefficients, symbol),
        polynomial_with(&coefficients, force_n),
        tr!(
            "{range}; it turns round at {force} N",
            range = from_to(symbol, [low, high], "N"),
            force = number(turns_n)
        ),
    )
}
