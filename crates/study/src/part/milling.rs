//! A program cut from a blank: at each step of the way the engagement of the tool, and what is left.
//!
//! The feed moves are gone along in steps of one length, over the ends of moves as well, so that a program of many
//! short ones gives as steady a path as one of few; rapid moves cut what is in their way, are told and are no part of
//! the path. Of a step
//!
//! ```text
//! a_p = highest material that is taken - tip          a_e = width of what is taken, across the feed
//! ```
//!
//! so that a slot has the tool's diameter, a side cut its width, and a tool that leaves the material the two strips that
//! are left beside it. Where a step meets materials of several heights, a_p a_e is more than what is taken; the report
//! has both sums.

use std::fmt::Write as _;

use super::blank::{Blank, CutAway, HeightMap};
use super::gcode::{GCodeMove, GCodeProgram, NotFollowed};
use super::path::{PartPath, span};
use crate::base::language::{text, tr};
use crate::models::tool::Outline;
use crate::run::job::{Budget, Job, Progress};

/// Range of the step along the way, mm.
pub const STEPS_MM: [f64; 2] = [0.05, 10.0];
/// Cells of the map in a step: less than three and a strip across the feed could hold none.
const CELLS_PER_STEP: f64 = 4.0;
/// Most steps of a way.
const MOST_STEPS: f64 = 500_000.0;
/// What a length may miss by rounding, mm.
const HAIR_MM: f64 = 1e-9;
/// Least volume that a rapid move or a plunge is told for, mm^3.
const TOLD_MM3: f64 = 1e-3;
/// Most lines that a remark names.
const MOST_LINES: usize = 8;

/// A step of the way: the depths hold from its start to the next one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MilledRow {
    /// Where along the way it begins, mm.
    pub s_mm: f64,
    /// Where the tip is there: x, y, z, mm.
    pub at_mm: [f64; 3],
    /// Axial depth a_p, mm; 0 in the air.
    pub axial_mm: f64,
    /// Radial depth a_e, mm; 0 in the air.
    pub radial_mm: f64,
    /// Programmed feed, mm/min.
    pub feed_mm_min: Option<f64>,
    /// Programmed speed, 1/min.
    pub speed_rpm: Option<f64>,
    /// Volume that it takes, mm^3.
    pub removed_mm3: f64,
    /// Its line in the program, from 1.
    pub line: usize,
}

/// A program as it was cut.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MilledPart {
    /// The steps, in order.
    pub rows: Vec<MilledRow>,
    /// Length of the way, mm.
    pub length_mm: f64,
    /// Where the way ends: x, y, z, mm.
    pub end_mm: [f64; 3],
    /// Lines of rapid moves that went through material, and lines that went straight down into it.
    pub rapids: Vec<usize>,
    /// See [`Self::rapids`].
    pub plunges: Vec<usize>,
    /// Words that were not acted on.
    pub not_followed: Vec<NotFollowed>,
    /// Lines behind the end of the program.
    pub left_out: usize,
    /// Volume that the feed moves took, mm^3, and what a_p a_e over the way comes to.
    pub removed_mm3: f64,
    /// See [`Self::removed_mm3`].
    pub counted_mm3: f64,
}

/// A step that is under way.
#[derive(Clone, Debug)]
struct Open {
    row: MilledRow,
    length_mm: f64,
    taken: CutAway,
}

/// The work: a step of the job is a piece of the way.
#[derive(Clone, Debug)]
pub struct MillingJob {
    outline: Outline,
    step_mm: f64,
    moves: Vec<GCodeMove>,
    map: HeightMap,
    part: MilledPart,
    /// The move under way, and how far along it, mm.
    next: usize,
    gone_mm: f64,
    open: Option<Open>,
    /// Direction of the feed in x and y.
    along: [f64; 2],
    done_mm: f64,
    total_mm: f64,
}

