//! What is worked out over the tool's life, as jobs beside the picture: the trends, and one tool
//! whose life is predicted; and the life predicted from the cut in the console.

use std::sync::Arc;

use crate::app::jobs::{Jobs, Work};
use crate::app::session::Session;
use crate::base::language::text;
use crate::models::machine_trend::{MachineTrend, TrendPoint};
use crate::models::wear::WearModel;
use crate::run::scenario::Scenario;
use crate::study::machine_life::adaptive::{AdaptiveLife, AdaptiveSoFar};
use crate::study::machine_life::measurement::measure;
use crate::study::machine_life::tool_condition::{ConditionEstimate, predictions};
use crate::study::machine_life::{LifeFindings, LifeJob, LifeSoFar, model};

/// Points of time, and minutes of the tool whose life is predicted, in the first slice.
const FIRST_POINTS: u64 = 300;
const FIRST_MINUTES: u64 = 12;

/// The jobs of one scenario.
pub struct Life {
    /// What they depend on.
    key: Key,
    work: Work<LifeJob>,
    tool_work: Work<AdaptiveLife>,
    /// The trends, and what they show once they are done.
    pub trends: Arc<LifeSoFar>,
    /// Sound and roughness of the sharp tool, and at the end of its life.
    pub ends: [TrendPoint; 2],
    /// Correlations of a virtual measurement with the calculation, trend and spectrum, once the trends are
    /// done.
    measured_r: Option<[Option<f64>; 2]>,
    /// The tool whose life is predicted.
    pub tool: Arc<AdaptiveSoFar>,
    /// Whether its life is over, or given up.
    pub tool_done: bool,
}

#[derive(Clone, Debug, PartialEq)]
struct Key {
    model: MachineTrend,
    seed: u32,
    adjusts: bool,
}

impl Key {
    fn new(scenario: &Scenario, adjusts: bool) -> Self {
        Self { model: model(scenario), seed: scenario.run.seed, adjusts }
    }
}

impl Life {
    /// The jobs of a scenario, begun; `adjusts` adjusts the speed to the desired tool life.
    #[must_use]
    pub fn new(scenario: &Scenario, adjusts: bool, jobs: &Jobs) -> Self {
        let key = Key::new(scenario, adjusts);
        let work =
            jobs.begin(text!("Trends over the tool life"), LifeJob::of(scenario), FIRST_POINTS);
        let tool_work = begin_tool(scenario, adjusts, jobs);
        Self {
            trends: work.partial(),
            ends: [0.0, 1.0].map(|x| key.model.at(x)),
            measured_r: None,
            tool: tool_work.partial(),
            tool_done: false,
            work,
            tool_work,
            key,
        }
    }

    /// Follows the scenario: starts again what a change has made wrong.
    pub fn follow(&mut self, scenario: &Scenario, adjusts: bool, jobs: &Jobs) {
        let key = Key::new(scenario, adjusts);
        if key.model != self.key.model || key.seed != self.key.seed {
            *self = Self::new(scenario, adjusts, jobs);
        } else if key != self.key {
            self.tool_work = begin_tool(scenario, adjusts, jobs);
            self.key = key;
        }
        self.trends = self.work.partial();
        (self.tool_done, self.tool) = (self.tool_work.is_over(), self.tool_work.partial());
        if self.measured_r.is_none()
            && let Some(findings) = &self.trends.findings
        {
            let seed = u64::from(scenario.run.seed);
            let (points, spectrum) = (&self.trends.points, &findings.first_spectrum);
            let measured = measure(points, spectrum, &scenario.life, seed);
            self.measured_r = Some([measured.trend_r, measured.spectrum_r]);
        }
    }

    /// Whether something of it was stopped before its end.
    #[must_use]
    pub fn is_stopped(&self) -> bool {
        let rests = |running: bool, over: bool| !running && !over;
        rests(self.work.is_running(), self.work.is_over())
            || rests(self.tool_work.is_running(), self.tool_work.is_over())
    }

