//! The workpiece: a straight cut of given length, radial depth and axial depth profile, or several
//! cuts of sections (2005, Experiments 1 and 2).

use crate::models::part::{DepthStep, RadialSteps, Section};

/// Axial depth A_D of the 2007 example, at which K4 holds, mm.
pub const AXIAL_DEPTH_2007_MM: f64 = 2.0;
/// Radial depth R_D of the 2007 example, at which K4 holds, mm.
pub const RADIAL_DEPTH_2007_MM: f64 = 3.0;

crate::settings! {
    /// The workpiece and its engagement.
    pub struct Workpiece {
        /// Length of the path.
        length_mm: f64 = 120.0, [1.0, 20000.0], "mm", setup, "Path length";
        /// Axial depth of cut A_D at the start of the path; zero is an air cut. Changed in the
        /// running cut, it holds from there to the next step of the profile.
        axial_depth_mm: f64 = AXIAL_DEPTH_2007_MM, [0.0, 8.0], "mm", live, "Axial depth";
        /// Radial depth of cut R_D, at most the cutter's diameter.
        radial_depth_mm: f64 = RADIAL_DEPTH_2007_MM, [0.0, 50.0], "mm", setup, "Radial depth";
        /// Depth profile: from each position on, the axial depth of cut given with it.
        depth_steps: Vec<DepthStep> = Vec::new(), [8.0, 20000.0], "mm", live, "Depth profile";
        /// Profile of the radial depth: from each position on, the radial depth of cut given with it.
        /// Tooth by tooth the wall then lies where every stretch has its radial depth; without a profile it
        /// stays where the start has it.
        radial_steps: RadialSteps = RadialSteps::default(), [50.0, 20000.0], "mm", setup, "Radial profile";
        /// Straight cuts one after the other, each a list of sections [length, axial depth, wall]; the
        /// wall is its position across the cut from the tool's axis. With cuts, length, depths and
        /// profile above are not used; each cut begins 7.6 mm before the part.
        cuts: Vec<Vec<Section>> = Vec::new(), [8.0, 2000.0], "mm", setup, "Cuts";
    }
}

impl Workpiece {
    /// Axial and radial depths of the one path in mm, as they come from its start to its end.
    #[must_use]
    pub fn places_mm(&self) -> Vec<[f64; 2]> {
        self.places_at_mm().into_iter().map(|(_, place)| place).collect()
    }

    /// The same with where along the path each begins, mm.
    #[must_use]
    pub fn places_at_mm(&self) -> Vec<(f64, [f64; 2])> {
        let steps = self.depth_steps.iter().chain(self.radial_steps.iter()).map(|step| step[0]);
        let within = steps.filter(|position_mm| *position_mm < self.length_mm);
        let mut positions_mm: Vec<f64> = within.chain([0.0]).collect();
        positions_mm.sort_by(f64::total_cmp);
        positions_mm.dedup();
        let [mut axial, mut radial] = [DepthProfile::new(self), DepthProfile::radial(self)];
        positions_mm.into_iter().map(|mm| (mm, [axial.at(mm), radial.at(mm)])).collect()
    }
}

/// Finds the depth along the path; positions only grow during a run, so it remembers its place.
#[derive(Clone, Debug)]
pub struct DepthProfile {
    first_mm: f64,
    steps: Vec<DepthStep>,
    passed: usize,
    depth_mm: f64,
    position_mm: f64,
}

impl DepthProfile {
    /// The profile of a workpiece.
    #[must_use]
    pub fn new(workpiece: &Workpiece) -> Self {
        Self::of(workpiece.axial_depth_mm, &workpiece.depth_steps)
    }

    /// The profile of a workpiece's radial depth.
    #[must_use]
    pub fn radial(workpiece: &Workpiece) -> Self {
        Self::of(workpiece.radial_depth_mm, &workpiece.radial_steps)
    }

    fn of(first_mm: f64, steps: &[DepthStep]) -> Self {
        Self { first_mm, steps: steps.to_vec(), passed: 0, depth_mm: first_mm, position_mm: 0.0 }
    }

    /// Whether the depth is the same all along.
    #[must_use]
    pub fn is_flat(&self) -> bool {
        self.steps.is_empty()
    }

    /// Takes over changed settings in the running cut: a new axial depth holds from here to the
    /// next step, a new profile as if it had been there from the start.
    pub fn reconfigure(&mut self, workpiece: &Workpiece) {
        if workpiece.depth_steps != self.steps {
            let position_mm = self.position_mm;
            *self = Self::new(workpiece);
            self.at(position_mm);
        } else if workpiece.axial_depth_mm != self.first_mm {
            self.first_mm = workpiece.axial_depth_mm;
            self.depth_mm = workpiece.axial_depth_mm;
        }
    }

