use super::*;
use crate::models::structure::{FiveMass, MachineSettings};

fn machine(dt_s: f64) -> Coupled {
    let reduced = Reduction::new(&FiveMass::new(&MachineSettings::default())).unwrap();
    Coupled::new(&CoupledSetup {
        machine: reduced,
        teeth: 2,
        diameter_mm: 16.0,
        stiffness_per_mm: 1.525e6,
        dt_s,
    })
}

/// Pulses of 107 N at a speed for two seconds without regeneration; displacements of the last second.
fn driven(machine: &mut Coupled, speed_rpm: f64) -> Vec<f64> {
    let cut = CutState { speed_rpm, axial_depth_mm: 0.0, radial_depth_mm: 3.0 };
    let all = (0..20_000).map(|_| machine.pulse(107.0, &cut).displacement_m);
    all.collect::<Vec<f64>>().split_off(10_000)
}

#[test]
fn the_steps_divide_the_plants() {
    for (dt_s, steps) in [(1e-3, 10), (1e-4, 1), (1.0 / 28_800.0, 1), (0.02, 200), (2.5e-4, 3)] {
        assert_eq!(machine(dt_s).steps(), steps, "{dt_s}");
    }
}

#[test]
fn pulses_of_107_newton_shake_the_machine_as_the_reference_says() {
    // Periodic relative vibration, peak to peak, um.
    for (speed_rpm, stated) in [(1571.0, 35.1), (1592.0, 36.0), (2134.0, 17.2)] {
        let moved = driven(&mut machine(1e-4), speed_rpm);
        let [low, high] = math::extent(moved.into_iter());
        let span_um = 1e6 * (high - low);
        assert!((span_um / stated - 1.0).abs() < 0.01, "{speed_rpm}: {span_um}");
    }
}

#[test]
fn the_sound_is_the_rms_of_the_velocity_over_a_second() {
    let mut sound = Sound::new(1e-4);
    let mut measured = Vec::new();
    for i in 0..25_000_u32 {
        let size = if i < 15_000 { 1.0 } else { 3.0 };
        sound.observe(size * math::sin(TAU * 50.0 * 1e-4 * f64::from(i)));
        measured.push(sound.rms_m_s);
    }
    let near =
        |at: usize, x: f64| assert!((measured[at] - x).abs() < 1e-6, "{at}: {}", measured[at]);
    near(99 + 200, 0.5_f64.sqrt());
    near(14_999, 0.5_f64.sqrt());
    near(19_999, (0.5 * 0.5 + 0.5 * 4.5_f64).sqrt());
    near(24_999, 4.5_f64.sqrt());
}

#[test]
fn without_regeneration_the_peak_is_the_given_one_and_a_standing_spindle_does_no_harm() {
    let mut machine = machine(1e-3);
    driven(&mut machine, 1571.0);
    assert_eq!(machine.added_force_n(), 0.0);
    let still = CutState { speed_rpm: 0.0, axial_depth_mm: 2.0, radial_depth_mm: 3.0 };
    (0..3000).for_each(|_| {
        let motion = machine.pulse(107.0, &still);
        assert!(motion.force_n.is_finite() && motion.displacement_m.abs() < 1e-3);
    });
    let sound = machine.sound_m_s();
    let air = CutState::default();
    (0..30_000).for_each(|_| {
        machine.pulse(0.0, &air);
    });
    assert!(machine.sound_m_s() < 1e-9 && sound > 1e-9, "it comes to rest");
}

#[test]
fn a_worn_tooth_is_softer() {
    let mut worn = machine(1e-4);
    worn.wear(0.5, 0.0);
    let still = CutState { speed_rpm: 0.0, axial_depth_mm: 0.0, radial_depth_mm: 3.0 };
    let rest = |machine: &mut Coupled| {
        (0..20_000)
            .map(|_| machine.instant(100.0, &[0.0; MAX_TEETH], &still).displacement_m)
            .last()
            .unwrap()
    };
    let softer = rest(&mut worn) - rest(&mut machine(1e-4));
    let tooth = 100.0 / 202_993_285.911_493;
    assert!((softer / tooth - 1.0).abs() < 1e-6, "{softer:e} {tooth:e}");
}

#[test]
fn the_speeds_that_it_holds_for_are_those_of_its_memory() {
    let machine = machine(1e-4);
    for (speed_rpm, holds) in
        [(0.0, false), (99.0, false), (100.0, true), (20_000.0, true), (2e5, false)]
    {
        assert_eq!(machine.holds_at(speed_rpm), holds, "{speed_rpm}");
    }
}

/// Teeth and regeneration at a slow speed: a surface once left comes back a tooth period later, not earlier.
#[test]
fn a_slow_tooth_meets_the_surface_of_its_own_tooth_period() {
    for speed_rpm in [100.0, 150.0, 399.0, 1571.0] {
        let mut machine = machine(1e-4);
        let cut = CutState { speed_rpm, axial_depth_mm: 1.0, radial_depth_mm: 3.0 };
        let mut edges_mm = [0.0; MAX_TEETH];
        edges_mm[0] = 1.0;
        // A short push in a cut that goes on with a constant force, and when the force answers it.
        let period = (60.0 / (2.0 * speed_rpm) / 1e-4) as usize;
        let answer = |machine: &mut Coupled, pushed_n: f64| {
            let force_n = |i: usize| if i < 3 { 500.0 + pushed_n } else { 500.0 };
            let forces =
                (0..2 * period).map(|i| machine.instant(force_n(i), &edges_mm, &cut).force_n);
            forces.collect::<Vec<f64>>()
        };
        let quiet = answer(&mut machine.clone(), 0.0);
        let pushed = answer(&mut machine, 200.0);
        let late = (period / 2..2 * period).max_by(|a, b| {
            let off = |i: usize| (pushed[i] - quiet[i]).abs();
            off(*a).total_cmp(&off(*b))
        });
        let late = late.unwrap() as f64 / period as f64;
        assert!((0.98..1.3).contains(&late), "{speed_rpm}: {late} tooth periods");
    }
}
