//! The safe constant feed of a part: the largest one that is nowhere rougher than allowed. Whoever must keep the
//! tolerance everywhere without control programs it, by the deepest and hardest place; what control buys is measured
//! against it.
//!
//! Every feed is tried by a true cut of the whole part ([`trial::FeedTrial`]), with the seed of the run that it is
//! compared with and with what is changed during that run, at the same places. So whatever the surface is judged by
//! counts, wear and noise included, and in a coupled machine the vibration. (In a map of the force noise moves what is sensed and Ra with dynamics, not the Ra
//! that is judged; tooth by tooth the material's inhomogeneity moves that, too.) A feed holds if the part is cut to
//! its end, Ra lies nowhere beyond the upper end of its tolerance and is known somewhere; a surface that is smoother
//! than asked is no scrap. Where a force is held, it is that which lies nowhere above its tolerance. The time limit
//! of the run does not count: the part is cut whole.
//!
//! The search, for one speed:
//!
//! ```text
//! feeds    whole mm/min from the machine's least to its largest feed (or the programmed one, where that is larger and
//!          the machine is not known to go no further),
//!          and below that at which a tooth is fed by more than the cutter's radius, which is a crash
//! ladder   from the largest feed down in steps of 15 %, until one holds: where more feed is not always rougher, the
//!          largest that holds is found as finely as the ladder's rungs lie
//! bisect   between that rung and the one above, to 1 mm/min: the feed above the one that is found does not hold
//! ```
//!
//! The programmed speed comes first. With `twin.free_speed` others follow, evenly over the limits of machine and
//! force model; of them only feeds above the best so far are tried, since at constant feed the larger one takes less
//! time.

pub mod trial;

use serde::Serialize;

use self::trial::{Broken, FeedTrial};
use crate::base::language::{text, tr};
use crate::blocks::control::{ControllerKind, ControllerSettings};
use crate::blocks::cutting::crash::most_per_turn_mm;
use crate::blocks::cutting::tool_path::ToolPath;
use crate::models::feed_speed::FeedSpeed;
use crate::plan::machine::MachineLimits;
use crate::run::constant_feed_twin::{self, PlacedEdit, placed_edits};
use crate::run::job::{Budget, Job, Progress};
use crate::run::one_run::Run;
use crate::run::scenario::{Info, Scenario};

/// Steps of the feed, mm/min: the next larger one does not hold.
pub const FEED_STEP_MM_MIN: f64 = 1.0;
/// A rung of the ladder over the next lower one.
const RUNG: f64 = 1.15;
/// Speeds that are tried besides the programmed one, where it is free.
const SPEEDS: u32 = 15;
/// Steps of those speeds, 1/min.
const SPEED_STEP_RPM: f64 = 10.0;

/// Most rows that a twin records: as many as a run may have in a page, so that it is the same everywhere.
const MOST_ROWS: f64 = 1_000_000.0;
/// Longest time limit of a run, s (the range of `run.duration_s`).
const LONGEST_RUN_S: f64 = 3600.0;

/// What the safe feed depends on, and nothing else: the same problem has the same answer.
#[derive(Clone, Debug, PartialEq)]
pub struct SafeFeedProblem {
    scenario: Scenario,
    edits: Vec<PlacedEdit>,
}

impl SafeFeedProblem {
    /// That of the twin of a run that is over.
    #[must_use]
    pub fn of(chosen: &Run) -> Self {
        Self::new(chosen.scenario(), placed_edits(chosen))
    }

    /// That of a scenario, with the changes that its twin shares at their places.
    #[must_use]
    pub fn new(chosen: &Scenario, edits: Vec<PlacedEdit>) -> Self {
        let scenario = constant_feed_twin::scenario(chosen).with(|settings| {
            settings.info = Info::default();
            settings.controller = ControllerSettings::default();
            settings.controller.kind = ControllerKind::ConstantFeed;
        });
        // No rule joins the controller and its settings, or a name, with anything that constant feed lacks.
        Self { scenario: scenario.expect("constant feed goes with any scenario"), edits }
    }
}

