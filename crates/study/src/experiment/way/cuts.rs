//! The plan of the cuts: a line for K2 and K3, a Latin hypercube for K4.

use super::super::design::{RunRole, hypercube};
use super::super::factor::{ExperimentFactor, FactorKind, FactorSpan};
use super::super::plan::ExperimentPlan;

/// Of three cuts, so many lie on the line.
const THIRD: usize = 3;

/// The plan of `cuts` cuts over ranges of feed in mm/min and speed in 1/min. The first third lies evenly on the line
/// from least feed and largest speed to largest feed and least speed.
#[must_use]
pub fn plan(cuts: usize, feeds: [f64; 2], speeds: [f64; 2], seed: u64) -> ExperimentPlan {
    let factor =
        |kind, range| ExperimentFactor { kind, span: FactorSpan::Range(range), levels: None };
    let factors = vec![factor(FactorKind::Feed, feeds), factor(FactorKind::Speed, speeds)];
    let on_line = cuts / THIRD;
    let last = on_line.saturating_sub(1).max(1) as f64;
    let line = (0..on_line).map(|place| {
        let x = 2.0 * place as f64 / last - 1.0;
        (vec![factors[0].value(x), factors[1].value(-x)], RunRole::Line)
    });
    let beside = hypercube(cuts - on_line, 2, seed).into_iter().map(|point| {
        let values = factors.iter().zip(&point.coded).map(|(factor, x)| factor.value(*x));
        (values.collect(), point.role)
    });
    let runs = line.chain(beside).collect();
    ExperimentPlan::of(factors, runs, None, seed)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::stats;
    use crate::experiment::factor::PAPERS_BOX;
    use crate::published::PaperId;

    /// K2 and K3 are derived on the papers' own line.
    #[test]
    fn the_line_of_the_papers_box_goes_through_the_final_values_of_table_3() {
        let [[low, high], [slow, fast]] = PAPERS_BOX;
        for row in PaperId::Sdnrp2007.rows() {
            let share = (row.feed_final_mm_min - low) / (high - low);
            let speed = fast - share * (fast - slow);
            let off = speed / row.spindle_final_rpm - 1.0;
            // The speed printed in row 8 is below the line of all others.
            let most = if row.sim == 8 { 0.051 } else { 0.021 };
            assert!(off.abs() < most, "simulation {}: {off}", row.sim);
        }
    }

    #[test]
    fn a_third_lies_on_the_line_and_the_rest_tells_feed_from_speed() {
        let [feeds, speeds] = PAPERS_BOX;
        let plan = plan(185, feeds, speeds, 1);
        let column = |place: usize, role: RunRole| -> Vec<f64> {
            let runs = plan.runs.iter().filter(|run| run.role == role);
            runs.map(|run| run.values[place]).collect()
        };
        let r = |role| stats::correlation(&column(0, role), &column(1, role)).unwrap();
        assert_eq!(column(0, RunRole::Line).len(), 61);
        assert_eq!(column(0, RunRole::Hypercube).len(), 124);
        assert!(r(RunRole::Line) < -0.9999 && r(RunRole::Hypercube).abs() < 0.1);
    }
}
