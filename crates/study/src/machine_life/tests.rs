use super::*;
use crate::models::tool::Tool;

/// The papers' cut.
fn scenario() -> Scenario {
    let mut scenario = Scenario::default();
    scenario
        .change(|s| {
            s.program.spindle_rpm = Tool::default().speed_rpm(80.0);
            s.program.feed_mm_min = 430.4;
            s.workpiece.axial_depth_mm = 2.0;
        })
        .unwrap();
    scenario
}

fn findings(change: impl Fn(&mut MachineTrend)) -> LifeFindings {
    let mut model = model(&scenario());
    change(&mut model);
    // Six minutes in place of four hours: 361 points.
    let mut job = LifeJob::new(model, 6.0);
    assert!(job.findings().is_none());
    while !job.advance_by(100) {}
    assert_eq!(job.progress().to_string(), "361 of 361 points of time");
    job.findings().unwrap()
}

#[test]
fn sound_and_roughness_go_together_as_in_the_reference() {
    for (exponent, r, difference) in [(1, 0.99908, 0.039), (0, 0.99990, 0.013), (2, 0.99881, 0.045)]
    {
        let findings = findings(|model| model.life.sound_exponent = exponent);
        assert!((findings.sound_roughness_r.unwrap() - r).abs() < 2e-5, "s = {exponent}");
        assert!((findings.largest_difference - difference).abs() < 6e-4, "s = {exponent}");
    }
}

#[test]
fn the_likeness_depends_on_how_the_tool_degrades() {
    let softer = findings(|model| model.wear.tooth_softening = 0.3);
    assert!((softer.sound_roughness_r.unwrap() - 0.9956).abs() < 3e-4);
    let stiff = findings(|model| model.wear.tooth_softening = 0.0);
    assert!(stiff.sound_vibration_r.unwrap() > 1.0 - 1e-12);
    let damped = findings(|model| model.wear.indentation_n_mm3 = 4e4);
    assert!((damped.sound_roughness_r.unwrap() - 0.983).abs() < 1e-3);
    let heavily = findings(|model| model.wear.indentation_n_mm3 = 1.5e5);
    assert!((heavily.sound_vibration_r.unwrap() - 0.29).abs() < 0.02);
}

#[test]
fn a_life_takes_a_point_a_second_and_slices_change_nothing() {
    let job = LifeJob::of(&scenario());
    // 0.13521 mm per tooth in place of the reference of 0.135: some 18 s less than four hours.
    let total = job.progress().total;
    assert!((total - 1.0 - 14_400.0 * libm::pow(0.135_214_147_8 / 0.135, -0.8)).abs() < 1.0);
    assert!((job.step_s() - 1.0).abs() < 1e-4);
    let mut whole = LifeJob::new(model(&scenario()), 0.5);
    let mut sliced = whole.clone();
    whole.to_end();
    while !sliced.advance_by(7) {}
    assert_eq!(whole.points(), sliced.points());
    let long = LifeJob::new(model(&scenario()), 1e7);
    assert!(long.progress().total <= 100_001.0 && long.step_s() > 1000.0);
}

#[test]
fn constant_series_have_no_correlation_and_proportional_ones_the_full() {
    assert_eq!(correlation(&[1.0, 2.0], &[3.0, 3.0]), None);
    assert_eq!(correlation(&[1.0, 2.0, 4.0], &[-2.0, -4.0, -8.0]), Some(-1.0));
}
