//! The random fraction r_d of the contact force, calibrated on Table 3 of 2007: the one number by which the
//! vibration alone would give the produced Ra.
//!
//! ```text
//! sigma = r_d u_rms(F),  Ra = Ra(cusps of f/(z n), sigma);  least squares over the ten rows
//! ```
//!
//! The residuals show what it is worth: the vibration grows in proportion to the force, the printed Ra
//! much more steeply, so no agreement is claimed. A coupled run therefore takes Ra = K5(F), which meets
//! the table, and adds only what the marks of the teeth change.

use serde::Serialize;

use super::model;
use crate::base::stats;
use crate::blocks::control::FeedSpeed;
use crate::models::genetic::GeneticModels;
use crate::models::roughness_trend::{cusp_mm, ra_um};
use crate::published::PaperId;
use crate::run::closed_loop::life::wear_cut;
use crate::run::scenario::Scenario;

/// Bisections of the interval of r_d.
const SECTIONS: u32 = 80;

/// A row of the table.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct CalibratedRow {
    /// Number of the simulation.
    pub sim: u32,
    /// Final force, N; the misprint corrected.
    pub force_n: f64,
    /// Produced Ra as printed, um.
    pub ra_printed_um: f64,
    /// Ra = K5(F), um.
    pub ra_k5_um: f64,
    /// Ra by the vibration with the calibrated r_d, um.
    pub ra_vibration_um: f64,
}

/// What the calibration gives.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Calibrated {
    /// r_d.
    pub random_ratio: f64,
    /// The ten rows.
    pub rows: Vec<CalibratedRow>,
    /// Root mean square of the residuals of the vibration's Ra, um.
    pub rms_vibration_um: f64,
    /// The same of K5, um.
    pub rms_k5_um: f64,
}

fn rms(rows: &[CalibratedRow], of: impl Fn(&CalibratedRow) -> f64) -> f64 {
    stats::rms(rows.iter().map(|row| of(row) - row.ra_printed_um)).unwrap_or(0.0)
}

/// Calibrates r_d of the scenario's machine with a sharp tool.
#[must_use]
pub fn calibrate(scenario: &Scenario) -> Calibrated {
    let k5 = GeneticModels::with_formulas(
        PaperId::Sdnrp2007.model_set(),
        scenario.plant.calibration,
        &scenario.formula,
    );
    let mut machine = model(scenario);
    let points: Vec<(CalibratedRow, f64, f64)> = PaperId::Sdnrp2007
        .rows()
        .iter()
        .map(|row| {
            let force_n = row.force_reference_n();
            let at =
                FeedSpeed { feed_mm_min: row.feed_final_mm_min, speed_rpm: row.spindle_final_rpm };
            machine.life.contact_force_n = force_n;
            machine.cut = wear_cut(&scenario.tool, at, scenario.workpiece.axial_depth_mm);
            let cusp_um = 1000.0 * cusp_mm(machine.cut.feed_per_tooth_mm, &machine.tool.outline());
            let row = CalibratedRow {
                sim: row.sim,
                force_n,
                ra_printed_um: row.ra_produced_um,
                ra_k5_um: k5.ra_from_force(force_n).value,
                ra_vibration_um: 0.0,
            };
            (row, cusp_um, 1e6 * machine.at(0.0).vibration_rms_m)
        })
        .collect();
    let with = |ratio: f64| -> Vec<CalibratedRow> {
        let of = |(row, cusp_um, u_um): &(CalibratedRow, f64, f64)| CalibratedRow {
            ra_vibration_um: ra_um(*cusp_um, ratio * u_um),
            ..*row
        };
        points.iter().map(of).collect()
    };
    let error = |ratio: f64| rms(&with(ratio), |row| row.ra_vibration_um);
    // Ra rises with r_d, so the squares have one minimum: thirds of an interval around it.
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..SECTIONS {
        let third = (high - low) / 3.0;
        if error(low + third) < error(high - third) { high -= third } else { low += third }
    }
    let random_ratio = 0.5 * (low + high);
    let rows = with(random_ratio);
    Calibrated {
        random_ratio,
        rms_vibration_um: rms(&rows, |row| row.ra_vibration_um),
        rms_k5_um: rms(&rows, |row| row.ra_k5_um),
        rows,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_calibration_is_a_minimum_and_its_residuals_are_far_larger_than_those_of_k5() {
        let mut scenario = Scenario::default();
        let found = calibrate(&scenario);
        assert_eq!(found.rows.len(), 10);
        let mean = |of: fn(&CalibratedRow) -> f64| found.rows.iter().map(of).sum::<f64>() / 10.0;
        let (vibration, printed) = (mean(|row| row.ra_vibration_um), mean(|row| row.ra_printed_um));
        assert!((vibration / printed - 1.0).abs() < 0.1, "{vibration} {printed}");
        assert!(found.rms_k5_um < 0.03 && found.rms_vibration_um > 5.0 * found.rms_k5_um);
        // A softer machine needs a smaller fraction for the same vibration.
        scenario.change(|s| s.machine.spindle_quality = 17.0).unwrap();
        assert!(calibrate(&scenario).random_ratio < found.random_ratio);
    }
}