impl MillingJob {
    /// A program with a tool of this outline over a blank, in steps of `step_mm`.
    ///
    /// # Errors
    /// A program without a feed move, a step outside [`STEPS_MM`], or more steps or cells than are kept.
    pub fn new(
        program: &GCodeProgram,
        blank: Blank,
        outline: Outline,
        step_mm: f64,
    ) -> Result<Self, String> {
        let [least, most] = STEPS_MM;
        if !(least..=most).contains(&step_mm) {
            return Err(tr!(
                "the step is {step} mm: allowed is {least} to {most} mm",
                step = step_mm,
                least = least,
                most = most
            ));
        }
        let length = |rapid: bool| -> f64 {
            let moves = program.moves.iter().filter(|one| one.rapid == rapid);
            moves.map(GCodeMove::length_mm).sum()
        };
        let [feed_mm, rapid_mm] = [false, true].map(length);
        if feed_mm <= HAIR_MM {
            return Err(tr("the program has no feed move: nothing is cut").to_owned());
        }
        if feed_mm / step_mm > MOST_STEPS {
            return Err(tr!(
                "a way of {length:.0} mm in steps of {step} mm: allowed are {most} steps; a larger step has fewer",
                length = feed_mm,
                step = step_mm,
                most = MOST_STEPS
            ));
        }
        let map = HeightMap::new(blank, step_mm / CELLS_PER_STEP)?;
        let part = MilledPart {
            not_followed: program.not_followed.clone(),
            left_out: program.left_out,
            ..MilledPart::default()
        };
        Ok(Self {
            outline,
            step_mm,
            moves: program.moves.clone(),
            map,
            part,
            next: 0,
            gone_mm: 0.0,
            open: None,
            along: [1.0, 0.0],
            done_mm: 0.0,
            total_mm: feed_mm + rapid_mm,
        })
    }

    /// The outline of the tool that cuts.
    #[must_use]
    pub fn outline(&self) -> Outline {
        self.outline
    }

    /// The step along the way, mm.
    #[must_use]
    pub fn step_mm(&self) -> f64 {
        self.step_mm
    }

    /// What is left of the blank.
    #[must_use]
    pub fn map(&self) -> &HeightMap {
        &self.map
    }

    /// The part, once the job is over.
    #[must_use]
    pub fn part(&self) -> Option<&MilledPart> {
        self.is_over().then_some(&self.part)
    }

    fn is_over(&self) -> bool {
        self.next >= self.moves.len() && self.open.is_none()
    }

    /// A piece of the way.
    fn piece(&mut self) {
        let Some(one) = self.moves.get(self.next).copied() else {
            return self.close();
        };
        if one.rapid && self.open.is_some() {
            self.close();
        }
        let length_mm = one.length_mm();
        let left_mm = self.step_mm - self.open.as_ref().map_or(0.0, |open| open.length_mm);
        let to_mm = (self.gone_mm + left_mm).min(length_mm);
        let ends = [self.gone_mm, to_mm].map(|mm| one.at(mm / length_mm));
        let [x, y] = [0, 1].map(|i: usize| ends[1][i] - ends[0][i]);
        let across_mm = (x * x + y * y).sqrt();
        if across_mm > HAIR_MM {
            self.along = [x / across_mm, y / across_mm];
        }
        let piece_mm = to_mm - self.gone_mm;
        if one.rapid {
            self.rapid(&one, ends);
        } else {
            self.feed(&one, ends, piece_mm);
        }
        self.done_mm += piece_mm;
        self.gone_mm = to_mm;
        if length_mm - to_mm <= HAIR_MM {
            (self.next, self.gone_mm) = (self.next + 1, 0.0);
        }
        let is_full = self.open.as_ref().is_some_and(|o| self.step_mm - o.length_mm <= HAIR_MM);
        if is_full || self.next >= self.moves.len() {
            self.close();
        }
    }

    fn rapid(&mut self, one: &GCodeMove, ends: [[f64; 3]; 2]) {
        let mut taken = CutAway::default();
        self.map.cut(&self.outline, ends, self.along, &mut taken);
        if taken.removed_mm3 > TOLD_MM3 && self.part.rapids.last() != Some(&one.line) {
            self.part.rapids.push(one.line);
        }
    }

    fn feed(&mut self, one: &GCodeMove, ends: [[f64; 3]; 2], piece_mm: f64) {
        let s_mm = self.part.length_mm;
        let open = self.open.get_or_insert_with(|| Open {
            row: MilledRow {
                s_mm,
                at_mm: ends[0],
                axial_mm: 0.0,
                radial_mm: 0.0,
                feed_mm_min: one.feed_mm_min,
                speed_rpm: one.speed_rpm,
                removed_mm3: 0.0,
                line: one.line,
            },
            length_mm: 0.0,
            taken: CutAway::default(),
        });
        let before_mm3 = open.taken.removed_mm3;
        self.map.cut(&self.outline, ends, self.along, &mut open.taken);
        open.length_mm += piece_mm;
        self.part.end_mm = ends[1];
        let is_cut = open.taken.removed_mm3 - before_mm3 > TOLD_MM3;
        if is_cut && one.is_plunge() && self.part.plunges.last() != Some(&one.line) {
            self.part.plunges.push(one.line);
        }
    }

