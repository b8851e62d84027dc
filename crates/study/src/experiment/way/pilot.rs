//! Pilot cuts tooth by tooth: the axial depth and the feeds at which forces are those of the papers' table.
//!
//! A shop that begins with a new cutter does the same: it cuts a few times until the surface is in the range that
//! is wanted. Depth: at the feed per tooth and the cutting speed of the middle of Table 3's final values the force
//! is to be that of its middle. Feeds at both ends of the line: forces a little beyond what its targets from 0.38
//! to 1.52 um ask for. Speeds: 5 % about the middle, since a force tooth by tooth rises with the feed per tooth
//! far more than K4's does.

use super::super::measure::{steady, steady_values};
use crate::base::language::{text, tr};
use crate::base::math;
use crate::models::tool::Tool;
use crate::run::edits::Edits;
use crate::run::job::{Budget, Job, Progress};
use crate::run::one_run::Run;
use crate::run::scenario::Scenario;

/// Middle of Table 3's final speeds and feeds, 1/min and mm/min with the papers' cutter.
const MIDDLE: [f64; 2] = [2080.0, 335.0];
/// Speeds of the box over the middle (chosen).
const SPEEDS: [f64; 2] = [0.95, 1.05];
/// Force in the middle, and at the ends of the line, N: K1 asks for 161 to 197.
const FORCES: [f64; 3] = [180.0, 153.0, 207.0];
/// How fast the force rises with the feed, by which the next pilot cut is chosen; the true exponent lies between
/// 0.7 and 0.9.
const EXPONENT: f64 = 0.8;
/// Pilot cuts for each value.
const CUTS: usize = 6;
/// Deviation of the force up to which a value is found.
const NEAR: f64 = 0.02;

/// What pilot cuts have found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PilotResult {
    /// Axial depth, mm.
    pub axial_depth_mm: f64,
    /// Feeds at the ends of the line, mm/min.
    pub feeds_mm_min: [f64; 2],
    /// Speeds of the box, 1/min.
    pub speeds_rpm: [f64; 2],
    /// Number of cuts.
    pub cuts: usize,
}

/// What is being found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Sought {
    Depth,
    LowFeed,
    HighFeed,
}

const SOUGHT: [Sought; 3] = [Sought::Depth, Sought::LowFeed, Sought::HighFeed];

/// The pilot cuts, one after the other.
#[derive(Clone, Debug)]
pub struct Pilot {
    base: Scenario,
    fixed_depth: bool,
    stage: usize,
    cut: usize,
    cuts: usize,
    now: [f64; 3],
    run: Option<Run>,
    refusal: Option<String>,
}

fn middle(tool: &Tool) -> [f64; 2] {
    let papers = Tool::default();
    let [speed_rpm, feed_mm_min] = MIDDLE;
    let speed = tool.speed_rpm(papers.cutting_speed_m_min(speed_rpm)).round();
    [speed, tool.feed_mm_min(papers.feed_per_tooth_mm(feed_mm_min, speed_rpm), speed)]
}

impl Pilot {
    /// Pilot cuts of a plant; a depth that is given stays.
    #[must_use]
    pub fn new(base: &Scenario, fixed_depth: bool) -> Self {
        let [_, feed] = middle(&base.tool);
        let depth = base.workpiece.axial_depth_mm;
        Self {
            base: base.clone(),
            fixed_depth,
            stage: usize::from(fixed_depth),
            cut: 0,
            cuts: 0,
            now: [depth, 0.9 * feed, 1.1 * feed],
            run: None,
            refusal: None,
        }
    }

    fn speeds(&self) -> [f64; 2] {
        let [speed, _] = middle(&self.base.tool);
        SPEEDS.map(|share| (share * speed).round())
    }

    /// What was found, once all pilot cuts are made.
    #[must_use]
    pub fn result(&self) -> Option<PilotResult> {
        let [axial_depth_mm, low, high] = self.now;
        (self.stage >= SOUGHT.len()).then(|| PilotResult {
            axial_depth_mm,
            feeds_mm_min: [low, high],
            speeds_rpm: self.speeds(),
            cuts: self.cuts,
        })
    }

