//! A plan with the way of its swarm: the search is worked out as fast as it goes, and a front end shows
//! it at its own pace.

use std::sync::Arc;

use super::swarm::Iteration;
use super::{PlanCounts, PlanJob};
use crate::run::job::{Budget, Job, Progress};

/// The swarm after one iteration; places are cutting speed in m/min and feed per tooth in mm.
#[derive(Clone, Debug, PartialEq)]
pub struct Stage {
    /// Where the particles are.
    pub positions: Vec<[f64; 2]>,
    /// The best place that each of them has been to.
    pub own_bests: Vec<[f64; 2]>,
    /// The best place of all.
    pub best: [f64; 2],
    /// What the plan has taken up to here.
    pub counts: PlanCounts,
}

impl Stage {
    fn of(plan: &PlanJob) -> Arc<Self> {
        let particles = plan.particles();
        Arc::new(Self {
            positions: particles.iter().map(|particle| particle.position).collect(),
            own_bests: particles.iter().map(|particle| particle.best_position).collect(),
            best: plan.swarm().best().0,
            counts: plan.counts(),
        })
    }
}

/// The way so far.
#[derive(Clone, Debug, PartialEq)]
pub struct Flown {
    /// The swarm at its random start, and after every iteration since.
    pub stages: Vec<Arc<Stage>>,
    /// Convergence, one for every stage.
    pub history: Vec<Iteration>,
}

/// A plan on its way that keeps the stages of its swarm.
#[derive(Clone, Debug)]
pub struct Flight {
    plan: PlanJob,
    stages: Vec<Arc<Stage>>,
}

impl Flight {
    /// The flight of a plan at its random start.
    #[must_use]
    pub fn new(plan: PlanJob) -> Self {
        Self { stages: vec![Stage::of(&plan)], plan }
    }
}

/// A step is an iteration of the swarm.
impl Job for Flight {
    type Partial = Flown;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        while !self.plan.counts().done && budget.step() {
            self.plan.advance_by(1);
            self.stages.push(Stage::of(&self.plan));
        }
        self.plan.counts().done
    }

    fn progress(&self) -> Progress {
        self.plan.progress()
    }

    fn partial(&self) -> Flown {
        Flown { stages: self.stages.clone(), history: self.plan.history().to_vec() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::run::scenario::Scenario;

    #[test]
    fn every_stage_is_that_of_the_plan() {
        let mut plan = PlanJob::new(&Scenario::default()).unwrap();
        let mut flight = Flight::new(plan.clone());
        flight.to_end();
        let flown = flight.partial();
        assert_eq!(flown.stages.len(), flown.history.len());
        for (stage, iteration) in flown.stages.iter().zip(&flown.history) {
            assert_eq!(**stage, *Stage::of(&plan));
            assert_eq!(Some(iteration), plan.history().last());
            plan.advance_by(1);
        }
        assert!(flown.stages.last().unwrap().counts.done);
        assert!(flown.stages.iter().rev().skip(1).all(|stage| !stage.counts.done));
    }
}
