//! The part as a controller with preview believes it to be: the programmed one with the belief's errors
//! of depth and place, never the true one. From it the force that a place would ask for at the
//! programmed feed.
//!
//! ```text
//! cuts      K(x) = peak of the cutter's static force at x (f_0 = 0.08 mm) (f/f_0)^alpha / F_ref
//! one path  K(x) = K4(f, n) A_D(x) R_D(x) / (2 mm x 3 mm) / F_ref          believed model set, programmed values
//! ```
//!
//! Parts of straight cuts are met gradually, as the cutter's contact points come to a step, so their
//! peaks are worked out once over a grid; on one path the depth changes at the axis. The material is
//! taken for sharp-cut Ck45: what it really is the controller estimates as the gain.

use crate::base::math;
use crate::base::units::ratio_from_percent;
use crate::models::mechanistic::{CK45, Cutter, Kienzle, PeakTable, Sliced};
use crate::models::part::{CutPath, ProgrammedPart};
use crate::models::part::{DepthStep, Section};
use crate::models::tool::Tool;

use crate::blocks::control::{Belief, ControlInput};

/// Height of the cutter's slices in mm, and cutting speed of the law in m/min.
const SLICE_MM: f64 = 0.5;
const SPEED_M_MIN: f64 = 80.0;
/// Feed per tooth of the table, mm.
const FEED_PER_TOOTH_MM: f64 = 0.08;
/// Angles of the spindle in a tooth's pitch: 5 degrees apart.
const ANGLES: usize = 36;
/// Cross-section A_D R_D at which the formula's force holds, mm^2.
const SECTION_MM2: f64 = 6.0;
/// Sampling grid along a cut: starts BEFORE_MM before the part, spacing STEP_MM, coarser where
/// MAX_POINTS would be exceeded.
const BEFORE_MM: f64 = 10.0;
const STEP_MM: f64 = 0.5;
const MAX_POINTS: f64 = 2000.0;

/// What a map was made from; made again only when this changes.
#[derive(Clone, Debug, PartialEq)]
struct Source {
    cuts: Vec<Vec<Section>>,
    depth_steps: Vec<DepthStep>,
    radial_steps: Vec<DepthStep>,
    tool: Tool,
    deeper: f64,
}

/// Peak forces of a cut over a grid.
#[derive(Clone, Debug)]
struct Profile {
    step_mm: f64,
    peaks_n: Vec<f64>,
}

impl Profile {
    fn new(table: &PeakTable, cut: &CutPath) -> Self {
        let length_mm = BEFORE_MM + cut.length_mm();
        let step_mm = STEP_MM.max(length_mm / MAX_POINTS);
        let peak = |i: usize| {
            let axis_mm = i as f64 * step_mm - BEFORE_MM;
            table.peak_n(|x, y| cut.depth_at(axis_mm + x, y))
        };
        let points = (length_mm / step_mm).ceil() as usize + 1;
        Self { step_mm, peaks_n: (0..points).map(peak).collect() }
    }

    fn at(&self, x_mm: f64) -> f64 {
        let last = self.peaks_n.len() - 1;
        let place = math::limit((x_mm + BEFORE_MM) / self.step_mm, 0.0, last as f64);
        let i = (place as usize).min(last.saturating_sub(1));
        let share = place - i as f64;
        self.peaks_n[i] + share * (self.peaks_n[(i + 1).min(last)] - self.peaks_n[i])
    }
}

/// The believed part.
#[derive(Clone, Debug)]
pub struct BelievedPart {
    source: Source,
    profiles: Vec<Profile>,
    /// For one path: axial depth at its start and radial depth, mm.
    first_mm: f64,
    radial_depth_mm: f64,
    shift_mm: f64,
}

