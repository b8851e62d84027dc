//! The dynamic component of the cutting force (2007 Fig. 10: random values sized like the
//! oscillations of measured forces). The figure is lost; it is built here from three sources, each
//! with a random stream of its own, relative to the force (chosen):
//!
//! ```text
//! F_dyn = F (1 + level (band b(t) + ripple sin(theta) + inhomogeneity w(x)))
//! b      band-limited noise of unit variance: first-order low pass minus its own low pass
//! theta  tooth-passing angle, theta' = 2 pi z n / 60, z teeth; where a step is longer than a third of a
//!        tooth's period it cannot show the ripple's course, and theta is drawn evenly for each step: mean and
//!        deviation stay those of the ripple
//! w      field of unit variance along the path ([`super::field`]): a property of the workpiece, the
//!        same for every controller
//! ```

use super::field::MaterialField;
use crate::base::math::{self, TAU};
use crate::base::rng::Stream;
use crate::base::units::{ratio_from_percent, rev_s_from_rpm};

crate::settings! {
    /// The dynamic component of the force and the sensor's noise.
    pub struct NoiseSettings {
        /// Factor on all noise sources: 0 switches them off, 1 is their size as set below (chosen; the
        /// paper sizes them like measured oscillations).
        level: f64 = 0.0, [0.0, 5.0], "", live, "Noise";
        /// Standard deviation of the band-limited noise, in percent of the force.
        band_percent: f64 = 2.0, [0.0, 20.0], "%", live, "Band noise";
        /// Lower corner of the band-limited noise.
        band_low_hz: f64 = 2.0, [0.1, 100.0], "Hz", live, "Band, lower corner";
        /// Upper corner of the band-limited noise.
        band_high_hz: f64 = 40.0, [0.2, 400.0], "Hz", live, "Band, upper corner";
        /// Amplitude of the tooth-passing ripple, in percent of the force.
        ripple_percent: f64 = 1.5, [0.0, 20.0], "%", live, "Tooth ripple";
        /// Standard deviation of the slow inhomogeneity of the material, in percent of the force.
        inhomogeneity_percent: f64 = 2.0, [0.0, 20.0], "%", live, "Inhomogeneity";
        /// Correlation length of the inhomogeneity along the path.
        correlation_mm: f64 = 3.0, [0.2, 100.0], "mm", live, "Correlation length";
        /// Standard deviation of the dynamometer's noise.
        sensor_n: f64 = 2.0, [0.0, 50.0], "N", live, "Sensor noise";
    }
}

/// Most of a tooth's period in a step that still shows the ripple's course: from three samples a period on,
/// mean and deviation of a sine are those of its samples; two may all fall on its zeros.
const RESOLVED: f64 = 1.0 / 3.0;

/// The dynamic component with its state.
#[derive(Clone, Debug)]
pub struct DynamicForce {
    band: Stream,
    ripple: Stream,
    field: MaterialField,
    teeth: f64,
    // Coefficients.
    pole_high: f64,
    drive_high: f64,
    share_low: f64,
    band_gain: f64,
    ripple_gain: f64,
    field_gain: f64,
    turn_per_rpm: f64,
    // State.
    fast: f64,
    slow: f64,
    turn: f64,
}

impl NoiseSettings {
    /// Standard deviation of the inhomogeneity as a fraction of the force, all levels counted.
    #[must_use]
    pub fn inhomogeneity(&self) -> f64 {
        self.level * ratio_from_percent(self.inhomogeneity_percent)
    }

    /// Standard deviation of the force sensor's noise, N.
    #[must_use]
    pub fn sensor_deviation_n(&self) -> f64 {
        self.level * self.sensor_n
    }
}

impl DynamicForce {
    /// The sources under `seed` for a cutter with `teeth` teeth, for steps of `dt_s`.
    #[must_use]
    pub fn new(settings: &NoiseSettings, teeth: u32, seed: u32, dt_s: f64) -> Self {
        let band = Stream::new(u64::from(seed), "noise.band");
        let ripple = Stream::new(u64::from(seed), "noise.ripple");
        let mut this = Self {
            band,
            ripple,
            teeth: f64::from(teeth),
            field: MaterialField::new(seed, settings.correlation_mm),
            pole_high: 0.0,
            drive_high: 0.0,
            share_low: 0.0,
            band_gain: 0.0,
            ripple_gain: 0.0,
            field_gain: 0.0,
            turn_per_rpm: 0.0,
            fast: band.normal(u64::MAX),
            slow: 0.0,
            turn: ripple.uniform(0),
        };
        this.reconfigure(settings, dt_s);
        this
    }

    /// Takes over changed settings and keeps the state, so the noise continues without a jump.
    pub fn reconfigure(&mut self, settings: &NoiseSettings, dt_s: f64) {
        let p = math::exp(-TAU * settings.band_high_hz * dt_s);
        let q = math::exp(-TAU * settings.band_low_hz * dt_s);
        self.pole_high = p;
        self.drive_high = (1.0 - p * p).sqrt();
        self.share_low = 1.0 - q;
        // Stationary variance of fast - slow, from the Lyapunov equation of the two states.
        let covariance = (1.0 - q) / (1.0 - p * q);
        let slow = (2.0 * q * (1.0 - q) * p * covariance + (1.0 - q) * (1.0 - q)) / (1.0 - q * q);
        let deviation = (1.0 - 2.0 * covariance + slow).max(1e-12).sqrt();
        self.band_gain = settings.level * ratio_from_percent(settings.band_percent) / deviation;
        self.ripple_gain = settings.level * ratio_from_percent(settings.ripple_percent);
        self.field_gain = settings.inhomogeneity();
        self.field.reconfigure(settings.correlation_mm);
        self.turn_per_rpm = rev_s_from_rpm(1.0) * self.teeth * dt_s;
    }

