//! Where a run has met its disturbances, as the edits had placed them when the tool came there.

use super::one_run::Run;
use super::signals::Row;
use crate::models::disturbances::{Disturbance, Zone};

/// A disturbance that a run has met.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MetDisturbance {
    /// Its kind.
    pub kind: Disturbance,
    /// Its place, length and size.
    pub zone: Zone,
    /// The row from which on it acts.
    pub from: usize,
    /// The row at which its length is over; none where the tool has not come there, or where it stays.
    pub to: Option<usize>,
}

/// All that the first rows of a run have met, kind by kind and by place; the teeth that broke under their load are among
/// the broken ones.
#[must_use]
pub fn met(run: &Run, rows: &[Row]) -> Vec<MetDisturbance> {
    let mut found = placed(run, rows);
    let last_s = rows.last().map_or(0.0, |row| row.time_s);
    for broke in run.breakages().iter().filter(|broke| broke.time_s <= last_s) {
        let zone = Zone { at_mm: broke.position_mm, length_mm: f64::INFINITY, size: 1.0 };
        let from = rows.partition_point(|row| row.time_s < broke.time_s);
        found.push(MetDisturbance { kind: Disturbance::BrokenTooth, zone, from, to: None });
    }
    found
}

/// Those that the settings have placed.
fn placed(run: &Run, rows: &[Row]) -> Vec<MetDisturbance> {
    let mut found: Vec<MetDisturbance> = Vec::new();
    let edits = run.edits().list().iter().filter(|edit| edit.path.starts_with("disturbances."));
    let mut edits = edits.peekable();
    if run.scenario().disturbances.is_empty() && edits.peek().is_none() {
        return found;
    }
    let mut now = run.scenario().clone();
    let mut from = 0;
    loop {
        let next = edits.next();
        let to = next.map_or(rows.len(), |edit| run.recording().index_at(edit.at_s) + 1);
        let to = to.min(rows.len());
        for (kind, zone) in now.disturbances.all() {
            meet(rows, [from, to], (kind, zone), &mut found);
        }
        from = to;
        match next {
            // The run ends at an edit that does not fit.
            Some(edit) if now.set(&edit.path, edit.value.clone()).is_err() => return found,
            Some(_) => {}
            None => return found,
        }
    }
}

/// What begins or ends on the rows of a window.
fn meet(
    rows: &[Row],
    [from, to]: [usize; 2],
    (kind, zone): (Disturbance, Zone),
    found: &mut Vec<MetDisturbance>,
) {
    let row_at = |place_mm: f64| rows.partition_point(|row| row.position_mm < place_mm);
    let end = kind.lasts().then(|| row_at(zone.end_mm()));
    let known = found.iter().position(|met| met.kind == kind && met.zone == zone);
    let known = known.or_else(|| {
        let first = row_at(zone.at_mm).max(from);
        let begins = first < to && end.is_none_or(|end| first < end);
        begins.then(|| {
            found.push(MetDisturbance { kind, zone, from: first, to: None });
            found.len() - 1
        })
    });
    if let (Some(known), Some(end)) = (known, end)
        && (from..to).contains(&end)
    {
        found[known].to = Some(end);
    }
}
