//! The swarm against exhaustive search and against an optimiser from a library.

use argmin::core::{CostFunction, Error, Executor, State};
use argmin::solver::neldermead::NelderMead;
use steadycut::study::plan::PlanJob;
use steadycut::study::plan::field::exhaustive;
use steadycut::study::plan::machine::MachineLimits;
use steadycut::study::plan::problem::Problem;

use super::{COST, DEEP, FIXED, MIXED, RATE, Sets, TIME, scenario};

/// The objectives that are compared, on the default cut with a force from the target Ra and on the
/// deep one with a fixed force.
const OBJECTIVES: [Sets<'static>; 6] = [&[], &RATE, &COST, &TIME, &MIXED, &FIXED];

fn the_swarm_finds_the_grids_best(cut: Sets, objectives: &[Sets]) {
    for objective in objectives {
        let sets = [cut, *objective].concat();
        let mut scenario = scenario(&sets);
        let problem = Problem::new(&scenario, &MachineLimits::heller_bea_01()).unwrap();
        let grid = exhaustive(&problem, 400, 100);
        assert!(grid.score.feasible(), "{sets:?}");
        let (mut found, mut worst, mut evaluations) = (0, 0.0_f64, 0);
        for seed in 1..=100 {
            scenario.change(|s| s.plan.seed = seed).unwrap();
            let job = PlanJob::complete(&scenario).unwrap();
            let optimum = job.optimum();
            let gap = 1.0 - optimum.score.value / grid.score.value;
            assert!(gap > -1e-4, "better than the grid by {gap}: the grid is too coarse");
            worst = worst.max(gap);
            found += u32::from(optimum.feasible && gap <= 0.005);
            evaluations += job.counts().evaluations;
        }
        let mean = evaluations / 100;
        println!("{sets:?}: {found} of 100, worst {:.4} %, {mean} evaluations", 100.0 * worst);
        assert!(found >= 99, "{sets:?}: {found} of 100 seeds");
    }
}

#[test]
fn the_swarm_finds_the_grids_best_in_99_of_100_seeds() {
    the_swarm_finds_the_grids_best(&[], &OBJECTIVES);
}

#[test]
fn the_swarm_finds_the_grids_best_of_a_deep_cut_in_99_of_100_seeds() {
    the_swarm_finds_the_grids_best(&DEEP, &OBJECTIVES);
}

#[test]
fn the_swarm_finds_the_grids_best_in_a_narrow_strip_along_the_edge_in_99_of_100_seeds() {
    // 112 N allow at most 0.0217 mm per tooth: the feasible strip is 1 % of the feeds wide.
    let narrow = [("plan.force_limit", "fixed"), ("plan.force_max_n", "112")];
    the_swarm_finds_the_grids_best(&narrow, &[&[], &COST]);
}

/// The same objective for a minimiser without constraints, on the unit square.
struct Penalised<'a>(&'a Problem);

impl Penalised<'_> {
    fn point(&self, unit: &[f64]) -> [f64; 2] {
        let [speeds, feeds] = self.0.range();
        [
            speeds[0] + unit[0].clamp(0.0, 1.0) * (speeds[1] - speeds[0]),
            feeds[0] + unit[1].clamp(0.0, 1.0) * (feeds[1] - feeds[0]),
        ]
    }
}

impl CostFunction for Penalised<'_> {
    type Param = Vec<f64>;
    type Output = f64;
    fn cost(&self, unit: &Vec<f64>) -> Result<f64, Error> {
        let outside: f64 = unit.iter().map(|x| (x - x.clamp(0.0, 1.0)).abs()).sum();
        let score = self.0.score(self.point(unit));
        Ok(20.0 * (score.violation + outside) - score.value)
    }
}

/// The best feasible value that argmin's Nelder-Mead finds from 25 starts, each restarted once.
fn nelder_mead(problem: &Problem) -> f64 {
    let mut best = f64::NEG_INFINITY;
    for start in 0..25_u32 {
        let mut at = vec![0.1 + 0.2 * f64::from(start % 5), 0.1 + 0.2 * f64::from(start / 5)];
        for size in [0.1, 0.01] {
            let near = |x: f64, y: f64| vec![at[0] + x * size, at[1] + y * size];
            let simplex = vec![near(0.0, 0.0), near(1.0, 0.0), near(0.0, 1.0)];
            let solver = NelderMead::new(simplex).with_sd_tolerance(1e-12).unwrap();
            let run = Executor::new(Penalised(problem), solver)
                .configure(|state| state.max_iters(200))
                .run()
                .unwrap();
            at = run.state().get_best_param().unwrap().clone();
        }
        let score = problem.score(Penalised(problem).point(&at));
        // A penalty lets the answer stand a hair outside.
        if score.violation < 1e-5 {
            best = best.max(score.value);
        }
    }
    best
}

#[test]
fn an_optimiser_from_a_library_agrees() {
    for objective in OBJECTIVES.into_iter().chain([&DEEP[..]]) {
        let job = PlanJob::complete(&scenario(objective)).unwrap();
        let (ours, theirs) = (job.optimum().score.value, nelder_mead(job.problem()));
        println!("{objective:?}: swarm {ours}, Nelder-Mead {theirs}");
        assert!((ours / theirs - 1.0).abs() < 0.005, "{objective:?}: {ours} against {theirs}");
    }
}
