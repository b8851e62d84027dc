//! Rules between settings.

use super::groups::{RunSettings, Settings};
use crate::base::settings::SettingError;

/// Most rows that a run may record: a row takes 184 bytes, a console holds up to four recordings,
/// and a page in the browser has 4 GiB at most.
pub const MAX_ROWS: f64 = if cfg!(target_arch = "wasm32") { 1_000_000.0 } else { 4_000_000.0 };

impl Settings {
    /// Rules between settings.
    pub(super) fn check(&self) -> Result<(), SettingError> {
        let longest_s = self.plant.force_model.longest_step_s();
        if self.dt_s() > longest_s {
            let steps = (self.control_period_s() / longest_s).ceil();
            return Err(SettingError::Refused {
                path: "plant.force_model".to_owned(),
                value: format!(
                    "{} with plant steps of {} s",
                    self.plant.force_model.id(),
                    self.dt_s()
                ),
                allowed: format!(
                    "plant steps of at most {longest_s} s: `run.steps_per_control` from \
                     {steps} on (576 give 28.8 kHz)"
                ),
            });
        }
        if self.wear.adjust_speed && !self.machine.coupled {
            return Err(SettingError::Refused {
                path: "wear.adjust_speed".to_owned(),
                value: "true without the machine's sound".to_owned(),
                allowed: "true with `machine.coupled` = true".to_owned(),
            });
        }
        if let Some(stored) = self.controller.unks.networks.get()
            && stored.start != self.controller.unks.start
        {
            return Err(SettingError::Refused {
                path: "controller.unks.networks".to_owned(),
                value: format!("networks of the start `{}`", stored.start.id()),
                allowed: format!(
                    "networks of `controller.unks.start`, {}, or none; set both together",
                    self.controller.unks.start.id()
                ),
            });
        }
        let refuse = |path: &str, value: f64, unit: &str, allowed: String| {
            let value = format!("{value}{unit}");
            Err(SettingError::Refused { path: path.to_owned(), value, allowed })
        };
        if self.noise.band_low_hz >= self.noise.band_high_hz {
            let high = self.noise.band_high_hz;
            let allowed = format!("below `noise.band_high_hz`, {high} Hz");
            return refuse("noise.band_low_hz", self.noise.band_low_hz, " Hz", allowed);
        }
        let RunSettings { record_every, steps_per_control, .. } = self.run;
        if !steps_per_control.is_multiple_of(record_every) {
            let allowed = format!(
                "a divisor of `run.steps_per_control`, {steps_per_control}: every control sample \
                 is recorded"
            );
            return refuse("run.record_every", f64::from(record_every), "", allowed);
        }
        let row_s = self.dt_s() * f64::from(self.run.record_every);
        if self.run.duration_s / row_s > MAX_ROWS {
            let longest = MAX_ROWS * row_s;
            let allowed = format!(
                "at most {longest} s with a row every {row_s} s ({MAX_ROWS} rows); record less \
                 often with `run.record_every`"
            );
            return refuse("run.duration_s", self.run.duration_s, " s", allowed);
        }
        Ok(())
    }
}
