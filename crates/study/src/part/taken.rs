//! From a path to the settings of a scenario.

use super::path::PartPath;
use crate::base::language::tr;
use crate::base::settings::{Kind, Value};
use crate::models::part::{DepthStep, MAX_STEPS};
use crate::run::scenario::{Scenario, param};

/// Largest differences of depth that are taken for one depth, mm: none first, then as small as lets the part fit.
const SAME_MM: [f64; 10] = [0.0, 0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5];
/// How many times as long as at the programmed feed a run may take, and time for its start, s (chosen).
const SLOWER: f64 = 2.0;
const START_S: f64 = 5.0;
/// Rows above which one is recorded per control period: a page holds a million.
const MANY_ROWS: f64 = 500_000.0;

/// A path as settings.
#[derive(Clone, Debug, PartialEq)]
pub struct TakenPart {
    /// The settings, to be set together.
    pub changes: Vec<(String, Value)>,
    /// What came with it, in sentences.
    pub told: Vec<String>,
}

/// Neighbouring stretches that are taken for one.
struct Joined {
    from_mm: f64,
    /// Their least and largest depth, mm.
    range_mm: [f64; 2],
    /// Their length, mm, and the area below their depth, mm^2.
    length_mm: f64,
    area_mm2: f64,
}

impl Joined {
    fn depth_mm(&self) -> f64 {
        let [low, high] = self.range_mm;
        if low == high { low } else { self.area_mm2 / self.length_mm }
    }

    /// Whether it takes a stretch of another depth in.
    fn takes(&mut self, depth_mm: f64, length_mm: f64, same_mm: f64) -> bool {
        let [low, high] = [self.range_mm[0].min(depth_mm), self.range_mm[1].max(depth_mm)];
        // Air is told from the lightest cut.
        let fits = high - low <= same_mm && (self.range_mm[0] == 0.0) == (depth_mm == 0.0);
        if fits {
            self.range_mm = [low, high];
            self.length_mm += length_mm;
            self.area_mm2 += depth_mm * length_mm;
        }
        fits
    }
}

/// The profile of stretches, each with its end, whose depths change at the same places or fewer.
fn merged(steps: &[(DepthStep, f64)], same_mm: f64) -> Vec<DepthStep> {
    let mut joined: Vec<Joined> = Vec::new();
    for ([from_mm, depth_mm], end_mm) in steps.iter().copied() {
        let length_mm = end_mm - from_mm;
        if joined.last_mut().is_some_and(|last| last.takes(depth_mm, length_mm, same_mm)) {
            continue;
        }
        let area_mm2 = depth_mm * length_mm;
        joined.push(Joined { from_mm, range_mm: [depth_mm; 2], length_mm, area_mm2 });
    }
    joined.iter().map(|one| [one.from_mm, one.depth_mm()]).collect()
}

impl PartPath {
    /// The profiles of the axial and the radial depth with the fewest differences taken for none that let them fit, and
    /// that difference, mm; none where none does.
    fn profiles(&self) -> Option<([Vec<DepthStep>; 2], f64)> {
        let mut radial_mm = self.stretches.iter().map(|[_, _, radial]| *radial).find(|x| *x > 0.0);
        let ends = self.stretches.iter().zip(self.ends_mm());
        let both = ends.map(|([from, axial, radial], end)| {
            let is_cut = *axial > 0.0 && *radial > 0.0;
            // In the air the width of the last cut goes on.
            if is_cut {
                radial_mm = Some(*radial);
            }
            let axial_mm = if is_cut { *axial } else { 0.0 };
            (([*from, axial_mm], end), ([*from, radial_mm.unwrap_or(*radial)], end))
        });
        let (axial, radial): (Vec<_>, Vec<_>) = both.unzip();
        SAME_MM.iter().find_map(|same_mm| {
            let profiles = [merged(&axial, *same_mm), merged(&radial, *same_mm)];
            profiles.iter().all(|steps| steps.len() <= MAX_STEPS).then_some((profiles, *same_mm))
        })
    }

