//! What is wrong with what was printed, and what SteadyCut does about it; checked numerically.

use serde::Serialize;

/// One entry of the errata list.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Erratum {
    /// Number within the paper's list.
    pub number: u32,
    /// The paper.
    pub paper: &'static str,
    /// What was printed, and where.
    pub printed: &'static str,
    /// What is wrong with it.
    pub problem: &'static str,
    /// What is done about it here.
    pub resolution: &'static str,
}

macro_rules! errata {
    ($paper:literal: $($number:literal, $printed:literal, $problem:literal, $resolution:literal;)+) => {
        &[ $( Erratum {
            number: $number,
            paper: $paper,
            printed: $printed,
            problem: $problem,
            resolution: $resolution,
        }, )+ ]
    };
}

/// Errata of SDNRP 2007.
pub const ERRATA_2007: &[Erratum] = errata! { "2007":
    1, "\"t = 8 s: time delay\"",
        "the transfer functions have e^(-0.08 s)",
        "dead time 0.08 s";
    2, "eq. 2: (s + 14.0) + (s^2 + 155 s + 35500)",
        "a sum has no unit gain at rest",
        "a product: 14 x 35500 = 497000, the printed numerator";
    3, "eq. 1 with the constants of Table 1",
        "gives 582508 / (s^3 + 169.0 s^2 + 38699.7 s + 582508), with other poles than eq. 2",
        "both are kept as separate drives, 2007_eq1 and 2007_eq2";
    4, "\"reference roughness 0.81 mm\"",
        "the unit",
        "0.81 um";
    5, "K2, eq. 5",
        "the feed is negative for every force below 177.07 N, that is for half of Table 3",
        "re-identified; the printed form runs with its commands limited and marked out of range";
    6, "K1, eq. 4",
        "K1(0.81 um) = 188.0 N where Table 3 has 178.5 N; at 0.38 um 139.7 N against 161.4 N",
        "re-identified from Table 3";
    7, "K3, eq. 6",
        "gives about 4100 1/min where Table 3 has about 2100 1/min",
        "re-identified from Table 3";
    8, "K4, eq. 7",
        "exceeds the table's final force, from the table's own final feed and speed, by 32.8 N \
         in simulations 1 to 9",
        "only the intercept is wrong: 253.66 in place of 286.44 N meets all ten rows within 0.75 N";
    9, "Table 3, simulation 10: final force 195.2 N",
        "from the table's own feed and speed the restored K4 gives 190.2 N, which also lies on \
         the force-roughness curve of all other rows",
        "taken as a misprint of 190.2 N; the printed value is shown beside it";
    10, "K5, eq. 8",
        "misses the table's roughness by up to 30 %",
        "the exact inverse of the re-identified K1";
    11, "findings: deviation of Ra at most 4.1 %, of force at most 5.2 %",
        "in the paper's own Table 3 the final Ra is off its target by +31.6 % (simulation 1) to \
         -22.4 % (simulation 10)",
        "the table's own deviations are reported";
};
