//! The best formula on the same rows: what a network must be compared with.
//!
//! Three forms, each fitted by least squares to the measured F_xy of the training rows:
//!
//! ```text
//! power law   F = C f_t^a v_c^b A_D^c R_D^d D^e HB^g M^m G^q      (M material, G geometry factor)
//! quadratic   ln F = second-degree polynomial of the same logarithms and codes
//! paper       F = A_D R_D [c0 - c1 n^3 - c2 ln(0.039 f)/f]        (form of K4 2007 and M4 2013)
//! ```
//!
//! The first two are fitted in ln F, the third to relative errors, so all three are fitted to what
//! they are judged by. The paper's form knows neither material, diameter nor geometry.

use serde::Serialize;

use super::data::{TrainingRow, fxy_n};
use super::errors::{TrainingErrors, of_fxy};
use crate::base::{cholesky, math};
use crate::models::neural_force::{CutPoint, speed_m_min};

steadycut_core::choice! {
    /// The form of a formula.
    pub enum Form {
        /// A product of powers.
        PowerLaw = "power law", "power law with factors for material and geometry";
        /// A quadratic in logarithms.
        Quadratic = "quadratic", "quadratic in the logarithms";
        /// The genetic-programming formula of the papers, scaled by A_D R_D.
        Paper = "paper", "the papers' K4/M4, scaled by A_D R_D";
    }
}

/// A fitted formula.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct FittedForm {
    /// Its form, in words.
    pub form: &'static str,
    /// Number of coefficients.
    pub coefficients: usize,
    /// Errors over the fresh rows.
    pub errors: TrainingErrors,
}

/// Logarithms of the six quantities relative to the middle of their ranges, and the two codes.
fn logarithms(cut: &CutPoint) -> [f64; 8] {
    let speed = speed_m_min(cut.diameter_mm, cut.speed_rpm);
    [
        math::ln(cut.feed_per_tooth_mm() / 0.08),
        math::ln(speed / 80.0),
        math::ln(cut.axial_depth_mm / 2.0),
        math::ln(cut.radial_depth_mm / 4.0),
        math::ln(cut.diameter_mm / 14.0),
        math::ln(cut.hardness_hb / 195.0),
        cut.material_code - 1.5,
        cut.geometry_code - 2.0,
    ]
}

fn features(form: Form, cut: &CutPoint) -> Vec<f64> {
    let linear = logarithms(cut);
    match form {
        Form::PowerLaw => [&[1.0], &linear[..]].concat(),
        Form::Quadratic => {
            let mut all = [&[1.0], &linear[..]].concat();
            for (i, x) in linear.iter().enumerate() {
                // The square of a code of two values is constant.
                let products = linear.iter().enumerate().skip(i);
                all.extend(products.filter(|(k, _)| (i, *k) != (6, 6)).map(|(_, y)| x * y));
            }
            all
        }
        Form::Paper => {
            let (n, f) = (cut.speed_rpm, cut.feed_mm_min);
            let section = cut.axial_depth_mm * cut.radial_depth_mm;
            [1.0, n * n * n, math::ln(0.039 * f) / f].map(|x| x * section).to_vec()
        }
    }
}

/// F_xy in N.
fn value(form: Form, coefficients: &[f64], cut: &CutPoint) -> f64 {
    let sum: f64 = features(form, cut).iter().zip(coefficients).map(|(x, c)| x * c).sum();
    if form == Form::Paper { sum } else { math::exp(sum) }
}

/// Of columns of unit length, what is left of one beside the others before it, squared, at least.
const LEAST_PIVOT: f64 = 1e-10;

/// Least squares by the normal equations (Cholesky), columns scaled to unit length; `None` where
/// the columns depend on each other.
fn least_squares(rows: &[(Vec<f64>, f64)]) -> Option<Vec<f64>> {
    let n = rows.first()?.0.len();
    let length = |k: usize| rows.iter().map(|(x, _)| x[k] * x[k]).sum::<f64>().sqrt();
    let scale: Vec<f64> = (0..n).map(length).collect();
    let mut lower = vec![vec![0.0; n]; n];
    let mut right = vec![0.0; n];
    for (x, y) in rows {
        for i in 0..n {
            for k in 0..=i {
                lower[i][k] += x[i] / scale[i] * (x[k] / scale[k]);
            }
            right[i] += x[i] / scale[i] * y;
        }
    }
    let solved = cholesky::solve(lower, right, LEAST_PIVOT)?;
    Some(solved.iter().zip(&scale).map(|(c, s)| c / s).collect())
}

fn fit(form: Form, rows: &[TrainingRow]) -> Option<Vec<f64>> {
    let equations = rows.iter().map(|row| {
        let (x, force_n) = (features(form, &row.cut), fxy_n(&row.forces_n));
        match form {
            Form::Paper => (x.into_iter().map(|x| x / force_n).collect(), 1.0),
            Form::PowerLaw | Form::Quadratic => (x, math::ln(force_n)),
        }
    });
    least_squares(&equations.collect::<Vec<_>>())
}

/// All forms fitted to `training` and judged over `fresh`, the best first.
///
/// # Errors
/// Names the form that the rows do not determine.
pub fn fit_all(training: &[TrainingRow], fresh: &[TrainingRow]) -> Result<Vec<FittedForm>, String> {
    let mut all = Vec::new();
    for form in Form::ALL {
        let coefficients = fit(*form, training).ok_or_else(|| {
            format!("{} training rows do not determine the {}", training.len(), form.label())
        })?;
        let errors = of_fxy(fresh, |row| value(*form, &coefficients, &row.cut));
        all.push(FittedForm { form: form.label(), coefficients: coefficients.len(), errors });
    }
    all.sort_by(|a, b| a.errors.mean_percent.total_cmp(&b.errors.mean_percent));
    Ok(all)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::train::data::RowsJob;

    #[test]
    fn forms_find_back_the_law_that_made_the_rows() {
        let cuts: Vec<TrainingRow> = RowsJob::fresh(120, 4).complete();
        for form in Form::ALL {
            let n = features(*form, &cuts[0].cut).len();
            let mut law: Vec<f64> = (0..n).map(|k| 0.03 * (k as f64 + 1.0)).collect();
            law[0] = 6.0;
            if *form == Form::Paper {
                law = vec![40.0, -2e-11, -900.0];
            }
            let made = |row: &TrainingRow| value(*form, &law, &row.cut);
            let rows: Vec<TrainingRow> = cuts
                .iter()
                .map(|row| TrainingRow { forces_n: [made(row), 0.0, 0.0], ..*row })
                .collect();
            for (found, given) in fit(*form, &rows).unwrap().iter().zip(&law) {
                assert!((found - given).abs() < 1e-6 * given.abs().max(1e-3), "{found} {given}");
            }
        }
        assert!(fit_all(&cuts[..20], &cuts).unwrap_err().contains("20 training rows"));
    }
}
