//! The delay equation of the cut on measured modes, integrated in time: whether a disturbance grows from tooth to tooth.
//!
//! The classical Runge-Kutta method of fourth order with the coefficients of the very instant; the delayed displacement
//! between two nodes of the last period is the cubic through values and slopes there. Nothing of it is shared with the
//! semi-discretisation but the angles at which the teeth enter and leave, where its steps end too.

use super::{TipCut, ToothStretch};
use crate::base::math::{self, TAU};
use crate::stability::least_unstable;

/// Steps to a period of the highest mode.
const STEPS_PER_PERIOD: f64 = 60.0;
/// Fewest steps of a stretch.
const FEWEST: usize = 24;
/// Tooth periods before the first window.
const SETTLING: u32 = 60;
/// Tooth periods of a window.
const WINDOW: u32 = 40;
/// Tooth periods from window to window.
const DISTANCE: u32 = 240;
/// Energies of a period that are kept as they are.
const FAR: std::ops::Range<f64> = 1e-40..1e40;

/// Displacement and velocity of the tip at a node, for each direction.
type Node = [[f64; 2]; 2];

struct Tip<'a> {
    cut: &'a TipCut,
    /// Direction, w, zeta, b K_t / m of every mode.
    modes: Vec<(usize, [f64; 3])>,
    omega: f64,
}

impl Tip<'_> {
    /// The tip's displacements and velocities.
    fn node(&self, state: &[[f64; 2]]) -> Node {
        let mut node = [[0.0; 2]; 2];
        for ((axis, _), [x, v]) in self.modes.iter().zip(state) {
            node[*axis][0] += x;
            node[*axis][1] += v;
        }
        node
    }

    /// The slopes of all modes at an angle with the tip one period before at `delayed`.
    fn slopes(
        &self,
        state: &[[f64; 2]],
        cutting: &[u32],
        rad: f64,
        delayed: [f64; 2],
    ) -> Vec<[f64; 2]> {
        let s = self.cut.at(cutting, rad);
        let now = self.node(state);
        let risen = [now[0][0] - delayed[0], now[1][0] - delayed[1]];
        let of = |((axis, [w, zeta, push]), [x, v]): (&(usize, [f64; 3]), &[f64; 2])| {
            let force = -(s[*axis][0] * risen[0] + s[*axis][1] * risen[1]);
            [*v, push * force - 2.0 * zeta * w * v - w * w * x]
        };
        self.modes.iter().zip(state).map(of).collect()
    }

    /// A step of `dt_s` from the angle `rad` between two nodes of the period before.
    fn step(
        &self,
        state: &mut [[f64; 2]],
        cutting: &[u32],
        (rad, dt_s): (f64, f64),
        [from, to]: [Node; 2],
    ) {
        let half = 0.5 * self.omega * dt_s;
        // The cubic at the middle.
        let middle = [0, 1].map(|axis| {
            let ([x0, v0], [x1, v1]) = (from[axis], to[axis]);
            0.5 * (x0 + x1) + 0.125 * dt_s * (v0 - v1)
        });
        let moved = |state: &[[f64; 2]], by: &[[f64; 2]], dt: f64| -> Vec<[f64; 2]> {
            let pairs = state.iter().zip(by);
            pairs.map(|([x, v], [dx, dv])| [x + dt * dx, v + dt * dv]).collect()
        };
        let ends = [from, to].map(|node| [node[0][0], node[1][0]]);
        let k1 = self.slopes(state, cutting, rad, ends[0]);
        let k2 = self.slopes(&moved(state, &k1, 0.5 * dt_s), cutting, rad + half, middle);
        let k3 = self.slopes(&moved(state, &k2, 0.5 * dt_s), cutting, rad + half, middle);
        let k4 = self.slopes(&moved(state, &k3, dt_s), cutting, rad + 2.0 * half, ends[1]);
        for (r, mode) in state.iter_mut().enumerate() {
            for (i, x) in mode.iter_mut().enumerate() {
                *x += dt_s / 6.0 * (k1[r][i] + 2.0 * k2[r][i] + 2.0 * k3[r][i] + k4[r][i]);
            }
        }
    }
}

