//! The part as the cutter's edge meets it: straight cuts one after the other, each of sections of
//! constant axial depth and side wall.
//!
//! A contact point of the edge at (x, y), x along the cut from the part's edge and y across it from
//! the tool's axis, is in the material if 0 <= x <= L and y >= y_e(x), up to the depth A_D(x). The wall
//! is given by its place y_e and not by the radial depth: with the radial depth constant the wall
//! would jump sideways at every step of the axial depth. Steps are met gradually, as the ball's
//! contact points come to them.

mod shapes;

pub use shapes::{
    DepthStep, MAX_CUTS, MAX_SECTIONS, MAX_STEPS, MIN_SECTION_MM, RadialSteps, Section,
};

/// Distance in mm that a cut starts before the part's edge: the tool comes in from the air.
pub const APPROACH_MM: f64 = 7.6;
/// Force below which a tool that goes through cuts with air between them counts as in the air, as a
/// share of the desired force: 40 of 665 N in 2005.
pub const AIR_FRACTION: f64 = 0.06;

/// The part as it is programmed: what a controller may know of it before it is cut.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProgrammedPart<'a> {
    /// Straight cuts; empty where the part is one path with a depth profile.
    pub cuts: &'a [Vec<Section>],
    /// Axial depth at the start of the one path, mm.
    pub axial_depth_mm: f64,
    /// Radial depth of the one path, mm.
    pub radial_depth_mm: f64,
    /// Depth profile of the one path.
    pub depth_steps: &'a [DepthStep],
    /// Profile of the radial depth of the one path; empty where it is the same all along.
    pub radial_steps: &'a [DepthStep],
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Stretch {
    to_mm: f64,
    axial_depth_mm: f64,
    wall_mm: f64,
}

/// One straight cut.
#[derive(Clone, Debug, PartialEq)]
pub struct CutPath {
    stretches: Vec<Stretch>,
    /// Where the material begins: at the part's edge, or nowhere for a path that starts in it.
    from_mm: f64,
}

impl CutPath {
    /// A cut through `sections`: length, axial depth and wall position y_e in mm.
    #[must_use]
    pub fn new(sections: &[Section]) -> Self {
        let mut to_mm = 0.0;
        let stretches = sections.iter().map(|&[length_mm, axial_depth_mm, wall_mm]| {
            to_mm += length_mm;
            Stretch { to_mm, axial_depth_mm, wall_mm }
        });
        Self { stretches: stretches.collect(), from_mm: 0.0 }
    }

    /// The same with material before the first section too: the tool starts in the cut.
    #[must_use]
    pub fn open(sections: &[Section]) -> Self {
        Self { from_mm: f64::NEG_INFINITY, ..Self::new(sections) }
    }

    /// The same with other axial depths: `depth_mm` gives that of the part between two of the `borders`, from
    /// where it begins and the depth that is there now, all in mm.
    #[must_use]
    pub fn with_depths(&self, borders: &[f64], depth_mm: impl Fn(f64, f64) -> f64) -> Self {
        let mut stretches = Vec::with_capacity(self.stretches.len() + borders.len());
        let mut from_mm = self.from_mm;
        for stretch in &self.stretches {
            let inside = |border: &&f64| **border > from_mm && **border < stretch.to_mm;
            let within: Vec<f64> = borders.iter().filter(inside).copied().collect();
            for to_mm in within.into_iter().chain([stretch.to_mm]) {
                let axial_depth_mm = depth_mm(from_mm, stretch.axial_depth_mm);
                stretches.push(Stretch { to_mm, axial_depth_mm, ..*stretch });
                from_mm = to_mm;
            }
        }
        Self { stretches, from_mm: self.from_mm }
    }

    /// Length L of the part along this cut, mm.
    #[must_use]
    pub fn length_mm(&self) -> f64 {
        self.stretches.last().map_or(0.0, |stretch| stretch.to_mm)
    }

    /// Whether there is material before the first section too.
    #[must_use]
    pub fn is_open(&self) -> bool {
        self.from_mm < 0.0
    }

    /// Where the sections begin, mm.
    #[must_use]
    pub fn steps_mm(&self) -> Vec<f64> {
        let ends = self.stretches.iter().map(|stretch| stretch.to_mm);
        let mut begins: Vec<f64> = [0.0].into_iter().chain(ends).collect();
        begins.pop();
        begins
    }

    /// The largest axial depth, mm.
    #[must_use]
    pub fn depth_max_mm(&self) -> f64 {
        self.stretches.iter().map(|stretch| stretch.axial_depth_mm).fold(0.0, f64::max)
    }

