//! The cut with the structure at the tool's tip as measured modes, and the force by tangential and radial coefficients:
//! both directions of the plane, each tooth with its own angle.
//!
//! ```text
//! F = -b K_t S(phi) [u(t) - u(t - T)] ,   S = sum over the teeth in the cut of
//!     | sin cos + K_r sin^2     cos^2 + K_r sin cos  |      phi from y, the feed along x
//!     | -sin^2 + K_r sin cos   -sin cos + K_r cos^2  |
//! ```
//!
//! (Altintas and Budak 1995, Analytical prediction of stability lobes in milling, with S = -A/2; the first element alone
//! is h(t) of Insperger and Stepan 2004.) Up-milling cuts from 0 to arccos(1 - 2 a_e/D), down-milling from
//! arccos(2 a_e/D - 1) to pi.

pub mod linear;
pub mod semi_discrete;
pub mod simulated;
pub mod zero_order;

use crate::base::language::tr;
use crate::base::math::{self, PI, TAU};
use crate::models::tip_modes::{TipAxis, TipMode, TipModes};

/// N/m that a specific cutting force of 1 N/mm^2 makes for a millimetre of depth.
const N_M_PER_N_MM2_MM: f64 = 1000.0;
/// Angles nearer than this are one, rad.
const SAME_RAD: f64 = 1e-9;

/// A 2 x 2 matrix over x and y.
pub type Directions = [[f64; 2]; 2];

/// A cut on a tip, all but its speed and depth.
#[derive(Clone, Debug, PartialEq)]
pub struct TipCut {
    /// The modes, at least one.
    pub modes: TipModes,
    /// Number of teeth.
    pub teeth: u32,
    /// Angles at which a tooth enters and leaves the cut, rad.
    pub window_rad: [f64; 2],
    /// Radial depth, mm.
    pub radial_depth_mm: f64,
    /// Diameter of the cutter, mm.
    pub diameter_mm: f64,
    /// Tangential coefficient K_t, N/mm^2.
    pub tangential_n_mm2: f64,
    /// Radial over tangential force K_r.
    pub radial_ratio: f64,
    /// Whether the teeth move against the feed: down-milling.
    pub down_milling: bool,
}

/// A stretch of the tooth period with the same teeth in the cut.
#[derive(Clone, Debug, PartialEq)]
pub struct ToothStretch {
    /// Angle of tooth 0 from its begin to its end, rad.
    pub rad: [f64; 2],
    /// Teeth in the cut, counted from 0.
    pub cutting: Vec<u32>,
}

/// The angles at which a tooth enters and leaves.
#[must_use]
pub fn window_rad(radial_depth_mm: f64, diameter_mm: f64, down_milling: bool) -> [f64; 2] {
    let share = math::limit(radial_depth_mm / diameter_mm, 0.0, 1.0);
    match down_milling {
        true => [math::acos(2.0 * share - 1.0), PI],
        false => [0.0, math::acos(1.0 - 2.0 * share)],
    }
}

impl TipCut {
    /// Tooth period in s at `speed_rpm`.
    #[must_use]
    pub fn period_s(&self, speed_rpm: f64) -> f64 {
        60.0 / (f64::from(self.teeth) * speed_rpm)
    }

    /// Angle from tooth to tooth, rad.
    #[must_use]
    pub fn pitch_rad(&self) -> f64 {
        TAU / f64::from(self.teeth)
    }

    /// Mean number of teeth in the cut.
    #[must_use]
    pub fn mean_teeth(&self) -> f64 {
        let [from, to] = self.window_rad;
        (to - from) / self.pitch_rad()
    }

    /// b K_t, N/m, of a depth in mm.
    #[must_use]
    pub fn stiffness_n_m(&self, depth_mm: f64) -> f64 {
        N_M_PER_N_MM2_MM * self.tangential_n_mm2 * depth_mm
    }

    /// The depth in mm of a b K_t in N/m.
    #[must_use]
    pub fn depth_mm(&self, stiffness_n_m: f64) -> f64 {
        stiffness_n_m / (N_M_PER_N_MM2_MM * self.tangential_n_mm2)
    }

    /// The directions in which the tip gives way, as places in [`Directions`].
    #[must_use]
    pub fn directions(&self) -> Vec<usize> {
        let axes = [TipAxis::X, TipAxis::Y];
        (0..2).filter(|axis| self.modes.along(axes[*axis]).next().is_some()).collect()
    }

