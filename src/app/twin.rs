//! How the chosen run compares with its constant-feed twin.

use crate::run::metrics::{self, Metrics};
use crate::run::one_run::Run;
use crate::run::recording::Recording;
use crate::run::signals::Row;

/// The chosen run up to the playhead against the twin over the same length of path.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// The chosen run up to the playhead.
    pub chosen: Metrics,
    /// The twin up to where it has done the same path.
    pub twin: Metrics,
    /// Time that the chosen run saves on the path that both have done, s; negative if it is
    /// slower.
    pub time_saved_s: f64,
    /// The twin where it has done the same path.
    pub twin_now: Row,
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
    let of = |run: &Run, rows| metrics::metrics(run.recording(), rows, run.scenario(), run.edits());
    Comparison {
        chosen: of(chosen, rows),
        twin: of(twin, twin_row + 1),
        time_saved_s,
        twin_now: twin_rows[twin_row],
    }
}
