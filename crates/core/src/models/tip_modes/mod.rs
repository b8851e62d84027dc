//! The structure at the tool's tip as its modes, as they are measured by an impact test: what stands in the place of
//! the five masses where someone knows the machine.
//!
//! ```text
//! G_d(s) = sum over the modes of direction d of  1 / (m (s^2 + 2 zeta w s + w^2)) ,   w = 2 pi f ,  k = m w^2
//! ```
//!
//! x is the direction of feed, y the one across it, towards the work; what couples them is left out, as is usual
//! (Altintas, Manufacturing Automation, 2nd ed., chapter 4).

mod file;

pub use file::{TIP_FILE_VERSION, TipModesFile};

use crate::base::language::tr;
use crate::base::math::TAU;
use crate::base::settings::{Editor, Structure, Value};
use crate::models::structure::Complex;

crate::choice! {
    /// A direction in which the tool's tip gives way.
    pub enum TipAxis {
        /// Along the feed.
        X = "x", "x, along the feed";
        /// Across the feed, towards the work.
        Y = "y", "y, across the feed";
    }
}

/// Most modes, of both directions together.
pub const MAX_TIP_MODES: usize = 16;
/// Natural frequency, Hz: what is allowed.
pub const FREQUENCY_HZ: [f64; 2] = [1.0, 20_000.0];
/// Damping ratio: what is allowed; a mode that rings.
pub const DAMPING_RATIO: [f64; 2] = [1e-4, 0.9];
/// Modal mass, kg: what is allowed.
pub const MODAL_MASS_KG: [f64; 2] = [1e-6, 1e6];

/// A mode at the tool's tip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TipMode {
    /// Its direction.
    pub axis: TipAxis,
    /// Natural frequency without damping f, Hz.
    pub frequency_hz: f64,
    /// Damping ratio zeta.
    pub damping_ratio: f64,
    /// Modal mass m, kg, scaled to the displacement of the tip.
    pub mass_kg: f64,
}

impl TipMode {
    /// The first value that is out of its range: its entry, the value, what is allowed.
    #[must_use]
    pub fn out_of_range(&self) -> Option<(&'static str, f64, [f64; 2])> {
        let values = [
            ("frequency_hz", self.frequency_hz, FREQUENCY_HZ),
            ("damping_ratio", self.damping_ratio, DAMPING_RATIO),
            ("mass_kg", self.mass_kg, MODAL_MASS_KG),
        ];
        // What is not a number is in no range.
        values.into_iter().find(|(_, value, [low, high])| !(*low..=*high).contains(value))
    }

    /// Natural frequency w, rad/s.
    #[must_use]
    pub fn omega_rad_s(&self) -> f64 {
        TAU * self.frequency_hz
    }

    /// Modal stiffness m w^2, N/m.
    #[must_use]
    pub fn stiffness_n_m(&self) -> f64 {
        self.mass_kg * self.omega_rad_s() * self.omega_rad_s()
    }

    /// The pole with positive imaginary part, rad/s.
    #[must_use]
    pub fn pole(&self) -> Complex {
        let (w, zeta) = (self.omega_rad_s(), self.damping_ratio);
        Complex::new(-zeta * w, w * (1.0 - zeta * zeta).sqrt())
    }

    /// Its compliance at s in rad/s, m/N.
    #[must_use]
    pub fn compliance(&self, s: Complex) -> Complex {
        let w = self.omega_rad_s();
        let dynamic = s * s + s * (2.0 * self.damping_ratio * w) + w * w;
        Complex::from(1.0 / self.mass_kg) / dynamic
    }
}

/// The modes of a tip, in the order given; none where the five masses stand.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TipModes {
    modes: Vec<TipMode>,
}

impl TipModes {
    /// Takes modes over.
    ///
    /// # Errors
    /// More modes than [`MAX_TIP_MODES`], or a value outside its range: which one, and what is allowed.
    pub fn new(modes: Vec<TipMode>) -> Result<Self, String> {
        if modes.len() > MAX_TIP_MODES {
            return Err(tr!(
                "{n} modes: allowed are at most {most}",
                n = modes.len(),
                most = MAX_TIP_MODES
            ));
        }
        for (place, mode) in modes.iter().enumerate() {
            if let Some((entry, value, [low, high])) = mode.out_of_range() {
                return Err(tr!(
                    "mode {place}: `{entry}` cannot be {value}: allowed is a number from {low} to {high}",
                    place = place + 1,
                    entry = entry,
                    value = value,
                    low = low,
                    high = high
                ));
            }
        }
        Ok(Self { modes })
    }

    /// All modes.
    #[must_use]
    pub fn all(&self) -> &[TipMode] {
        &self.modes
    }

    /// Those of a direction.
    pub fn along(&self, axis: TipAxis) -> impl Iterator<Item = &TipMode> {
        self.modes.iter().filter(move |mode| mode.axis == axis)
    }

    /// Whether there are none: the five masses stand.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.modes.is_empty()
    }

    /// The compliance of a direction at s in rad/s, m/N.
    #[must_use]
    pub fn compliance(&self, axis: TipAxis, s: Complex) -> Complex {
        self.along(axis).map(|mode| mode.compliance(s)).sum()
    }
}

