//! Workpiece materials: specific cutting force after Kienzle, k_c = k_c1.1 h^-m_c, with hardness.
//!
//! The constants of Ck45 and 16MnCrSi5 are those of the 2005 simulator; the others are textbook
//! values of Kienzle tables (Tschätsch/Dietrich; König/Klocke), rounded, and represent the class
//! of material, not for a charge. The force of K4 belongs to Ck45 at 200 HB; any other material
//! scales it by its k_c at a chip thickness of 0.1 mm, times (HB / HB_ref)^0.4 (chosen).

use crate::base::math;
use crate::models::mechanistic::{CK45, MNCRSI5, Steel};

crate::choice! {
    /// A workpiece material.
    pub enum Material {
        /// Unalloyed heat-treatable steel 1.0503, the papers' material; the reference, factor 1.
        Ck45 = "ck45", "Ck45 (1.0503)";
        /// Case-hardening steel of the 2005 paper, as 16MnCr5 (1.7131).
        MnCrSi5 = "16mncrsi5", "16MnCrSi5 (1.7131)";
        /// Structural steel 1.0038.
        S235 = "s235jr", "S235JR (1.0038)";
        /// Heat-treatable steel 1.7225, pre-hardened.
        Crmo42 = "42crmo4", "42CrMo4 (1.7225)";
        /// Austenitic stainless steel 1.4301.
        X5CrNi = "x5crni18-10", "X5CrNi18-10 (1.4301)";
        /// Tool steel 1.2714, pre-hardened for moulds and dies.
        NiCrMoV = "55nicrmov7", "55NiCrMoV7 (1.2714)";
        /// Grey cast iron EN-GJL-250.
        Gjl250 = "gjl-250", "EN-GJL-250 grey iron";
        /// Nodular cast iron EN-GJS-600-3.
        Gjs600 = "gjs-600", "EN-GJS-600 nodular iron";
        /// Wrought aluminium alloy EN AW-7075 T6.
        Al7075 = "aw-7075", "EN AW-7075 aluminium";
        /// Free-cutting brass CuZn39Pb3.
        Brass = "cuzn39pb3", "CuZn39Pb3 brass";
        /// Titanium alloy Ti-6Al-4V.
        Ti64 = "ti6al4v", "Ti-6Al-4V titanium";
    }
}

/// Chip thickness in mm at which materials are compared.
const CHIP_THICKNESS_MM: f64 = 0.1;
/// Exponent of the hardness ratio (chosen).
const HARDNESS_EXPONENT: f64 = 0.4;

impl Material {
    /// k_c1.1 in N/mm^2, m_c, and the reference hardness in HB.
    #[must_use]
    pub fn constants(self) -> (f64, f64, f64) {
        match self {
            Self::Ck45 => (2220.0, 0.14, 200.0),
            Self::MnCrSi5 => (2100.0, 0.26, 180.0),
            Self::S235 => (1780.0, 0.17, 120.0),
            Self::Crmo42 => (2500.0, 0.26, 280.0),
            Self::X5CrNi => (2350.0, 0.21, 180.0),
            Self::NiCrMoV => (1740.0, 0.24, 360.0),
            Self::Gjl250 => (1160.0, 0.26, 210.0),
            Self::Gjs600 => (1480.0, 0.17, 230.0),
            Self::Al7075 => (830.0, 0.23, 150.0),
            Self::Brass => (780.0, 0.18, 110.0),
            Self::Ti64 => (1370.0, 0.21, 330.0),
        }
    }

    /// Reference hardness, HB.
    #[must_use]
    pub fn hardness_hb(self) -> f64 {
        self.constants().2
    }

    /// Power of the chip thickness in the cutting force of Kienzle's law, 1 - m_c.
    #[must_use]
    pub fn feed_exponent(self) -> f64 {
        1.0 - self.constants().1
    }

    /// The steel whose laws of force its teeth meet, and the factor on them at a hardness in HB: materials but the two
    /// of the 2005 paper are Ck45 times the ratio of their forces.
    #[must_use]
    pub fn steel(self, hardness_hb: f64) -> (Steel, f64) {
        let (steel, base) = match self {
            Self::MnCrSi5 => (MNCRSI5, Self::MnCrSi5),
            Self::Ck45
            | Self::S235
            | Self::Crmo42
            | Self::X5CrNi
            | Self::NiCrMoV
            | Self::Gjl250
            | Self::Gjs600
            | Self::Al7075
            | Self::Brass
            | Self::Ti64 => (CK45, Self::Ck45),
        };
        (steel, self.force_factor(hardness_hb) / base.force_factor(base.hardness_hb()))
    }

    /// Force relative to Ck45 at 200 HB.
    #[must_use]
    pub fn force_factor(self, hardness_hb: f64) -> f64 {
        let specific = |material: Self| {
            let (kc11, mc, _) = material.constants();
            kc11 * math::pow(CHIP_THICKNESS_MM, -mc)
        };
        let hardness = math::pow(hardness_hb / self.hardness_hb(), HARDNESS_EXPONENT);
        specific(self) / specific(Self::Ck45) * hardness
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ck45_is_the_reference_and_force_rises_with_hardness() {
        assert_eq!(Material::Ck45.force_factor(200.0), 1.0);
        // 16MnCrSi5 at 0.1 mm by hand: 2100 0.1^-0.26 / (2220 0.1^-0.14) = 1.2470.
        assert!((Material::MnCrSi5.force_factor(180.0) - 1.2470).abs() < 1e-4);
        for material in Material::ALL {
            assert!(material.force_factor(300.0) > material.force_factor(200.0));
        }
    }
}
