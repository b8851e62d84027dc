//! The constant-feed twin of a run: the same cut, the same noise, without control. What is changed during the
//! run, the twin meets at the same place of the part, not at the same time: it moves at another feed.
//!
//! There are two ([`TwinKind`]): as programmed, and at a feed of its own, which is the same in every cut. Which feed
//! is safe takes many runs: `steadycut_study::safe_feed` finds it. `twin.kind` of a twin's own scenario says which of
//! the two it is.

use super::edits::{Edit, Edits};
use super::job::{Budget, Job, Progress};
use super::metrics::Metrics;
use super::one_run::{LOOK_TICKS, Run};
use super::scenario::{Scenario, TwinKind};
use crate::base::language::tr;
use crate::base::settings::SettingError;
use crate::blocks::control::ControllerKind;
use crate::models::feed_speed::FeedSpeed;

/// Whether a setting belongs to the controller alone, so that the twin does not know it.
#[must_use]
pub fn is_of_controller(path: &str) -> bool {
    path.starts_with("controller.") || path.starts_with("belief.")
}

/// The scenario of the twin as programmed: constant feed at 100 % overrides, all else equal.
///
/// ```
/// use steadycut_core::blocks::control::ControllerKind;
/// use steadycut_core::run::{constant_feed_twin, presets};
///
/// let chosen = presets::load("first-cut").unwrap();
/// let twin = constant_feed_twin::scenario(&chosen);
/// assert_eq!(twin.controller.kind, ControllerKind::ConstantFeed);
/// assert_eq!(twin.run.seed, chosen.run.seed);
/// ```
#[must_use]
pub fn scenario(chosen: &Scenario) -> Scenario {
    let twin = chosen.with(|settings| {
        settings.controller.kind = ControllerKind::ConstantFeed;
        settings.controller.constant_feed.feed_percent = 100.0;
        settings.controller.constant_feed.speed_percent = 100.0;
        settings.twin.kind = TwinKind::Programmed;
    });
    // No rule joins the controller and its settings with anything that constant feed lacks.
    twin.expect("constant feed goes with any scenario")
}

/// The scenario of a twin at a feed and speed of its own, the same in every cut.
///
/// # Errors
/// The feed or the speed is none that can be programmed.
pub fn scenario_at(chosen: &Scenario, at: FeedSpeed) -> Result<Scenario, SettingError> {
    scenario(chosen).with(|settings| {
        settings.program.feed_mm_min = at.feed_mm_min;
        settings.program.spindle_rpm = at.speed_rpm;
        settings.program.cut_feeds_mm_min.clear();
        settings.twin.kind = TwinKind::Safe;
    })
}

/// What a twin is called, in the chosen language: `safe constant feed` or `constant feed`.
#[must_use]
pub fn name(twin: &Scenario) -> &'static str {
    match twin.twin.kind {
        TwinKind::Safe => tr("safe constant feed"),
        TwinKind::Programmed => tr("constant feed"),
    }
}

/// A change during a run, at the place of the part where the run met it.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacedEdit {
    /// The change, at its time in that run.
    pub edit: Edit,
    /// The place, mm along the way.
    pub place_mm: f64,
}

/// Where a run is at a time in s, mm along the way; none where it has not come so far.
fn place_at(chosen: &Run, at_s: f64) -> Option<f64> {
    let rows = chosen.recording().rows();
    let half_step_s = 0.5 * chosen.scenario().dt_s();
    let reached = rows.last().is_some_and(|last| last.time_s + half_step_s >= at_s);
    reached.then(|| rows[chosen.recording().index_at(at_s)].position_mm)
}

/// The edits that a twin shares, at their places: those that the run has come to.
#[must_use]
pub fn placed_edits(chosen: &Run) -> Vec<PlacedEdit> {
    let shared = edits(chosen.edits());
    let placed = |edit: &Edit| {
        place_at(chosen, edit.at_s).map(|place_mm| PlacedEdit { edit: edit.clone(), place_mm })
    };
    shared.list().iter().map_while(placed).collect()
}

/// The edits that the twin shares, at their times in the chosen run.
#[must_use]
pub fn edits(chosen: &Edits) -> Edits {
    // Checked for the chosen run, and no rule joins controller and cut.
    chosen.only(|edit| !is_of_controller(&edit.path))
}

/// The edits that the twin shares, each at the time when the twin is at the place of the part where the chosen
/// run was: a twin that is ahead or behind meets a change where the other one did, as it meets a step in depth.
#[derive(Clone, Debug, Default)]
pub struct SharedEdits {
    /// Edits of the chosen run, each with its time in the twin, s.
    placed: Vec<(Edit, f64)>,
}

