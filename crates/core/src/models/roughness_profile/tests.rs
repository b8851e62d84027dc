use super::*;
use crate::base::math;

const BALL: Outline = Outline { diameter_mm: 16.0, corner_radius_mm: 8.0 };

/// Teeth 0.1 mm apart from -4 mm on, at heights by their number.
fn marks(height_mm: impl Fn(i32) -> f64) -> Vec<ProfileMark> {
    (-40..=89).map(|k| ProfileMark { x_mm: f64::from(k) * 0.1, z_mm: height_mm(k) }).collect()
}

fn measured(height_mm: impl Fn(i32) -> f64) -> Roughness {
    measure(&marks(height_mm), &BALL, 0.0, &ProfileSettings::default()).unwrap()
}

fn sine(amplitude_mm: f64, length_mm: f64) -> Roughness {
    let height = |x_mm: f64| amplitude_mm * math::sin(math::TAU * x_mm / length_mm);
    evaluate(&ProfileSettings::default(), |start, step, count| {
        (0..count).map(|i| height(start + i as f64 * step)).collect()
    })
    .unwrap()
}

/// Height, Ra and Rq of a period of the exact envelope.
fn period(marks: &[ProfileMark], length_mm: f64) -> (f64, f64, f64) {
    let n = 20_000;
    let heights = envelope(marks, &BALL, 0.0, length_mm / f64::from(n), n as usize);
    let mean = heights.iter().sum::<f64>() / f64::from(n);
    let ra = heights.iter().map(|z| (z - mean).abs()).sum::<f64>() / f64::from(n);
    let squares = heights.iter().map(|z| (z - mean) * (z - mean)).sum::<f64>() / f64::from(n);
    let [low, high] = math::extent(heights.into_iter());
    (high - low, ra, squares.sqrt())
}

#[test]
fn circular_cusps_have_the_reference_heights() {
    for (feed_mm, total, ra) in [
        (0.08, 1.000006250078126e-4, 2.566014026531093e-5),
        (0.1352141478105047, 2.856748782603951e-4, 7.33039461672446e-5),
        (0.2, 6.250244159700349e-4, 1.60380086805511e-4),
        (0.5, 3.907204140262105e-3, 1.002540063298067e-3),
        // Across the feed, a stepover of 3 mm: far above the papers' Ra, which is along the feed.
        (3.0, 0.1418831772491445, 0.03634170011489559),
    ] {
        let marks: Vec<ProfileMark> =
            (-3..=3).map(|k| ProfileMark { x_mm: f64::from(k) * feed_mm, z_mm: 0.0 }).collect();
        let (height, mean, square) = period(&marks, feed_mm);
        assert!((height / total - 1.0).abs() < 1e-12, "{feed_mm}: {height}");
        // Nearly a parabola up to feeds of half a millimetre: the ratios of one.
        if feed_mm < 1.0 {
            assert!((mean / height - 0.2566001196398337).abs() < 2e-4);
            assert!((square / height - 0.298142396999972).abs() < 2e-4);
        }
        // The kinks of |y - mean| fall between the points.
        assert!((mean / ra - 1.0).abs() < 3e-8, "{feed_mm}: {mean}");
    }
}

#[test]
fn run_out_raises_the_cusps_until_one_tooth_no_longer_cuts() {
    // The references are for parabolas: 2e-5 off the circle at these heights.
    for (out_um, total, ra) in [
        (0.1, 2.1025e-4, 5.18073708628431e-5),
        (0.3, 3.4225e-4, 1.141531254977513e-4),
        (0.625, 6.25e-4, 1.60375074774896e-4),
        (5.0, 6.25e-4, 1.60375074774896e-4),
    ] {
        let marks = marks(|k| if k % 2 == 0 { 0.0 } else { out_um / 1000.0 });
        let (height, mean, _) = period(&marks, 0.2);
        assert!((height / total - 1.0).abs() < 1e-4, "{out_um}: {height}");
        assert!((mean / ra - 1.0).abs() < 2e-4, "{out_um}: {mean}");
    }
}

