//! What is wrong with the dynamic model of 2019 as printed; numbers measured by the tests of
//! `models/structure`.

use super::errata::Erratum;
use crate::base::language::text;

const fn entry(
    number: u32,
    printed: &'static str,
    problem: &'static str,
    resolution: &'static str,
) -> Erratum {
    Erratum { number, paper: "2019", printed, problem, resolution }
}

/// The errata of Panda et al. 2019.
pub const MACHINE_2019: &[Erratum] = &[
    entry(
        1,
        text!("eq. 1, row 1: + c3 (z3' - z2') + k3 (z3 - z2)"),
        text!(
            "the force between 2 and 3 cannot act on the base, and its sign is that of no spring"
        ),
        text!("- c5 (z5' - z1') - k5 (z5 - z1): row 5 of eq. 2 hangs the table on the base by k5"),
    ),
    entry(
        2,
        text!("eq. 1, row 2: no term with k3, c3"),
        text!("the tooth's spring ends on nothing; momentum is not conserved"),
        text!("- c3 (z3' - z2') - k3 (z3 - z2), the reaction of row 3"),
    ),
    entry(
        3,
        text!("eq. 1, row 4: c4 (z4' - z3') + k4 (z4 - z3)"),
        text!(
            "ties the slides to the tooth, without reaction in row 3, and contradicts row 4 of eq. 2"
        ),
        text!("c4 (z4' - z5') + k4 (z4 - z5)"),
    ),
    entry(
        4,
        text!("eq. 1, row 5: - c5 (z5' - z4') - k5 (z5 - z4)"),
        text!(
            "a spring of negative stiffness k4 - k5 remains: eq. 1 as printed is unstable, with a real \
         pole at 2 pi x 194.9 rad/s with corrected numbers, at 2 pi x 4057 and 2 pi x 78659 rad/s \
         with the printed ones"
        ),
        text!("+ c5 (z5' - z1') + k5 (z5 - z1)"),
    ),
    entry(
        5,
        text!("eq. 2, row 1: k1 + k2 + k3 and -(k3 + i w c3) z3"),
        text!("not symmetric: row 3 has no z1, row 5 has one without partner"),
        text!("5 for 3 three times: k1 + k2 + k5, c1 + c2 + c5, -(k5 + i w c5) z5"),
    ),
    entry(
        6,
        text!("eq. 2, row 2: (k2 - w^2 m2) + i w c2"),
        text!(
            "the tooth's reaction is missing: the tool point has 5.04e-9 m/N at rest where the mended \
         machine has 1.28e-7, and no resonance of the spindle"
        ),
        text!("(k2 + k3 - w^2 m2) + i w (c2 + c3), and -(k3 + i w c3) z3"),
    ),
    entry(
        7,
        text!("eq. 2, row 3: [k3 + i w c3] z2 - [(k3 - w^2 m3) + i w c3] z3 = -P"),
        text!(
            "the left side is that of eq. 1 times -1, the right side is not: both forces point the same \
         way"
        ),
        text!("the left side times -1"),
    ),
    entry(8, text!("eq. 2, row 4: c_42"), text!("there is no such coefficient"), text!("c4")),
    entry(
        9,
        text!("Table 1: k4 = 6.3e12 N/m"),
        text!(
            "the rule below the table gives 6.26e8; with 6.3e12 c4 would be 1.46e7, not the printed \
         1.4e5"
        ),
        text!("exponent 8"),
    ),
    entry(
        10,
        text!("Table 1: c5 = 2.6e8 N s/m"),
        text!("the rule gives 2.62e5; 2.6e8 means Q = 0.003"),
        text!("exponent 5"),
    ),
    entry(
        11,
        text!("Table 1: c2 = 2348 N s/m beside Q = 17"),
        text!(
            "sqrt(k m) / 2348 = 5.00; Q = 17 needs 691 and repeats the mass m2 = 17 of its column"
        ),
        text!("Q = 5; 17 can be chosen (machine.spindle_quality)"),
    ),
    entry(
        12,
        text!("Table 1: k3 = 1.9e8 N/m, c3 = 0.5 N s/m, m3 = 0.3e-6 kg"),
        text!(
            "m3 is rounded to one digit: its rule gives k3 = 2.03e8; no m3 that rounds to 0.3e-6 gives \
         c3 = 0.5 with Q = 10"
        ),
        text!("both by the rule; c3 does not matter up to 3000 Hz"),
    ),
    entry(
        13,
        text!("Table 1: unit of c N/m/sec"),
        text!("a damper's unit is N s/m"),
        text!("N s/m"),
    ),
    entry(
        14,
        text!("note of Table 1: P_CF = 107 N"),
        text!("may have been 10^7 N, which is absurd for a cut"),
        text!("107 N, the order of the forces of 2007 and 2013"),
    ),
    entry(
        15,
        text!("\"six differential equations (1)\""),
        text!("five are printed, for five nodes"),
        text!("five; table and work piece are one node"),
    ),
    entry(
        16,
        text!("\"substitution xi(tau) = xi_A exp(i w tau)\""),
        text!("another symbol than zeta for the same quantity"),
        text!("zeta"),
    ),
    entry(
        17,
        text!("section 3: \"Fig. 4a .. spectra\", \"roughness (Figure 3a)\""),
        text!("the captions say the opposite"),
        text!("3a are the spectra, 4a is the roughness"),
    ),
    entry(
        18,
        text!("names of the nodes against eq. 2"),
        text!(
            "by the names the slides carry the table and the force acts on the table; by rows 4 and 5 the \
         table carries the slides and the force acts on these"
        ),
        text!(
            "variant A by the equations, variant B by the names (machine.variant); G_rel differs by 2.9 %"
        ),
    ),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entries_are_numbered_in_order_and_complete() {
        for (i, erratum) in MACHINE_2019.iter().enumerate() {
            assert_eq!(erratum.number as usize, i + 1);
            let texts = [erratum.printed, erratum.problem, erratum.resolution];
            assert!(texts.iter().all(|text| !text.is_empty()), "{}", erratum.number);
        }
    }
}
