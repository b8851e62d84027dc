//! Table 1 of 2019 beside its own rules, and what of the paper can be reproduced.

use serde::Serialize;

use crate::base::language::{decimal, fixed, text, tr};
use crate::models::structure::frf::{frequencies_hz, tree};
use crate::models::structure::literal::Equation;
use crate::models::structure::modes::undamped;
use crate::models::structure::parameters::{
    DAMPING_PRINTED_N_S_M, Elements, FREQUENCY_HZ, MASS_KG, NODES, Parameters, QUALITY_PRINTED,
    STIFFNESS_PRINTED_N_M, by_rule,
};
use crate::models::structure::{FiveMass, MachineSettings};

/// Largest difference between a printed number and its rule that rounding explains.
const ROUNDING: f64 = 0.05;

/// A node of Table 1, as printed and by the rules k = m (2 pi f)^2, c = sqrt(k m) / Q.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct MachineTableRow {
    /// Node.
    pub node: &'static str,
    /// Mass as printed, kg.
    pub mass_kg: f64,
    /// Frequency as printed, Hz.
    pub frequency_hz: f64,
    /// Quality factor as printed.
    pub quality: f64,
    /// Spring as printed, N/m.
    pub stiffness_printed_n_m: f64,
    /// Spring by the rule, N/m.
    pub stiffness_rule_n_m: f64,
    /// Damper as printed, N s/m.
    pub damping_printed_n_s_m: f64,
    /// Damper by the rule with the printed quality factor, N s/m.
    pub damping_rule_n_s_m: f64,
    /// Spring and damper, each within what rounding explains.
    pub agrees: [bool; 2],
    /// What is wrong, if anything.
    pub verdict: MachineTableVerdict,
    /// The same in words.
    pub verdict_text: &'static str,
}

steadycut_core::choice! {
    /// What is wrong with a row of Table 1.
    pub enum MachineTableVerdict {
        /// Nothing: spring and damper follow from the rules.
        AsRuled = "as_ruled", "as the rules say";
        /// The quality factor does not belong to the damper.
        Quality = "quality", "Q wrong: the damper shows 5, not 17";
        /// The mass has lost its digits, and the damper does not belong to it.
        Mass = "mass", "m3 rounded to one digit; damper wrong";
        /// The exponent of the spring.
        SpringExponent = "spring_exponent", "exponent of the spring wrong: 8, not 12";
        /// The exponent of the damper.
        DamperExponent = "damper_exponent", "exponent of the damper wrong: 5, not 8";
        /// Something that nobody has found yet.
        Unknown = "unknown", "not as the rules say";
    }
}

/// What is wrong with the rows, where they do not agree.
const WRONG: [MachineTableVerdict; 5] = [
    MachineTableVerdict::Unknown,
    MachineTableVerdict::Quality,
    MachineTableVerdict::Mass,
    MachineTableVerdict::SpringExponent,
    MachineTableVerdict::DamperExponent,
];

/// The verdict on a row: what is said to be wrong counts only where spring or damper really is off.
fn verdict(row: usize, agrees: [bool; 2]) -> MachineTableVerdict {
    if agrees == [true, true] { MachineTableVerdict::AsRuled } else { WRONG[row] }
}

/// The five rows.
#[must_use]
pub fn table() -> [MachineTableRow; 5] {
    [0, 1, 2, 3, 4].map(|i| {
        let (stiffness_rule_n_m, damping_rule_n_s_m) = by_rule(i, QUALITY_PRINTED[i]);
        let near = |printed: f64, rule: f64| (printed / rule - 1.0).abs() <= ROUNDING;
        let agrees = [
            near(STIFFNESS_PRINTED_N_M[i], stiffness_rule_n_m),
            near(DAMPING_PRINTED_N_S_M[i], damping_rule_n_s_m),
        ];
        MachineTableRow {
            node: NODES[i],
            mass_kg: MASS_KG[i],
            frequency_hz: FREQUENCY_HZ[i],
            quality: QUALITY_PRINTED[i],
            stiffness_printed_n_m: STIFFNESS_PRINTED_N_M[i],
            stiffness_rule_n_m,
            damping_printed_n_s_m: DAMPING_PRINTED_N_S_M[i],
            damping_rule_n_s_m,
            agrees,
            verdict: verdict(i, agrees),
            verdict_text: verdict(i, agrees).label(),
        }
    })
}

