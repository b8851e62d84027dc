//! The four activation functions that the 2013 paper compares.

use crate::base::math;

crate::choice! {
    /// The activation: what a neuron gives for its weighted sum.
    pub enum Activation {
        /// arctan(s), the papers' choice: -pi/2 to pi/2, slope 1/(1 + s^2).
        Arctan = "arctan", "arc tangent";
        /// tanh(s): -1 to 1, slope 1 - y^2.
        Tanh = "tanh", "hyperbolic tangent";
        /// sin(s): -1 to 1, slope cos(s); not monotone.
        Sine = "sine", "sine";
        /// 1/(1 + e^-s): 0 to 1, slope y (1 - y).
        Sigmoid = "sigmoid", "sigmoid";
    }
}

impl Activation {
    /// Replaces weighted sums by activations.
    #[inline]
    pub fn apply(self, sums: &mut [f64]) {
        match self {
            Self::Arctan => sums.iter_mut().for_each(|s| *s = math::atan(*s)),
            Self::Tanh => sums.iter_mut().for_each(|s| *s = math::tanh(*s)),
            Self::Sine => sums.iter_mut().for_each(|s| *s = math::sin(*s)),
            Self::Sigmoid => sums.iter_mut().for_each(|s| *s = 1.0 / (1.0 + math::exp(-*s))),
        }
    }

    /// Slope da/ds from the sum `s` and the activation `y` there.
    #[must_use]
    #[inline]
    pub fn slope(self, s: f64, y: f64) -> f64 {
        match self {
            Self::Arctan => 1.0 / (1.0 + s * s),
            Self::Tanh => 1.0 - y * y,
            Self::Sine => math::cos(s),
            Self::Sigmoid => y * (1.0 - y),
        }
    }

    /// A range for the targets of an output layer with this activation, inside its bounds, which
    /// only infinite weights reach (chosen; the 2013 paper maps everything to 0..1).
    #[must_use]
    pub fn target_range(self) -> [f64; 2] {
        match self {
            Self::Arctan => [-1.0, 1.0],
            Self::Tanh | Self::Sine => [-0.8, 0.8],
            Self::Sigmoid => [0.1, 0.9],
        }
    }
}
