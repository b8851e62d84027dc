//! The marks that the teeth leave: every tooth at the instant when it makes the surface.
//!
//! ```text
//! t_k: tooth k passes;  x_k = position,  z_k = e_(k mod N) + gamma_n u(t_k) + sigma N(0, 1)
//! ```
//!
//! e is the run-out, u the vibration between tooth and work, sigma its random part. The profile is
//! the envelope of the marks ([`crate::models::roughness_profile`]).

use crate::base::rng::Stream;
use crate::models::roughness_profile::ProfileMark;
use crate::models::tool::runout_share;

/// Counts the teeth that come past.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Passing {
    tooth: u64,
    /// Fraction of the way to the next tooth's instant.
    phase: f64,
}

impl Passing {
    /// Advances by `teeth` tooth passings in a step; `each` gets, for every tooth whose instant lies in
    /// it, its number from 0 and the fraction of the step that has passed by then.
    pub fn advance(&mut self, teeth: f64, mut each: impl FnMut(u64, f64)) {
        let before = self.phase;
        self.phase += teeth;
        let mut at = 1.0;
        while at <= self.phase {
            each(self.tooth, (at - before) / teeth);
            self.tooth += 1;
            at += 1.0;
        }
        self.phase -= at - 1.0;
    }

    /// Teeth so far, with the fraction of the next one.
    #[must_use]
    pub fn teeth(&self) -> f64 {
        self.tooth as f64 + self.phase
    }
}

/// One step of the cut.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProfileStep {
    /// Turns of the spindle in the step.
    pub turns: f64,
    /// Position along the feed at its end, mm.
    pub position_mm: f64,
    /// Vibration normal to the surface at its end, positive away from the work, mm.
    pub vibration_mm: f64,
    /// Deviation of the random part, mm.
    pub random_mm: f64,
}

/// The turning cutter, as far as it leaves marks.
#[derive(Clone, Debug)]
pub struct ToothMarks {
    /// Run-out: how far each tooth stands back, mm.
    stands_back_mm: Vec<f64>,
    random: Stream,
    passing: Passing,
    last: ProfileStep,
}

impl ToothMarks {
    /// The cutter before its first tooth, at `position_mm`, with `teeth` teeth (at least one) that stand
    /// back by up to `runout_mm`: the second of two, the one opposite the first of an even number
    /// ([`runout_share`]).
    #[must_use]
    pub fn new(teeth: usize, runout_mm: f64, position_mm: f64, seed: u64) -> Self {
        let teeth = teeth.max(1);
        let back = |tooth: usize| 0.5 * runout_mm * (1.0 - runout_share(tooth, teeth));
        Self {
            stands_back_mm: (0..teeth).map(back).collect(),
            random: Stream::new(seed, "surface.marks"),
            passing: Passing::default(),
            last: ProfileStep { turns: 0.0, position_mm, vibration_mm: 0.0, random_mm: 0.0 },
        }
    }

    /// Advances by a step; `leave` gets the marks of the teeth that pass in it, first to last.
    pub fn update(&mut self, step: &ProfileStep, mut leave: impl FnMut(ProfileMark)) {
        let Self { stands_back_mm, random, passing, last } = self;
        let teeth = stands_back_mm.len();
        passing.advance(step.turns * teeth as f64, |tooth, fraction| {
            // Between the ends of the step position and vibration are lines.
            let between = |from: f64, to: f64| from + fraction * (to - from);
            let back = stands_back_mm[(tooth % teeth as u64) as usize];
            leave(ProfileMark {
                x_mm: between(last.position_mm, step.position_mm),
                z_mm: back
                    + between(last.vibration_mm, step.vibration_mm)
                    + step.random_mm * random.normal(tooth),
            });
        });
        self.last = *step;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::math;

    /// Marks of a second at 1600 1/min with two teeth, 8 mm/s, in steps of `dt_s`.
    fn cut(dt_s: f64, runout_mm: f64, vibration: impl Fn(f64) -> f64) -> Vec<ProfileMark> {
        let mut cutter = ToothMarks::new(2, runout_mm, 0.0, 1);
        let mut marks = Vec::new();
        for i in 1..=(1.0 / dt_s).round() as u32 {
            let time_s = f64::from(i) * dt_s;
            let step = ProfileStep {
                turns: dt_s * 1600.0 / 60.0,
                position_mm: 8.0 * time_s,
                vibration_mm: vibration(time_s),
                random_mm: 0.0,
            };
            cutter.update(&step, |mark| marks.push(mark));
        }
        marks
    }

    #[test]
    fn teeth_leave_marks_a_feed_per_tooth_apart_whatever_the_step() {
        for dt_s in [1e-4, 1e-3, 0.02, 0.1] {
            let marks = cut(dt_s, 0.003, |_| 0.0);
            assert!(marks.len().abs_diff(53) <= 1, "{dt_s}: {}", marks.len());
            for pair in marks.windows(2) {
                assert!((pair[1].x_mm - pair[0].x_mm - 0.15).abs() < 1e-9);
                assert!((pair[1].z_mm - pair[0].z_mm).abs() == 0.003);
            }
        }
    }

    #[test]
    fn a_vibration_at_the_tooth_passing_frequency_marks_all_teeth_alike() {
        let passing_hz = 2.0 * 1600.0 / 60.0;
        let in_step = cut(1e-4, 0.0, |t| 0.01 * math::cos(math::TAU * passing_hz * t));
        let beside = cut(1e-4, 0.0, |t| 0.01 * math::cos(math::TAU * 1.3 * passing_hz * t));
        let spread = |marks: &[ProfileMark]| {
            let [low, high] = math::extent(marks.iter().map(|mark| mark.z_mm));
            high - low
        };
        assert!(spread(&in_step) < 1e-5 && spread(&beside) > 0.015);
    }

    #[test]
    fn the_random_part_has_its_deviation() {
        let mut cutter = ToothMarks::new(2, 0.0, 0.0, 3);
        let mut heights = Vec::new();
        for i in 0..4000 {
            let position_mm = 0.1 * f64::from(i);
            let step = ProfileStep { turns: 0.5, position_mm, vibration_mm: 0.0, random_mm: 0.002 };
            cutter.update(&step, |mark| heights.push(mark.z_mm));
        }
        let squares: f64 = heights.iter().map(|z| z * z).sum();
        assert!(((squares / 4000.0).sqrt() / 0.002 - 1.0).abs() < 0.05);
    }
}
