//! What is wrong with what was printed, and what SteadyCut does about it; checked numerically.

use serde::Serialize;

use super::published::PaperId;
use crate::base::language::text;

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
    ($paper:literal: $($number:literal, $printed:expr, $problem:expr, $resolution:expr;)+) => {
        &[ $( Erratum {
            number: $number,
            paper: $paper,
            printed: $printed,
            problem: $problem,
            resolution: $resolution,
        }, )+ ]
    };
}

/// The errata of a paper.
#[must_use]
pub fn of(paper: PaperId) -> &'static [Erratum] {
    match paper {
        PaperId::Sdnrp2007 => SDNRP_2007,
        PaperId::Strategy2013 => STRATEGY_2013,
    }
}

/// The errata of the 2005 combined system: its Table 1 is a comparison, not a table of simulations
/// that [`PaperId`] could re-run.
pub const COMBINED_2005: &[Erratum] = errata! { "2005":
    1, text!("1 / (0.001024 s^2 + 0.064 s + 1) beside \"natural frequency of 3 Hz and a settling time of \
        0.4 s\""),
        text!("its natural frequency is 4.97 Hz, critically damped; 3.2 Hz is its -3 dB bandwidth; it \
         settles to 2 % in 0.19 s, to 0.5 % in 0.24 s"),
        text!("both are kept as separate drives, 2013_eq1 and measured_3hz");
    2, text!("dead time"),
        text!("the paper has none; 2013 has 0.04 s, 2007 e^(-0.08 s)"),
        text!("0.04 s, two control periods; `papers --paper 2005 --robustness` shows 0, 40 and 80 ms");
    3, text!("radial depth R_D: 4 mm in the English text, 3 mm in the Slovene"),
        text!("they differ, and so does the force: 404 against 281 N at 0.08 mm and A_D = 2 mm"),
        text!("presets experiment-1 with 4 mm and experiment-1-sl with 3 mm; 280 N as desired force \
         belongs to 3 mm (`steadycut force`)");
    4, text!("Experiment 1: desired force 280 N in the set-up, 650 N in the discussion"),
        text!("at R_D = 4 mm already the starting depth takes 404 N"),
        text!("650 N with R_D = 4 mm, 280 N with R_D = 3 mm");
    5, text!("Experiment 2: desired force 650 N in the text, 0.665 kN in Table 1"),
        text!("they differ by 2 %"),
        text!("665 N");
    6, text!("Experiment 1: \"a time saving of 40 % with one cut\""),
        text!("with an override of at most 150 % no more than 33.3 % is possible, and 27 % more removal \
         rate is 21 % of time"),
        text!("the gain in removal rate is judged; the time is reported");
    7, text!("Table 1: times of 88 to 115 s"),
        text!("0.08 mm, two teeth and 1591.5 1/min are 254.65 mm/min, so 115 s are a path of 488 mm and \
         76.7 s the least at 150 %"),
        text!("all six times fit a constant programmed feed: the part has 488 mm");
    8, text!("\"returns the cutting-force value to the desired value level within four or less iterations\"; \
        the Slovene text adds 2 ms"),
        text!("0.5 ms each cannot be samples of 20 ms"),
        text!("read as iterations of the internal loop with NM-1 inside a control period");
    9, text!("sampling time 20 ms, 28.8 kHz"),
        text!("576 samples hold one tooth period of 18.85 ms, so run-out makes one peak high and the \
         next one low"),
        text!("kept; what is judged as a transient is the mean of four peaks");
    10, text!("Fig. 5: a step of the feed from 0.05 to 2 mm/tooth"),
        text!("2 mm a tooth would break a cutter of 16 mm"),
        text!("read as 0.2 mm/tooth");
    11, text!("\"the optimized feedrate would always be equal to the reference peak force\""),
        text!("a feed is no force: mistranslated"),
        text!("read as: the right override would be 100 %");
    12, text!("\"A_D\" and \"R_D\" in the English text"),
        text!("in another order than in the Slovene"),
        text!("A_D is the axial depth, R_D the radial one");
    13, text!("Fig. 6: 0.07, 0.35, 2.1, 0.09, 0.37, 0.4"),
        text!("without names; presumably learning rates and momenta by layer"),
        text!("not used; the ranges of 2013 are");
    14, text!("Table 1: \"optimization time\" and \"iterations\", 0.001 s / 18 to 0.012 s / 34"),
        text!("what was timed and what was counted is not said"),
        text!("beside them stand a controller's cost per update and its control periods after a load \
         step");
    15, text!("eq. 2, the normalised standard error, over n = 20 samples"),
        text!("which 20 is not said; the spread over seeds is some 0.02"),
        text!("over all samples in contact; the form with 20, evenly spaced, stands beside it");
};

