//! The path: stretches of constant axial and radial depth along the way.

use std::fmt::Write as _;

use super::columns;
use crate::base::language::tr;
use crate::blocks::cutting::workpiece::Workpiece;

/// A path with its depths. A depth of 0 is air.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PartPath {
    /// Stretches: where each begins along the way, its axial depth a_p and its radial depth a_e, mm. Where they begin
    /// ascends from 0; none is empty.
    pub stretches: Vec<[f64; 3]>,
    /// Length of the way, mm.
    pub length_mm: f64,
    /// Least and largest feed that the file programs, mm/min; none where it says none.
    pub feeds_mm_min: Option<[f64; 2]>,
    /// The same of the spindle's speed, 1/min.
    pub speeds_rpm: Option<[f64; 2]>,
    /// What of the file was not used, in sentences.
    pub remarks: Vec<String>,
}

/// Least and largest of the values that are there.
pub(super) fn span(values: impl Iterator<Item = f64>) -> Option<[f64; 2]> {
    values.fold(None, |span, x| match span {
        None => Some([x, x]),
        Some([low, high]) => Some([f64::min(low, x), f64::max(high, x)]),
    })
}

impl PartPath {
    /// Reads a table (CSV of any separator and decimal sign): a column `s`, or `x` and `y` and, if it is there, `z`; the
    /// depths `a_p` and `a_e`; and, if they are there, `feed` and `speed`. Units stand in the names, as in `a_p [um]`
    /// or `s_mm`; without one, lengths are in mm, feeds in mm/min, speeds in 1/min. A row's depths hold up to the next
    /// row; the last row ends the path.
    ///
    /// ```
    /// use steadycut_study::part::PartPath;
    ///
    /// let path = PartPath::read("s;a_p;a_e\n0;2,0;3\n40;0;0\n50;2,5;3\n100;0;0\n").unwrap();
    /// assert_eq!(path.stretches, [[0.0, 2.0, 3.0], [40.0, 0.0, 0.0], [50.0, 2.5, 3.0]]);
    /// assert_eq!(path.length_mm, 100.0);
    /// ```
    ///
    /// # Errors
    /// Names what is missing, or line, column, value and what is allowed.
    pub fn read(text: &str) -> Result<Self, String> {
        columns::read(text)
    }

    /// Whether a text is meant as the table of a path: its header has all that [`Self::read`] asks for.
    #[must_use]
    pub fn is_meant_by(text: &str) -> bool {
        columns::is_meant_by(text)
    }

    /// The path of a scenario's part.
    ///
    /// # Errors
    /// It has several cuts, which are no one path.
    pub fn of(workpiece: &Workpiece) -> Result<Self, String> {
        if !workpiece.cuts.is_empty() {
            return Err(tr!(
                "the part has {n} cuts with air between them: only one path is a table of depths",
                n = workpiece.cuts.len()
            ));
        }
        let stretches = workpiece
            .places_at_mm()
            .into_iter()
            .map(|(at_mm, [axial, radial])| [at_mm, axial, radial]);
        Ok(Self {
            stretches: stretches.collect(),
            length_mm: workpiece.length_mm,
            ..Self::default()
        })
    }

    /// Where every stretch ends, mm.
    pub fn ends_mm(&self) -> impl Iterator<Item = f64> {
        self.stretches.iter().skip(1).map(|stretch| stretch[0]).chain([self.length_mm])
    }

    /// Length of the way without a cut, mm.
    #[must_use]
    pub fn air_mm(&self) -> f64 {
        let air = |[_, axial, radial]: &[f64; 3]| *axial <= 0.0 || *radial <= 0.0;
        let all = self.stretches.iter().zip(self.ends_mm());
        all.filter(|(stretch, _)| air(stretch)).map(|(stretch, end)| end - stretch[0]).sum()
    }

    /// The largest axial and the largest radial depth, mm.
    #[must_use]
    pub fn deepest_mm(&self) -> [f64; 2] {
        [1, 2].map(|i: usize| self.stretches.iter().map(|stretch| stretch[i]).fold(0.0, f64::max))
    }

    /// The path as a table that [`Self::read`] reads again to the bit.
    #[must_use]
    pub fn csv(&self) -> String {
        let mut text = "s_mm,a_p_mm,a_e_mm\n".to_owned();
        for [at, axial, radial] in &self.stretches {
            // A text takes whatever is written to it.
            let _ = writeln!(text, "{at},{axial},{radial}");
        }
        let _ = writeln!(text, "{},0,0", self.length_mm);
        text
    }
}
