//! M1..M5 from Table 1 of 2013, jointly, on the closed loop's equilibria.
//!
//! ```text
//! F_d = M1(Ra desired)      M1 a line
//! F_s = F_d + Kp (F_d - F)  Kp = 0.5
//! F   = M4(M2(F_s), M3(F_s))  M2 a quadratic, M3 an exponential, M4 in its printed form
//! Ra  = M5(F)               M5 the exact inverse of M1
//! ```
//!
//! Fitted one after the other, the loop misses the table, since its equilibrium lies elsewhere than
//! the points of any single model. So all coefficients are fitted at once to the final forces,
//! feeds, speeds and roughnesses, each residual in units of its band in `steadycut papers`. M4's
//! speed coefficient stays as printed (left free, its sign turns). M1 is a line: with a quadratic
//! through the final forces M1 turns round at 1.14 um, and left free its curvature does not improve
//! the worst residuals.

use nalgebra::SVector;

use super::least_squares::minimise;
use super::{Fit, Identified};
use crate::base::math::{self, extent};
use crate::blocks::control::sdnrp::KP_DEFAULT;
use crate::models::genetic::curve::Curve;
use crate::models::genetic::exponential::Exponential;
use crate::models::genetic::force_formula::ForceFormula;
use crate::models::genetic::strategy_2013;
use crate::models::genetic::{
    CutsAs, FeedLaw, ForceRoughness, GeneticModels, ModelSet, OwnModels, SpeedLaw,
};
use crate::published::{PaperId, TableRow};

/// Middle of the desired roughnesses, um, and of the force setpoints, N: with them the parameters
/// are nearly independent of each other.
const RA_MIDDLE_UM: f64 = 0.75;
const SETPOINT_MIDDLE_N: f64 = 175.0;
const SETPOINT_HALF_N: f64 = 15.0;
/// Sizes of the nine parameters: M1 (2), M2 (3), M3 (2), M4 (2).
const SIZES: [f64; 9] = [180.0, 50.0, 310.0, 40.0, 10.0, 2200.0, 0.1, 320.0, 18_000.0];
/// The search starts from M4 as printed and from a loop that turns the right way.
const START: [f64; 9] = [178.0, 35.0, 310.0, 30.0, 0.0, 2200.0, -0.05, 265.11, 8303.2];

fn models(parameters: &SVector<f64, 9>) -> GeneticModels {
    let p: Vec<f64> = parameters.iter().zip(SIZES).map(|(x, size)| x * size).collect();
    let everywhere = |coefficients| Curve { coefficients, low: -1e6, high: 1e6 };
    let (middle, half) = (SETPOINT_MIDDLE_N, SETPOINT_HALF_N);
    let (slope, curvature) = (p[3] / half, p[4] / (half * half));
    let rate_per_n = p[6] / half;
    GeneticModels {
        set: ModelSet::Strategy2013,
        roughness: ForceRoughness::Curve(everywhere([p[0] - p[1] * RA_MIDDLE_UM, p[1], 0.0])),
        feed: FeedLaw::Curve(everywhere([
            p[2] - slope * middle + curvature * middle * middle,
            slope - 2.0 * curvature * middle,
            curvature,
        ])),
        speed: SpeedLaw::Exponential(
            Exponential { scale_rpm: p[5] * math::exp(-rate_per_n * middle), rate_per_n },
            [-1e6, 1e6],
        ),
        force: ForceFormula { intercept_n: p[7], speed: strategy_2013::M4.speed, feed: p[8] },
        cuts_as: CutsAs::PAPERS,
        own: OwnModels::default(),
    }
}

/// Where the loop comes to rest: force setpoint, force, feed and speed.
struct Rest {
    setpoint_n: f64,
    force_n: f64,
    feed_mm_min: f64,
    speed_rpm: f64,
}

