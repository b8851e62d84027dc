//! What the sound of a recorded run foretells of its tool's life, minute by minute of that life.

use serde::Serialize;

use crate::base::settings::SettingError;
use crate::models::genetic::GeneticModels;
use crate::models::tool_life::Forecast;
use crate::run::durability::{listened, listener};
use crate::run::recording::Recording;
use crate::run::scenario::Scenario;
use crate::run::signals::Row;

/// A minute of the tool's life.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Heard {
    /// Time in the run, s.
    pub time_s: f64,
    /// Share of the life that is really used.
    pub used_life: f64,
    /// The sound, mm/s.
    pub sound_mm_s: f64,
    /// What is foretold; ages and lives in minutes at the programmed cut.
    pub forecast: Forecast,
}

/// The forecasts over the recording of a coupled run, by the settings of its start; of a run without
/// sound they are those of the prior.
///
/// # Errors
/// As [`listener`].
pub fn listen(scenario: &Scenario, recording: &Recording) -> Result<Vec<Heard>, SettingError> {
    let mut listener = listener(scenario)?;
    let belief = GeneticModels::new(scenario.belief.model_set, scenario.belief.calibration);
    // As in the running cut: once in a control period.
    let stride = recording.control_stride();
    let period_s = recording.row_s() * stride as f64;
    let hear = |row: &Row| {
        let forecast = listener.hear(&listened(row, &belief, period_s))?;
        let Row { time_s, used_life, sound_mm_s, .. } = *row;
        Some(Heard { time_s, used_life, sound_mm_s, forecast })
    };
    Ok(recording.rows().iter().step_by(stride).skip(1).filter_map(hear).collect())
}
