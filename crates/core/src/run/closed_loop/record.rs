//! The record of a plant step: the row, written once at its end, and the check that it is finite.

use super::{ClosedLoop, Fault};
use crate::models::Valued;
use crate::run::signals::{Row, SIGNALS, flag};

/// What holds from one control sample to the next and is recorded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// What the sensor has read, N.
    pub force_measured_n: f64,
    /// The force that the controller asks its models for, N.
    pub force_setpoint_n: f64,
    /// The controller's estimate of true over modelled force.
    pub gain_estimate: f64,
    /// Flags of the command.
    pub flags: u32,
}

impl Sample {
    /// Nothing is read or asked for yet but the desired force in N.
    pub fn before_the_first(force_setpoint_n: f64) -> Self {
        Self { force_measured_n: 0.0, force_setpoint_n, gain_estimate: 1.0, flags: 0 }
    }
}

#[inline]
pub(super) fn bit(on: bool, bit: u32) -> u32 {
    if on { bit } else { 0 }
}

impl ClosedLoop {
    /// Writes the row of the present moment.
    #[inline]
    pub(super) fn record(&mut self, [ra, ra_dyn]: [Valued; 2]) {
        let cut = self.plant.now();
        let [feed, speed] = self.cnc.sent();
        let flags = self.sample.flags
            | bit(!self.desired.force.valid, flag::K1_OUTSIDE)
            | bit(!cut.force.model.valid || !self.cnc.drives_are_known(), flag::K4_OUTSIDE)
            | bit(!ra.valid, flag::K5_OUTSIDE)
            | bit(!ra_dyn.valid, flag::K6_OUTSIDE)
            | bit(cut.force.air, flag::AIR)
            | bit(cut.vibration.lost_contact, flag::LOST_CONTACT)
            | bit(self.plant.broken_teeth() > 0, flag::TOOTH_BROKEN);
        self.row = Row {
            time_s: self.clock.time_s(),
            position_mm: cut.position_mm,
            axial_depth_mm: cut.place.axial_depth_mm,
            radial_depth_mm: cut.place.radial_depth_mm,
            ra_target_um: self.desired.ra_um,
            ra_um: ra.value,
            ra_dyn_um: ra_dyn.value,
            force_ref_n: self.desired.force.value,
            force_setpoint_n: self.sample.force_setpoint_n,
            force_n: cut.force.model.value,
            force_dyn_n: cut.force.dynamic_n,
            force_measured_n: self.sample.force_measured_n,
            feed_command_mm_min: feed.command,
            feed_mm_min: cut.motion.feed_mm_min,
            feed_override_percent: feed.percent,
            spindle_command_rpm: speed.command,
            spindle_rpm: cut.motion.speed_rpm,
            spindle_override_percent: speed.percent,
            gain_estimate: self.sample.gain_estimate,
            used_life: cut.used_life,
            vibration_um: cut.vibration.tooth_um,
            sound_mm_s: cut.vibration.sound_mm_s,
            state_flags: f64::from(flags),
        };
    }

    #[inline]
    pub(super) fn check(&self) -> Result<(), Fault> {
        let values = self.row.values();
        // Sums instead of a test each: any NaN or infinity makes them not finite. Four at a time,
        // since one long sum would wait for itself.
        let mut sums = [0.0; 4];
        for (i, value) in values.iter().enumerate() {
            sums[i % 4] += value;
        }
        if ((sums[0] + sums[1]) + (sums[2] + sums[3])).is_finite() {
            return Ok(());
        }
        let signal = values.iter().position(|value| !value.is_finite());
        match signal {
            Some(index) => Err(Fault { signal: SIGNALS[index].id, tick: self.clock.tick() }),
            None => Ok(()),
        }
    }
}
