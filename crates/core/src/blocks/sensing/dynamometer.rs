//! The dynamometer: adds its own noise to the dynamic force once per control period.

use crate::base::math;
use crate::base::rng::Stream;

/// The sensor.
#[derive(Clone, Debug)]
pub struct Dynamometer {
    stream: Stream,
    deviation_n: f64,
}

impl Dynamometer {
    /// The sensor under `seed` with a standard deviation of its noise in N.
    #[must_use]
    pub fn new(deviation_n: f64, seed: u32) -> Self {
        Self { stream: Stream::new(u64::from(seed), "noise.sensor"), deviation_n }
    }

    /// Takes over another standard deviation in N.
    pub fn reconfigure(&mut self, deviation_n: f64) {
        self.deviation_n = deviation_n;
    }

    /// The reading in N of a force in N, reading number `sample`: the size of a force, so never negative.
    #[must_use]
    pub fn read(&self, force_n: f64, sample: u64) -> f64 {
        math::positive(force_n + self.deviation_n * self.stream.normal(sample))
    }
}
