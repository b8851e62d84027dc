//! The machine coupled to the cut: pulses of the force drive it, and its vibration changes the chip.
//!
//! ```text
//! P(t)     = F g(phi) / max g                           g = sum of sin phi over the teeth in the cut
//! kappa(t) = K_s gamma b teeth(t),  c(t) = c_pd teeth(t)                         regeneration, damping
//! b teeth  = height of all edges in the cut                                      tooth by tooth
//! F_n, ubar_n                                              from the step of `response`, averages of P
//! dF       = max over a tooth's pass of F_n - the same of P
//! E_S      = rms of the velocity over the last second
//! ```
//!
//! F is the peak force of the plant's model, so the machine adds vibration and no second mean force.
//! The steps are of at most 0.1 ms, a whole number to a plant step. Where the force is simulated tooth by
//! tooth its resultant drives the machine at every instant, with the edges that are in the cut and the
//! surfaces that they meet; that model's own compliance is then taken away. Wear enters by F, by the tooth's stiffness and by c_pd; kappa is that of a sharp tool, since a
//! wear land adds force but no force per chip (chosen).

use super::response::{CutForce, LeftBy, ModalResponse, Motion};
use crate::base::math::{self, TAU};
use crate::base::units::rev_s_from_rpm;
use crate::models::mechanistic::MAX_TEETH;
use crate::models::spindle::SLOWEST_RPM;
use crate::models::structure::engagement::EngagementAngles;
use crate::models::structure::reduction::Reduction;

/// Longest step of the machine, s.
pub const STEP_MAX_S: f64 = 1e-4;
/// A tooth that is out of contact counts as such where it should carry this fraction of the peak force
/// (chosen): at the very start of the chip the least vibration parts tooth and work.
const LOST_FRACTION: f64 = 0.1;
/// Parts of the second over which the sound is averaged.
const SOUND_PARTS: usize = 100;

/// What does not change in a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CoupledSetup {
    /// The machine, reduced.
    pub machine: Reduction,
    /// Number of teeth.
    pub teeth: u32,
    /// Diameter of the cutter, mm.
    pub diameter_mm: f64,
    /// K_s gamma, N/m per mm of axial depth.
    pub stiffness_per_mm: f64,
    /// Plant step, s.
    pub dt_s: f64,
}

/// The cut during a plant step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CutState {
    /// Spindle speed, 1/min.
    pub speed_rpm: f64,
    /// Axial depth, mm.
    pub axial_depth_mm: f64,
    /// Radial depth, mm.
    pub radial_depth_mm: f64,
}

/// The machine with its vibration and sound.
#[derive(Clone, Debug)]
pub struct Coupled {
    response: ModalResponse,
    tooth_n_m: f64,
    diameter_mm: f64,
    stiffness_per_mm: f64,
    damping_n_s_m: f64,
    steps: u32,
    dt_s: f64,
    radial_depth_mm: f64,
    engagement: EngagementAngles,
    peak_chip: f64,
    /// Turns of the spindle since a tooth passed, times the number of teeth.
    phase: f64,
    angle_rad: f64,
    displacement_m: f64,
    at_tooth_m: f64,
    /// Largest force with and without vibration in the present pass of a tooth and in the last one, N.
    peaks_n: [[f64; 2]; 2],
    lost_contact: bool,
    sound: Sound,
}

impl Coupled {
    /// The machine at rest.
    #[must_use]
    pub fn new(setup: &CoupledSetup) -> Self {
        let steps = (setup.dt_s / STEP_MAX_S - 1e-9).ceil().max(1.0);
        let dt_s = setup.dt_s / steps;
        // A turn: run-out may leave all teeth out but one.
        let longest_s = 60.0 / SLOWEST_RPM;
        Self {
            response: ModalResponse::new(&setup.machine, dt_s, longest_s),
            tooth_n_m: 1.0 / setup.machine.feedthrough_m_n,
            diameter_mm: setup.diameter_mm,
            stiffness_per_mm: setup.stiffness_per_mm,
            damping_n_s_m: 0.0,
            steps: steps as u32,
            dt_s,
            radial_depth_mm: 0.0,
            engagement: EngagementAngles::side_milling(setup.teeth, 0.0, setup.diameter_mm),
            peak_chip: 0.0,
            phase: 0.0,
            angle_rad: 0.0,
            displacement_m: 0.0,
            at_tooth_m: 0.0,
            peaks_n: [[0.0; 2]; 2],
            lost_contact: false,
            sound: Sound::new(dt_s),
        }
    }

