//! The tool's life as predicted from the sound of a recorded run, minute by minute of that life.

use serde::Serialize;

use crate::base::settings::SettingError;
use crate::models::structure::FiveMass;
use crate::models::structure::reduction::Reduction;
use crate::models::tool_life::LifePrediction;
use crate::run::closed_loop::life::{Stretch, estimator};
use crate::run::recording::Recording;
use crate::run::scenario::Scenario;
use crate::run::signals::Row;

/// A minute of the tool's life.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ConditionEstimate {
    /// Time in the run, s.
    pub time_s: f64,
    /// Fraction of the tool's life that is really used.
    pub used_life: f64,
    /// The sound, mm/s.
    pub sound_mm_s: f64,
    /// The predicted life; ages and lives in minutes at the programmed cut.
    pub prediction: LifePrediction,
}

/// The predictions over the recording of a coupled run, by the settings of its start; of a run without
/// sound they are those of the prior.
///
/// # Errors
/// As [`Reduction::new`]: a run without sound may have any machine.
pub fn predictions(
    scenario: &Scenario,
    recording: &Recording,
) -> Result<Vec<ConditionEstimate>, SettingError> {
    let machine = match scenario.coupled_machine() {
        Some(machine) => *machine,
        None => Reduction::new(&FiveMass::new(&scenario.machine))?,
    };
    let mut estimator = estimator(scenario, &machine);
    let belief = scenario.believed();
    // As in the running cut: once in a control period.
    let period_s = recording.row_s() * recording.control_stride() as f64;
    let observe = |row: &Row| {
        let stretch = Stretch::of_row(row, period_s);
        let prediction = estimator.observe(&stretch.observed(&scenario.tool, &belief))?;
        let Row { time_s, used_life, sound_mm_s, .. } = *row;
        Some(ConditionEstimate { time_s, used_life, sound_mm_s, prediction })
    };
    Ok(recording.samples(usize::MAX).skip(1).filter_map(observe).collect())
}
