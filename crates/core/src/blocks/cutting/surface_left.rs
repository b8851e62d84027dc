//! The surface that the last teeth have left: where the tool stood, by the angle of the spindle, over the last
//! turn.
//!
//! ```text
//! s_k = x(t) - x(t_k)        X_k = G [F_x(t) - F_x(t_k)],  Y_k likewise         turns(t_k) = turns(t) - k/z
//! s_1 = v_f / (z n)          of several teeth: the chip per tooth from the actual feed       (2005, Fig. 3)
//! ```
//!
//! t_k is when the k-th tooth before stood where a tooth stands now: by angle and not by time, so feed and
//! speed may change as they like. With the feed stopped every s_k falls to 0, and with it the chip, whatever
//! the run-out; once it moves again no chip is thicker than the way that is really gone. The tooth before alone
//! counts with the feed of the moment, as the paper has it and the reference figures were made with: a feed
//! that changes within a tooth period is felt half a tooth period early. Before the first record the tool
//! counts as fed steadily, without force.

use crate::models::mechanistic::{Advances, MAX_TEETH};

/// Records in a turn at most: a turn in steps of 0.18 degrees, nearly twice as fine as the samples of the
/// papers' set-up (0.33 degrees at 1592 1/min and 28.8 kHz). A slower spindle leaves samples out.
const PER_TURN: f64 = 2000.0;
/// Records that are kept, a power of two: a turn and some more.
const KEPT: usize = 2048;

/// Where the tool was at an instant.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Stand {
    /// Turns of the spindle since the history began.
    pub turns: f64,
    /// The axis along the cut, mm.
    pub x_mm: f64,
    /// Forces along and across the feed that bend the tool, N.
    pub force_n: [f64; 2],
}

/// The history of a turn.
#[derive(Clone, Debug)]
pub struct SurfaceLeft {
    teeth: usize,
    /// A ring; record number i is at i modulo its length.
    records: Vec<Stand>,
    /// Records so far.
    written: usize,
    /// The last record before the first tooth before stood here, the second one, ...
    before: [usize; MAX_TEETH],
    /// Feed per turn before the first record, mm.
    fed_before_mm: f64,
    /// How far the tool has come in the last turn, mm.
    last_turn_mm: f64,
}

impl SurfaceLeft {
    /// Nothing has passed yet; for a cutter of `teeth` teeth, 1 to [`MAX_TEETH`].
    #[must_use]
    pub fn new(teeth: usize) -> Self {
        Self {
            teeth,
            records: vec![Stand::default(); KEPT],
            written: 0,
            before: [0; MAX_TEETH],
            fed_before_mm: 0.0,
            last_turn_mm: 0.0,
        }
    }

    /// How far the tool was fed in the last turn, mm.
    #[must_use]
    pub fn last_turn_mm(&self) -> f64 {
        self.last_turn_mm
    }

    /// Forgets all.
    pub fn restart(&mut self) {
        (self.written, self.before) = (0, [0; MAX_TEETH]);
    }

    /// Takes over what another cutter has left, if it has as many teeth.
    pub fn take_over(&mut self, before: &Self) {
        if self.teeth == before.teeth {
            self.clone_from(before);
        }
    }

    /// The tool comes to stand at `now`, no fewer turns than ever before, fed by `feed_per_tooth_mm`; how far it
    /// has come since the teeth before stood here. `compliance_mm_n` is G.
    #[inline]
    pub fn stand(&mut self, now: &Stand, feed_per_tooth_mm: f64, compliance_mm_n: f64) -> Advances {
        if self.written == 0 {
            self.fed_before_mm = self.teeth as f64 * feed_per_tooth_mm;
        }
        if self.written == 0 || now.turns - self.newest().turns >= 1.0 / PER_TURN {
            self.records[self.written & (KEPT - 1)] = *now;
            self.written += 1;
        }
        let mut advances = [[0.0; 2]; MAX_TEETH];
        for (k, advance) in advances[..self.teeth].iter_mut().enumerate() {
            let Stand { x_mm, force_n: [x, y], .. } = self.at(k, now);
            let bent = |force: f64, before: f64| compliance_mm_n * (force - before);
            let [x, y] = [bent(now.force_n[0], x), bent(now.force_n[1], y)];
            self.last_turn_mm = now.x_mm - x_mm;
            let fed_mm = match k == 0 && self.teeth > 1 {
                true => feed_per_tooth_mm,
                false => self.last_turn_mm,
            };
            *advance = [fed_mm + x, y];
        }
        advances
    }

    fn newest(&self) -> &Stand {
        &self.records[(self.written - 1) & (KEPT - 1)]
    }

