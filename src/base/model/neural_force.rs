//! The papers' neural cutting-force model: eight inputs, fifteen hidden neurons, three force
//! components, arc tangent (2013, section 2.3).
//!
//! The 3500 measurements that the papers trained it with were never published. The two networks
//! shipped here learned from the mechanistic model of [`super::ball_end`] with noise
//! (`steadycut train force`). Their outputs are the signed Fx, Fy, Fz at the instant of the largest
//! F_xy, so that sqrt(Fx^2 + Fy^2) is the peak force; separate maxima of the axes would overstate
//! it by 5 to 20 %, absolute values would put a kink where Fy changes sign.
//!
//! A network does not extrapolate. Outside the ranges of its training data the inputs are limited
//! to them, the force is scaled in proportion to the cross-section of the chip (feed per tooth,
//! A_D, R_D: asked over limited), and the answer is marked invalid: no feed or depth gives no
//! force, and the force keeps rising with them. The ranges of feed and speed are those of feed per
//! tooth and cutting speed.

use std::sync::LazyLock;

use super::Valued;
use crate::base::math;
use crate::base::network::{self, Activation, Provenance, ScaledNetwork};

/// Teeth of the cutters in the training data.
pub const TEETH: f64 = 2.0;
/// Feed per tooth in the training data, mm.
pub const FEED_PER_TOOTH_MM: [f64; 2] = [0.02, 0.2];
/// Cutting speed, m/min.
pub const SPEED_M_MIN: [f64; 2] = [40.0, 150.0];
/// Axial depth A_D, mm; also at most [`AXIAL_PER_DIAMETER`] of the diameter.
pub const AXIAL_DEPTH_MM: [f64; 2] = [0.5, 5.0];
/// Largest axial depth over the diameter.
pub const AXIAL_PER_DIAMETER: f64 = 1.0 / 3.0;
/// Radial depth R_D over the diameter.
pub const RADIAL_PER_DIAMETER: [f64; 2] = [0.12, 0.5];
/// Cutter diameter, mm.
pub const DIAMETER_MM: [f64; 2] = [10.0, 20.0];
/// Hardness of Ck45 (code 1) and 16MnCrSi5 (code 2), HB.
pub const HARDNESS_HB: [[f64; 2]; 2] = [[180.0, 240.0], [150.0, 210.0]];
/// Tool geometry code.
pub const GEOMETRY_CODE: [f64; 2] = [1.0, 3.0];
/// Below this speed, 1/min, the feed per tooth is taken as at it: at rest it would be infinite.
const SPEED_FLOOR_RPM: f64 = 1.0;
/// Inputs beyond this magnitude (mm/min, 1/min, mm) are taken as it, so that forces stay finite.
const INPUT_MAX: f64 = 1e6;
/// Names of the inputs in the order of the network.
pub const INPUTS: [&str; 8] = [
    "feed_mm_min",
    "speed_rpm",
    "radial_depth_mm",
    "axial_depth_mm",
    "material_code",
    "hardness_hb",
    "diameter_mm",
    "geometry_code",
];
/// Hidden neurons are summed in this many interleaved sums, which do not wait for each other.
const LANES: usize = 4;
/// Most hidden neurons; whole lanes.
pub const MAX_HIDDEN: usize = 24;

/// Cutting speed in m/min of a diameter in mm at a speed in 1/min.
#[must_use]
pub fn speed_m_min(diameter_mm: f64, speed_rpm: f64) -> f64 {
    math::PI * diameter_mm * speed_rpm / 1000.0
}

/// A cut as the network sees it: the papers' eight inputs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CutPoint {
    /// Feed, mm/min.
    pub feed_mm_min: f64,
    /// Spindle speed, 1/min.
    pub speed_rpm: f64,
    /// Radial depth of cut R_D, mm.
    pub radial_depth_mm: f64,
    /// Axial depth of cut A_D, mm.
    pub axial_depth_mm: f64,
    /// Material: 1 Ck45, 2 16MnCrSi5.
    pub material_code: f64,
    /// Hardness, HB.
    pub hardness_hb: f64,
    /// Cutter diameter D, mm.
    pub diameter_mm: f64,
    /// Tool geometry: 1, 2, 3 for a rake of 6, 9, 12 deg. It stands for the papers' 8-digit code,
    /// which was not published.
    pub geometry_code: f64,
}

