//! What went wrong last in the cut: a stop, a broken tooth, or scrap; from 2 s before it, it can be tried again.

use super::Session;
use crate::base::language::text;
use crate::run::metrics::Judged;
use crate::run::one_run::End;
use crate::run::signals::{Row, flag};

/// How far before it the playhead goes, s.
pub const BEFORE_MISHAP_S: f64 = 2.0;
/// What is said where nothing went wrong.
pub const NO_MISHAP: &str = text!(
    "Nothing has gone wrong so far: no tooth broke, nothing stopped the feed, no surface is scrap."
);

impl Session {
    /// Whether something went wrong up to the playhead; as old as [`Self::comparison`].
    #[must_use]
    pub fn has_mishap(&self) -> bool {
        self.stopped_s().is_some()
            || self.broke_s().is_some()
            || self.comparison.chosen.scrap_mm > 0.0
    }

    /// When that was, s: the latest of a stop of the feed, a broken tooth, and the beginning of a stretch of scrap.
    #[must_use]
    pub fn mishap_s(&self) -> Option<f64> {
        let all = [self.stopped_s(), self.broke_s(), self.scrap_s()];
        all.into_iter().flatten().reduce(f64::max)
    }

    /// When the cut was ended by a stop, a crash or a broken tool, s, once the playhead has come there.
    fn stopped_s(&self) -> Option<f64> {
        match self.finished()? {
            End::Overload(stop) => Some(stop.time_s),
            End::Crash(crash) => Some(crash.time_s),
            End::Breakage(broke) => Some(broke.time_s),
            End::Script(fault) => Some(fault.time_s),
            End::PathDone | End::TimeLimit | End::Fault(_) | End::Refused(_) => None,
        }
    }

    fn broke_s(&self) -> Option<f64> {
        let now_s = self.row().time_s;
        let mut broken = self.chosen.run().breakages().iter().map(|broke| broke.time_s);
        broken.rfind(|time_s| *time_s <= now_s)
    }

    /// When the last stretch of scrap before the playhead began, s.
    fn scrap_s(&self) -> Option<f64> {
        let judged = Judged::by(&self.current, self.chosen.run().recording().control_every());
        let is_scrap = |row: &Row| !row.has(flag::AIR) && judged.above(row);
        let rows = self.revealed();
        let last = rows.iter().rposition(is_scrap)?;
        let first =
            rows[..last].iter().rposition(|row| !is_scrap(row)).map_or(0, |before| before + 1);
        Some(rows[first].time_s)
    }
}