    /// The path as the part of a scenario: its length, the profiles of its depths, no cuts, and time enough for the run.
    ///
    /// # Errors
    /// It changes more often than a scenario can hold.
    pub fn to_scenario(&self, scenario: &Scenario) -> Result<TakenPart, String> {
        let Some(([axial, radial], same_mm)) = self.profiles() else {
            return Err(tr!(
                "the depths change at {n} places: allowed are {most}, with differences up to {same} mm taken for none; \
                 a larger step or a part of the path has fewer",
                n = self.stretches.len(),
                most = MAX_STEPS,
                same = SAME_MM[SAME_MM.len() - 1]
            ));
        };
        let mut told = self.remarks.clone();
        if same_mm > 0.0 {
            told.push(tr!(
                "Differences of depth up to {same} mm are taken for none, so that the part fits into a scenario.",
                same = same_mm
            ));
        }
        let start = |steps: &[DepthStep]| steps.first().map_or(0.0, |step| step[1]);
        let mut changes = vec![
            ("workpiece.cuts".to_owned(), Value::List(Vec::new())),
            ("workpiece.length_mm".to_owned(), Value::Float(self.length_mm)),
            ("workpiece.axial_depth_mm".to_owned(), Value::Float(start(&axial))),
            ("workpiece.radial_depth_mm".to_owned(), Value::Float(start(&radial))),
            ("workpiece.depth_steps".to_owned(), Value::from(axial[1.min(axial.len())..].to_vec())),
            // Its first step too: so the wall follows the axial depth, and every stretch has its width.
            ("workpiece.radial_steps".to_owned(), Value::from(radial)),
        ];
        self.time(scenario, &mut changes, &mut told);
        self.feed(scenario, &mut told);
        Ok(TakenPart { changes, told })
    }

    /// Time for the way, and rows that fit into memory.
    fn time(
        &self,
        scenario: &Scenario,
        changes: &mut Vec<(String, Value)>,
        told: &mut Vec<String>,
    ) {
        let feed_mm_s = scenario.program.feed_mm_min / 60.0;
        let wanted_s = (SLOWER * self.length_mm / feed_mm_s + START_S).ceil();
        let most_s = longest_s();
        let time_s = wanted_s.min(most_s);
        if scenario.run.duration_s >= time_s {
            return;
        }
        changes.push(("run.duration_s".to_owned(), Value::Float(time_s)));
        told.push(tr!(
            "The time limit is {time} s now (`run.duration_s`), twice what the path takes at the programmed feed.",
            time = time_s
        ));
        if wanted_s > most_s {
            told.push(tr!(
                "It would take {wanted} s; a run has {most} s at most, and may end before the path does.",
                wanted = wanted_s,
                most = most_s
            ));
        }
        let rows = time_s / (scenario.dt_s() * f64::from(scenario.run.record_every));
        if rows > MANY_ROWS {
            let every = scenario.run.steps_per_control;
            changes.push(("run.record_every".to_owned(), Value::Int(i64::from(every))));
            told.push(
                tr("One row is recorded per control period (`run.record_every`): the run is long.")
                    .to_owned(),
            );
        }
    }

    /// That the file programs another feed than the scenario.
    fn feed(&self, scenario: &Scenario, told: &mut Vec<String>) {
        let feed = scenario.program.feed_mm_min;
        if let Some([low, high]) = self.feeds_mm_min
            && [low, high] != [feed, feed]
        {
            told.push(tr!(
                "The file programs feeds from {low} to {high} mm/min; the run programs {feed} mm/min \
                 (`program.feed_mm_min`).",
                low = low,
                high = high,
                feed = feed
            ));
        }
        let speed = scenario.program.spindle_rpm;
        if let Some([low, high]) = self.speeds_rpm
            && [low, high] != [speed, speed]
        {
            told.push(tr!(
                "The file programs speeds from {low} to {high} 1/min; the run programs {speed} 1/min \
                 (`program.spindle_rpm`).",
                low = low,
                high = high,
                speed = speed
            ));
        }
    }
}

/// The longest time limit of a run, s.
fn longest_s() -> f64 {
    match param("run.duration_s").map(|param| &param.spec.allowed) {
        Ok(Kind::Float { max, .. }) => *max,
        Ok(
            Kind::Int { .. }
            | Kind::Bool
            | Kind::Choice { .. }
            | Kind::Text { .. }
            | Kind::Structured(_),
        )
        | Err(_) => f64::INFINITY,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stretches_of_one_depth_become_one_and_keep_their_area() {
        let steps = [([0.0, 2.0], 1.0), ([1.0, 2.0], 2.0), ([2.0, 2.1], 4.0), ([4.0, 0.0], 5.0)];
        assert_eq!(merged(&steps, 0.0), [[0.0, 2.0], [2.0, 2.1], [4.0, 0.0]]);
        let joined = merged(&steps, 0.11);
        assert_eq!(joined.len(), 2);
        assert!((joined[0][1] * 4.0 - (2.0 * 2.0 + 2.1 * 2.0)).abs() < 1e-12, "{joined:?}");
        assert_eq!(joined[1], [4.0, 0.0], "air stays air");
        assert_eq!(merged(&[([0.0, 0.005], 1.0), ([1.0, 0.0], 2.0)], 0.01).len(), 2);
    }
}
