//! The cuts of a whole run that are nearest to chatter: at each speed the deepest one, with where it is.

use super::{Operating, far};
use crate::app::session::Session;
use crate::run::signals::{Row, flag};

/// Most cuts that are judged: each takes some ten milliseconds.
const MOST: usize = 4;

/// A cut of the run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct CutOfRun {
    /// Speed and depth.
    pub at: Operating,
    /// From where to where along the way, mm.
    pub from_to_mm: [f64; 2],
}

/// The deepest cuts of the run as far as it is simulated, the deepest first, at different speeds.
pub(super) fn deepest(session: &Session) -> Vec<CutOfRun> {
    let rows = session.chosen().run().recording().rows();
    let changes = session.chosen().scan().depth();
    let begins = std::iter::once(0).chain(changes.iter().map(|span| span.last));
    let ends = changes.iter().map(|span| span.first).chain([rows.len()]);
    let stretches = begins.zip(ends).filter(|(from, to)| from < to);
    let mut found: Vec<CutOfRun> = stretches
        .filter_map(|(from, to)| {
            // At its end the speed has settled.
            let last: &Row = &rows[to - 1];
            let at = Operating { speed_rpm: last.spindle_rpm, depth_mm: last.axial_depth_mm };
            let cuts = !last.has(flag::AIR) && at.depth_mm > 0.0 && at.speed_rpm > 0.0;
            cuts.then_some(CutOfRun { at, from_to_mm: [rows[from].position_mm, last.position_mm] })
        })
        .collect();
    found.sort_by(|a, b| b.at.depth_mm.total_cmp(&a.at.depth_mm));
    let mut distinct: Vec<CutOfRun> = Vec::new();
    for cut in found {
        // At the same speed the deeper cut is nearer to chatter.
        let same_depth = |at: Operating| Operating { depth_mm: 0.0, ..at };
        if distinct.iter().all(|known| far(same_depth(known.at), same_depth(cut.at))) {
            distinct.push(cut);
        }
        if distinct.len() == MOST {
            break;
        }
    }
    distinct
}
