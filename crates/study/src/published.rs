//! The published tables, as shipped in `assets/data`, and the bands in which they are met.

use serde::{Deserialize, Serialize};

use crate::models::genetic::ModelSet;

steadycut_core::choice! {
    /// A paper whose table can be re-run.
    pub enum PaperId {
        /// SDNRP 2007, Table 3: ten simulations.
        Sdnrp2007 = "2007", "SDNRP 2007, Table 3";
        /// Control strategy 2013, Table 1: eight simulations.
        Strategy2013 = "2013", "Control strategy 2013, Table 1";
    }
}

/// Largest deviations for the verdict "met".
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Bands {
    /// Final force, percent.
    pub force_percent: f64,
    /// Final feed, percent.
    pub feed_percent: f64,
    /// Final spindle speed, percent.
    pub speed_percent: f64,
    /// Produced roughness, um.
    pub ra_um: f64,
}

impl PaperId {
    /// The table's text as shipped.
    #[must_use]
    pub fn text(self) -> &'static str {
        match self {
            Self::Sdnrp2007 => include_str!("../../../assets/data/table3_2007.csv"),
            Self::Strategy2013 => include_str!("../../../assets/data/table1_2013.csv"),
        }
    }

    /// The bands in which a final value counts as met. Table 1 of 2013 is not smooth itself: its
    /// rows 6 and 7 differ by 1 N and 0.17 um.
    #[must_use]
    pub fn bands(self) -> Bands {
        match self {
            Self::Sdnrp2007 => {
                Bands { force_percent: 0.5, feed_percent: 3.0, speed_percent: 1.5, ra_um: 0.03 }
            }
            Self::Strategy2013 => {
                Bands { force_percent: 2.0, feed_percent: 3.5, speed_percent: 3.5, ra_um: 0.08 }
            }
        }
    }

    /// The paper's models.
    #[must_use]
    pub fn model_set(self) -> ModelSet {
        match self {
            Self::Sdnrp2007 => ModelSet::Sdnrp2007,
            Self::Strategy2013 => ModelSet::Strategy2013,
        }
    }

    /// What the table's force before the simulation is called.
    #[must_use]
    pub fn start_force(self) -> &'static str {
        match self {
            Self::Sdnrp2007 => "Desired force",
            Self::Strategy2013 => "Initial force",
        }
    }

    /// Name of the preset of one of its simulations.
    #[must_use]
    pub fn preset(self, sim: u32) -> String {
        match self {
            Self::Sdnrp2007 => format!("table3-{sim}"),
            Self::Strategy2013 => format!("strategy-table1-{sim}"),
        }
    }

    /// The shipped table.
    ///
    /// # Panics
    /// Never: a test reads the shipped tables.
    #[must_use]
    pub fn rows(self) -> Vec<TableRow> {
        parse_table(self.text()).expect("the shipped tables are checked by a test")
    }
}

/// Table 3 of 2007 prints 195.2 N as final force of simulation 10; with K4 restored its own feed
/// and speed give 190.2 N, which also lies on the force-roughness curve of all other rows: a
/// misprint.
pub const SIM_10_FORCE_N: f64 = 190.2;
/// The misprint itself.
const SIM_10_PRINTED_N: f64 = 195.2;

/// A row of Table 3 of 2007 or of Table 1 of 2013.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
pub struct TableRow {
    /// Number of the simulation, from 1.
    pub sim: u32,
    /// Desired roughness, um.
    pub ra_desired_um: f64,
    /// 2007: desired force F_d; 2013: initial force, N.
    #[serde(alias = "f_desired_n", alias = "force_initial_n")]
    pub force_start_n: f64,
    /// Feed before the simulation, mm/min.
    pub feed_initial_mm_min: f64,
    /// Spindle speed before the simulation, 1/min.
    pub spindle_initial_rpm: f64,
    /// Force after the simulation, N.
    pub force_final_n: f64,
    /// Feed after the simulation, mm/min.
    pub feed_final_mm_min: f64,
    /// Spindle speed after the simulation, 1/min.
    pub spindle_final_rpm: f64,
    /// Produced roughness, um.
    pub ra_produced_um: f64,
}

impl TableRow {
    /// The final force to compare with: as printed, but the misprint of simulation 10 corrected.
    #[must_use]
    pub fn force_reference_n(&self) -> f64 {
        let misprint = self.sim == 10 && self.force_final_n == SIM_10_PRINTED_N;
        if misprint { SIM_10_FORCE_N } else { self.force_final_n }
    }
}

/// Reads a table in the format of Table 3 of 2007 or of Table 1 of 2013.
///
/// # Errors
/// The line and column name that is missing or not a finite number.
pub fn parse_table(text: &str) -> Result<Vec<TableRow>, String> {
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(text.as_bytes());
    let rows: Result<Vec<TableRow>, csv::Error> = reader.deserialize().collect();
    let rows = rows.map_err(|error| error.to_string())?;
    for row in &rows {
        let values = [
            row.ra_desired_um,
            row.force_start_n,
            row.feed_initial_mm_min,
            row.spindle_initial_rpm,
            row.force_final_n,
            row.feed_final_mm_min,
            row.spindle_final_rpm,
            row.ra_produced_um,
        ];
        if values.iter().any(|value| !(value.is_finite() && *value > 0.0)) {
            return Err(format!("sim {}: every value must be a positive number", row.sim));
        }
    }
    if rows.len() < 4 {
        return Err(format!("{} rows; at least 4 are needed", rows.len()));
    }
    Ok(rows)
}