    /// Machine steps in a plant step.
    #[must_use]
    pub fn steps(&self) -> u32 {
        self.steps
    }

    /// Takes the wear of the tooth: the factor on its stiffness and the process damping of a tooth in the
    /// cut, N s/m.
    pub fn wear(&mut self, stiffness_factor: f64, damping_n_s_m: f64) {
        self.response.set_tooth_stiffness(self.tooth_n_m * stiffness_factor);
        self.damping_n_s_m = damping_n_s_m;
    }

    /// A plant step begins: contact is judged again.
    pub fn begin(&mut self) {
        self.lost_contact = false;
    }

    /// One machine step with the teeth's pulses of peak `force_n`.
    #[inline]
    pub fn pulse(&mut self, force_n: f64, cut: &CutState) -> Motion {
        if cut.radial_depth_mm != self.radial_depth_mm {
            self.radial_depth_mm = cut.radial_depth_mm;
            let teeth = self.engagement.teeth;
            self.engagement =
                EngagementAngles::side_milling(teeth, cut.radial_depth_mm, self.diameter_mm);
            self.peak_chip = self.engagement.peak_chip();
        }
        let turned_rad = (TAU * rev_s_from_rpm(cut.speed_rpm) * self.dt_s).max(1e-12);
        let engaged = self.engagement.means(self.angle_rad, self.angle_rad + turned_rad);
        let share = if self.peak_chip > 0.0 { engaged.chip / self.peak_chip } else { 0.0 };
        let kappa = self.stiffness_per_mm * cut.axial_depth_mm * engaged.teeth;
        let damping_n_s_m = self.damping_n_s_m * engaged.teeth;
        let cut_force = CutForce {
            static_n: force_n * share,
            stiffness_n_m: kappa,
            damping_n_s_m,
            delay_s: self.tooth_period_s(cut.speed_rpm),
        };
        let motion = self.response.update(&cut_force);
        self.follow(&motion, cut_force.static_n, force_n, cut)
    }

    /// One machine step with the force of an instant, tooth by tooth, in N; `height_mm` is that of the edges in
    /// the cut, by the tooth before that has left the surface.
    #[inline]
    pub fn instant(
        &mut self,
        force_n: f64,
        height_mm: &[f64; MAX_TEETH],
        cut: &CutState,
    ) -> Motion {
        let edges_mm: f64 = height_mm.iter().sum();
        let depth_mm = cut.axial_depth_mm;
        let teeth = if depth_mm > 0.0 { edges_mm / depth_mm } else { 0.0 };
        let cut_force = CutForce {
            static_n: force_n,
            stiffness_n_m: self.stiffness_per_mm * edges_mm,
            damping_n_s_m: self.damping_n_s_m * teeth,
            delay_s: self.tooth_period_s(cut.speed_rpm),
        };
        let peak_n = force_n.max(self.peaks_n[1][1]);
        let motion = self.response.update_on(&cut_force, &LeftBy::shares(height_mm));
        self.follow(&motion, force_n, peak_n, cut)
    }

    fn tooth_period_s(&self, speed_rpm: f64) -> f64 {
        60.0 / (f64::from(self.engagement.teeth) * speed_rpm)
    }

