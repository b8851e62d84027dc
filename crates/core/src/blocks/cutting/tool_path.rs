//! Where the tool is: along one path with a depth profile, or along several straight cuts. The
//! position is counted along all of them, so it only grows; between two cuts the tool returns in
//! rapid feed, which takes no time here.

use super::workpiece::{DepthProfile, Workpiece};
use crate::base::math;
use crate::models::disturbances::Disturbances;
use crate::models::part::{APPROACH_MM, CutPath};
use crate::models::tool::Outline;

/// Engagement at the tool's axis.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Engagement {
    /// Axial depth of cut A_D, mm.
    pub axial_depth_mm: f64,
    /// Radial depth of cut R_D, mm.
    pub radial_depth_mm: f64,
}

impl Engagement {
    /// Inside a section of an axial depth with its wall at a distance from the tool's axis, mm.
    #[must_use]
    pub fn in_section(outline: &Outline, [axial_depth_mm, wall_mm]: [f64; 2]) -> Self {
        Self { axial_depth_mm, radial_depth_mm: radial_depth_mm(outline, axial_depth_mm, wall_mm) }
    }
}

/// Radius in mm at which a cutter meets the surface of a cut of an axial depth in mm; 0 without depth.
#[must_use]
pub fn met_mm(outline: &Outline, axial_depth_mm: f64) -> f64 {
    if axial_depth_mm > 0.0 { outline.radius_mm(axial_depth_mm) } else { 0.0 }
}

/// Radial depth R_D in mm of a section of an axial depth and a wall position in mm: from the wall to
/// where the cutter meets the surface.
#[must_use]
pub fn radial_depth_mm(outline: &Outline, axial_depth_mm: f64, wall_mm: f64) -> f64 {
    math::positive(met_mm(outline, axial_depth_mm) - wall_mm)
}

/// Where across a cut its machined strip lies at `x_mm` from the part's edge, in mm from the tool's
/// axis: from the wall to where the cutter meets the surface. None where nothing is cut.
#[must_use]
pub fn strip_mm(outline: &Outline, cut: &CutPath, x_mm: f64) -> Option<[f64; 2]> {
    let [axial_depth_mm, wall_mm] = cut.section_at(x_mm);
    let edge_mm = met_mm(outline, axial_depth_mm);
    (edge_mm > wall_mm).then_some([wall_mm, edge_mm])
}

/// Position in mm of the side wall that gives a radial depth in mm at an axial depth in mm.
#[must_use]
pub fn wall_mm(outline: &Outline, axial_depth_mm: f64, radial_depth_mm: f64) -> f64 {
    outline.radius_mm(axial_depth_mm) - radial_depth_mm
}

/// The tool's way.
#[derive(Clone, Debug)]
pub struct ToolPath {
    outline: Outline,
    profile: DepthProfile,
    /// For one path: its length, and the profile of its radial depth with what the start has.
    length_mm: f64,
    radial: DepthProfile,
    radial_depth_mm: f64,
    /// The cuts; the one path as a cut that is open at its start.
    cuts: Vec<CutPath>,
    several: bool,
    /// What the part differs by in depth from how it is programmed; none where it does not.
    depths: Option<Box<Disturbances>>,
    /// The cut under the tool and where along the way it began.
    cut: usize,
    began_mm: f64,
}

impl ToolPath {
    /// The way of a cutter through a workpiece, the tool at its start.
    #[must_use]
    pub fn new(workpiece: &Workpiece, outline: Outline) -> Self {
        let mut path = Self {
            outline,
            profile: DepthProfile::new(workpiece),
            length_mm: workpiece.length_mm,
            radial: DepthProfile::radial(workpiece),
            radial_depth_mm: workpiece.radial_depth_mm,
            cuts: workpiece.cuts.iter().map(|sections| CutPath::new(sections)).collect(),
            several: !workpiece.cuts.is_empty(),
            depths: None,
            cut: 0,
            began_mm: 0.0,
        };
        path.lay_profile(workpiece.axial_depth_mm);
        path
    }

    /// The same way through a part with gaps and other depths than programmed.
    #[must_use]
    pub fn disturbed(mut self, disturbances: &Disturbances) -> Self {
        self.disturb(disturbances);
        self
    }

    fn disturb(&mut self, disturbances: &Disturbances) {
        self.depths = disturbances.changes_depth().then(|| Box::new(disturbances.clone()));
        let Some(depths) = &self.depths else { return };
        let mut starts_mm = 0.0;
        for cut in &mut self.cuts {
            if self.several {
                starts_mm += APPROACH_MM;
            }
            let borders: Vec<f64> =
                depths.depth_borders_mm().iter().map(|border| border - starts_mm).collect();
            let length_mm = cut.length_mm();
            *cut =
                cut.with_depths(&borders, |x_mm, now_mm| depths.depth_mm(starts_mm + x_mm, now_mm));
            starts_mm += length_mm;
        }
    }

