//! The sound of the cut as samples that loop: the machine's model driven by the passing teeth.
//!
//! ```text
//! force   sin(phi) from entry to 51.3 degrees per tooth, every other tooth by the run-out's share
//!         stronger: lines at the harmonics of the spindle; beside them random lines, r_d in all
//! sound   (i w)^s G_rel(w) F(w): the velocity between tooth and work for s = 1
//! ```
//!
//! All lines lie on those of the block, so that its end meets its start; the spindle's frequency is
//! rounded to the nearest one. The level is that of the worn tool at this speed: half of full scale,
//! so a sharp tool is quieter by the model's own ratio and there is headroom for more force.

use crate::base::fft::synthesise;
use crate::base::math;
use crate::base::rng::Stream;
use crate::base::units::rev_s_from_rpm;
use crate::models::machine_trend::MachineTrend;
use crate::models::structure::Complex;
use crate::models::structure::frf::LAST_HZ;

/// Samples of a block: 2.7 s at 48 kHz.
pub const SAMPLES: usize = 1 << 17;
/// Largest sample of the worn tool.
const LEVEL: f64 = 0.5;
/// Angle over which a tooth cuts, in radians: the papers' cut.
const ENGAGEMENT: f64 = 51.3 / 180.0 * math::PI;
/// Share by which run-out makes every other tooth stronger and weaker (chosen).
const RUNOUT_RATIO: f64 = 0.1;

/// integral of sin(phi) e^{-i m phi} over the engagement, over a turn.
fn pulse(m: f64) -> Complex {
    let (sin, cos) = (math::sin(ENGAGEMENT), math::cos(ENGAGEMENT));
    let whole = if m == 1.0 {
        Complex::new(0.5 * sin * sin, 0.5 * (sin * cos - ENGAGEMENT))
    } else {
        let angle = m * ENGAGEMENT;
        let end = Complex::new(math::cos(angle), -math::sin(angle)) * Complex::new(cos, m * sin);
        (Complex::new(1.0, 0.0) - end) / (1.0 - m * m)
    };
    whole / math::TAU
}

/// The sound of one cut.
#[derive(Clone, Debug)]
pub struct CutSound {
    model: MachineTrend,
    line_hz: f64,
    /// Lines from one harmonic of the spindle to the next; 0 for a spindle at rest.
    spindle_lines: usize,
    random: Stream,
    gain: f64,
}

impl CutSound {
    /// The sound of the machine at a spindle speed in 1/min, for playing at `rate_hz` samples a
    /// second.
    #[must_use]
    pub fn new(model: &MachineTrend, speed_rpm: f64, rate_hz: u32, seed: u64) -> Self {
        let line_hz = f64::from(rate_hz.max(1)) / SAMPLES as f64;
        let spindle_lines = (rev_s_from_rpm(math::positive(speed_rpm)) / line_hz).round() as usize;
        let random = Stream::new(seed, "sound.random");
        let mut this = Self { model: model.clone(), line_hz, spindle_lines, random, gain: 1.0 };
        let worn = this.raw(1.0, 1.0);
        let peak = worn.iter().fold(0.0_f64, |peak, z| peak.max(z.re.abs()));
        this.gain = if peak > 0.0 { LEVEL / peak } else { 0.0 };
        this
    }

    /// Frequency of the spindle as it sounds, Hz.
    #[must_use]
    pub fn spindle_hz(&self) -> f64 {
        self.spindle_lines as f64 * self.line_hz
    }

    /// Force as fractions of the peak on line `j`, without the random part.
    fn periodic(&self, j: usize) -> Complex {
        if self.spindle_lines == 0 || !j.is_multiple_of(self.spindle_lines) {
            return Complex::new(0.0, 0.0);
        }
        let harmonic = j / self.spindle_lines;
        let teeth = self.model.tool.teeth;
        let weight = if harmonic.is_multiple_of(teeth as usize) { 1.0 } else { RUNOUT_RATIO };
        // Both signs of the frequency in one line.
        pulse(harmonic as f64) * (2.0 * f64::from(teeth) * weight)
    }

    /// The sound before the gain, in the real parts.
    fn raw(&self, x: f64, force_ratio: f64) -> Vec<Complex> {
        let model = &self.model;
        let w = model.wear.wear(x);
        let (worn, damping) = (model.worn(w), model.damping_n_s_m(w));
        let force_n = model.life.contact_force_n * model.wear.force_factor(w) * force_ratio;
        let last = ((f64::from(LAST_HZ) / self.line_hz) as usize).min(SAMPLES / 2 - 1);
        let random = model.life.random_ratio * (2.0 / last.max(1) as f64).sqrt();
        let mut lines = vec![Complex::new(0.0, 0.0); SAMPLES];
        for (j, line) in lines.iter_mut().enumerate().take(last + 1).skip(1) {
            let f_hz = j as f64 * self.line_hz;
            let angle = math::TAU * self.random.uniform(j as u64);
            let noise = Complex::new(math::cos(angle), math::sin(angle)) * random;
            let rate = Complex::new(0.0, math::TAU * f_hz);
            let power = match model.life.sound_exponent {
                0 => Complex::new(1.0, 0.0),
                1 => rate,
                _ => rate * rate,
            };
            let force = (self.periodic(j) + noise) * force_n;
            *line = power * model.response(&worn, damping, f_hz) * force;
        }
        synthesise(&mut lines);
        lines
    }