impl BelievedPart {
    /// The programmed part with the belief's errors.
    #[must_use]
    pub fn new(part: &ProgrammedPart, tool: &Tool, belief: &Belief) -> Self {
        let deeper = 1.0 + ratio_from_percent(belief.depth_error_percent);
        let believed = |sections: &Vec<Section>| {
            let deep = sections.iter().map(|&[length, depth, wall]| [length, deeper * depth, wall]);
            CutPath::new(&deep.collect::<Vec<Section>>())
        };
        let cuts: Vec<CutPath> = part.cuts.iter().map(believed).collect();
        let depth_max_mm = cuts.iter().map(CutPath::depth_max_mm).fold(0.0, f64::max);
        let sliced = Sliced::new(&Cutter::new(tool, 0.0, SLICE_MM), depth_max_mm);
        let law = Kienzle::new(&CK45, SPEED_M_MIN, tool.rake_deg, CK45.hardness_hb);
        let table = PeakTable::new(&sliced, &law, FEED_PER_TOOTH_MM, ANGLES);
        Self {
            source: Source {
                cuts: part.cuts.to_vec(),
                depth_steps: part.depth_steps.to_vec(),
                radial_steps: part.radial_steps.to_vec(),
                tool: tool.clone(),
                deeper,
            },
            profiles: cuts.iter().map(|cut| Profile::new(&table, cut)).collect(),
            first_mm: part.axial_depth_mm,
            radial_depth_mm: part.radial_depth_mm,
            shift_mm: belief.position_error_mm,
        }
    }

    /// Takes over a changed belief or program. An axial depth that is changed in the running cut is
    /// no part of the program.
    pub fn configure(&mut self, part: &ProgrammedPart, tool: &Tool, belief: &Belief) {
        let deeper = 1.0 + ratio_from_percent(belief.depth_error_percent);
        let Source { cuts, depth_steps, radial_steps, tool: with, deeper: before } = &self.source;
        self.shift_mm = belief.position_error_mm;
        let profiles = [(depth_steps, part.depth_steps), (radial_steps, part.radial_steps)];
        let same =
            cuts == part.cuts && profiles.iter().all(|(had, has)| had == has) && with == tool;
        if !same || *before != deeper {
            let first_mm = self.first_mm;
            *self = Self { first_mm, ..Self::new(part, tool, belief) };
        }
    }

    /// What K is made of but the place: the force in units of the reference, where [`Self::at`] gives
    /// newtons for cuts and a ratio of cross-sections for one path; `exponent` is that of the feed.
    #[must_use]
    pub fn level(&self, input: &ControlInput, exponent: f64) -> f64 {
        let programmed = input.programmed;
        if self.profiles.is_empty() {
            let force = input.models.force(programmed.feed_mm_min, programmed.speed_rpm);
            return force.value / input.force_ref_n;
        }
        let tool = &self.source.tool;
        let feed_per_tooth_mm =
            tool.feed_per_tooth_mm(programmed.feed_mm_min, programmed.speed_rpm);
        math::pow(feed_per_tooth_mm / FEED_PER_TOOTH_MM, exponent) / input.force_ref_n
    }

    /// The part of K that depends on the place: in cut `cut`, `x_mm` along it by the machine's reading.
    #[must_use]
    pub fn at(&self, cut: usize, x_mm: f64) -> f64 {
        let x_mm = x_mm - self.shift_mm;
        if let Some(profile) = self.profiles.get(cut) {
            return profile.at(x_mm);
        }
        let axial_mm = depth_at(&self.source.depth_steps, self.first_mm, x_mm);
        let radial_mm = depth_at(&self.source.radial_steps, self.radial_depth_mm, x_mm);
        self.source.deeper * axial_mm * radial_mm / SECTION_MM2
    }
}

/// The depth at a place of a profile that begins with `first_mm`, all in mm.
fn depth_at(steps: &[DepthStep], first_mm: f64, x_mm: f64) -> f64 {
    let passed = steps.partition_point(|step| step[0] <= x_mm);
    passed.checked_sub(1).map_or(first_mm, |last| steps[last][1])
}
