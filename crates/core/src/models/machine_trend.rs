//! Sound and roughness of the five-mass machine at a fraction x of the tool's life (2019, section 3).
//!
//! ```text
//! P(x), k3(x)                          see the wear model; P on every line of 10, 20, .. 3000 Hz
//! u_j = |G_rel(f_j)| P                 vibration between tooth and work
//! A_S(f_j) = (2 pi f_j)^s u_j          sound: s = 1 velocity, 0 bare amplitude, 2 monopole
//! E_S = mean of A_S,  u_rms = rms of u_j
//! sigma = r_d u_rms,  Ra = Ra(cusp, sigma)
//! ```
//!
//! The flat spectrum of the contact force is the only reading that the paper's symbols allow: its
//! absolute amplitudes are formal, the trends are not. r_d is chosen so that Ra is 0.256 um at 107 N,
//! where the 2007 paper's equation 8 gives 0.258 um; at other forces they part.

use super::roughness_trend::{cusp_mm, ra_um};
use super::structure::Complex;
use super::structure::FiveMass;
use super::structure::engagement::EngagementAngles;
use super::structure::frf::{LAST_HZ, STEP_HZ, Tree};
use super::tool::Tool;
use super::wear::{WearCut, WearSettings};
use crate::base::math::TAU;

crate::settings! {
    /// Sound, its measurement, and the prediction of tool life from it.
    pub struct LifeSettings {
        /// Contact force of the sharp tool, as printed in 2019.
        contact_force_n: f64 = 107.0, [1.0, 5000.0], "N", live, "Contact force";
        /// Power of the frequency by which vibration sounds: 0 amplitude, 1 velocity, 2 monopole.
        sound_exponent: u32 = 1, [0.0, 2.0], "", live, "Sound exponent";
        /// Random over nominal contact force: what roughens the surface.
        random_ratio: f64 = 0.05, [0.0, 1.0], "", live, "Random force";
        /// White noise of a measured sound trend, per second.
        white_percent: f64 = 1.73, [0.0, 50.0], "%", live, "White noise of the trend";
        /// Slow noise of a measured sound trend.
        slow_percent: f64 = 1.0, [0.0, 20.0], "%", live, "Slow noise of the trend";
        /// Correlation time of the slow noise.
        slow_min: f64 = 5.0, [1.0, 60.0], "min", live, "Memory of the slow noise";
        /// Noise of a measured spectrum over the deviation of its lines.
        spectrum_ratio: f64 = 1.066, [0.0, 10.0], "", live, "Noise of the spectrum";
        /// Tool life that the speed is adjusted to.
        tool_life_min: f64 = 240.0, [10.0, 2000.0], "min", live, "Tool life wanted";
        /// Deviation of a minute's mean that the prediction expects.
        sigma_percent: f64 = 1.2, [0.1, 20.0], "%", live, "Expected noise";
        /// Minutes that the prediction counts as one, since neighbours err alike.
        correlated_min: f64 = 5.0, [1.0, 60.0], "min", live, "Expected memory";
        /// Spread of the logarithm of the tool life before the first observation.
        prior_spread: f64 = 0.3, [0.05, 0.6], "", live, "Spread of tool lives";
    }
}

/// Mean number of engaged teeth of the papers' cut as the model was calibrated: two teeth, 51.3 degrees
/// each at 3 mm of 16 mm. Other cuts engage more in proportion to their window.
pub const ENGAGED: f64 = 0.285;
/// Radial depth of that cut, mm.
const ENGAGED_RADIAL_MM: f64 = 3.0;

/// Sound and roughness at one fraction of the life.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct TrendPoint {
    /// Fraction of the life.
    pub x: f64,
    /// Wear, 1 at the end of life.
    pub wear: f64,
    /// Flank wear land, mm.
    pub flank_mm: f64,
    /// Contact force, N.
    pub force_n: f64,
    /// Mean amplitude of the sound; m/s for the exponent 1.
    pub sound: f64,
    /// Root mean square of the vibration, m.
    pub vibration_rms_m: f64,
    /// Roughness, um.
    pub ra_um: f64,
}

/// A line of the spectrum.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct TrendLine {
    /// Frequency, Hz.
    pub f_hz: f64,
    /// Vibration between tooth and work, m.
    pub vibration_m: f64,
    /// Amplitude of the sound.
    pub sound: f64,
}

