//! The tool's life in the running cut: its prediction from the sound, and the speed that makes it the
//! desired one (2019). The estimator and the supervisor meet here; the law stands in
//! [`crate::blocks::control::speed_supervisor`].

use crate::blocks::control::FeedSpeed;
use crate::blocks::control::speed_supervisor::SpeedSupervisor;
use crate::blocks::machine::coupled::CutState;
use crate::blocks::sensing::tool_condition::{
    CutObservation, EstimatorSetup, ToolConditionEstimator,
};
use crate::models::genetic::GeneticModels;
use crate::models::structure::reduction::Reduction;
use crate::models::tool::Tool;
use crate::models::wear::{WearCut, WearModel};
use crate::run::scenario::Scenario;
use crate::run::signals::{Row, flag};

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

/// A stretch of the cut as far as it can be observed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stretch {
    /// Length, s.
    pub dt_s: f64,
    /// Actual feed, mm/min.
    pub feed_mm_min: f64,
    /// Actual speed and depths.
    pub cut: CutState,
    /// Trend of the sound, mm/s.
    pub sound_mm_s: f64,
    /// The tool is in the material.
    pub in_cut: bool,
}

impl Stretch {
    /// What a row of length `dt_s` shows.
    #[must_use]
    pub fn of_row(row: &Row, dt_s: f64) -> Self {
        Self {
            dt_s,
            feed_mm_min: row.feed_mm_min,
            cut: CutState {
                speed_rpm: row.spindle_rpm,
                axial_depth_mm: row.axial_depth_mm,
                radial_depth_mm: row.radial_depth_mm,
            },
            sound_mm_s: row.sound_mm_s,
            in_cut: !row.has(flag::AIR),
        }
    }

    /// What it shows of the tool; `belief` gives the force of a sharp one.
    #[must_use]
    pub fn observed(&self, tool: &Tool, belief: &GeneticModels) -> CutObservation {
        let CutState { speed_rpm, axial_depth_mm, radial_depth_mm } = self.cut;
        let at = FeedSpeed { feed_mm_min: self.feed_mm_min, speed_rpm };
        let force_n = belief.force(at.feed_mm_min, at.speed_rpm).value;
        CutObservation {
            dt_s: self.dt_s,
            cut: wear_cut(tool, at, axial_depth_mm),
            speed_rpm,
            radial_depth_mm,
            sharp_force_n: force_n * axial_depth_mm,
            sound_m_s: 1e-3 * self.sound_mm_s,
            in_cut: self.in_cut,
        }
    }
}

/// The estimator with the supervisor that uses its predictions.
#[derive(Clone, Debug)]
pub struct ToolLife {
    tool: Tool,
    estimator: ToolConditionEstimator,
    supervisor: SpeedSupervisor,
}

impl ToolLife {
    /// Those of a scenario; `None` where the speed is not adjusted, or nothing wears or sounds.
    #[must_use]
    pub fn new(scenario: &Scenario) -> Option<Box<Self>> {
        let wear = &scenario.wear;
        if !(wear.adjust_speed && wear.model == WearModel::Life) {
            return None;
        }
        let estimator = estimator(scenario, scenario.coupled_machine()?);
        let supervisor = SpeedSupervisor::new(wear, &scenario.life, estimator.age_min());
        Some(Box::new(Self { tool: scenario.tool.clone(), estimator, supervisor }))
    }

    /// Takes over changed settings; what was observed stays.
    pub fn reconfigure(&mut self, scenario: &Scenario) {
        self.estimator.reconfigure(&scenario.wear);
        self.supervisor.reconfigure(&scenario.wear, &scenario.life);
    }

    /// Feed and speed in place of the programmed ones.
    #[must_use]
    pub fn adjust(&self, programmed: FeedSpeed) -> FeedSpeed {
        self.supervisor.adjust(programmed)
    }

    /// Lets a stretch of the cut pass.
    pub fn observe(&mut self, stretch: &Stretch, belief: &GeneticModels) {
        let observation = stretch.observed(&self.tool, belief);
        if observation.in_cut {
            self.supervisor.pass(observation.dt_s);
        }
        if let Some(prediction) = self.estimator.observe(&observation) {
            let ratio = self.estimator.life_ratio(&observation.cut);
            self.supervisor.predict(prediction.remaining_min() * ratio);
        }
    }
}
