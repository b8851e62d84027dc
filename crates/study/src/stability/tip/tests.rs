use super::*;
use crate::stability::tip::semi_discrete::{multiplier, multiplier_by};
use crate::stability::tip::simulated::growth;
use crate::stability::tip::{semi_discrete, zero_order};

/// The one mode of Insperger and Stepan 2004: 922 Hz, damping 0.011, 0.03993 kg along the feed.
fn one() -> TipMode {
    let axis = TipAxis::X;
    TipMode { axis, frequency_hz: 922.0, damping_ratio: 0.011, mass_kg: 0.03993 }
}

/// Their cut: two teeth without helix, K_t 600 and K_n 200 N/mm^2.
pub(crate) fn benchmark(immersion: f64, down_milling: bool) -> TipCut {
    TipCut {
        modes: TipModes::new(vec![one()]).unwrap(),
        teeth: 2,
        window_rad: window_rad(immersion * 10.0, 10.0, down_milling),
        radial_depth_mm: immersion * 10.0,
        diameter_mm: 10.0,
        tangential_n_mm2: 600.0,
        radial_ratio: 1.0 / 3.0,
        down_milling,
    }
}

/// The same with a mode across the feed.
fn both_ways(cut: TipCut) -> TipCut {
    let across =
        TipMode { axis: TipAxis::Y, frequency_hz: 1005.0, damping_ratio: 0.02, mass_kg: 0.05 };
    TipCut { modes: TipModes::new(vec![one(), across]).unwrap(), ..cut }
}

#[test]
fn the_multipliers_of_the_benchmark_are_those_published() {
    // Slot at 5000 1/min: Ding, Zhu, Zhang and Ding 2010, A full-discretization method for prediction of milling
    // stability, with the reference values |mu_0| of a fine semi-discretisation.
    let cut = benchmark(1.0, true);
    let period_s = cut.period_s(5000.0);
    for (depth_mm, published) in [(0.2, 0.8192), (0.5, 1.0726), (0.7, 1.2197), (1.0, 1.4040)] {
        let at_200 = multiplier_by(&cut, 5000.0, depth_mm, period_s / 200.0 * (1.0 + 1e-9));
        assert!((at_200 / published - 1.0).abs() < 3e-4, "{depth_mm}: {at_200} {published}");
        // 200 intervals are not the end: the usual ones and far finer ones stay within 0.2 %.
        let usual = multiplier(&cut, 5000.0, depth_mm);
        let finer = multiplier_by(&cut, 5000.0, depth_mm, period_s / 800.0);
        assert!((usual / published - 1.0).abs() < 2.5e-3, "{depth_mm}: {usual} {published}");
        assert!((usual / finer - 1.0).abs() < 2e-3, "{depth_mm}: {usual} {finer}");
    }
}

#[test]
fn the_first_coefficient_is_that_of_insperger_and_stepan() {
    let cut = benchmark(0.5, true);
    for rad in [1.6, 2.0, 3.1] {
        let (sin, cos) = (math::sin(rad), math::cos(rad));
        let h_n_mm2 = (600.0 * cos + 200.0 * sin) * sin;
        let found = 600.0 * cut.at(&[0], rad)[0][0];
        assert!((found - h_n_mm2).abs() < 1e-9, "{rad}: {found} {h_n_mm2}");
    }
    assert!((cut.window_rad[0] - PI / 2.0).abs() < 1e-12 && cut.window_rad[1] == PI);
    let [from, to] = benchmark(0.05, false).window_rad;
    // arccos 0.9 is 25.84 degrees.
    assert!(from == 0.0 && (to * 180.0 / PI - 25.842).abs() < 1e-3, "{to}");
}

#[test]
fn means_are_those_of_many_instants() {
    let cut = TipCut { teeth: 3, ..benchmark(0.8, false) };
    let stretches = cut.stretches();
    let all: f64 = stretches.iter().map(|stretch| stretch.rad[1] - stretch.rad[0]).sum();
    assert!((all - cut.pitch_rad()).abs() < 1e-12);
    for stretch in stretches {
        let [from, to] = stretch.rad;
        let mean = cut.mean(&stretch.cutting, stretch.rad);
        let count = 4000;
        let flat = |of: Directions| [of[0][0], of[0][1], of[1][0], of[1][1]];
        let mut sum = [0.0; 4];
        for i in 0..count {
            let rad = from + (to - from) * (f64::from(i) + 0.5) / f64::from(count);
            for (sum, x) in sum.iter_mut().zip(flat(cut.at(&stretch.cutting, rad))) {
                *sum += x / f64::from(count);
            }
        }
        for (mean, sum) in flat(mean).into_iter().zip(sum) {
            assert!((mean - sum).abs() < 1e-6, "{stretch:?}");
        }
    }
}

