use super::*;
use crate::base::math::PI;
use crate::models::structure::engagement::EngagementAngles;
use crate::models::structure::{FiveMass, MachineSettings};

fn standard() -> Reduction {
    Reduction::new(&FiveMass::new(&MachineSettings::default())).unwrap()
}

fn force(static_n: f64) -> CutForce {
    CutForce { static_n, delay_s: 0.02, ..CutForce::default() }
}

#[test]
fn a_held_force_gives_the_exact_mean_displacement() {
    // Mean of the unit step's response over an interval, by parts of the closed form.
    let machine = standard();
    for dt in [1e-4, 1e-3] {
        let mut response = ModalResponse::new(&machine, dt, 0.02);
        let mut last = 0.0;
        for k in 0..100_u32 {
            let motion = response.update(&force(1.0));
            let integral = |t: f64| {
                let modes = machine.poles.iter().zip(&machine.residues);
                let sum: f64 = modes
                    .map(|(l, residue)| {
                        let size = math::exp(l.re * t);
                        let e =
                            Complex::new(size * math::cos(l.im * t), size * math::sin(l.im * t));
                        2.0 * (residue / l * ((e - 1.0) / l - t)).re
                    })
                    .sum();
                sum + machine.feedthrough_m_n * t
            };
            let (from, to) = (dt * f64::from(k), dt * f64::from(k + 1));
            let mean = (integral(to) - integral(from)) / dt;
            assert!((motion.displacement_m / mean - 1.0).abs() < 1e-8, "{k}");
            last = motion.displacement_m;
        }
        assert!(last > 0.0 && dt * 100.0 < 1.0);
    }
    let d1 = ModalResponse::new(&machine, 1e-4, 0.02);
    let d1 = d1.d1_modes + d1.feedthrough_m_n;
    assert!((d1 / 5.029_344_127_8e-9 - 1.0).abs() < 1e-10, "{d1:e}");
}

#[test]
fn at_rest_it_gives_way_by_its_compliance_and_velocity_is_the_change() {
    let machine = FiveMass::new(&MachineSettings::default());
    let mut response = ModalResponse::new(&standard(), 1e-4, 0.02);
    let mut before = 0.0;
    for k in 0..20_000 {
        let motion = response.update(&force(107.0));
        // Central difference of means against the mean velocity, once the jump is past.
        if (10..200).contains(&k) {
            let change = (motion.displacement_m - before) / 1e-4;
            assert!((change - motion.velocity_m_s).abs() < 0.002, "{k}: {change}");
        }
        before = motion.displacement_m;
    }
    let still = 107.0 * machine.static_compliance().grel_m_n;
    assert!((before / still - 1.0).abs() < 1e-9, "{before:e} {still:e}");
    assert!((still - 13.96e-6).abs() < 1e-8);
}

#[test]
fn interval_averages_keep_second_order_over_the_pulses_jump() {
    // Milling pulses sin(phi) from 0 to 51.3 degrees at 1592 1/min; rms of the part that the
    // modes give, against steps 12 times shorter. Reference: 3.9e-4 at 0.1 ms, 1.5e-3 at 0.2.
    let cut = EngagementAngles::side_milling(2, 3.0, 16.0);
    let omega = 1592.0 / 60.0 * 2.0 * PI;
    let machine = standard();
    let run = |dt: f64, steps: u32, parts: u32| {
        let mut response = ModalResponse::new(&machine, dt / f64::from(parts), 0.02);
        let residues = Row::of(machine.residues);
        let mut ends = Vec::new();
        for k in 0..steps * parts {
            let at = |k: u32| omega * dt / f64::from(parts) * f64::from(k);
            let mean = cut.means(at(k), at(k + 1));
            response.update(&force(mean.chip));
            if (k + 1) % parts == 0 {
                // The modes' displacement at the end of the step.
                ends.push(residues.times(&response.q));
            }
        }
        ends
    };
    for (dt, steps, stated) in [(1e-4, 1000, 3.9e-4), (2e-4, 500, 1.5e-3)] {
        let (coarse, fine) = (run(dt, steps, 1), run(dt, steps, 12));
        let size: f64 = fine.iter().map(|x| x * x).sum();
        let off: f64 = coarse.iter().zip(&fine).map(|(x, y)| (x - y) * (x - y)).sum();
        let error = (off / size).sqrt();
        assert!(error < 1.15 * stated && error > 0.4 * stated, "{dt}: {error:e}");
    }
}

#[test]
fn the_surface_before_is_interpolated_by_a_cubic() {
    let mut response = ModalResponse::new(&standard(), 1e-3, 0.03);
    let cubic = |t: f64| 1.0 + t * (0.3 + t * (-0.02 + 0.0007 * t));
    let length = response.surface_m.len();
    for k in 0..length {
        response.surface_m[k] = cubic(k as f64);
    }
    response.newest = length - 1;
    for steps in [2.0, 2.25, 7.0, 18.85, 29.99] {
        response.set_delay(steps * 1e-3);
        let exact = cubic(length as f64 - steps);
        assert!(
            (response.surface_before(&LeftBy::default()) / exact - 1.0).abs() < 1e-12,
            "{steps}"
        );
    }
}

#[test]
fn teeth_that_are_left_out_leave_no_surface() {
    let mut response = ModalResponse::new(&standard(), 1e-3, 0.1);
    let length = response.surface_m.len();
    (0..length).for_each(|k| response.surface_m[k] = k as f64);
    response.newest = length - 1;
    response.set_delay(20.5e-3);
    let before =
        |parts: [f64; MAX_TEETH]| length as f64 - response.surface_before(&LeftBy::shares(&parts));
    for (parts, steps) in [
        ([0.0; MAX_TEETH], 20.5),
        ([0.7, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0], 20.5),
        ([0.0, 2.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0], 41.0),
        ([0.0, 0.0, 0.0, 1.5, 0.0, 0.0, 0.0, 0.0], 82.0),
        ([1.0, 3.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0], 0.25 * 20.5 + 0.75 * 41.0),
    ] {
        assert!((before(parts) - steps).abs() < 1e-9, "{parts:?}: {}", before(parts));
    }
}

#[test]
fn a_lost_tooth_leaves_the_surface_of_the_one_before() {
    let mut response = ModalResponse::new(&standard(), 1e-4, 0.005);
    // A hard cut throws the tooth off; then a thin chip finds nothing to cut.
    for _ in 0..40 {
        response.update(&CutForce { static_n: 500.0, delay_s: 0.005, ..CutForce::default() });
    }
    let thin =
        CutForce { static_n: 0.01, stiffness_n_m: 1e6, delay_s: 0.005, ..CutForce::default() };
    let before = response.surface_before(&LeftBy::default());
    let motion = response.update(&thin);
    assert!(motion.lost_contact && motion.force_n == 0.0);
    let surface = response.surface_m[response.newest];
    assert!((surface - (before + 1e-8)).abs() < 1e-15 && surface < motion.displacement_m);
    let held = response.holding_contact().update(&thin);
    assert!(held.force_n < 0.0 && !held.lost_contact);
}

#[test]
fn process_damping_takes_energy() {
    let ring = |damping_n_s_m: f64| {
        let mut response = ModalResponse::new(&standard(), 1e-4, 0.02).holding_contact();
        response.update(&force(1000.0));
        let mut sum = 0.0;
        for _ in 0..500 {
            let motion = response.update(&CutForce { damping_n_s_m, ..force(0.0) });
            sum += motion.displacement_m * motion.displacement_m;
        }
        sum
    };
    assert!(ring(2000.0) < 0.7 * ring(0.0));
}
