//! The model with everything but feed and speed folded into the hidden biases.

use super::Valued;
use super::cut_point::{
    AXIAL_DEPTH_MM, AXIAL_PER_DIAMETER, CutPoint, DIAMETER_MM, FEED_PER_TOOTH_MM, GEOMETRY_CODE,
    HARDNESS_HB, INPUT_MAX, RADIAL_PER_DIAMETER, SPEED_M_MIN, TEETH, feed_per_tooth_mm,
    speed_m_min,
};
use crate::base::math;
use crate::base::network::{Activation, ScaledNetwork};

/// Number of interleaved sums over the hidden neurons: the processor need not wait for one to end.
const LANES: usize = 4;
/// Most hidden neurons; whole lanes.
pub const MAX_HIDDEN: usize = 24;

/// A neural force model of which only feed and speed are left open; evaluated without allocation.
#[derive(Clone, Debug, PartialEq)]
pub struct NeuralForceAt {
    /// Hidden neurons, filled up to whole lanes with neurons of no weight.
    padded: usize,
    activation: Activation,
    linear_output: bool,
    /// Whether feed and speed go in as logarithms.
    ln: [bool; 2],
    bias: [f64; MAX_HIDDEN],
    /// Of each hidden neuron's sum over feed and speed (or their logarithms).
    slopes: [[f64; MAX_HIDDEN]; 2],
    outer: [[f64; MAX_HIDDEN]; 3],
    outer_bias: [f64; 3],
    output_maps: [[f64; 2]; 3],
    rpm_per_m_min: f64,
    /// Asked over limited A_D R_D.
    section: f64,
    valid: bool,
}

impl NeuralForceAt {
    /// Folds `cut` into `scaled`, a network of shape 8-N-3.
    pub(super) fn new(scaled: &ScaledNetwork, cut: &CutPoint) -> Self {
        let mut valid = true;
        let mut within = |x: f64, [low, high]: [f64; 2]| {
            let limited = math::limit(x, low, high);
            valid &= limited == x;
            limited
        };
        let diameter = within(cut.diameter_mm, DIAMETER_MM);
        let axial_max = (diameter * AXIAL_PER_DIAMETER).min(AXIAL_DEPTH_MM[1]);
        let axial = within(cut.axial_depth_mm, [AXIAL_DEPTH_MM[0], axial_max]);
        let radial = within(cut.radial_depth_mm, RADIAL_PER_DIAMETER.map(|part| part * diameter));
        // There is no material between the two.
        let second = cut.material_code >= 1.5;
        let code = if second { 2.0 } else { 1.0 };
        let material = within(cut.material_code, [code, code]);
        let hardness = within(cut.hardness_hb, HARDNESS_HB[usize::from(second)]);
        let geometry = within(cut.geometry_code, GEOMETRY_CODE);
        let section = |asked: f64, limited: f64| math::limit(asked, 0.0, INPUT_MAX) / limited;
        let inputs = [1.0, 1.0, radial, axial, material, hardness, diameter, geometry];
        let ScaledNetwork { network, scaling } = scaled;
        let normal = scaling.normal_inputs(&inputs);
        let maps = [scaling.input_map(0), scaling.input_map(1)];
        let hidden = network.sizes()[1];
        let (inner, outer) = network.weights().split_at(9 * hidden);
        let mut at = Self {
            padded: hidden.next_multiple_of(LANES),
            activation: network.activation(),
            linear_output: network.linear_output(),
            ln: [scaling.ln_inputs[0], scaling.ln_inputs[1]],
            bias: [0.0; MAX_HIDDEN],
            slopes: [[0.0; MAX_HIDDEN]; 2],
            outer: [[0.0; MAX_HIDDEN]; 3],
            outer_bias: [0.0; 3],
            output_maps: [0, 1, 2].map(|i| scaling.output_map(i)),
            rpm_per_m_min: 1.0 / speed_m_min(diameter, 1.0),
            section: section(cut.axial_depth_mm, axial) * section(cut.radial_depth_mm, radial),
            valid,
        };
        for (i, row) in inner.chunks_exact(9).enumerate() {
            at.bias[i] = row[8] + row[0] * maps[0][1] + row[1] * maps[1][1];
            at.bias[i] += (2..8).map(|k| row[k] * normal[k]).sum::<f64>();
            (at.slopes[0][i], at.slopes[1][i]) = (row[0] * maps[0][0], row[1] * maps[1][0]);
        }
        for (k, row) in outer.chunks_exact(hidden + 1).enumerate() {
            at.outer[k][..hidden].copy_from_slice(&row[..hidden]);
            at.outer_bias[k] = row[hidden];
        }
        at
    }

    /// The first `N` components in N, and whether everything lay inside the ranges.
    #[inline]
    fn first<const N: usize>(&self, feed_mm_min: f64, speed_rpm: f64) -> ([f64; N], bool) {
        let asked_mm = feed_per_tooth_mm(feed_mm_min, speed_rpm);
        let feed_mm = math::limit(asked_mm, FEED_PER_TOOTH_MM[0], FEED_PER_TOOTH_MM[1]);
        let [slowest, fastest] = SPEED_M_MIN.map(|speed| speed * self.rpm_per_m_min);
        let speed = math::limit(speed_rpm, slowest, fastest);
        let feed = TEETH * feed_mm * speed;
        let [ln_feed, ln_speed] = self.ln;
        let x = if ln_feed { math::ln(feed) } else { feed };
        let y = if ln_speed { math::ln(speed) } else { speed };
        let mut values = [0.0; MAX_HIDDEN];
        for (i, value) in values[..self.padded].iter_mut().enumerate() {
            *value = self.bias[i] + self.slopes[0][i] * x + self.slopes[1][i] * y;
        }
        self.activation.apply(&mut values[..self.padded]);
        let mut outputs = [0.0; N];
        for (k, output) in outputs.iter_mut().enumerate() {
            let weights = self.outer[k][..self.padded].chunks_exact(LANES);
            let mut sums = [0.0; LANES];
            for (weights, values) in weights.zip(values.chunks_exact(LANES)) {
                for lane in 0..LANES {
                    sums[lane] += weights[lane] * values[lane];
                }
            }
            *output = self.outer_bias[k] + ((sums[0] + sums[1]) + (sums[2] + sums[3]));
        }
        if !self.linear_output {
            self.activation.apply(&mut outputs);
        }
        let section = self.section * (asked_mm / feed_mm);
        for (output, [slope, intercept]) in outputs.iter_mut().zip(self.output_maps) {
            *output = section * (slope * *output + intercept);
        }
        (outputs, self.valid && feed_mm == asked_mm && speed == speed_rpm)
    }

    /// Signed Fx, Fy, Fz in N at the instant of the largest F_xy.
    #[must_use]
    pub fn components(&self, feed_mm_min: f64, speed_rpm: f64) -> [f64; 3] {
        self.first::<3>(feed_mm_min, speed_rpm).0
    }

    /// The peak force F_xy = sqrt(Fx^2 + Fy^2) in N; invalid where an input was outside the ranges.
    #[must_use]
    #[inline]
    pub fn peak(&self, feed_mm_min: f64, speed_rpm: f64) -> Valued {
        let ([fx, fy], valid) = self.first::<2>(feed_mm_min, speed_rpm);
        Valued::new((fx * fx + fy * fy).sqrt(), valid)
    }
}
