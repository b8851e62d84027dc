//! A run that can be advanced in slices, rewound and branched; slicing never changes its bits.

use super::closed_loop::{ClosedLoop, Halt};
use super::edits::Edits;
pub use super::end::End;
use super::job::{Budget, Job, Progress};
use super::metrics::{self, Judged, Metrics, Tally};
use super::recording::Recording;
use super::scenario::Scenario;
use crate::base::language::text;
use crate::base::math::limit;
use crate::base::settings::SettingError;
use crate::blocks::cutting::breakage::Breakage;
use crate::blocks::cutting::tool_path::ToolPath;
use crate::models::feed_speed::STANDSTILL_MM_MIN;

/// Ticks between snapshots at first: the most that a rewind has to repeat.
const SNAPSHOT_TICKS: u64 = 10_000;
/// Most snapshots that are kept; with more, every other one goes and the distance doubles.
const MAX_SNAPSHOTS: usize = 128;

#[derive(Clone, Debug)]
struct State {
    closed_loop: ClosedLoop,
    /// The scenario with all edits up to now.
    scenario: Scenario,
    next_edit: usize,
    /// What metrics are made of, where not every plant step is recorded.
    tally: Option<Tally>,
}

impl State {
    /// One step with the edits that are due before it.
    #[inline]
    fn step(&mut self, edits: &Edits, edit_ticks: &[u64]) -> Result<(), End> {
        let tick = self.closed_loop.tick();
        let mut edited = false;
        if edit_ticks.get(self.next_edit).is_some_and(|at| *at <= tick) {
            edited = self.apply_edits(tick, edits, edit_ticks).map_err(End::Refused)?;
        }
        self.closed_loop.step().map_err(|halt| match halt {
            Halt::Crash(crash) => End::Crash(crash),
            Halt::Breakage(broke) => End::Breakage(broke),
            Halt::Fault(fault) => End::Fault(fault),
            Halt::Script(fault) => End::Script(fault),
        })?;
        if let Some(tally) = &mut self.tally {
            tally.add(self.closed_loop.row(), edited);
        }
        Ok(())
    }

    /// Applies the edits that are due; gives whether one of them may move the loop.
    fn apply_edits(
        &mut self,
        tick: u64,
        edits: &Edits,
        edit_ticks: &[u64],
    ) -> Result<bool, SettingError> {
        let mut moved = false;
        while edit_ticks.get(self.next_edit).is_some_and(|at| *at <= tick) {
            let edit = &edits.list()[self.next_edit];
            self.scenario.set(&edit.path, edit.value.clone())?;
            moved |= metrics::moves(edit);
            self.next_edit += 1;
        }
        self.closed_loop.reconfigure(&self.scenario);
        Ok(moved)
    }
}

/// A part of a run that is being repeated; the run itself stays as it is.
#[derive(Clone, Debug)]
pub struct Repeat {
    state: State,
    edits: Edits,
    edit_ticks: Vec<u64>,
}

impl Repeat {
    /// The loop where the repeat has come to.
    #[must_use]
    pub fn closed_loop(&self) -> &ClosedLoop {
        &self.state.closed_loop
    }

    fn tick(&self) -> u64 {
        self.state.closed_loop.tick()
    }

    /// One step more.
    ///
    /// # Errors
    /// What ended the run.
    pub fn step(&mut self) -> Result<(), End> {
        self.state.step(&self.edits, &self.edit_ticks)
    }
}

/// One run: scenario, edits, state and recording.
#[derive(Clone, Debug)]
pub struct Run {
    base: Scenario,
    edits: Edits,
    edit_ticks: Vec<u64>,
    state: State,
    last_tick: u64,
    path_mm: f64,
    recording: Recording,
    snapshots: Vec<State>,
    snapshot_ticks: u64,
    /// The tick of the next snapshot: a comparison in every step, where a remainder costs a division.
    next_snapshot: u64,
    end: Option<End>,
}

