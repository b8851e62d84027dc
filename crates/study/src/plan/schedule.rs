//! Programmed feeds of the single cuts: every straight cut planned for one of its sections, the
//! spindle as programmed.
//!
//! The lightest section gives the fast schedule: elsewhere the force at 100 % is above its limit and a
//! controller has to hold it. The heaviest gives the safe one. Which section is the lightest is
//! judged by the force of the network at the reference feed per tooth.

use serde::Serialize;

use super::PlanJob;
use super::cut::REFERENCE;
use super::machine::MachineLimits;
use super::optimum::Optimum;
use super::problem::{CUTTING_SPEED_M_MIN, Problem};
use crate::base::language::text;
use crate::base::settings::{SettingError, Value};
use crate::blocks::cutting::tool_path::Engagement;
use crate::models::part::Section;
use crate::models::plan::PlannedSection;
use crate::run::job::{Budget, Job, Progress};
use crate::run::parts::{Making, Parts};
use crate::run::scenario::Scenario;

/// A cut and its planned feed.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PlannedCut {
    /// The section that it was planned for, counted from 0.
    pub section: usize,
    /// Length of that section, its axial depth and wall position, mm.
    pub section_mm: Section,
    /// The plan.
    pub optimum: Optimum,
}

/// A schedule on its way: a plan for every cut.
#[derive(Clone, Debug)]
pub struct ScheduleJob {
    sizing: Sizing,
    plans: Parts<CutPlan, PlannedCut>,
}

/// What the plans are made of.
#[derive(Clone, Debug)]
struct Sizing {
    scenario: Scenario,
    machine: MachineLimits,
    sized_by: PlannedSection,
}

/// The plan of one cut.
#[derive(Clone, Debug)]
struct CutPlan {
    section: usize,
    section_mm: Section,
    plan: PlanJob,
}

impl ScheduleJob {
    /// The schedule of a scenario with cuts on a machine, not yet begun.
    ///
    /// # Errors
    /// The workpiece has no cuts, or the programmed spindle gives a cutting speed outside the
    /// plan's range.
    pub fn on(
        scenario: &Scenario,
        machine: &MachineLimits,
        sized_by: PlannedSection,
    ) -> Result<Self, SettingError> {
        let refused = |path: &str, value: String, allowed: String| {
            Err(SettingError::Refused { path: path.to_owned(), value, allowed })
        };
        if scenario.workpiece.cuts.is_empty() {
            let allowed = "at least one cut for a schedule".to_owned();
            return refused("workpiece.cuts", "[]".to_owned(), allowed);
        }
        let speed_rpm = scenario.program.spindle_rpm;
        let speed_m_min = speed_rpm / scenario.tool.speed_rpm(1.0);
        let [low, high] = CUTTING_SPEED_M_MIN;
        if !(low..=high).contains(&speed_m_min) {
            let [low, high] = [low, high].map(|speed| scenario.tool.speed_rpm(speed));
            let allowed = format!("{low:.0} to {high:.0} 1/min for a schedule");
            return refused("program.spindle_rpm", format!("{speed_rpm} 1/min"), allowed);
        }
        let mut scenario = scenario.clone();
        scenario.change(|s| {
            s.plan.free_speed = false;
            s.plan.cutting_speed_m_min = speed_m_min;
        })?;
        let sizing = Sizing { scenario, machine: machine.clone(), sized_by };
        Ok(Self { sizing, plans: Parts::default() })
    }

    /// The cuts planned so far.
    #[must_use]
    pub fn planned(&self) -> &[PlannedCut] {
        self.plans.done()
    }

    /// Their feeds, mm/min.
    #[must_use]
    pub fn feeds_mm_min(&self) -> Vec<f64> {
        self.planned().iter().map(|cut| cut.optimum.feed_mm_min).collect()
    }

