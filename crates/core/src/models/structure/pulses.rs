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
use crate::base::units::rev_s_from_rpm;
use crate::models::spindle::SLOWEST_RPM;

/// Fewest harmonics that are summed; they reach [`HIGHEST_HZ`] at the slowest speed of the papers.
const HARMONICS: f64 = 60.0;
/// Frequency up to which harmonics are summed at any slower speed too, Hz: all modes but the tooth's lie well
/// below it.
const HIGHEST_HZ: f64 = 2000.0;
/// Slowest tooth passing that is summed up to [`HIGHEST_HZ`], Hz: one tooth at the slowest speed that can be
/// programmed. What is slower has no resonance left, and lacks the harmonics beyond 1200 times its own.
const SLOWEST_HZ: f64 = SLOWEST_RPM / 60.0;

/// Root mean square of the velocity between tooth and work in m/s for a peak force of 1 N at a speed
/// in 1/min; 0 where nothing is cut.
#[must_use]
pub fn velocity_m_s_n(machine: &Reduction, cut: &EngagementAngles, speed_rpm: f64) -> f64 {
    let passing_hz = (f64::from(cut.teeth) * rev_s_from_rpm(speed_rpm)).max(SLOWEST_HZ);
    let harmonics = (HIGHEST_HZ / passing_hz).ceil().max(HARMONICS) as u32;
    velocity_by(machine, cut, speed_rpm, harmonics)
}

/// The same by so many harmonics.
fn velocity_by(machine: &Reduction, cut: &EngagementAngles, speed_rpm: f64, harmonics: u32) -> f64 {
    let (peak, teeth) = (cut.peak_chip(), f64::from(cut.teeth));
    if peak <= 0.0 || speed_rpm <= 0.0 {
        return 0.0;
    }
    let (sine, cosine) = (math::sin(cut.angle_rad), math::cos(cut.angle_rad));
    let passing = TAU * teeth * speed_rpm / 60.0;
    let squares = (1..=harmonics).map(|k| {
        let a = f64::from(k) * teeth;
        let turned = a * cut.angle_rad;
        let turn = Complex::new(math::cos(turned), -math::sin(turned));
        // Of sin(phi) e^{-i a phi} over the window; one tooth's first harmonic is the limit at a = 1.
        let integral = if a == 1.0 {
            (Complex::from(1.0) - turn * turn) / 4.0 - Complex::new(0.0, 0.5 * cut.angle_rad)
        } else {
            (Complex::from(1.0) - turn * Complex::new(cosine, a * sine)) / (1.0 - a * a)
        };
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
        for (teeth, speed_rpm) in [(2, 1571.0), (2, 2134.0), (1, 2134.0), (5, 700.0)] {
            let cut = EngagementAngles::side_milling(teeth, 3.0, 16.0);
            let number = f64::from(teeth);
            let passing = TAU * number * speed_rpm / 60.0;
            let samples = 20_000;
            let squares: f64 = (1..=60)
                .map(|k| {
                    let mut c = Complex::default();
                    for i in 0..samples {
                        let phi = math::PI * (f64::from(i) + 0.5) / f64::from(samples);
                        if phi < cut.angle_rad {
                            let turned = f64::from(teeth * k) * phi;
                            let turn = Complex::new(math::cos(turned), -math::sin(turned));
                            let chip = math::sin(phi) / cut.peak_chip();
                            c += turn * (0.5 * number * chip / f64::from(samples));
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
        // At a slow speed it takes more harmonics to reach the modes: 60 of one tooth end at 100 Hz.
        let one = EngagementAngles::side_milling(1, 3.0, 16.0);
        let slow = velocity_m_s_n(&machine, &one, 100.0);
        let more = velocity_by(&machine, &one, 100.0, 4800);
        assert!((slow / more - 1.0).abs() < 0.02, "{slow} {more}");
        assert!(slow > 1.2 * velocity_by(&machine, &one, 100.0, 60), "{slow}");
        let cut = EngagementAngles::side_milling(2, 3.0, 16.0);
        let resonant = velocity_m_s_n(&machine, &cut, 1649.0);
        assert!(resonant > 1.5 * velocity_m_s_n(&machine, &cut, 2134.0));
        assert_eq!(velocity_m_s_n(&machine, &cut, 0.0), 0.0);
        let air = EngagementAngles::side_milling(2, 0.0, 16.0);
        assert_eq!(velocity_m_s_n(&machine, &air, 1571.0), 0.0);
    }
}