/// What the corrected and the literal equations give; every number is computed here.
#[must_use]
pub fn measured() -> Vec<String> {
    let machine = FiveMass::new(&MachineSettings::default());
    let peak = frequencies_hz()
        .map(|f_hz| (f_hz, tree(&machine, f_hz).grel.norm_sqr().sqrt()))
        .max_by(|x, y| x.1.total_cmp(&y.1))
        .unwrap_or((0.0, 0.0));
    let modes = undamped(&machine).unwrap_or_default();
    let modes: Vec<String> = modes.iter().map(|mode| fixed(mode.frequency_hz, 2)).collect();
    let poles = |parameters: Parameters| {
        let elements = Elements::new(parameters, 5.0);
        let poles = Equation::One.unstable_poles(&elements).unwrap_or_default();
        let poles: Vec<String> = poles.iter().map(|pole| fixed(pole.re, 1)).collect();
        poles.join(tr(" and "))
    };
    let rules = Elements::new(Parameters::Rules, 5.0);
    let tooth = |f_hz: f64| Equation::Two.tooth_m_n(&rules, f_hz).unwrap_or(f64::NAN);
    let still = machine.static_compliance().h33_m_n;
    let scientific = |value: f64| decimal(format!("{value:.3e}"));
    vec![
        tr!("natural frequencies without damping: {list} Hz", list = modes.join(", ")),
        tr!(
            "one resonance between tooth and work from 0 to 3000 Hz: {peak} m/N at {frequency} Hz",
            peak = scientific(peak.1),
            frequency = peak.0
        ),
        tr!(
            "eq. 1 as printed is unstable: real poles at +{corrected} 1/s with corrected numbers, at +{printed} 1/s \
             with the printed ones",
            corrected = poles(Parameters::Rules),
            printed = poles(Parameters::Printed)
        ),
        tr!(
            "eq. 2 as printed: tool point {printed} m/N at rest and {moving} at 110 Hz; corrected {corrected} \
             at rest, {times:.1} times as soft",
            printed = scientific(tooth(0.0)),
            moving = scientific(tooth(110.0)),
            corrected = scientific(still),
            times = still / tooth(0.0)
        ),
    ]
}

/// What of the paper is repeated here.
pub const REPRODUCED: &[&str] = &[
    text!("Table 1's springs and dampers from its rules, but for the entries of the errata"),
    text!(
        "the solution of eq. 2 by Gauss from 0 to 3000 Hz in steps of 10 Hz (`steadycut machine frf`)"
    ),
];

/// What cannot be, and why.
pub const NOT_REPRODUCED: &[&str] = &[
    text!(
        "no published curve: the figures are not available as data, so spectra, sound trend, roughness \
     profile and roughness trend stand beside no measurement"
    ),
    text!(
        "the correlations 0.684 and 0.993 compare with measurements that were not published; noise can be \
     chosen that gives them, which validates nothing"
    ),
    text!(
        "how wear changes springs and dampers is not stated; every law of wear here is an assumption"
    ),
    text!(
        "absolute amplitudes: a force of 107 N at every line of the spectrum is the formal reading of eq. 2"
    ),
    text!("parameters of the tool-life prediction: its equations are not in the paper"),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_that_agree_are_those_without_an_erratum() {
        let agrees = table().map(|row| row.agrees);
        let expected = [[true, true], [true, false], [false, false], [false, true], [true, false]];
        assert_eq!(agrees, expected);
        for (i, row) in table().iter().enumerate() {
            let expected = if i == 0 { MachineTableVerdict::AsRuled } else { WRONG[i] };
            assert_eq!((row.verdict, row.verdict_text), (expected, expected.label()), "{row:?}");
        }
        assert_eq!(verdict(0, [false, true]), MachineTableVerdict::Unknown);
        let ratio = |i: usize| table()[i].damping_printed_n_s_m / table()[i].damping_rule_n_s_m;
        assert!((ratio(1) - 3.397).abs() < 1e-3 && (ratio(2) - 0.641).abs() < 1e-3);
        let exponent = table()[3].stiffness_printed_n_m / table()[3].stiffness_rule_n_m / 1e4;
        assert!((exponent - 1.0).abs() < 0.01, "{exponent}");
    }

    #[test]
    fn measured_lines_carry_the_references_numbers() {
        let text = measured().join("\n");
        for number in ["109.93", "at 110 Hz", "5.042e-9", "4.888e-9", "25.4 times"] {
            assert!(text.contains(number), "{number} is missing in\n{text}");
        }
    }
}
