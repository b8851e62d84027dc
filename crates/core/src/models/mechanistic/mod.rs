//! Mechanistic forces of an end mill: the simulated process of the 2005 system with a ball end, and
//! the source of the neural force model's training data; bull nose and square end by the same model.
//!
//! Geometry of the ball after Lee and Altintas (1996), of the others after Engin and Altintas (2001),
//! with z measured from the tip, R0 = D/2 and the corner radius r ([`Outline`]: r = R0 is the ball, r = 0
//! the square end, whose bottom edges do not cut):
//!
//! ```text
//! z < r   R(z) = R0 - r + sqrt(z (2 r - z)), sin k = (R - (R0 - r))/r, cos k = (r - z)/r
//! z >= r  R(z) = R0, sin k = 1, cos k = 0
//! psi(z) = (z/R0) tan(helix)                      phi = spindle - 2 pi j/teeth - psi, 0 < phi < pi
//! x = R sin phi, y = R cos phi                    contact point; +x is the direction of feed
//! h = min over k = 1..teeth of [(s_k + X_k) sin phi + Y_k cos phi + rho_j - rho_(j-k)] sin k,
//!                                                 no cut for h <= 0
//! db = w dz / sin k,  dF_i = k_i h^(1 - m_i) db   i = c (tangential), r (radial), a (axial)
//! rho_j = e cos(2 pi j/teeth)                     axis shifted by e towards tooth 0 (Kline and DeVor 1983)
//! dFx = -sk sp dFr - cp dFc - ck sp dFa
//! dFy = -sk cp dFr + sp dFc - ck cp dFa
//! dFz =  ck dFr - sk dFa
//! ```
//!
//! s_k is the way that the tool was fed since the k-th tooth before stood at phi, k f_t in a steady cut: the
//! tooth cuts down from the surface that stands furthest out, which is the one that the last teeth have really
//! left. Where every tooth cuts that is the one of the tooth before, k = 1; from a run-out of 2 e = f_t on one
//! of two teeth is left out, and the other cuts with the feed of the whole turn, k = 2 (Kline and DeVor 1983).
//! After a turn the same tooth comes again, so no tooth further back stands out. The sum of h over the teeth
//! of a rigid tool is the feed of a turn at every angle, whatever the run-out.
//!
//! Forces act on the tool. Slices are taken at their midpoints; w is the part of a slice below the
//! surface, so that the top slice may be partial. Three Kienzle laws stand in place of linear edge
//! forces: published tables give them, and a power law needs no edge constants. X and Y are the
//! regenerative deflection of the 2005 paper's eq. (1), X_k = G [F(t) - F(t - k T)] with T one tooth
//! period; the forces of the sample before are used, which avoids an algebraic loop (loop gain 0.1).
//! The slice height is part of the calibration: a slice enters and leaves the cut whole, so the peak
//! carries part of a slice too much; thin slices give about 3 % less than slices of 0.1 mm
//! (`steadycut force` prints how it converges).

use super::tool::{Outline, Tool, runout_share};
use crate::base::math;
use crate::base::units::mm_from_um;

mod kienzle;
mod peak_table;
mod static_cut;

pub use kienzle::{CK45, EdgeLaw, Kienzle, MNCRSI5, OwnEdgeLaw, Steel};
pub use peak_table::PeakTable;
pub use static_cut::{StaticCut, StaticPeak, static_peak, static_turn};

/// Most teeth of a cutter.
pub const MAX_TEETH: usize = 8;

/// An end mill as it is sliced.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cutter {
    /// The outline that its edges sweep.
    pub outline: Outline,
    /// Number of teeth, 1 to [`MAX_TEETH`].
    pub teeth: usize,
    /// Helix angle, degrees.
    pub helix_deg: f64,
    /// Radial position of each tooth off the mean, mm.
    pub runout_mm: [f64; MAX_TEETH],
    /// Height of a slice, mm.
    pub slice_mm: f64,
    /// Compliance G of tool and holder, mm/N.
    pub compliance_mm_n: f64,
}