impl Run {
    /// A run at its first tick.
    #[must_use]
    pub fn new(scenario: &Scenario, edits: &Edits) -> Self {
        let closed_loop = ClosedLoop::new(scenario);
        let last_tick = scenario.ticks(scenario.run.duration_s).max(1);
        let settings = &scenario.run;
        let mut recording = Recording::new(
            last_tick,
            settings.record_every,
            scenario.dt_s(),
            settings.steps_per_control,
        );
        let tally = recording.leaves_out().then(|| {
            Tally::new(Judged::by(scenario, recording.control_every()), closed_loop.row())
        });
        match &tally {
            Some(tally) => recording.push_counted(0, closed_loop.row(), tally),
            None => recording.push(0, closed_loop.row()),
        }
        let state = State { closed_loop, scenario: scenario.clone(), next_edit: 0, tally };
        let mut run = Self {
            base: scenario.clone(),
            edits: Edits::none(),
            edit_ticks: Vec::new(),
            snapshots: vec![state.clone()],
            snapshot_ticks: SNAPSHOT_TICKS,
            next_snapshot: SNAPSHOT_TICKS,
            state,
            last_tick,
            path_mm: ToolPath::length_of(&scenario.workpiece),
            recording,
            end: None,
        };
        run.take_edits(edits);
        run
    }

    /// A run from start to end.
    ///
    /// ```
    /// use steadycut_core::run::{edits::Edits, one_run::{End, Run}, presets};
    ///
    /// let run = Run::complete(&presets::load("first-cut").unwrap(), &Edits::none());
    /// assert!(run.end().is_some());
    /// let metrics = run.metrics();
    /// println!("Ra {:.2} um at {:.0} N", metrics.ra_final_um.unwrap(), metrics.force_final_n.unwrap());
    /// # assert!(!matches!(run.end(), Some(End::Fault(_))));
    /// ```
    #[must_use]
    pub fn complete(scenario: &Scenario, edits: &Edits) -> Self {
        let mut run = Self::new(scenario, edits);
        run.advance(u64::MAX);
        run
    }

    fn take_edits(&mut self, edits: &Edits) {
        self.edits = edits.clone();
        self.edit_ticks = edits.list().iter().map(|edit| self.base.ticks(edit.at_s)).collect();
    }

    /// Advances by at most `ticks` steps; `true` when the run is over.
    pub fn advance(&mut self, ticks: u64) -> bool {
        for _ in 0..ticks {
            if self.end.is_some() {
                break;
            }
            self.step();
        }
        self.end.is_some()
    }

    #[inline]
    fn step(&mut self) {
        let result = self.state.step(&self.edits, &self.edit_ticks);
        let tick = self.state.closed_loop.tick();
        if let Err(end) = result {
            // A row that no model stands for is not recorded: nothing that was recorded is lost or spoilt.
            let State { closed_loop, tally, .. } = &self.state;
            match &end {
                // The row is still that of the step before.
                End::Crash(_) | End::Breakage(_) => {
                    self.recording.finish(tick - 1, closed_loop.row(), tally.as_ref());
                }
                // Nothing was done in this step.
                End::Refused(_) | End::Script(_) => {
                    self.recording.finish(tick, closed_loop.row(), tally.as_ref());
                }
                End::Fault(_) | End::PathDone | End::TimeLimit | End::Overload(_) => {}
            }
            self.end = Some(end);
            return;
        }
        let row = self.state.closed_loop.row();
        match &self.state.tally {
            Some(tally) => self.recording.push_counted(tick, row, tally),
            None => self.recording.push(tick, row),
        }
        if row.position_mm >= self.path_mm {
            self.end = Some(End::PathDone);
        } else if let Some(overload) = self.state.closed_loop.overload()
            && (overload.retracted || row.feed_mm_min < STANDSTILL_MM_MIN)
        {
            self.end = Some(End::Overload(overload));
        } else if tick >= self.last_tick {
            self.end = Some(End::TimeLimit);
        } else if tick >= self.next_snapshot {
            self.snapshot();
            self.aim_snapshot();
        }
        if self.end.is_some() {
            let State { closed_loop, tally, .. } = &self.state;
            self.recording.finish(tick, closed_loop.row(), tally.as_ref());
        }
    }

    /// The next snapshot is taken at the next whole number of its ticks.
    fn aim_snapshot(&mut self) {
        let tick = self.state.closed_loop.tick();
        self.next_snapshot = (tick / self.snapshot_ticks + 1) * self.snapshot_ticks;
    }