#[test]
fn the_measuring_chain_gives_the_reference_values() {
    let run_out = |k: i32| if k % 2 == 0 { 0.0 } else { 0.3e-3 };
    let wave = |k: i32| 1e-3 * math::sin(math::TAU * f64::from(k) * 0.3819660112501051);
    for (roughness, reference_mm) in [
        (measured(|_| 0.0), 4.00818047168e-5),
        (measured(run_out), 1.141394439e-4),
        (measured(wave), 2.70423300543e-4),
        (sine(1e-3, 0.1), 6.36291714971e-4),
        (sine(1e-3, 0.8), 3.18307349955e-4),
    ] {
        let ra_mm = roughness.ra_um / 1000.0;
        assert_eq!((roughness.profile_mm.len(), roughness.step_mm), (8000, 0.0005));
        assert!((ra_mm / reference_mm - 1.0).abs() < 2e-10, "{ra_mm} {reference_mm}");
    }
}

#[test]
fn the_parameters_of_a_sine_are_those_of_its_amplitude() {
    // Short against the cut-off, so that all but 3e-8 passes.
    let roughness = sine(1e-3, 0.16);
    assert!((roughness.ra_um / 0.6366197723675813 - 1.0).abs() < 2e-3);
    assert!((roughness.rq_um * 2.0_f64.sqrt() - 1.0).abs() < 2e-3);
    assert!((roughness.rz_um / 2.0 - 1.0).abs() < 2e-3);
}

#[test]
fn a_vibration_in_step_with_the_teeth_gives_no_roughness() {
    let still = measured(|_| 0.0);
    let shifted = measured(|_| 0.02);
    assert!((still.ra_um - shifted.ra_um).abs() < 1e-9);
    assert!(shifted.total_mm[0] > 0.02 - 1e-12);
}

#[test]
fn marks_that_do_not_cover_the_length_have_no_roughness() {
    let settings = ProfileSettings::default();
    assert_eq!(measure(&[], &BALL, 0.0, &settings), None);
    let far = [ProfileMark { x_mm: 100.0, z_mm: 0.0 }];
    assert_eq!(measure(&far, &BALL, 0.0, &settings), None);
    let broken = marks(|k| if k == 7 { f64::NAN } else { 0.0 });
    // A mark that is no number cuts nothing.
    assert!(measure(&broken, &BALL, 0.0, &settings).unwrap().ra_um.is_finite());
    for (short_um, long_mm) in [(25.0, 0.08), (0.5, 8.0), (25.0, 8.0)] {
        let settings = ProfileSettings { short_um, long_mm, ..ProfileSettings::default() };
        let flat = evaluate(&settings, |_, _, count| vec![1.0; count]).unwrap();
        assert!(flat.ra_um < 1e-9 && flat.profile_mm.len() <= 40_000);
    }
}

#[test]
fn a_flat_leaves_no_marks_and_a_corner_those_of_its_radius() {
    let settings = ProfileSettings::default();
    let square = Outline { diameter_mm: 16.0, corner_radius_mm: 0.0 };
    let even: Vec<ProfileMark> =
        (0..200).map(|k| ProfileMark { x_mm: 0.1 * f64::from(k), z_mm: 0.0 }).collect();
    let ra = |outline: &Outline| measure(&even, outline, 5.0, &settings).unwrap().ra_um;
    assert!(ra(&square) < 1e-12);
    // A flat of 0.02 mm about the tip leaves a feed of 0.06 mm to the corner of 8 mm.
    let narrow = Outline { diameter_mm: 16.04, corner_radius_mm: 8.0 };
    let peaks = ra(&narrow) / ra(&BALL);
    assert!(peaks > 0.1 && peaks < 0.6, "{peaks}");
}
