//! The twin drawn by place: at the time when the cut is at the same place of the part, as everything else on
//! the screen compares them.

use crate::app::session::Session;
use crate::run::recording::Recording;

/// The ways of the cut and of its twin.
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
        let moved = points.into_iter().filter_map(|[time_s, value]| {
            let row = self.cut.rows().get(before(self.cut, place_mm(self.twin, time_s)))?;
            Some([row.time_s, value])
        });
        moved.collect()
    }
}
