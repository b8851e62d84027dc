//! Robustness of a controller: many runs of a scenario whose plant is drawn at random, while the
//! controller's beliefs stay as they are.
//!
//! Drawn for every run, before any of them begins: seed of the noise, hardness (uniform in +-20 %), wear
//! factor (1 to 1.3), dead time of the machine (0 to 80 ms), errors of the believed depth (+-10 %) and
//! place (+-1 mm). The believed dead time stays that of the scenario: 40 ms in Experiment 2, the middle
//! of the range. The result is the 95th percentile of the largest force against 1.15 kN, and that no run
//! is stopped.

use serde::Serialize;

use crate::base::language::text;
use crate::base::rng::Stream;
use crate::base::settings::{SettingError, Value};
use crate::base::stats::Sorted;
use crate::blocks::control::ControllerKind;
use crate::run::edits::Edits;
use crate::run::end::EndId;
use crate::run::job::{Budget, Job, Progress};
use crate::run::one_run::{End, Run};
use crate::run::parts::{Making, Parts};
use crate::run::scenario::Scenario;

/// The 95th percentile of the largest force may reach this, kN.
pub const LIMIT_KN: f64 = 1.15;
/// Most runs of a study.
pub const MAX_RUNS: u32 = 10_000;

/// One setting that is drawn: its path, and the range over which it is uniform, absolute or relative to
/// the scenario's value.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct DrawnPlant {
    /// Path of the setting.
    pub path: &'static str,
    /// Range.
    pub range: [f64; 2],
    /// Whether the range multiplies the scenario's value.
    pub relative: bool,
}

/// What is drawn for every run, besides its seed.
pub const DRAWN: [DrawnPlant; 5] = [
    DrawnPlant { path: "plant.hardness_hb", range: [0.8, 1.2], relative: true },
    DrawnPlant { path: "plant.wear_factor", range: [1.0, 1.3], relative: false },
    DrawnPlant { path: "cnc.dead_time_s", range: [0.0, 0.08], relative: false },
    DrawnPlant { path: "belief.depth_error_percent", range: [-10.0, 10.0], relative: false },
    DrawnPlant { path: "belief.position_error_mm", range: [-1.0, 1.0], relative: false },
];

/// What one run gave.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct RobustOutcome {
    /// The values drawn, in the order of [`DRAWN`].
    pub drawn: [f64; 5],
    /// Largest force, kN.
    pub max_force_kn: f64,
    /// Normalised standard error over all samples in contact.
    pub normalized_standard_error: f64,
    /// Time of the cut, s.
    pub time_of_cut_s: f64,
    /// Whether the path was cut to its end, without a stop.
    pub finished: bool,
    /// Whether a fault of the controller's script ended it.
    pub script_failed: bool,
}

/// Percentiles over the runs.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Percentiles {
    /// Half of the runs lie below it.
    pub p50: f64,
    /// 95 % of the runs lie below it.
    pub p95: f64,
    /// The largest of all.
    pub largest: f64,
}

impl Percentiles {
    /// Without any run nothing is promised.
    fn of(values: impl Iterator<Item = f64>) -> Self {
        let sorted = Sorted::new(values);
        let at = |fraction: f64| sorted.quantile(fraction).unwrap_or(f64::INFINITY);
        Self { p50: at(0.5), p95: at(0.95), largest: at(1.0) }
    }
}

/// What the study found.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct RobustFindings {
    /// Runs done.
    pub runs: usize,
    /// Largest force, kN.
    pub max_force_kn: Percentiles,
    /// Normalised standard error.
    pub normalized_standard_error: Percentiles,
    /// Time of the cut, s.
    pub time_of_cut_s: Percentiles,
    /// Runs that did not reach the end of the path: stopped by an overload, out of time, or with a script that failed.
    pub unfinished: usize,
    /// Those of them that a fault of the controller's script ended.
    pub script_failed: usize,
    /// Whether the 95th percentile of the largest force keeps [`LIMIT_KN`] and every run is finished.
    pub passed: bool,
}

/// The study: the scenarios of all runs, drawn at once.
#[derive(Clone, Debug)]
pub struct Robustness {
    drawn: Drawn,
    runs: Parts<Run, RobustOutcome>,
}

/// What the runs are made of.
#[derive(Clone, Debug)]
struct Drawn {
    base: Scenario,
    draws: Vec<(u32, [f64; 5])>,
}

impl Robustness {
    /// A study of `runs` runs of `scenario` with a controller, drawn from `seed`; not yet begun.
    ///
    /// # Panics
    /// Never: no rule refuses a controller, or a row for every control period.
    #[must_use]
    pub fn new(scenario: &Scenario, kind: ControllerKind, runs: u32, seed: u32) -> Self {
        let base = scenario.with(|settings| {
            settings.controller.kind = kind;
            // A row for every control sample is what the figures need.
            settings.run.record_every = settings.run.steps_per_control;
        });
        let base = base.expect("a controller, and a row a control period, go with any scenario");
        let streams = DRAWN.map(|drawn| Stream::new(u64::from(seed), drawn.path));
        let seeds = Stream::new(u64::from(seed), "run.seed");
        let draw = |run: u64| {
            let values = std::array::from_fn(|i| {
                let [low, high] = DRAWN[i].range;
                low + (high - low) * streams[i].uniform(run)
            });
            (seeds.bits(run) as u32, values)
        };
        let runs = u64::from(runs.clamp(1, MAX_RUNS));
        let drawn = Drawn { base, draws: (0..runs).map(draw).collect() };
        Self { drawn, runs: Parts::default() }
    }

