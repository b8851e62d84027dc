//! The combined system of 2005 as one: the five steps of the paper's section 1, one after the
//! other, for a scenario.
//!
//! 1. ANFIS models recommend cutting speed and feed per tooth ([`super::recommend`]).
//! 2. Off-line optimisation ([`super::plan`]) searches below the recommended values for the best
//!    allowed cut; its feed and speed are programmed.
//! 3. The measured forces go to the neural control scheme UNKS.
//! 4. UNKS adjusts the feed.
//! 5. Steps 3 and 4 are repeated every control period until the part is done. The paper prints
//!    "1 to 3"; neither the table nor the plan reads a force, so repeating them changes nothing.
//!
//! One feed is programmed for the whole part, by one of its sections. With UNKS in the loop that is
//! the lightest: the override lowers the feed to nothing but raises it by half at most. The same
//! feed without control overloads the heavy sections, and the report says by how much.

use serde::Serialize;

use super::plan::PlanJob;
use super::plan::cut::REFERENCE;
use super::plan::machine::MachineLimits;
use super::plan::optimum::Optimum;
use super::plan::problem::Problem;
use super::plan::surface::ForceSurface;
use super::recommend::{Advisor, EngagementCode, Recommendation};
use crate::base::language::text;
use crate::base::math::extent;
use crate::base::settings::SettingError;
use crate::base::stats;
use crate::base::units::percent_from_ratio;
use crate::blocks::control::ControllerKind;
use crate::blocks::cutting::tool_path::ToolPath;
use crate::blocks::cutting::workpiece::Workpiece;
use crate::models::part::{APPROACH_MM, RadialSteps};
use crate::models::plan::PlannedSection;
use crate::run::edits::Edits;
use crate::run::job::{Budget, Job, Progress};
use crate::run::one_run::Run;
use crate::run::scenario::Scenario;
use crate::run::signals::{Row, flag};

/// The five steps in words.
pub const STEPS: [&str; 5] = [
    "recommended conditions, by ANFIS from a cutting-data table",
    "off-line optimisation of feed and speed below them, by particle swarm",
    "measured forces to the neural control scheme",
    "the neural control scheme adjusts the feed",
    "3 and 4 repeated until the end (printed: 1 to 3, which read no force)",
];

/// Step 1.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Recommended {
    /// What the table gives.
    #[serde(flatten)]
    pub recommendation: Recommendation,
    /// Axial and radial depth of the section that it was asked for, mm.
    pub depths_mm: [f64; 2],
    /// The recommended cut against the constraints of the plan, within the networks' range.
    pub checked: Optimum,
}

/// Step 2.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Planned {
    /// Which section the plan is made for.
    pub section: &'static str,
    /// Largest cutting speed in m/min and feed per tooth in mm: the recommended ones, within the
    /// networks' range.
    pub at_most: [f64; 2],
    /// The answer.
    pub optimum: Optimum,
    /// Iterations of the swarm.
    pub iterations: u32,
    /// The network's force in N at the programmed values in the heaviest section.
    pub heaviest_force_n: f64,
}

/// Steps 3 to 5 as far as they have come, over control periods in contact.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Adjusted {
    /// Control periods in contact: how often steps 3 and 4 were repeated.
    pub periods: usize,
    /// Mean of the measured force, N.
    pub measured_mean_n: f64,
    /// Largest measured force, N.
    pub measured_max_n: f64,
    /// Fraction of periods with the force within 10 % of its reference, percent.
    pub within_ten_percent: f64,
    /// Least, mean and largest feed override, percent.
    pub override_percent: [f64; 3],
}

/// The combined system on its way.
#[derive(Clone, Debug)]
pub struct Combined {
    recommended: Recommended,
    planned: Planned,
    scenario: Scenario,
    run: Option<Run>,
}

impl Combined {
    /// Steps 1 and 2; the run stands at its first tick, if the plan is feasible.
    ///
    /// # Errors
    /// The part has no cut, or hardness or planned values lie outside their ranges.
    pub fn new(
        scenario: &Scenario,
        advisor: &Advisor,
        machine: &MachineLimits,
        section: PlannedSection,
    ) -> Result<Self, SettingError> {
        let mut scenario = scenario.clone();
        scenario.change(|s| {
            s.plan.section = section;
            s.controller.kind = ControllerKind::Unks;
        })?;
        let planning = one_cut(&scenario, section)?;
        let job = PlanJob::on(&planning, machine)?;
        let depths_mm = job.problem().depths_mm();
        let engagement = EngagementCode::of(depths_mm[1], scenario.tool.diameter_mm);
        let hardness_hb = scenario.plant.hardness_hb;
        let recommendation = advisor.recommend(hardness_hb, &scenario.tool, engagement)?;
        let asked =
            [recommendation.cutting_speed_m_min.value, recommendation.feed_per_tooth_mm.value];

        let mut job = job.at_most(asked);
        let at_most = job.problem().range().map(|[_, high]| high);
        job.to_end();
        let optimum = job.optimum();
        let mut heaviest = one_cut(&scenario, PlannedSection::Heaviest)?;
        heaviest.change(|s| s.plan.section = PlannedSection::Heaviest)?;
        let heaviest = Problem::new(&heaviest, machine)?;
        let planned = Planned {
            section: section.label(),
            at_most,
            heaviest_force_n: heaviest
                .cut([optimum.cutting_speed_m_min, optimum.feed_per_tooth_mm])
                .force_n,
            iterations: job.counts().iteration,
            optimum,
        };
        let checked = Optimum::at(job.problem(), at_most);
        let run = if planned.optimum.feasible {
            scenario = planned.optimum.apply(&scenario)?;
            Some(Run::new(&scenario, &Edits::none()))
        } else {
            None
        };
        Ok(Self {
            recommended: Recommended { recommendation, depths_mm, checked },
            planned,
            scenario,
            run,
        })
    }

