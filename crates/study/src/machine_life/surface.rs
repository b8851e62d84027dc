//! The surface that the machine leaves at a fraction of the tool's life: the paper's profile Y.
//!
//! Marks at the programmed feed with the random part of the vibration and the run-out; the periodic
//! vibration of the teeth is the same for all of them and leaves no roughness.

use crate::base::units::mm_from_um;
use crate::blocks::surface::profile::{ProfileStep, ToothMarks};
use crate::models::machine_trend::MachineTrend;
use crate::models::roughness_profile::{
    ProfileMark, ProfileSettings, Roughness, evaluation_mm, measure, run_up_mm,
};

/// Millimetres per metre.
const MM_PER_M: f64 = 1000.0;

/// The marks of a straight cut at the fraction `x` of the life, long enough to be measured from 0 on.
#[must_use]
pub fn marks(
    model: &MachineTrend,
    settings: &ProfileSettings,
    runout_um: f64,
    x: f64,
    seed: u64,
) -> Vec<ProfileMark> {
    let random_m = model.life.random_ratio * model.at(x).vibration_rms_m;
    let feed_mm = model.cut.feed_per_tooth_mm;
    if feed_mm <= 0.0 {
        // A tool that is not fed leaves no marks.
        return Vec::new();
    }
    let teeth = f64::from(model.tool.teeth);
    // Cusps beyond both ends too.
    let from_mm = -run_up_mm(settings) - 2.0 * teeth * feed_mm;
    let length_mm = evaluation_mm(settings) - 2.0 * from_mm;
    let mut cutter = ToothMarks::new(teeth as usize, mm_from_um(runout_um), from_mm, seed);
    let mut marks = Vec::new();
    for i in 1..=(length_mm / feed_mm).ceil() as u64 {
        let step = ProfileStep {
            turns: 1.0 / teeth,
            position_mm: from_mm + i as f64 * feed_mm,
            vibration_mm: 0.0,
            random_mm: settings.normal_share * MM_PER_M * random_m,
        };
        cutter.update(&step, |mark| marks.push(mark));
    }
    marks
}

/// The measured roughness at the fraction `x` of the life.
#[must_use]
pub fn surface(
    model: &MachineTrend,
    settings: &ProfileSettings,
    runout_um: f64,
    x: f64,
    seed: u64,
) -> Option<Roughness> {
    measure(&marks(model, settings, runout_um, x, seed), &model.tool.outline(), 0.0, settings)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine_life::model;
    use crate::models::roughness_trend::{cusp_mm, ra_um};
    use crate::run::scenario::Scenario;

    /// Mean Ra over some seeds over that of the closed form.
    fn ratio(long_mm: f64, x: f64) -> f64 {
        let model = model(&Scenario::default());
        let settings = ProfileSettings { long_mm, short_um: 25.0, ..ProfileSettings::default() };
        let seeds = (0..4).map(|seed| surface(&model, &settings, 0.0, x, seed).unwrap().ra_um);
        seeds.sum::<f64>() / 4.0 / model.at(x).ra_um
    }

    #[test]
    fn the_profile_agrees_with_the_closed_form_but_for_what_the_filter_takes() {
        for x in [0.0, 1.0] {
            let whole = ratio(8.0, x);
            assert!((0.9..1.03).contains(&whole), "x = {x}: {whole}");
            // Teeth 0.14 mm apart that differ at random make long waves too: a cut-off of 0.8 mm
            // takes a third of them.
            let filtered = ratio(0.8, x);
            assert!((0.55..0.8).contains(&filtered), "x = {x}: {filtered}");
        }
    }

    #[test]
    fn the_marks_stand_as_far_apart_as_the_feed_is_however_small_and_none_without() {
        let mut model = model(&Scenario::default());
        let settings = ProfileSettings::default();
        for feed_mm in [0.1, 1e-3, 2e-4] {
            model.cut.feed_per_tooth_mm = feed_mm;
            let marks = marks(&model, &settings, 0.0, 0.5, 1);
            let apart = marks.windows(2).all(|pair| {
                let [a, b] = [pair[0].x_mm, pair[1].x_mm];
                ((b - a) / feed_mm - 1.0).abs() < 1e-6
            });
            assert!(apart && marks.len() > 40, "{feed_mm}: {}", marks.len());
        }
        model.cut.feed_per_tooth_mm = 0.0;
        assert!(marks(&model, &settings, 0.0, 0.5, 1).is_empty());
        assert!(surface(&model, &settings, 0.0, 0.5, 1).is_none(), "no contact");
    }

    #[test]
    fn a_steady_machine_leaves_the_cusps_and_run_out_raises_them() {
        let mut model = model(&Scenario::default());
        model.life.random_ratio = 0.0;
        let settings = ProfileSettings::default();
        let ra = |runout_um| surface(&model, &settings, runout_um, 0.5, 1).unwrap().ra_um;
        let cusps =
            ra_um(1000.0 * cusp_mm(model.cut.feed_per_tooth_mm, &model.tool.outline()), 0.0);
        assert!((ra(0.0) / cusps - 1.0).abs() < 0.02, "{} {cusps}", ra(0.0));
        // One tooth of two no longer cuts: twice the feed, four times the height.
        assert!((ra(50.0) / (4.0 * cusps) - 1.0).abs() < 0.02);
    }
}
