//! The structures that are compared.

steadycut_core::choice! {
    /// The structure of a feed drive without its dead time.
    pub enum DriveStructure {
        /// A lag of first order: 1 / (T s + 1).
        First = "first", "first order";
        /// Two equal lags: 1 / (T s + 1)^2.
        Critical = "critical", "second order, critically damped";
        /// Second order: 1 / (T^2 s^2 + 2 D T s + 1).
        Second = "second", "second order";
        /// A lag and a second order: 1 / ((T1 s + 1) (T^2 s^2 + 2 D T s + 1)).
        Third = "third", "third order";
    }
}

impl DriveStructure {
    /// Its parameters: names, and units.
    #[must_use]
    pub fn parameters(self) -> &'static [(&'static str, &'static str)] {
        match self {
            Self::First | Self::Critical => &[("T", "s")],
            Self::Second => &[("T", "s"), ("D", "")],
            Self::Third => &[("T1", "s"), ("T", "s"), ("D", "")],
        }
    }

    /// Values to begin with, of a lag in s.
    pub(super) fn start(self, lag_s: f64) -> Vec<f64> {
        match self {
            Self::First => vec![lag_s],
            Self::Critical => vec![0.5 * lag_s],
            Self::Second => vec![0.6 * lag_s, 0.8],
            Self::Third => vec![0.5 * lag_s, 0.3 * lag_s, 0.8],
        }
    }

    /// The lag of these parameters, s.
    pub(super) fn lag_s(self, parameters: &[f64]) -> f64 {
        match (self, parameters) {
            (Self::First, [t]) => *t,
            (Self::Critical, [t]) => 2.0 * t,
            (Self::Second, [t, d]) => 2.0 * d * t,
            (Self::Third, [t1, t, d]) => t1 + 2.0 * d * t,
            (Self::First | Self::Critical | Self::Second | Self::Third, _) => f64::NAN,
        }
    }

    /// Coefficients a0, a1, .. of the denominator and its order, as a drive of the loop has them.
    #[must_use]
    pub fn denominator(self, parameters: &[f64]) -> ([f64; 3], usize) {
        match (self, parameters) {
            (Self::First, [t]) => ([1.0 / t, 0.0, 0.0], 1),
            (Self::Critical, [t]) => ([1.0 / (t * t), 2.0 / t, 0.0], 2),
            (Self::Second, [t, d]) => ([1.0 / (t * t), 2.0 * d / t, 0.0], 2),
            (Self::Third, [t1, t, d]) => {
                let (p, omega) = (1.0 / t1, 1.0 / t);
                let a1 = omega * omega + 2.0 * d * omega * p;
                ([p * omega * omega, a1, p + 2.0 * d * omega], 3)
            }
            (Self::First | Self::Critical | Self::Second | Self::Third, _) => ([f64::NAN; 3], 1),
        }
    }

    /// The poles, real and imaginary parts in rad/s.
    #[must_use]
    pub fn poles(self, parameters: &[f64]) -> Vec<[f64; 2]> {
        // Those of T^2 s^2 + 2 D T s + 1.
        let pair = |t: f64, d: f64| {
            let root = (d * d - 1.0).abs().sqrt();
            match d < 1.0 {
                true => vec![[-d / t, root / t], [-d / t, -root / t]],
                false => vec![[(root - d) / t, 0.0], [-(root + d) / t, 0.0]],
            }
        };
        match (self, parameters) {
            (Self::First, [t]) => vec![[-1.0 / t, 0.0]],
            (Self::Critical, [t]) => vec![[-1.0 / t, 0.0]; 2],
            (Self::Second, [t, d]) => pair(*t, *d),
            (Self::Third, [t1, t, d]) => [vec![[-1.0 / t1, 0.0]], pair(*t, *d)].concat(),
            (Self::First | Self::Critical | Self::Second | Self::Third, _) => Vec::new(),
        }
    }
}
