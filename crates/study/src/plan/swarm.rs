//! Particle swarm in two dimensions with inertia weight (Shi and Eberhart 1998), constraints by
//! feasibility rules (see [`super::score`]). It knows nothing of milling.
//!
//! ```text
//! v <- w v + c1 r1 (p - x) + c2 r2 (g - x)     r1, r2 new for every dimension
//! x <- x + v
//! ```
//!
//! w falls linearly from 0.9 to 0.4 over the iterations allowed, c1 = c2 = 2, |v| is at most 0.2 of
//! the range. A particle that would leave the range is set on its edge and comes back with a
//! quarter of that component of v. With none, as is also done, whole swarms stick to an edge along
//! which the feasible strip is narrow: where the force limit leaves 1 to 3 % of the feeds, 11 to 99
//! of 100 seeds meet the grid's best within 0.5 %, by problem. With a half or more they fly over it.
//!
//! The swarm ends when its best has not gained for a while and all particles have gathered around
//! it. Without the second condition most runs end before the swarm has contracted, and 37 to 100 of
//! 100 seeds meet the grid's best.
//!
//! Every random number is drawn by counter from one stream, so that the result depends on the seed
//! alone and not on how the work was cut in slices.

use serde::Serialize;

use super::score::Score;
use crate::base::math::limit;
use crate::base::rng::Stream;

/// Inertia weight at the first and the last iteration.
const INERTIA: [f64; 2] = [0.9, 0.4];
/// Pull towards the own best and towards the swarm's best, c1 and c2.
const PULL: f64 = 2.0;
/// Largest step of an iteration as a fraction of the range.
const LARGEST_STEP: f64 = 0.2;
/// Fraction of its velocity with which a particle comes back from an edge (chosen: see above).
const REBOUND: f64 = 0.25;
/// The swarm has gathered when its particles' own bests lie, on average, within this fraction of the
/// best (chosen).
const GATHERED: f64 = 5e-3;

/// One particle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Particle {
    /// Where it is.
    pub position: [f64; 2],
    /// Its last step.
    pub velocity: [f64; 2],
    /// What it found there.
    pub score: Score,
    /// The best place it has been to.
    pub best_position: [f64; 2],
    /// What it found there.
    pub best_score: Score,
}

/// One iteration in the history.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Iteration {
    /// Number of the iteration; 0 is the random start.
    pub iteration: u32,
    /// The swarm's best so far.
    pub best: Score,
    /// Mean of the particles' present values.
    pub mean_value: f64,
    /// Fraction of the particles that are at a feasible place now.
    pub feasible_share: f64,
}

/// How a swarm is set up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SwarmSetup {
    /// Seed of all random numbers.
    pub seed: u64,
    /// Number of particles, at least 1.
    pub particles: u32,
    /// Most iterations.
    pub iterations: u32,
    /// Iterations without a relative gain of 1e-4 after which it ends, once gathered.
    pub stop_after: u32,
    /// Least position; equal to `high` in a dimension that is not searched.
    pub low: [f64; 2],
    /// Largest position.
    pub high: [f64; 2],
}

/// A swarm on its way.
#[derive(Clone, Debug)]
pub struct Swarm {
    setup: SwarmSetup,
    stream: Stream,
    particles: Vec<Particle>,
    best: ([f64; 2], Score),
    /// The score of the last iteration that counted as progress.
    anchor: Score,
    stale: u32,
    history: Vec<Iteration>,
}

impl Swarm {
    /// The swarm at its random start, every particle evaluated once.
    #[must_use]
    pub fn new(setup: SwarmSetup, evaluate: impl Fn([f64; 2]) -> Score) -> Self {
        let stream = Stream::new(setup.seed, "plan.swarm");
        let particles: Vec<Particle> = (0..u64::from(setup.particles))
            .map(|index| {
                let draw = |k: u64| stream.uniform(4 * index + k);
                let position = [0, 1]
                    .map(|d: usize| setup.low[d] + draw(d as u64) * (setup.high[d] - setup.low[d]));
                let velocity = [0, 1].map(|d: usize| {
                    let largest = LARGEST_STEP * (setup.high[d] - setup.low[d]);
                    (2.0 * draw(2 + d as u64) - 1.0) * largest
                });
                let score = evaluate(position);
                Particle { position, velocity, score, best_position: position, best_score: score }
            })
            .collect();
        let mut best = (particles[0].position, particles[0].score);
        for particle in &particles {
            if particle.score.beats(best.1) {
                best = (particle.position, particle.score);
            }
        }
        let history = Vec::with_capacity(setup.iterations as usize + 1);
        let mut swarm = Self { setup, stream, particles, best, anchor: best.1, stale: 0, history };
        swarm.record();
        swarm
    }

