//! What the vibration adds to the roughness of the surface behind the tool.
//!
//! ```text
//! added Ra = Ra_profile(u_k, run-out) - Ra_profile(0)
//! ```
//!
//! over the last evaluation length, measured again each time the tool has cut a sampling length more.
//! Both profiles have the same places of the teeth; in the second one every tooth leaves the ideal
//! surface. The only random part is the dynamic component of the force, which acts on u_k: no further
//! noise is added.

use super::profile::{ProfileStep, ToothMarks};
use crate::models::roughness_profile::{
    ProfileMark, ProfileSettings, evaluation_mm, measure, run_up_mm,
};
use crate::models::tool::Outline;

/// Least cut-off against short waves here, um: teeth leave marks further apart, and a profile with points
/// for them alone is measured twenty times as fast, Ra within some 2 %.
const SHORT_UM: f64 = 50.0;
/// Most marks that are kept; a feed that leaves more to an evaluation length leaves no cusps to measure.
const MARKS: usize = 4096;

/// The surface behind the tool.
#[derive(Clone, Debug)]
pub struct Finish {
    settings: ProfileSettings,
    outline: Outline,
    teeth: ToothMarks,
    marks: Vec<ProfileMark>,
    measured_mm: f64,
    added_um: f64,
}

impl Finish {
    /// The surface of a cutter with `teeth` teeth that stand back by at most `runout_mm`.
    #[must_use]
    pub fn new(settings: &ProfileSettings, outline: Outline, teeth: usize, runout_mm: f64) -> Self {
        let mut finish = Self {
            settings: settings.clone(),
            outline,
            teeth: ToothMarks::new(teeth, runout_mm, 0.0, 0),
            marks: Vec::with_capacity(2 * MARKS),
            measured_mm: 0.0,
            added_um: 0.0,
        };
        finish.reconfigure(settings);
        finish
    }

    /// Takes over changed settings.
    pub fn reconfigure(&mut self, settings: &ProfileSettings) {
        self.settings = settings.clone();
        self.settings.short_um = self.settings.short_um.max(SHORT_UM);
    }

    /// Discards the surface: the tool is in the air, or a new cut begins.
    pub fn clear(&mut self) {
        self.marks.clear();
        self.added_um = 0.0;
    }

    /// One machine step: turns of the spindle, position at its end in mm and displacement off the work
    /// in m.
    #[inline]
    pub fn update(&mut self, turns: f64, position_mm: f64, displacement_m: f64, in_cut: bool) {
        let step = ProfileStep {
            turns,
            position_mm,
            vibration_mm: 1000.0 * self.settings.normal_share * displacement_m,
            random_mm: 0.0,
        };
        let marks = &mut self.marks;
        self.teeth.update(&step, |mark| {
            if in_cut {
                marks.push(mark);
            }
        });
        if self.marks.len() == 1 {
            self.measured_mm = self.marks[0].x_mm;
        }
        if self.marks.len() >= 2 * MARKS {
            self.marks.drain(..MARKS);
        }
        if position_mm - self.measured_mm >= self.settings.long_mm {
            self.measured_mm = position_mm;
            self.measure();
        }
    }

    fn measure(&mut self) {
        let (Some(first), Some(last)) = (self.marks.first(), self.marks.last()) else { return };
        let run_up_mm = run_up_mm(&self.settings);
        let from_mm = last.x_mm - run_up_mm - evaluation_mm(&self.settings);
        if first.x_mm > from_mm - run_up_mm {
            return;
        }
        let ra = |marks: &[ProfileMark]| {
            measure(marks, &self.outline, from_mm, &self.settings).map(|rough| rough.ra_um)
        };
        let ideal: Vec<ProfileMark> =
            self.marks.iter().map(|mark| ProfileMark { z_mm: 0.0, ..*mark }).collect();
        if let Some((ra_um, ideal_um)) = ra(&self.marks).zip(ra(&ideal)) {
            self.added_um = ra_um - ideal_um;
        }
        // The end reaches its radius to each side.
        let reach_mm = from_mm - run_up_mm - self.outline.edge_mm();
        let gone = self.marks.partition_point(|mark| mark.x_mm < reach_mm);
        self.marks.drain(..gone);
    }

    /// What vibration and run-out add to Ra over the last evaluation length, um; 0 before the first one
    /// is cut.
    #[must_use]
    pub fn added_um(&self) -> f64 {
        self.added_um
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::math;

    /// A cut of 12 mm with 0.1 mm to the tooth; each tooth's displacement in mm.
    fn cut(runout_mm: f64, of_tooth: impl Fn(f64) -> f64) -> Finish {
        let mut finish = Finish::new(&ProfileSettings::default(), Outline::ball(8.0), 2, runout_mm);
        for tooth in 1..=120 {
            let tooth = f64::from(tooth);
            finish.update(0.5, 0.1 * tooth, 1e-3 * of_tooth(tooth), true);
        }
        finish
    }

    #[test]
    fn a_vibration_in_step_with_the_teeth_adds_nothing() {
        assert!(cut(0.0, |_| 0.02).added_um().abs() < 1e-9);
    }

    #[test]
    fn vibration_and_run_out_add_what_the_references_say() {
        // Ra of cusps 0.0401 um; 0.27069 um with 1 um sin(2 pi k 0.38197), 0.1141 with 0.3 um run-out.
        let turn = 0.381_966_011_250_105_1;
        let chatter = cut(0.0, |tooth| 0.001 * math::sin(math::TAU * turn * tooth)).added_um();
        assert!((chatter / (0.2707 - 0.0401) - 1.0).abs() < 0.05, "{chatter}");
        let runout = cut(3e-4, |_| 0.0).added_um();
        assert!((runout / (0.1141 - 0.0401) - 1.0).abs() < 0.05, "{runout}");
    }

    #[test]
    fn vibration_along_the_surface_leaves_no_mark() {
        let settings = ProfileSettings { normal_share: 0.0, ..ProfileSettings::default() };
        let mut finish = Finish::new(&settings, Outline::ball(8.0), 2, 0.0);
        for tooth in 1..=120 {
            let tooth = f64::from(tooth);
            finish.update(0.5, 0.1 * tooth, 1e-6 * math::sin(2.4 * tooth), true);
        }
        assert!(finish.measured_mm > 8.0 && finish.added_um().abs() < 1e-9, "{finish:?}");
    }

    #[test]
    fn the_air_leaves_nothing_and_neither_does_a_standing_tool() {
        let mut finish = cut(0.0, |tooth| 1e-3 * (tooth % 2.0));
        assert!(finish.added_um() > 0.0);
        finish.clear();
        (0..40_000).for_each(|_| finish.update(0.5, 12.0, 1e-6, true));
        assert_eq!(finish.added_um(), 0.0);
        assert!(finish.marks.len() < 2 * MARKS);
    }
}
