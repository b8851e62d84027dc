//! The 2005 paper's claims against runs: each reported as found, true or not.

use serde::Serialize;

use super::entrants::{self, Entrant, TABLE_1};
use super::iterations::MANY_ITERATIONS;
#[cfg(doc)]
use super::load_step;
use super::load_step::Transient;
use super::outcome::Measure;
use super::table_1;
use super::tournament::Compared;
use crate::base::units::{percent_from_ratio, ratio_from_percent};
use crate::run::presets;
use crate::verdict::Verdict;

/// Iterations that the paper needs at most.
const ITERATIONS: u32 = 4;
/// Removal rate gained in Experiment 1, percent.
const RATE_PERCENT: f64 = 27.0;
/// Time saved in one cut of Experiment 1, percent.
const TIME_1_PERCENT: f64 = 40.0;
/// Time saved in Experiment 2, percent.
const TIME_2_PERCENT: f64 = 24.0;
/// Row of UNKS in Table 1.
pub(super) const UNKS: usize = 5;

/// One claim.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ControlClaim {
    /// Which claim.
    pub id: &'static str,
    /// Whether the runs bear it out.
    pub verdict: Verdict,
    /// What the paper says.
    pub paper: &'static str,
    /// What they gave, and what has to be known about it.
    pub found: String,
}

/// Conventional milling and UNKS on a preset: Experiment 1 in one of its two readings.
///
/// # Panics
/// Never: a test loads every preset.
#[must_use]
pub fn both_on(preset: &str) -> Vec<Entrant> {
    let base = presets::load(preset).expect("presets are tested");
    entrants::on(&base, &[TABLE_1[0], TABLE_1[UNKS]])
}

/// What the claims are judged by.
#[derive(Clone, Copy, Debug)]
pub struct Evidence<'a> {
    /// Experiment 1, conventional milling and UNKS.
    pub experiment_1: &'a [Compared],
    /// Experiment 2, the six methods of Table 1 first.
    pub experiment_2: &'a [Compared],
    /// The same methods after the load step.
    pub transients: &'a [Transient],
    /// The load step, N: see [`load_step::forces_n`].
    pub load_step_n: [f64; 2],
    /// See [`IterationsJob`](super::iterations::IterationsJob).
    pub iterations_needed: u32,
}

/// Every claim; none while the tables have no finished run.
#[must_use]
pub fn claims(evidence: &Evidence<'_>) -> Vec<ControlClaim> {
    let (Some([conventional_1, unks_1]), Some(conventional), Some(unks), Some(step)) = (
        evidence.experiment_1.first_chunk::<2>(),
        evidence.experiment_2.first(),
        evidence.experiment_2.get(UNKS),
        evidence.transients.get(UNKS),
    ) else {
        return Vec::new();
    };
    if [conventional_1, unks_1, conventional, unks].iter().any(|row| row.finished == 0) {
        return Vec::new();
    }
    let never = if step.unstable { "is unstable" } else { "is never back within 10 %" };
    let told = step.periods.map_or(never.to_owned(), |n| {
        format!("takes {n} control periods to be back within 10 % for good")
    });
    let [before_n, after_n] = evidence.load_step_n;
    // The same metal in less time: the removal rate grows as the time shrinks.
    let ratio = unks_1.mean(Measure::Time) / conventional_1.mean(Measure::Time);
    let rate = percent_from_ratio(1.0 / ratio - 1.0);
    let saved_1 = percent_from_ratio(1.0 - ratio);
    let saved_2 =
        percent_from_ratio(1.0 - unks.mean(Measure::Time) / conventional.mean(Measure::Time));
    let [part_1, part_2] = [&both_on("experiment-1")[0].scenario, &entrants::experiment_2()];
    let cap_percent = part_1.cnc.override_max_percent;
    let possible = percent_from_ratio(1.0 - 1.0 / ratio_from_percent(cap_percent));
    let [printed_s, printed_unks_s] = [0, UNKS].map(|row| table_1::printed()[row].time_of_cut_s);
    let printed_saved = percent_from_ratio(1.0 - printed_unks_s / printed_s);
    let shipped = part_2.controller.unks.internal_iterations;
    let uneven = part_2.noise.inhomogeneity_percent;
    let from_rate = percent_from_ratio(1.0 - 1.0 / (1.0 + ratio_from_percent(RATE_PERCENT)));
    let held = unks.mean(Measure::Held);
    let tolerance = unks.mean(Measure::InTolerance);
    let needed = evidence.iterations_needed;
    vec![
        ControlClaim {
            id: "iterations_of_control",
            paper: "the force is back within four or less iterations: of the control, 20 ms each",
            verdict: (step.periods.is_some_and(|n| n <= ITERATIONS as usize)).into(),
            found: format!("after the load step from {before_n:.0} to {after_n:.0} N UNKS {told}"),
        },
        ControlClaim {
            id: "iterations_of_internal_loop",
            paper: "the same, of the internal loop with NM-1: the Slovene text adds 2 ms, which \
                    is a tenth of a control period",
            verdict: (needed <= ITERATIONS).into(),
            found: format!(
                "in Experiment 2 the loop is content after at most {needed} iterations where it may \
                 do {MANY_ITERATIONS}; the shipped limit is {shipped}"
            ),
        },
        ControlClaim {
            id: "removal_rate_1",
            paper: "Experiment 1: 27 % more removal rate",
            verdict: (rate >= RATE_PERCENT - 0.5).into(),
            found: format!(
                "{rate:+.1} %; the lengths and depths of the part are chosen with this in view"
            ),
        },
        ControlClaim {
            id: "time_1",
            paper: "Experiment 1: 40 % less time in one cut",
            verdict: (saved_1 >= TIME_1_PERCENT - 0.5).into(),
            found: format!(
                "{saved_1:.1} %; with at most {cap_percent} % of the programmed feed no more than \
                 {possible:.1} % is possible, and 27 % more removal rate is {from_rate:.1} % of time"
            ),
        },
        ControlClaim {
            id: "time_2",
            paper: "Experiment 2: 24 % less time",
            verdict: (saved_2 >= TIME_2_PERCENT - 0.5).into(),
            found: format!(
                "{saved_2:.1} %; the paper's own Table 1, {printed_unks_s} of {printed_s} s, gives \
                 {printed_saved:.1} %"
            ),
        },
        ControlClaim {
            id: "force_within_ten_percent",
            paper: "the controlled force deviates from the desired one by no more than 10 %",
            verdict: (held >= 99.5).into(),
            found: format!(
                "in {held:.0} % of UNKS's samples in contact and below the largest feed (Experiment \
                 2); over the whole length in contact, light sections included, {tolerance:.0} %. \
                 Entries, exits, depth steps, run-out and {uneven} % of inhomogeneity make the rest"
            ),
        },
    ]
}
