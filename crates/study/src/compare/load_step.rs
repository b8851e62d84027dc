//! The transient after a load step: how many control periods until the force is back within 10 %.
//!
//! The step is that between two sections of Experiment 2's fifth cut, each long enough to come to rest,
//! without noise; [`forces_n`] says how large it is. The paper's column of iterations is not defined; this
//! is one meaning that it can have.

use serde::Serialize;

use super::entrants::Entrant;
use super::outcome::{means, unstable};
use crate::base::language::text;
use crate::base::stats;
use crate::base::units::{mm_from_um, percent_from_ratio};
use crate::blocks::control::FeedSpeed;
use crate::models::mechanistic::{CK45, Cutter, Kienzle, StaticCut, static_peak};
use crate::run::edits::Edits;
use crate::run::one_run::Run;
use crate::run::scenario::Scenario;
use crate::run::signals::Row;

/// Length of each of the two sections, mm.
const SECTION_MM: f64 = 60.0;
/// The two sections: axial depth and wall, mm.
const SECTIONS: [[f64; 2]; 2] = [[2.6, 2.0], [3.5, 1.5]];
/// How far ahead of its axis the tool meets a step or leaves the part, mm: its largest contact
/// radius at these depths.
const AHEAD_MM: f64 = 6.7;
/// Half width of the band, as a fraction of the desired force.
const BAND: f64 = 0.1;
/// Means at the end that must lie in the band, a second of them: what still leaves it then is
/// never back.
const STEADY: usize = 50;

/// How an entrant took the step; forces as running means of four control samples, since run-out
/// makes one peak high and the next one low.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Transient {
    /// Its name.
    pub name: String,
    /// Control periods from leaving the band of 10 % to being back for good; none if it never is.
    pub periods: Option<usize>,
    /// Whether the loop is unstable in any stretch, as the run's story judges it.
    pub unstable: bool,
    /// Largest excursion above the desired force, percent.
    pub overshoot_percent: f64,
    /// Mean deviation from the desired force in the last second, percent.
    pub offset_percent: f64,
}

impl Transient {
    /// What is said in the place of a number of periods where there is none: nothing is, where it is unstable or
    /// rests outside the band.
    #[must_use]
    pub fn without_periods(&self) -> &'static str {
        if self.unstable { text!("unstable") } else { text!("never back") }
    }
}

/// The scenario of an entrant with the load step in the place of its part.
///
/// # Panics
/// Never: the sections are constants within their ranges, and no rule joins them.
#[must_use]
pub fn scenario(entrant: &Scenario) -> Scenario {
    let section = |[depth_mm, wall_mm]: [f64; 2]| [SECTION_MM, depth_mm, wall_mm];
    let stepped = entrant.with(|settings| {
        settings.workpiece.cuts = vec![SECTIONS.map(section).to_vec()];
        settings.noise.level = 0.0;
        settings.run.record_every = settings.run.steps_per_control;
    });
    stepped.expect("tested: the load step lies within the ranges")
}

/// Peak forces in N of the two sections as static cuts of the scenario's cutter, at its programmed feed and
/// speed, in Ck45.
#[must_use]
pub fn forces_n(scenario: &Scenario) -> [f64; 2] {
    let tool = &scenario.tool;
    let FeedSpeed { feed_mm_min, speed_rpm } = scenario.programmed(0);
    let cutter = Cutter::new(tool, mm_from_um(tool.runout_um), scenario.plant.slice_mm);
    let speed_m_min = tool.cutting_speed_m_min(speed_rpm);
    let law = Kienzle::new(&CK45, speed_m_min, tool.rake_deg, CK45.hardness_hb);
    SECTIONS.map(|[axial_depth_mm, wall_mm]| {
        let cut = StaticCut {
            feed_per_tooth_mm: tool.feed_per_tooth_mm(feed_mm_min, speed_rpm),
            axial_depth_mm,
            radial_depth_mm: cutter.radius_mm(axial_depth_mm) - wall_mm,
        };
        static_peak(&cutter, &law, &cut).fxy_n
    })
}

/// Takes an entrant through the load step.
#[must_use]
pub fn transient(entrant: &Entrant) -> Transient {
    judged(&entrant.name, &Run::complete(&scenario(&entrant.scenario), &Edits::none()))
}

/// What a finished run of [`scenario`] says about the entrant of this name.
#[must_use]
pub fn judged(name: &str, run: &Run) -> Transient {
    let recording = run.recording();
    let samples: Vec<&Row> = recording.samples(usize::MAX).collect();
    let length_mm = samples.last().map_or(0.0, |row| row.position_mm);
    let from_mm = length_mm - SECTION_MM - AHEAD_MM;
    let within = |row: &Row| row.position_mm >= from_mm && row.position_mm < length_mm - AHEAD_MM;
    let means: Vec<f64> = means(&samples)
        .into_iter()
        .filter(|(i, _)| within(samples[*i]))
        .map(|(_, mean)| mean)
        .collect();
    let tail = &means[means.len().saturating_sub(STEADY)..];
    let largest = means.iter().copied().fold(0.0, f64::max);
    Transient {
        name: name.to_owned(),
        periods: back_for_good(&means),
        unstable: !unstable(run).is_empty(),
        overshoot_percent: percent_from_ratio(largest - 1.0),
        offset_percent: percent_from_ratio(stats::mean(tail.iter().copied()).unwrap_or(0.0) - 1.0),
    }
}

fn back_for_good(means: &[f64]) -> Option<usize> {
    let outside = |mean: &f64| (mean - 1.0).abs() > BAND;
    let Some(first) = means.iter().position(outside) else { return Some(0) };
    let last = means.iter().rposition(outside)?;
    (last + STEADY < means.len()).then_some(last + 1 - first)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compare::{entrants, sections};

    #[test]
    fn the_step_is_that_of_the_sections_of_experiment_2() {
        for ([depth_mm, wall_mm], force_n) in
            SECTIONS.into_iter().zip(forces_n(&entrants::experiment_2()))
        {
            let same = |row: &&(u32, f64, f64, f64)| (row.1, row.2) == (depth_mm, wall_mm);
            let reference_n = sections::REFERENCE.iter().find(same).unwrap().3;
            assert!((force_n / reference_n - 1.0).abs() < 0.01, "{force_n} N of {reference_n} N");
        }
        let mut slow = entrants::experiment_2();
        slow.change(|settings| settings.program.feed_mm_min *= 0.5).unwrap();
        assert!(forces_n(&slow)[0] < 0.7 * forces_n(&entrants::experiment_2())[0]);
    }

    #[test]
    fn periods_are_counted_from_leaving_the_band_to_being_back_for_good() {
        let mut means = vec![1.0; 10];
        assert_eq!(back_for_good(&means), Some(0), "it never left");
        means.extend([1.2, 1.3, 1.05, 0.85, 0.95]);
        means.extend(vec![1.01; STEADY - 1]);
        assert_eq!(back_for_good(&means), Some(4));
        means.push(1.11);
        assert_eq!(back_for_good(&means), None, "it left the band at the end");
    }
}
