//! Off-line optimisation of feed and speed (2013 section 2.1): a particle swarm flies over the
//! force surface of the neural network, which seven constraints cut off, in search of the best
//! allowed cut.
//!
//! A plan is a job that a front end advances in slices; slicing changes nothing.

pub mod constraints;
pub mod contour;
pub mod cut;
pub mod field;
pub mod flight;
pub mod machine;
pub mod optimum;
pub mod over_depths;
pub mod problem;
pub mod remarks;
pub mod schedule;
pub mod score;
pub mod surface;
pub mod swarm;

use machine::MachineLimits;
use optimum::Optimum;
use problem::Problem;
use swarm::{Iteration, Particle, Swarm, SwarmSetup};

use crate::base::language::text;
use crate::base::settings::SettingError;
use crate::run::job::{Budget, Job, Progress};
use crate::run::scenario::Scenario;

/// What a plan has taken so far.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PlanCounts {
    /// Iterations done.
    pub iteration: u32,
    /// Most iterations.
    pub iterations: u32,
    /// Evaluations of the network so far.
    pub evaluations: u64,
    /// Whether it has ended.
    pub done: bool,
}

/// A plan on its way.
#[derive(Clone, Debug)]
pub struct PlanJob {
    problem: Problem,
    swarm: Swarm,
}

impl PlanJob {
    /// The plan of a scenario on the papers' machine, its swarm at the random start.
    ///
    /// # Errors
    /// See [`Problem::new`].
    pub fn new(scenario: &Scenario) -> Result<Self, SettingError> {
        Self::on(scenario, &MachineLimits::heller_bea_01())
    }

    /// The plan of a scenario on a machine.
    ///
    /// # Errors
    /// See [`Problem::new`].
    pub fn on(scenario: &Scenario, machine: &MachineLimits) -> Result<Self, SettingError> {
        let problem = Problem::new(scenario, machine)?;
        let plan = &scenario.plan;
        let [speeds, feeds] = problem.range();
        let setup = SwarmSetup {
            seed: u64::from(plan.seed),
            particles: plan.particles,
            iterations: plan.iterations,
            stop_after: plan.stop_after,
            low: [speeds[0], feeds[0]],
            high: [speeds[1], feeds[1]],
        };
        let swarm = Swarm::new(setup, |point| problem.score(point));
        Ok(Self { problem, swarm })
    }

    /// The same plan at its start, searched no further than a cutting speed in m/min and a feed per
    /// tooth in mm; where one lies below its range, at the lower end.
    #[must_use]
    pub fn at_most(self, high: [f64; 2]) -> Self {
        let mut problem = self.problem;
        problem.narrow(high);
        let setup =
            SwarmSetup { high: problem.range().map(|[_, high]| high), ..*self.swarm.setup() };
        let swarm = Swarm::new(setup, |point| problem.score(point));
        Self { problem, swarm }
    }

    /// The plan of a scenario, run to its end.
    ///
    /// ```
    /// use steadycut_core::run::presets;
    /// use steadycut_study::plan::PlanJob;
    ///
    /// let plan = PlanJob::complete(&presets::load("strategy-2013").unwrap()).unwrap();
    /// assert!(plan.optimum().feasible);
    /// ```
    ///
    /// # Errors
    /// See [`Problem::new`].
    pub fn complete(scenario: &Scenario) -> Result<Self, SettingError> {
        let mut job = Self::new(scenario)?;
        job.to_end();
        Ok(job)
    }

    /// Iterations and evaluations.
    #[must_use]
    pub fn counts(&self) -> PlanCounts {
        PlanCounts {
            iteration: self.swarm.iteration(),
            iterations: self.swarm.setup().iterations,
            evaluations: self.swarm.evaluations(),
            done: self.swarm.done(),
        }
    }

    /// What is optimised.
    #[must_use]
    pub fn problem(&self) -> &Problem {
        &self.problem
    }

    /// The swarm.
    #[must_use]
    pub fn swarm(&self) -> &Swarm {
        &self.swarm
    }

    /// The particles now; positions are cutting speed in m/min and feed per tooth in mm.
    #[must_use]
    pub fn particles(&self) -> &[Particle] {
        self.swarm.particles()
    }

    /// Convergence, the random start first.
    #[must_use]
    pub fn history(&self) -> &[Iteration] {
        self.swarm.history()
    }

    /// The best cut so far.
    #[must_use]
    pub fn optimum(&self) -> Optimum {
        Optimum::at(&self.problem, self.swarm.best().0)
    }
}

/// A step is an iteration of the swarm.
impl Job for PlanJob {
    type Partial = Optimum;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        let problem = &self.problem;
        while !self.swarm.done() && budget.step() {
            self.swarm.advance(1, |point| problem.score(point));
        }
        self.swarm.done()
    }

    fn progress(&self) -> Progress {
        let total = f64::from(self.swarm.setup().iterations);
        let done = if self.swarm.done() { total } else { f64::from(self.swarm.iteration()) };
        Progress { done, total, unit: text!("iterations") }
    }

    fn partial(&self) -> Optimum {
        self.optimum()
    }
}