    /// [`SAMPLES`] samples in -1..1 at the fraction `x` of the life, for a force as fractions of the
    /// model's contact force (0 in the air: silence).
    #[must_use]
    pub fn block(&self, x: f64, force_ratio: f64) -> Vec<f32> {
        let raw = self.raw(x, math::limit(force_ratio, 0.0, 10.0));
        raw.iter().map(|z| math::limit(self.gain * z.re, -1.0, 1.0) as f32).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine_life::model;
    use crate::run::scenario::Scenario;

    const RATE_HZ: u32 = 48_000;

    fn sound(speed_rpm: f64) -> CutSound {
        CutSound::new(&model(&Scenario::default()), speed_rpm, RATE_HZ, 1)
    }

    /// Power of every line.
    fn powers(block: &[f32]) -> Vec<f64> {
        let mut lines: Vec<Complex> =
            block.iter().map(|x| Complex::new(f64::from(*x), 0.0)).collect();
        synthesise(&mut lines);
        lines.iter().map(Complex::norm_sqr).collect()
    }

    fn rms(block: &[f32]) -> f64 {
        let squares: f64 = block.iter().map(|x| f64::from(*x) * f64::from(*x)).sum();
        (squares / block.len() as f64).sqrt()
    }

    #[test]
    fn the_teeth_sound_at_their_harmonics_and_the_spindle_at_its_mode() {
        let sound = sound(1200.0);
        let powers = powers(&sound.block(0.3, 1.0));
        let line = |f_hz: f64| (f_hz * SAMPLES as f64 / f64::from(RATE_HZ)).round() as usize;
        let passing_hz = 2.0 * sound.spindle_hz();
        assert!((passing_hz - 40.0).abs() < 0.4);
        for k in 1..=6 {
            let at = line(f64::from(k) * passing_hz);
            let beside: f64 = powers[at + 3..at + 23].iter().sum::<f64>() / 20.0;
            assert!(powers[at] > 30.0 * beside, "harmonic {k}: {} {beside}", powers[at]);
        }
        // Between the spindle's lines only the random part is left; it peaks at 110 Hz.
        let between = |from_hz: f64, to_hz: f64| {
            let lines = line(from_hz)..line(to_hz);
            let n = lines.len() as f64;
            powers[lines].iter().sum::<f64>() / n
        };
        let mode = between(106.0, 114.0);
        assert!(mode > 3.0 * between(66.0, 74.0) && mode > 10.0 * between(206.0, 214.0));
        assert!(powers[line(3100.0)..SAMPLES / 2].iter().all(|power| *power < 1e-6 * mode));
    }

    #[test]
    fn wear_makes_it_louder_within_the_headroom_and_air_is_silent() {
        let sound = sound(1592.0);
        let blocks = [0.0, 0.5, 1.0].map(|x| sound.block(x, 1.0));
        let [new, half, old] = [&blocks[0], &blocks[1], &blocks[2]].map(|block| rms(block));
        assert!(new < half && half < old, "{new} {half} {old}");
        assert!((1.5..1.95).contains(&(old / new)), "{}", old / new);
        let peak = blocks[2].iter().fold(0.0_f32, |peak, x| peak.max(x.abs()));
        assert!((peak - 0.5).abs() < 1e-6);
        let loud = sound.block(3.0, 10.0);
        assert!(loud.iter().all(|x| x.abs() <= 1.0));
        assert!(sound.block(0.5, 0.0).iter().all(|x| *x == 0.0));
    }

    #[test]
    fn a_block_loops_without_a_click_and_is_the_same_every_time() {
        let block = sound(1592.0).block(0.5, 1.0);
        let step = |i: usize| (block[(i + 1) % SAMPLES] - block[i]).abs();
        let largest = (0..SAMPLES - 1).map(step).fold(0.0, f32::max);
        assert!(step(SAMPLES - 1) <= largest && largest < 0.5);
        assert_eq!(block, sound(1592.0).block(0.5, 1.0));
        // A spindle at rest and a nonsense speed still give samples.
        for speed_rpm in [0.0, f64::NAN, 1e12] {
            assert!(sound(speed_rpm).block(0.5, 1.0).iter().all(|x| x.is_finite()));
        }
    }
}