    /// Number of runs.
    #[must_use]
    pub fn runs(&self) -> usize {
        self.drawn.draws.len()
    }

    /// The scenario of a run, counted from 0.
    ///
    /// # Errors
    /// A drawn value lies outside the range of its setting.
    pub fn scenario(&self, run: usize) -> Result<Scenario, SettingError> {
        self.drawn.scenario(run)
    }

    /// Outcomes of the runs done so far, in order.
    #[must_use]
    pub fn outcomes(&self) -> &[RobustOutcome] {
        self.runs.done()
    }

    /// What the script of the first run that it failed in says, with its line; none where it has failed in none.
    #[must_use]
    pub fn script_fault(&self) -> Option<String> {
        let failed = self.outcomes().iter().position(|one| one.script_failed)?;
        let run = Run::complete(&self.scenario(failed).ok()?, &Edits::none());
        run.end().map(End::to_string)
    }

    /// What was found so far.
    #[must_use]
    pub fn findings(&self) -> RobustFindings {
        let over = |of: fn(&RobustOutcome) -> f64| Percentiles::of(self.outcomes().iter().map(of));
        let max_force_kn = over(|one| one.max_force_kn);
        let unfinished = self.outcomes().iter().filter(|one| !one.finished).count();
        RobustFindings {
            runs: self.outcomes().len(),
            max_force_kn,
            normalized_standard_error: over(|one| one.normalized_standard_error),
            time_of_cut_s: over(|one| one.time_of_cut_s),
            unfinished,
            script_failed: self.outcomes().iter().filter(|one| one.script_failed).count(),
            passed: max_force_kn.p95 <= LIMIT_KN && unfinished == 0,
        }
    }
}

impl Drawn {
    fn scenario(&self, run: usize) -> Result<Scenario, SettingError> {
        let mut scenario = self.base.clone();
        let (seed, values) = self.draws[run % self.draws.len()];
        scenario.change(|settings| settings.run.seed = seed)?;
        for (drawn, value) in DRAWN.iter().zip(values) {
            let factor = match (drawn.relative, self.base.get(drawn.path)?) {
                (true, Value::Float(now)) => now,
                _ => 1.0,
            };
            scenario.set(drawn.path, Value::Float(factor * value))?;
        }
        Ok(scenario)
    }

    fn outcome(&self, index: usize, run: &Run) -> RobustOutcome {
        let metrics = run.metrics();
        RobustOutcome {
            drawn: self.draws[index].1,
            max_force_kn: metrics.max_force_n / 1000.0,
            normalized_standard_error: metrics.normalized_standard_error.unwrap_or(f64::INFINITY),
            time_of_cut_s: metrics.time_of_cut_s,
            finished: run.end() == Some(&End::PathDone),
            script_failed: run.end().map(End::id) == Some(EndId::Script),
        }
    }
}

/// A step is one of the plant in one of the runs.
impl Job for Robustness {
    type Partial = RobustFindings;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        let drawn = &self.drawn;
        let begin = |index: usize| {
            let scenario = drawn.scenario(index).map_err(|error| error.to_string())?;
            Ok(Run::new(&scenario, &Edits::none()))
        };
        let end = |index: usize, run: &Run| drawn.outcome(index, run);
        self.runs.advance(drawn.draws.len(), budget, &Making { begin: &begin, end: &end })
    }

    fn progress(&self) -> Progress {
        Progress { done: self.runs.progress(), total: self.runs() as f64, unit: text!("runs") }
    }

    fn partial(&self) -> RobustFindings {
        self.findings()
    }

    fn refusal(&self) -> Option<&str> {
        self.runs.refusal()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn percentiles_are_quantiles_of_the_runs() {
        let of = |n: u32| Percentiles::of((1..=n).rev().map(f64::from));
        assert_eq!(of(100), Percentiles { p50: 50.5, p95: 95.05, largest: 100.0 });
        assert_eq!(of(3), Percentiles { p50: 2.0, p95: 2.9, largest: 3.0 });
        assert_eq!(of(1).p95, 1.0);
        assert_eq!(of(0).p95, f64::INFINITY);
    }

    /// A script is a contestant as any other; one that fails is told with its line, and passes nothing.
    #[test]
    fn a_script_of_ones_own_is_drawn_for_and_its_fault_is_told() {
        use crate::run::presets;
        let base = presets::load("own-controller").unwrap();
        let base = base.with(|s| s.run.duration_s = 2.0).unwrap();
        let study = |scenario: &Scenario, kind: ControllerKind| {
            let mut study = Robustness::new(scenario, kind, 3, 1);
            study.to_end();
            study
        };
        let own = study(&base, ControllerKind::Script);
        assert_eq!((own.findings().runs, own.findings().script_failed), (3, 0));
        assert_eq!(own.script_fault(), None);
        let alone = Run::complete(&own.scenario(2).unwrap(), &Edits::none()).metrics();
        assert_eq!(own.outcomes()[2].max_force_kn, alone.max_force_n / 1000.0);
        let mut faulty = base;
        let code = "fn update(now) {\n    if now.x_mm > 3.0 { no_such_thing(now) }\n    100.0\n}\n";
        faulty.set("controller.script.code", Value::Text(code.to_owned())).unwrap();
        let failed = study(&faulty, ControllerKind::Script);
        let findings = failed.findings();
        assert_eq!((findings.script_failed, findings.unfinished, findings.passed), (3, 3, false));
        let told = failed.script_fault().unwrap();
        assert!(told.contains("script failed") && told.contains("line 2"), "{told}");
    }
}