    fn begin(&self) -> Result<Run, String> {
        let [speed, feed] = middle(&self.base.tool);
        let [slow, fast] = self.speeds();
        let [depth, low, high] = self.now;
        let [speed, feed] = match SOUGHT[self.stage] {
            Sought::Depth => [speed, feed],
            Sought::LowFeed => [fast, low],
            Sought::HighFeed => [slow, high],
        };
        let cut = steady(&self.base)?.with(|s| {
            s.noise.level = 0.0;
            s.program.feed_mm_min = feed;
            s.program.spindle_rpm = speed;
            s.workpiece.axial_depth_mm = depth;
        });
        let cut = cut.map_err(|error| {
            tr!("pilot cuts: {error}: give another depth", error = error.to_string())
        })?;
        Ok(Run::new(&cut, &Edits::none()))
    }

    /// A pilot cut is over: the next value, or the next one that is sought.
    fn take(&mut self, run: &Run) -> Result<(), String> {
        let [force, _] = steady_values(run);
        let force = force.unwrap_or(f64::NAN);
        let ratio = FORCES[self.stage] / force;
        if !ratio.is_finite() {
            return Err(tr("pilot cuts: no chip is cut: give other depths").to_owned());
        }
        self.cuts += 1;
        self.cut += 1;
        let near = (ratio - 1.0).abs() < NEAR;
        if !near && self.cut == CUTS {
            let force = force.round();
            return Err(tr!(
                "pilot cuts: {value} gives {force} N in place of {wanted} N: give another depth",
                value = self.now[self.stage],
                force = force,
                wanted = FORCES[self.stage]
            ));
        }
        let (exponent, steps) = match SOUGHT[self.stage] {
            Sought::Depth => (1.0, 100.0),
            Sought::LowFeed | Sought::HighFeed => (1.0 / EXPONENT, 10.0),
        };
        let factor = if near { 1.0 } else { math::power(ratio, exponent) };
        // In steps that a shop can set.
        self.now[self.stage] = (self.now[self.stage] * factor * steps).round() / steps;
        if near {
            let [depth, low, high] = self.now;
            if self.stage > 0 && low >= high {
                return Err(tr!(
                    "pilot cuts at {depth} mm: feeds {low} to {high} are no range",
                    depth = depth,
                    low = low,
                    high = high
                ));
            }
            self.stage += 1;
            self.cut = 0;
        }
        Ok(())
    }
}

/// A step is one of the plant in one of the cuts.
impl Job for Pilot {
    type Partial = Option<PilotResult>;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        while self.stage < SOUGHT.len() && self.refusal.is_none() {
            if budget.is_spent() {
                return false;
            }
            let begun = match self.run.take() {
                Some(run) => Ok(run),
                None => self.begin(),
            };
            let step = begun.and_then(|mut run| {
                if !Job::advance(&mut run, budget) {
                    self.run = Some(run);
                    return Ok(false);
                }
                self.take(&run).map(|()| true)
            });
            match step {
                Ok(true) => {}
                Ok(false) => return false,
                Err(problem) => self.refusal = Some(problem),
            }
        }
        true
    }

    fn progress(&self) -> Progress {
        let first = usize::from(self.fixed_depth);
        let run = self.run.as_ref().map_or(0.0, |run| run.progress().share());
        let within = (self.cut as f64 + run) / CUTS as f64;
        let done =
            (self.stage - first) as f64 + if self.stage < SOUGHT.len() { within } else { 0.0 };
        Progress { done, total: (SOUGHT.len() - first) as f64, unit: text!("pilot values") }
    }

    fn partial(&self) -> Option<PilotResult> {
        self.result()
    }

    fn refusal(&self) -> Option<&str> {
        self.refusal.as_deref()
    }
}