/// The largest constant feed that holds.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct SafeTwin {
    /// The feed, mm/min: a whole number of [`FEED_STEP_MM_MIN`].
    pub feed_mm_min: f64,
    /// The spindle speed, 1/min.
    pub spindle_rpm: f64,
    /// Time in which it cuts the whole part, s.
    pub time_of_cut_s: f64,
}

impl SafeTwin {
    /// Feed and speed.
    #[must_use]
    pub fn at(&self) -> FeedSpeed {
        FeedSpeed { feed_mm_min: self.feed_mm_min, speed_rpm: self.spindle_rpm }
    }
}

/// No constant feed holds: what stands against the least one at the programmed speed.
#[derive(Clone, Debug, PartialEq)]
pub struct NoSafeFeed {
    /// That feed, mm/min.
    pub least_feed_mm_min: f64,
    /// The speed, 1/min.
    pub spindle_rpm: f64,
    /// What breaks it.
    pub broken: Broken,
}

impl std::fmt::Display for NoSafeFeed {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { least_feed_mm_min, spindle_rpm, broken } = self;
        f.write_str(&tr!(
            "no constant feed is safe: even at {feed:.0} mm/min and {speed:.0} 1/min {broken}",
            feed = *least_feed_mm_min,
            speed = *spindle_rpm,
            broken = broken.to_string()
        ))
    }
}

/// What the search comes to.
#[derive(Clone, Debug, PartialEq)]
pub enum SafeFeed {
    /// The safe feed.
    Found(SafeTwin),
    /// There is none.
    NoneHolds(NoSafeFeed),
}

impl SafeFeed {
    /// The safe feed, where there is one.
    #[must_use]
    pub fn found(&self) -> Option<SafeTwin> {
        match self {
            Self::Found(twin) => Some(*twin),
            Self::NoneHolds(_) => None,
        }
    }
}

/// The twin of a cut at the safe feed; as programmed where there is none, or none is wanted. Its time limit is that in
/// which it cuts the whole part, as far as a run can be so long: one that ended on the way, before the part gets hard,
/// would look better than it is.
#[must_use]
pub fn twin_scenario(chosen: &Scenario, safe: Option<&SafeFeed>) -> Scenario {
    let at_safe = safe.and_then(SafeFeed::found).map(|twin| twin.at());
    let twin = at_safe.and_then(|at| constant_feed_twin::scenario_at(chosen, at).ok());
    let twin = twin.unwrap_or_else(|| constant_feed_twin::scenario(chosen));
    let feed_mm_min = least_feed(&twin);
    let path_mm = ToolPath::length_of(&twin.workpiece);
    let longest_s = trial::longest_s(path_mm, feed_mm_min).min(longest_run_s(&twin)).floor();
    if longest_s <= twin.run.duration_s {
        return twin;
    }
    let longer = twin.with(|settings| settings.run.duration_s = longest_s);
    longer.unwrap_or(twin)
}

/// How long a run may be wherever it is cut, with the rows that it records, s.
fn longest_run_s(twin: &Scenario) -> f64 {
    let row_s = twin.dt_s() * f64::from(twin.run.record_every);
    (MOST_ROWS * row_s).min(LONGEST_RUN_S)
}

/// The least feed of a twin as programmed and as far as its machine goes, mm/min.
fn least_feed(twin: &Scenario) -> f64 {
    let feeds = match twin.workpiece.cuts.is_empty() {
        true => &[][..],
        false => &twin.program.cut_feeds_mm_min,
    };
    twin.cnc.feed_within(feeds.iter().copied().fold(twin.program.feed_mm_min, f64::min))
}

/// Where the search at one speed is.
#[derive(Clone, Debug)]
enum Stage {
    /// Down the ladder, at this rung.
    Ladder(usize),
    /// Between a feed that holds and one that does not, in steps of the feed.
    Between(u32, u32),
}

