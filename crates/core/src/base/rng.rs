//! Random numbers: counter-based, one stream per labelled source.
//!
//! A draw is a pure function of (key, counter): no hidden state, so lanes of runs, snapshots and
//! replays draw the same numbers whatever was drawn before. The mixer is the finaliser of
//! SplitMix64 (Steele, Lea, Flood 2014; constants of Stafford's variant 13), applied twice.
//!
//! The normal deviate is branch-free and uses only exact integer and IEEE operations: the sum of
//! eight 16-bit uniforms (Irwin-Hall) has excess kurtosis -0.15, which one Cornish-Fisher term
//! removes. Its distribution function is within 1e-3 of the normal one and it is bounded by about
//! 5.7 standard deviations, both held by tests: physical noise has no further tail.

/// One labelled stream of random numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stream {
    key: u64,
}

fn mix(mut z: u64) -> u64 {
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

const GAMMA: u64 = 0x9e37_79b9_7f4a_7c15;
/// Standard deviation of the sum of eight uniforms on 0..65535, sqrt(8 (2^32 - 1) / 12).
const SUM_SD: f64 = 53_509.919_921_450_08;
/// Mean of that sum.
const SUM_MEAN: f64 = 8.0 * 65_535.0 / 2.0;
/// Excess kurtosis -1.2/8 over 24: the Cornish-Fisher coefficient.
const KURTOSIS_TERM: f64 = 0.15 / 24.0;
/// Restores unit variance after the cubic term (from the exact moments of the sum).
const UNIT_VARIANCE: f64 = 1.000_845_658_552_905;

impl Stream {
    /// The stream of the source `label` (for example `"noise.band"`) under `seed`.
    #[must_use]
    pub fn new(seed: u64, label: &str) -> Self {
        let mut key = mix(seed.wrapping_add(GAMMA));
        for byte in label.bytes() {
            key = mix(key ^ u64::from(byte)).wrapping_add(GAMMA);
        }
        Self { key }
    }

    /// 64 uniform random bits, draw number `counter`.
    #[must_use]
    #[inline]
    pub fn bits(self, counter: u64) -> u64 {
        mix(mix(self.key.wrapping_add(counter.wrapping_mul(GAMMA))) ^ self.key)
    }

    /// A uniform deviate in 0..1 (53 bits), draw number `counter`.
    #[must_use]
    pub fn uniform(self, counter: u64) -> f64 {
        (self.bits(counter) >> 11) as f64 * (1.0 / 9_007_199_254_740_992.0)
    }

    /// A whole number uniform in 0..`end`, draw number `counter` (0 for `end` 0).
    #[must_use]
    pub fn below(self, counter: u64, end: u64) -> u64 {
        ((u128::from(self.bits(counter)) * u128::from(end)) >> 64) as u64
    }

    /// A standard normal deviate, draw number `counter`.
    #[must_use]
    #[inline]
    pub fn normal(self, counter: u64) -> f64 {
        let a = self.bits(counter);
        let b = mix(a ^ GAMMA);
        const LANES: u64 = 0x0000_ffff_0000_ffff;
        // Four 16-bit numbers of each word in two 32-bit lanes: no carries between lanes.
        let lanes = (a & LANES) + ((a >> 16) & LANES) + (b & LANES) + ((b >> 16) & LANES);
        let sum = (lanes & 0xffff_ffff) + (lanes >> 32);
        let x = (sum as f64 - SUM_MEAN) * (1.0 / SUM_SD);
        (x + KURTOSIS_TERM * (x * x * x - 3.0 * x)) * UNIT_VARIANCE
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn normal_cdf(x: f64) -> f64 {
        0.5 * libm::erfc(-x / std::f64::consts::SQRT_2)
    }

    #[test]
    fn normal_deviates_have_normal_moments_and_distribution() {
        let stream = Stream::new(7, "test");
        let n = 1_000_000_u64;
        let mut draws: Vec<f64> = (0..n).map(|i| stream.normal(i)).collect();
        let mean = |power: fn(f64) -> f64| draws.iter().map(|x| power(*x)).sum::<f64>() / n as f64;
        assert!(mean(|x| x).abs() < 4e-3, "mean");
        assert!((mean(|x| x * x) - 1.0).abs() < 6e-3, "variance {}", mean(|x| x * x));
        assert!(mean(|x| x * x * x).abs() < 0.016, "skewness");
        assert!(
            (mean(|x| x * x * x * x) - 3.0).abs() < 0.04,
            "kurtosis {}",
            mean(|x| x * x * x * x)
        );
        draws.sort_by(f64::total_cmp);
        let worst = draws
            .iter()
            .enumerate()
            .map(|(i, x)| (normal_cdf(*x) - (i as f64 + 0.5) / n as f64).abs())
            .fold(0.0, f64::max);
        assert!(worst < 2.5e-3, "Kolmogorov distance {worst}");
        assert!(draws[0] > -6.0 && draws[draws.len() - 1] < 6.0);
    }

    #[test]
    fn streams_are_independent_and_values_stable() {
        let (a, b) = (Stream::new(1, "a"), Stream::new(1, "b"));
        let n = 100_000;
        let cross = (0..n).map(|i| a.normal(i) * b.normal(i)).sum::<f64>() / n as f64;
        let serial = (0..n).map(|i| a.normal(i) * a.normal(i + 1)).sum::<f64>() / n as f64;
        assert!(cross.abs() < 0.013 && serial.abs() < 0.013, "{cross} {serial}");
        let below: Vec<u64> = (0..6000).map(|i| a.below(i, 6)).collect();
        for face in 0..6 {
            let count = below.iter().filter(|x| **x == face).count();
            assert!(count.abs_diff(1000) < 120, "{face}: {count}");
        }
        assert_ne!(Stream::new(1, "a").bits(0), Stream::new(2, "a").bits(0));
        // A change of the generator would silently change every golden digest: hold two values.
        // Computed by an independent implementation of the formulas at the head of this file.
        let stream = Stream::new(1, "noise.band");
        assert_eq!(stream.bits(0), 0x2be6_d2cc_5715_2b25);
        assert_eq!(stream.bits(12345), 0xdbaa_b91c_b4d6_c4c0);
    }
}
