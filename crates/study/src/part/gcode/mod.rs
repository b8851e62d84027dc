//! A program of a milling machine (G-code, RS-274) as the moves of its tool's tip.
//!
//! | followed | how |
//! | --- | --- |
//! | G0, G1, G2, G3 | rapid, straight and circular moves; arcs by I, J from their start, or R; a helix along Z |
//! | F, S | feed and spindle speed |
//! | G17, G20, G21, G90, G91, G91.1 | plane XY, inches, millimetres, absolute, relative |
//! | M2, M30 | end of the program |
//!
//! Everything else is told with its lines and not guessed. What would change where the tool goes is refused: other
//! planes, cutter compensation, canned cycles, splines, offsets and rotations, feeds per turn, axes besides X, Y, Z,
//! variables. G28, G30 and G53 go to places that only the machine knows: the axes they name have no known place
//! afterwards, and a feed move needs one.
//!
//! The crate `gcode` was looked at: its words hold `f32`, which spoils the last digits of a coordinate, it passes over
//! what it cannot read, and modes, arcs and lengths, which are the work, are not in it.

mod arc;
mod reader;
#[cfg(test)]
mod tests;
mod words;

pub use arc::GCodeArc;

/// A move of the tool's tip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GCodeMove {
    /// Its line, from 1.
    pub line: usize,
    /// Whether it is a rapid move, which is to cut nothing.
    pub rapid: bool,
    /// Where it begins and ends: x, y, z, mm.
    pub ends_mm: [[f64; 3]; 2],
    /// The arc it goes along in x and y; straight without one.
    pub arc: Option<GCodeArc>,
    /// Programmed feed, mm/min; none before the first F.
    pub feed_mm_min: Option<f64>,
    /// Programmed speed, 1/min; none before the first S.
    pub speed_rpm: Option<f64>,
}

impl GCodeMove {
    /// Its length, mm.
    #[must_use]
    pub fn length_mm(&self) -> f64 {
        let [x, y, z] = [0, 1, 2].map(|i: usize| self.ends_mm[1][i] - self.ends_mm[0][i]);
        let across_mm = match self.arc {
            None => (x * x + y * y).sqrt(),
            Some(arc) => {
                let radius = [0, 1].map(|i: usize| self.ends_mm[0][i] - arc.centre_mm[i]);
                (radius[0] * radius[0] + radius[1] * radius[1]).sqrt() * arc.sweep_rad.abs()
            }
        };
        (across_mm * across_mm + z * z).sqrt()
    }

    /// The point a share of the way, 0 to 1, behind its start, mm.
    #[must_use]
    pub fn at(&self, share: f64) -> [f64; 3] {
        let [from, to] = self.ends_mm;
        if share >= 1.0 {
            return to;
        }
        let straight = [0, 1, 2].map(|i: usize| from[i] + share * (to[i] - from[i]));
        match self.arc {
            None => straight,
            Some(arc) => {
                let [x, y] = arc.at([from[0], from[1]], share);
                [x, y, straight[2]]
            }
        }
    }

    /// Whether it goes straight down.
    #[must_use]
    pub fn is_plunge(&self) -> bool {
        let [from, to] = self.ends_mm;
        self.arc.is_none() && from[0] == to[0] && from[1] == to[1] && to[2] < from[2]
    }
}

/// A word that is told and not acted on, with its lines.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NotFollowed {
    /// The word, or its letter where only the letter matters.
    pub word: String,
    /// Its lines, from 1.
    pub lines: Vec<usize>,
}

/// A program as it was read.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct GCodeProgram {
    /// The moves, in order; none has no length.
    pub moves: Vec<GCodeMove>,
    /// What was read and not acted on, in the order in which it came.
    pub not_followed: Vec<NotFollowed>,
    /// Lines behind the end of the program, which were not read.
    pub left_out: usize,
}

impl GCodeProgram {
    /// Reads a program.
    ///
    /// ```
    /// use steadycut_study::part::gcode::GCodeProgram;
    ///
    /// let program = GCodeProgram::read("G21 G90\nG0 X0 Y0 Z5\nG1 Z-2 F200\nG1 X50 F300 M8\nM30\n").unwrap();
    /// assert_eq!(program.moves.len(), 2, "before the first line with X, Y and Z no place is known");
    /// assert_eq!(program.moves[1].length_mm(), 50.0);
    /// assert_eq!((program.not_followed[0].word.as_str(), program.not_followed[0].lines[0]), ("M8", 4));
    /// ```
    ///
    /// # Errors
    /// The first line that cannot be followed, with what is wrong with it.
    pub fn read(text: &str) -> Result<Self, String> {
        reader::read(text)
    }
}