    /// The one path as a cut, from here on; `axial_depth_mm` is where the radial depth is counted.
    fn lay_profile(&mut self, axial_depth_mm: f64) {
        if !self.several {
            let outline = self.outline;
            let of_start_mm = wall_mm(&outline, axial_depth_mm, self.radial_depth_mm);
            let mut sections = self.profile.sections(self.length_mm, of_start_mm);
            if !self.radial.is_flat() {
                let wall_mm = |axial_mm, radial_mm| wall_mm(&outline, axial_mm, radial_mm);
                sections = self.radial.walled(&sections, wall_mm);
            }
            self.cuts = vec![CutPath::open(&sections)];
        }
    }

    /// Takes over changed depths in the running cut.
    pub fn reconfigure(&mut self, workpiece: &Workpiece, disturbances: &Disturbances) {
        self.profile.reconfigure(workpiece);
        self.lay_profile(workpiece.axial_depth_mm);
        if self.several {
            self.cuts = workpiece.cuts.iter().map(|sections| CutPath::new(sections)).collect();
        }
        self.disturb(disturbances);
    }

    /// Length of the way of a workpiece, mm.
    #[must_use]
    pub fn length_of(workpiece: &Workpiece) -> f64 {
        if workpiece.cuts.is_empty() {
            return workpiece.length_mm;
        }
        let cuts = workpiece.cuts.iter().map(|sections| CutPath::new(sections).length_mm());
        cuts.map(|length_mm| APPROACH_MM + length_mm).sum()
    }

    /// Where along the way each cut of a workpiece begins, before its approach, mm.
    #[must_use]
    pub fn begins_of(workpiece: &Workpiece) -> Vec<f64> {
        let mut begins_mm = 0.0;
        let cuts = workpiece.cuts.iter().map(|sections| {
            let here_mm = begins_mm;
            begins_mm += APPROACH_MM + CutPath::new(sections).length_mm();
            here_mm
        });
        cuts.collect()
    }

    /// The engagement at `position_mm`, which must not fall between calls.
    #[inline]
    pub fn place(&mut self, position_mm: f64) -> Engagement {
        if !self.several {
            let mut axial_depth_mm = self.profile.at(position_mm);
            if let Some(depths) = &self.depths {
                axial_depth_mm = depths.depth_mm(position_mm, axial_depth_mm);
            }
            let radial_depth_mm = self.radial.at(position_mm);
            return Engagement { axial_depth_mm, radial_depth_mm };
        }
        let (cut, x_mm) = self.cut_at(position_mm);
        Engagement::in_section(&self.outline, cut.section_at(x_mm))
    }

    /// The engagement that loads the teeth with the tool's axis at `here`: along several cuts they are
    /// ahead of it, by half the cutter's radius in the mean (chosen), or still at it.
    #[must_use]
    pub fn loaded(&self, position_mm: f64, here: Engagement) -> Engagement {
        if !self.several {
            return here;
        }
        let (cut, x_mm) = self.cut_at(position_mm);
        let ahead_mm = 0.5 * met_mm(&self.outline, cut.depth_max_mm());
        let ahead = Engagement::in_section(&self.outline, cut.section_at(x_mm + ahead_mm));
        let area = |place: Engagement| place.axial_depth_mm * place.radial_depth_mm;
        if area(ahead) > area(here) { ahead } else { here }
    }

    /// Whether the way is one of several cuts, with air between them.
    #[must_use]
    pub fn is_several(&self) -> bool {
        self.several
    }

    /// The cut under the tool, and where along it the tool's axis is, in mm from the part's edge.
    #[must_use]
    #[inline]
    pub fn cut_at(&self, position_mm: f64) -> (&CutPath, f64) {
        let approach_mm = if self.several { APPROACH_MM } else { 0.0 };
        (&self.cuts[self.cut], position_mm - self.began_mm - approach_mm)
    }

    /// A cut by its number, counted from 0; beyond the last one, the last one.
    #[must_use]
    pub fn of(&self, cut: usize) -> &CutPath {
        &self.cuts[cut.min(self.cuts.len() - 1)]
    }

    /// Number of the present cut, counted from 0.
    #[must_use]
    pub fn cut(&self) -> usize {
        self.cut
    }

    /// Number of the cut of a workpiece in which `position_mm` lies, counted from 0.
    #[must_use]
    pub fn cut_of(workpiece: &Workpiece, position_mm: f64) -> usize {
        // Where cuts begin does not depend on the cutter.
        let mut path = Self::new(workpiece, Outline::ball(0.0));
        while path.next_cut(position_mm).is_some() {}
        path.cut
    }

    /// The next cut, if the tool has come to the end of one and there is another: the position at
    /// which it begins. What the tool went beyond the end is not counted.
    pub fn next_cut(&mut self, position_mm: f64) -> Option<f64> {
        let (cut, x_mm) = self.cut_at(position_mm);
        if x_mm < cut.length_mm() || self.cut + 1 >= self.cuts.len() {
            return None;
        }
        self.began_mm += APPROACH_MM + cut.length_mm();
        self.cut += 1;
        Some(self.began_mm)
    }