impl Cutter {
    /// A tool whose axis is shifted by `runout_mm`, in slices of `slice_mm`.
    #[must_use]
    pub fn new(tool: &Tool, runout_mm: f64, slice_mm: f64) -> Self {
        let teeth = (tool.teeth as usize).clamp(1, MAX_TEETH);
        let mut runout = [0.0; MAX_TEETH];
        for (j, rho) in runout[..teeth].iter_mut().enumerate() {
            *rho = runout_mm * runout_share(j, teeth);
        }
        Self {
            outline: tool.outline(),
            teeth,
            helix_deg: tool.helix_deg,
            runout_mm: runout,
            slice_mm,
            compliance_mm_n: mm_from_um(tool.compliance_um_n),
        }
    }

    /// The papers' ball end with two teeth at another diameter if wanted; run-out of `+-runout_mm`.
    #[must_use]
    pub fn two_teeth(diameter_mm: f64, runout_mm: f64, slice_mm: f64) -> Self {
        Self::new(&Tool { diameter_mm, ..Tool::default() }, runout_mm, slice_mm)
    }

    /// Radius in mm at height `z_mm` above the tip.
    #[must_use]
    pub fn radius_mm(&self, z_mm: f64) -> f64 {
        self.outline.radius_mm(z_mm)
    }
}

#[derive(Clone, Copy, Debug)]
struct Slice {
    bottom_mm: f64,
    radius_mm: f64,
    sin_k: f64,
    cos_k: f64,
    sin_lag: f64,
    cos_lag: f64,
}

/// A cutter sliced up to a depth.
#[derive(Clone, Debug)]
pub struct Sliced {
    cutter: Cutter,
    slices: Vec<Slice>,
    teeth: Vec<Tooth>,
    /// The first so many teeth are broken: they cut nothing and leave no surface.
    broken: usize,
}

#[derive(Clone, Copy, Debug)]
struct Tooth {
    sin_pitch: f64,
    cos_pitch: f64,
    /// rho_j - rho_(j-k) in mm for k = 1, 2, ...
    stands_out_mm: [f64; MAX_TEETH],
}

impl Tooth {
    /// Tooth `j` of a cutter whose first `broken` teeth are gone: the surface of one that is gone stands out
    /// infinitely little, so that it never bounds the chip.
    fn new(cutter: &Cutter, j: usize, broken: usize) -> Self {
        let n = cutter.teeth.clamp(1, MAX_TEETH);
        let pitch = math::TAU * j as f64 / n as f64;
        let stands_out = |i: usize| {
            let before = (j + n - (i + 1) % n) % n;
            match i < n {
                true if before < broken => f64::INFINITY,
                true => cutter.runout_mm[j] - cutter.runout_mm[before],
                false => 0.0,
            }
        };
        Self {
            sin_pitch: math::sin(pitch),
            cos_pitch: math::cos(pitch),
            stands_out_mm: std::array::from_fn(stands_out),
        }
    }
}

/// How far the tool has come in mm, x and y, since the k-th tooth before stood where a tooth stands now; for
/// k = 1 to the number of teeth.
pub type Advances = [[f64; 2]; MAX_TEETH];

/// The advances of a rigid tool at a constant feed per tooth in mm.
#[must_use]
pub fn steady(feed_per_tooth_mm: f64) -> Advances {
    std::array::from_fn(|i| [(i + 1) as f64 * feed_per_tooth_mm, 0.0])
}

/// What the teeth do at an instant.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cutting {
    /// Forces on the tool, Fx, Fy, Fz, N.
    pub forces_n: [f64; 3],
    /// Height of the edges in mm that cuts down from the surface of the tooth before, of the second one
    /// before, ...; summed over the teeth.
    pub height_mm: [f64; MAX_TEETH],
}

impl Cutting {
    /// The force across the tool, N.
    #[must_use]
    #[inline]
    pub fn across_n(&self) -> f64 {
        let [x, y, _] = self.forces_n;
        (x * x + y * y).sqrt()
    }
}