    /// Goes on for at most `iterations`; `true` when the swarm has ended.
    pub fn advance(&mut self, iterations: u32, evaluate: impl Fn([f64; 2]) -> Score) -> bool {
        for _ in 0..iterations {
            if self.done() {
                break;
            }
            self.iterate(&evaluate);
        }
        self.done()
    }

    fn iterate(&mut self, evaluate: impl Fn([f64; 2]) -> Score) {
        let SwarmSetup { low, high, particles, iterations, .. } = self.setup;
        let iteration = self.iteration() + 1;
        let share = f64::from(iteration - 1) / f64::from(iterations.max(2) - 1);
        let inertia = INERTIA[0] + share * (INERTIA[1] - INERTIA[0]);
        let largest = [0, 1].map(|d: usize| LARGEST_STEP * (high[d] - low[d]));
        let first = u64::from(iteration) * u64::from(particles);
        // Four random numbers from one draw: steps of 1/65536 are fine enough for a pull.
        let share = |bits: u64| f64::from(bits as u16) * (1.0 / 65_536.0);
        let attractor = self.best.0;
        for (counter, particle) in (first..).zip(&mut self.particles) {
            let bits = self.stream.bits(4 * counter);
            for d in 0..2 {
                let own = share(bits >> (32 * d));
                let swarm = share(bits >> (32 * d + 16));
                let x = particle.position[d];
                let velocity = inertia * particle.velocity[d]
                    + PULL * own * (particle.best_position[d] - x)
                    + PULL * swarm * (attractor[d] - x);
                let velocity = limit(velocity, -largest[d], largest[d]);
                let moved = x + velocity;
                particle.position[d] = limit(moved, low[d], high[d]);
                let inside = particle.position[d] == moved;
                particle.velocity[d] = if inside { velocity } else { -REBOUND * velocity };
            }
        }
        // First all evaluations, then all comparisons: a comparison that the processor guesses
        // wrongly would throw away the evaluation that it had begun meanwhile.
        for particle in &mut self.particles {
            particle.score = evaluate(particle.position);
        }
        for particle in &mut self.particles {
            if particle.score.beats(particle.best_score) {
                (particle.best_position, particle.best_score) = (particle.position, particle.score);
                if particle.score.beats(self.best.1) {
                    self.best = (particle.position, particle.score);
                }
            }
        }
        let best = self.best;
        if best.1.gains_on(self.anchor) {
            (self.anchor, self.stale) = (best.1, 0);
        } else {
            self.stale += 1;
        }
        self.record();
    }

    fn record(&mut self) {
        let count = self.particles.len() as f64;
        let (mut sum, mut feasible) = (0.0, 0_u32);
        for particle in &self.particles {
            sum += particle.score.value;
            feasible += u32::from(particle.score.feasible());
        }
        self.history.push(Iteration {
            iteration: self.history.len() as u32,
            best: self.best.1,
            mean_value: sum / count,
            feasible_share: f64::from(feasible) / count,
        });
    }

    /// Iterations so far.
    #[must_use]
    pub fn iteration(&self) -> u32 {
        self.history.len() as u32 - 1
    }

    /// Whether it has ended: all iterations done, or no gain for too long.
    #[must_use]
    pub fn done(&self) -> bool {
        self.iteration() >= self.setup.iterations
            || (self.stale >= self.setup.stop_after && self.gathered())
    }

    /// Whether the particles' own bests are nearly as good as the swarm's.
    fn gathered(&self) -> bool {
        let best = self.best.1;
        let apart = |score: Score| {
            if best.feasible() {
                (best.value - score.value) / best.value.abs()
            } else {
                (score.violation - best.violation) / best.violation
            }
        };
        let all = self.particles.iter().map(|particle| particle.best_score);
        let feasible = all.clone().filter(|score| score.feasible() == best.feasible()).count();
        let sum: f64 = all.map(apart).sum();
        feasible == self.particles.len() && sum <= GATHERED * feasible as f64
    }

    /// Evaluations so far.
    #[must_use]
    pub fn evaluations(&self) -> u64 {
        self.history.len() as u64 * self.particles.len() as u64
    }

    /// The particles as they are now.
    #[must_use]
    pub fn particles(&self) -> &[Particle] {
        &self.particles
    }

    /// The best place found and its score.
    #[must_use]
    pub fn best(&self) -> ([f64; 2], Score) {
        self.best
    }

    /// All iterations so far, the random start first.
    #[must_use]
    pub fn history(&self) -> &[Iteration] {
        &self.history
    }

    /// How it was set up.
    #[must_use]
    pub fn setup(&self) -> &SwarmSetup {
        &self.setup
    }
}

#[cfg(test)]
mod tests;
