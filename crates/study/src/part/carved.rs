//! A blank as it is cut, at any place of the way: a map of few cells, to be looked at.
//!
//! The cells are the same whatever was looked at before: the tool goes on in whole pieces of its moves, and going back
//! begins at a map that was kept on the way. Heights over the middles of cells are those of a finer map there.

use super::blank::{Blank, HeightMap};
use super::gcode::{GCodeMove, GCodeProgram};
use crate::base::language::tr;
use crate::models::tool::Outline;

/// Cells of the map, about (chosen: a picture of them has some 80 000 triangles).
const CELLS: f64 = 40_000.0;
/// Maps that are kept along the way.
const KEPT: usize = 15;
/// Most pieces of a way.
const MOST_PIECES: f64 = 500_000.0;
/// What a length may miss by rounding, mm.
const HAIR_MM: f64 = 1e-9;
/// In the place of a piece: never cut, and cut by a rapid move.
const NEVER: u32 = u32::MAX;
const BY_RAPID: u32 = u32::MAX - 1;

/// What a cell was cut by last.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CutBy {
    /// It stands as it came.
    Nothing,
    /// A rapid move.
    Rapid,
    /// A feed move, in the piece of this number: [`CarvedBlank::piece_end_mm`] says where that ends.
    Piece(usize),
}

/// A point of the way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WayPoint {
    /// How far along the way, mm.
    pub s_mm: f64,
    /// The tip: x, y, z, mm.
    pub at_mm: [f64; 3],
    /// Whether the tool comes here from the point before without a rapid move.
    pub joined: bool,
}

/// How far the tool is, and what it has left.
#[derive(Clone, Debug)]
struct Stand {
    map: HeightMap,
    cut_by: Vec<u32>,
    /// The move under way, how far along it, and how far along the feed moves, mm.
    next: usize,
    gone_mm: f64,
    way_mm: f64,
    pieces: u32,
}

/// See the head of this file.
#[derive(Clone, Debug)]
pub struct CarvedBlank {
    outline: Outline,
    moves: Vec<GCodeMove>,
    piece_mm: f64,
    /// Where every move begins along the way of the feed moves, mm, and where the last one ends.
    begins_mm: Vec<f64>,
    /// Where every piece that was cut ends, mm.
    ends_mm: Vec<f64>,
    begin: Stand,
    now: Stand,
    kept: Vec<Stand>,
}

impl CarvedBlank {
    /// A program with a tool of this outline over a whole blank; the tool goes on by `piece_mm`, or by a cell where that
    /// is longer.
    ///
    /// # Errors
    /// A program without a feed move, or with more pieces than are kept.
    pub fn new(
        program: &GCodeProgram,
        blank: Blank,
        outline: Outline,
        piece_mm: f64,
    ) -> Result<Self, String> {
        let [x, y, _] = blank.size_mm;
        let map = HeightMap::new(blank, (x * y / CELLS).sqrt())?;
        let piece_mm = piece_mm.max(map.cell_mm());
        let moves = program.moves.clone();
        let mut begins_mm = Vec::with_capacity(moves.len() + 1);
        let (mut way_mm, mut pieces) = (0.0, 0.0);
        for one in &moves {
            begins_mm.push(way_mm);
            if !one.rapid {
                way_mm += one.length_mm();
                pieces += (one.length_mm() / piece_mm).ceil();
            }
        }
        begins_mm.push(way_mm);
        if way_mm <= HAIR_MM {
            return Err(tr("the program has no feed move: nothing is cut").to_owned());
        }
        if pieces > MOST_PIECES {
            return Err(tr!(
                "the way has {n:.0} pieces: at most {most} are drawn",
                n = pieces,
                most = MOST_PIECES
            ));
        }
        let cut_by = vec![NEVER; map.heights_mm().len()];
        let begin = Stand { map, cut_by, next: 0, gone_mm: 0.0, way_mm: 0.0, pieces: 0 };
        let (now, kept, ends_mm) = (begin.clone(), Vec::new(), Vec::new());
        Ok(Self { outline, moves, piece_mm, begins_mm, ends_mm, begin, now, kept })
    }

    /// The map as far as it is cut.
    #[must_use]
    pub fn map(&self) -> &HeightMap {
        &self.now.map
    }

    /// The tool's outline.
    #[must_use]
    pub fn outline(&self) -> &Outline {
        &self.outline
    }

    /// Length of the way, mm: that of the feed moves.
    #[must_use]
    pub fn length_mm(&self) -> f64 {
        self.begins_mm.last().copied().unwrap_or(0.0)
    }

    /// Number of pieces that the map has met: it is another one whenever this is another one.
    #[must_use]
    pub fn stand(&self) -> [usize; 2] {
        [self.now.next, self.now.pieces as usize]
    }

