//! What is worked out over the tool's life, in slices beside the picture: the trends, and one tool
//! whose life is predicted; and the life predicted from the cut in the console.

use crate::app::session::Session;
use crate::models::machine_trend::{MachineTrend, TrendPoint};
use crate::models::wear::WearModel;
use crate::run::job::Job;
use crate::run::scenario::Scenario;
use crate::study::machine_life::adaptive::AdaptiveLife;
use crate::study::machine_life::measurement::measure;
use crate::study::machine_life::tool_condition::{ConditionEstimate, predictions};
use crate::study::machine_life::{LifeFindings, LifeJob, model};

/// Points of time that one frame may cost, and minutes of the tool whose life is predicted: some
/// milliseconds each.
const POINTS_PER_FRAME: u64 = 300;
const MINUTES_PER_FRAME: u64 = 12;

/// The jobs of one scenario.
pub struct Life {
    /// What they depend on.
    key: Key,
    /// The trends.
    pub trends: LifeJob,
    /// Sound and roughness of the sharp tool, and at the end of its life.
    pub ends: [TrendPoint; 2],
    /// What the trends show, once they are done.
    pub findings: Option<LifeFindings>,
    /// Correlations of a virtual measurement with the calculation: trend and spectrum.
    pub measured_r: [Option<f64>; 2],
    /// The tool whose life is predicted.
    pub tool: AdaptiveLife,
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
    /// The jobs of a scenario, not yet begun; `adjusts` adjusts the speed to the desired tool life.
    #[must_use]
    pub fn new(scenario: &Scenario, adjusts: bool) -> Self {
        let key = Key::new(scenario, adjusts);
        Self {
            trends: LifeJob::of(scenario),
            ends: [0.0, 1.0].map(|x| key.model.at(x)),
            findings: None,
            measured_r: [None; 2],
            tool: AdaptiveLife::new(scenario, adjusts),
            tool_done: false,
            key,
        }
    }

    /// Follows the scenario: starts again what a change has made wrong, and continues the
    /// rest by a slice. `true` while there is more to do.
    pub fn follow(&mut self, scenario: &Scenario, adjusts: bool) -> bool {
        let key = Key::new(scenario, adjusts);
        if key.model != self.key.model || key.seed != self.key.seed {
            *self = Self::new(scenario, adjusts);
        } else if key != self.key {
            (self.tool, self.tool_done) = (AdaptiveLife::new(scenario, adjusts), false);
            self.key = key;
        }
        if self.findings.is_none() && self.trends.advance_by(POINTS_PER_FRAME) {
            self.findings = self.trends.findings();
            if let Some(findings) = &self.findings {
                let seed = u64::from(scenario.run.seed);
                let spectrum = &findings.first_spectrum;
                let measured = measure(self.trends.points(), spectrum, &scenario.life, seed);
                self.measured_r = [measured.trend_r, measured.spectrum_r];
            }
        }
        if !self.tool_done {
            let before = self.tool.minutes().len();
            let over = self.tool.advance_by(MINUTES_PER_FRAME);
            // One that outlives every wish is given up: it grows no more.
            self.tool_done = over || self.tool.minutes().len() == before;
        }
        !self.tool_done || self.findings.is_none()
    }

    /// The machine in its cut.
    #[must_use]
    pub fn model(&self) -> &MachineTrend {
        self.trends.model()
    }

    /// Fraction of the trends that is done.
    #[must_use]
    pub fn progress(&self) -> f64 {
        self.trends.progress().share()
    }
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
        let mut life = Life::new(&scenario, false);
        let mut frames = 0;
        while life.follow(&scenario, false) {
            frames += 1;
            assert!(frames < 1000);
        }
        assert!(life.findings.is_some() && life.tool.end_min().is_some());
        assert!(life.follow(&scenario, true) && life.findings.is_some());
        scenario.change(|s| s.life.random_ratio = 0.1).unwrap();
        assert!(life.follow(&scenario, true) && life.findings.is_none());
        // What the machine does not depend on changes nothing.
        let done = life.trends.progress().done;
        scenario.change(|s| s.target.ra_um = 0.5).unwrap();
        life.follow(&scenario, true);
        assert!(life.trends.progress().done > done);
    }
}