    fn snapshot(&mut self) {
        if self.snapshots.len() >= MAX_SNAPSHOTS {
            self.snapshot_ticks *= 2;
            let spacing = self.snapshot_ticks;
            self.snapshots.retain(|state| state.closed_loop.tick().is_multiple_of(spacing));
            if !self.state.closed_loop.tick().is_multiple_of(spacing) {
                return;
            }
        }
        self.snapshots.push(self.state.clone());
    }

    /// Goes back to the last snapshot from which the run can be repeated with `edits`, and takes
    /// them over. Both the old and the new edits must agree before `from_s`.
    pub fn branch(&mut self, from_s: f64, edits: &Edits) {
        let from = self.base.ticks(from_s);
        while self.snapshots.len() > 1
            && self.snapshots.last().is_some_and(|state| state.closed_loop.tick() > from)
        {
            self.snapshots.pop();
        }
        if let Some(state) = self.snapshots.last() {
            self.state = state.clone();
        }
        self.aim_snapshot();
        self.recording.truncate(self.state.closed_loop.tick());
        self.end = None;
        self.take_edits(edits);
    }

    /// A repeat of this run that is to show ticks from `from` on: it begins at the last snapshot before
    /// them, or goes on with `before`, a repeat of this run with these edits, where that is nearer.
    #[must_use]
    pub fn repeat(&self, from: u64, before: Option<Repeat>) -> Repeat {
        let known = self.snapshots.partition_point(|state| state.closed_loop.tick() <= from);
        // The first snapshot is that of tick 0.
        let snapshot = &self.snapshots[known.saturating_sub(1)];
        let near = snapshot.closed_loop.tick()..=from;
        before.filter(|repeat| near.contains(&repeat.tick())).unwrap_or_else(|| Repeat {
            state: snapshot.clone(),
            edits: self.edits.clone(),
            edit_ticks: self.edit_ticks.clone(),
        })
    }

    /// Why the run is over, if it is.
    #[must_use]
    pub fn end(&self) -> Option<&End> {
        self.end.as_ref()
    }

    /// The scenario as it was at the start.
    #[must_use]
    pub fn scenario(&self) -> &Scenario {
        &self.base
    }

    /// The edits.
    #[must_use]
    pub fn edits(&self) -> &Edits {
        &self.edits
    }

    /// Steps done so far.
    #[must_use]
    pub fn ticks(&self) -> u64 {
        self.state.closed_loop.tick()
    }

    /// The most steps that the time limit allows.
    #[must_use]
    pub fn last_tick(&self) -> u64 {
        self.last_tick
    }

    /// Fraction of the way that is done, 0 to 1; of the time limit where that is more, and 1 at the end.
    #[must_use]
    pub fn share_done(&self) -> f64 {
        if self.end.is_some() {
            return 1.0;
        }
        let of_time = self.ticks() as f64 / self.last_tick as f64;
        let of_path = self.state.closed_loop.row().position_mm / self.path_mm;
        limit(of_path, of_time, 1.0)
    }

    /// The rows recorded so far.
    #[must_use]
    pub fn recording(&self) -> &Recording {
        &self.recording
    }

    /// The teeth that broke under their load so far, in order.
    #[must_use]
    pub fn breakages(&self) -> &[Breakage] {
        self.state.closed_loop.breakages()
    }

    /// The loop as it stands after the last step.
    #[must_use]
    pub fn closed_loop(&self) -> &ClosedLoop {
        &self.state.closed_loop
    }

    /// Metrics over all plant steps so far.
    #[must_use]
    pub fn metrics(&self) -> Metrics {
        let rows = self.recording.rows().len();
        metrics::metrics(&self.recording, rows, &self.base, self.edits())
    }
}

/// Steps of the plant between two looks at whether the job is cancelled.
pub(super) const LOOK_TICKS: u64 = 4096;

/// A step is one of the plant.
impl Job for Run {
    type Partial = Metrics;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        while self.end.is_none() {
            let granted = budget.spend(LOOK_TICKS);
            if granted == 0 {
                break;
            }
            let before = self.ticks();
            Self::advance(self, granted);
            budget.put_back(granted - (self.ticks() - before));
        }
        self.end.is_some()
    }

    fn progress(&self) -> Progress {
        let total = self.last_tick as f64;
        Progress { done: self.share_done() * total, total, unit: text!("steps") }
    }

    fn partial(&self) -> Metrics {
        self.metrics()
    }
}