impl Sliced {
    /// Slices `cutter` up to `depth_mm`; its teeth are limited to 1..=[`MAX_TEETH`].
    #[must_use]
    pub fn new(cutter: &Cutter, depth_mm: f64) -> Self {
        let Outline { corner_radius_mm: corner, .. } = cutter.outline;
        let (r0, flat) = (cutter.outline.edge_mm(), cutter.outline.flat_mm());
        let tan_helix = {
            let helix = cutter.helix_deg * (math::PI / 180.0);
            math::sin(helix) / math::cos(helix)
        };
        // A hair less than the quotient, so that 2 mm in slices of 0.1 mm are 20.
        let count = (depth_mm / cutter.slice_mm - 1e-9).ceil() as usize;
        let slice = |i: usize| {
            let bottom_mm = i as f64 * cutter.slice_mm;
            let z = bottom_mm + 0.5 * cutter.slice_mm;
            let radius_mm = cutter.radius_mm(z);
            let lag = z / r0 * tan_helix;
            let [sin_k, cos_k] = if z < corner {
                [(radius_mm - flat) / corner, (corner - z) / corner]
            } else {
                [1.0, 0.0]
            };
            Slice {
                bottom_mm,
                radius_mm,
                sin_k,
                cos_k,
                sin_lag: math::sin(lag),
                cos_lag: math::cos(lag),
            }
        };
        let n = cutter.teeth.clamp(1, MAX_TEETH);
        Self {
            cutter: *cutter,
            slices: (0..count).map(slice).collect(),
            teeth: (0..n).map(|j| Tooth::new(cutter, j, 0)).collect(),
            broken: 0,
        }
    }

    /// The first so many teeth are broken, at most all but one: no surface of theirs is met any more.
    pub fn break_teeth(&mut self, broken: usize) {
        self.broken = broken.min(self.teeth.len() - 1);
        for (j, tooth) in self.teeth.iter_mut().enumerate() {
            *tooth = Tooth::new(&self.cutter, j, self.broken);
        }
    }

    /// Number of teeth.
    #[must_use]
    pub fn teeth(&self) -> usize {
        self.teeth.len()
    }