    /// Whether the surface is remembered as it is at a speed in 1/min: long enough for a slow tooth, often
    /// enough for a fast one.
    #[must_use]
    pub fn holds_at(&self, speed_rpm: f64) -> bool {
        let steps = self.tooth_period_s(speed_rpm) / self.dt_s;
        speed_rpm >= SLOWEST_RPM && steps >= ModalResponse::FEWEST_STEPS
    }

    /// What the machine did in a step that was driven by `static_n` of a peak force.
    #[inline]
    fn follow(&mut self, motion: &Motion, static_n: f64, peak_n: f64, cut: &CutState) -> Motion {
        let count = f64::from(self.engagement.teeth);
        self.lost_contact |= motion.lost_contact && static_n > LOST_FRACTION * peak_n;
        let [with, without] = &mut self.peaks_n[0];
        *with = with.max(motion.force_n);
        *without = without.max(static_n);
        let turns = rev_s_from_rpm(cut.speed_rpm) * self.dt_s;
        self.angle_rad += TAU * turns;
        if self.angle_rad >= TAU {
            self.angle_rad -= TAU * (self.angle_rad / TAU).floor();
        }
        let before = self.phase;
        self.phase += count * turns;
        if self.phase >= 1.0 {
            let share = (1.0 - before) / (count * turns);
            let change = motion.displacement_m - self.displacement_m;
            self.at_tooth_m = self.displacement_m + math::limit(share, 0.0, 1.0) * change;
            self.phase -= self.phase.floor();
            self.peaks_n = [[0.0; 2], self.peaks_n[0]];
        }
        self.displacement_m = motion.displacement_m;
        self.sound.observe(motion.velocity_m_s);
        *motion
    }

    /// Turns of the spindle in a machine step at a speed in 1/min.
    #[must_use]
    pub fn turns(&self, speed_rpm: f64) -> f64 {
        rev_s_from_rpm(speed_rpm) * self.dt_s
    }

    /// What the vibration adds to the peak force, N; the larger of this tooth's pass and the last one's.
    #[must_use]
    pub fn added_force_n(&self) -> f64 {
        let [now, last] = self.peaks_n;
        now[0].max(last[0]) - now[1].max(last[1])
    }

    /// Displacement off the work as the last tooth made the surface, m.
    #[must_use]
    pub fn at_tooth_m(&self) -> f64 {
        self.at_tooth_m
    }

    /// Whether a tooth has jumped out of the cut since the plant step began.
    #[must_use]
    pub fn lost_contact(&self) -> bool {
        self.lost_contact
    }

    /// E_S: root mean square of the velocity over the last second, m/s.
    #[must_use]
    pub fn sound_m_s(&self) -> f64 {
        self.sound.rms_m_s
    }
}

/// The sound's window of a second, in parts of 10 ms.
#[derive(Clone, Debug)]
struct Sound {
    parts: [f64; SOUND_PARTS],
    filled: usize,
    next: usize,
    steps_per_part: u32,
    steps: u32,
    sum: f64,
    rms_m_s: f64,
}

impl Sound {
    fn new(dt_s: f64) -> Self {
        let steps_per_part = (1.0 / (SOUND_PARTS as f64 * dt_s)).round().max(1.0) as u32;
        let parts = [0.0; SOUND_PARTS];
        Self { parts, filled: 0, next: 0, steps_per_part, steps: 0, sum: 0.0, rms_m_s: 0.0 }
    }

    #[inline]
    fn observe(&mut self, velocity_m_s: f64) {
        self.sum += velocity_m_s * velocity_m_s;
        self.steps += 1;
        if self.steps == self.steps_per_part {
            self.parts[self.next] = self.sum / f64::from(self.steps);
            self.next = (self.next + 1) % SOUND_PARTS;
            self.filled = (self.filled + 1).min(SOUND_PARTS);
            (self.sum, self.steps) = (0.0, 0);
            self.rms_m_s = (self.parts.iter().sum::<f64>() / self.filled as f64).sqrt();
        }
    }
}

#[cfg(test)]
#[path = "coupled/tests.rs"]
mod tests;