    /// The step under way is over.
    fn close(&mut self) {
        let Some(Open { mut row, length_mm, taken }) = self.open.take() else { return };
        if length_mm <= HAIR_MM {
            return;
        }
        row.axial_mm = rounded(taken.axial_mm);
        row.radial_mm = rounded(taken.radial_mm(&self.outline, self.map.cell_mm()));
        row.removed_mm3 = taken.removed_mm3;
        self.part.removed_mm3 += taken.removed_mm3;
        self.part.counted_mm3 += row.axial_mm * row.radial_mm * length_mm;
        self.part.length_mm += length_mm;
        self.part.rows.push(row);
    }
}

/// A depth in tenths of a micrometre: the rest is rounding.
fn rounded(depth_mm: f64) -> f64 {
    (depth_mm * 1e4).round() / 1e4
}

impl Job for MillingJob {
    /// The part, once it is over.
    type Partial = Option<MilledPart>;

    fn advance(&mut self, budget: &Budget<'_>) -> bool {
        while !self.is_over() {
            if !budget.step() {
                return false;
            }
            self.piece();
        }
        true
    }

    fn progress(&self) -> Progress {
        let done = if self.is_over() { self.total_mm } else { self.done_mm.min(self.total_mm) };
        Progress { done, total: self.total_mm, unit: text!("mm of the way") }
    }

    fn partial(&self) -> Self::Partial {
        self.part().cloned()
    }
}

/// Lines as a list that is no longer than anybody reads.
fn listed(lines: &[usize]) -> String {
    let first = lines.iter().take(MOST_LINES).map(usize::to_string);
    let mut list = first.collect::<Vec<_>>().join(", ");
    if lines.len() > MOST_LINES {
        list.push_str(&tr!(" and {n} more", n = lines.len() - MOST_LINES));
    }
    list
}

impl MilledPart {
    /// The path of the part.
    #[must_use]
    pub fn path(&self) -> PartPath {
        PartPath {
            stretches: self
                .rows
                .iter()
                .map(|row| [row.s_mm, row.axial_mm, row.radial_mm])
                .collect(),
            length_mm: self.length_mm,
            feeds_mm_min: span(self.rows.iter().filter_map(|row| row.feed_mm_min)),
            speeds_rpm: span(self.rows.iter().filter_map(|row| row.speed_rpm)),
            remarks: Vec::new(),
        }
    }

    /// What there is to say of the program, in sentences.
    #[must_use]
    pub fn remarks(&self) -> Vec<String> {
        let mut told = Vec::new();
        if !self.rapids.is_empty() {
            told.push(tr!(
                "Rapid moves through material: lines {lines}.",
                lines = listed(&self.rapids)
            ));
        }
        if !self.plunges.is_empty() {
            told.push(tr!(
                "Straight down into material: lines {lines}.",
                lines = listed(&self.plunges)
            ));
        }
        for NotFollowed { word, lines } in &self.not_followed {
            told.push(tr!(
                "Not acted on: {word}, lines {lines}.",
                word = word,
                lines = listed(lines)
            ));
        }
        if self.left_out > 0 {
            told.push(tr!(
                "Behind the end of the program: {n} lines, not read.",
                n = self.left_out
            ));
        }
        if self.rows.iter().any(|row| row.feed_mm_min.is_none()) {
            told.push(
                tr("There are feed moves before the first F: their feed is not known.").to_owned(),
            );
        }
        told
    }

    /// The part as a table, of which [`PartPath::read`] reads the path again.
    #[must_use]
    pub fn csv(&self) -> String {
        let mut text =
            "s_mm,x_mm,y_mm,z_mm,a_p_mm,a_e_mm,feed_mm_min,speed_rpm,air,removed_mm3,line\n"
                .to_owned();
        let number = |value: Option<f64>| value.map_or(String::new(), |x| x.to_string());
        for row in &self.rows {
            let [x, y, z] = row.at_mm;
            let [feed, speed] = [row.feed_mm_min, row.speed_rpm].map(number);
            let air = u8::from(row.axial_mm <= 0.0 || row.radial_mm <= 0.0);
            let MilledRow { s_mm, axial_mm, radial_mm, removed_mm3, line, .. } = row;
            // A text takes whatever is written to it.
            let _ = writeln!(
                text,
                "{s_mm},{x},{y},{z},{axial_mm},{radial_mm},{feed},{speed},{air},{removed_mm3},{line}"
            );
        }
        if let Some(last) = self.rows.last() {
            let [x, y, z] = self.end_mm;
            let _ = writeln!(text, "{},{x},{y},{z},0,0,,,1,0,{}", self.length_mm, last.line);
        }
        text
    }
}
