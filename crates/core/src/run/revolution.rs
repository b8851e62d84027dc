//! The force within a revolution: the last turns of the spindle before a moment at the rate of the
//! plant steps (28.8 kHz in the papers' set-up). A recording keeps fewer rows; these samples come
//! from repeating the run from its last snapshot, so they are exactly the forces of the run.

use super::closed_loop::ClosedLoop;
use super::job::{Budget, Job, Progress};
use super::one_run::{Repeat, Run};
use crate::base::language::text;
use crate::base::units::rev_s_from_rpm;
use crate::models::spindle::SLOWEST_RPM;

/// Most turns at once.
pub const MAX_TURNS: u32 = 8;

/// The forces on the tool at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RevolutionSample {
    /// Time since the start of the run, s.
    pub time_s: f64,
    /// Angle of the spindle, from 0 to below 360 deg; at 0 the first tooth's tip stands across the
    /// feed, where it would enter a full cut.
    pub angle_deg: f64,
    /// Force along the feed, N.
    pub fx_n: f64,
    /// Force across it, N.
    pub fy_n: f64,
    /// Force along the tool's axis, N.
    pub fz_n: f64,
}

impl RevolutionSample {
    fn of(closed_loop: &ClosedLoop) -> Option<Self> {
        let ([fx_n, fy_n, fz_n], turn) = closed_loop.teeth()?;
        let time_s = closed_loop.row().time_s;
        Some(Self { time_s, angle_deg: 360.0 * turn, fx_n, fy_n, fz_n })
    }

    /// Force across the tool, |F_xy| = sqrt(F_x^2 + F_y^2), N.
    #[must_use]
    pub fn fxy_n(&self) -> f64 {
        (self.fx_n * self.fx_n + self.fy_n * self.fy_n).sqrt()
    }
}

/// Samples up to the end of the last whole control period.
#[derive(Clone, Debug, PartialEq)]
pub struct Revolution {
    /// One after the other, a plant step apart.
    pub samples: Vec<RevolutionSample>,
    /// The first sample of the last control period; `None` before the first one is whole.
    pub window_from: Option<usize>,
    /// Where the force across is largest in that control period: its F_m.
    pub peak: Option<usize>,
}

/// A revolution that is being repeated, in slices: the way from the last snapshot may be long.
#[derive(Clone, Debug)]
pub struct RevolutionJob {
    repeat: Repeat,
    /// Where the repeat began.
    begun: u64,
    from: u64,
    to: u64,
    /// Samples of a control period, where one is whole.
    control: Option<usize>,
    samples: Vec<RevolutionSample>,
    done: bool,
}

impl RevolutionJob {
    /// The last `turns` turns (1 to [`MAX_TURNS`]) of the spindle up to the control period whose peak
    /// force holds at `at_s`. `before` is the repeat that another job of the same run with the same
    /// edits has left.
    #[must_use]
    pub fn new(run: &Run, at_s: f64, turns: u32, before: Option<Repeat>) -> Self {
        let scenario = run.scenario();
        let at = scenario.ticks(at_s.max(0.0)).min(run.ticks());
        // Windows begin with the sample of tick 0.
        let control = u64::from(scenario.run.steps_per_control);
        let whole = (at + 1) / control;
        let to = if whole > 0 { whole * control - 1 } else { at };
        let recording = run.recording();
        let row = recording.rows()[recording.index_at(to as f64 * scenario.dt_s())];
        let turn_s = 1.0 / rev_s_from_rpm(row.spindle_rpm.max(SLOWEST_RPM));
        let turns = f64::from(turns.clamp(1, MAX_TURNS));
        let count = (turns * turn_s / scenario.dt_s()).round() as u64;
        // The window whose peak is marked is always in the picture.
        let count = if whole > 0 { count.max(control) } else { count };
        let from = (to + 1).saturating_sub(count);
        let repeat = run.repeat(from, before);
        Self {
            begun: repeat.closed_loop().tick(),
            repeat,
            from,
            to,
            control: (whole > 0).then_some(control as usize),
            samples: Vec::with_capacity(count as usize),
            done: false,
        }
    }

    /// What was found, and the repeat for a job that goes on from here. Nothing is found where the
    /// run is not tooth by tooth.
    #[must_use]
    pub fn finish(self) -> (Option<Revolution>, Repeat) {
        (self.partial(), self.repeat)
    }
}

/// A step is one of the plant, on the way to the turns or in them.
impl Job for RevolutionJob {
    type Partial = Option<Revolution>;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        while !self.done && budget.step() {
            let closed_loop = self.repeat.closed_loop();
            let tick = closed_loop.tick();
            if tick >= self.from {
                match RevolutionSample::of(closed_loop) {
                    Some(sample) => self.samples.push(sample),
                    // What lies before another force model is not of these turns.
                    None => self.samples.clear(),
                }
            }
            self.done = tick >= self.to || self.repeat.step().is_err();
        }
        self.done
    }

    fn progress(&self) -> Progress {
        let total = (self.to + 1 - self.begun.min(self.to)) as f64;
        let tick = self.repeat.closed_loop().tick();
        let done = if self.done { total } else { tick.saturating_sub(self.begun) as f64 };
        Progress { done, total, unit: text!("steps") }
    }

    fn partial(&self) -> Option<Revolution> {
        let samples = self.samples.clone();
        let window_from = self.control.and_then(|control| samples.len().checked_sub(control));
        let peak = window_from.filter(|_| self.done).and_then(|from| {
            let across_n = |i: &usize| samples[*i].fxy_n();
            (from..samples.len()).max_by(|a, b| across_n(a).total_cmp(&across_n(b)))
        });
        let window_from = window_from.filter(|_| self.done);
        (!samples.is_empty()).then_some(Revolution { samples, window_from, peak })
    }
}

/// The revolution at once; see [`RevolutionJob::new`]. `None` where the run is not tooth by tooth.
#[must_use]
pub fn revolution(run: &Run, at_s: f64, turns: u32) -> Option<Revolution> {
    let mut job = RevolutionJob::new(run, at_s, turns, None);
    job.to_end();
    job.finish().0
}
