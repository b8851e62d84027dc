//! The machine for the running cut: the tooth as a spring without mass (reduction R1).
//!
//! ```text
//! zeta_3 = zeta_2 + P_3 / k3
//! G(s) = 1/k3 + sum over r = 1..4 of [ R_r / (s - l_r) + its conjugate ]
//! ```
//!
//! The tooth's own pole (-1.3e6 +- 2.6e7 i) decays in 0.8 us; without it eight states and one
//! feedthrough remain, wrong by at most 2.9e-4 of G_rel from 0 to 3000 Hz, at the antiresonance.

use super::modes::{eigenvalues, from_starts};
use super::{Complex, FiveMass};
use crate::base::language::tr;
use crate::base::settings::SettingError;
use crate::models::tip_modes::{TipAxis, TipModes};

/// Poles, residues and feedthrough of the reduced machine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reduction {
    /// l_r, rad/s, by rising size; of a conjugate pair the one with positive imaginary part.
    pub poles: [Complex; 4],
    /// R_r, m/(N s).
    pub residues: [Complex; 4],
    /// 1/k3, m/N: the tooth.
    pub feedthrough_m_n: f64,
}

#[cfg(test)]
thread_local! {
    static SOLVED: std::cell::Cell<u32> = const { std::cell::Cell::new(0) };
}

impl Reduction {
    /// Reduces the machine.
    ///
    /// # Errors
    /// A machine with overdamped modes, as the printed parameters make it: the recursion runs in
    /// conjugate pairs.
    pub fn new(machine: &FiveMass) -> Result<Self, SettingError> {
        #[cfg(test)]
        SOLVED.with(|solved| solved.set(solved.get() + 1));
        let refused = || SettingError::Refused {
            path: "machine.parameters".to_owned(),
            value: "a machine with overdamped modes in a running cut".to_owned(),
            allowed: "D or T; the printed parameters serve `steadycut machine modes` and `frf`"
                .to_owned(),
        };
        let starts =
            eigenvalues(&machine.elements.mass_kg, &machine.damping(), &machine.stiffness());
        let mut starts = starts.ok_or_else(refused)?;
        starts.sort_by(|x, y| x.norm_sqr().total_cmp(&y.norm_sqr()));
        starts.truncate(8);
        let mut reduced = *machine;
        reduced.elements.mass_kg[2] = 0.0;
        reduced.elements.damping_n_s_m[2] = 0.0;
        let modes = from_starts(&reduced, starts);
        let paired = modes.len() == 4 && modes.iter().all(|mode| mode.pole.im > 0.0);
        if !paired {
            return Err(refused());
        }
        Ok(Self {
            poles: [0, 1, 2, 3].map(|r| modes[r].pole),
            residues: [0, 1, 2, 3].map(|r| modes[r].residue),
            feedthrough_m_n: 1.0 / machine.elements.stiffness_n_m[2],
        })
    }

    /// Measured modes across the feed as the machine of the running cut: the tooth is stiff, all compliance is in the
    /// modes. Of a mode with mass m and pole l the residue is 1 / (2 i m Im l); places that are left over give way by
    /// nothing.
    ///
    /// # Errors
    /// No mode across the feed, or more than four.
    pub fn of_tip(modes: &TipModes) -> Result<Self, SettingError> {
        let across: Vec<_> = modes.along(TipAxis::Y).collect();
        if across.is_empty() || across.len() > 4 {
            return Err(SettingError::Refused {
                path: "machine.tip_modes".to_owned(),
                value: tr!("{n} modes across the feed in a running cut", n = across.len()),
                allowed: tr("1 to 4 modes across the feed, which the surface sees").to_owned(),
            });
        }
        let mut reduction = Self {
            poles: [Complex::new(-1e3, 1e3); 4],
            residues: [Complex::from(0.0); 4],
            feedthrough_m_n: 0.0,
        };
        for (r, mode) in across.iter().enumerate() {
            let pole = mode.pole();
            reduction.poles[r] = pole;
            reduction.residues[r] = Complex::new(0.0, -0.5 / (mode.mass_kg * pole.im));
        }
        Ok(reduction)
    }

    /// How many machines this thread's tests have reduced.
    #[cfg(test)]
    pub(crate) fn solved() -> u32 {
        SOLVED.with(std::cell::Cell::get)
    }

    /// G(s), m/N, at s in rad/s.
    #[must_use]
    pub fn at(&self, s: Complex) -> Complex {
        let pairs = self.poles.iter().zip(&self.residues);
        pairs.fold(Complex::from(self.feedthrough_m_n), |sum, (pole, residue)| {
            sum + *residue / (s - *pole) + residue.conj() / (s - pole.conj())
        })
    }