    /// Forces on the tool at the spindle angle `spindle_rad`: the equations at the head of this module
    /// (Lee and Altintas 1996; 2005 eq. 1).
    ///
    /// `advances` are [s_k + X_k, Y_k]; `depth_at(x_mm, y_mm)` is the axial depth of the material in mm at a
    /// contact point relative to the tool's axis, 0 where there is none.
    #[must_use]
    #[inline]
    pub fn forces(
        &self,
        law: &impl EdgeLaw,
        spindle_rad: f64,
        advances: &Advances,
        depth_at: impl Fn(f64, f64) -> f64,
    ) -> Cutting {
        let (sin_spindle, cos_spindle) = (math::sin(spindle_rad), math::cos(spindle_rad));
        let advances = &advances[..self.teeth.len()];
        let mut sum = [0.0; 3];
        let mut height_mm = [0.0; MAX_TEETH];
        for Tooth { sin_pitch, cos_pitch, stands_out_mm } in &self.teeth[self.broken..] {
            let sin_tooth = sin_spindle * cos_pitch - cos_spindle * sin_pitch;
            let cos_tooth = cos_spindle * cos_pitch + sin_spindle * sin_pitch;
            for slice in &self.slices {
                let sp = sin_tooth * slice.cos_lag - cos_tooth * slice.sin_lag;
                if sp <= 0.0 {
                    continue;
                }
                let cp = cos_tooth * slice.cos_lag + sin_tooth * slice.sin_lag;
                let depth = depth_at(slice.radius_mm * sp, slice.radius_mm * cp);
                let width = math::limit(depth - slice.bottom_mm, 0.0, self.cutter.slice_mm);
                if width <= 0.0 {
                    continue;
                }
                let (mut chip, mut left_by) = (f64::INFINITY, 0);
                for (k, ([x, y], stands_out)) in advances.iter().zip(stands_out_mm).enumerate() {
                    let above = x * sp + y * cp + stands_out;
                    if above < chip {
                        (chip, left_by) = (above, k);
                    }
                }
                let h = chip * slice.sin_k;
                if h <= 0.0 {
                    continue;
                }
                height_mm[left_by] += width;
                let db = width / slice.sin_k;
                let [c, r, a] = law.per_width(h).map(|force| force * db);
                let (sk, ck) = (slice.sin_k, slice.cos_k);
                sum[0] -= sk * sp * r + cp * c + ck * sp * a;
                sum[1] += sp * c - sk * cp * r - ck * cp * a;
                sum[2] += ck * r - sk * a;
            }
        }
        Cutting { forces_n: sum, height_mm }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn force_needs_material_at_the_contact_point() {
        let cutter = Cutter::two_teeth(16.0, 0.0, 0.25);
        let law = Kienzle::new(&CK45, 80.0, 12.0, 200.0);
        let sliced = Sliced::new(&cutter, 2.0);
        let at = |depth_at: &dyn Fn(f64, f64) -> f64| {
            sliced.forces(&law, 1.0, &steady(0.08), depth_at).forces_n
        };
        assert_eq!(at(&|_, _| 0.0), [0.0; 3]);
        let whole = at(&|_, _| 2.0);
        assert!(whole[0] < 0.0 && whole[2] > 0.0);
        // A tenth of the first slice only: a tenth of its force, at the same place of the edge.
        let [slice, tenth] = [0.25, 0.025].map(|depth| at(&|_, _| depth));
        for (part, all) in tenth.iter().zip(slice) {
            assert!((10.0 * part - all).abs() < 1e-9 * all.abs());
        }
        // The contact points are those of a sphere's circles: x^2 + y^2 = R(z)^2.
        at(&|x: f64, y: f64| {
            let radius = (x * x + y * y).sqrt();
            assert!(radius > 1.3 && radius < cutter.radius_mm(2.0), "{radius}");
            2.0
        });
    }

    #[test]
    fn behind_a_broken_tooth_the_next_one_cuts_the_feed_of_both() {
        let law = Kienzle::new(&CK45, 80.0, 12.0, 200.0);
        let peak = |teeth: u32, broken: usize, fed_mm: f64| {
            let tool = Tool { teeth, ..Tool::default() };
            let mut sliced = Sliced::new(&Cutter::new(&tool, 0.0, 0.1), 2.0);
            sliced.break_teeth(broken);
            let at = |i: u32| {
                let angle = math::TAU * f64::from(i) / 720.0;
                sliced.forces(&law, angle, &steady(fed_mm), |_, _| 2.0).across_n()
            };
            (0..720).map(at).fold(0.0, f64::max)
        };
        // Of two teeth the one that is left is a cutter of one tooth with the feed of a turn.
        let [left, alone] = [peak(2, 1, 0.08), peak(1, 0, 0.16)];
        assert!((left / alone - 1.0).abs() < 1e-12, "{left} {alone}");
        assert!(
            peak(3, 1, 0.08) > 1.5 * peak(3, 0, 0.08),
            "{} {}",
            peak(3, 1, 0.08),
            peak(3, 0, 0.08)
        );
        assert_eq!(peak(3, 7, 0.08), peak(3, 2, 0.08), "one is left at last");
    }

    #[test]
    fn deflection_towards_the_cut_thickens_the_chip() {
        let sliced = Sliced::new(&Cutter::two_teeth(16.0, 0.0, 0.1), 2.0);
        let law = Kienzle::new(&MNCRSI5, 80.0, 12.0, 180.0);
        let at = |advances| sliced.forces(&law, 1.2, &advances, |_, _| 2.0).forces_n[0];
        let bent = |by_mm: f64| at(steady(0.08).map(|[x, y]| [x + by_mm, y]));
        let (ahead, faster) = (bent(0.01) / bent(0.0), at(steady(0.09)) / bent(0.0));
        assert!(ahead > 1.05 && ahead == faster, "{ahead} {faster}");
        assert_eq!(bent(-0.08), 0.0, "no chip");
    }
}
