//! Table 1 of 2019: masses, springs and dampers of the five nodes, and the sets made of it.

use crate::base::language::text;
use crate::base::math::TAU;

crate::choice! {
    /// A set of parameters of the five-mass machine.
    pub enum Parameters {
        /// Masses, frequencies and quality factors as printed; springs and dampers by the rules below the table, with Q = 5 for the spindle, which its printed damper shows.
        Rules = "D", "from the table's rules";
        /// The printed digits with the two wrong exponents corrected: k4 = 6.3e8 N/m, c5 = 2.6e5 N s/m.
        Table = "T", "printed, exponents corrected";
        /// The numbers literally as printed.
        Printed = "printed", "as printed";
    }
}

/// Names of the nodes in the order of the table.
pub const NODES: [&str; 5] =
    [text!("base console"), text!("spindle"), text!("tooth"), text!("slides"), text!("table")];
/// m_i in kg, as printed.
pub const MASS_KG: [f64; 5] = [3494.0, 17.0, 0.3e-6, 305.0, 500.0];
/// f_i in Hz, as printed: each node alone on its own spring.
pub const FREQUENCY_HZ: [f64; 5] = [250.0, 110.0, 4.14e6, 228.0, 250.0];
/// Q_i as printed; that of the spindle repeats its mass (errata).
pub const QUALITY_PRINTED: [f64; 5] = [3.0, 17.0, 10.0, 3.0, 3.0];
/// k_i in N/m, as printed.
pub const STIFFNESS_PRINTED_N_M: [f64; 5] = [8.6e9, 8.1e6, 1.9e8, 6.3e12, 1.2e9];
/// c_i in N s/m, as printed.
pub const DAMPING_PRINTED_N_S_M: [f64; 5] = [1.8e6, 2348.0, 0.5, 1.4e5, 2.6e8];
/// Quality factor of the spindle that its printed damper of 2348 N s/m shows.
pub const SPINDLE_QUALITY: f64 = 5.0;

/// Masses, springs and dampers, nodes in the order of the table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Elements {
    /// m_i, kg.
    pub mass_kg: [f64; 5],
    /// k_i, N/m.
    pub stiffness_n_m: [f64; 5],
    /// c_i, N s/m.
    pub damping_n_s_m: [f64; 5],
}

/// The rules below Table 1 for node `i`: k = m (2 pi f)^2 in N/m and c = sqrt(k m) / Q in N s/m.
#[must_use]
pub fn by_rule(i: usize, quality: f64) -> (f64, f64) {
    let omega = TAU * FREQUENCY_HZ[i];
    let stiffness = MASS_KG[i] * (omega * omega);
    (stiffness, (stiffness * MASS_KG[i]).sqrt() / quality)
}

impl Elements {
    /// The set `parameters` with the spindle's quality factor (greater than 0). The printed damper
    /// of the spindle belongs to Q = 5 and follows another quality in proportion.
    #[must_use]
    pub fn new(parameters: Parameters, spindle_quality: f64) -> Self {
        let mut elements = Self {
            mass_kg: MASS_KG,
            stiffness_n_m: STIFFNESS_PRINTED_N_M,
            damping_n_s_m: DAMPING_PRINTED_N_S_M,
        };
        elements.damping_n_s_m[1] *= SPINDLE_QUALITY / spindle_quality;
        match parameters {
            Parameters::Rules => {
                for (i, printed) in QUALITY_PRINTED.into_iter().enumerate() {
                    let quality = if i == 1 { spindle_quality } else { printed };
                    let (stiffness, damping) = by_rule(i, quality);
                    elements.stiffness_n_m[i] = stiffness;
                    elements.damping_n_s_m[i] = damping;
                }
            }
            Parameters::Table => {
                elements.stiffness_n_m[3] = 6.3e8;
                elements.damping_n_s_m[4] = 2.6e5;
            }
            Parameters::Printed => {}
        }
        elements
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rules_give_the_reference_values() {
        let d = Elements::new(Parameters::Rules, 5.0);
        let stiffness = [
            8_621_099_444.351_55,
            8_120_710.501_216_32,
            202_993_285.911_493,
            625_935_048.527_2,
            1_233_700_550.136_17,
        ];
        let damping = [
            1_829_454.121_940_46,
            2_349.911_304_885_17,
            0.780_371_615_151_705,
            145_644.235_420_423,
            261_799.387_799_149,
        ];
        for i in 0..5 {
            assert!((d.stiffness_n_m[i] / stiffness[i] - 1.0).abs() < 1e-13, "k{}", i + 1);
            assert!((d.damping_n_s_m[i] / damping[i] - 1.0).abs() < 1e-13, "c{}", i + 1);
        }
    }

    #[test]
    fn the_shipped_table_is_the_one_in_the_code() {
        let text = include_str!("../../../../../assets/data/table1_2019.csv");
        let rows: Vec<Vec<f64>> = text
            .lines()
            .filter(|line| !line.starts_with('#') && !line.starts_with("node"))
            .map(|line| line.split(',').skip(1).map(|cell| cell.parse().unwrap()).collect())
            .collect();
        assert_eq!(rows.len(), 5);
        for (i, row) in rows.iter().enumerate() {
            let code = [
                MASS_KG[i],
                STIFFNESS_PRINTED_N_M[i],
                FREQUENCY_HZ[i],
                DAMPING_PRINTED_N_S_M[i],
                QUALITY_PRINTED[i],
            ];
            assert_eq!(row[..], code, "{}", NODES[i]);
        }
    }

    #[test]
    fn sets_differ_where_they_should() {
        let t = Elements::new(Parameters::Table, 5.0);
        let printed = Elements::new(Parameters::Printed, 5.0);
        assert_eq!((t.stiffness_n_m[3], printed.stiffness_n_m[3]), (6.3e8, 6.3e12));
        assert_eq!((t.damping_n_s_m[4], printed.damping_n_s_m[4]), (2.6e5, 2.6e8));
        assert_eq!(printed.damping_n_s_m, DAMPING_PRINTED_N_S_M);
        let sharp = Elements::new(Parameters::Rules, 17.0).damping_n_s_m[1];
        assert!((sharp - 691.15).abs() < 0.01, "{sharp}");
    }
}