    /// What a cell, counted row by row along x, was cut by last.
    #[must_use]
    pub fn cut_by(&self, cell: usize) -> CutBy {
        match self.now.cut_by.get(cell) {
            None | Some(&NEVER) => CutBy::Nothing,
            Some(&BY_RAPID) => CutBy::Rapid,
            Some(piece) => CutBy::Piece(*piece as usize),
        }
    }

    /// Where a piece ends along the way, mm; none where it was never cut.
    #[must_use]
    pub fn piece_end_mm(&self, piece: usize) -> Option<f64> {
        self.ends_mm.get(piece).copied()
    }

    /// The move at a place of the way.
    fn move_at(&self, s_mm: f64) -> usize {
        let begun = self.begins_mm.partition_point(|begin| *begin <= s_mm);
        let last = begun.min(self.moves.len()).saturating_sub(1);
        // Where two begin at one place, the other is rapid and has no length there.
        let feed = |index: &usize| !self.moves[*index].rapid;
        let before = (0..=last).rev().find(feed);
        before.or_else(|| (last..self.moves.len()).find(feed)).unwrap_or(last)
    }

    /// Where the tip is at a place of the way: x, y, z, mm. Before the way it stands at its start.
    #[must_use]
    pub fn tip_mm(&self, s_mm: f64) -> [f64; 3] {
        let index = self.move_at(s_mm.clamp(0.0, self.length_mm()));
        let Some(one) = self.moves.get(index) else { return [0.0; 3] };
        let gone_mm = (s_mm - self.begins_mm[index]).max(0.0);
        one.at((gone_mm / one.length_mm().max(HAIR_MM)).min(1.0))
    }

    /// The way, by at most so many points and one.
    #[must_use]
    pub fn way(&self, most: usize) -> Vec<WayPoint> {
        let length_mm = self.length_mm();
        let count = ((length_mm / self.piece_mm).ceil() as usize).clamp(1, most.max(1));
        let mut rapids = 0;
        let rapids: Vec<usize> = self
            .moves
            .iter()
            .map(|one| {
                rapids += usize::from(one.rapid);
                rapids
            })
            .collect();
        let mut before = None;
        (0..=count)
            .map(|i| {
                let s_mm = length_mm * i as f64 / count as f64;
                let passed = rapids.get(self.move_at(s_mm)).copied();
                let joined = before.replace(passed) == Some(passed);
                WayPoint { s_mm, at_mm: self.tip_mm(s_mm), joined }
            })
            .collect()
    }

    /// Cuts up to a place of the way, mm, or goes back to it; looks at about so many cells at most. Whether it is there.
    pub fn go_to(&mut self, s_mm: f64, most_cells: usize) -> bool {
        let s_mm = s_mm.clamp(0.0, self.length_mm());
        if self.now.way_mm > s_mm + HAIR_MM {
            let nearest = self.kept.iter().rfind(|kept| kept.way_mm <= s_mm + HAIR_MM);
            self.now = nearest.unwrap_or(&self.begin).clone();
        }
        let is_end = s_mm >= self.length_mm() - HAIR_MM;
        let cell_mm = self.now.map.cell_mm();
        let mut looked_at = 0.0;
        while let Some(one) = self.moves.get(self.now.next).copied() {
            let length_mm = one.length_mm();
            // A rapid move belongs to what comes behind it.
            let reached = match one.rapid {
                true => is_end || s_mm > self.now.way_mm + HAIR_MM,
                false => {
                    let piece_mm = (length_mm - self.now.gone_mm).min(self.piece_mm);
                    self.now.way_mm + piece_mm <= s_mm + HAIR_MM
                }
            };
            if !reached {
                return true;
            }
            if looked_at > most_cells as f64 {
                return false;
            }
            let piece_mm = self.piece(&one, length_mm);
            let across = (2.0 * self.outline.edge_mm() + piece_mm) / cell_mm + 1.0;
            looked_at += (across * across).min(CELLS);
        }
        true
    }

    /// A piece of a move; gives its length, mm.
    fn piece(&mut self, one: &GCodeMove, length_mm: f64) -> f64 {
        let now = &mut self.now;
        let to_mm = (now.gone_mm + self.piece_mm).min(length_mm);
        let ends = [now.gone_mm, to_mm].map(|mm| one.at(mm / length_mm));
        let piece_mm = to_mm - now.gone_mm;
        let by = if one.rapid { BY_RAPID } else { now.pieces };
        let cut_by = &mut now.cut_by;
        now.map.cut_each(&self.outline, ends, |cell| cut_by[cell.index] = by);
        now.gone_mm = to_mm;
        if !one.rapid {
            now.way_mm += piece_mm;
            if self.ends_mm.len() == now.pieces as usize {
                self.ends_mm.push(now.way_mm);
            }
            now.pieces += 1;
        }
        if length_mm - to_mm <= HAIR_MM {
            (now.next, now.gone_mm) = (now.next + 1, 0.0);
            // Sums of pieces do not run away from the moves' own.
            now.way_mm = self.begins_mm[now.next];
        }
        let wanted = (self.kept.len() + 1) as f64 / (KEPT + 1) as f64;
        if self.kept.len() < KEPT && self.now.way_mm >= wanted * self.length_mm() {
            self.kept.push(self.now.clone());
        }
        piece_mm
    }
}

