//! The plan that the screen shows: the swarm on its way, and the map that it flies over. Both are
//! made again when something changes that they depend on, and only then. The search itself is a job of
//! the console; the screen shows its stages one after the other, slow enough to be watched.

use std::sync::Arc;

use crate::app::jobs::{Jobs, Work};
use crate::app::playback::Speed;
use crate::base::language::text;
use crate::base::settings::SettingError;
use crate::blocks::control::Belief;
use crate::blocks::cutting::process::PlantSettings;
use crate::blocks::cutting::workpiece::Workpiece;
use crate::blocks::reference::Target;
use crate::models::plan::PlanSettings;
use crate::models::tool::Tool;
use crate::run::scenario::Scenario;
use crate::study::plan::PlanJob;
use crate::study::plan::flight::{Flight, Flown, Stage};
use crate::study::plan::machine::MachineLimits;
use crate::study::plan::optimum::Optimum;
use crate::study::plan::over_depths::{CutInRun, OverDepths};
use crate::study::plan::problem::Problem;
use crate::study::plan::swarm::Iteration;

use super::picture::Picture;

/// Real time of one iteration of the swarm at natural speed, s: slow enough to be watched.
const ITERATION_S: f64 = 0.06;
/// Places of the map that are kept as the run cuts them: the one under the pointer and the pinned one.
const PLACES: usize = 2;
/// Iterations in the first slice of the search.
const FIRST: u64 = 8;
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
    /// How far the machine goes: largest feed in mm/min, least and largest speed in 1/min.
    machine: [f64; 3],
}