/// The search for the safe feed of a part, as a job. See the head of this file.
///
/// ```
/// use steadycut_study::run::job::Job;
/// use steadycut_study::run::presets;
/// use steadycut_study::safe_feed::{SafeFeedJob, SafeFeedProblem};
///
/// let part = presets::load("depth-step").unwrap();
/// let mut search = SafeFeedJob::new(SafeFeedProblem::new(&part, Vec::new()));
/// search.to_end();
/// let safe = search.partial().and_then(|found| found.found()).unwrap();
/// assert!(safe.feed_mm_min < part.program.feed_mm_min, "as programmed it is too rough where it is deeper");
/// ```
#[derive(Clone, Debug)]
pub struct SafeFeedJob {
    problem: SafeFeedProblem,
    speeds: Vec<f64>,
    /// Number of the present speed.
    speed: usize,
    /// Feeds of the ladder at the present speed, in steps of the feed, the largest first.
    ladder: Vec<u32>,
    stage: Stage,
    trial: Option<FeedTrial>,
    /// Trials that are over at the present speed.
    tried: u32,
    /// The feed that is known to hold at the present speed, with its time, s.
    holds: Option<(u32, f64)>,
    best: Option<SafeTwin>,
    /// What broke the least feed at the programmed speed.
    broken: Option<NoSafeFeed>,
    outcome: Option<SafeFeed>,
}

/// Least and largest feed at a speed, in steps of the feed.
fn feeds(scenario: &Scenario, speed_rpm: f64) -> [u32; 2] {
    let machine = MachineLimits::heller_bea_01();
    let programmed = &scenario.program;
    let most = programmed.cut_feeds_mm_min.iter().copied().fold(programmed.feed_mm_min, f64::max);
    // A machine that is known to go no further has no faster feed to find.
    let most = scenario.cnc.feed_within(most.max(machine.feed_max_mm_min.value));
    // At the limit itself it crashes by a rounding.
    let crash = most_per_turn_mm(&scenario.tool) * speed_rpm - FEED_STEP_MM_MIN;
    let steps = |feed_mm_min: f64| feed_mm_min / FEED_STEP_MM_MIN;
    let least = steps(machine.feed_min_mm_min.value).ceil() as u32;
    [least, (steps(most.min(crash)).floor() as u32).max(least)]
}

/// The ladder from the largest feed down to the least.
fn ladder([least, most]: [u32; 2]) -> Vec<u32> {
    let mut rungs = vec![most];
    while let Some(last) = rungs.last().copied().filter(|last| *last > least) {
        let next = (f64::from(last) / RUNG).floor() as u32;
        rungs.push(next.min(last - 1).max(least));
    }
    rungs
}

/// Speeds that are tried, the programmed one first.
fn speeds(scenario: &Scenario) -> Vec<f64> {
    let programmed = scenario.cnc.speed_within(scenario.program.spindle_rpm);
    let mut all = vec![programmed];
    if scenario.twin.free_speed {
        let machine = MachineLimits::heller_bea_01();
        let [_, [least, most]] = scenario.of_plant().cut_ranges();
        let machine = machine.within(&scenario.cnc);
        let low = machine.speed_min_rpm.value.max(least);
        let high = machine.speed_max_rpm.value.min(most);
        let between = |k: u32| low + (high - low) * f64::from(k) / f64::from(SPEEDS - 1);
        let even = (0..SPEEDS).map(between).map(|speed| {
            let rounded = (speed / SPEED_STEP_RPM).round() * SPEED_STEP_RPM;
            rounded.max(low).min(high)
        });
        all.extend(even.filter(|speed| *speed != programmed && low <= high));
    }
    all
}

impl SafeFeedJob {
    /// A search at its start.
    #[must_use]
    pub fn new(problem: SafeFeedProblem) -> Self {
        let speeds = speeds(&problem.scenario);
        let mut job = Self {
            ladder: ladder(feeds(&problem.scenario, speeds[0])),
            problem,
            speeds,
            speed: 0,
            stage: Stage::Ladder(0),
            trial: None,
            tried: 0,
            holds: None,
            best: None,
            broken: None,
            outcome: None,
        };
        job.begin();
        job
    }

    fn at(&self, feed: u32) -> FeedSpeed {
        FeedSpeed {
            feed_mm_min: f64::from(feed) * FEED_STEP_MM_MIN,
            speed_rpm: self.speeds[self.speed],
        }
    }