    /// Step 1.
    #[must_use]
    pub fn recommended(&self) -> &Recommended {
        &self.recommended
    }

    /// Step 2.
    #[must_use]
    pub fn planned(&self) -> &Planned {
        &self.planned
    }

    /// Steps 3 to 5 so far; none without contact.
    #[must_use]
    pub fn adjusted(&self) -> Option<Adjusted> {
        let recording = self.run.as_ref()?.recording();
        let samples = recording.samples(usize::MAX);
        Adjusted::of(&samples.filter(|row| !row.has(flag::AIR)).collect::<Vec<&Row>>())
    }

    /// The scenario with the planned values programmed and UNKS in the loop; as it was given but
    /// for UNKS and section where nothing is feasible.
    #[must_use]
    pub fn scenario(&self) -> &Scenario {
        &self.scenario
    }

    /// The run of steps 3 to 5; none where the plan is not feasible.
    #[must_use]
    pub fn run(&self) -> Option<&Run> {
        self.run.as_ref()
    }
}

/// A step is one of the plant; steps 1 and 2 of the system are done when it is made.
impl Job for Combined {
    type Partial = Option<Adjusted>;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        self.run.as_mut().is_none_or(|run| Job::advance(run, budget))
    }

    fn progress(&self) -> Progress {
        let nothing = Progress { done: 0.0, total: 0.0, unit: text!("steps") };
        self.run.as_ref().map_or(nothing, Job::progress)
    }

    fn partial(&self) -> Option<Adjusted> {
        self.adjusted()
    }
}

impl Adjusted {
    fn of(rows: &[&Row]) -> Option<Self> {
        let first = rows.first()?;
        let count = rows.len() as f64;
        let mean =
            |get: fn(&Row) -> f64| stats::mean(rows.iter().map(|row| get(row))).unwrap_or(0.0);
        let near = |row: &&&Row| (row.force_n - row.force_ref_n).abs() <= 0.1 * row.force_ref_n;
        let overrides = rows.iter().map(|row| row.feed_override_percent);
        let [low, high] = extent(overrides);
        let largest = rows.iter().map(|row| row.force_measured_n);
        Some(Self {
            periods: rows.len(),
            measured_mean_n: mean(|row| row.force_measured_n),
            measured_max_n: largest.fold(first.force_measured_n, f64::max),
            within_ten_percent: percent_from_ratio(rows.iter().filter(near).count() as f64 / count),
            override_percent: [low, mean(|row| row.feed_override_percent), high],
        })
    }
}

/// The scenario with its part replaced by one cut of the planned section's depths, as long as the
/// part: by the network's force at the reference cut the heaviest or the lightest. A part that is one
/// cut already is left to the plan.
fn one_cut(scenario: &Scenario, section: PlannedSection) -> Result<Scenario, SettingError> {
    let speed_rpm = scenario.tool.speed_rpm(REFERENCE[0]);
    let feed_mm_min = scenario.tool.feed_mm_min(REFERENCE[1], speed_rpm);
    let mut found: Option<(f64, Scenario)> = None;
    for one in scenario.workpiece.cuts.iter().flatten() {
        let alone = Workpiece { cuts: vec![vec![*one]], ..scenario.workpiece.clone() };
        let place =
            ToolPath::new(&alone, scenario.tool.outline()).place(APPROACH_MM + 0.5 * one[0]);
        if place.axial_depth_mm <= 0.0 || place.radial_depth_mm <= 0.0 {
            continue;
        }
        let candidate = scenario.with(|settings| {
            settings.workpiece = Workpiece {
                length_mm: ToolPath::length_of(&scenario.workpiece),
                axial_depth_mm: place.axial_depth_mm,
                radial_depth_mm: place.radial_depth_mm,
                depth_steps: Vec::new(),
                radial_steps: RadialSteps::default(),
                cuts: Vec::new(),
            };
        })?;
        let radial_depth_mm = candidate.workpiece.radial_depth_mm;
        let surface = ForceSurface::new(&candidate, [place.axial_depth_mm, radial_depth_mm]);
        let [x, y, _] = surface.components_n(feed_mm_min, speed_rpm);
        let force = (x * x + y * y).sqrt();
        let better = found.as_ref().is_none_or(|(best, _)| match section {
            PlannedSection::Heaviest => force > *best,
            PlannedSection::Lightest => force < *best,
        });
        if better {
            found = Some((force, candidate));
        }
    }
    Ok(found.map_or_else(|| scenario.clone(), |(_, scenario)| scenario))
}
