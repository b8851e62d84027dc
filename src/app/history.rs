//! What a run's networks were on their way: samples of the learning, so that the playhead can show
//! them without repeating the run. What a sample holds is the state of the controller at a tick, so
//! rewinding leaves out what lies ahead and nothing else changes.

use crate::models::unks::UnksStart;
use crate::run::one_run::Run;

/// Most samples; with more, every other one goes and the distance doubles.
const MAX_SAMPLES: usize = 1024;

/// The learning at a moment.
#[derive(Clone, Debug, PartialEq)]
pub struct LearningSample {
    tick: u64,
    /// Time, s.
    pub time_s: f64,
    /// The start, and so the law.
    pub start: UnksStart,
    /// Mean size of the feedback's share of the override over about a second.
    pub feedback: f64,
    /// Mean size of NM-1's error, ln F, over as long.
    pub error: f64,
    /// Iterations of the internal loop.
    pub iterations: u32,
    /// Number of samples that NM-1 and NM-2 were trained with.
    pub lessons: [u32; 2],
    /// Weights of NM-1 and NM-2, in the order of their files.
    pub weights: [Vec<f64>; 2],
}

/// The samples of a run.
#[derive(Clone, Debug)]
pub struct LearningHistory {
    samples: Vec<LearningSample>,
    spacing: u64,
}

impl LearningHistory {
    /// The history of a run at its first tick.
    #[must_use]
    pub fn new(run: &Run) -> Self {
        let spacing = u64::from(run.scenario().run.steps_per_control);
        let mut history = Self { samples: Vec::new(), spacing };
        history.note(run);
        history
    }

    /// Ticks until the next sample is due.
    #[must_use]
    pub fn due(&self, run: &Run) -> u64 {
        self.spacing - run.ticks() % self.spacing
    }

    /// Takes a sample if one is due and there is something that learns.
    pub fn note(&mut self, run: &Run) {
        let tick = run.ticks();
        let known = self.samples.last().is_some_and(|last| last.tick >= tick);
        if known || !tick.is_multiple_of(self.spacing) {
            return;
        }
        let Some(learning) = run.closed_loop().learning() else { return };
        let weights = [learning.forward, learning.inverse];
        self.samples.push(LearningSample {
            tick,
            time_s: tick as f64 * run.scenario().dt_s(),
            start: learning.start,
            feedback: learning.trace.feedback_mean,
            error: learning.trace.error_mean,
            iterations: learning.trace.iterations,
            lessons: learning.lessons,
            weights: weights.map(|scaled| scaled.network.weights().to_vec()),
        });
        if self.samples.len() > MAX_SAMPLES {
            self.spacing *= 2;
            let spacing = self.spacing;
            self.samples.retain(|sample| sample.tick.is_multiple_of(spacing));
        }
    }

    /// Forgets what lies after the run's last tick.
    pub fn truncate(&mut self, run: &Run) {
        self.samples.retain(|sample| sample.tick <= run.ticks());
    }

    /// The samples up to a time in s.
    #[must_use]
    pub fn until(&self, time_s: f64) -> &[LearningSample] {
        /// Room for the rounding of times, s.
        const HAIR_S: f64 = 1e-9;
        let end = self.samples.partition_point(|sample| sample.time_s <= time_s + HAIR_S);
        &self.samples[..end]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::cut::Cut;
    use crate::base::settings::Value;
    use crate::run::edits::{Edit, Edits};
    use crate::run::presets::load;
    use crate::run::scenario::Scenario;

    /// A quick cut that the networks learn in.
    fn scenario(period_ms: f64) -> Scenario {
        let mut scenario = load("table3-5-noise").unwrap();
        scenario.set("controller.kind", Value::Text("unks".to_owned())).unwrap();
        scenario.set("run.control_period_ms", Value::Float(period_ms)).unwrap();
        scenario
    }

    fn history(cut: &Cut) -> Vec<LearningSample> {
        cut.learning().until(f64::INFINITY).to_vec()
    }

    #[test]
    fn slices_and_branches_leave_the_same_samples() {
        let scenario = scenario(20.0);
        let mut whole = Cut::new(&scenario, &Edits::none());
        whole.advance(u64::MAX);
        let samples = history(&whole);
        assert!(samples.len() > 500 && samples.len() <= MAX_SAMPLES, "{}", samples.len());
        assert_ne!(samples[0].weights, samples[samples.len() - 1].weights);
        let mut sliced = Cut::new(&scenario, &Edits::none());
        while !sliced.is_over() {
            sliced.advance(777);
        }
        assert_eq!(history(&sliced), samples);
        // A change and its taking back: the run is repeated from the middle.
        let mut edits = Edits::none();
        let path = "controller.unks.inverse_rate".to_owned();
        edits.push(&scenario, Edit { at_s: 5.0, path, value: Value::Float(0.0) }).unwrap();
        sliced.change(&scenario, &edits);
        sliced.advance(u64::MAX);
        let changed = history(&sliced);
        assert_ne!(changed, samples);
        let before = |samples: &[LearningSample]| {
            samples.iter().filter(|sample| sample.time_s <= 5.0).cloned().collect::<Vec<_>>()
        };
        assert_eq!(before(&changed), before(&samples));
        sliced.change(&scenario, &Edits::none());
        sliced.advance(u64::MAX);
        assert_eq!(history(&sliced), samples);
    }

    #[test]
    fn long_runs_keep_a_bounded_number_and_the_playhead_sees_no_future() {
        let mut cut = Cut::new(&scenario(1.0), &Edits::none());
        cut.advance(u64::MAX);
        let samples = history(&cut);
        assert!((MAX_SAMPLES / 2..=MAX_SAMPLES).contains(&samples.len()), "{}", samples.len());
        let seen = cut.learning().until(3.0);
        assert!(seen.last().is_some_and(|last| last.time_s <= 3.0 && last.time_s > 2.9));
        let mut other = scenario(20.0);
        other.set("controller.kind", Value::Text("sdnrp".to_owned())).unwrap();
        let mut cut = Cut::new(&other, &Edits::none());
        cut.advance(u64::MAX);
        assert!(history(&cut).is_empty());
    }
}