impl CutPoint {
    /// The inputs in the order of [`INPUTS`].
    #[must_use]
    pub fn inputs(&self) -> [f64; 8] {
        [
            self.feed_mm_min,
            self.speed_rpm,
            self.radial_depth_mm,
            self.axial_depth_mm,
            self.material_code,
            self.hardness_hb,
            self.diameter_mm,
            self.geometry_code,
        ]
    }

    /// Feed per tooth in mm, for the training data's [`TEETH`].
    #[must_use]
    pub fn feed_per_tooth_mm(&self) -> f64 {
        feed_per_tooth_mm(self.feed_mm_min, self.speed_rpm)
    }
}

fn feed_per_tooth_mm(feed_mm_min: f64, speed_rpm: f64) -> f64 {
    let speed_rpm = math::limit(speed_rpm, SPEED_FLOOR_RPM, INPUT_MAX);
    math::limit(feed_mm_min, 0.0, INPUT_MAX) / (TEETH * speed_rpm)
}

crate::choice! {
    /// One of the two shipped networks.
    pub enum NeuralKind {
        /// Logarithms of the continuous inputs, ranges -1 to 1, other rates; the same 8-15-3 shape.
        Improved = "improved", "improved";
        /// The paper's inputs, ranges and learning parameters, reported as it is.
        Literal = "literal", "as in the paper";
    }
}

static IMPROVED: LazyLock<NeuralForce> = LazyLock::new(|| shipped(NeuralKind::Improved));
static LITERAL: LazyLock<NeuralForce> = LazyLock::new(|| shipped(NeuralKind::Literal));

fn shipped(kind: NeuralKind) -> NeuralForce {
    NeuralForce::parse(kind.file()).expect("the shipped network files are checked by a test")
}

impl NeuralKind {
    /// The shipped file, written by `steadycut train force`.
    #[must_use]
    pub fn file(self) -> &'static str {
        match self {
            Self::Improved => include_str!("../../../assets/models/force_improved.json"),
            Self::Literal => include_str!("../../../assets/models/force_literal.json"),
        }
    }
}

/// A neural force model with one hidden layer.
#[derive(Clone, Debug, PartialEq)]
pub struct NeuralForce {
    scaled: ScaledNetwork,
    provenance: Provenance,
}

