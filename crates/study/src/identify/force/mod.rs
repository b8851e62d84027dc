//! Force coefficients, run-out and angle of a cutter from the forces that were recorded over a steady cut
//! (`steadycut identify force`).
//!
//! The model is the loop's own, tooth by tooth ([`crate::models::mechanistic`]), with Kienzle's laws for the tangential,
//! radial and axial force (O. Kienzle, VDI-Z 94, 1952):
//!
//! ```text
//! dF_i = k_i(h) h db,  k_i(h) = k_i1.1 h^-m_i           i = c (tangential), r (radial), a (axial)
//! F(t) = F(angle),  angle = phase + 2 pi n (t - t_0)     one turn like the other: the cut is steady
//! ```
//!
//! The recording is laid over one turn (`fold.rs`): places of a turn with the mean of their samples. To these the model is
//! fitted by least squares, weighted by the number of samples: k_i at the reference thickness and m_i, the run-out of every
//! tooth off their mean, and the angle of the spindle at the first sample. Where to begin says a search over the angles of
//! a tooth's pitch, each with the k_i that are best there (linear least squares). Intervals are those of 95 % of the
//! linearised fit (`estimate.rs` beside it); they take what is left between the places, so that a model that does not fit has
//! wider ones. Corrections for rake, speed and hardness are not asked for: the k_i are those of this very cut.

mod fit;
mod fold;
mod settings;
mod start;

use fit::Fitting;
pub use settings::identified_scenario;

use super::EstimatedValue;
use crate::base::language::tr;
use crate::models::mechanistic::{Kienzle, StaticCut};
use crate::models::tool::Tool;

/// Fewest and most samples of a recording.
const SAMPLES: [usize; 2] = [60, 2_000_000];
/// Fewest turns of the spindle: a whole one, which a sample less may end.
const LEAST_TURNS: f64 = 0.99;
/// Least share of the forces' variation that the model must explain: below it, these are no such forces.
const LEAST_R2: f64 = 0.3;
/// Mean square between places over that within them from which on a model does not fit, unless it explains this share
/// of what repeats: a place in which a tooth leaves the cut is never quite that of its mean angle.
const MISFIT: f64 = 4.0;
const GOOD_R2: f64 = 0.99;

/// A force that was recorded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ForceAxis {
    /// Along the feed, on the tool: +x is its direction.
    X,
    /// Across the feed, on the tool: +y is where a tooth enters the cut.
    Y,
    /// Along the tool's axis, on the tool: +z is away from the tip.
    Z,
    /// The size of the force across the tool, sqrt(Fx^2 + Fy^2).
    Across,
}

impl ForceAxis {
    /// Its name.
    #[must_use]
    pub fn id(self) -> &'static str {
        match self {
            Self::X => "Fx",
            Self::Y => "Fy",
            Self::Z => "Fz",
            Self::Across => "F_xy",
        }
    }

    /// The force of a model's three.
    fn of(self, [x, y, z]: [f64; 3]) -> f64 {
        match self {
            Self::X => x,
            Self::Y => y,
            Self::Z => z,
            Self::Across => (x * x + y * y).sqrt(),
        }
    }
}

/// Forces of a steady cut, one sample after the other.
#[derive(Clone, Debug, PartialEq)]
pub struct ForceRecording {
    /// Distance of two samples, s.
    pub period_s: f64,
    /// What was recorded, and its samples in N; all of one length.
    pub forces: Vec<(ForceAxis, Vec<f64>)>,
}

/// The cut in which they were recorded.
#[derive(Clone, Debug, PartialEq)]
pub struct RecordedCut {
    /// The cutter; its run-out is not used.
    pub tool: Tool,
    /// Height of the model's slices, mm.
    pub slice_mm: f64,
    /// Spindle speed, 1/min.
    pub speed_rpm: f64,
    /// Feed, mm/min.
    pub feed_mm_min: f64,
    /// Axial depth, mm.
    pub axial_depth_mm: f64,
    /// Radial depth, mm: from the side wall to where the cutter meets the surface.
    pub radial_depth_mm: f64,
    /// The law to begin with, and what is kept of it where the forces do not tell.
    pub law: Kienzle,
    /// Exponents m_c, m_r, m_a that are kept as the law has them.
    pub held_exponents: [bool; 3],
}

