//! The adaptive use of the life prediction in the running cut: the programmed speed is adjusted so that the
//! tool reaches the tool life wanted (2019).
//!
//! ```text
//! n_new = n [ R/R_des ]^n_Taylor,   R = (T_hat - a) T(now)/T(programmed),   R_des = T_des - t
//! ```
//!
//! every ten minutes of the tool's life, which pass `wear.time_scale` times as fast as the run. The feed
//! per tooth stays, so the programmed feed goes with the speed. It takes effect where a controller holds
//! the programmed speed: at constant feed and under the force controllers.

use super::scenario::Scenario;
use super::signals::{Row, flag};
use crate::base::math;
use crate::blocks::control::FeedSpeed;
use crate::blocks::sensing::tool_condition::{
    CutObservation, EstimatorSetup, ToolConditionEstimator,
};
use crate::models::genetic::GeneticModels;
use crate::models::structure::reduction::Reduction;
use crate::models::tool::Tool;
use crate::models::wear::{WearCut, WearModel};

/// Minutes of the tool's life between two adjustments (chosen).
pub const PERIOD_MIN: f64 = 10.0;
/// The speed stays between these ratios to the programmed one (chosen: the range of the overrides).
pub const SPEED_RATIOS: [f64; 2] = [0.5, 1.5];
/// No adjustment in the last minutes: the remaining life wanted is too short to divide by.
pub const LAST_MIN: f64 = 10.0;

/// The quantities of Taylor's equation for a tool at a feed, a speed and an axial depth in mm.
#[must_use]
pub fn wear_cut(tool: &Tool, at: FeedSpeed, axial_depth_mm: f64) -> WearCut {
    WearCut {
        cutting_speed_m_min: at.speed_rpm / tool.speed_rpm(1.0),
        feed_per_tooth_mm: tool.feed_per_tooth_mm(at.feed_mm_min, at.speed_rpm),
        axial_depth_mm,
    }
}

/// The tool-condition estimator of a scenario before the cut, on a machine.
#[must_use]
pub fn estimator(scenario: &Scenario, machine: &Reduction) -> ToolConditionEstimator {
    let tool = &scenario.tool;
    ToolConditionEstimator::new(EstimatorSetup {
        machine: *machine,
        teeth: tool.teeth,
        diameter_mm: tool.diameter_mm,
        wear: scenario.wear.clone(),
        life: scenario.life.clone(),
        programmed: wear_cut(tool, scenario.programmed(0), scenario.workpiece.axial_depth_mm),
    })
}

/// What a row of length `dt_s` shows of the cut of a tool; `belief` gives the force of a sharp one.
#[must_use]
pub fn observation_of(row: &Row, tool: &Tool, belief: &GeneticModels, dt_s: f64) -> CutObservation {
    let at = FeedSpeed { feed_mm_min: row.feed_mm_min, speed_rpm: row.spindle_rpm };
    let force_n = belief.force(at.feed_mm_min, at.speed_rpm).value;
    CutObservation {
        dt_s,
        cut: wear_cut(tool, at, row.axial_depth_mm),
        speed_rpm: row.spindle_rpm,
        radial_depth_mm: row.radial_depth_mm,
        sharp_force_n: force_n * row.axial_depth_mm,
        sound_m_s: 1e-3 * row.sound_mm_s,
        in_cut: !row.has(flag::AIR),
    }
}

/// The adjustment of the speed in a run.
#[derive(Clone, Debug)]
pub struct Durability {
    estimator: ToolConditionEstimator,
    tool: Tool,
    desired_min: f64,
    taylor_exponent: f64,
    time_scale: f64,
    /// Minutes in cut; the next adjustment.
    time_min: f64,
    next_min: f64,
    /// Speed over the programmed one.
    share: f64,
}

impl Durability {
    /// The adjustment of a scenario; `None` where it is off, or where nothing wears or sounds.
    #[must_use]
    pub fn new(scenario: &Scenario) -> Option<Box<Self>> {
        let wear = &scenario.wear;
        if !(wear.adjust_speed && wear.model == WearModel::Life) {
            return None;
        }
        let estimator = estimator(scenario, scenario.coupled_machine()?);
        Some(Box::new(Self {
            tool: scenario.tool.clone(),
            desired_min: scenario.life.tool_life_min,
            taylor_exponent: wear.taylor_exponent,
            time_scale: wear.time_scale,
            time_min: estimator.age_min(),
            next_min: estimator.age_min() + PERIOD_MIN,
            share: 1.0,
            estimator,
        }))
    }

    /// Takes over changed settings; what was observed stays.
    pub fn reconfigure(&mut self, scenario: &Scenario) {
        self.estimator.reconfigure(&scenario.wear);
        self.desired_min = scenario.life.tool_life_min;
        self.taylor_exponent = scenario.wear.taylor_exponent;
        self.time_scale = scenario.wear.time_scale;
    }

    /// Feed and speed in place of the programmed ones.
    #[must_use]
    pub fn adjusted(&self, programmed: FeedSpeed) -> FeedSpeed {
        FeedSpeed {
            feed_mm_min: self.share * programmed.feed_mm_min,
            speed_rpm: self.share * programmed.speed_rpm,
        }
    }

    /// Lets `dt_s` of the cut in `row` pass.
    pub fn update(&mut self, row: &Row, belief: &GeneticModels, dt_s: f64) {
        let observation = observation_of(row, &self.tool, belief, dt_s);
        if observation.in_cut {
            self.time_min += self.time_scale * dt_s / 60.0;
        }
        let Some(prediction) = self.estimator.observe(&observation) else { return };
        let wanted_min = self.desired_min - self.time_min;
        if self.time_min < self.next_min || wanted_min < LAST_MIN {
            return;
        }
        self.next_min = self.time_min + PERIOD_MIN;
        let remaining_min =
            prediction.remaining_min() * self.estimator.life_ratio(&observation.cut);
        let ratio = math::pow(remaining_min / wanted_min, self.taylor_exponent);
        let [low, high] = SPEED_RATIOS;
        self.share = math::limit(self.share * ratio, low, high);
    }
}
