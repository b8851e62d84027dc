//! The milling simulator's process: the end mill turning tooth by tooth through the part
//! (2005, Fig. 3; [`crate::models::ball_end`]).
//!
//! ```text
//! f_t = v_f / (z n)                                        chip per tooth from the actual feed
//! X   = G [F_x(t) - F_x(t - T)],  Y likewise               T one tooth period     (2005 eq. 1)
//! h   = [(f_t + X) sin phi + Y cos phi + run-out] sin k    chip thickness
//! F   = sum over teeth and slices, times the speed's and the material's factors
//! ```
//!
//! The forces of the sample before make the deflection: no algebraic loop. One call is one sample,
//! 28.8 kHz in the papers' set-up.

use crate::base::math;
use crate::base::units::rev_s_from_rpm;
use crate::models::ball_end::{Cutter, Kienzle, Sliced, Steel};
use crate::models::part::CutPath;
use crate::models::spindle::SLOWEST_RPM;

/// Cutting speed in m/min at which the law's constants are worked out; the force follows
/// v_c^-0.153 from there.
const LAW_SPEED_M_MIN: f64 = 80.0;

/// What the tool and the material are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MillingSetup {
    /// The cutter with its run-out and slices.
    pub cutter: Cutter,
    /// The steel.
    pub steel: Steel,
    /// Rake angle, degrees.
    pub rake_deg: f64,
    /// Hardness, HB.
    pub hardness_hb: f64,
    /// Factor on the steel's force, for materials that have no law of their own.
    pub factor: f64,
    /// Length of a sample, s.
    pub dt_s: f64,
}

/// The turning cutter with its history of forces.
#[derive(Clone, Debug)]
pub struct Milling {
    setup: MillingSetup,
    sliced: Sliced,
    law: Kienzle,
    /// Speed for which `speed_factor` and `tooth_samples` hold.
    speed_rpm: f64,
    speed_factor: f64,
    tooth_samples: usize,
    /// F_x, F_y of the last samples, a ring; `newest` is the last one written.
    history: Vec<[f64; 2]>,
    newest: usize,
    turn: f64,
    /// The spindle's turn at the last sample.
    sampled_turn: f64,
    compliance_mm_n: f64,
}

impl Milling {
    /// The cutter at rest in the air, for cuts of at most `depth_max_mm`.
    #[must_use]
    pub fn new(setup: &MillingSetup, depth_max_mm: f64) -> Self {
        let slowest = (60.0 / (SLOWEST_RPM * setup.cutter.teeth as f64) / setup.dt_s).ceil();
        let law = Kienzle::new(&setup.steel, LAW_SPEED_M_MIN, setup.rake_deg, setup.hardness_hb);
        Self {
            setup: *setup,
            sliced: Sliced::new(&setup.cutter, depth_max_mm),
            law,
            speed_rpm: 0.0,
            speed_factor: 1.0,
            tooth_samples: 1,
            history: vec![[0.0; 2]; (slowest as usize + 2).next_power_of_two()],
            newest: 0,
            turn: 0.0,
            sampled_turn: 0.0,
            compliance_mm_n: setup.cutter.compliance_mm_n,
        }
    }

    fn set_speed(&mut self, speed_rpm: f64) {
        self.speed_rpm = speed_rpm;
        let rpm = speed_rpm.max(SLOWEST_RPM);
        let period_s = 60.0 / (rpm * self.setup.cutter.teeth as f64);
        self.tooth_samples = ((period_s / self.setup.dt_s).round() as usize).max(1);
        let speed_m_min = math::PI * self.setup.cutter.outline.diameter_mm * rpm / 1000.0;
        self.speed_factor = self.setup.factor * math::pow(LAW_SPEED_M_MIN / speed_m_min, 0.153);
    }

    /// Takes over the angle and the last forces of another cutter.
    pub fn take_over(&mut self, before: &Self) {
        (self.turn, self.sampled_turn) = (before.turn, before.sampled_turn);
        if self.history.len() == before.history.len() {
            self.history.clone_from(&before.history);
            self.newest = before.newest;
        }
    }

    /// The tool has left the part: no force is left that could bend it.
    pub fn restart(&mut self) {
        self.history.fill([0.0; 2]);
    }

    /// The spindle's turn at the last sample, from 0 to below 1.
    #[must_use]
    pub fn spindle_turn(&self) -> f64 {
        self.sampled_turn
    }

    /// Takes the model's own compliance away: a machine that is coupled to the cut has its own.
    pub fn make_rigid(&mut self) {
        self.compliance_mm_n = 0.0;
    }

    fn before(&self, samples: usize) -> [f64; 2] {
        let mask = self.history.len() - 1;
        self.history[(self.newest + self.history.len() - samples) & mask]
    }

    /// One sample: forces on the tool in N with the tool's axis at `x_mm` along `cut`, feed in
    /// mm/min, speed in 1/min; `factor` is what wear and the material's inhomogeneity multiply.
    pub fn update(
        &mut self,
        feed_mm_min: f64,
        speed_rpm: f64,
        x_mm: f64,
        cut: &CutPath,
        factor: f64,
    ) -> [f64; 3] {
        if speed_rpm != self.speed_rpm {
            self.set_speed(speed_rpm);
        }
        let feed_per_tooth_mm =
            feed_mm_min / (self.setup.cutter.teeth as f64 * speed_rpm.max(SLOWEST_RPM));
        let (last, earlier) = (self.before(0), self.before(self.tooth_samples));
        let deflection = [0, 1].map(|axis| self.compliance_mm_n * (last[axis] - earlier[axis]));
        let angle = self.turn * math::TAU;
        let depth_at = |x: f64, y: f64| cut.depth_at(x_mm + x, y);
        let forces = self.sliced.forces(&self.law, angle, feed_per_tooth_mm, deflection, depth_at);
        let forces = forces.map(|force| force * (self.speed_factor * factor));
        self.newest = (self.newest + 1) & (self.history.len() - 1);
        self.history[self.newest] = [forces[0], forces[1]];
        self.sampled_turn = self.turn;
        self.turn += rev_s_from_rpm(speed_rpm) * self.setup.dt_s;
        self.turn -= self.turn.floor();
        forces
    }
}
