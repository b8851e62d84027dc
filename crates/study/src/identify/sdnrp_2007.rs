//! K1..K4 from Table 3 of 2007.
//!
//! The functional roles K1, K2, K3 are fitted again by least squares; K4 keeps its printed form
//! with the restored intercept. Abscissae:
//!
//! ```text
//! K1   F over Ra:   the ten (Ra desired, F desired) and the ten (Ra produced, F final)
//! K2   f over F_s   F_s = F_d + Kp (F_d - F_final), Kp = 0.5, F_d = K1(Ra desired):
//! K3   n over F_s   what the proportional loop asks for at the table's own final values
//! ```

use nalgebra::{Matrix3, Vector3};

use super::{Fit, Identified};
use crate::base::math::extent;
use crate::blocks::control::sdnrp::KP_DEFAULT;
use crate::models::genetic::curve::Curve;
use crate::models::genetic::sdnrp_2007;
use crate::models::genetic::{
    CutsAs, FeedLaw, ForceRoughness, GeneticModels, ModelSet, OwnModels, SpeedLaw,
};
use crate::published::TableRow;

/// Least-squares quadratic through points, on their range.
fn quadratic(points: &[[f64; 2]]) -> Option<Curve> {
    let [low, high] = extent(points.iter().map(|p| p[0]));
    // Centred and scaled to -1..1: the normal equations are then well conditioned.
    let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
    let mut normal = Matrix3::zeros();
    let mut right = Vector3::zeros();
    for [x, y] in points {
        let t = (x - middle) / half;
        let row = Vector3::new(1.0, t, t * t);
        normal += row * row.transpose();
        right += row * *y;
    }
    let c = normal.lu().solve(&right)?;
    let (m, h) = (middle / half, 1.0 / half);
    let coefficients = [c[0] - c[1] * m + c[2] * m * m, (c[1] - 2.0 * c[2] * m) * h, c[2] * h * h];
    Some(Curve { coefficients, low, high })
}

/// The monotone quadratic through points, with its residuals.
pub(super) fn fit(
    model: &'static str,
    meaning: &'static str,
    unit: &'static str,
    points: Vec<[f64; 2]>,
) -> Result<(Curve, Fit), String> {
    let curve = quadratic(&points)
        .filter(Curve::is_monotone)
        .ok_or_else(|| format!("{model}: the points give no monotone quadratic"))?;
    let residuals = points.iter().map(|[x, y]| curve.at(*x).value - y).collect();
    Ok((curve, Fit { model, meaning, points, residuals, unit }))
}

/// Identifies K1..K3.
pub(super) fn identify(rows: &[TableRow]) -> Result<Identified, String> {
    let desired = rows.iter().map(|row| [row.ra_desired_um, row.force_start_n]);
    let produced = rows.iter().map(|row| [row.ra_produced_um, row.force_reference_n()]);
    let (k1, k1_fit) =
        fit("K1", "force over Ra, desired and produced", "N", desired.chain(produced).collect())?;
    let setpoint = |row: &TableRow| {
        let desired_n = k1.at(row.ra_desired_um).value;
        desired_n + KP_DEFAULT * (desired_n - row.force_reference_n())
    };
    let feeds = rows.iter().map(|row| [setpoint(row), row.feed_final_mm_min]).collect();
    let speeds = rows.iter().map(|row| [setpoint(row), row.spindle_final_rpm]).collect();
    let (k2, k2_fit) = fit("K2", "final feed over F_s", "mm/min", feeds)?;
    let (k3, k3_fit) = fit("K3", "final spindle speed over F_s", "1/min", speeds)?;
    let models = GeneticModels {
        set: ModelSet::Sdnrp2007,
        roughness: ForceRoughness::Curve(k1),
        feed: FeedLaw::Curve(k2),
        speed: SpeedLaw::Curve(k3),
        force: sdnrp_2007::K4_RESTORED,
        cuts_as: CutsAs::PAPERS,
        own: OwnModels::default(),
    };
    let at_final = |row: &TableRow| models.force(row.feed_final_mm_min, row.spindle_final_rpm);
    let k4_fit = Fit {
        model: "K4",
        meaning: "final force from final feed and speed (restored, not fitted)",
        points: rows.iter().map(|r| [f64::from(r.sim), r.force_reference_n()]).collect(),
        residuals: rows.iter().map(|r| at_final(r).value - r.force_reference_n()).collect(),
        unit: "N",
    };
    Ok(Identified { models, fits: vec![k1_fit, k2_fit, k3_fit, k4_fit] })
}
