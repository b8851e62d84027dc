//! How the five masses move: forced at a frequency, by the passing teeth, or in a mode.

use super::state::MachineState;
use crate::base::math::{TAU, cos, extent, sin};
use crate::models::structure::Complex;
use crate::models::structure::frf::{LAST_HZ, Tree};

/// What moves the masses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Drive {
    /// The contact force at the chosen frequency.
    Frequency,
    /// The contact force at a harmonic of the tooth passing of the cut.
    Teeth(u32),
    /// Nothing: a mode by its number from 0, swinging freely.
    Mode(usize),
}

/// A movement of the five masses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotionPicture {
    /// Its frequency, Hz.
    pub f_hz: f64,
    /// Amplitudes with their phases, m; in a mode relative to the largest one.
    pub z: [Complex; 5],
    /// Whether the amplitudes are metres.
    pub in_metres: bool,
}

impl MotionPicture {
    /// The movement of `machine`; none for a mode that is not known.
    #[must_use]
    pub fn of(
        machine: &MachineState,
        drive: Drive,
        chosen_hz: f64,
        tooth_hz: f64,
        force_n: f64,
    ) -> Option<Self> {
        let forced = |f_hz: f64| {
            let f_hz = f_hz.clamp(0.0, f64::from(LAST_HZ));
            let tree = Tree::new(&machine.model, Complex::new(0.0, TAU * f_hz));
            Self { f_hz, z: tree.solve(-force_n, force_n), in_metres: true }
        };
        Some(match drive {
            Drive::Frequency => forced(chosen_hz),
            Drive::Teeth(harmonic) => forced(f64::from(harmonic) * tooth_hz),
            Drive::Mode(i) => {
                let free = &machine.modes.get(i)?.free;
                let [_, largest] = extent(free.shape.iter().map(|x| x.abs()));
                let z = free.shape.map(|x| Complex::from(x / largest));
                Self { f_hz: free.frequency_hz, z, in_metres: false }
            }
        })
    }

    /// Largest amplitude.
    #[must_use]
    pub fn largest(&self) -> f64 {
        self.z.iter().map(|z| amplitude(*z)).fold(0.0, f64::max)
    }

    /// Displacements at a phase in turns.
    #[must_use]
    pub fn at(&self, phase: f64) -> [f64; 5] {
        let (sin, cos) = (sin(TAU * phase), cos(TAU * phase));
        self.z.map(|z| z.re * cos - z.im * sin)
    }
}

/// Size of a complex amplitude.
#[must_use]
pub fn amplitude(z: Complex) -> f64 {
    z.norm_sqr().sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::structure::MachineSettings;

    #[test]
    fn a_slow_force_bends_the_machine_by_its_compliance() {
        let machine = MachineState::new(&MachineSettings::default());
        let motion = MotionPicture::of(&machine, Drive::Frequency, 0.0, 53.0, 107.0).unwrap();
        let z = motion.at(0.0);
        let gap = z[machine.model.branch().1] - z[2];
        let still = 107.0 * machine.model.static_compliance().grel_m_n;
        assert!((gap / still - 1.0).abs() < 1e-9 && (motion.at(0.5)[2] + z[2]).abs() < 1e-15);
    }

    #[test]
    fn modes_are_shapes_and_unknown_ones_are_none() {
        let machine = MachineState::new(&MachineSettings::default());
        let of = |drive| MotionPicture::of(&machine, drive, 100.0, 53.0, 107.0);
        let first = of(Drive::Mode(0)).unwrap();
        assert!((first.f_hz - 109.929).abs() < 1e-3 && first.largest() == 1.0);
        assert_eq!(of(Drive::Mode(9)), None);
        let second = of(Drive::Teeth(2)).unwrap();
        assert_eq!(second.f_hz, 106.0);
    }
}
