//! A run with the min-max pyramids of its signals, what its networks learned and what happens in it,
//! kept in step.

use super::history::LearningHistory;
use super::trace::Traces;
use crate::run::edits::Edits;
use crate::run::metrics::Counting;
use crate::run::one_run::Run;
use crate::run::scenario::Scenario;
use crate::run::story::Scan;

/// A run and what is drawn of it.
#[derive(Clone, Debug)]
pub struct Cut {
    run: Run,
    traces: Traces,
    learning: LearningHistory,
    scan: Scan,
    counting: Counting,
}

/// What a run was before a change: drawn from the change on.
#[derive(Clone, Debug)]
pub struct Ghost {
    /// Time of the change, s.
    pub from_s: f64,
    /// Its signals.
    pub traces: Traces,
}

impl Cut {
    /// A run at its first tick.
    #[must_use]
    pub fn new(scenario: &Scenario, edits: &Edits) -> Self {
        let run = Run::new(scenario, edits);
        let traces = Traces::new(run.recording().row_s());
        let learning = LearningHistory::new(&run);
        let mut cut =
            Self { run, traces, learning, scan: Scan::default(), counting: Counting::default() };
        cut.advance(0);
        cut
    }

    /// Takes over a changed scenario or changed edits; what lies before the change is kept.
    pub fn change(&mut self, scenario: &Scenario, edits: &Edits) {
        if self.run.scenario() != scenario {
            *self = Self::new(scenario, edits);
        } else if let Some(from_s) = first_difference(self.run.edits(), edits) {
            self.run.branch(from_s, edits);
            let kept = self.run.recording().rows().len();
            self.traces.truncate(kept);
            self.scan.truncate(kept);
            self.counting.forget();
            self.learning.truncate(&self.run);
            self.advance(0);
        }
    }

    /// Simulates at most `ticks` steps more.
    pub fn advance(&mut self, ticks: u64) {
        let mut left = ticks;
        while left > 0 && !self.is_over() {
            let slice = self.learning.due(&self.run).min(left);
            self.run.advance(slice);
            self.learning.note(&self.run);
            left -= slice;
        }
        self.traces.extend(self.run.recording().rows());
        self.scan.extend(self.run.recording().rows());
    }

    /// The run.
    #[must_use]
    pub fn run(&self) -> &Run {
        &self.run
    }

    /// What is drawn of it.
    #[must_use]
    pub fn traces(&self) -> &Traces {
        &self.traces
    }

    /// What happens in it, as its story is told from.
    #[must_use]
    pub fn scan(&self) -> &Scan {
        &self.scan
    }

    /// The run, with what its metrics are counted on from.
    pub fn counted(&mut self) -> (&Run, &mut Counting) {
        (&self.run, &mut self.counting)
    }

    /// What its networks learned.
    #[must_use]
    pub fn learning(&self) -> &LearningHistory {
        &self.learning
    }

    /// Whether it is simulated to its end.
    #[must_use]
    pub fn is_over(&self) -> bool {
        self.run.end().is_some()
    }

    /// Up to where it is simulated, s.
    #[must_use]
    pub fn simulated_s(&self) -> f64 {
        self.run.recording().rows().last().map_or(0.0, |row| row.time_s)
    }
}

/// The time from which two lists of edits differ, if they do.
#[must_use]
pub fn first_difference(a: &Edits, b: &Edits) -> Option<f64> {
    let (a, b) = (a.list(), b.list());
    let same = a.iter().zip(b).take_while(|(a, b)| a == b).count();
    let times = [a.get(same), b.get(same)].into_iter().flatten().map(|edit| edit.at_s);
    times.reduce(f64::min)
}
