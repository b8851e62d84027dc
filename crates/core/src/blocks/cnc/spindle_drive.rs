//! The spindle drive: a first-order lag with a rate limit (chosen: no paper gives one;
//! [`crate::models::spindle`]). The defaults are those of a machine of this class.

use crate::base::math;
use crate::models::drive_curve::{DriveCurve, SpeedReached};
use crate::models::formula_model::OwnFormula;
use crate::models::spindle::ExactSpindle;
use crate::models::transfer::{TransferDrive, TransferPoles};

crate::settings! {
    /// The spindle drive.
    pub struct SpindleDriveSettings {
        /// Time constant of the speed control loop (chosen).
        time_constant_s: f64 = 0.2, [0.01, 5.0], "s", live, "Spindle lag";
        /// Largest rate of change of the speed (chosen).
        rate_rpm_s: f64 = 1000.0, [50.0, 100000.0], "1/min/s", live, "Spindle rate limit";
        /// Speed that is reached at rest as a formula of one's own over the speed that is asked for.
        curve: OwnFormula<SpeedReached> = OwnFormula::default(), [], "", live, "Speed reached";
        /// Poles of a drive of one's own, in the place of lag and rate limit: up to order 8, stable; a pair by the pole with positive imaginary part.
        poles: TransferPoles = TransferPoles::default(), [], "", live, "Own spindle drive";
        /// Speed over the speed that is asked for at rest, of a drive of one's own.
        gain: f64 = 1.0, [0.1, 10.0], "", live, "Own spindle gain";
    }
}

/// The spindle with its state.
#[derive(Clone, Debug)]
pub struct SpindleDrive {
    exact: ExactSpindle,
    curve: DriveCurve,
    speed_rpm: f64,
    /// A drive of one's own, which then stands in the place of lag and rate limit.
    own: Option<TransferDrive>,
}

impl SpindleDrive {
    /// Turning where it is asked for `speed_rpm`, for steps of `dt_s`.
    #[must_use]
    pub fn new(settings: &SpindleDriveSettings, dt_s: f64, speed_rpm: f64) -> Self {
        let exact = ExactSpindle::new(settings.time_constant_s, settings.rate_rpm_s, dt_s);
        let mut curve = DriveCurve::new(&settings.curve);
        let reached_rpm = curve.reached(speed_rpm);
        let mut own = TransferDrive::new(&settings.poles, settings.gain, dt_s, reached_rpm);
        if let Some(own) = &mut own {
            own.settle(reached_rpm);
        }
        let speed_rpm = own.map_or(reached_rpm, |own| math::positive(own.output()));
        Self { exact, curve, speed_rpm, own }
    }

    /// Takes over changed settings at the present speed.
    pub fn reconfigure(&mut self, settings: &SpindleDriveSettings, dt_s: f64) {
        self.exact = ExactSpindle::new(settings.time_constant_s, settings.rate_rpm_s, dt_s);
        self.curve = DriveCurve::new(&settings.curve);
        let own = TransferDrive::new(&settings.poles, settings.gain, dt_s, self.speed_rpm);
        self.own = own.map(|own| own.going_on(self.own));
    }

    /// The actual speed n_a in 1/min after one step.
    #[inline]
    pub fn update(&mut self, command_rpm: f64) -> f64 {
        let reached_rpm = self.curve.reached(command_rpm);
        self.speed_rpm = match &mut self.own {
            // A spindle does not turn back when its drive rings.
            Some(own) => math::positive(own.advance(reached_rpm)),
            None => self.exact.advance(self.speed_rpm, reached_rpm),
        };
        self.speed_rpm
    }

    /// The actual speed, 1/min.
    #[must_use]
    pub fn actual(&self) -> f64 {
        self.speed_rpm
    }

    /// Whether the last command lay within the range of a formula of one's own.
    #[must_use]
    #[inline]
    pub fn is_known(&self) -> bool {
        self.curve.is_known()
    }
}