/// Kienzle's law of one direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IdentifiedLaw {
    /// Letter of the direction: c, r or a.
    pub letter: char,
    /// k_i1.1, at a chip thickness of 1 mm, N/mm^2.
    pub k_n_mm2: EstimatedValue,
    /// Exponent m_i.
    pub exponent: EstimatedValue,
    /// k_i at the reference thickness, N/mm^2: told best, for it lies in the cut.
    pub at_reference_n_mm2: EstimatedValue,
    /// Whether the forces tell anything of it; otherwise it is the law that was begun with.
    pub seen: bool,
}

/// What was identified.
#[derive(Clone, Debug, PartialEq)]
pub struct ForceFit {
    /// Tangential, radial and axial law.
    pub laws: [IdentifiedLaw; 3],
    /// The reference thickness of the chip, mm.
    pub reference_mm: f64,
    /// Thickest chip that the law was fitted to, mm.
    pub thickest_mm: f64,
    /// How far every tooth stands out of the mean, um; the first tooth is the one furthest out.
    pub runout_um: Vec<EstimatedValue>,
    /// The shift of the axis towards the first tooth that comes nearest to it, um: the setting `tool.runout_um`.
    pub shift_um: EstimatedValue,
    /// How far a tooth is from what that shift gives it, at most, um.
    pub shift_rest_um: f64,
    /// Angle of the spindle at the first sample, deg: at 0 the first tooth's tip stands where it would enter a full cut.
    pub phase_deg: EstimatedValue,
    /// Spindle speed, 1/min: as given, or found beside it where the forces repeat better.
    pub speed_rpm: f64,
    /// Samples of each force.
    pub samples: usize,
    /// Turns of the spindle.
    pub turns: f64,
    /// Places of a turn.
    pub places: usize,
    /// Root mean square of what is left of the samples, N.
    pub rest_n: f64,
    /// Root mean square of what is left of the means of the places, N: what noise cannot be.
    pub place_rest_n: f64,
    /// Share of the forces' variation that the model explains.
    pub r2: f64,
    /// The same of the means of the places: of what repeats from turn to turn.
    pub repeated_r2: f64,
    /// Mean square of what is left between the places, over that within them: 1 where only noise is left. None where the
    /// places have too few samples.
    pub misfit: Option<f64>,
    /// Condition of the Jacobian with columns of length one.
    pub condition: f64,
    /// Parameters that the forces cannot tell apart, by their names.
    pub not_apart: Vec<String>,
    /// Angles of the spindle in deg, since the first sample, and at each the mean of the samples and the model, for every
    /// force.
    pub turn: Vec<(f64, Vec<[f64; 2]>)>,
}

impl ForceFit {
    /// What a person should know before the result is used.
    #[must_use]
    pub fn notes(&self) -> Vec<String> {
        let mut notes = Vec::new();
        for law in self.laws.iter().filter(|law| !law.seen) {
            notes.push(tr!(
                "these forces tell nothing of k_{letter} and m_{letter}: they are those of the steel that the fit began with",
                letter = law.letter.to_string()
            ));
        }
        if !self.not_apart.is_empty() {
            notes.push(tr!(
                "this cut cannot tell {names} apart (condition {condition:.0}): record another component, another feed, or hold an exponent",
                names = self.not_apart.join(", "),
                condition = self.condition
            ));
        }
        if self.shift_rest_um > 1.0 {
            notes.push(tr!(
                "a tooth stands {rest:.1} um off what a shift of the axis gives it: the program's own cutter has only that shift",
                rest = self.shift_rest_um
            ));
        }
        if self.misfit.is_some_and(|ratio| ratio > MISFIT) && self.repeated_r2 < GOOD_R2 {
            notes.push(tr!(
                "what is left repeats from turn to turn ({place:.1} N): the cut differs from the model, and values may be off by more than their intervals",
                place = self.place_rest_n
            ));
        }
        notes
    }
}

impl RecordedCut {
    /// Feed per tooth, mm.
    fn feed_per_tooth_mm(&self) -> f64 {
        self.tool.feed_per_tooth_mm(self.feed_mm_min, self.speed_rpm)
    }

