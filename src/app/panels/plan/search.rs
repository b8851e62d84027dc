//! The plan that the screen shows: the swarm on its way, and the map that it flies over. Both are
//! made again when something changes that they depend on, and only then.

use crate::app::playback::Speed;
use crate::base::settings::SettingError;
use crate::blocks::control::Belief;
use crate::blocks::cutting::process::PlantSettings;
use crate::blocks::cutting::workpiece::Workpiece;
use crate::blocks::reference::Target;
use crate::models::plan::PlanSettings;
use crate::models::tool::Tool;
use crate::run::job::Job;
use crate::run::scenario::Scenario;
use crate::study::plan::PlanJob;

use super::picture::Picture;

/// Real time of one iteration of the swarm at natural speed, s: slow enough to be watched.
const ITERATION_S: f64 = 0.06;
/// Evaluations of the force surface that one frame may cost: some milliseconds.
const EVALUATIONS_PER_FRAME: u32 = 6000;
/// The speeds on offer.
pub const SPEEDS: [Speed; 4] =
    [Speed::Times(0.2), Speed::Times(1.0), Speed::Times(5.0), Speed::Max];

/// All that a plan depends on.
#[derive(Clone, PartialEq)]
struct Key {
    plan: PlanSettings,
    plant: PlantSettings,
    tool: Tool,
    workpiece: Workpiece,
    target: Target,
    belief: Belief,
}

impl Key {
    fn of(scenario: &Scenario) -> Self {
        Self {
            plan: scenario.plan.clone(),
            plant: scenario.plant.clone(),
            tool: scenario.tool.clone(),
            workpiece: scenario.workpiece.clone(),
            target: scenario.target.clone(),
            belief: scenario.belief.clone(),
        }
    }

    /// The same with the swarm's own settings left out, which do not change the map.
    fn of_map(&self) -> Self {
        let mut map = self.clone();
        let usual = PlanSettings::default();
        map.plan.particles = usual.particles;
        map.plan.iterations = usual.iterations;
        map.plan.stop_after = usual.stop_after;
        map.plan.seed = usual.seed;
        map
    }
}

/// A plan with its map.
pub struct Found {
    /// The swarm.
    pub job: PlanJob,
    /// The map.
    pub picture: Picture,
    /// Where the particles were an iteration ago.
    before: Vec<[f64; 2]>,
}

impl Found {
    /// The cutting speed in m/min where it is not searched.
    #[must_use]
    pub fn fixed_speed_m_min(&self) -> Option<f64> {
        let [low, high] = self.job.problem().range()[0];
        (low == high).then_some(low)
    }

    fn iterate(&mut self, iterations: u32) {
        self.before = self.job.particles().iter().map(|particle| particle.position).collect();
        self.job.advance_by(iterations.into());
    }
}

/// See the head of this file.
pub struct Search {
    key: Option<Key>,
    /// The plan, or why there is none.
    found: Option<Result<Found, SettingError>>,
    /// Whether the swarm moves.
    pub playing: bool,
    /// How fast it moves.
    pub speed: Speed,
    /// Whether it hurries to its end whatever its speed.
    rushing: bool,
    since_s: f64,
}

impl Default for Search {
    fn default() -> Self {
        let speed = Speed::Times(1.0);
        Self { key: None, found: None, playing: true, speed, rushing: false, since_s: 0.0 }
    }
}

impl Search {
    /// Starts again if a setting that matters here has changed.
    pub fn follow(&mut self, scenario: &Scenario) {
        let key = Key::of(scenario);
        if self.key.as_ref() != Some(&key) {
            let map_stays = self.key.as_ref().is_some_and(|old| old.of_map() == key.of_map());
            self.key = Some(key);
            self.begin(scenario, map_stays);
        }
    }

    /// Begins again: the swarm at its random start.
    pub fn again(&mut self, scenario: &Scenario) {
        self.begin(scenario, true);
    }