fn at_rest(models: &GeneticModels, ra_desired_um: f64) -> Rest {
    let desired_n = models.force_from_ra(ra_desired_um).value;
    let given = |force_n: f64| {
        let setpoint_n = desired_n + KP_DEFAULT * (desired_n - force_n);
        let feed_mm_min = models.feed_from_force(setpoint_n).value;
        let speed_rpm = models.speed_from_force(setpoint_n).value;
        Rest { setpoint_n, force_n, feed_mm_min, speed_rpm }
    };
    // A larger force lowers the setpoint and so the force that follows: one crossing.
    let (mut low, mut high) = (50.0, 400.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        let rest = given(middle);
        if models.force(rest.feed_mm_min, rest.speed_rpm).value > middle {
            low = middle;
        } else {
            high = middle;
        }
    }
    given(0.5 * (low + high))
}

/// Identifies M1..M5.
pub(super) fn identify(rows: &[TableRow]) -> Result<Identified, String> {
    let bands = PaperId::Strategy2013.bands();
    let residuals = |parameters: &SVector<f64, 9>| {
        let models = models(parameters);
        let mut all = Vec::with_capacity(4 * rows.len());
        for row in rows {
            let rest = at_rest(&models, row.ra_desired_um);
            let percent = |is: f64, printed: f64| 100.0 * (is / printed - 1.0);
            let ra_um = models.ra_from_force(rest.force_n).value;
            all.push(percent(rest.force_n, row.force_final_n) / bands.force_percent);
            all.push(percent(rest.feed_mm_min, row.feed_final_mm_min) / bands.feed_percent);
            all.push(percent(rest.speed_rpm, row.spindle_final_rpm) / bands.speed_percent);
            all.push((ra_um - row.ra_produced_um) / bands.ra_um);
        }
        all
    };
    let start = SVector::from_fn(|i, _| START[i] / SIZES[i]);
    let mut fitted = models(&minimise(start, residuals));
    let rests: Vec<Rest> = rows.iter().map(|row| at_rest(&fitted, row.ra_desired_um)).collect();
    let [ra_low, ra_high] = extent(rows.iter().map(|row| row.ra_desired_um));
    let [lowest, highest] = extent(rests.iter().map(|rest| rest.setpoint_n));
    // Whole newtons outwards: a run in time comes to rest near these points, not exactly on them.
    let setpoints = [lowest.floor(), highest.ceil()];
    if let ForceRoughness::Curve(curve) = &mut fitted.roughness {
        (curve.low, curve.high) = (ra_low, ra_high);
        rising(curve, "M1")?;
    }
    if let FeedLaw::Curve(curve) = &mut fitted.feed {
        [curve.low, curve.high] = setpoints;
        rising(curve, "M2")?;
    }
    if let SpeedLaw::Exponential(_, range) = &mut fitted.speed {
        *range = setpoints;
    }
    let fit =
        |model, meaning, unit, printed: fn(&TableRow) -> f64, is: &dyn Fn(&Rest) -> f64| Fit {
            model,
            meaning,
            points: rows.iter().map(|row| [f64::from(row.sim), printed(row)]).collect(),
            residuals: rows.iter().zip(&rests).map(|(row, rest)| is(rest) - printed(row)).collect(),
            unit,
        };
    let ra = |rest: &Rest| fitted.ra_from_force(rest.force_n).value;
    let fits = vec![
        fit("M4", "final force of the loop at rest", "N", |row| row.force_final_n, &|r| r.force_n),
        fit("M2", "final feed", "mm/min", |row| row.feed_final_mm_min, &|r| r.feed_mm_min),
        fit("M3", "final speed", "1/min", |row| row.spindle_final_rpm, &|r| r.speed_rpm),
        fit("M5", "produced roughness", "um", |row| row.ra_produced_um, &ra),
    ];
    Ok(Identified { models: fitted, fits })
}

fn rising(curve: &Curve, model: &str) -> Result<(), String> {
    let rises = curve.is_monotone() && curve.slope(curve.low) > 0.0;
    if rises { Ok(()) } else { Err(format!("{model}: the table gives no rising curve")) }
}
