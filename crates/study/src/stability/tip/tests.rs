use super::*;
use crate::models::structure::Complex;
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

/// Two modes in each direction, an end mill of 31.75 mm with two teeth in a half immersed down-milling cut, K_t 1319.4 and
/// K_r 788.8 N/mm^2: the public example of leekunhwee/Dynamics (Milling/General/ScriptStiffnessFD.m), there with the
/// formulas of two textbooks.
fn end_mill() -> TipCut {
    let modes = [
        (TipAxis::X, 456.780432115313, 0.111705399393456, 0.963094248615537),
        (TipAxis::X, 1448.88914030656, 0.0170370095790783, 0.177274003430936),
        (TipAxis::Y, 516.51818914797, 0.0245796327070992, 0.89006790971493),
        (TipAxis::Y, 1408.44814086966, 0.0313576019295683, 0.158418061422864),
    ]
    .map(|(axis, frequency_hz, damping_ratio, mass_kg)| TipMode {
        axis,
        frequency_hz,
        damping_ratio,
        mass_kg,
    });
    TipCut {
        modes: TipModes::new(modes.to_vec()).unwrap(),
        teeth: 2,
        window_rad: window_rad(15.875, 31.75, true),
        radial_depth_mm: 15.875,
        diameter_mm: 31.75,
        tangential_n_mm2: 1319.4,
        radial_ratio: 788.8 / 1319.4,
        down_milling: true,
    }
}

/// Depths in mm of all lobes that pass a spindle speed, and the least depth of any, by the textbook: Altintas,
/// Manufacturing Automation, 2012, sec. 4.7: a_0 L^2 + a_1 L + 1 = 0 with the directional coefficients alpha,
/// b = -2 pi L_R (1 + (L_I / L_R)^2) / (N K_t), w T = pi - 2 arctan(L_I / L_R) + 2 pi k.
fn by_the_textbook(cut: &TipCut, speed_rpm: f64) -> (Vec<f64>, f64) {
    let [from, to] = cut.window_rad;
    let r = cut.radial_ratio;
    let (sin, cos) = (|x: f64| math::sin(2.0 * x), |x: f64| math::cos(2.0 * x));
    let between = |of: &dyn Fn(f64) -> f64| 0.5 * (of(to) - of(from));
    let xx = between(&|x| cos(x) - 2.0 * r * x + r * sin(x));
    let xy = between(&|x| -sin(x) - 2.0 * x + r * cos(x));
    let yx = between(&|x| -sin(x) + 2.0 * x + r * cos(x));
    let yy = between(&|x| -cos(x) - 2.0 * r * x - r * sin(x));
    let kt_n_m2 = 1e6 * cut.tangential_n_mm2;
    let teeth = f64::from(cut.teeth);
    let (mut depths, mut least) = (Vec::new(), f64::INFINITY);
    // Each root as it goes on: depth and speed in every lobe.
    let mut before: [Option<(Complex, f64, Vec<f64>)>; 2] = [None, None];
    for k in 0..220_000 {
        let omega = TAU * (100.0 + 0.02 * f64::from(k));
        let s = Complex::new(0.0, omega);
        let [gx, gy] = [TipAxis::X, TipAxis::Y].map(|axis| cut.modes.compliance(axis, s));
        let a0 = gx * gy * (xx * yy - xy * yx);
        let a1 = gx * xx + gy * yy;
        let apart = zero_order::root(a1 * a1 - a0 * 4.0);
        let mut roots = [-(a1 + apart) / (a0 * 2.0), -(a1 - apart) / (a0 * 2.0)];
        let far = |a: Complex, b: &Option<(Complex, f64, Vec<f64>)>| {
            b.as_ref().map_or(0.0, |(b, ..)| (a - *b).norm_sqr())
        };
        if far(roots[1], &before[0]) < far(roots[0], &before[0]) {
            roots.swap(0, 1);
        }
        for (root, before) in roots.into_iter().zip(&mut before) {
            let kappa = root.im / root.re;
            let depth_mm = -1e3 * TAU * root.re * (1.0 + kappa * kappa) / (teeth * kt_n_m2);
            let shift = PI - 2.0 * math::atan(kappa);
            let speeds: Vec<f64> = (0..30)
                .map(|lobe| {
                    let turns = shift + TAU * f64::from(lobe);
                    60.0 * omega / (teeth * turns)
                })
                .collect();
            if depth_mm > 0.0 {
                least = least.min(depth_mm);
                if let Some((_, _, was)) = before.as_ref().filter(|(_, depth, _)| *depth > 0.0) {
                    let passes = |(a, b): (&f64, &f64)| {
                        (a - speed_rpm) * (b - speed_rpm) <= 0.0 && (a / b - 1.0).abs() < 0.05
                    };
                    if was.iter().zip(&speeds).any(passes) {
                        depths.push(depth_mm);
                    }
                }
            }
            *before = Some((root, depth_mm, speeds));
        }
    }
    (depths, least)
}

#[test]
fn the_chart_of_two_directions_is_that_of_the_textbook() {
    let cut = end_mill();
    let mut known = Vec::new();
    for speed in [3000.0, 5000.0, 8000.0, 12_000.0, 14_500.0] {
        let (depths, least_mm) = by_the_textbook(&cut, speed);
        let depth_mm = depths.into_iter().fold(f64::INFINITY, f64::min);
        let found = zero_order::limit(&cut, speed).expect("it chatters");
        assert!((found.depth_mm / depth_mm - 1.0).abs() < 3e-3, "{speed}: {found:?} {depth_mm}");
        let any_mm = zero_order::at_any_speed_mm(&cut);
        assert!((any_mm / least_mm - 1.0).abs() < 1e-4, "{any_mm} {least_mm}");
        known.push(depth_mm);
    }
    // No chart that is flat, and within the picture of the example: 0 to 6 mm.
    let (least, most) = (
        known.iter().copied().fold(f64::INFINITY, f64::min),
        known.iter().copied().fold(0.0, f64::max),
    );
    assert!(most > 1.5 * least && most < 6.0, "{known:?}");
}