    /// Axial depth and wall position in mm of the section at `x_mm`; no depth where there is none.
    #[must_use]
    pub fn section_at(&self, x_mm: f64) -> [f64; 2] {
        let inside = x_mm >= self.from_mm;
        match self.stretch_at(x_mm) {
            Some(stretch) if inside => [stretch.axial_depth_mm, stretch.wall_mm],
            _ => [0.0, 0.0],
        }
    }

    /// Sections overlapping [low, high], clipped to it: ([axial depth, wall], [from, to]), all in mm.
    /// Air yields no entry.
    pub fn sections_within(
        &self,
        [low_mm, high_mm]: [f64; 2],
    ) -> impl Iterator<Item = ([f64; 2], [f64; 2])> {
        let mut begin_mm = self.from_mm;
        self.stretches.iter().filter_map(move |stretch| {
            let [from, to] = [begin_mm.max(low_mm), stretch.to_mm.min(high_mm)];
            begin_mm = stretch.to_mm;
            (from < to).then_some(([stretch.axial_depth_mm, stretch.wall_mm], [from, to]))
        })
    }

    /// Axial depth in mm of the material at a contact point; 0 where there is none.
    #[must_use]
    #[inline]
    pub fn depth_at(&self, x_mm: f64, y_mm: f64) -> f64 {
        if x_mm < self.from_mm {
            return 0.0;
        }
        match self.stretch_at(x_mm) {
            Some(stretch) if y_mm >= stretch.wall_mm => stretch.axial_depth_mm,
            _ => 0.0,
        }
    }

    /// The first section that does not end before `x_mm`.
    #[inline]
    fn stretch_at(&self, x_mm: f64) -> Option<&Stretch> {
        // A path of one's own has hundreds of them, and every tooth asks in every plant step.
        self.stretches.get(self.stretches.partition_point(|stretch| stretch.to_mm < x_mm))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn depths_change_between_borders_and_nothing_else_does() {
        let cut = CutPath::new(&[[30.0, 2.0, 2.0], [10.0, 3.0, 1.5]]);
        let gap = |from_mm: f64, depth_mm: f64| {
            if (25.0..32.0).contains(&from_mm) { 0.0 } else { depth_mm }
        };
        let other = cut.with_depths(&[-5.0, 25.0, 32.0, 90.0], gap);
        assert_eq!(other.length_mm(), 40.0);
        let depths = [24.9, 25.1, 29.9, 30.1, 31.9, 32.1, 41.0].map(|x| other.section_at(x)[0]);
        assert_eq!(depths, [2.0, 0.0, 0.0, 0.0, 0.0, 3.0, 0.0]);
        assert_eq!(other.section_at(35.0), [3.0, 1.5], "the wall stays");
        assert_eq!(cut.with_depths(&[], |_, depth_mm| depth_mm), cut);
        let open = CutPath::open(&[[30.0, 2.0, 2.0]]).with_depths(&[10.0], gap);
        assert!(open.is_open() && open.section_at(-3.0)[0] == 2.0);
    }

    #[test]
    fn sections_are_cut_to_what_is_asked_for() {
        let cut = CutPath::new(&[[30.0, 2.6, 2.0], [10.0, 3.0, 1.5]]);
        let within = |range| cut.sections_within(range).collect::<Vec<_>>();
        assert_eq!(within([-5.0, 0.0]), []);
        assert_eq!(within([-5.0, 2.0]), [([2.6, 2.0], [0.0, 2.0])]);
        let both = [([2.6, 2.0], [28.0, 30.0]), ([3.0, 1.5], [30.0, 33.0])];
        assert_eq!(within([28.0, 33.0]), both);
        assert_eq!(within([39.0, 50.0]), [([3.0, 1.5], [39.0, 40.0])]);
        let open = CutPath::open(&[[30.0, 2.6, 2.0]]);
        let open: Vec<_> = open.sections_within([-5.0, 2.0]).collect();
        assert_eq!(open, [([2.6, 2.0], [-5.0, 2.0])], "material behind the start too");
    }

    #[test]
    fn material_is_found_by_section_and_wall_and_only_within_the_part() {
        let cut = CutPath::new(&[[30.0, 2.6, 2.0], [10.0, 3.0, 1.5]]);
        assert_eq!((cut.length_mm(), cut.depth_max_mm()), (40.0, 3.0));
        for (x, y, depth) in [
            (-0.1, 5.0, 0.0),
            (0.0, 2.0, 2.6),
            (29.9, 1.9, 0.0),
            (30.1, 1.9, 3.0),
            (40.0, 1.5, 3.0),
            (40.1, 5.0, 0.0),
        ] {
            assert_eq!(cut.depth_at(x, y), depth, "{x} {y}");
        }
    }
}
