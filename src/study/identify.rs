//! Identification of the default models from the published table (`steadycut identify tables`).
//!
//! The functional roles K1, K2, K3 are fitted again by least squares; K4 keeps its printed form
//! with the restored intercept. Abscissae:
//!
//! ```text
//! K1   F over Ra:   the ten (Ra desired, F desired) and the ten (Ra produced, F final)
//! K2   f over F_s   F_s = F_d + Kp (F_d - F_final), Kp = 0.5, F_d = K1(Ra desired):
//! K3   n over F_s   what the proportional loop asks for at the table's own final values
//! ```

use std::fmt::Write as _;

use nalgebra::{Matrix3, Vector3};

use super::published::Table3Row;
use crate::base::model::curve::Curve;
use crate::base::model::gp_2007::{
    FeedLaw, ForceRoughness, GpModels, K4_INTERCEPT_RESTORED_N, SpeedLaw,
};
use crate::blocks::control::sdnrp::KP_DEFAULT;

/// One fitted curve with its points and residuals.
#[derive(Clone, Debug)]
pub struct Fit {
    /// Name of the model, K1..K4.
    pub model: &'static str,
    /// What is fitted over what.
    pub meaning: &'static str,
    /// Points (x, y).
    pub points: Vec<[f64; 2]>,
    /// Fitted minus given y, per point.
    pub residuals: Vec<f64>,
    /// Unit of y.
    pub unit: &'static str,
}

impl Fit {
    /// Root mean square of the residuals.
    #[must_use]
    pub fn rms(&self) -> f64 {
        let sum: f64 = self.residuals.iter().map(|r| r * r).sum();
        (sum / self.residuals.len() as f64).sqrt()
    }

    /// Largest absolute residual.
    #[must_use]
    pub fn worst(&self) -> f64 {
        self.residuals.iter().fold(0.0, |worst: f64, r| worst.max(r.abs()))
    }
}

/// The result of an identification.
#[derive(Clone, Debug)]
pub struct Identified {
    /// The models.
    pub models: GpModels,
    /// The fits, with residuals.
    pub fits: Vec<Fit>,
}

/// Least-squares quadratic through points, on their range.
fn quadratic(points: &[[f64; 2]]) -> Option<Curve> {
    let low = points.iter().map(|p| p[0]).fold(f64::INFINITY, f64::min);
    let high = points.iter().map(|p| p[0]).fold(f64::NEG_INFINITY, f64::max);
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

fn fit(
    model: &'static str,
    meaning: &'static str,
    unit: &'static str,
    points: Vec<[f64; 2]>,
) -> Result<(Curve, Fit), String> {
    let curve = quadratic(&points)
        .filter(Curve::is_monotone)
        .ok_or_else(|| format!("{model}: the table gives no monotone quadratic"))?;
    let residuals = points.iter().map(|[x, y]| curve.at(*x).value - y).collect();
    Ok((curve, Fit { model, meaning, points, residuals, unit }))
}

/// Identifies K1..K3 from rows of Table 3.
///
/// # Errors
/// Names the model whose points give no monotone curve.
pub fn identify(rows: &[Table3Row]) -> Result<Identified, String> {
    let desired = rows.iter().map(|row| [row.ra_desired_um, row.f_desired_n]);
    let produced = rows.iter().map(|row| [row.ra_produced_um, row.force_reference_n()]);
    let (k1, k1_fit) =
        fit("K1", "force over Ra, desired and produced", "N", desired.chain(produced).collect())?;
    let setpoint = |row: &Table3Row| {
        let desired_n = k1.at(row.ra_desired_um).value;
        desired_n + KP_DEFAULT * (desired_n - row.force_reference_n())
    };
    let feeds = rows.iter().map(|row| [setpoint(row), row.feed_final_mm_min]).collect();
    let speeds = rows.iter().map(|row| [setpoint(row), row.spindle_final_rpm]).collect();
    let (k2, k2_fit) = fit("K2", "final feed over F_s", "mm/min", feeds)?;
    let (k3, k3_fit) = fit("K3", "final spindle speed over F_s", "1/min", speeds)?;
    let models = GpModels {
        roughness: ForceRoughness::Identified(k1),
        feed: FeedLaw::Identified(k2),
        speed: SpeedLaw::Identified(k3),
        k4_intercept_n: K4_INTERCEPT_RESTORED_N,
    };
    let at_final = |row: &Table3Row| models.force(row.feed_final_mm_min, row.spindle_final_rpm);
    let k4_fit = Fit {
        model: "K4",
        meaning: "final force from final feed and speed (restored, not fitted)",
        points: rows.iter().map(|r| [f64::from(r.sim), r.force_reference_n()]).collect(),
        residuals: rows.iter().map(|r| at_final(r).value - r.force_reference_n()).collect(),
        unit: "N",
    };
    Ok(Identified { models, fits: vec![k1_fit, k2_fit, k3_fit, k4_fit] })
}

/// The model file that is shipped as `assets/models/identified_2007.toml`.
#[must_use]
pub fn model_file(identified: &Identified) -> String {
    let mut text = String::from(
        "# Models of SDNRP 2007, identified from its Table 3 by `steadycut identify tables`.\n\
         # Quadratics c0 + c1 x + c2 x^2 on low..high, continued with their end slopes.\n",
    );
    let models = &identified.models;
    let mut section = |name: &str, doc: &str, curve: &Curve| {
        let _ = write!(
            text,
            "\n# {doc}\n[{name}]\ncoefficients = {:?}\nlow = {:?}\nhigh = {:?}\n",
            curve.coefficients, curve.low, curve.high
        );
    };
    if let ForceRoughness::Identified(curve) = &models.roughness {
        section("k1", "Force in N over Ra in um; K5 = K6 is its exact inverse.", curve);
    }
    if let FeedLaw::Identified(curve) = &models.feed {
        section("k2", "Feed command in mm/min over the force setpoint in N.", curve);
    }
    if let SpeedLaw::Identified(curve) = &models.speed {
        section("k3", "Spindle speed command in 1/min over the force setpoint in N.", curve);
    }
    let _ = write!(
        text,
        "\n# K4 as printed, its intercept restored.\n[k4]\nintercept_n = {:?}\n",
        models.k4_intercept_n
    );
    text
}
