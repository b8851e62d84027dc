//! Speed of the particle swarm against the bare evaluations of its network: the same points in the
//! same order, feed and speed already known, nothing but the force asked for.

use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use steadycut_core::run::presets::load;
use steadycut_core::run::scenario::{Scenario, parse_value};
use steadycut_study::plan::PlanJob;
use steadycut_study::plan::problem::Problem;
use steadycut_study::plan::swarm::{Swarm, SwarmSetup};

/// The objectives that are timed: the default one, and one that needs tool life and cost.
fn jobs() -> [(&'static str, PlanJob); 2] {
    let job = |sets: &[(&str, &str)]| {
        let mut scenario: Scenario = load("first-cut").expect("a shipped preset");
        for (path, value) in sets {
            let value = parse_value(path, value).expect("a value of its type");
            scenario.set(path, value).expect("an allowed value");
        }
        PlanJob::new(&scenario).expect("the cut can be planned")
    };
    let mixed = [("plan.weight_removal_rate", "1"), ("plan.weight_time", "1")];
    [("force", job(&[])), ("all", job(&[&mixed[..], &[("plan.weight_cost", "1")]].concat()))]
}

fn swarm(setup: SwarmSetup, problem: &Problem) -> Swarm {
    let mut swarm = Swarm::new(setup, |point| problem.score(point));
    swarm.advance(u32::MAX, |point| problem.score(point));
    swarm
}

/// Feed and speed of every evaluation, in order.
fn visited(setup: SwarmSetup, problem: &Problem) -> Vec<[f64; 2]> {
    let mut swarm = Swarm::new(setup, |point| problem.score(point));
    let mut points = Vec::new();
    loop {
        for particle in swarm.particles() {
            let cut = problem.cut(particle.position);
            points.push([cut.feed_mm_min, cut.speed_rpm]);
        }
        if swarm.done() {
            assert_eq!(points.len() as u64, swarm.evaluations());
            return points;
        }
        swarm.advance(1, |point| problem.score(point));
    }
}

fn bare(problem: &Problem, points: &[[f64; 2]]) -> f64 {
    let mut sum = 0.0;
    for [feed_mm_min, speed_rpm] in points {
        let [x, y, _] = problem.surface().network().components(*feed_mm_min, *speed_rpm);
        sum += x + y;
    }
    sum
}

/// Best of many alternating runs: the ratio that the project promises, and fails without.
#[expect(clippy::disallowed_methods, reason = "a bench needs a clock")]
fn ratio() {
    // The network's share depends on the processor: 0.4.0 measured 1.23 to 1.25 on one, and its very
    // sources 1.34 on another, where today's give 1.34 to 1.36.
    const LIMIT: f64 = 1.5;
    for (name, job) in &jobs() {
        let (setup, problem) = (*job.swarm().setup(), job.problem());
        let points = visited(setup, problem);
        let (mut network, mut whole) = (f64::INFINITY, f64::INFINITY);
        // The best of more runs where other work on the machine hides it; a ratio that is really
        // too large stays so.
        for run in 0..2000 {
            if run % 500 == 0 && whole <= LIMIT * network && run > 0 {
                break;
            }
            let start = std::time::Instant::now();
            black_box(bare(black_box(problem), black_box(&points)));
            let middle = std::time::Instant::now();
            black_box(swarm(black_box(setup), black_box(problem)).best());
            network = network.min((middle - start).as_secs_f64());
            whole = whole.min(middle.elapsed().as_secs_f64());
        }
        let ns = |seconds: f64| seconds / points.len() as f64 * 1e9;
        let ratio = whole / network;
        println!(
            "{name}: {} evaluations, {:.1} ns each in the swarm, {:.1} ns bare, ratio {ratio:.3} \
             (limit {LIMIT}); {:.3} ms in all",
            points.len(),
            ns(whole),
            ns(network),
            whole * 1e3
        );
        assert!(ratio <= LIMIT, "{name}: the swarm costs {ratio:.3} times its evaluations");
    }
}

fn plans(criterion: &mut Criterion) {
    ratio();
    let mut group = criterion.benchmark_group("plan");
    for (name, job) in &jobs() {
        let (setup, problem) = (*job.swarm().setup(), job.problem());
        let points = visited(setup, problem);
        group.throughput(Throughput::Elements(points.len() as u64));
        group.bench_function(format!("{name}: network alone"), |bencher| {
            bencher.iter(|| bare(problem, &points));
        });
        group.bench_function(format!("{name}: swarm"), |bencher| {
            bencher.iter(|| swarm(setup, problem).best());
        });
    }
    group.finish();
}

criterion_group!(benches, plans);
criterion_main!(benches);
