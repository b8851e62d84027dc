//! How the surface compares with what was asked for: colour of a place, and lengths.

use egui::Color32;

use crate::app::session::Session;
use crate::app::theme;
use crate::base::units::ratio_from_percent;
use crate::blocks::reference::Reference;
use crate::run::signals::{Row, flag};

/// How far a row is off what is held, in tolerances; nothing in the air.
pub fn off(row: &Row, session: &Session) -> Option<f64> {
    let target = &session.current().target;
    let tolerance = ratio_from_percent(target.tolerance_percent);
    let off = match target.reference {
        Reference::Ra => row.ra_um / row.ra_target_um - 1.0,
        Reference::Force => row.force_n / row.force_ref_n - 1.0,
    };
    (!row.has(flag::AIR)).then_some(off.abs() / tolerance)
}

/// Within the tolerance 0, up to twice as far off 1, farther 2: scrap.
fn grade(off: f64) -> usize {
    if off <= 1.0 {
        0
    } else if off <= 2.0 {
        1
    } else {
        2
    }
}

/// The colour of a place that is so far off.
pub fn color(off: Option<f64>) -> Color32 {
    off.map_or(theme::METAL, |off| theme::MACHINED[grade(off)])
}

/// Lengths of the way that were cut so far, by grade, mm.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Lengths {
    /// Within the tolerance, up to twice as far off, farther.
    pub mm: [f64; 3],
    rows: usize,
}

impl Lengths {
    /// Goes on to the last row that is revealed.
    pub fn extend(&mut self, session: &Session) {
        let rows = session.revealed();
        for pair in rows[self.rows.saturating_sub(1).min(rows.len())..].windows(2) {
            if let Some(off) = off(&pair[1], session) {
                self.mm[grade(off)] += (pair[1].position_mm - pair[0].position_mm).max(0.0);
            }
        }
        self.rows = self.rows.max(rows.len());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::run::edits::Edits;
    use crate::run::presets::load;

    #[test]
    fn the_lengths_of_a_cut_add_up_to_its_way() {
        let mut session = Session::new(load("table3-5").unwrap(), Edits::none());
        let mut lengths = Lengths::default();
        for _ in 0..40 {
            session.advance(0.25);
            lengths.extend(&session);
        }
        let whole: f64 = lengths.mm.iter().sum();
        assert!((whole - session.row().position_mm).abs() < 1e-6, "{lengths:?}");
        // It starts out of tolerance and is brought within it.
        assert!(lengths.mm[0] > 40.0 && lengths.mm[2] > 0.5, "{lengths:?}");
        let mut once = Lengths::default();
        once.extend(&session);
        assert!((0..3).all(|i| (once.mm[i] - lengths.mm[i]).abs() < 1e-9));
    }

    #[test]
    fn grades_have_their_colours() {
        assert_eq!(color(None), theme::METAL);
        assert_eq!([0.3, 1.5, 2.5].map(|off| color(Some(off))), theme::MACHINED);
    }
}