#[test]
fn disturbances_grow_in_time_as_the_semi_discretisation_says() {
    for (immersion, down, speed, depths) in [
        (0.05, true, 9000.0, [0.5, 3.0]),
        (0.1, true, 16_000.0, [0.5, 3.0]),
        (0.5, true, 12_000.0, [0.2, 1.0]),
        (1.0, true, 5000.0, [0.2, 1.0]),
        (0.05, false, 9000.0, [0.5, 3.0]),
        (0.5, false, 12_000.0, [0.2, 1.0]),
    ] {
        for cut in [benchmark(immersion, down), both_ways(benchmark(immersion, down))] {
            for depth in depths {
                let expected = multiplier(&cut, speed, depth);
                let found = growth(&cut, speed, depth);
                let told = format!("{immersion} {down} {depth}: {found} {expected}");
                assert!((found / expected - 1.0).abs() < 4e-3, "{told}");
            }
        }
    }
}

#[test]
fn the_limits_of_the_benchmark_are_the_same_by_both_ways() {
    for (immersion, speeds) in [
        (0.05, [9000.0, 18_000.0]),
        (0.1, [11_000.0, 20_000.0]),
        (0.5, [7000.0, 13_000.0]),
        (1.0, [5000.0, 9500.0]),
    ] {
        let cut = benchmark(immersion, true);
        for speed in speeds {
            let expected = semi_discrete::limit_mm(&cut, speed, 200.0).expect("it chatters");
            let [below, above] = [0.985, 1.015].map(|share| growth(&cut, speed, share * expected));
            assert!(below < 1.0 && above > 1.0, "{immersion} {speed}: {below} {above} {expected}");
        }
    }
}

#[test]
fn where_the_coefficients_are_constant_the_zero_order_is_exact() {
    // Four teeth in a slot: two in the cut a quarter turn apart, whose coefficients add up to a constant.
    let cut = TipCut { teeth: 4, ..both_ways(benchmark(1.0, true)) };
    let mean = cut.mean_of_period();
    for rad in [0.1, 0.9] {
        let at = cut.at(&cut.stretches()[0].cutting, rad);
        assert!((at[0][0] - mean[0][0]).abs() + (at[0][1] - mean[0][1]).abs() < 1e-12);
    }
    for speed in [4000.0, 7000.0, 12_000.0] {
        let lobes = zero_order::limit(&cut, speed).expect("it chatters");
        let found = semi_discrete::limit_mm(&cut, speed, 200.0).expect("it chatters");
        assert!((found / lobes.depth_mm - 1.0).abs() < 8e-3, "{speed}: {found} {lobes:?}");
    }
}

#[test]
fn the_depth_that_never_chatters_is_the_textbook_one() {
    // Of one mode: min Re G = -1 / (4 k zeta (1 + zeta)); S_0 in a slot of two teeth is K_r / 2.
    let cut = benchmark(1.0, true);
    let mode = one();
    let mean = cut.mean_of_period()[0][0];
    assert!((mean - 1.0 / 6.0).abs() < 1e-12, "{mean}");
    let zeta = mode.damping_ratio;
    let known_mm = 2.0 * mode.stiffness_n_m() * zeta * (1.0 + zeta) / mean / 6e5;
    let any_mm = zero_order::at_any_speed_mm(&cut);
    assert!((any_mm / known_mm - 1.0).abs() < 1e-6, "{any_mm} {known_mm}");
    let mut least = f64::INFINITY;
    for i in 0..200 {
        let speed = 2000.0 + 20.0 * f64::from(i);
        let depth_mm = zero_order::limit(&cut, speed).expect("it chatters").depth_mm;
        assert!(depth_mm >= any_mm * (1.0 - 1e-6), "{speed}: {depth_mm}");
        least = least.min(depth_mm);
    }
    assert!(least < 1.01 * any_mm, "{least} {any_mm}");
}

#[test]
fn without_a_depth_the_mode_decays() {
    let cut = benchmark(0.5, true);
    let decay = math::exp(one().pole().re * cut.period_s(6000.0));
    let found = multiplier(&cut, 6000.0, 1e-9);
    assert!((found / decay - 1.0).abs() < 1e-3, "{found} {decay}");
}
