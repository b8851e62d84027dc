//! UNKS over the same part again and again, the learned networks carried from pass to pass.
//!
//! Every pass is a whole run of a scenario of its own: that of the pass before with its learned
//! networks put in, rounded as a file keeps them. So a pass can be saved and run again by itself.
//! All passes have the same seed, part and noise: what changes from one to the next is learned.

use serde::Serialize;

use crate::base::language::text;
use crate::base::network::Provenance;
use crate::base::settings::{SettingError, Value};
use crate::blocks::control::ControllerKind;
use crate::blocks::control::unks::Learning;
use crate::blocks::cutting::tool_path::ToolPath;
use crate::models::unks::{Stored, StoredNetworks, UnksStart};
use crate::run::edits::Edits;
use crate::run::job::{Budget, Job, Progress};
use crate::run::one_run::Run;
use crate::run::scenario::Scenario;

/// Reference figures of the cold start on Experiment 2 (spec, numerical prototype): normalised
/// standard error and time in s with the learning off, in the first and in the fifth pass at 0.003.
pub const REFERENCE: [[f64; 2]; 3] = [[0.224, 96.4], [0.207, 87.9], [0.167, 90.2]];
/// By how much the fifth pass is to be better than the first.
pub const BETTER: f64 = 0.15;
/// Most passes.
pub const MAX_PASSES: u32 = 50;

/// One pass.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Pass {
    /// Its number, from 1.
    pub number: u32,
    /// Normalised standard error over all samples in contact; none without contact.
    pub normalized_standard_error: Option<f64>,
    /// Time of the cut, s.
    pub time_of_cut_s: f64,
    /// Largest force, kN.
    pub max_force_kn: f64,
    /// Mean size of the feedback's share of the override, over the samples in which the override
    /// was not at a limit: there no controller can hold the force, and the feedback goes on asking.
    pub feedback: f64,
    /// The same for each quarter of the part; 0 where there is no such sample.
    pub feedback_by_quarter: [f64; 4],
}

/// Sums and counts for means by quarter.
#[derive(Clone, Copy, Debug, Default)]
struct Means {
    sums: [f64; 4],
    counts: [u32; 4],
}

impl Means {
    fn add(&mut self, share: f64, value: f64) {
        let quarter = ((4.0 * share) as usize).min(3);
        self.sums[quarter] += value;
        self.counts[quarter] += 1;
    }

    fn quarters(&self) -> [f64; 4] {
        std::array::from_fn(|i| self.sums[i] / f64::from(self.counts[i].max(1)))
    }

    fn all(&self) -> f64 {
        self.sums.iter().sum::<f64>() / f64::from(self.counts.iter().sum::<u32>().max(1))
    }
}

/// The passes, one after the other, in slices.
#[derive(Clone, Debug)]
pub struct Passes {
    scenario: Scenario,
    from_scratch: bool,
    wanted: u32,
    length_mm: f64,
    run: Run,
    means: Means,
    /// Samples of the scheme seen so far in this pass.
    seen: u32,
    /// The networks after the last whole pass.
    learned: Option<Stored>,
    /// Why what was learned cannot be gone on with.
    refused: Option<SettingError>,
    done: Vec<Pass>,
}

impl Passes {
    /// Passes of `scenario` with UNKS, not yet begun; at least one and at most [`MAX_PASSES`].
    /// They begin with the networks of the scenario, and its edits are left out.
    ///
    /// # Panics
    /// Never: no rule refuses a controller, or a row for every control period.
    #[must_use]
    pub fn new(scenario: &Scenario, passes: u32) -> Self {
        let scenario = scenario.with(|settings| {
            settings.controller.kind = ControllerKind::Unks;
            // A row for every control sample is what the figures need.
            settings.run.record_every = settings.run.steps_per_control;
        });
        let scenario = scenario.expect("UNKS, and a row a control period, go with any scenario");
        let unks = &scenario.controller.unks;
        Self {
            from_scratch: unks.start == UnksStart::Cold && unks.networks.get().is_none(),
            wanted: passes.clamp(1, MAX_PASSES),
            length_mm: ToolPath::length_of(&scenario.workpiece),
            run: Run::new(&scenario, &Edits::none()),
            scenario,
            means: Means::default(),
            seen: 0,
            learned: None,
            refused: None,
            done: Vec::new(),
        }
    }

    /// Whether all passes are done.
    #[must_use]
    pub fn is_done(&self) -> bool {
        self.done.len() >= self.wanted as usize || self.refused.is_some()
    }

    /// Why no further pass begins before all are done: what was learned is not finite, as extreme
    /// rates can make it.
    #[must_use]
    pub fn refused(&self) -> Option<&SettingError> {
        self.refused.as_ref()
    }

    fn observe(&mut self) {
        let closed_loop = self.run.closed_loop();
        let Some(Learning { trace, .. }) = closed_loop.learning() else { return };
        if trace.samples != self.seen {
            self.seen = trace.samples;
            if !trace.free {
                return;
            }
            let share = closed_loop.row().position_mm / self.length_mm.max(f64::MIN_POSITIVE);
            self.means.add(share, trace.feedback.abs());
        }
    }

