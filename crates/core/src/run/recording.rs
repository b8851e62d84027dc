//! The recording of a run: rows at even ticks, memory reserved once.

use super::digest::Digest;
use super::metrics::{Period, Tally};
use super::signals::{Row, flag};

/// Rows reserved at once, 46 MB: more memory is taken only as a run really needs it.
const RESERVED_ROWS: usize = 250_000;

/// All recorded rows of one run.
///
/// ```
/// use steadycut_core::run::{edits::Edits, one_run::Run, presets};
///
/// let run = Run::complete(&presets::load("table3-5").unwrap(), &Edits::none());
/// let rows = run.recording().rows();
/// let most = rows.iter().map(|row| row.force_n).fold(0.0, f64::max);
/// assert_eq!(most, run.metrics().max_force_n);
/// // The same scenario gives the same bits, so a digest says whether two runs are equal.
/// let again = Run::complete(run.scenario(), &Edits::none());
/// assert_eq!(run.recording().digest(), again.recording().digest());
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Recording {
    rows: Vec<Row>,
    /// At each row, what was counted over all plant steps up to it; empty where every step is a row.
    tallies: Vec<Tally>,
    /// Whether the last row is one that was not due.
    off_grid: bool,
    every: u64,
    dt_s: f64,
    control_every: u64,
}

impl Recording {
    /// An empty recording for at most `ticks` steps of `dt_s`, a row every `every` ticks, the
    /// controller sampling every `control_every` ticks.
    #[must_use]
    pub fn new(ticks: u64, every: u32, dt_s: f64, control_every: u32) -> Self {
        let every = u64::from(every.max(1));
        let capacity = usize::try_from(ticks / every + 2).unwrap_or(0).min(RESERVED_ROWS);
        Self {
            rows: Vec::with_capacity(capacity),
            tallies: Vec::with_capacity(if every > 1 { capacity } else { 0 }),
            off_grid: false,
            every,
            dt_s,
            control_every: u64::from(control_every),
        }
    }

    /// Keeps the row of `tick` if it is due.
    #[inline]
    pub fn push(&mut self, tick: u64, row: &Row) {
        if self.every == 1 || tick.is_multiple_of(self.every) {
            self.rows.push(*row);
        }
    }

    /// Whether some plant steps are not recorded: a [`Tally`] then has to be kept with each row.
    #[must_use]
    pub fn leaves_out(&self) -> bool {
        self.every > 1
    }

    /// Keeps the row of `tick` with the tally up to it, if it is due.
    #[inline]
    pub fn push_counted(&mut self, tick: u64, row: &Row, tally: &Tally) {
        if tick.is_multiple_of(self.every) {
            self.rows.push(*row);
            self.tallies.push(tally.clone());
        }
    }

    /// Keeps the last row of a run, due or not, with the tally up to it.
    pub fn finish(&mut self, tick: u64, row: &Row, tally: Option<&Tally>) {
        if !tick.is_multiple_of(self.every) {
            self.rows.push(*row);
            self.tallies.extend(tally.cloned());
            self.off_grid = true;
        }
    }

    /// What was counted up to row `index`; none where every plant step is a row.
    #[must_use]
    pub fn tally(&self, index: usize) -> Option<&Tally> {
        self.tallies.get(index)
    }

    /// The sums of a whole control period, counted from 1; 0 is the row before the first step.
    #[must_use]
    pub fn period(&self, number: u64) -> Period {
        let last = usize::try_from(number).unwrap_or(usize::MAX) * self.control_stride();
        if let Some(tally) = self.tallies.get(last) {
            return *tally.period();
        }
        let first = if number == 0 { 0 } else { last + 1 - self.control_stride() };
        Period::of(self.rows.get(first..=last).unwrap_or(&[]))
    }

    /// The rows of control samples among the first `rows` rows.
    pub fn samples(&self, rows: usize) -> impl Iterator<Item = &Row> {
        let on_grid = self.rows.len() - usize::from(self.off_grid);
        self.rows[..rows.min(on_grid)].iter().step_by(self.control_stride())
    }

    /// The rows of the last second in contact, or of the last second if there was no contact.
    #[must_use]
    pub fn last_second(rows: &[Row], row_s: f64) -> Vec<Row> {
        let window = ((1.0 / row_s).round() as usize).max(1);
        let contact = rows.iter().rev().filter(|row| !row.has(flag::AIR));
        let found: Vec<Row> = contact.take(window).copied().collect();
        if found.is_empty() { rows.iter().rev().take(window).copied().collect() } else { found }
    }

    /// Forgets all rows after `tick`.
    pub fn truncate(&mut self, tick: u64) {
        let rows = usize::try_from(tick / self.every).unwrap_or(0) + 1;
        // A row that was not due lies after every snapshot.
        self.off_grid = false;
        self.rows.truncate(rows);
        self.tallies.truncate(rows);
    }

    /// The rows, the first one at time 0.
    #[must_use]
    pub fn rows(&self) -> &[Row] {
        &self.rows
    }

    /// Time between rows, s.
    #[must_use]
    pub fn row_s(&self) -> f64 {
        self.dt_s * self.every as f64
    }

    /// Rows between control samples (at least 1).
    #[must_use]
    pub fn control_stride(&self) -> usize {
        usize::try_from(self.control_every / self.every).unwrap_or(1).max(1)
    }

    /// Plant steps in a control period.
    #[must_use]
    pub fn control_every(&self) -> u64 {
        self.control_every
    }

    /// A time in s as the nearest whole number of plant steps.
    #[must_use]
    pub fn tick_of(&self, time_s: f64) -> u64 {
        (time_s / self.dt_s).round() as u64
    }

    /// Index of the last row at or before a time in s; 0 for an empty recording.
    #[must_use]
    pub fn index_at(&self, time_s: f64) -> usize {
        // Half a thousandth of a row: times that were rounded in text still find their row.
        let index = (time_s / self.row_s() + 5e-4).max(0.0) as usize;
        index.min(self.rows.len().saturating_sub(1))
    }

    /// The digest over all rows.
    #[must_use]
    pub fn digest(&self) -> String {
        let mut digest = Digest::default();
        self.rows.iter().for_each(|row| digest.row(row));
        digest.hex()
    }
}