    /// The bits of all numbers, for the test that they are equal natively and in wasm.
    #[must_use]
    pub fn bits(&self) -> Vec<u64> {
        let complex = self.poles.iter().chain(&self.residues).flat_map(|z| [z.re, z.im]);
        complex.chain([self.feedthrough_m_n]).map(f64::to_bits).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::math::{self, TAU};
    use crate::models::structure::frf::{frequencies_hz, tree};
    use crate::models::structure::modes::damped;
    use crate::models::structure::parameters::Parameters;
    use crate::models::structure::{MachineSettings, Variant};

    fn standard() -> FiveMass {
        FiveMass::new(&MachineSettings::default())
    }

    fn size(z: Complex) -> f64 {
        z.norm_sqr().sqrt()
    }

    #[test]
    fn modes_at_the_tip_are_their_own_reduction() {
        use crate::models::tip_modes::TipMode;
        let mode = |axis, frequency_hz, mass_kg| TipMode {
            axis,
            frequency_hz,
            damping_ratio: 0.03,
            mass_kg,
        };
        let across = [mode(TipAxis::Y, 310.0, 2.0), mode(TipAxis::Y, 890.0, 0.4)];
        let along = mode(TipAxis::X, 500.0, 1.0);
        let modes = TipModes::new(vec![across[0], along, across[1]]).unwrap();
        let reduction = Reduction::of_tip(&modes).unwrap();
        for f_hz in [0.0, 100.0, 310.0, 700.0, 895.0, 3000.0] {
            let s = Complex::new(0.0, TAU * f_hz);
            let known = modes.compliance(TipAxis::Y, s);
            assert!(size(reduction.at(s) - known) < 1e-12 * size(known), "{f_hz}");
        }
        for wrong in [vec![along], vec![across[0]; 5]] {
            let error = Reduction::of_tip(&TipModes::new(wrong).unwrap()).unwrap_err().to_string();
            assert!(error.contains("machine.tip_modes") && error.contains("1 to 4"), "{error}");
        }
    }

    #[test]
    fn poles_and_residues_meet_the_reference() {
        let reduction = Reduction::new(&standard()).unwrap();
        let reference = [
            (-68.992_176_023_419, 687.253_731_307_13, -3.086_546_531_6e-8, -4.255_285_912_841_9e-5),
            (-102.766_480_988_69, 965.256_560_909_33, 2.587_739_794_08e-8, -1.295_882_314_391_2e-6),
            (
                -288.342_712_175_46,
                1_605.071_674_384_1,
                -7.432_709_778_05e-9,
                -1.304_946_409_504_6e-7,
            ),
            (
                -554.818_136_751_87,
                2_164.367_109_400_3,
                1.242_077_715_36e-8,
                -1.623_862_944_163_6e-7,
            ),
        ];
        for (r, (re, im, res_re, res_im)) in reference.into_iter().enumerate() {
            let (pole, residue) = (Complex::new(re, im), Complex::new(res_re, res_im));
            let gap = size(reduction.poles[r] - pole) / size(pole);
            assert!(gap < 1e-12, "pole {r}: {gap:e}");
            let gap = size(reduction.residues[r] - residue) / size(residue);
            assert!(gap < 1e-10, "residue {r}: {gap:e}");
        }
    }

    /// How far a model of G_rel is off from 0 to 3000 Hz: largest relative error and where, Hz, largest
    /// absolute error, m/N, and the relative error of the sum of squares.
    fn off(model: impl Fn(f64) -> Complex) -> [f64; 4] {
        let machine = standard();
        let (mut worst, mut at, mut absolute, mut off, mut all) = (0.0_f64, 0.0, 0.0_f64, 0.0, 0.0);
        for f_hz in frequencies_hz() {
            let full = tree(&machine, f_hz).grel;
            let gap = size(model(f_hz) - full);
            if gap / size(full) > worst {
                (worst, at) = (gap / size(full), f_hz);
            }
            absolute = absolute.max(gap);
            off += gap * gap;
            all += full.norm_sqr();
        }
        [worst, at, absolute, (off / all).sqrt()]
    }

    /// The first modes alone, without the tooth.
    fn modes_at(reduction: &Reduction, count: usize, f_hz: f64) -> Complex {
        let s = Complex::new(0.0, TAU * f_hz);
        let pairs = reduction.poles.iter().zip(&reduction.residues).take(count);
        pairs.map(|(l, r)| r / (s - l) + r.conj() / (s - l.conj())).sum()
    }

    #[test]
    fn the_reduction_is_as_near_as_stated() {
        let reduction = Reduction::new(&standard()).unwrap();
        let [worst, at, absolute, all] = off(|f_hz| reduction.at(Complex::new(0.0, TAU * f_hz)));
        assert!((worst / 2.9e-4 - 1.0).abs() < 0.02 && at == 580.0, "{worst:e} at {at} Hz");
        assert!((absolute / 3.6e-13 - 1.0).abs() < 0.02, "{absolute:e}");
        assert!((all / 3.1e-6 - 1.0).abs() < 0.02, "{all:e}");
    }

    #[test]
    fn smaller_models_are_as_far_off_as_stated_and_a_static_remainder_is_worse() {
        let machine = standard();
        let reduction = Reduction::new(&machine).unwrap();
        let tooth = Complex::new(reduction.feedthrough_m_n, 0.0);
        let near = |found: f64, stated: f64| (found / stated - 1.0).abs() < 0.06;
        for (modes, stated) in [
            (3, [0.32, 3.0e-10, 1.3e-3]),
            (2, [0.47, 6.3e-10, 2.5e-3]),
            (1, [1.3, 1.27e-8, 2.5e-2]),
        ] {
            let [worst, _, absolute, all] = off(|f_hz| modes_at(&reduction, modes, f_hz) + tooth);
            let found = [worst, absolute, all];
            let fits = found.iter().zip(stated).all(|(found, stated)| near(*found, stated));
            assert!(fits, "{modes} modes: {found:?} against {stated:?}");
        }
        // What is left out counted at rest: the modes left out lie inside the band.
        let rest = tree(&machine, 0.0).grel - modes_at(&reduction, 1, 0.0);
        let [worst, _, absolute, all] = off(|f_hz| modes_at(&reduction, 1, f_hz) + rest);
        assert!(near(worst, 13.5) && near(absolute, 1.26e-8) && near(all, 5.1e-2), "{worst} {all}");
        // A tooth without mass but with its damper is nearer still.
        let (k, c) = (machine.elements.stiffness_n_m[2], machine.elements.damping_n_s_m[2]);
        let [worst, _, absolute, all] =
            off(|f_hz| modes_at(&reduction, 4, f_hz) + Complex::new(k, TAU * f_hz * c).inv());
        assert!(
            near(worst, 5.1e-7) && near(absolute, 5.4e-14) && near(all, 6.4e-8),
            "{worst} {all}"
        );
    }

    /// Response to a unit force from t = 0 on: sum of 2 Re (R / l (e^{lt} - 1)), m.
    fn step(poles: &[Complex], residues: &[Complex], t_s: f64) -> f64 {
        let grown = |l: Complex| {
            let size = math::exp(l.re * t_s);
            Complex::new(size * math::cos(l.im * t_s), size * math::sin(l.im * t_s)) - 1.0
        };
        poles.iter().zip(residues).map(|(l, r)| 2.0 * (r / l * grown(*l)).re).sum()
    }

    #[test]
    fn unit_steps_meet_the_reference() {
        let reduction = Reduction::new(&standard()).unwrap();
        let modes = damped(&standard()).unwrap();
        let poles: Vec<Complex> = modes.iter().map(|mode| mode.pole).collect();
        let residues: Vec<Complex> = modes.iter().map(|mode| mode.residue).collect();
        for (ms, full, reduced) in [
            (0.1, 5.235_032_115_151e-9, 5.235_032_291_36e-9),
            (1.0, 3.316_573_926_927e-8, 3.316_573_982_076e-8),
            (2.0, 9.975_960_919_789e-8, 9.975_961_043_331e-8),
            (5.0, 2.160_643_119_68e-7, 2.160_643_108_38e-7),
            (10.0, 7.685_636_641_697e-8, 7.685_636_887_032e-8),
            (20.0, 1.154_876_910_754e-7, 1.154_876_946_958e-7),
            (50.0, 1.342_274_864_555e-7, 1.342_274_865_632e-7),
        ] {
            let x = step(&poles, &residues, ms * 1e-3);
            assert!((x / full - 1.0).abs() < 1e-11, "full, {ms} ms: {x:e}");
            let x =
                reduction.feedthrough_m_n + step(&reduction.poles, &reduction.residues, ms * 1e-3);
            assert!((x / reduced - 1.0).abs() < 1e-11, "reduced, {ms} ms: {x:e}");
        }
    }

    #[test]
    fn every_machine_that_settings_allow_reduces_or_says_why_not() {
        for variant in Variant::ALL {
            for parameters in Parameters::ALL {
                for spindle_quality in [1.0, 5.0, 17.0, 100.0] {
                    let machine = FiveMass::new(&MachineSettings {
                        variant: *variant,
                        parameters: *parameters,
                        spindle_quality,
                        ..MachineSettings::default()
                    });
                    match Reduction::new(&machine) {
                        Ok(reduction) => {
                            let still = reduction.at(Complex::from(0.0)).re;
                            let exact = machine.static_compliance().grel_m_n;
                            assert!((still / exact - 1.0).abs() < 1e-9, "{still:e}");
                        }
                        Err(error) => {
                            assert_eq!(*parameters, Parameters::Printed);
                            assert!(error.to_string().contains("machine.parameters"));
                        }
                    }
                }
            }
        }
    }
}