    /// Goes on with what was stopped.
    pub fn go_on(&self) {
        self.work.go_on();
        self.tool_work.go_on();
    }

    /// The machine in its cut.
    #[must_use]
    pub fn model(&self) -> &MachineTrend {
        &self.key.model
    }

    /// What the trends show, once they are done.
    #[must_use]
    pub fn findings(&self) -> Option<&LifeFindings> {
        self.trends.findings.as_ref()
    }

    /// Correlations of a virtual measurement with the calculation: trend and spectrum.
    #[must_use]
    pub fn measured_r(&self) -> [Option<f64>; 2] {
        self.measured_r.unwrap_or_default()
    }

    /// Fraction of the trends that is done.
    #[must_use]
    pub fn progress(&self) -> f64 {
        self.work.progress().share()
    }
}

fn begin_tool(scenario: &Scenario, adjusts: bool, jobs: &Jobs) -> Work<AdaptiveLife> {
    jobs.begin(text!("Life of one tool"), AdaptiveLife::new(scenario, adjusts), FIRST_MINUTES)
}

/// The life predicted from the sound of the cut in the console, up to the playhead.
#[derive(Default)]
pub struct LifeInCut {
    /// Changes and rows of the run that was evaluated.
    of: Option<(u64, usize)>,
    estimates: Vec<ConditionEstimate>,
    /// Why there is no prediction.
    pub problem: Option<String>,
}

impl LifeInCut {
    /// Whether the cut can be evaluated: the machine vibrates in it, and the tool wears.
    #[must_use]
    pub fn possible(scenario: &Scenario) -> bool {
        scenario.machine.coupled && scenario.wear.model == WearModel::Life
    }

    /// Evaluates the run once it is simulated to its end, and again when it has changed.
    pub fn follow(&mut self, session: &Session) {
        let cut = session.chosen();
        let of = (session.changes(), cut.run().recording().rows().len());
        if !Self::possible(session.scenario()) || !cut.is_over() || self.of == Some(of) {
            return;
        }
        self.of = Some(of);
        let found = predictions(session.scenario(), cut.run().recording());
        self.problem = found.as_ref().err().map(ToString::to_string);
        self.estimates = found.unwrap_or_default();
    }

    /// The estimates up to a time of the run in s.
    #[must_use]
    pub fn until(&self, time_s: f64) -> &[ConditionEstimate] {
        &self.estimates[..self.estimates.partition_point(|estimate| estimate.time_s <= time_s)]
    }

    /// Whether the run has been evaluated.
    #[must_use]
    pub fn is_ready(&self) -> bool {
        self.of.is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_change_begins_anew_only_what_depends_on_it() {
        let mut scenario = Scenario::default();
        scenario.change(|s| s.wear.taylor_life_min = 1.0).unwrap();
        let jobs = Jobs::default();
        jobs.work_in_slices();
        let mut life = Life::new(&scenario, false, &jobs);
        let finish = |life: &mut Life, scenario: &Scenario, adjusts: bool| {
            for _ in 0..1000 {
                jobs.pump(&egui::Context::default());
                life.follow(scenario, adjusts, &jobs);
                if life.tool_done && life.findings().is_some() {
                    return;
                }
            }
            panic!("{}", life.progress());
        };
        finish(&mut life, &scenario, false);
        assert!(life.tool.end_min.is_some() && life.measured_r()[0].is_some());
        life.follow(&scenario, true, &jobs);
        assert!(!life.tool_done && life.findings().is_some());
        scenario.change(|s| s.life.random_ratio = 0.1).unwrap();
        life.follow(&scenario, true, &jobs);
        assert!(life.findings().is_none() && life.progress() == 0.0);
        // What the machine does not depend on changes nothing.
        finish(&mut life, &scenario, true);
        scenario.change(|s| s.target.ra_um = 0.5).unwrap();
        life.follow(&scenario, true, &jobs);
        assert!(life.findings().is_some());
    }
}
