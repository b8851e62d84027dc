//! Overrides: commands reach the machine in percent of the programmed values, within limits
//! (2013: DNCFRO and DNCSPO, 0..250 %). Continuous here: no quantisation.

use crate::base::math::{limit, positive};
use crate::base::units::{percent_from_ratio, ratio_from_percent};

crate::settings! {
    /// The command channel of the CNC.
    pub struct Cnc {
        /// Least override of feed and spindle, in percent of the programmed values.
        override_min_percent: f64 = 0.0, [0.0, 100.0], "%", live, "Least override";
        /// Largest override of feed and spindle, in percent of the programmed values.
        override_max_percent: f64 = 250.0, [100.0, 250.0], "%", live, "Largest override";
        /// Dead time of the command channel (the PLC): a whole number of plant steps. Choosing a
        /// feed drive sets the dead time published with it.
        dead_time_s: f64 = 0.08, [0.0, 0.5], "s", live, "Dead time";
    }
}

crate::settings! {
    /// The NC program.
    pub struct Program {
        /// Programmed feed: 100 % override, and the feed at the start of the run.
        feed_mm_min: f64 = 430.41, [10.0, 5000.0], "mm/min", setup, "Programmed feed";
        /// Programmed spindle speed: 100 % override, and the speed at the start of the run.
        spindle_rpm: f64 = 1571.0, [100.0, 20000.0], "1/min", setup, "Programmed speed";
    }
}

impl Cnc {
    /// The range of commands in the unit of `programmed`.
    #[must_use]
    pub fn range(&self, programmed: f64) -> [f64; 2] {
        [
            programmed * ratio_from_percent(self.override_min_percent),
            programmed * ratio_from_percent(self.override_max_percent),
        ]
    }
}

/// One override channel's answer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Overridden {
    /// The command that is sent, in the unit of the programmed value; never negative, never NaN.
    pub command: f64,
    /// The same in percent of the programmed value.
    pub percent: f64,
    /// Whether a limit acted.
    pub saturated: bool,
}

/// Limits a request to `range` and expresses it as override of `programmed`.
#[must_use]
pub fn apply(request: f64, range: [f64; 2], programmed: f64) -> Overridden {
    let command = positive(limit(request, range[0], range[1]));
    Overridden {
        command,
        percent: percent_from_ratio(command / programmed),
        saturated: command != request,
    }
}
