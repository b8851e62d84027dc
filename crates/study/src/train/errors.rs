//! Errors of a force model over rows.

use serde::Serialize;

use super::data::{TrainingRow, fxy_n};
use crate::base::math;
use crate::base::stats::{self, Sorted};

/// Errors in percent.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct TrainingErrors {
    /// Rows judged.
    pub rows: usize,
    /// Mean of |F_xy - F_row| / F_row.
    pub mean_percent: f64,
    /// Median of it.
    pub median_percent: f64,
    /// Mean over rows above 200 N.
    pub mean_above_200_n_percent: f64,
    /// 95 % of the rows lie below.
    pub p95_percent: f64,
    /// Root mean square error of each component over its range in the rows, where the model gives
    /// components.
    pub rmse_percent_of_range: Option<[f64; 3]>,
}

/// Above this force rows count for [`TrainingErrors::mean_above_200_n_percent`], N.
const LARGE_N: f64 = 200.0;

/// Errors of a model that gives F_xy in N.
#[must_use]
pub fn of_fxy(rows: &[TrainingRow], model: impl Fn(&TrainingRow) -> f64) -> TrainingErrors {
    let off = |row: &TrainingRow| {
        let exact = fxy_n(&row.forces_n);
        100.0 * (model(row) - exact).abs() / exact
    };
    let all: Vec<f64> = rows.iter().map(off).collect();
    let large = rows.iter().zip(&all).filter(|(row, _)| fxy_n(&row.forces_n) > LARGE_N);
    let mean_above_200_n_percent = stats::mean(large.map(|(_, e)| *e)).unwrap_or(0.0);
    let all = Sorted::new(all);
    // Without rows nothing is off.
    let quantile = |share: f64| all.quantile(share).unwrap_or(0.0);
    TrainingErrors {
        rows: rows.len(),
        mean_percent: stats::mean(all.values().iter().copied()).unwrap_or(0.0),
        median_percent: quantile(0.5),
        mean_above_200_n_percent,
        p95_percent: quantile(0.95),
        rmse_percent_of_range: None,
    }
}

/// Errors of a model that gives the three components in N.
#[must_use]
pub fn of_components(
    rows: &[TrainingRow],
    model: impl Fn(&TrainingRow) -> [f64; 3],
) -> TrainingErrors {
    let given: Vec<[f64; 3]> = rows.iter().map(&model).collect();
    let rmse = [0, 1, 2].map(|k| {
        let range = math::extent(rows.iter().map(|row| row.forces_n[k]));
        let off = rows.iter().zip(&given).map(|(row, given)| given[k] - row.forces_n[k]);
        100.0 * stats::rms(off).unwrap_or(0.0) / (range[1] - range[0])
    });
    TrainingErrors { rmse_percent_of_range: Some(rmse), ..of_fxy(rows, |row| fxy_n(&model(row))) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::train::data::RowsJob;

    #[test]
    fn a_model_off_by_known_amounts_has_those_errors() {
        let rows: Vec<TrainingRow> = RowsJob::fresh(40, 3).complete();
        let exact = of_components(&rows, |row| row.forces_n);
        assert_eq!((exact.mean_percent, exact.rmse_percent_of_range), (0.0, Some([0.0; 3])));
        let larger = of_components(&rows, |row| row.forces_n.map(|force| 1.1 * force));
        for error in [larger.mean_percent, larger.median_percent, larger.p95_percent] {
            assert!((error - 10.0).abs() < 1e-9, "{error}");
        }
        // One row in forty is off by 40 %: the mean is 1 %, median and 95 % are not.
        let first = rows[0];
        let one = of_fxy(&rows, |row| fxy_n(&row.forces_n) * if *row == first { 0.6 } else { 1.0 });
        assert!((one.mean_percent - 1.0).abs() < 1e-9);
        assert!(one.median_percent == 0.0 && one.p95_percent == 0.0);
        let shifted = of_components(&rows, |row| row.forces_n.map(|force| force + 10.0));
        let [low, high] = math::extent(rows.iter().map(|row| row.forces_n[2]));
        let expected = 1000.0 / (high - low);
        assert!((shifted.rmse_percent_of_range.unwrap()[2] - expected).abs() < 1e-9);
    }
}
