//! Modes from a measured frequency response at the tool's tip (`steadycut identify structure`).
//!
//! ```text
//! G(iw) = sum over r of (1/m_r) / (w_r^2 - w^2 + 2 i zeta_r w_r w)  +  R
//! ```
//!
//! Peaks of -Im G give the modes to begin with (peak picking: at resonance -Im G = 1 / (2 zeta k), and half of that at both
//! sides of it, 2 zeta w_r apart), then real and imaginary parts are fitted by least squares. R is what stiffer modes
//! beyond the recording add, a flexibility that stays; it is told, and no mode.

mod fit;
mod table;

pub use fit::identify_structure;

use super::estimate::EstimatedValue;
use crate::models::structure::Complex;
use crate::models::tip_modes::TipMode;

/// Fewest and most points of a response.
const POINTS: [usize; 2] = [20, 20_000];

/// A frequency response: displacement over force at the tip.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredResponse {
    /// Frequencies, Hz, ascending, above 0.
    pub frequency_hz: Vec<f64>,
    /// The response there, m/N.
    pub response_m_n: Vec<Complex>,
}

/// What was fitted to a response.
#[derive(Clone, Debug, PartialEq)]
pub struct ResponseFit {
    /// The modes, by frequency; their direction is the one that was said.
    pub modes: Vec<TipMode>,
    /// Flexibility of stiffer modes beyond the recording, m/N.
    pub residual_m_n: f64,
    /// What is left: root of the mean square of the difference over that of the response.
    pub rest: f64,
    /// Natural frequency in Hz, damping ratio and modal mass in kg of every mode with their 95 % intervals, which take what is
    /// left for noise from point to point.
    pub estimated: Vec<[EstimatedValue; 3]>,
}

impl ResponseFit {
    /// The fitted response at a frequency in Hz, m/N.
    #[must_use]
    pub fn at(&self, f_hz: f64) -> Complex {
        let s = Complex::new(0.0, crate::base::math::TAU * f_hz);
        self.modes
            .iter()
            .fold(Complex::from(self.residual_m_n), |sum, mode| sum + mode.compliance(s))
    }
}

#[cfg(test)]
mod tests;
