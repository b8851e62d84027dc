//! How loud the teeth's pulses make the machine, in closed form.
//!
//! ```text
//! P(t)/F = sum over k of c_k e^{i k w_T t},  w_T = 2 pi N n/60,  a = k N
//! c_k    = N/(2 pi max g) [1 - e^{-i a phi_e} (cos phi_e + i a sin phi_e)] / (1 - a^2)
//! v_rms  = F sqrt( sum over k >= 1 of 2 |c_k|^2 (k w_T)^2 |G(i k w_T) - 1/k3|^2 )
//! ```
//!
//! The velocity of the modes, as the sound of the running cut takes it; the tooth's own spring follows the force's
//! jump at once, for which there is no velocity. In a settled cut the tooth before left the same
//! surface, so regeneration does not enter.

use super::Complex;
use super::engagement::EngagementAngles;
use super::reduction::Reduction;
use crate::base::math::{self, TAU};

/// Harmonics that are summed: the last ones lie beyond 2 kHz at the slowest speed of the papers.
const HARMONICS: u32 = 60;

/// Root mean square of the velocity between tooth and work in m/s for a peak force of 1 N at a speed
/// in 1/min, of a cutter with at least two teeth; 0 where nothing is cut.
#[must_use]
pub fn velocity_m_s_n(machine: &Reduction, cut: &EngagementAngles, speed_rpm: f64) -> f64 {
    let (peak, teeth) = (cut.peak_chip(), f64::from(cut.teeth));
    if peak <= 0.0 || speed_rpm <= 0.0 {
        return 0.0;
    }
    let (sine, cosine) = (math::sin(cut.angle_rad), math::cos(cut.angle_rad));
    let passing = TAU * teeth * speed_rpm / 60.0;
    let squares = (1..=HARMONICS).map(|k| {
        let a = f64::from(k) * teeth;
        let turned = a * cut.angle_rad;
        let turn = Complex::new(math::cos(turned), -math::sin(turned));
        let integral = (Complex::from(1.0) - turn * Complex::new(cosine, a * sine)) / (1.0 - a * a);
        let omega = f64::from(k) * passing;
        let modes = machine.at(Complex::new(0.0, omega)) - machine.feedthrough_m_n;
        let share = teeth / (TAU * peak);
        2.0 * share * share * integral.norm_sqr() * omega * omega * modes.norm_sqr()
    });
    squares.sum::<f64>().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::structure::{FiveMass, MachineSettings};

    #[test]
    fn the_sum_is_the_rms_of_the_sampled_response() {
        // Fourier coefficients by sums of samples in place of the closed form.
        let machine = Reduction::new(&FiveMass::new(&MachineSettings::default())).unwrap();
        let cut = EngagementAngles::side_milling(2, 3.0, 16.0);
        for speed_rpm in [1571.0, 2134.0] {
            let passing = TAU * 2.0 * speed_rpm / 60.0;
            let samples = 20_000;
            let squares: f64 = (1..=60)
                .map(|k| {
                    let mut c = Complex::default();
                    for i in 0..samples {
                        let phi = math::PI * (f64::from(i) + 0.5) / f64::from(samples);
                        if phi < cut.angle_rad {
                            let turned = f64::from(2 * k) * phi;
                            let turn = Complex::new(math::cos(turned), -math::sin(turned));
                            c += turn * (math::sin(phi) / cut.peak_chip() / f64::from(samples));
                        }
                    }
                    let omega = f64::from(k) * passing;
                    let modes = machine.at(Complex::new(0.0, omega)) - machine.feedthrough_m_n;
                    2.0 * (c * modes * omega).norm_sqr()
                })
                .sum();
            let found = velocity_m_s_n(&machine, &cut, speed_rpm);
            assert!((found / squares.sqrt() - 1.0).abs() < 1e-3, "{found} {}", squares.sqrt());
        }
        let resonant = velocity_m_s_n(&machine, &cut, 1649.0);
        assert!(resonant > 1.5 * velocity_m_s_n(&machine, &cut, 2134.0));
        assert_eq!(velocity_m_s_n(&machine, &cut, 0.0), 0.0);
        let air = EngagementAngles::side_milling(2, 0.0, 16.0);
        assert_eq!(velocity_m_s_n(&machine, &air, 1571.0), 0.0);
    }
}
