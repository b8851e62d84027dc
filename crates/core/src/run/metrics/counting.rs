//! The metrics of a recording again and again, as a playhead shows more and more of its rows.

use super::{Judged, Metrics, Tally, counted, moves};
use crate::run::edits::Edits;
use crate::run::recording::Recording;
use crate::run::scenario::Scenario;

/// What was counted of a recording so far: rows that follow are counted on from there, where every plant step is
/// recorded; otherwise the recording itself keeps what was counted in the run.
///
/// It belongs to one recording: where rows of that are cut anew, or its scenario or edits change, [`Self::forget`] it.
///
/// ```
/// use steadycut_core::run::metrics::{Counting, metrics};
/// use steadycut_core::run::{edits::Edits, one_run::Run, presets};
///
/// let run = Run::complete(&presets::load("depth-step").unwrap(), &Edits::none());
/// let mut counting = Counting::default();
/// for rows in [2000, 9000, 5000, 12_000] {
///     let counted_on = counting.metrics(run.recording(), rows, run.scenario(), run.edits());
///     assert_eq!(counted_on, metrics(run.recording(), rows, run.scenario(), run.edits()));
/// }
/// ```
#[derive(Clone, Debug, Default)]
pub struct Counting {
    /// What was counted, and over how many rows, at least one.
    so_far: Option<(Tally, usize)>,
}

impl Counting {
    /// Begins anew.
    pub fn forget(&mut self) {
        self.so_far = None;
    }

    /// Metrics over the first `rows` rows of the recording, or all where there are fewer.
    #[must_use]
    pub fn metrics(
        &mut self,
        recording: &Recording,
        rows: usize,
        scenario: &Scenario,
        edits: &Edits,
    ) -> Metrics {
        let rows = rows.min(recording.rows().len());
        let Some(last) = rows.checked_sub(1) else { return Metrics::empty() };
        if let Some(tally) = recording.tally(last) {
            return counted(recording, rows, tally, &scenario.economics);
        }
        let before = self.so_far.take().filter(|(_, counted)| *counted <= rows);
        let (mut tally, from) = before.unwrap_or_else(|| {
            let judged = Judged::by(scenario, recording.control_every());
            (Tally::new(judged, &recording.rows()[0]), 1)
        });
        // An edit is due before the step from its tick to the next one.
        let moving = edits.list().iter().filter(|edit| moves(edit));
        let due = moving.map(|edit| recording.tick_of(edit.at_s) + 1);
        let mut due = due.skip_while(|at| *at < from as u64).peekable();
        for (tick, row) in (from as u64..).zip(&recording.rows()[from..rows]) {
            let mut moved = false;
            while due.next_if(|at| *at <= tick).is_some() {
                moved = true;
            }
            tally.add(row, moved);
        }
        let metrics = counted(recording, rows, &tally, &scenario.economics);
        self.so_far = Some((tally, rows));
        metrics
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::settings::Value;
    use crate::run::edits::Edit;
    use crate::run::metrics::metrics;
    use crate::run::one_run::Run;
    use crate::run::presets;

    #[test]
    fn counted_on_it_is_what_it_is_counted_at_once_with_edits_on_both_sides() {
        let scenario = presets::load("depth-step").unwrap();
        let mut edits = Edits::none();
        for (at_s, ra_um) in [(1.0, 0.7), (1.5, 0.9), (4.0, 0.8)] {
            let (path, value) = ("target.ra_um".to_owned(), Value::Float(ra_um));
            edits.push(&scenario, Edit { at_s, path, value }).unwrap();
        }
        let run = Run::complete(&scenario, &edits);
        let all = run.recording().rows().len();
        // On the tick of an edit, before and after it; back; on in one; more than there are.
        let (mut counting, mut settled) = (Counting::default(), Vec::new());
        for rows in [1, 1000, 1001, 1002, 1502, 4001, 4002, 900, 1600, all, all + 7] {
            let found = counting.metrics(run.recording(), rows, &scenario, &edits);
            assert_eq!(found, metrics(run.recording(), rows, &scenario, &edits), "{rows}");
            settled.push(found.settling_time_s);
        }
        settled.dedup();
        assert!(settled.len() > 4, "the edits count: {settled:?}");
        assert_eq!(counting.metrics(run.recording(), 0, &scenario, &edits), Metrics::empty());
    }
}