    /// The factor 1 + relative dynamic component at tick `tick`, position in mm and speed in 1/min.
    #[inline]
    pub fn update(&mut self, tick: u64, position_mm: f64, speed_rpm: f64) -> f64 {
        self.fast = self.pole_high * self.fast + self.drive_high * self.band.normal(tick);
        self.slow += self.share_low * (self.fast - self.slow);

        let advance = speed_rpm * self.turn_per_rpm;
        self.turn += advance;
        self.turn -= self.turn.floor();
        let turn = if advance <= RESOLVED { self.turn } else { self.ripple.uniform(tick) };

        1.0 + self.band_gain * (self.fast - self.slow)
            + self.ripple_gain * math::sin(TAU * turn)
            + self.field_gain * self.field.at(position_mm)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::stats;

    fn only(band: f64, ripple: f64, inhomogeneity: f64) -> NoiseSettings {
        NoiseSettings {
            level: 1.0,
            band_percent: band,
            ripple_percent: ripple,
            inhomogeneity_percent: inhomogeneity,
            ..NoiseSettings::default()
        }
    }

    fn deviation(settings: &NoiseSettings) -> f64 {
        let mut source = DynamicForce::new(settings, 2, 3, 1e-3);
        let n = 400_000_u64;
        let mut sum = 0.0;
        for k in 0..n {
            let x = source.update(k, k as f64 * 7e-3, 2000.0) - 1.0;
            sum += x * x;
        }
        (sum / n as f64).sqrt()
    }

    #[test]
    fn each_source_has_the_size_that_is_set() {
        assert!((deviation(&only(2.0, 0.0, 0.0)) - 0.02).abs() < 4e-4);
        assert!((deviation(&only(0.0, 2.0, 0.0)) - 0.02 / 2.0_f64.sqrt()).abs() < 1e-4);
        // Linear interpolation between cells takes a little variance; few independent lengths.
        assert!((deviation(&only(0.0, 0.0, 2.0)) - 0.02).abs() < 2e-3);
        assert_eq!(deviation(&NoiseSettings::default()), 0.0, "level 0 is silence");
    }

    #[test]
    fn each_source_keeps_mean_and_size_at_any_step() {
        let sizes = [
            (only(2.0, 0.0, 0.0), 0.02),
            (only(0.0, 1.5, 0.0), 0.015 / 2.0_f64.sqrt()),
            (only(0.0, 0.0, 2.0), 0.02),
        ];
        // At 1500 1/min two teeth pass in 20 ms, and so once, twice, a half or a whole number of times a step.
        for dt_s in [3.472e-5, 1e-3, 4e-3, 5e-3, 1e-2, 2e-2, 4e-2, 0.1] {
            for (settings, size) in &sizes {
                let mut source = DynamicForce::new(settings, 2, 3, dt_s);
                // As much way for each step: the field belongs to it.
                let found: Vec<f64> =
                    (0..200_000).map(|k| source.update(k, k as f64 * 0.1, 1500.0)).collect();
                let mean = stats::mean(found.iter().copied()).unwrap();
                let deviation = stats::deviation(&found).unwrap();
                // Band noise at the finest step is seen for seven seconds only.
                assert!((mean - 1.0).abs() < 1.2e-3, "{dt_s} s: mean {mean}");
                assert!((deviation / size - 1.0).abs() < 0.05, "{dt_s} s: {deviation}, {size}");
            }
        }
    }

    #[test]
    fn the_ripple_has_the_frequency_of_the_teeth() {
        let settings = only(0.0, 2.0, 0.0);
        let [mut two, mut four] = [2, 4].map(|teeth| DynamicForce::new(&settings, teeth, 3, 1e-3));
        for k in 0..500 {
            let [fast, slow] = [two.update(k, 0.0, 2400.0), four.update(k, 0.0, 1200.0)];
            assert!((fast - slow).abs() < 1e-9, "{k}: {fast} {slow}");
        }
    }

    #[test]
    fn the_inhomogeneity_belongs_to_the_position_not_to_the_time() {
        let settings = only(0.0, 0.0, 2.0);
        let mut slow = DynamicForce::new(&settings, 2, 3, 1e-3);
        let mut fast = DynamicForce::new(&settings, 2, 3, 1e-3);
        let mut at_slow = Vec::new();
        for k in 0..4000_u32 {
            at_slow.push(slow.update(u64::from(k), f64::from(k) * 0.01, 2000.0));
        }
        for k in 0..400_usize {
            let x = fast.update(k as u64, (k * 10) as f64 * 0.01, 500.0);
            assert!((x - at_slow[k * 10]).abs() < 1e-12);
        }
    }
}
