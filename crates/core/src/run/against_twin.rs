//! How a run compares with its constant-feed twin, over the same length of the way.

use super::metrics::{Counting, Metrics};
use super::one_run::Run;
use super::recording::Recording;
use super::signals::Row;

/// The chosen run up to some row against the twin over the same length of path.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// The chosen run up to that row.
    pub chosen: Metrics,
    /// The twin up to where it has done the same path.
    pub twin: Metrics,
    /// Time that the chosen run saves on the path that both have done, s; negative if it is
    /// slower.
    pub time_saved_s: f64,
    /// The twin where it has done the same path.
    pub twin_now: Row,
}

/// What the times of two cuts say.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TimeJudged {
    /// Neither is rougher than allowed: what the chosen one saves of the twin's time, percent; negative if it is
    /// slower.
    AtEqualQuality(f64),
    /// One of them is, or may be: whether each holds, the chosen one first; none where that is not known. A faster
    /// cut that is scrap is no gain.
    NotCompared([Option<bool>; 2]),
}

impl Comparison {
    /// Whether control has bought time. Both hold where at most what may be missed of a target that counts as held is
    /// rougher than allowed ([`Metrics::not_above`]).
    #[must_use]
    pub fn time_judged(&self) -> TimeJudged {
        let hold = [&self.chosen, &self.twin].map(Metrics::not_above);
        if hold == [Some(true); 2] && self.twin.time_of_cut_s > 0.0 {
            TimeJudged::AtEqualQuality(100.0 * self.time_saved_s / self.twin.time_of_cut_s)
        } else {
            TimeJudged::NotCompared(hold)
        }
    }
}

/// Row at which a run has done a length of path, if it ever has.
fn row_at_path(recording: &Recording, path_mm: f64) -> Option<usize> {
    let rows = recording.rows();
    let index = rows.partition_point(|row| row.position_mm < path_mm);
    (index < rows.len()).then_some(index)
}

/// Compares the runs over the path that the chosen one has done after `rows` rows.
#[must_use]
pub fn compare(chosen: &Run, rows: usize, twin: &Run) -> Comparison {
    let [mut of_chosen, mut of_twin] = [Counting::default(), Counting::default()];
    compare_on((chosen, &mut of_chosen), rows, (twin, &mut of_twin))
}

/// The same again and again, as a playhead shows more and more rows: each with what was counted of it so far.
#[must_use]
pub fn compare_on(
    (chosen, of_chosen): (&Run, &mut Counting),
    rows: usize,
    (twin, of_twin): (&Run, &mut Counting),
) -> Comparison {
    let all = chosen.recording().rows();
    let rows = rows.clamp(1, all.len());
    let now = &all[rows - 1];
    let twin_rows = twin.recording().rows();
    let (twin_row, time_saved_s) = match row_at_path(twin.recording(), now.position_mm) {
        Some(row) => (row, twin_rows[row].time_s - now.time_s),
        // The twin ends short of it: compare where it ends.
        None => {
            let last = twin_rows.len() - 1;
            let reached = row_at_path(chosen.recording(), twin_rows[last].position_mm);
            let chosen_s = reached.map_or(now.time_s, |row| all[row].time_s);
            (last, twin_rows[last].time_s - chosen_s)
        }
    };
    let of = |run: &Run, counting: &mut Counting, rows| {
        counting.metrics(run.recording(), rows, run.scenario(), run.edits())
    };
    Comparison {
        chosen: of(chosen, of_chosen, rows),
        twin: of(twin, of_twin, twin_row + 1),
        time_saved_s,
        twin_now: twin_rows[twin_row],
    }
}
