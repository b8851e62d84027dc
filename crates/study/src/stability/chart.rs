//! The stability chart over the speed, as a job: its points are independent, each with its curves
//! one after the other.

use serde::Serialize;

use super::charted::ChartedCut;
use crate::base::language::text;
use crate::base::settings::SettingError;
use crate::run::job::{Budget, Job, Progress};
use crate::run::parts::{Making, Parts};
use crate::run::scenario::Scenario;

/// Step of the time simulation, s: that of the running cut.
pub const DT_S: f64 = 1e-4;
/// Largest difference between chart and time simulation that passes as agreement, percent.
pub const BAND_PERCENT: f64 = 5.0;

/// What to chart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// Lowest speed, 1/min.
    pub from_rpm: f64,
    /// Highest speed, 1/min.
    pub to_rpm: f64,
    /// Number of speeds, evenly spaced; at least 1.
    pub speeds: u32,
    /// Greatest depth that is looked at, mm.
    pub highest_mm: f64,
    /// Whether the time simulation is asked as well.
    pub simulate: bool,
}

/// Limits at one speed in mm; `None` where no depth up to the greatest chatters, or where it was
/// not asked for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct LobePoint {
    /// Speed, 1/min.
    pub speed_rpm: f64,
    /// The lobes: mean number of teeth.
    pub mean_mm: Option<f64>,
    /// Chatter frequency of the lobes' limit, Hz.
    pub mean_chatter_hz: Option<f64>,
    /// The interrupted cut, by semi-discretisation.
    pub interrupted_mm: Option<f64>,
    /// The time simulation with the mean number of teeth.
    pub simulated_mean_mm: Option<f64>,
    /// The time simulation with teeth that come and go.
    pub simulated_interrupted_mm: Option<f64>,
    /// Where the two differ: the interrupted cut's limit nearest to the simulation's at a speed
    /// 0.5 % beside this one. The limit jumps at the tip of an island of instability.
    pub interrupted_beside_mm: Option<f64>,
}

/// Distance in speed at which a jump of the limit is looked for, as a fraction.
const BESIDE: f64 = 0.005;

fn percent(simulated: Option<f64>, chart: Option<f64>) -> Option<f64> {
    simulated.zip(chart).map(|(simulated, chart)| 100.0 * (simulated / chart - 1.0))
}

/// Whether both have no limit, or limits within the band.
fn agree(simulated: Option<f64>, chart: Option<f64>) -> bool {
    match percent(simulated, chart) {
        Some(percent) => percent.abs() <= BAND_PERCENT,
        None => simulated.is_none() && chart.is_none(),
    }
}

impl LobePoint {
    /// Whether the time simulation gives the charts' limits within the band, a jump's two sides
    /// both counting; the lobes count where the mean cut is simulated.
    #[must_use]
    pub fn agrees(&self, cut: &ChartedCut) -> bool {
        let simulated = self.simulated_interrupted_mm;
        (!cut.simulates_mean() || agree(self.simulated_mean_mm, self.mean_mm))
            && (agree(simulated, self.interrupted_mm) || self.interrupted_beside_mm.is_some())
    }

    /// Simulation over chart - 1 in percent, for the mean and for the interrupted cut.
    #[must_use]
    pub fn differences_percent(&self) -> [Option<f64>; 2] {
        [
            percent(self.simulated_mean_mm, self.mean_mm),
            percent(self.simulated_interrupted_mm, self.interrupted_mm),
        ]
    }
}

/// The chart in the making.
#[derive(Clone, Debug)]
pub struct ChartJob {
    cut: ChartedCut,
    range: Range,
    any_speed_mm: f64,
    points: Parts<PointJob, LobePoint>,
}

/// One speed in the making: a step is a curve.
#[derive(Clone, Debug)]
struct PointJob {
    cut: ChartedCut,
    range: Range,
    point: LobePoint,
    /// Curves that are done.
    curves: u32,
}

impl ChartJob {
    /// A chart of the scenario's machine, not yet begun.
    ///
    /// # Errors
    /// As [`ChartedCut::new`].
    pub fn new(scenario: &Scenario, range: Range) -> Result<Self, SettingError> {
        let cut = ChartedCut::new(scenario)?;
        let any_speed_mm = cut.any_speed_mm();
        Ok(Self { cut, range, any_speed_mm, points: Parts::default() })
    }