const SDNRP_2007: &[Erratum] = errata! { "2007":
    1, text!("\"t = 8 s: time delay\""),
        text!("the transfer functions have e^(-0.08 s)"),
        text!("dead time 0.08 s");
    2, text!("eq. 2: (s + 14.0) + (s^2 + 155 s + 35500)"),
        text!("a sum has no unit gain at rest"),
        text!("a product: 14 x 35500 = 497000, the printed numerator");
    3, text!("eq. 1 with the constants of Table 1"),
        text!("gives 582508 / (s^3 + 169.0 s^2 + 38699.7 s + 582508), with other poles than eq. 2"),
        text!("both are kept as separate drives, 2007_eq1 and 2007_eq2");
    4, text!("\"reference roughness 0.81 mm\""),
        text!("the unit"),
        text!("0.81 um");
    5, text!("K2, eq. 5"),
        text!("the feed is negative for every force below 177.07 N, that is for half of Table 3"),
        text!("re-identified; the printed form runs with its commands limited and marked out of range");
    6, text!("K1, eq. 4"),
        text!("K1(0.81 um) = 188.0 N where Table 3 has 178.5 N; at 0.38 um 139.7 N against 161.4 N"),
        text!("re-identified from Table 3");
    7, text!("K3, eq. 6"),
        text!("gives about 4100 1/min where Table 3 has about 2100 1/min"),
        text!("re-identified from Table 3");
    8, text!("K4, eq. 7"),
        text!("exceeds the table's final force, from the table's own final feed and speed, by 32.8 N \
         in simulations 1 to 9"),
        text!("only the intercept is wrong: 253.66 in place of 286.44 N meets all ten rows within 0.75 N");
    9, text!("Table 3, simulation 10: final force 195.2 N"),
        text!("from the table's own feed and speed the restored K4 gives 190.2 N, which also lies on \
         the force-roughness curve of all other rows"),
        text!("taken as a misprint of 190.2 N; the printed value is shown beside it");
    10, text!("K5, eq. 8"),
        text!("misses the table's roughness by up to 30 %"),
        text!("the exact inverse of the re-identified K1");
    11, text!("findings: deviation of Ra at most 4.1 %, of force at most 5.2 %"),
        text!("in the paper's own Table 3 the final Ra is off its target by +31.6 % (simulation 1) to \
         -22.4 % (simulation 10)"),
        text!("the table's own deviations are reported");
    12, text!("K1 to K5 by genetic programming from 185 measurements"),
        text!("the measurements were never published, and the table's final feeds and speeds lie on one line \
         (correlation -0.995), which tells no formula of both"),
        text!("calibration genetic: K1, K2, K3 and K5 found anew in Table 3 by genetic programming, K4 the \
         printed form with its constants fitted (`steadycut identify genetic`); all 40 final values lie \
         within their bands");
};

const STRATEGY_2013: &[Erratum] = errata! { "2013":
    1, text!("eq. 3 (M2): \"10^05 F^4\""),
        text!("can only be 10^-5; and rounded so, M2 gives negative feeds of thousands at every force \
         of Table 1"),
        text!("restored with 1.426371e-5 F^4 - 1.015767e-2 F^3, which gives the final feeds of Table 3 \
         of 2007 from its desired forces; re-identified from Table 1");
    2, text!("eq. 4 (M3): exponent -0.004"),
        text!("gives about 3700 1/min where Table 1 has about 2200 1/min"),
        text!("restored with -0.0071, which gives the final speeds from the initial forces within \
         4.7 %; re-identified");
    3, text!("eq. 6 (M5): leading coefficient 0.0001"),
        text!("gives 0.11 to 0.14 um where Table 1 has 0.44 to 0.99 um, and turns round at 170.5 N, \
         inside the table"),
        text!("restored with 0.00012025 (least squares), which still misses by up to 0.19 um; \
         re-identified as the exact inverse of M1");
    4, text!("eq. 2 (M1)"),
        text!("M1(0.40 um) = 135.6 N where Table 1 starts from 164.5 N and ends at 157.5 N; at 1.11 um \
         219.5 N against 188.1 N"),
        text!("re-identified from Table 1");
    5, text!("eq. 5 (M4)"),
        text!("exceeds the table's final force, from the table's own final feed and speed, by 12 to \
         28 N, and the initial force by 27 to 36 N; there is no one intercept that mends it"),
        text!("the printed form with its intercept and feed coefficient re-identified, its speed \
         coefficient as printed");
    6, text!("eq. 1: 1 / (0.001024 s^2 + 0.064 s + 1) beside \"natural frequency of 3 Hz and a settling \
        time of 0.4 s\""),
        text!("its natural frequency is 4.97 Hz, critically damped; 3.2 Hz is its -3 dB bandwidth"),
        text!("both are kept as separate drives");
    7, text!("\"neural network predictions were by 4 % closer to the measurements, compared to 6 %\""),
        text!("the 3500 measurements were never published; read as mean errors of 4 % and 6 %"),
        text!("networks and formulas are trained on one data set from the mechanistic force model with \
         measurement noise, the formula by genetic programming; their errors stand beside the \
         paper's, true or not (`steadycut papers --paper 2013`)");
    8, text!("section 2.1: \"seven constraints are listed in [18]\""),
        text!("the list is not given"),
        text!("the usual seven of milling, each marked as chosen, machine limits in a file of \
         placeholders");
    9, text!("Table 1, simulations 6 and 7"),
        text!("the force differs by 1 N, the roughness by 0.17 um: the table is not smooth, no smooth \
         function of force meets both"),
        text!("Ra is judged within 0.08 um");
    10, text!("section 2.3: \"momentum rates between 0.008 and 0.01 are good\" for small errors, but should \
         \"not exceed 0.004 if the number of training cycles is also to be minimized\""),
        text!("no momentum serves both"),
        text!("`steadycut train --study` prints both rates beside others");
    11, text!("M1 to M5 by genetic programming from 200 measurements"),
        text!("the measurements were never published, and the table's final feeds and speeds lie on one line \
         (correlation -0.937)"),
        text!("calibration genetic: M1, M2, M3 and M5 found anew in Table 1 by genetic programming, M4 the \
         printed form with its speed coefficient as printed and the others fitted (`steadycut identify \
         genetic`); all 32 final values lie within their bands");
};