    fn finish(&mut self) {
        let metrics = self.run.metrics();
        let number = self.done.len() as u32 + 1;
        self.done.push(Pass {
            number,
            normalized_standard_error: metrics.normalized_standard_error,
            time_of_cut_s: metrics.time_of_cut_s,
            max_force_kn: metrics.max_force_n / 1000.0,
            feedback: self.means.all(),
            feedback_by_quarter: self.means.quarters(),
        });
        self.learned = learned(&self.run, number);
        if !self.is_done()
            && let Some(stored) = &self.learned
        {
            let networks = StoredNetworks::from(stored.clone());
            match self.scenario.change(|settings| settings.controller.unks.networks = networks) {
                Ok(()) => {
                    self.run = Run::new(&self.scenario, &Edits::none());
                    (self.means, self.seen) = (Means::default(), 0);
                }
                Err(refused) => self.refused = Some(refused),
            }
        }
    }

    /// The passes that are done.
    #[must_use]
    pub fn done(&self) -> &[Pass] {
        &self.done
    }

    /// The networks after the last pass that is done.
    #[must_use]
    pub fn learned(&self) -> Option<&Stored> {
        self.learned.as_ref()
    }

    /// What the passes show; none before the last one is done, or without contact.
    #[must_use]
    pub fn verdict(&self) -> Option<PassesVerdict> {
        if !self.is_done() {
            return None;
        }
        let (first, last) = (self.done.first()?, self.done.last()?);
        let [before, after] = [first.normalized_standard_error?, last.normalized_standard_error?];
        Some(PassesVerdict {
            feedback_falls: self.done.windows(2).all(|two| two[1].feedback < two[0].feedback),
            feedback: [first.feedback, last.feedback],
            error_gain: 1.0 - after / before,
            error_better: after <= (1.0 - BETTER) * before,
            unchanged: after == before && first.time_of_cut_s == last.time_of_cut_s,
            from_scratch: self.from_scratch,
        })
    }
}

/// What is known of the passes while they go on.
#[derive(Clone, Debug, PartialEq)]
pub struct PassesSoFar {
    /// The passes that are done.
    pub done: Vec<Pass>,
    /// The networks after the last of them.
    pub learned: Option<Stored>,
    /// What they show, once all are done.
    pub verdict: Option<PassesVerdict>,
    /// Why there is no further pass, if what was learned was refused.
    pub refused: Option<String>,
}

/// A step is a control period.
impl Job for Passes {
    type Partial = PassesSoFar;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        let steps = u64::from(self.scenario.run.steps_per_control);
        while !self.is_done() && budget.step() {
            let over = self.run.advance(steps);
            self.observe();
            if over {
                self.finish();
            }
        }
        self.is_done()
    }

    fn progress(&self) -> Progress {
        let row = self.run.closed_loop().row();
        let of_pass = (row.position_mm / self.length_mm.max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
        let of_pass = if self.is_done() { 0.0 } else { of_pass };
        let done = self.done.len() as f64 + of_pass;
        let total = if self.refused.is_some() { done } else { f64::from(self.wanted) };
        Progress { done, total, unit: text!("passes") }
    }

    fn partial(&self) -> PassesSoFar {
        PassesSoFar {
            done: self.done.clone(),
            learned: self.learned.clone(),
            verdict: self.verdict(),
            refused: self.refused.as_ref().map(ToString::to_string),
        }
    }
}

/// What the passes show.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct PassesVerdict {
    /// Whether the feedback's share is smaller in every pass than in the one before.
    pub feedback_falls: bool,
    /// Its mean in the first and the last pass.
    pub feedback: [f64; 2],
    /// By what fraction the normalised standard error is smaller in the last pass than in the first.
    pub error_gain: f64,
    /// Whether that is at least [`BETTER`].
    pub error_better: bool,
    /// Whether the passes began untrained: networks that are trained already have less to learn.
    pub from_scratch: bool,
    /// Whether error and time are the same in both, as they are where nothing is learned.
    pub unchanged: bool,
}

/// The networks of a run as they are after its last step, to be kept; none where its controller has
/// none. `passes` is how often the part has been cut.
#[must_use]
pub fn learned(run: &Run, passes: u32) -> Option<Stored> {
    let learning = run.closed_loop().learning()?;
    let (scenario, settings) = (run.scenario(), &run.scenario().controller.unks);
    let origin = |rows: u32, rate: f64| Provenance {
        note: format!("learned in the cut by UNKS: {}", scenario.info.name),
        rows,
        seed: scenario.run.seed,
        epochs: passes,
        rate,
        momentum: 0.0,
        decay: 0.0,
    };
    let inverse_rate = match learning.start {
        UnksStart::Shipped => settings.inverse_rate,
        UnksStart::Cold => settings.cold_rate,
    };
    let [forward, inverse] = learning.lessons;
    let origins =
        [origin(0, 0.0), origin(forward, settings.forward_rate), origin(inverse, inverse_rate)];
    Some(Stored::new(learning.start, &learning.now(), origins))
}

/// The settings by which a scenario begins with these networks, under the law they belong to.
#[must_use]
pub fn beginning_with(stored: &Stored) -> Vec<(String, Value)> {
    vec![
        ("controller.unks.start".to_owned(), Value::Text(stored.start.id().to_owned())),
        ("controller.unks.networks".to_owned(), StoredNetworks::value_of(stored)),
    ]
}

/// The settings by which a scenario begins again, with the networks of this start.
#[must_use]
pub fn beginning_anew(start: UnksStart) -> Vec<(String, Value)> {
    vec![
        ("controller.unks.start".to_owned(), Value::Text(start.id().to_owned())),
        ("controller.unks.networks".to_owned(), Value::Text(String::new())),
    ]
}