    /// The modes, each with its direction's place among [`Self::directions`].
    fn placed_modes(&self) -> Vec<(TipMode, usize)> {
        let directions = self.directions();
        let place = |mode: &TipMode| {
            let axis = usize::from(mode.axis == TipAxis::Y);
            directions.iter().position(|direction| *direction == axis).unwrap_or_default()
        };
        self.modes.all().iter().map(|mode| (*mode, place(mode))).collect()
    }

    /// The highest natural frequency, Hz.
    #[must_use]
    pub fn highest_hz(&self) -> f64 {
        self.modes.all().iter().map(|mode| mode.frequency_hz).fold(0.0, f64::max)
    }

    /// The stretches of a tooth period, in order.
    #[must_use]
    pub fn stretches(&self) -> Vec<ToothStretch> {
        let pitch = self.pitch_rad();
        let within = |angle: f64| {
            let angle = angle - pitch * (angle / pitch + SAME_RAD).floor();
            math::positive(angle)
        };
        let mut edges = vec![0.0, within(self.window_rad[0]), within(self.window_rad[1]), pitch];
        edges.sort_by(f64::total_cmp);
        edges.dedup_by(|next, before| *next - *before < SAME_RAD);
        let cutting = |middle: f64| {
            let [from, to] = self.window_rad;
            let inside = |tooth: &u32| {
                let angle = middle + pitch * f64::from(*tooth);
                (from..to).contains(&angle)
            };
            (0..self.teeth).filter(inside).collect()
        };
        let pairs = edges.windows(2);
        pairs
            .map(|pair| ToothStretch {
                rad: [pair[0], pair[1]],
                cutting: cutting(0.5 * (pair[0] + pair[1])),
            })
            .collect()
    }

    /// The mean of S from one angle of tooth 0 to another, rad, for the teeth that cut there.
    #[must_use]
    pub fn mean(&self, cutting: &[u32], [from, to]: [f64; 2]) -> Directions {
        let ratio = self.radial_ratio;
        let length = to - from;
        let mut sum = [[0.0; 2]; 2];
        for tooth in cutting {
            let lag = self.pitch_rad() * f64::from(*tooth);
            let [a, b] = [from + lag, to + lag];
            let (sin_a, sin_b) = (math::sin(a), math::sin(b));
            let mixed = 0.5 * (sin_b * sin_b - sin_a * sin_a) / length;
            let doubled = 0.25 * (math::sin(2.0 * b) - math::sin(2.0 * a)) / length;
            add(&mut sum, mixed, 0.5 - doubled, 0.5 + doubled, ratio);
        }
        sum
    }

    /// S at an angle of tooth 0, rad, for the teeth that cut there.
    #[must_use]
    pub fn at(&self, cutting: &[u32], rad: f64) -> Directions {
        let mut sum = [[0.0; 2]; 2];
        for tooth in cutting {
            let angle = rad + self.pitch_rad() * f64::from(*tooth);
            let (sin, cos) = (math::sin(angle), math::cos(angle));
            add(&mut sum, sin * cos, sin * sin, cos * cos, self.radial_ratio);
        }
        sum
    }

    /// The mean of S over a tooth period.
    #[must_use]
    pub fn mean_of_period(&self) -> Directions {
        let mut sum = [[0.0; 2]; 2];
        for stretch in self.stretches() {
            let share = (stretch.rad[1] - stretch.rad[0]) / self.pitch_rad();
            let mean = self.mean(&stretch.cutting, stretch.rad);
            for (row, of) in sum.iter_mut().zip(mean) {
                for (cell, x) in row.iter_mut().zip(of) {
                    *cell += share * x;
                }
            }
        }
        sum
    }

    /// The engagement in words.
    #[must_use]
    pub fn engagement_text(&self) -> String {
        let [from, to] = self.window_rad.map(|x| x * (180.0 / PI));
        tr!(
            "R_D {radial:.2} mm of a cutter of {diameter} mm with {teeth} teeth: each cuts from {from:.1} to {to:.1} \
             degrees, {way}",
            radial = self.radial_depth_mm,
            diameter = self.diameter_mm,
            teeth = self.teeth,
            from = from,
            to = to,
            way = if self.down_milling { tr("down-milling") } else { tr("up-milling") }
        )
    }
}

/// Adds a tooth of these products of sine and cosine.
fn add(sum: &mut Directions, mixed: f64, sines: f64, cosines: f64, ratio: f64) {
    sum[0][0] += mixed + ratio * sines;
    sum[0][1] += cosines + ratio * mixed;
    sum[1][0] += ratio * mixed - sines;
    sum[1][1] += ratio * cosines - mixed;
}

#[cfg(test)]
pub(crate) mod tests;