    /// The profile from here on as sections of a cut that is open at its start: from each position
    /// to the next the depth, up to `length_mm`; the present depth also holds behind.
    #[must_use]
    pub fn sections(&self, length_mm: f64, wall_mm: f64) -> Vec<Section> {
        let mut sections = Vec::new();
        let (mut from_mm, mut depth_mm) = (0.0, self.depth_mm);
        for [step_mm, next_mm] in self.steps.iter().skip(self.passed) {
            if *step_mm >= length_mm {
                break;
            }
            sections.push([step_mm - from_mm, depth_mm, wall_mm]);
            (from_mm, depth_mm) = (*step_mm, *next_mm);
        }
        sections.push([length_mm - from_mm, depth_mm, wall_mm]);
        sections
    }

    /// Sections of a path from its start, parted where this profile of a radial depth changes, each with the wall
    /// that gives it its radial depth; `wall_mm` has it for an axial and a radial depth. All in mm.
    #[must_use]
    pub fn walled(&self, sections: &[Section], wall_mm: impl Fn(f64, f64) -> f64) -> Vec<Section> {
        let mut parted = Vec::with_capacity(sections.len() + self.steps.len());
        let mut steps = self.steps.iter().peekable();
        let (mut from_mm, mut radial_mm) = (0.0, self.first_mm);
        for [length_mm, axial_mm, _] in sections {
            let to_mm = from_mm + length_mm;
            loop {
                while let Some([_, next_mm]) = steps.next_if(|step| step[0] <= from_mm) {
                    radial_mm = *next_mm;
                }
                let end_mm = steps.peek().map_or(to_mm, |step| step[0].min(to_mm));
                // Without a depth there is no wall to speak of.
                let wall_mm = if *axial_mm > 0.0 { wall_mm(*axial_mm, radial_mm) } else { 0.0 };
                parted.push([end_mm - from_mm, *axial_mm, wall_mm]);
                from_mm = end_mm;
                if from_mm >= to_mm {
                    break;
                }
            }
        }
        parted
    }

    /// Axial depth of cut in mm at `position_mm`, which must not fall between calls.
    #[inline]
    pub fn at(&mut self, position_mm: f64) -> f64 {
        self.position_mm = position_mm;
        while let Some([from_mm, depth_mm]) = self.steps.get(self.passed) {
            if position_mm < *from_mm {
                break;
            }
            self.depth_mm = *depth_mm;
            self.passed += 1;
        }
        self.depth_mm
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_depth_changes_at_its_position() {
        let workpiece =
            Workpiece { depth_steps: vec![[0.5, 2.3], [2.0, 0.0]], ..Workpiece::default() };
        let mut profile = DepthProfile::new(&workpiece);
        let found: Vec<f64> = [0.0, 0.49, 0.5, 1.99, 2.0, 9.0].map(|x| profile.at(x)).to_vec();
        assert_eq!(found, [2.0, 2.0, 2.3, 2.3, 0.0, 0.0]);
        assert_eq!(DepthProfile::new(&workpiece).at(5.0), 0.0, "several steps in one stride");
    }

    #[test]
    fn radial_depths_part_the_path_and_set_its_walls() {
        let workpiece = Workpiece {
            length_mm: 10.0,
            depth_steps: vec![[4.0, 1.0], [8.0, 0.0]],
            radial_steps: RadialSteps(vec![[0.0, 5.0], [6.0, 2.0], [8.0, 1.0], [30.0, 9.0]]),
            ..Workpiece::default()
        };
        let places = workpiece.places_mm();
        assert_eq!(places, [[2.0, 5.0], [1.0, 5.0], [1.0, 2.0], [0.0, 1.0]]);
        let sections = DepthProfile::new(&workpiece).sections(workpiece.length_mm, 0.0);
        let walled = DepthProfile::radial(&workpiece)
            .walled(&sections, |axial_mm, radial_mm| 8.0 * axial_mm - radial_mm);
        let wanted = [[4.0, 2.0, 11.0], [2.0, 1.0, 3.0], [2.0, 1.0, 6.0], [2.0, 0.0, 0.0]];
        assert_eq!(walled, wanted);
        assert_eq!(Workpiece::default().places_mm(), [[2.0, 3.0]]);
    }

    #[test]
    fn a_change_in_the_cut_holds_from_there_to_the_next_step() {
        let mut workpiece =
            Workpiece { depth_steps: vec![[1.0, 2.3], [5.0, 1.0]], ..Workpiece::default() };
        let mut profile = DepthProfile::new(&workpiece);
        assert_eq!(profile.at(2.0), 2.3);
        profile.reconfigure(&workpiece);
        assert_eq!(profile.at(2.1), 2.3, "nothing changed");
        workpiece.axial_depth_mm = 1.7;
        profile.reconfigure(&workpiece);
        assert_eq!([profile.at(2.2), profile.at(5.0)], [1.7, 1.0]);
        workpiece.depth_steps = vec![[3.0, 0.5]];
        profile.reconfigure(&workpiece);
        assert_eq!(profile.at(5.1), 0.5, "a new profile as if it had always been there");
    }
}