    /// The feed that is tried, in steps of the feed.
    fn tried_feed(&self) -> u32 {
        match self.stage {
            Stage::Ladder(rung) => self.ladder[rung],
            Stage::Between(low, high) => low + (high - low) / 2,
        }
    }

    fn begin(&mut self) {
        let at = self.at(self.tried_feed());
        self.trial = Some(FeedTrial::new(&self.problem.scenario, &self.problem.edits, at));
    }

    /// Goes on from a trial that is over.
    fn take(&mut self, verdict: Result<f64, Broken>) {
        let feed = self.tried_feed();
        self.tried += 1;
        let last_rung = matches!(self.stage, Stage::Ladder(rung) if rung + 1 == self.ladder.len());
        self.stage = match (&self.stage, verdict) {
            (Stage::Ladder(rung), Ok(time_s)) => {
                self.holds = Some((feed, time_s));
                // Above the uppermost rung there is none.
                let above = if *rung == 0 { feed + 1 } else { self.ladder[rung - 1] };
                Stage::Between(feed, above)
            }
            (Stage::Ladder(rung), Err(broken)) => {
                if last_rung && self.speed == 0 {
                    let FeedSpeed { feed_mm_min, speed_rpm } = self.at(feed);
                    self.broken = Some(NoSafeFeed {
                        least_feed_mm_min: feed_mm_min,
                        spindle_rpm: speed_rpm,
                        broken,
                    });
                }
                Stage::Ladder(rung + usize::from(!last_rung))
            }
            (Stage::Between(_, high), Ok(time_s)) => {
                self.holds = Some((feed, time_s));
                Stage::Between(feed, *high)
            }
            (Stage::Between(low, _), Err(_)) => Stage::Between(*low, feed),
        };
        let nothing_holds = last_rung && self.holds.is_none();
        let found = matches!(self.stage, Stage::Between(low, high) if high - low <= 1);
        if found || nothing_holds {
            self.next_speed();
        } else {
            self.begin();
        }
    }

    /// Keeps what was found at the present speed and goes on to the next one.
    fn next_speed(&mut self) {
        if let Some((feed, time_of_cut_s)) = self.holds.take() {
            let FeedSpeed { feed_mm_min, speed_rpm } = self.at(feed);
            self.best = Some(SafeTwin { feed_mm_min, spindle_rpm: speed_rpm, time_of_cut_s });
        }
        self.trial = None;
        while self.speed + 1 < self.speeds.len() {
            self.speed += 1;
            let [least, most] = feeds(&self.problem.scenario, self.speeds[self.speed]);
            let best = self.best.map_or(0, |best| (best.feed_mm_min / FEED_STEP_MM_MIN) as u32);
            let least = least.max(best + 1);
            if least <= most {
                self.ladder = ladder([least, most]);
                (self.stage, self.tried) = (Stage::Ladder(0), 0);
                return self.begin();
            }
        }
        self.outcome = match (self.best, self.broken.take()) {
            (Some(best), _) => Some(SafeFeed::Found(best)),
            (None, Some(broken)) => Some(SafeFeed::NoneHolds(broken)),
            // The first speed's least feed held or broke.
            (None, None) => None,
        };
    }

    /// Most trials that one speed takes.
    fn most_trials(&self) -> f64 {
        let widest = self.ladder.windows(2).map(|pair| pair[0] - pair[1]).max().unwrap_or(1);
        self.ladder.len() as f64 + f64::from(u32::BITS - widest.leading_zeros())
    }
}

/// A step is one of the plant.
impl Job for SafeFeedJob {
    type Partial = Option<SafeFeed>;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        while let Some(trial) = &mut self.trial {
            if !trial.advance(budget) {
                return false;
            }
            if let Some(verdict) = trial.verdict() {
                self.take(verdict);
            }
        }
        true
    }

    fn progress(&self) -> Progress {
        let total = self.speeds.len() as f64;
        let done = match &self.trial {
            Some(trial) => {
                let tried = f64::from(self.tried) + trial.share();
                self.speed as f64 + (tried / self.most_trials()).min(1.0)
            }
            None => total,
        };
        Progress { done, total, unit: text!("speeds") }
    }

    fn partial(&self) -> Option<SafeFeed> {
        self.outcome.clone()
    }
}
