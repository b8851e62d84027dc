//! The milling simulator's process: the end mill turning tooth by tooth through the part
//! (2005, Fig. 3; [`crate::models::mechanistic`]).
//!
//! ```text
//! X_k = G [F_x(t) - F_x(t_k)],  Y_k likewise       the k-th tooth before stood here at t_k     (2005 eq. 1)
//! h   = min over k of [(s_k + X_k) sin phi + Y_k cos phi + run-out] sin kappa     s_k fed since t_k
//! F   = sum over teeth and slices, times the speed's and the material's factors
//! ```
//!
//! The chip is cut from the surface that the last teeth have left ([`super::surface_left`]). The forces of the
//! sample before make the deflection: no algebraic loop. One call is one sample, 28.8 kHz in the papers'
//! set-up. A spindle that stands cuts nothing, nor does a tool that is not fed.

use super::surface_left::{Stand, SurfaceLeft};
use std::sync::Arc;

use crate::base::math;
use crate::base::units::rev_s_from_rpm;
use crate::models::formula_model::FormulaModel;
use crate::models::mechanistic::{Cutter, Cutting, Kienzle, OwnEdgeLaw, Sliced, Steel};
use crate::models::part::CutPath;

/// Cutting speed in m/min at which the law's constants are worked out; the force follows
/// v_c^-0.153 from there.
const LAW_SPEED_M_MIN: f64 = 80.0;
/// Feed of a turn in mm from which on there is something to cut (chosen): no chip is a nanometre thick. A power
/// law has an infinite slope at 0, so without an end a tool that stands would cut by its own deflection for ever.
const LEAST_TURN_MM: f64 = 1e-6;

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

/// The turning cutter with what its teeth have left.
#[derive(Clone, Debug)]
pub struct Milling {
    setup: MillingSetup,
    sliced: Sliced,
    law: OwnEdgeLaw,
    /// Speed for which `speed_factor` holds.
    speed_rpm: f64,
    speed_factor: f64,
    surface: SurfaceLeft,
    /// F_x, F_y of the last sample, N.
    last_n: [f64; 2],
    /// Turns of the spindle since the surface's history began.
    turns: f64,
    turn: f64,
    /// The spindle's turn at the last sample.
    sampled_turn: f64,
    compliance_mm_n: f64,
}

impl Milling {
    /// The cutter at rest in the air, for cuts of at most `depth_max_mm`.
    #[must_use]
    pub fn new(setup: &MillingSetup, depth_max_mm: f64) -> Self {
        let law = Kienzle::new(&setup.steel, LAW_SPEED_M_MIN, setup.rake_deg, setup.hardness_hb);
        let sliced = Sliced::new(&setup.cutter, depth_max_mm);
        Self {
            setup: *setup,
            surface: SurfaceLeft::new(sliced.teeth()),
            sliced,
            law: OwnEdgeLaw { law, specific: [const { None }; 3], corrections: 1.0 },
            speed_rpm: 0.0,
            speed_factor: 0.0,
            last_n: [0.0; 2],
            turns: 0.0,
            turn: 0.0,
            sampled_turn: 0.0,
            compliance_mm_n: setup.cutter.compliance_mm_n,
        }
    }

    /// The same with specific forces of one's own, cutting, radial, axial: N/mm^2 of the chip thickness in mm,
    /// uncorrected.
    #[must_use]
    pub fn with_specific_forces(mut self, specific: [Option<Arc<FormulaModel>>; 3]) -> Self {
        let MillingSetup { steel, rake_deg, hardness_hb, .. } = self.setup;
        let corrections = Kienzle::corrections(&steel, LAW_SPEED_M_MIN, rake_deg, hardness_hb);
        self.law = OwnEdgeLaw { specific, corrections, ..self.law };
        self
    }

    fn set_speed(&mut self, speed_rpm: f64) {
        self.speed_rpm = speed_rpm;
        let speed_m_min = math::PI * self.setup.cutter.outline.diameter_mm * speed_rpm / 1000.0;
        self.speed_factor = self.setup.factor * math::pow(LAW_SPEED_M_MIN / speed_m_min, 0.153);
    }

    /// Takes over the angle, the last forces and the surface of another cutter.
    pub fn take_over(&mut self, before: &Self) {
        (self.turn, self.sampled_turn) = (before.turn, before.sampled_turn);
        (self.turns, self.last_n) = (before.turns, before.last_n);
        self.surface.take_over(&before.surface);
    }

    /// The tool has left the part: no force is left that could bend it, and the next cut has a surface of its
    /// own.
    pub fn restart(&mut self) {
        (self.turns, self.last_n) = (0.0, [0.0; 2]);
        self.surface.restart();
    }

    /// The spindle's turn at the last sample, from 0 to below 1.
    #[must_use]
    pub fn spindle_turn(&self) -> f64 {
        self.sampled_turn
    }

    /// The first so many teeth are broken from now on.
    pub fn break_teeth(&mut self, broken: usize) {
        self.sliced.break_teeth(broken);
    }

    /// Takes the model's own compliance away: a machine that is coupled to the cut has its own.
    pub fn make_rigid(&mut self) {
        self.compliance_mm_n = 0.0;
    }

    /// One sample: forces on the tool with the tool's axis at `x_mm` along `cut`, feed in
    /// mm/min, speed in 1/min; `factor` is what wear and the material's inhomogeneity multiply.
    pub fn update(
        &mut self,
        feed_mm_min: f64,
        speed_rpm: f64,
        x_mm: f64,
        cut: &CutPath,
        factor: f64,
    ) -> Cutting {
        let turned = rev_s_from_rpm(speed_rpm) * self.setup.dt_s;
        let teeth = self.sliced.teeth() as f64;
        let fed_mm = if speed_rpm > 0.0 { feed_mm_min / (teeth * speed_rpm) } else { 0.0 };
        let now = Stand { turns: self.turns, x_mm, force_n: self.last_n };
        let advances = self.surface.stand(&now, fed_mm, self.compliance_mm_n);
        let mut cutting = Cutting::default();
        if speed_rpm > 0.0 && self.surface.last_turn_mm() >= LEAST_TURN_MM {
            if speed_rpm != self.speed_rpm {
                self.set_speed(speed_rpm);
            }
            let angle = self.turn * math::TAU;
            let depth_at = |x: f64, y: f64| cut.depth_at(x_mm + x, y);
            cutting = self.sliced.forces(&self.law, angle, &advances, depth_at);
            let factor = self.speed_factor * factor;
            cutting.forces_n = cutting.forces_n.map(|force| force * factor);
        }
        let [x, y, _] = cutting.forces_n;
        self.last_n = [x, y];
        self.sampled_turn = self.turn;
        self.turns += turned;
        self.turn += turned;
        self.turn -= self.turn.floor();
        cutting
    }
}
