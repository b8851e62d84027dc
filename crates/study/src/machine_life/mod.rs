//! The 2019 model over the life of the tool: the equations solved again for every second, the trends
//! of sound and roughness, and how alike they are.
//!
//! The paper claims that the two trends are identical, without figures. Here they come out alike as
//! long as the tool degrades mainly through the force; that is a property of the chosen wear, and
//! no evidence for it.

pub mod adaptive;
pub mod calibration;
pub mod measurement;
pub mod monte_carlo;
pub mod surface;
pub mod tool_condition;

use serde::Serialize;

use crate::base::language::text;
use crate::base::math::extent;
use crate::base::stats::correlation;
use crate::base::units::s_from_min;
use crate::blocks::cnc::feed_override::Program;
use crate::blocks::control::FeedSpeed;
use crate::models::machine_trend::{MachineTrend, TrendLine, TrendPoint};
use crate::models::structure::FiveMass;
use crate::models::wear::WearCut;
use crate::run::closed_loop::life::wear_cut;
use crate::run::job::{Budget, Job, Progress};
use crate::run::scenario::Scenario;

/// Step of the paper, s.
pub const STEP_S: f64 = 1.0;
/// The life that is solved for a tool that never wears out, since it cuts nothing, s: some 30 years.
const LONGEST_S: f64 = 1e9;
/// Most steps; a longer life is taken in longer ones.
const STEPS_MAX: f64 = 100_000.0;

/// What the paper says of the two trends, and of calculated and measured sound.
pub const CLAIMS: [&str; 3] = [
    text!("sound trend and roughness trend are identical (no figure is printed)"),
    text!("calculated and measured sound trend: R = 0.993; no measurement is published"),
    text!("calculated and measured sound spectrum: R = 0.684; no measurement is published"),
];

/// The cut of a scenario at its programmed feed and speed and its axial depth.
#[must_use]
pub fn programmed_cut(scenario: &Scenario) -> WearCut {
    let Program { feed_mm_min, spindle_rpm: speed_rpm, .. } = scenario.program;
    let at = FeedSpeed { feed_mm_min, speed_rpm };
    wear_cut(&scenario.tool, at, scenario.workpiece.axial_depth_mm)
}

/// The machine of a scenario in its programmed cut.
#[must_use]
pub fn model(scenario: &Scenario) -> MachineTrend {
    MachineTrend {
        machine: FiveMass::new(&scenario.machine),
        wear: scenario.wear.clone(),
        life: scenario.life.clone(),
        cut: programmed_cut(scenario),
        tool: scenario.tool.clone(),
        radial_depth_mm: scenario.workpiece.radial_depth_mm,
    }
}

/// The repeated solution over the life.
#[derive(Clone, Debug)]
pub struct LifeJob {
    model: MachineTrend,
    step_s: f64,
    steps: usize,
    points: Vec<TrendPoint>,
}

impl LifeJob {
    /// A life of `life_min`, not yet begun; in steps of a second, or longer ones beyond 100 000.
    #[must_use]
    pub fn new(model: MachineTrend, life_min: f64) -> Self {
        let life_s = s_from_min(life_min).min(LONGEST_S);
        let step_s = STEP_S * (life_s / STEPS_MAX).ceil().max(1.0);
        let steps = ((life_s / step_s).round() as usize).max(1);
        Self { model, step_s: life_s / steps as f64, steps, points: Vec::new() }
    }

    /// The life of this very tool in a scenario's cut.
    #[must_use]
    pub fn of(scenario: &Scenario) -> Self {
        let model = model(scenario);
        let life_min = model.wear.life_min(&model.cut);
        Self::new(model, life_min)
    }

    /// Time between two points, s.
    #[must_use]
    pub fn step_s(&self) -> f64 {
        self.step_s
    }

    /// What is solved so far, from the sharp tool on.
    #[must_use]
    pub fn points(&self) -> &[TrendPoint] {
        &self.points
    }

    /// The machine.
    #[must_use]
    pub fn model(&self) -> &MachineTrend {
        &self.model
    }

    /// What the trends show; `None` before the end.
    #[must_use]
    pub fn findings(&self) -> Option<LifeFindings> {
        if self.points.len() <= self.steps {
            return None;
        }
        let (first, last) = (self.points[0], self.points[self.steps]);
        let series = |of: fn(&TrendPoint) -> f64| self.points.iter().map(of).collect::<Vec<f64>>();
        let sound = series(|point| point.sound);
        let ra = series(|point| point.ra_um);
        let vibration = series(|point| point.vibration_rms_m);
        Some(LifeFindings {
            life_s: self.step_s * self.steps as f64,
            sound_ratio: last.sound / first.sound,
            vibration_ratio: last.vibration_rms_m / first.vibration_rms_m,
            ra_ratio: last.ra_um / first.ra_um,
            sound_roughness_r: correlation(&sound, &ra),
            sound_vibration_r: correlation(&sound, &vibration),
            largest_difference: largest_difference(&sound, &ra),
            first_spectrum: self.model.spectrum(0.0).collect(),
            last_spectrum: self.model.spectrum(1.0).collect(),
        })
    }
}

/// What the solution over the life has given so far.
#[derive(Clone, Debug)]
pub struct LifeSoFar {
    /// What is solved, from the sharp tool on.
    pub points: Vec<TrendPoint>,
    /// What the trends show, at the end.
    pub findings: Option<LifeFindings>,
}

/// A step is a point of time.
impl Job for LifeJob {
    type Partial = LifeSoFar;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        while self.points.len() <= self.steps && budget.step() {
            let x = self.points.len() as f64 / self.steps as f64;
            self.points.push(self.model.at(x));
        }
        self.points.len() > self.steps
    }

    fn progress(&self) -> Progress {
        let total = (self.steps + 1) as f64;
        Progress { done: self.points.len() as f64, total, unit: text!("points of time") }
    }

    fn partial(&self) -> LifeSoFar {
        LifeSoFar { points: self.points.clone(), findings: self.findings() }
    }
}

/// Largest difference of two series, each brought to 0..1 by its first and last value.
fn largest_difference(a: &[f64], b: &[f64]) -> f64 {
    let unit = |series: &[f64], i: usize| {
        let (first, last) = (series[0], series[series.len() - 1]);
        (series[i] - first) / (last - first)
    };
    extent((0..a.len()).map(|i| (unit(a, i) - unit(b, i)).abs()))[1]
}

/// What the trends over a life show.
#[derive(Clone, Debug, Serialize)]
pub struct LifeFindings {
    /// The life, s.
    pub life_s: f64,
    /// Sound at the end over sound at the start: the criterion lambda.
    pub sound_ratio: f64,
    /// The same of the vibration.
    pub vibration_ratio: f64,
    /// The same of the roughness.
    pub ra_ratio: f64,
    /// Correlation of the trends of sound and roughness.
    pub sound_roughness_r: Option<f64>,
    /// Correlation of the trends of sound and vibration.
    pub sound_vibration_r: Option<f64>,
    /// Largest difference of the trends of sound and roughness, each brought to 0..1.
    pub largest_difference: f64,
    /// Spectrum of the sharp tool.
    pub first_spectrum: Vec<TrendLine>,
    /// Spectrum at the end of life.
    pub last_spectrum: Vec<TrendLine>,
}

#[cfg(test)]
mod tests;