#[cfg(test)]
mod tests {
    use super::super::EXAMPLE_GCODE;
    use super::super::milling::MillingJob;
    use super::*;
    use crate::base::settings::Value;
    use crate::run::job::Job;
    use crate::run::scenario::Scenario;

    const ALL: usize = usize::MAX;

    fn bracket() -> (GCodeProgram, Blank, Outline) {
        let program = GCodeProgram::read(EXAMPLE_GCODE).unwrap();
        let blank = Blank::new([100.0, 60.0, 20.0], None).unwrap();
        let mut scenario = Scenario::default();
        scenario.set("tool.name", Value::Text("square-12-4".to_owned())).unwrap();
        (program, blank, scenario.tool.outline())
    }

    fn carved() -> CarvedBlank {
        let (program, blank, outline) = bracket();
        CarvedBlank::new(&program, blank, outline, 0.5).unwrap()
    }

    #[test]
    fn at_its_end_it_is_what_the_program_leaves_and_the_way_is_as_long() {
        let (program, blank, outline) = bracket();
        let mut job = MillingJob::new(&program, blank, outline, 0.5).unwrap();
        job.to_end();
        let part = job.part().unwrap();
        let mut carved = carved();
        assert!((carved.length_mm() - part.length_mm).abs() < 1e-6);
        assert!(carved.go_to(carved.length_mm(), ALL));
        let [fine, coarse] = [job.map().removed_mm3(), carved.map().removed_mm3()];
        assert!((coarse / fine - 1.0).abs() < 0.02, "{coarse} of {fine}");
        for row in part.rows.iter().step_by(17) {
            let tip = carved.tip_mm(row.s_mm + 1e-9);
            let off = [0, 1, 2].map(|i: usize| (tip[i] - row.at_mm[i]).abs());
            assert!(off.iter().all(|off| *off < 1e-6), "{tip:?} {row:?}");
        }
    }

    #[test]
    fn it_is_the_same_whatever_was_looked_at_before() {
        let length_mm = carved().length_mm();
        for place in [0.0, 0.21, 0.5, 0.77, 1.0].map(|share| share * length_mm) {
            let mut straight = carved();
            assert!(straight.go_to(place, ALL));
            let mut about = carved();
            for before in [0.3, 0.9, 0.1, 1.0, 0.6] {
                about.go_to(before * length_mm, ALL);
            }
            // In small slices, too.
            let slices = (0..10_000).find(|_| about.go_to(place, 2_000));
            assert!(slices.is_some());
            assert_eq!(straight.map(), about.map(), "{place}");
            assert_eq!(straight.now.cut_by, about.now.cut_by, "{place}");
            assert_eq!(straight.stand(), about.stand());
        }
    }

    #[test]
    fn what_is_cut_knows_its_place_on_the_way_and_what_is_ahead_stands() {
        let mut carved = carved();
        let top = carved.map().blank().top_mm();
        carved.go_to(60.0, ALL);
        let map = carved.map().clone();
        let [columns, rows] = map.cells();
        let mut cut = 0;
        for (x, y) in (0..rows).flat_map(|y| (0..columns).map(move |x| (x, y))) {
            let height = map.height_mm([x, y]).unwrap();
            match carved.cut_by(y * columns + x) {
                CutBy::Nothing => assert_eq!(height, top),
                CutBy::Rapid => panic!("no rapid move cuts"),
                CutBy::Piece(piece) => {
                    assert!(height < top);
                    let s_mm = carved.piece_end_mm(piece).unwrap();
                    assert!(s_mm <= 60.0 + 1e-9);
                    // The tool was there.
                    let [tip_x, ..] = carved.tip_mm(s_mm);
                    let middle = (x as f64 + 0.5) * map.blank().size_mm[0] / columns as f64;
                    assert!((middle - tip_x).abs() < 6.6, "{middle} {tip_x}");
                    cut += 1;
                }
            }
        }
        assert!(cut > 100);
    }

    #[test]
    fn the_way_has_gaps_where_the_tool_is_lifted() {
        let way = carved().way(500);
        assert!(way.len() <= 501);
        let gaps: Vec<f64> = way[1..].iter().filter(|p| !p.joined).map(|p| p.s_mm).collect();
        assert_eq!(gaps.len(), 1, "{gaps:?}");
        assert!((gaps[0] - 178.85).abs() < 1.0, "{gaps:?}");
        assert_eq!(way.last().unwrap().at_mm, [55.0, -10.0, -2.0]);
    }
}
