//! The disturbances that a run has met, as changes.

use super::super::met_disturbances::met;
use super::super::one_run::Run;
use super::super::signals::Row;
use super::changes::{Cause, Change};
use super::scan::RowSpan;

/// Where each begins and where it is over, in no order.
pub(super) fn disturbances(run: &Run, rows: &[Row]) -> Vec<Change> {
    let mut found = Vec::new();
    for met in met(run, rows) {
        let kind = met.kind;
        let mut add = |row: usize, begins: bool| {
            let length_mm = kind.lasts().then_some(met.zone.length_mm);
            let size = kind.size().map(|_| met.zone.size);
            let causes = vec![Cause::Disturbance { kind, begins, length_mm, size }];
            found.push(Change { rows: RowSpan { first: row, last: row }, causes });
        };
        // A change is compared with the row before it.
        if rows.len() > 1 {
            add(met.from.max(1), true);
        }
        if let Some(to) = met.to {
            add(to, false);
        }
    }
    found
}
