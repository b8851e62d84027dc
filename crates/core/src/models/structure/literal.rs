//! Equations 1 and 2 of 2019 letter by letter, to show what is wrong with them.
//!
//! Row 3 of eq. 2 is multiplied by -1 here, so that its mass stands with the usual sign; its load
//! becomes +P, which is one of its faults. Nothing else uses these forms.

use nalgebra::Matrix5 as Rows;
use nalgebra::SVector;

use super::modes::eigenvalues;
use super::parameters::Elements;
use super::{Complex, Matrix5};
use crate::base::math::TAU;

/// A printed equation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Equation {
    /// The differential equations (1).
    One,
    /// The algebraic equations (2).
    Two,
}

impl Equation {
    /// The printed matrix of springs, or with dampers `x` that of dampers.
    #[must_use]
    pub fn matrix(self, x: &[f64; 5]) -> Matrix5 {
        let [x1, x2, x3, x4, x5] = *x;
        match self {
            #[rustfmt::skip]
            Self::One => Rows::new(
                x1 + x2, -x2 - x3, x3, 0.0, 0.0,
                -x2, x2, 0.0, 0.0, 0.0,
                0.0, -x3, x3, 0.0, 0.0,
                0.0, 0.0, -x4, x4, 0.0,
                0.0, 0.0, 0.0, x5 - x4, x4 - x5,
            ),
            #[rustfmt::skip]
            Self::Two => Rows::new(
                x1 + x2 + x3, -x2, -x3, 0.0, 0.0,
                -x2, x2, 0.0, 0.0, 0.0,
                0.0, -x3, x3, 0.0, 0.0,
                0.0, 0.0, 0.0, x4, -x4,
                -x5, 0.0, 0.0, -x4, x4 + x5,
            ),
        }
    }

    /// Poles with positive real part, rad/s, by rising size; `None` if they are not found.
    #[must_use]
    pub fn unstable_poles(self, elements: &Elements) -> Option<Vec<Complex>> {
        let damping = self.matrix(&elements.damping_n_s_m);
        let stiffness = self.matrix(&elements.stiffness_n_m);
        let mut poles = eigenvalues(&elements.mass_kg, &damping, &stiffness)?;
        // Below this the iteration's error decides the sign of a tooth pole's real part.
        poles.retain(|pole| pole.re > 1.0);
        poles.sort_by(|x, y| x.norm_sqr().total_cmp(&y.norm_sqr()));
        Some(poles)
    }

    /// |zeta_3| per newton at `f_hz` under the printed loads, m/N; `None` for a singular matrix.
    #[must_use]
    pub fn tooth_m_n(self, elements: &Elements, f_hz: f64) -> Option<f64> {
        let omega = TAU * f_hz;
        let damping = self.matrix(&elements.damping_n_s_m);
        let stiffness = self.matrix(&elements.stiffness_n_m);
        let z = nalgebra::SMatrix::<Complex, 5, 5>::from_fn(|i, j| {
            let inertia = if i == j { omega * omega * elements.mass_kg[i] } else { 0.0 };
            Complex::new(stiffness[(i, j)] - inertia, omega * damping[(i, j)])
        });
        let tooth = if self == Self::One { -1.0 } else { 1.0 };
        let load = SVector::from([0.0, 0.0, tooth, 1.0, 0.0].map(Complex::from));
        z.lu().solve(&load).map(|x| x[2].norm_sqr().sqrt())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::models::structure::parameters::Parameters;

    #[test]
    fn equation_1_is_unstable_as_printed() {
        let poles =
            |parameters| Equation::One.unstable_poles(&Elements::new(parameters, 5.0)).unwrap();
        let corrected = poles(Parameters::Rules);
        assert_eq!(corrected.len(), 1);
        assert!((corrected[0].re / TAU - 194.9).abs() < 0.1, "{:?}", corrected[0].re / TAU);
        let printed = poles(Parameters::Printed);
        assert_eq!(printed.len(), 2, "{printed:?}");
        assert!((printed[0].re / TAU - 4056.7).abs() < 0.1, "{}", printed[0].re / TAU);
        assert!((printed[1].re / TAU - 78_659.0).abs() < 1.0, "{}", printed[1].re / TAU);
    }

    #[test]
    fn equation_2_hides_the_spindle_at_the_tool() {
        let elements = Elements::new(Parameters::Rules, 5.0);
        assert_eq!(Equation::Two.unstable_poles(&elements), Some(Vec::new()));
        let still = Equation::Two.tooth_m_n(&elements, 0.0).unwrap();
        let at_110 = Equation::Two.tooth_m_n(&elements, 110.0).unwrap();
        assert!((still / 5.042e-9 - 1.0).abs() < 2e-4, "{still:e}");
        assert!((at_110 / 4.889e-9 - 1.0).abs() < 2e-4, "{at_110:e}");
    }
}