    /// The largest axial depth of all cuts, mm.
    #[must_use]
    pub fn depth_max_mm(&self) -> f64 {
        self.cuts.iter().map(CutPath::depth_max_mm).fold(0.0, f64::max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::settings::Group;
    use crate::models::disturbances::{Disturbance, Zone};

    fn with_gap(at_mm: f64, length_mm: f64) -> Disturbances {
        let mut disturbances = Disturbances::default();
        let gap = disturbances.with(Disturbance::Gap, Zone { at_mm, length_mm, size: 1.0 });
        let specs = Disturbances::specs();
        let spec = specs.iter().find(|spec| spec.key == "gaps").unwrap();
        disturbances.set("gaps", &gap, &spec.allowed).unwrap();
        disturbances
    }

    #[test]
    fn a_gap_lies_at_its_place_along_the_whole_way() {
        let straight = Workpiece::default();
        let mut path = ToolPath::new(&straight, Outline::ball(8.0)).disturbed(&with_gap(50.0, 5.0));
        let depths = [49.99, 50.0, 54.99, 55.0].map(|x| path.place(x).axial_depth_mm);
        assert_eq!(depths, [2.0, 0.0, 0.0, 2.0]);
        assert_eq!(path.cut_at(52.0).0.section_at(52.0)[0], 0.0, "the teeth meet it too");
        // In the second of two cuts, whose approaches count.
        let cuts = Workpiece {
            cuts: vec![vec![[10.0, 2.0, 2.0]], vec![[20.0, 3.0, 1.0]]],
            ..Workpiece::default()
        };
        let second_mm = 10.0 + 2.0 * APPROACH_MM;
        let gap = with_gap(second_mm + 4.0, 2.0);
        let path = ToolPath::new(&cuts, Outline::ball(8.0)).disturbed(&gap);
        assert_eq!([3.9, 4.1, 5.9, 6.1].map(|x| path.of(1).section_at(x)[0]), [3.0, 0.0, 0.0, 3.0]);
        assert_eq!(path.of(0).section_at(4.1)[0], 2.0, "not in the first one");
    }

    #[test]
    fn cuts_follow_each_other_with_an_approach_each() {
        let workpiece = Workpiece {
            cuts: vec![vec![[10.0, 2.0, 2.0]], vec![[20.0, 3.0, 1.0], [5.0, 1.0, 0.0]]],
            ..Workpiece::default()
        };
        assert!(
            (ToolPath::length_of(&workpiece) - (10.0 + 25.0 + 2.0 * APPROACH_MM)).abs() < 1e-12
        );
        let mut path = ToolPath::new(&workpiece, Outline::ball(8.0));
        assert_eq!(path.place(0.0).axial_depth_mm, 0.0, "before the part");
        let inside = path.place(APPROACH_MM + 1.0);
        assert_eq!(inside.axial_depth_mm, 2.0);
        assert!((inside.radial_depth_mm - (28.0_f64.sqrt() - 2.0)).abs() < 1e-12);
        assert_eq!(path.next_cut(APPROACH_MM + 9.9), None);
        let second = path.next_cut(APPROACH_MM + 10.2).unwrap();
        assert_eq!(second, APPROACH_MM + 10.0);
        assert_eq!(ToolPath::begins_of(&workpiece), [0.0, second]);
        assert_eq!(path.cut_at(second).1, -APPROACH_MM);
        assert_eq!(path.place(second + APPROACH_MM + 21.0).axial_depth_mm, 1.0);
        assert_eq!(path.next_cut(1e9), None, "the last one ends the run");
        assert_eq!(path.depth_max_mm(), 3.0);
        let cut_of = |position_mm| ToolPath::cut_of(&workpiece, position_mm);
        assert_eq!([0.0, second - 0.1, second, 1e9].map(cut_of), [0, 0, 1, 1]);
    }

    #[test]
    fn one_path_is_a_cut_that_the_tool_starts_in() {
        let workpiece = Workpiece { depth_steps: vec![[50.0, 2.5]], ..Workpiece::default() };
        let mut path = ToolPath::new(&workpiece, Outline::ball(8.0));
        let (cut, x_mm) = path.cut_at(0.0);
        assert_eq!((x_mm, cut.length_mm()), (0.0, 120.0));
        // R_D = 3 mm at A_D = 2 mm: the wall is 28^0.5 - 3 mm from the axis and stays there.
        let wall = 28.0_f64.sqrt() - 3.0;
        assert_eq!(cut.depth_at(-5.0, wall + 1e-9), 2.0);
        assert_eq!(cut.depth_at(-5.0, wall - 1e-9), 0.0);
        assert_eq!(cut.depth_at(51.0, wall + 1e-9), 2.5);
        path.place(60.0);
        let other = Workpiece { axial_depth_mm: 1.0, ..workpiece };
        path.reconfigure(&other, &Disturbances::default());
        assert_eq!(path.cut_at(60.0).0.depth_at(61.0, 5.0), 1.0);
        let ball = Outline::ball(8.0);
        let [low, high] = strip_mm(&ball, path.cut_at(60.0).0, 60.0).unwrap();
        assert!(
            (high - 15.0_f64.sqrt()).abs() < 1e-12 && low == wall_mm(&ball, 1.0, 3.0),
            "{low} {high}"
        );
        assert_eq!(strip_mm(&ball, path.cut_at(60.0).0, 121.0), None);
    }
}