    /// Where the tool was a share (k + 1)/z of a turn before `now`: the place between two records, the forces of
    /// the nearer one, as the samples of one tooth period before are in the papers.
    #[inline]
    fn at(&mut self, k: usize, now: &Stand) -> Stand {
        let turns = now.turns - (k + 1) as f64 / self.teeth as f64;
        let record = |number: usize| &self.records[number & (KEPT - 1)];
        let mut last = self.before[k];
        while last + 1 < self.written && record(last + 1).turns <= turns {
            last += 1;
        }
        self.before[k] = last;
        let low = record(last);
        if turns < low.turns {
            let x_mm = low.x_mm - (low.turns - turns) * self.fed_before_mm;
            return Stand { turns, x_mm, force_n: [0.0; 2] };
        }
        let high = if last + 1 < self.written { record(last + 1) } else { now };
        let span = high.turns - low.turns;
        let share = if span > 0.0 { (turns - low.turns) / span } else { 0.0 };
        Stand {
            turns,
            x_mm: low.x_mm + share * (high.x_mm - low.x_mm),
            force_n: if share < 0.5 { low.force_n } else { high.force_n },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Stands fed by `feed_mm` a turn, `steps` to a turn; the last advances.
    fn turn(
        surface: &mut SurfaceLeft,
        at: &mut Stand,
        turns: f64,
        steps: f64,
        feed_mm: f64,
    ) -> Advances {
        let mut last = [[0.0; 2]; MAX_TEETH];
        for _ in 0..(turns * steps).round() as usize {
            last = surface.stand(at, feed_mm / surface.teeth as f64, 1e-5);
            at.turns += 1.0 / steps;
            at.x_mm += feed_mm / steps;
        }
        last
    }

    #[test]
    fn a_steady_feed_has_come_by_its_share_of_the_turn_at_any_rate_of_samples() {
        for teeth in 1..=MAX_TEETH {
            for steps in [11.3, 1085.7, 17_280.0, 123_456.7] {
                let mut surface = SurfaceLeft::new(teeth);
                let advances = turn(&mut surface, &mut Stand::default(), 3.4, steps, 0.3);
                for (k, [x, y]) in advances[..teeth].iter().enumerate() {
                    let expected = 0.3 * (k + 1) as f64 / teeth as f64;
                    assert!((x - expected).abs() < 1e-11, "{teeth} {steps} {k}: {x} {expected}");
                    assert_eq!(*y, 0.0);
                }
            }
        }
    }

    #[test]
    fn a_stopped_feed_is_felt_for_a_turn_and_a_new_one_grows_from_there() {
        for teeth in [1, 3] {
            let mut surface = SurfaceLeft::new(teeth);
            let mut at = Stand::default();
            turn(&mut surface, &mut at, 2.0, 1000.0, 0.2);
            let whole = |advances: &Advances| advances[teeth - 1][0];
            let later = turn(&mut surface, &mut at, 0.25, 1000.0, 0.0);
            assert!((whole(&later) - 0.15).abs() < 1e-3, "{later:?}");
            let none = turn(&mut surface, &mut at, 7.0, 1000.0, 0.0);
            assert!(none.iter().all(|[x, _]| x.abs() < 1e-12), "{none:?}");
            let grown = turn(&mut surface, &mut at, 0.25, 1000.0, 0.2);
            assert!((whole(&grown) - 0.05).abs() < 1e-3, "{grown:?}");
        }
    }

    #[test]
    fn a_standing_spindle_cuts_nothing_away_where_it_is_fed() {
        let mut surface = SurfaceLeft::new(3);
        let mut at = Stand::default();
        turn(&mut surface, &mut at, 2.0, 500.0, 0.3);
        let mut last = surface.stand(&at, 0.0, 0.0)[2][0];
        for _ in 0..5000 {
            at.x_mm += 0.001;
            let [x, _] = surface.stand(&at, 0.0, 0.0)[2];
            assert!((x - last - 0.001).abs() < 1e-12, "{x} after {last}");
            last = x;
        }
    }

    #[test]
    fn the_force_of_a_tooth_before_bends_the_surface() {
        let mut surface = SurfaceLeft::new(2);
        let pushed = Stand { force_n: [100.0, -50.0], ..Stand::default() };
        surface.stand(&pushed, 0.0, 1e-5);
        let [first, second] = [0.5, 1.0].map(|turns| {
            let now = Stand { turns, ..Stand::default() };
            surface.stand(&now, 0.0, 1e-5)
        });
        assert_eq!(first[0], [-1e-3, 5e-4]);
        assert_eq!((second[0], second[1]), ([0.0; 2], [-1e-3, 5e-4]));
    }
}