    /// The same as the model takes it.
    fn static_cut(&self) -> StaticCut {
        StaticCut {
            feed_per_tooth_mm: self.feed_per_tooth_mm(),
            axial_depth_mm: self.axial_depth_mm,
            radial_depth_mm: self.radial_depth_mm,
        }
    }

    fn check(&self) -> Result<(), String> {
        let positive = [
            (tr("spindle speed"), self.speed_rpm, "1/min"),
            (tr("feed"), self.feed_mm_min, "mm/min"),
            (tr("axial depth"), self.axial_depth_mm, "mm"),
            (tr("radial depth"), self.radial_depth_mm, "mm"),
            (tr("slice height"), self.slice_mm, "mm"),
        ];
        for (name, value, unit) in positive {
            if !(value > 0.0 && value.is_finite()) {
                return Err(tr!(
                    "the {name} is {value} {unit}: nothing is cut; expected is a number above 0",
                    name = name,
                    value = value,
                    unit = unit
                ));
            }
        }
        Ok(())
    }
}

impl ForceRecording {
    /// Samples of each force.
    #[must_use]
    pub fn samples(&self) -> usize {
        self.forces.first().map_or(0, |(_, samples)| samples.len())
    }

    /// Checks that something can be learned from it at a speed in 1/min.
    fn check(&self, speed_rpm: f64) -> Result<(), String> {
        let count = self.samples();
        let [least, most] = SAMPLES;
        if !(least..=most).contains(&count)
            || self.forces.iter().any(|(_, samples)| samples.len() != count)
        {
            return Err(tr!(
                "the recording has {count} samples: allowed are {least} to {most}",
                count = count,
                least = least,
                most = most
            ));
        }
        if !(self.period_s > 0.0 && self.period_s.is_finite()) {
            return Err(tr!("a period of {period} s", period = self.period_s));
        }
        for (axis, samples) in &self.forces {
            if let Some(i) = samples.iter().position(|x| !x.is_finite()) {
                return Err(tr!(
                    "{axis}: sample {sample} is no number",
                    axis = axis.id(),
                    sample = i + 1
                ));
            }
        }
        let turns = count as f64 * self.period_s * speed_rpm / 60.0;
        if turns < LEAST_TURNS {
            return Err(tr!(
                "the recording has {turns:.2} turns of the spindle: expected is at least one",
                turns = turns
            ));
        }
        Ok(())
    }
}

/// The fit of the model to a recording, from one place to begin after the other.
#[derive(Clone, Debug)]
pub struct ForceSearch {
    fitting: Fitting,
}

impl ForceSearch {
    /// Lays the recording over one turn and looks for places to begin.
    ///
    /// # Errors
    /// The recording is too short or too long, has samples that are no numbers, or does not repeat from turn to turn; nothing
    /// is cut.
    pub fn new(recording: &ForceRecording, cut: &RecordedCut) -> Result<Self, String> {
        cut.check()?;
        recording.check(cut.speed_rpm)?;
        let folded = fold::folded(recording, cut)?;
        let cut = RecordedCut { speed_rpm: folded.speed_rpm, ..cut.clone() };
        Ok(Self { fitting: Fitting::new(folded, cut) })
    }

    /// How many places to begin there are.
    #[must_use]
    pub fn starts(&self) -> usize {
        self.fitting.starts()
    }

    /// Fits from the next place; `true` while there are more.
    pub fn step(&mut self) -> bool {
        self.fitting.step()
    }

    /// The best fit of all.
    ///
    /// # Errors
    /// The model does not explain the forces at all.
    pub fn found(&self) -> Result<ForceFit, String> {
        let found = self.fitting.found()?;
        if found.r2 < LEAST_R2 {
            return Err(tr!(
                "the model explains {share:.0} % of the forces: expected are forces on the tool in N, along (Fx) and across (Fy) the feed or along the axis (Fz), of the cut that is given",
                share = 100.0 * found.r2.max(0.0)
            ));
        }
        Ok(found)
    }
}

/// Fits the model to a recording.
///
/// # Errors
/// As [`ForceSearch::new`] and [`ForceSearch::found`].
pub fn identify_force(recording: &ForceRecording, cut: &RecordedCut) -> Result<ForceFit, String> {
    let mut search = ForceSearch::new(recording, cut)?;
    while search.step() {}
    search.found()
}

#[cfg(test)]
mod tests;