/// The machine with its tool in a cut.
#[derive(Clone, Debug, PartialEq)]
pub struct MachineTrend {
    /// The machine with a sharp tool.
    pub machine: FiveMass,
    /// Wear.
    pub wear: WearSettings,
    /// Sound and random force.
    pub life: LifeSettings,
    /// The cut.
    pub cut: WearCut,
    /// The cutter.
    pub tool: Tool,
    /// Radial depth of the cut, mm.
    pub radial_depth_mm: f64,
}

impl MachineTrend {
    /// The machine at wear `w`: a softer tooth of unchanged quality.
    #[must_use]
    pub fn worn(&self, w: f64) -> FiveMass {
        let factor = self.wear.stiffness_factor(w);
        let elements = &self.machine.elements;
        self.machine.with_tooth(
            elements.stiffness_n_m[2] * factor,
            elements.damping_n_s_m[2] * factor.sqrt(),
        )
    }

    /// G_rel in m/N of a machine that [`Self::worn`] made at wear `w`, process damping included.
    #[must_use]
    #[inline]
    pub fn response(&self, worn: &FiveMass, damping_n_s_m: f64, f_hz: f64) -> Complex {
        let s = Complex::new(0.0, TAU * f_hz);
        let free = Tree::new(worn, s).relative();
        free / (Complex::new(1.0, 0.0) + s * free * damping_n_s_m)
    }

    /// Process damping at wear `w`, N s/m; see [`WearSettings::process_damping_n_s_m`].
    #[must_use]
    pub fn damping_n_s_m(&self, w: f64) -> f64 {
        let WearCut { cutting_speed_m_min, axial_depth_mm, .. } = self.cut;
        self.wear.process_damping_n_s_m(w, self.engaged(), axial_depth_mm, cutting_speed_m_min)
    }

    /// Mean number of engaged teeth.
    #[must_use]
    pub fn engaged(&self) -> f64 {
        let mean = |tool: &Tool, radial_mm: f64| {
            EngagementAngles::side_milling(tool.teeth, radial_mm, tool.diameter_mm).mean_teeth()
        };
        let papers = mean(&Tool::default(), ENGAGED_RADIAL_MM);
        ENGAGED * (mean(&self.tool, self.radial_depth_mm) / papers)
    }

    fn line(&self, worn: &FiveMass, damping_n_s_m: f64, force_n: f64, f_hz: f64) -> TrendLine {
        let vibration_m = self.response(worn, damping_n_s_m, f_hz).norm_sqr().sqrt() * force_n;
        let rate = TAU * f_hz;
        let power = match self.life.sound_exponent {
            0 => 1.0,
            1 => rate,
            _ => rate * rate,
        };
        TrendLine { f_hz, vibration_m, sound: power * vibration_m }
    }

    /// The lines of 10, 20, .. 3000 Hz at the fraction `x` of the life.
    pub fn spectrum(&self, x: f64) -> impl Iterator<Item = TrendLine> {
        let w = self.wear.wear(x);
        let (worn, damping_n_s_m) = (self.worn(w), self.damping_n_s_m(w));
        let force_n = self.life.contact_force_n * self.wear.force_factor(w);
        let lines = (STEP_HZ..=LAST_HZ).step_by(STEP_HZ as usize).map(f64::from);
        lines.map(move |f_hz| self.line(&worn, damping_n_s_m, force_n, f_hz))
    }

    /// Sound and roughness at the fraction `x` of the life (2019, section 3; the equations at the head).
    #[must_use]
    pub fn at(&self, x: f64) -> TrendPoint {
        let (mut sound, mut squares, mut lines) = (0.0, 0.0, 0.0);
        for line in self.spectrum(x) {
            sound += line.sound;
            squares += line.vibration_m * line.vibration_m;
            lines += 1.0;
        }
        let wear = self.wear.wear(x);
        let vibration_rms_m = (squares / lines).sqrt();
        let cusp_um = 1000.0 * cusp_mm(self.cut.feed_per_tooth_mm, &self.tool.outline());
        TrendPoint {
            x,
            wear,
            flank_mm: self.wear.flank_mm(wear),
            force_n: self.life.contact_force_n * self.wear.force_factor(wear),
            sound: sound / lines,
            vibration_rms_m,
            ra_um: ra_um(cusp_um, self.life.random_ratio * vibration_rms_m * 1e6),
        }
    }
}

#[cfg(test)]
#[path = "machine_trend/tests.rs"]
mod tests;
