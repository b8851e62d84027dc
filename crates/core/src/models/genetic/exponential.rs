//! An exponential law n = a e^{b F} (2013 eq. 4): positive and monotone for every force.

use crate::base::math;

/// n = scale e^{rate F}.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exponential {
    /// Speed at zero force, 1/min.
    pub scale_rpm: f64,
    /// Rate, 1/N; negative.
    pub rate_per_n: f64,
}

impl Exponential {
    /// Speed in 1/min for a force in N. The exponent is held within +-50, so that no force, however
    /// wrong, makes an infinite command.
    #[must_use]
    pub fn at(&self, force_n: f64) -> f64 {
        self.scale_rpm * math::exp(math::limit(self.rate_per_n * force_n, -50.0, 50.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_the_exponential_and_never_infinite() {
        let law = Exponential { scale_rpm: 7641.3, rate_per_n: -0.004 };
        assert_eq!(law.at(0.0), 7641.3);
        assert!((law.at(250.0) - 7641.3 / math::E).abs() < 1e-9);
        assert!(law.at(-1e12).is_finite() && law.at(1e12) > 0.0);
    }
}
