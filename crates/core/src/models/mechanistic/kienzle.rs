//! Kienzle's law of cutting forces for the papers' two steels.

use std::sync::Arc;

use crate::base::math;
use crate::models::formula_model::FormulaModel;

/// Uncorrected Kienzle constants k_i1.1 in N/mm^2 with exponents m_i, at 1 mm chip thickness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Steel {
    /// k_c1.1 in N/mm^2 and m_c: tangential.
    pub tangential: [f64; 2],
    /// k_r1.1 in N/mm^2 and m_r: radial (chosen so that F_r/F_c is 0.5 at 0.05 mm, 0.33 at 0.2 mm).
    pub radial: [f64; 2],
    /// k_a1.1 in N/mm^2 and m_a: axial (chosen).
    pub axial: [f64; 2],
    /// Hardness in HB at which they hold.
    pub hardness_hb: f64,
}

/// Ck45 (1.0503); tangential after Tschätsch/Dietrich.
pub const CK45: Steel = Steel {
    tangential: [2220.0, 0.14],
    radial: [450.0, 0.45],
    axial: [200.0, 0.20],
    hardness_hb: 200.0,
};
/// 16MnCrSi5 as 16MnCr5 (1.7131); tangential fitted to a published k_c table (Röhm RN-1391).
pub const MNCRSI5: Steel = Steel {
    tangential: [2100.0, 0.26],
    radial: [430.0, 0.50],
    axial: [200.0, 0.25],
    hardness_hb: 180.0,
};

/// Kienzle's laws with all corrections applied: k_i in N/mm^2 and 1 - m_i.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kienzle {
    /// k_c, k_r, k_a in N/mm^2.
    pub k_n_mm2: [f64; 3],
    /// 1 - m_c, 1 - m_r, 1 - m_a.
    pub exponents: [f64; 3],
}

impl Kienzle {
    /// Corrections for rake, x [1 - 0.015 (rake - 6 deg)], for cutting speed, x 2.023 / v_c^0.153
    /// (both Tschätsch/Dietrich; carbide), and for hardness, x (HB/HB_ref)^0.4 (chosen).
    #[must_use]
    pub fn new(steel: &Steel, speed_m_min: f64, rake_deg: f64, hardness_hb: f64) -> Self {
        let factor = Self::corrections(steel, speed_m_min, rake_deg, hardness_hb);
        let laws = [steel.tangential, steel.radial, steel.axial];
        Self { k_n_mm2: laws.map(|[k, _]| k * factor), exponents: laws.map(|[_, m]| 1.0 - m) }
    }

    /// The factor of all three corrections on the uncorrected constants.
    #[must_use]
    pub fn corrections(steel: &Steel, speed_m_min: f64, rake_deg: f64, hardness_hb: f64) -> f64 {
        (1.0 - 0.015 * (rake_deg - 6.0)) * 2.023 / math::pow(speed_m_min, 0.153)
            * math::pow(hardness_hb / steel.hardness_hb, 0.4)
    }
}

/// What gives the forces on an edge.
pub trait EdgeLaw {
    /// Forces per mm of edge width in N/mm at a chip thickness in mm: tangential, radial, axial.
    fn per_width(&self, thickness_mm: f64) -> [f64; 3];
}

/// Kienzle, F/b = k_1.1 h^(1 - m).
impl EdgeLaw for Kienzle {
    #[inline]
    fn per_width(&self, thickness_mm: f64) -> [f64; 3] {
        let log = math::ln(thickness_mm);
        let [c, r, a] = self.exponents;
        let [kc, kr, ka] = self.k_n_mm2;
        [kc * math::exp(c * log), kr * math::exp(r * log), ka * math::exp(a * log)]
    }
}

/// Kienzle's laws, or formulas of one's own in the place of some.
#[derive(Clone, Debug, PartialEq)]
pub struct OwnEdgeLaw {
    /// Kienzle's laws.
    pub law: Kienzle,
    /// Specific forces k_c, k_r, k_a in N/mm^2 of the chip thickness in mm, uncorrected, where there are such.
    pub specific: [Option<Arc<FormulaModel>>; 3],
    /// The factor of the corrections on them.
    pub corrections: f64,
}

/// F/b = k_i(h) h; never negative.
impl EdgeLaw for OwnEdgeLaw {
    #[inline]
    fn per_width(&self, thickness_mm: f64) -> [f64; 3] {
        let mut forces = self.law.per_width(thickness_mm);
        for (force, specific) in forces.iter_mut().zip(&self.specific) {
            if let Some(own) = specific {
                let specific_n_mm2 = math::positive(own.at(&[thickness_mm]).value);
                *force = self.corrections * specific_n_mm2 * thickness_mm;
            }
        }
        forces
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corrected_constants_are_those_published_with_the_model() {
        for (steel, expected) in
            [(CK45, [2090.34, 423.72, 188.32]), (MNCRSI5, [1977.35, 404.89, 188.32])]
        {
            let law = Kienzle::new(&steel, 80.0, 12.0, steel.hardness_hb);
            for (k, expected) in law.k_n_mm2.iter().zip(expected) {
                assert!((k - expected).abs() < 0.01, "{k} {expected}");
            }
        }
    }
}