impl Key {
    fn of(scenario: &Scenario) -> Self {
        let cnc = &scenario.cnc;
        Self {
            plan: scenario.plan.clone(),
            plant: scenario.plant.clone(),
            tool: scenario.tool.clone(),
            workpiece: scenario.workpiece.clone(),
            target: scenario.target.clone(),
            belief: scenario.belief.clone(),
            machine: [cnc.feed_max_mm_min, cnc.speed_min_rpm, cnc.speed_max_rpm],
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
    /// What is optimised.
    pub problem: Problem,
    /// The map.
    pub picture: Picture,
    /// The search, which goes on when the screen is left.
    work: Work<Flight>,
    /// As far as it has come, and whether it went on then.
    latest: Arc<Flown>,
    running: bool,
    /// The stage that is shown.
    at: usize,
    /// The best cut at that stage.
    optimum: Optimum,
    /// It at all depths of the part, and of which scenario that is, once the search is over.
    over: Option<(Scenario, OverDepths)>,
    /// Places of the map as the run cuts them, those asked for last, and of which scenario they are.
    in_run: Vec<(Scenario, [f64; 2], Option<CutInRun>)>,
}

impl Found {
    fn new(plan: PlanJob, old: Option<Picture>, jobs: &Jobs) -> Self {
        let problem = plan.problem().clone();
        let optimum = plan.optimum();
        let work = jobs.begin(text!("Plan: search of the swarm"), Flight::new(plan), FIRST);
        let picture = old.unwrap_or_else(|| Picture::new(&problem));
        Self {
            latest: work.partial(),
            running: true,
            problem,
            picture,
            work,
            at: 0,
            optimum,
            over: None,
            in_run: Vec::new(),
        }
    }

    /// The cutting speed in m/min where it is not searched.
    #[must_use]
    pub fn fixed_speed_m_min(&self) -> Option<f64> {
        let [low, high] = self.problem.range()[0];
        (low == high).then_some(low)
    }

    /// The stage that is shown.
    #[must_use]
    pub fn stage(&self) -> &Stage {
        &self.latest.stages[self.at]
    }

    /// The best cut up to there.
    #[must_use]
    pub fn optimum(&self) -> &Optimum {
        &self.optimum
    }

    /// It at all depths of the part, once the search is over.
    #[must_use]
    pub fn over_depths(&self) -> Option<&OverDepths> {
        self.over.as_ref().map(|(_, over)| over)
    }

    /// Finds that, once for each answer and scenario: it takes short cuts.
    fn judge_depths(&mut self, scenario: &Scenario) {
        if !self.stage().counts.done {
            self.over = None;
        } else if self.over.as_ref().is_none_or(|(of, _)| of != scenario) {
            let machine = MachineLimits::heller_bea_01();
            let over = OverDepths::of(scenario, &machine, &self.optimum);
            self.over = Some((scenario.clone(), over));
        }
    }

    /// The cut at a place of the map, cutting speed in m/min and feed per tooth in mm, as the run makes it; found
    /// once for each place that stays under the pointer or pinned: it takes a short cut.
    pub fn in_run(&mut self, scenario: &Scenario, point: [f64; 2]) -> Option<CutInRun> {
        let known = self.in_run.iter().find(|(of, place, _)| *place == point && of == scenario);
        if let Some((_, _, cut)) = known {
            return *cut;
        }
        let cut = CutInRun::at(scenario, &self.problem, point);
        self.in_run.truncate(PLACES - 1);
        self.in_run.insert(0, (scenario.clone(), point, cut));
        cut
    }

    /// Convergence up to there.
    #[must_use]
    pub fn history(&self) -> &[Iteration] {
        &self.latest.history[..=self.at]
    }

    /// Whether more is known than is shown.
    #[must_use]
    pub fn has_more(&self) -> bool {
        self.at < self.last()
    }

    /// Whether the search was stopped before its end.
    #[must_use]
    pub fn is_stopped(&self) -> bool {
        !self.work.is_running() && !self.work.is_over()
    }

    /// The last stage that is known.
    fn last(&self) -> usize {
        self.latest.stages.len() - 1
    }

    fn show(&mut self, at: usize) {
        let at = at.min(self.last());
        if at != self.at {
            self.at = at;
            self.optimum = Optimum::at(&self.problem, self.stage().best);
        }
    }
}

/// See the head of this file.
pub struct Search {
    key: Option<Key>,
    /// The plan, or why there is none.
    found: Option<Result<Found, SettingError>>,
    /// Whether the swarm moves.
    playing: bool,
    /// How fast it moves.
    pub speed: Speed,
    /// Whether all that is known is shown, whatever its speed.
    rushing: bool,
    /// Whether another screen was shown.
    away: bool,
    since_s: f64,
}

impl Default for Search {
    fn default() -> Self {
        Self {
            key: None,
            found: None,
            playing: true,
            speed: Speed::Times(1.0),
            rushing: false,
            away: false,
            since_s: 0.0,
        }
    }
}

impl Search {
    /// Starts again if a setting that matters here has changed; otherwise takes over what the search has
    /// found meanwhile.
    pub fn follow(&mut self, scenario: &Scenario, jobs: &Jobs) {
        let key = Key::of(scenario);
        if self.key.as_ref() != Some(&key) {
            let map_stays = self.key.as_ref().is_some_and(|old| old.of_map() == key.of_map());
            let picture = match self.found.take() {
                Some(Ok(old)) if map_stays => Some(old.picture),
                _ => None,
            };
            self.found = Some(PlanJob::new(scenario).map(|plan| Found::new(plan, picture, jobs)));
            self.key = Some(key);
            (self.rushing, self.since_s) = (false, 0.0);
            self.playing = matches!(self.found, Some(Ok(_)));
        } else if let Some(Ok(found)) = &mut self.found {
            // In this order: at rest nothing comes after what is read then.
            found.running = found.work.is_running();
            found.latest = found.work.partial();
            found.judge_depths(scenario);
        }
    }

    /// The plan, or why there is none; nothing before the first [`Self::follow`].
    pub fn found(&mut self) -> Option<Result<&mut Found, &SettingError>> {
        self.found.as_mut().map(|found| found.as_mut().map_err(|error| &*error))
    }

    /// Whether the swarm moves.
    #[must_use]
    pub fn is_playing(&self) -> bool {
        self.playing
    }

    /// Shows what comes in `dt_s` seconds of real time, as far as it is known.
    pub fn advance(&mut self, dt_s: f64) {
        let away = std::mem::take(&mut self.away);
        let Some(Ok(found)) = &mut self.found else { return };
        if !self.playing {
            return;
        }
        match self.speed {
            Speed::Times(factor) if !self.rushing && !away => {
                self.since_s += dt_s * factor;
                let due = (self.since_s / ITERATION_S).floor();
                if due > 0.0 {
                    self.since_s -= due * ITERATION_S;
                    found.show(found.at + due as usize);
                }
            }
            Speed::Times(_) | Speed::Max => found.show(found.last()),
        }
        if !found.has_more() && !found.running {
            self.pause();
        }
    }

    /// Another screen is shown: the swarm flies on meanwhile.
    pub fn leave(&mut self) {
        self.away = true;
    }

    /// Moves on from where it is, and searches on where it was stopped; at the end once more from the start.
    pub fn play(&mut self) {
        let Some(Ok(found)) = &mut self.found else { return };
        if found.stage().counts.done {
            found.show(0);
        }
        found.work.go_on();
        found.running = true;
        self.playing = true;
    }

    /// Shows the way once more from the random start.
    pub fn again(&mut self) {
        if let Some(Ok(found)) = &mut self.found {
            found.show(0);
        }
        (self.rushing, self.since_s) = (false, 0.0);
        self.play();
    }

    /// On to the end, as fast as it is found.
    pub fn rush(&mut self) {
        self.play();
        self.rushing = true;
    }

    /// One iteration on, and no further.
    pub fn step(&mut self) {
        if let Some(Ok(found)) = &mut self.found {
            found.show(found.at + 1);
        }
        self.pause();
    }

    /// Stands still where it is; the search goes on to be ready.
    pub fn pause(&mut self) {
        (self.playing, self.rushing, self.since_s) = (false, false, 0.0);
    }

    /// Where the particles are drawn: on their way between two iterations.
    #[must_use]
    pub fn positions(&self) -> Vec<[f64; 2]> {
        let Some(Ok(found)) = &self.found else { return Vec::new() };
        let share = if self.playing { (self.since_s / ITERATION_S).min(1.0) } else { 1.0 };
        let between = |(from, to): (&[f64; 2], &[f64; 2])| {
            [0, 1].map(|d: usize| from[d] + share * (to[d] - from[d]))
        };
        let before = &found.latest.stages[found.at.saturating_sub(1)];
        before.positions.iter().zip(&found.stage().positions).map(between).collect()
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
    fn slices_threads_and_speeds_lead_to_the_same_optimum() {
        let scenario = Scenario::default();
        let whole = PlanJob::complete(&scenario).unwrap();
        for (speed, in_slices) in SPEEDS.into_iter().zip([true, false, true, false]) {
            let jobs = Jobs::default();
            if in_slices {
                jobs.work_in_slices();
            }
            let mut search = Search { speed, ..Search::default() };
            for _ in 0..100_000 {
                jobs.pump(&egui::Context::default());
                search.follow(&scenario, &jobs);
                search.advance(0.016);
                if !search.playing {
                    break;
                }
            }
            assert!(!search.playing, "{}", speed.label());
            let Some(Ok(found)) = search.found() else { panic!("a plan") };
            assert_eq!(*found.optimum(), whole.optimum(), "{}", speed.label());
            assert_eq!(found.history(), whole.history());
        }
    }

    #[test]
    fn the_search_goes_on_while_another_screen_is_shown() {
        let scenario = Scenario::default();
        let jobs = Jobs::default();
        jobs.work_in_slices();
        let mut search = Search::default();
        search.follow(&scenario, &jobs);
        search.leave();
        (0..200).for_each(|_| jobs.pump(&egui::Context::default()));
        search.follow(&scenario, &jobs);
        search.advance(0.016);
        let Some(Ok(found)) = search.found() else { panic!("a plan") };
        assert!(found.stage().counts.done, "nothing was begun again");
        assert_eq!(*found.optimum(), PlanJob::complete(&scenario).unwrap().optimum());
    }

    #[test]
    fn a_stopped_search_stands_and_goes_on_when_it_is_played() {
        let scenario = Scenario::default();
        let jobs = Jobs::default();
        jobs.work_in_slices();
        let mut search = Search { speed: Speed::Max, ..Search::default() };
        search.follow(&scenario, &jobs);
        let Some(Ok(found)) = search.found() else { panic!("a plan") };
        found.work.stop();
        search.follow(&scenario, &jobs);
        search.advance(0.016);
        assert!(!search.playing);
        let Some(Ok(found)) = search.found() else { panic!("a plan") };
        assert!(found.is_stopped() && found.stage().counts.iteration == 0);
        search.play();
        for _ in 0..200 {
            jobs.pump(&egui::Context::default());
            search.follow(&scenario, &jobs);
            search.advance(0.016);
        }
        let Some(Ok(found)) = search.found() else { panic!("a plan") };
        assert!(found.stage().counts.done && !found.is_stopped());
    }
}
