//! The dynamometer: adds its own noise to the dynamic force once per control period.

use super::dynamic_force::NoiseSettings;
use crate::base::math;
use crate::base::rng::Stream;

/// The sensor.
#[derive(Clone, Debug)]
pub struct Dynamometer {
    stream: Stream,
    deviation_n: f64,
}

impl Dynamometer {
    /// The sensor under `seed`.
    #[must_use]
    pub fn new(settings: &NoiseSettings, seed: u32) -> Self {
        let mut this =
            Self { stream: Stream::new(u64::from(seed), "noise.sensor"), deviation_n: 0.0 };
        this.reconfigure(settings);
        this
    }

    /// Takes over changed settings.
    pub fn reconfigure(&mut self, settings: &NoiseSettings) {
        self.deviation_n = settings.level * settings.sensor_n;
    }

    /// The reading in N of a force in N, reading number `sample`; never negative.
    #[must_use]
    pub fn read(&self, force_n: f64, sample: u64) -> f64 {
        math::positive(force_n + self.deviation_n * self.stream.normal(sample))
    }
}
