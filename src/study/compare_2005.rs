//! Table 1 of the 2005 combined system against the milling simulator: six ways of control on
//! Experiment 2, the same part and the same noise seeds for all of them.
//!
//! The part is an invention, since its drawing is lost, and its sections were chosen with the row
//! of conventional milling in view; so were run-out, inhomogeneity and air feed, and the gains of
//! P and MRAC ([`DISCLOSED`]). Nothing is tuned to a seed, and the plant is the same for every row.

use serde::{Deserialize, Serialize};

use crate::blocks::control::ControllerKind;
use crate::run::edits::Edits;
use crate::run::one_run::Run;
use crate::run::presets;
use crate::run::scenario::Scenario;

/// Table 1 as printed.
pub const TABLE_1: &str = include_str!("../../assets/data/table1_2005.csv");

/// What was chosen with the table in view, to be told beside every agreement.
pub const DISCLOSED: &[&str] = &[
    "the part: eight candidates were tried; conventional milling's row is calibrated by it, not \
     predicted, and so is a best possible time near 88 s",
    "inhomogeneity 5 %, run-out 3 um, air feed 150 %, dead time 40 ms: set once, looking at \
     conventional milling",
    "P: Kp = 1.1 is the stability limit at the heaviest section; MRAC: of some 25 settings the one \
     nearest to the table; division: of three readings the one that fits it",
    "adjustable PI and UNKS: first guesses, kept",
];

/// What cannot be reached honestly, and why.
pub const NOT_REACHED: &[&str] = &[
    "division 0.29 and 1.25 kN: static division is smooth by construction; on the last command it \
     oscillates instead",
    "PI 94 s: any integrating controller runs the light sections at the cap of 150 % and needs no \
     more than some 89 s here",
    "MRAC 0.90 kN: reached on a smooth plant only, not tooth by tooth",
    "UNKS wins by a hair: adjustable PI and one-gain MRAC are equal to it in error and time; what \
     it buys is a faster transient after a load step and lower peaks",
];

/// A row of Table 1 as printed.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
pub struct Printed {
    /// Method.
    pub method: String,
    /// Normalised standard error.
    pub normalized_standard_error: f64,
    /// Time of the cut, s.
    pub time_of_cut_s: f64,
    /// Time of an optimisation step, s; what was timed is not said.
    pub optimization_time_s: f64,
    /// Its iterations; what they are is not said.
    pub optimization_iterations: f64,
    /// Desired force, kN.
    pub desired_force_kn: f64,
    /// Largest force, kN.
    pub max_force_kn: f64,
}

/// The six methods in the order of the table.
pub const METHODS: [ControllerKind; 6] = [
    ControllerKind::ConstantFeed,
    ControllerKind::Division,
    ControllerKind::Proportional,
    ControllerKind::AdjustablePi,
    ControllerKind::Mrac,
    ControllerKind::Unks,
];

/// The rows as printed.
///
/// # Panics
/// Never: a test reads the shipped table.
#[must_use]
pub fn printed() -> Vec<Printed> {
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(TABLE_1.as_bytes());
    let rows: Result<Vec<Printed>, csv::Error> = reader.deserialize().collect();
    rows.expect("the shipped table is checked by a test")
}

/// Mean and standard deviation over the seeds.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Spread {
    /// Mean.
    pub mean: f64,
    /// Standard deviation of the sample.
    pub deviation: f64,
}

impl Spread {
    fn of(values: &[f64]) -> Self {
        let n = values.len() as f64;
        let mean = values.iter().sum::<f64>() / n;
        let squares: f64 = values.iter().map(|x| (x - mean) * (x - mean)).sum();
        Self { mean, deviation: (squares / (n - 1.0).max(1.0)).sqrt() }
    }
}

/// What one run gave.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Outcome {
    nsn: f64,
    nsn_20: f64,
    time_s: f64,
    force_kn: f64,
}

/// One method beside its printed row.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Compared {
    /// The controller's name.
    pub controller: &'static str,
    /// As printed.
    pub printed: Printed,
    /// Normalised standard error over all samples in contact.
    pub normalized_standard_error: Spread,
    /// The same over 20 samples, the paper's form.
    pub normalized_standard_error_20: Spread,
    /// Time of the cut, s.
    pub time_of_cut_s: Spread,
    /// Largest force of a run, kN.
    pub max_force_kn: Spread,
}

/// The scenario of a method with a seed.
///
/// # Panics
/// Never: a test loads every preset.
#[must_use]
pub fn scenario(kind: ControllerKind, seed: u32) -> Scenario {
    let mut scenario = presets::load("experiment-2").expect("presets are tested");
    scenario.controller.kind = kind;
    scenario.run.seed = seed;
    // A row for every control sample is what the figures need.
    scenario.run.record_every = scenario.run.steps_per_control;
    scenario
}

/// All runs of the comparison, one after the other.
#[derive(Clone, Debug)]
pub struct Comparison {
    seeds: u32,
    outcomes: Vec<Outcome>,
}

impl Comparison {
    /// A comparison over seeds 1 to `seeds`, not yet begun; at least one.
    #[must_use]
    pub fn new(seeds: u32) -> Self {
        Self { seeds: seeds.max(1), outcomes: Vec::new() }
    }

    /// Number of runs.
    #[must_use]
    pub fn runs(&self) -> usize {
        METHODS.len() * self.seeds as usize
    }

    /// Does the next run; `true` when all are done.
    pub fn advance(&mut self) -> bool {
        let next = self.outcomes.len();
        if next < self.runs() {
            let kind = METHODS[next / self.seeds as usize];
            let seed = 1 + (next % self.seeds as usize) as u32;
            let metrics = Run::complete(&scenario(kind, seed), &Edits::none()).metrics();
            self.outcomes.push(Outcome {
                nsn: metrics.normalized_standard_error.unwrap_or(f64::INFINITY),
                nsn_20: metrics.normalized_standard_error_20.unwrap_or(f64::INFINITY),
                time_s: metrics.time_of_cut_s,
                force_kn: metrics.max_force_n / 1000.0,
            });
        }
        self.outcomes.len() >= self.runs()
    }

    /// The methods whose runs are all done, beside the table.
    #[must_use]
    pub fn compared(&self) -> Vec<Compared> {
        let whole = self.outcomes.chunks_exact(self.seeds as usize);
        whole
            .zip(METHODS)
            .zip(printed())
            .map(|((outcomes, kind), printed)| {
                let spread = |of: fn(&Outcome) -> f64| {
                    Spread::of(&outcomes.iter().map(of).collect::<Vec<f64>>())
                };
                Compared {
                    controller: kind.label(),
                    printed,
                    normalized_standard_error: spread(|outcome| outcome.nsn),
                    normalized_standard_error_20: spread(|outcome| outcome.nsn_20),
                    time_of_cut_s: spread(|outcome| outcome.time_s),
                    max_force_kn: spread(|outcome| outcome.force_kn),
                }
            })
            .collect()
    }
}