impl NeuralForce {
    /// A shipped network.
    #[must_use]
    pub fn shipped(kind: NeuralKind) -> &'static Self {
        match kind {
            NeuralKind::Improved => &IMPROVED,
            NeuralKind::Literal => &LITERAL,
        }
    }

    /// Reads a network file.
    ///
    /// # Errors
    /// Names the faulty field; `sizes` must be 8, 1 to [`MAX_HIDDEN`], 3.
    pub fn parse(json: &str) -> Result<Self, String> {
        let (scaled, provenance) = network::parse(json)?;
        match scaled.network.sizes() {
            [8, hidden, 3] if *hidden <= MAX_HIDDEN => Ok(Self { scaled, provenance }),
            sizes => Err(format!(
                "`sizes` cannot be {sizes:?}: allowed is 8, 1 to {MAX_HIDDEN} and 3 neurons"
            )),
        }
    }

    /// The network with its scaling.
    #[must_use]
    pub fn network(&self) -> &ScaledNetwork {
        &self.scaled
    }

    /// Where its weights come from.
    #[must_use]
    pub fn provenance(&self) -> &Provenance {
        &self.provenance
    }

    /// Signed Fx, Fy, Fz in N at the instant of the largest F_xy.
    #[must_use]
    pub fn components(&self, cut: &CutPoint) -> [f64; 3] {
        self.at(cut).components(cut.feed_mm_min, cut.speed_rpm)
    }

    /// The model of one tool in one material at given depths, where only feed and speed are left:
    /// everything else of `cut` is folded into the hidden biases.
    #[must_use]
    pub fn at(&self, cut: &CutPoint) -> NeuralForceAt {
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
        let (network, scaling) = (&self.scaled.network, &self.scaled.scaling);
        let normal = scaling.normal_inputs(&inputs);
        let maps = [scaling.input_map(0), scaling.input_map(1)];
        let hidden = network.sizes()[1];
        let (inner, outer) = network.weights().split_at(9 * hidden);
        let mut at = NeuralForceAt {
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

    /// The bits of both shipped networks' forces over a grid that goes beyond the ranges: equal
    /// words mean equal networks and equal arithmetic.
    #[must_use]
    pub fn output_bits() -> Vec<u64> {
        let mut words = Vec::new();
        for kind in NeuralKind::ALL {
            for (diameter_mm, axial_depth_mm, radial_depth_mm) in
                [(16.0, 2.0, 4.0), (16.0, 2.0, 3.0), (10.0, 0.5, 5.0), (20.0, 7.0, 1.0)]
            {
                for (material_code, hardness_hb, geometry_code) in
                    [(1.0, 200.0, 3.0), (2.0, 180.0, 1.0)]
                {
                    let at = Self::shipped(*kind).at(&CutPoint {
                        feed_mm_min: 0.0,
                        speed_rpm: 0.0,
                        radial_depth_mm,
                        axial_depth_mm,
                        material_code,
                        hardness_hb,
                        diameter_mm,
                        geometry_code,
                    });
                    for feed_mm_min in [20.0, 254.65, 324.61, 900.0] {
                        for speed_rpm in [500.0, 1591.55, 2201.0, 4000.0] {
                            let forces = at.components(feed_mm_min, speed_rpm);
                            words.extend(forces.map(f64::to_bits));
                        }
                    }
                }
            }
        }
        words
    }
}

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

#[cfg(test)]
mod tests {
    use super::*;

    const CUT: CutPoint = CutPoint {
        feed_mm_min: 254.65,
        speed_rpm: 1591.55,
        radial_depth_mm: 4.0,
        axial_depth_mm: 2.0,
        material_code: 1.0,
        hardness_hb: 200.0,
        diameter_mm: 16.0,
        geometry_code: 3.0,
    };

    fn both() -> impl Iterator<Item = &'static NeuralForce> {
        NeuralKind::ALL.iter().map(|kind| NeuralForce::shipped(*kind))
    }

    #[test]
    fn folded_inputs_give_what_the_whole_network_gives() {
        for force in both() {
            for (speed_rpm, axial_depth_mm, diameter_mm, material_code, hardness_hb) in
                [(1591.55, 2.0, 16.0, 1.0, 200.0), (3000.0, 3.0, 10.0, 2.0, 160.0)]
            {
                let feed_mm_min = 0.11 * TEETH * speed_rpm;
                let cut = CutPoint {
                    feed_mm_min,
                    speed_rpm,
                    axial_depth_mm,
                    diameter_mm,
                    material_code,
                    hardness_hb,
                    ..CUT
                };
                let at = force.at(&cut);
                let folded = force.components(&cut);
                let whole = force.network().predict(&cut.inputs());
                for (folded, whole) in folded.iter().zip(whole) {
                    assert!((folded - whole).abs() < 1e-9 * whole.abs().max(1.0));
                }
                let peak = at.peak(feed_mm_min, speed_rpm);
                let [fx, fy, _] = folded;
                assert_eq!(peak, Valued::new((fx * fx + fy * fy).sqrt(), true));
            }
        }
    }

    #[test]
    fn beyond_the_ranges_the_force_follows_the_chip_and_is_marked() {
        for force in both() {
            let at = force.at(&CUT);
            let feed = |feed_per_tooth_mm: f64| TEETH * feed_per_tooth_mm * CUT.speed_rpm;
            let end = at.peak(feed(0.2), CUT.speed_rpm).value;
            let beyond = at.peak(feed(0.5), CUT.speed_rpm);
            assert!(!beyond.valid && (beyond.value - 2.5 * end).abs() < 1e-6 * end);
            assert_eq!(at.peak(0.0, CUT.speed_rpm), Valued::new(0.0, false));
            assert_eq!(at.peak(0.0, 0.0), Valued::new(0.0, false));
            let deep = force.at(&CutPoint { axial_depth_mm: 10.0, ..CUT });
            let five = force.at(&CutPoint { axial_depth_mm: 5.0, ..CUT });
            let [ten_n, five_n] = [deep, five].map(|at| at.peak(feed(0.08), CUT.speed_rpm));
            assert!(!ten_n.valid && five_n.valid);
            assert!((ten_n.value - 2.0 * five_n.value).abs() < 1e-9 * ten_n.value);
            for no_cut in
                [CutPoint { axial_depth_mm: 0.0, ..CUT }, CutPoint { radial_depth_mm: -1.0, ..CUT }]
            {
                assert_eq!(force.at(&no_cut).peak(feed(0.08), CUT.speed_rpm).value, 0.0);
            }
            for odd in [
                CutPoint { material_code: 1.2, ..CUT },
                CutPoint { hardness_hb: 300.0, ..CUT },
                CutPoint { geometry_code: 0.0, ..CUT },
                CutPoint { diameter_mm: 50.0, ..CUT },
            ] {
                assert!(!force.at(&odd).peak(feed(0.08), CUT.speed_rpm).valid, "{odd:?}");
            }
        }
    }

    #[test]
    fn no_input_makes_a_force_that_is_not_finite() {
        let extremes = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0, -1.0, 1e-300, 1e300, 2.0];
        for force in both() {
            for a in extremes {
                for b in extremes {
                    for cut in [
                        CutPoint { axial_depth_mm: a, radial_depth_mm: b, ..CUT },
                        CutPoint { material_code: a, hardness_hb: b, ..CUT },
                        CutPoint { diameter_mm: a, geometry_code: b, ..CUT },
                    ] {
                        let at = force.at(&cut);
                        assert!(at.peak(a, b).value.is_finite(), "{a} {b} {cut:?}");
                        assert!(at.components(b, a).iter().all(|n| n.is_finite()), "{a} {b}");
                    }
                }
            }
        }
    }

    #[test]
    fn the_force_rises_with_the_feed() {
        for force in both() {
            for (axial_depth_mm, radial_depth_mm, diameter_mm) in
                [(2.0, 4.0, 16.0), (2.0, 3.0, 16.0), (1.0, 5.0, 10.0), (5.0, 10.0, 20.0)]
            {
                let at =
                    force.at(&CutPoint { axial_depth_mm, radial_depth_mm, diameter_mm, ..CUT });
                for speed_rpm in [400.0, 1000.0, 1591.55, 2500.0, 6000.0] {
                    let peaks = (0..400).map(|i| at.peak(f64::from(i) * 10.0, speed_rpm).value);
                    let peaks: Vec<f64> = peaks.collect();
                    let fall = peaks.windows(2).position(|pair| pair[1] <= pair[0]);
                    assert!(fall.is_none(), "{diameter_mm} mm at {speed_rpm}, step {fall:?}");
                }
            }
        }
    }

    #[test]
    fn other_shapes_are_refused() {
        let file = NeuralKind::Improved.file();
        assert!(NeuralForce::parse(&file.replace("15", "14")).unwrap_err().contains("weights"));
        let network = network::Network::new(&[2, 3], Activation::Arctan, false, vec![0.1; 9]);
        let mut other = NeuralForce::parse(file).unwrap();
        other.scaled.network = network.unwrap();
        other.scaled.scaling.inputs.truncate(2);
        other.scaled.scaling.ln_inputs.truncate(2);
        let text = network::write(&other.scaled, &other.provenance);
        assert!(NeuralForce::parse(&text).unwrap_err().contains("[2, 3]"));
    }
}