    /// The points so far; the last one may lack curves.
    #[must_use]
    pub fn points(&self) -> Vec<LobePoint> {
        let under_way = self.points.next_under_way().map(|job| job.point);
        self.points.done().iter().copied().chain(under_way).collect()
    }

    /// Depth in mm that is stable at every speed, by the lobes.
    #[must_use]
    pub fn any_speed_mm(&self) -> f64 {
        self.any_speed_mm
    }

    /// The cut that is charted.
    #[must_use]
    pub fn cut(&self) -> &ChartedCut {
        &self.cut
    }
}

impl Range {
    fn curves_per_point(&self) -> u32 {
        if self.simulate { 4 } else { 2 }
    }

    fn count(&self) -> usize {
        self.speeds.max(1) as usize
    }

    fn speed_rpm(&self, index: usize) -> f64 {
        let share = index as f64 / f64::from(self.speeds.max(2) - 1);
        self.from_rpm + (self.to_rpm - self.from_rpm) * share
    }
}

impl PointJob {
    fn curve(&mut self) {
        let (cut, highest_mm) = (&self.cut, self.range.highest_mm);
        let point = &mut self.point;
        let speed = point.speed_rpm;
        match self.curves {
            0 => {
                if let Some([depth, frequency_hz]) = cut.lobe(speed) {
                    point.mean_mm = Some(depth).filter(|depth| *depth < highest_mm);
                    point.mean_chatter_hz = point.mean_mm.map(|_| frequency_hz);
                }
            }
            1 => point.interrupted_mm = cut.interrupted_mm(speed, highest_mm),
            2 => point.simulated_mean_mm = cut.simulated_mean_mm(speed, highest_mm),
            _ => {
                let simulated = cut.simulated_mm(speed, highest_mm);
                point.simulated_interrupted_mm = simulated;
                if !agree(simulated, point.interrupted_mm) {
                    let beside = [1.0 - BESIDE, 1.0 + BESIDE];
                    let beside = beside.map(|x| cut.interrupted_mm(x * speed, highest_mm));
                    point.interrupted_beside_mm =
                        beside.into_iter().find(|limit| agree(simulated, *limit)).flatten();
                }
            }
        }
        self.curves += 1;
    }
}

impl Job for PointJob {
    type Partial = LobePoint;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        while self.curves < self.range.curves_per_point() && budget.step() {
            self.curve();
        }
        self.curves >= self.range.curves_per_point()
    }

    fn progress(&self) -> Progress {
        let total = f64::from(self.range.curves_per_point());
        Progress { done: f64::from(self.curves), total, unit: text!("curves") }
    }

    fn partial(&self) -> LobePoint {
        self.point
    }
}

/// A step is a curve at one speed.
impl Job for ChartJob {
    type Partial = Vec<LobePoint>;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        let (cut, range) = (&self.cut, self.range);
        let begin = |index: usize| {
            let point = LobePoint { speed_rpm: range.speed_rpm(index), ..LobePoint::default() };
            Ok(PointJob { cut: cut.clone(), range, point, curves: 0 })
        };
        let end = |_: usize, job: &PointJob| job.point;
        self.points.advance(range.count(), budget, &Making { begin: &begin, end: &end })
    }

    fn progress(&self) -> Progress {
        Progress {
            done: self.points.progress(),
            total: self.range.count() as f64,
            unit: text!("speeds"),
        }
    }

    fn partial(&self) -> Vec<LobePoint> {
        self.points()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_time_simulation_meets_the_chart() {
        let range =
            Range { from_rpm: 1100.0, to_rpm: 2300.0, speeds: 2, highest_mm: 60.0, simulate: true };
        let mut job = ChartJob::new(&Scenario::default(), range).unwrap();
        let mut steps = 1;
        while !job.advance_by(1) {
            steps += 1;
        }
        assert_eq!((steps, job.points().len()), (2 * 4, 2));
        for point in job.points() {
            for difference in point.differences_percent() {
                let percent = difference.expect("every speed here has a limit");
                assert!(percent.abs() < BAND_PERCENT, "{point:?}");
            }
            assert!(point.mean_mm > Some(job.any_speed_mm()));
        }
        let whole = job.points();
        assert!(job.advance_by(1) && job.points() == whole, "a finished chart stays as it is");
    }
}
