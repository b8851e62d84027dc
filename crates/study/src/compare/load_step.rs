//! The transient after a load step: how many control periods until the force is back within 10 %.
//!
//! The step is that of Experiment 2 from a section of 493 N into the one of 772 N of its fifth cut
//! (forces at 100 % override), each long enough to come to rest, without noise. The paper's column
//! of iterations is not defined; this is one meaning that it can have.

use serde::Serialize;

use super::entrants::Entrant;
use super::outcome::means;
use crate::base::stats;
use crate::base::units::percent_from_ratio;
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
/// never steady.
const STEADY: usize = 50;

/// How an entrant took the step; forces as running means of four control samples, since run-out
/// makes one peak high and the next one low.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Transient {
    /// Its name.
    pub name: String,
    /// Control periods from leaving the band of 10 % to being back for good; none if it is never
    /// steady.
    pub periods: Option<usize>,
    /// Largest excursion above the desired force, percent.
    pub overshoot_percent: f64,
    /// Mean deviation from the desired force in the last second, percent.
    pub offset_percent: f64,
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

/// Takes an entrant through the load step.
#[must_use]
pub fn transient(entrant: &Entrant) -> Transient {
    judged(&entrant.name, &Run::complete(&scenario(&entrant.scenario), &Edits::none()))
}

/// What a finished run of [`scenario`] says about the entrant of this name.
#[must_use]
pub fn judged(name: &str, run: &Run) -> Transient {
    let recording = run.recording();
    let samples: Vec<&Row> = recording.rows().iter().step_by(recording.control_stride()).collect();
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
