use super::*;

const SETUP: SwarmSetup = SwarmSetup {
    seed: 1,
    particles: 30,
    iterations: 100,
    stop_after: 30,
    low: [-5.0, 0.0],
    high: [5.0, 20.0],
};

/// A hill with its top 7 at (1, 4), allowed where x + y <= `sum`.
fn hill(sum: f64) -> impl Fn([f64; 2]) -> Score {
    move |[x, y]| Score {
        value: 7.0 - (x - 1.0) * (x - 1.0) - 0.1 * (y - 4.0) * (y - 4.0),
        violation: (x + y - sum).max(0.0),
    }
}

fn found(setup: SwarmSetup, f: impl Fn([f64; 2]) -> Score) -> Swarm {
    let mut swarm = Swarm::new(setup, &f);
    while !swarm.advance(1, &f) {}
    swarm
}

#[test]
fn the_top_of_a_hill_is_found_inside_and_on_a_constraint() {
    for seed in 0..50 {
        let (top, score) = found(SwarmSetup { seed, ..SETUP }, hill(99.0)).best();
        assert!((score.value - 7.0).abs() < 2e-3, "seed {seed}: {top:?} {score:?}");
        // On x + y = 3 by Lagrange: x - 1 = 0.1 (y - 4), so x = 0.9 / 1.1, value 6.6364.
        let (edge, score) = found(SwarmSetup { seed, ..SETUP }, hill(3.0)).best();
        assert!(score.feasible() && (score.value - 6.636_36).abs() < 0.033, "{edge:?} {score:?}");
        // Nothing is allowed: the least violation is at the lower corner.
        let (corner, score) = found(SwarmSetup { seed, ..SETUP }, hill(-6.0)).best();
        assert_eq!((corner, score.violation), ([-5.0, 0.0], 1.0));
    }
}

#[test]
fn slicing_changes_nothing_and_the_seed_everything() {
    let f = hill(3.0);
    let whole = found(SETUP, &f);
    let mut sliced = Swarm::new(SETUP, &f);
    for slice in [0, 1, 5, 2, 1000] {
        sliced.advance(slice, &f);
    }
    assert_eq!((whole.particles(), whole.history()), (sliced.particles(), sliced.history()));
    let other = found(SwarmSetup { seed: 2, ..SETUP }, &f);
    assert_ne!(whole.best().0, other.best().0);
}

#[test]
fn particles_stay_inside_and_a_fixed_dimension_does_not_move() {
    let f = |[x, y]: [f64; 2]| Score { value: x + y, violation: 0.0 };
    let setup = SwarmSetup { low: [2.0, 0.0], high: [2.0, 20.0], stop_after: 100, ..SETUP };
    let mut swarm = Swarm::new(setup, f);
    while !swarm.advance(1, f) {
        for particle in swarm.particles() {
            let [x, y] = particle.position;
            assert!(x == 2.0 && (0.0..=20.0).contains(&y));
            assert!(particle.velocity[0] == 0.0 && particle.velocity[1].abs() <= 4.0);
        }
    }
    assert_eq!(swarm.best().0, [2.0, 20.0]);
    assert_eq!((swarm.iteration(), swarm.evaluations()), (100, 3030));
    let bests = swarm.history().windows(2);
    assert!(bests.into_iter().all(|pair| pair[1].best.value >= pair[0].best.value));
}

#[test]
fn it_stops_after_so_many_iterations_without_gain() {
    let flat = |_| Score { value: 1.0, violation: 0.0 };
    assert_eq!(found(SwarmSetup { stop_after: 12, ..SETUP }, flat).iteration(), 12);
}
