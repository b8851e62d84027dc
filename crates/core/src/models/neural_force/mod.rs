//! The papers' neural cutting-force model: eight inputs, fifteen hidden neurons, three force
//! components, arc tangent (2013, section 2.3).
//!
//! The 3500 measurements that the papers trained it with were never published. The two networks
//! shipped here learned from the mechanistic model of [`super::mechanistic`] with noise
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
use crate::base::language::tr;
use crate::base::network::{self, Provenance, ScaledNetwork};

mod cut_point;
mod folded;

pub use cut_point::*;
pub use folded::{MAX_HIDDEN, NeuralForceAt};

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
            Self::Improved => include_str!("../../../../../assets/models/force_improved.json"),
            Self::Literal => include_str!("../../../../../assets/models/force_literal.json"),
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
            sizes => Err(tr!(
                "`sizes` cannot be {sizes}: allowed is 8, 1 to {most} and 3 neurons",
                sizes = format!("{sizes:?}"),
                most = MAX_HIDDEN
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
        NeuralForceAt::new(&self.scaled, cut)
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::base::network::Activation;

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