impl SharedEdits {
    /// Forgets where those from a time of the chosen run in s on come, since they or their places have changed.
    pub fn truncate(&mut self, from_s: f64) {
        self.placed.retain(|(edit, _)| edit.at_s < from_s);
    }

    /// The twin's edits, as far as their places are known.
    #[must_use]
    pub fn edits(&self) -> Edits {
        Edits::at_times(self.placed.iter().cloned())
    }

    /// Finds the place of the next one, once both runs have come there; gives the twin's time there, s, from
    /// which on it is to be cut again with [`Self::edits`].
    #[must_use]
    pub fn place(&mut self, chosen: &Run, twin: &Run) -> Option<f64> {
        let next = edits(chosen.edits()).list().get(self.placed.len())?.clone();
        let place_mm = place_at(chosen, next.at_s)?;
        let rows = twin.recording().rows();
        let at_s = rows.get(rows.partition_point(|row| row.position_mm < place_mm))?.time_s;
        self.placed.push((next, at_s));
        Some(at_s)
    }
}

/// The twin beside a run, cut as far as the run lets it: the same part with the same changes at the same places.
#[derive(Clone, Debug)]
pub struct TwinBeside {
    twin: Run,
    shared: SharedEdits,
}

impl TwinBeside {
    /// The twin as programmed at its first tick, beside a run of this scenario.
    #[must_use]
    pub fn new(chosen: &Scenario) -> Self {
        Self::of(&scenario(chosen))
    }

    /// The twin of this scenario of a twin, at its first tick.
    #[must_use]
    pub fn of(twin: &Scenario) -> Self {
        Self { twin: Run::new(twin, &Edits::none()), shared: SharedEdits::default() }
    }

    /// The twin as far as it is cut.
    #[must_use]
    pub fn run(&self) -> &Run {
        &self.twin
    }

    /// Cuts on beside a run that is over; `true` when the twin is over, too.
    pub fn advance(&mut self, chosen: &Run, budget: &Budget<'_>) -> bool {
        loop {
            while let Some(at_s) = self.shared.place(chosen, &self.twin) {
                self.twin.branch(at_s, &self.shared.edits());
            }
            if self.twin.end().is_some() {
                return true;
            }
            let granted = budget.spend(LOOK_TICKS);
            if granted == 0 {
                return false;
            }
            let before = self.twin.ticks();
            self.twin.advance(granted);
            budget.put_back(granted - (self.twin.ticks() - before));
        }
    }
}

/// The twin beside a run that is over, as a job: the same part with the same changes at the same places.
///
/// ```
/// use steadycut_core::run::job::Job;
/// use steadycut_core::run::{constant_feed_twin::BesideRun, edits::Edits, one_run::Run, presets};
///
/// let chosen = Run::complete(&presets::load("first-cut").unwrap(), &Edits::none());
/// let mut beside = BesideRun::new(&chosen);
/// beside.to_end();
/// assert!(beside.twin().end().is_some());
/// ```
#[derive(Clone, Debug)]
pub struct BesideRun<'a> {
    chosen: &'a Run,
    beside: TwinBeside,
}

impl<'a> BesideRun<'a> {
    /// The twin as programmed at its first tick.
    #[must_use]
    pub fn new(chosen: &'a Run) -> Self {
        Self { chosen, beside: TwinBeside::new(chosen.scenario()) }
    }

    /// The twin of this scenario of a twin, at its first tick.
    #[must_use]
    pub fn of(chosen: &'a Run, twin: &Scenario) -> Self {
        Self { chosen, beside: TwinBeside::of(twin) }
    }

    /// The twin as far as it is cut.
    #[must_use]
    pub fn twin(&self) -> &Run {
        self.beside.run()
    }

    /// The same, kept.
    #[must_use]
    pub fn into_twin(self) -> Run {
        self.beside.twin
    }
}

/// A step is one of the plant.
impl Job for BesideRun<'_> {
    type Partial = Metrics;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        self.beside.advance(self.chosen, budget)
    }

    fn progress(&self) -> Progress {
        self.twin().progress()
    }

    fn partial(&self) -> Metrics {
        self.twin().metrics()
    }
}

/// The twin as programmed of a run that is over, cut to its end.
#[must_use]
pub fn beside(chosen: &Run) -> Run {
    let mut beside = BesideRun::new(chosen);
    beside.to_end();
    beside.into_twin()
}
