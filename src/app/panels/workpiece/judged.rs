//! How the surface compares with what was asked for: colour of a place, and lengths.

use egui::Color32;

use crate::app::session::Session;
use crate::app::theme;
use crate::base::language::text;
use crate::base::units::ratio_from_percent;
use crate::blocks::reference::Reference;
use crate::run::signals::{Row, flag};
use crate::run::story::{deviation, shaken_deviation};

/// How far a row is above what is to be held (below: negative), in tolerances; nothing in the air and where Ra lies
/// outside its model. Where the machine vibrates in the cut, Ra with dynamics is what is left.
pub fn off(row: &Row, session: &Session) -> Option<f64> {
    let target = &session.current().target;
    let tolerance = ratio_from_percent(target.tolerance_percent);
    let off = match (target.reference, session.current().machine.coupled) {
        (Reference::Ra, true) => shaken_deviation(row),
        (Reference::Ra, false) | (Reference::Force, _) => deviation(row, target.reference),
    };
    off.map(|off| off / tolerance)
}

/// Within the tolerance 0, above it up to twice as far off 1, farther above 2, below it 3: a surface that is smoother
/// than it need be is no scrap.
fn grade(off: f64) -> usize {
    match off {
        within if within.abs() <= 1.0 => 0,
        below if below < 0.0 => 3,
        near if near <= 2.0 => 1,
        _ => 2,
    }
}

/// The grades in words, of what is to be held.
pub fn names(held: Reference) -> [&'static str; 4] {
    match held {
        Reference::Ra => [
            text!("within"),
            text!("too rough, up to twice as far off"),
            text!("rougher still"),
            text!("smoother than asked"),
        ],
        Reference::Force => [
            text!("within"),
            text!("too large, up to twice as far off"),
            text!("larger still"),
            text!("smaller than asked"),
        ],
    }
}

/// The colour of a place that is so far off.
pub fn color(off: Option<f64>) -> Color32 {
    off.map_or(theme::METAL, |off| theme::MACHINED[grade(off)])
}

/// Lengths of the way that were cut so far, by grade, mm.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Lengths {
    /// Those of [`names`].
    pub mm: [f64; 4],
    /// Outside the model: not judged.
    pub unknown_mm: f64,
    rows: usize,
}

impl Lengths {
    /// Goes on to the last row that is revealed.
    pub fn extend(&mut self, session: &Session) {
        let rows = session.revealed();
        for pair in rows[self.rows.saturating_sub(1).min(rows.len())..].windows(2) {
            let mm = (pair[1].position_mm - pair[0].position_mm).max(0.0);
            match off(&pair[1], session) {
                Some(off) => self.mm[grade(off)] += mm,
                None if pair[1].has(flag::AIR) => {}
                None => self.unknown_mm += mm,
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
        assert!((0..4).all(|i| (once.mm[i] - lengths.mm[i]).abs() < 1e-9));
    }

    /// Is the part good? What vibration leaves on it is what is coloured.
    #[test]
    fn where_the_machine_vibrates_ra_with_dynamics_is_coloured() {
        let mut session = Session::new(load("machine-dynamics").unwrap(), Edits::none());
        (0..8).for_each(|_| session.advance(0.25));
        let row = session.row();
        let known = (row.ra_dyn_um / row.ra_target_um - 1.0) / 0.1;
        assert!((off(row, &session).unwrap() - known).abs() < 1e-9 && row.ra_dyn_um != row.ra_um);
    }

    #[test]
    fn grades_have_their_colours() {
        assert_eq!(color(None), theme::METAL);
        assert_eq!([0.3, 1.5, 2.5, -1.5].map(|off| color(Some(off))), theme::MACHINED);
        assert_eq!([-0.3, -2.5].map(grade), [0, 3], "smoother than asked is no scrap");
    }
}