    fn begin(&mut self, scenario: &Scenario, map_stays: bool) {
        (self.rushing, self.since_s) = (false, 0.0);
        let old = self.found.take();
        self.found = Some(PlanJob::new(scenario).map(|job| {
            let picture = match old {
                Some(Ok(old)) if map_stays => old.picture,
                _ => Picture::new(job.problem()),
            };
            let before = job.particles().iter().map(|particle| particle.position).collect();
            Found { job, picture, before }
        }));
        self.playing = matches!(self.found, Some(Ok(_)));
    }

    /// The plan, or why there is none; nothing before the first [`Self::follow`].
    pub fn found(&mut self) -> Option<Result<&mut Found, &SettingError>> {
        self.found.as_mut().map(|found| found.as_mut().map_err(|error| &*error))
    }

    /// Advances by `dt_s` seconds of real time, with some milliseconds of work at most.
    pub fn advance(&mut self, dt_s: f64) {
        let Some(Ok(found)) = &mut self.found else { return };
        if !self.playing {
            return;
        }
        let most = (EVALUATIONS_PER_FRAME / found.job.particles().len() as u32).max(1);
        match self.speed {
            Speed::Times(factor) if !self.rushing => {
                self.since_s += dt_s * factor;
                let due = (self.since_s / ITERATION_S).floor();
                self.since_s -= due * ITERATION_S;
                if due > 0.0 {
                    found.iterate((due as u32).min(most));
                }
            }
            Speed::Times(_) | Speed::Max => found.iterate(most),
        }
        if found.job.counts().done {
            self.stop();
        }
    }

    /// On to the end, each frame as many iterations as its time allows.
    pub fn rush(&mut self) {
        (self.playing, self.rushing) = (true, true);
    }

    /// One iteration on, and no further.
    pub fn step(&mut self) {
        if let Some(Ok(found)) = &mut self.found {
            found.iterate(1);
        }
        self.stop();
    }

    /// Stands still where it is.
    pub fn stop(&mut self) {
        (self.playing, self.rushing, self.since_s) = (false, false, 0.0);
    }

    /// Where the particles are drawn: on their way between two iterations.
    #[must_use]
    pub fn positions(&self) -> Vec<[f64; 2]> {
        let Some(Ok(found)) = &self.found else { return Vec::new() };
        let share = if self.playing { self.since_s / ITERATION_S } else { 1.0 };
        let between = |(from, to): (&[f64; 2], [f64; 2])| {
            [0, 1].map(|d: usize| from[d] + share * (to[d] - from[d]))
        };
        let now = found.job.particles().iter().map(|particle| particle.position);
        found.before.iter().zip(now).map(between).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::settings::{Kind, Value};
    use crate::run::scenario::table;

    #[test]
    fn what_the_key_leaves_out_does_not_change_the_plan() {
        let scenario = Scenario::default();
        let job = PlanJob::new(&scenario).unwrap();
        let mut tried = 0;
        for param in table() {
            let allowed = &param.spec.allowed;
            let (least, largest) = if let Kind::Float { min, max } = allowed {
                (Value::Float(*min), Value::Float(*max))
            } else if let Kind::Int { min, max } = allowed {
                (Value::Int(*min), Value::Int(*max))
            } else if matches!(allowed, Kind::Bool) {
                (Value::Bool(false), Value::Bool(true))
            } else {
                continue;
            };
            for value in [least, largest] {
                let mut other = scenario.clone();
                if other.set(&param.path, value).is_err() || Key::of(&other) != Key::of(&scenario) {
                    continue;
                }
                tried += 1;
                let other = PlanJob::new(&other).unwrap();
                assert_eq!(job.particles(), other.particles(), "{}", param.path);
            }
        }
        assert!(tried > 40, "{tried}");
    }

    #[test]
    fn slices_and_speeds_lead_to_the_same_optimum() {
        let scenario = Scenario::default();
        let whole = PlanJob::complete(&scenario).unwrap().optimum();
        for speed in SPEEDS {
            let mut search = Search { speed, ..Search::default() };
            search.follow(&scenario);
            for _ in 0..10_000 {
                search.advance(0.016);
            }
            assert!(!search.playing, "{}", speed.label());
            let Some(Ok(found)) = search.found() else { panic!("a plan") };
            assert_eq!(found.job.optimum(), whole, "{}", speed.label());
        }
    }
}