fn row(mode: &TipMode) -> [f64; 4] {
    let axis = match mode.axis {
        TipAxis::X => 0.0,
        TipAxis::Y => 1.0,
    };
    [axis, mode.frequency_hz, mode.damping_ratio, mode.mass_kg]
}

fn mode(row: [f64; 4]) -> Option<TipMode> {
    let [axis, frequency_hz, damping_ratio, mass_kg] = row;
    let axis = match axis {
        0.0 => TipAxis::X,
        1.0 => TipAxis::Y,
        _ => return None,
    };
    Some(TipMode { axis, frequency_hz, damping_ratio, mass_kg })
}

/// A list of rows [axis, Hz, damping ratio, kg], the axis 0 for x and 1 for y.
impl Structure for TipModes {
    const ID: &'static str = "tip_modes";

    fn bounds(_: [f64; 2]) -> Vec<(&'static str, f64)> {
        vec![
            ("min_frequency_hz", FREQUENCY_HZ[0]),
            ("max_frequency_hz", FREQUENCY_HZ[1]),
            ("min_damping_ratio", DAMPING_RATIO[0]),
            ("max_damping_ratio", DAMPING_RATIO[1]),
            ("min_mass_kg", MODAL_MASS_KG[0]),
            ("max_mass_kg", MODAL_MASS_KG[1]),
        ]
    }
    fn allowed(_: [f64; 2], _: &str) -> String {
        let ([f0, f1], [d0, d1], [m0, m1]) = (FREQUENCY_HZ, DAMPING_RATIO, MODAL_MASS_KG);
        tr!(
            "at most {n} lists [axis, frequency, damping ratio, modal mass]: axis 0 for x or 1 for y, {f0} to {f1} Hz, \
             {d0} to {d1}, {m0} to {m1} kg",
            n = MAX_TIP_MODES,
            f0 = f0,
            f1 = f1,
            d0 = d0,
            d1 = d1,
            m0 = m0,
            m1 = m1
        )
    }
    fn write(&self) -> Value {
        self.modes.iter().map(row).collect::<Vec<_>>().into()
    }
    fn read(value: &Value, _: [f64; 2]) -> Option<Self> {
        let modes = value.list()?.iter().map(|row| mode(row.array()?));
        Self::new(modes.collect::<Option<_>>()?).ok()
    }
    fn editor(_: [f64; 2]) -> Editor {
        Editor::Presence
    }
    fn example(_: [f64; 2], share: f64, pick: u32) -> Value {
        let between = |[low, high]: [f64; 2]| low + share * (high - low);
        let of = |axis| TipMode {
            axis,
            // Slow enough for a running cut.
            frequency_hz: between([FREQUENCY_HZ[0], 1000.0]),
            damping_ratio: between(DAMPING_RATIO),
            mass_kg: between(MODAL_MASS_KG),
        };
        let modes = [of(TipAxis::Y), of(TipAxis::X), of(TipAxis::Y)];
        modes[..1 + pick as usize % 3].iter().map(row).collect::<Vec<_>>().into()
    }
}

crate::structured!(TipModes);

#[cfg(test)]
mod tests {
    use super::*;

    fn one() -> TipMode {
        let axis = TipAxis::X;
        TipMode { axis, frequency_hz: 922.0, damping_ratio: 0.011, mass_kg: 0.03993 }
    }

    #[test]
    fn at_rest_a_mode_is_its_spring_and_at_resonance_its_damper() {
        let mode = one();
        let k = mode.stiffness_n_m();
        // 0.03993 (2 pi 922)^2 N/m.
        assert!((k / 1.340_04e6 - 1.0).abs() < 1e-5, "{k}");
        assert!((mode.compliance(Complex::from(0.0)).re * k - 1.0).abs() < 1e-12);
        let s = Complex::new(0.0, mode.omega_rad_s());
        let peak = mode.compliance(s);
        assert!(peak.re.abs() < 1e-12 * peak.im.abs());
        assert!((-peak.im * 2.0 * 0.011 * k - 1.0).abs() < 1e-12);
        // At its pole the dynamic stiffness is nothing.
        assert!(mode.compliance(mode.pole()).norm_sqr().sqrt() * k > 1e9);
    }

    #[test]
    fn rows_come_back_and_what_is_out_of_range_is_named() {
        let modes = TipModes::new(vec![one(), TipMode { axis: TipAxis::Y, ..one() }]).unwrap();
        let written = Structure::write(&modes);
        assert_eq!(<TipModes as Structure>::read(&written, [0.0; 2]), Some(modes));
        let bad = TipModes::new(vec![one(), TipMode { damping_ratio: 1.5, ..one() }]).unwrap_err();
        for part in ["mode 2", "damping_ratio", "1.5", "0.0001 to 0.9"] {
            assert!(bad.contains(part), "{part}: {bad}");
        }
        assert!(TipModes::new(vec![TipMode { mass_kg: f64::NAN, ..one() }]).is_err());
        assert!(TipModes::new(vec![one(); MAX_TIP_MODES + 1]).is_err());
        let axis = Value::from(vec![[2.0, 922.0, 0.011, 0.04]]);
        assert_eq!(<TipModes as Structure>::read(&axis, [0.0; 2]), None);
    }
}