/// Factor by which a disturbance grows from one tooth period to the next. Speed and depth are positive.
#[must_use]
pub fn growth(cut: &TipCut, speed_rpm: f64, depth_mm: f64) -> f64 {
    let omega = TAU * speed_rpm / 60.0;
    let directions = cut.directions();
    let stiffness = cut.stiffness_n_m(depth_mm);
    let modes = cut.placed_modes().into_iter().map(|(mode, place)| {
        let values = [mode.omega_rad_s(), mode.damping_ratio, stiffness / mode.mass_kg];
        (directions[place], values)
    });
    let tip = Tip { cut, modes: modes.collect(), omega };
    let longest_s = 1.0 / (STEPS_PER_PERIOD * cut.highest_hz());
    let stretches = cut.stretches();
    let steps = |stretch: &ToothStretch| {
        let length_s = (stretch.rad[1] - stretch.rad[0]) / omega;
        ((length_s / longest_s).ceil() as usize).max(FEWEST)
    };
    let count: usize = stretches.iter().map(|stretch| steps(stretch) + 1).sum();
    let mut nodes: Vec<Node> = vec![[[0.0; 2]; 2]; count];
    // Pushed once: every mode by a little of its own.
    let push = |r: usize| [1.0 / (r + 1) as f64, 0.0];
    let mut state: Vec<[f64; 2]> = (0..tip.modes.len()).map(push).collect();
    let windows = [SETTLING, SETTLING + DISTANCE].map(|from| from..from + WINDOW);
    // Energies of the windows, each over a factor whose logarithm stands beside it.
    let (mut energy, mut scales_ln) = ([0.0; 2], [0.0; 2]);
    for period in 0..SETTLING + DISTANCE + WINDOW {
        let mut at = 0;
        let mut sum = 0.0;
        for stretch in &stretches {
            let [from, to] = stretch.rad;
            let steps = steps(stretch);
            let (turned, dt_s) = ((to - from) / steps as f64, (to - from) / omega / steps as f64);
            let mut before = nodes[at];
            nodes[at] = tip.node(&state);
            for i in 0..steps {
                at += 1;
                let rad = from + turned * i as f64;
                tip.step(&mut state, &stretch.cutting, (rad, dt_s), [before, nodes[at]]);
                before = nodes[at];
                nodes[at] = tip.node(&state);
                sum +=
                    dt_s * (nodes[at][0][0] * nodes[at][0][0] + nodes[at][1][0] * nodes[at][1][0]);
            }
            at += 1;
        }
        for (window, energy) in windows.iter().zip(&mut energy) {
            if window.contains(&period) {
                *energy += sum;
            }
        }
        if !sum.is_finite() {
            return f64::INFINITY;
        }
        // What grows or decays by far is scaled back; a window that is over keeps its own scale.
        if sum > 0.0 && !FAR.contains(&sum) {
            let scale = 1.0 / sum.sqrt();
            state.iter_mut().flatten().for_each(|x| *x *= scale);
            nodes.iter_mut().flatten().flatten().for_each(|x| *x *= scale);
            let open = windows.iter().zip(energy.iter_mut().zip(&mut scales_ln));
            for (_, (energy, scale_ln)) in open.filter(|(window, _)| period + 1 < window.end) {
                *energy /= sum;
                *scale_ln += math::ln(sum);
            }
        }
    }
    let [first, second] = energy;
    if first > 0.0 && second > 0.0 {
        let grown_ln = math::ln(second / first) + scales_ln[1] - scales_ln[0];
        math::exp(grown_ln / f64::from(2 * DISTANCE))
    } else {
        0.0
    }
}

/// Least unstable depth in mm at `speed_rpm` up to `highest_mm`.
#[must_use]
pub fn limit_mm(cut: &TipCut, speed_rpm: f64, highest_mm: f64) -> Option<f64> {
    let start_mm = super::zero_order::at_any_speed_mm(cut);
    least_unstable(start_mm, highest_mm, |depth| growth(cut, speed_rpm, depth))
}
