//! The force sensor of the loop: what it is given every plant step, and what the controller reads of it
//! once in a control period.
//!
//! A force that is a map is sampled ([`super::dynamometer`]); tooth by tooth the sensor holds the peak of
//! the control period ([`super::peak`]).

use super::dynamometer::Dynamometer;
use super::peak::PeakWindow;

/// The sensor by the kind of force that it measures.
#[derive(Clone, Debug)]
pub enum ForceSensor {
    /// Samples the largest force of a revolution.
    Sampled {
        /// The sensor.
        dynamometer: Dynamometer,
        /// What it was given last, N.
        force_n: f64,
    },
    /// Holds the peak of the instants of a control period.
    PeakHold {
        /// The sensor.
        window: Box<PeakWindow>,
        /// The peak of the last whole control period, N.
        held_n: f64,
    },
}

/// What a sensor is set up from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SensorSetup {
    /// The force comes instant by instant.
    pub by_instants: bool,
    /// Standard deviation of the sensor's noise, N.
    pub deviation_n: f64,
    /// Seed of the noise.
    pub seed: u32,
    /// Plant steps in a control period.
    pub steps: u64,
    /// Plant step, s.
    pub dt_s: f64,
}

impl ForceSensor {
    /// The sensor before anything is measured.
    #[must_use]
    pub fn new(setup: &SensorSetup) -> Self {
        let SensorSetup { by_instants, deviation_n, seed, steps, dt_s } = *setup;
        if by_instants {
            let window = Box::new(PeakWindow::new(deviation_n, seed, steps, dt_s));
            Self::PeakHold { window, held_n: 0.0 }
        } else {
            let dynamometer = Dynamometer::new(deviation_n, seed);
            Self::Sampled { dynamometer, force_n: 0.0 }
        }
    }

    /// Takes over changed settings; what was measured stays where the kind of force does.
    pub fn reconfigure(&mut self, setup: &SensorSetup) {
        match (&mut *self, setup.by_instants) {
            (Self::Sampled { dynamometer, .. }, false) => {
                dynamometer.reconfigure(setup.deviation_n);
            }
            (Self::PeakHold { window, .. }, true) => window.reconfigure(setup.deviation_n),
            (Self::Sampled { force_n: given_n, .. }, true)
            | (Self::PeakHold { held_n: given_n, .. }, false) => {
                let given_n = *given_n;
                *self = Self::new(setup);
                self.hold(given_n);
            }
        }
    }

    /// Stands at a force in N until it is given one.
    fn hold(&mut self, at_n: f64) {
        match self {
            Self::Sampled { force_n, .. } => *force_n = at_n,
            Self::PeakHold { held_n, .. } => *held_n = at_n,
        }
    }

    /// A new cut begins: nothing is left of the one before.
    pub fn restart(&mut self) {
        match self {
            Self::Sampled { .. } => {}
            Self::PeakHold { window, .. } => window.restart(),
        }
    }

    /// Takes the force of plant step `tick`: its maximum in N, and where it comes instant by instant F_x
    /// and F_y.
    #[inline]
    pub fn take(&mut self, tick: u64, maximum_n: f64, instant_n: [f64; 2]) {
        match self {
            Self::Sampled { force_n, .. } => *force_n = maximum_n,
            Self::PeakHold { window, held_n } => *held_n = window.push(tick, instant_n).measured_n,
        }
    }

    /// The reading in N, reading number `sample`.
    #[must_use]
    pub fn read(&self, sample: u64) -> f64 {
        match self {
            Self::Sampled { dynamometer, force_n } => dynamometer.read(*force_n, sample),
            Self::PeakHold { held_n, .. } => *held_n,
        }
    }
}
