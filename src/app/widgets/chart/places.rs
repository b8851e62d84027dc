//! The twin, and a cut driven by hand, drawn by place: at the time when the cut is at the same place of the part, as
//! everything else on the screen compares them.

use crate::app::session::Session;
use crate::run::recording::Recording;
use crate::run::signals::Row;

/// The ways of the cut and of its twin, or of another cut in the twin's place.
pub(super) struct Places<'a> {
    cut: &'a Recording,
    twin: &'a Recording,
}

/// Rows before a place along the way.
fn before(recording: &Recording, place_mm: f64) -> usize {
    recording.rows().partition_point(|row| row.position_mm < place_mm)
}

/// Where a run is at a time.
fn place_mm(recording: &Recording, time_s: f64) -> f64 {
    recording.rows()[recording.index_at(time_s)].position_mm
}

impl<'a> Places<'a> {
    /// Those of a session.
    pub fn of(session: &'a Session) -> Self {
        let [cut, twin] = [session.chosen(), session.twin()].map(|cut| cut.run().recording());
        Self { cut, twin }
    }

    /// Those of a session's cut and another one of the same part.
    pub fn beside(session: &'a Session, other: &'a Recording) -> Self {
        Self { cut: session.chosen().run().recording(), twin: other }
    }

    /// When the twin is where the cut is at a time, s; its end where it never comes there.
    pub fn of_twin(&self, time_s: f64) -> f64 {
        let rows = self.twin.rows();
        let row = before(self.twin, place_mm(self.cut, time_s)).min(rows.len() - 1);
        rows[row].time_s
    }

    /// How many rows of the twin lie no further along the way than the cut is at a time.
    pub fn rows_of_twin(&self, time_s: f64) -> usize {
        let there_mm = place_mm(self.cut, time_s);
        self.twin.rows().partition_point(|row| row.position_mm <= there_mm)
    }

    /// Points of the twin at the times when the cut is at their places; those where it does not come are left
    /// out.
    pub fn at_the_cut(&self, points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
        let rows = self.cut.rows();
        let mut near = 0;
        let moved = points.into_iter().filter_map(|[time_s, value]| {
            near = before_from(rows, near, place_mm(self.twin, time_s));
            Some([rows.get(near)?.time_s, value])
        });
        moved.collect()
    }
}

/// Rows before a place along the way, looked for from row `near` on, in steps that double: the next point of a
/// curve is some rows further, and a search among all of them would be most of the work of a chart.
fn before_from(rows: &[Row], near: usize, place_mm: f64) -> usize {
    let is_before = |row: &Row| row.position_mm < place_mm;
    if near > 0 && !rows.get(near - 1).is_some_and(is_before) {
        return rows.partition_point(is_before);
    }
    let (mut low, mut step) = (near, 1);
    while rows.get(low + step - 1).is_some_and(is_before) {
        low += step;
        step *= 2;
    }
    let high = (low + step).min(rows.len());
    low + rows[low..high].partition_point(is_before)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_search_from_anywhere_finds_what_one_among_all_finds() {
        let place = |i: i32| f64::from(i / 3);
        let rows: Vec<Row> =
            (0..100).map(|i| Row { position_mm: place(i), ..Row::default() }).collect();
        for near in 0..=rows.len() {
            for i in -1..=102 {
                for place_mm in [place(i), place(i) - 0.5] {
                    let all = rows.partition_point(|row| row.position_mm < place_mm);
                    assert_eq!(before_from(&rows, near, place_mm), all, "{place_mm} from {near}");
                }
            }
        }
        assert_eq!(before_from(&[], 0, 1.0), 0);
    }
}