    /// `scenario` with these feeds as the programmed ones.
    ///
    /// # Errors
    /// A feed lies outside the range of its setting.
    pub fn apply(&self, scenario: &Scenario) -> Result<Scenario, SettingError> {
        let mut planned = scenario.clone();
        planned.set("program.cut_feeds_mm_min", Value::from(self.feeds_mm_min()))?;
        Ok(planned)
    }
}

impl Sizing {
    /// The scenario of one section alone.
    fn alone(&self, section: &Section) -> Result<Scenario, SettingError> {
        let place = Engagement::in_section(&self.scenario.tool.outline(), [section[1], section[2]]);
        self.scenario.with(|settings| {
            let workpiece = &mut settings.workpiece;
            workpiece.axial_depth_mm = place.axial_depth_mm;
            workpiece.radial_depth_mm = place.radial_depth_mm;
            // A path has 1 mm at least; the optimum does not depend on the length, of which time and cost are
            // shares of the same cut as programmed.
            workpiece.length_mm = section[0].max(1.0);
            workpiece.cuts.clear();
            workpiece.depth_steps.clear();
            workpiece.radial_steps.clear();
        })
    }

    /// The section that a cut is planned for: number and scenario.
    ///
    /// # Errors
    /// No section of it cuts anything.
    fn sizing(&self, cut: &[Section]) -> Result<(usize, Scenario), SettingError> {
        let mut found: Option<(f64, usize, Scenario)> = None;
        let mut refusal = None;
        for (i, section) in cut.iter().enumerate() {
            let scenario = self.alone(section)?;
            let problem = match Problem::new(&scenario, &self.machine) {
                Ok(problem) => problem,
                Err(error) => {
                    refusal = Some(error);
                    continue;
                }
            };
            let speed_m_min = scenario.plan.cutting_speed_m_min;
            let force_n = problem.cut([speed_m_min, REFERENCE[1]]).force_n;
            let better = found.as_ref().is_none_or(|(best_n, ..)| match self.sized_by {
                PlannedSection::Lightest => force_n < *best_n,
                PlannedSection::Heaviest => force_n > *best_n,
            });
            if better {
                found = Some((force_n, i, scenario));
            }
        }
        match (found, refusal) {
            (Some((_, i, scenario)), _) => Ok((i, scenario)),
            (None, refusal) => Err(refusal.expect("a cut has at least one section")),
        }
    }

    /// The plan of cut `index`, at its start.
    fn begin(&self, index: usize) -> Result<CutPlan, SettingError> {
        let cut = &self.scenario.workpiece.cuts[index];
        let (section, scenario) = self.sizing(cut)?;
        let plan = PlanJob::on(&scenario, &self.machine)?;
        Ok(CutPlan { section, section_mm: cut[section], plan })
    }
}

/// A step is an iteration of a swarm.
impl Job for CutPlan {
    type Partial = Optimum;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        self.plan.advance(budget)
    }

    fn progress(&self) -> Progress {
        self.plan.progress()
    }

    fn partial(&self) -> Optimum {
        self.plan.optimum()
    }
}

/// A step is an iteration of the swarm of one of the cuts.
impl Job for ScheduleJob {
    type Partial = Vec<PlannedCut>;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        let sizing = &self.sizing;
        let begin = |index: usize| sizing.begin(index).map_err(|error| error.to_string());
        let end = |_: usize, cut: &CutPlan| PlannedCut {
            section: cut.section,
            section_mm: cut.section_mm,
            optimum: cut.plan.optimum(),
        };
        let count = sizing.scenario.workpiece.cuts.len();
        self.plans.advance(count, budget, &Making { begin: &begin, end: &end })
    }

    fn progress(&self) -> Progress {
        let total = self.sizing.scenario.workpiece.cuts.len() as f64;
        Progress { done: self.plans.progress(), total, unit: text!("cuts") }
    }

    fn partial(&self) -> Vec<PlannedCut> {
        self.planned().to_vec()
    }

    fn refusal(&self) -> Option<&str> {
        self.plans.refusal()
    }
}
