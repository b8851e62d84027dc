//! The three networks of the neural control scheme UNKS (2005): NM-R, NM-1 and NM-2, arc tangent in
//! the hidden layer, linear at the output, trained by `steadycut train unks`.
//!
//! ```text
//! NM-R  2-12-1  (F_ref, F)                            -> F_ref / F, limited to 0..1.5
//! NM-1  4-8-1   (f0, f0-f1, f0-f2, ln(a_c/a_0))       -> f(k+H) - f0
//! NM-2  4-8-1   (f0, f0-f1, f0-f2, ln(F_wanted/F))    -> ln(a(k+H)/a_0)
//! ```
//!
//! f_i = ln of the peak force i control periods ago in kN, a the override that the feed drive has
//! reached, H the horizon. Forces are taken relative to a reference of 0.665 kN, that of
//! Experiment 2, so that the networks serve every plant.
//!
//! The cold start has an NM-2 of its own that gives the override itself (spec: literal
//! feedback-error learning): NM-2 (f0 - ln a_0, f0-f1, f0-f2, ln F_ref) -> ln u. Its hidden layer is
//! random and its output layer zero, so that u = 1 before it has learned.

mod stored;

pub use stored::{Stored, StoredNetworks};

use std::sync::LazyLock;

use crate::base::language::tr;
use crate::base::math;
use crate::base::network::{Activation, Network, ScaledNetwork, Scaling, parse};
use crate::base::rng::Stream;

crate::choice! {
    /// What the scheme begins with.
    pub enum UnksStart {
        /// Networks that were trained before (train unks), with the internal loop through NM-1.
        Shipped = "shipped", "trained before";
        /// An untrained NM-2 beside the division controller, literal feedback-error learning.
        Cold = "cold", "cold start";
    }
}

/// Reference force of the networks' kilonewtons.
pub const REFERENCE_KN: f64 = 0.665;
/// Least force of which the logarithm is taken, kN.
pub const LEAST_KN: f64 = 0.03;
/// Control periods of the horizon beyond the dead time.
pub const HORIZON_BEYOND: usize = 4;

/// Logarithm of a normalised force as the networks see it.
#[must_use]
pub fn log_force(normalised: f64) -> f64 {
    math::ln((normalised * REFERENCE_KN).max(LEAST_KN))
}

/// The three networks.
#[derive(Clone, Debug, PartialEq)]
pub struct UnksNetworks {
    /// NM-R, the controller of the feedback loops.
    pub reference: ScaledNetwork,
    /// NM-1, the process forward.
    pub forward: ScaledNetwork,
    /// NM-2, the process inverted.
    pub inverse: ScaledNetwork,
}

/// Files of the shipped networks in the order NM-R, NM-1, NM-2.
pub const FILES: [&str; 3] = [
    include_str!("../../../../assets/models/unks_nmr.json"),
    include_str!("../../../../assets/models/unks_nm1.json"),
    include_str!("../../../../assets/models/unks_nm2.json"),
];
/// Their shapes.
pub const SIZES: [&[usize]; 3] = [&[2, 12, 1], &[4, 8, 1], &[4, 8, 1]];

static SHIPPED: LazyLock<UnksNetworks> = LazyLock::new(|| {
    UnksNetworks::parse(FILES).expect("the shipped networks are checked by a test")
});

impl UnksNetworks {
    /// The shipped networks.
    #[must_use]
    pub fn shipped() -> &'static Self {
        &SHIPPED
    }

    /// What a start begins with; from a cold start, `draw` is the seed of the random weights of
    /// NM-2's hidden layer.
    #[must_use]
    pub fn at_start(start: UnksStart, draw: u32) -> Self {
        let shipped = Self::shipped().clone();
        match start {
            UnksStart::Shipped => shipped,
            UnksStart::Cold => Self { inverse: untrained(draw), ..shipped },
        }
    }

    /// Reads three network files in the order of [`FILES`].
    ///
    /// # Errors
    /// Names the network and the faulty field.
    pub fn parse(files: [&str; 3]) -> Result<Self, String> {
        let read = |i: usize| {
            let name = ["NM-R", "NM-1", "NM-2"][i];
            let (scaled, _) = parse(files[i]).map_err(|error| format!("{name}: {error}"))?;
            let sizes = scaled.network.sizes();
            if sizes == SIZES[i] {
                Ok(scaled)
            } else {
                Err(tr!(
                    "{name}: `sizes` cannot be {sizes}: allowed is {allowed}",
                    name = name,
                    sizes = format!("{sizes:?}"),
                    allowed = format!("{:?}", SIZES[i])
                ))
            }
        };
        Ok(Self { reference: read(0)?, forward: read(1)?, inverse: read(2)? })
    }

    /// NM-R: F_ref / F, limited to 0..1.5, for forces in kN.
    #[must_use]
    pub fn ratio(&self, reference_kn: f64, force_kn: f64) -> f64 {
        let force_kn = math::limit(force_kn, 0.1, 2.0);
        math::limit(self.reference.predict(&[reference_kn, force_kn])[0], 0.0, 1.5)
    }
}

/// Ranges of the inputs of NM-2 from a cold start (chosen, spec).
const COLD_INPUTS: [[f64; 2]; 4] = [[-1.5, 1.0], [-0.5, 0.5], [-0.5, 0.5], [-1.5, 0.5]];
/// Range of its output, ln u.
const COLD_OUTPUT: [f64; 2] = [-1.5, 0.5];

/// NM-2 before it has learned anything: u = 1 whatever it is asked.
fn untrained(draw: u32) -> ScaledNetwork {
    let sizes = SIZES[2];
    let stream = Stream::new(u64::from(draw), "unks.cold");
    let random = Network::random(sizes, Activation::Arctan, true, stream);
    let mut weights = random.expect("the sizes are allowed").weights().to_vec();
    let outputs = weights.len() - (sizes[1] + 1);
    weights[outputs..].fill(0.0);
    // The bias that gives ln u = 0.
    let [low, high] = COLD_OUTPUT;
    *weights.last_mut().expect("it has a bias") = -(low + high) / (high - low);
    let network = Network::new(sizes, Activation::Arctan, true, weights);
    let scaling = Scaling {
        norm: [-1.0, 1.0],
        target: [-1.0, 1.0],
        ln_inputs: vec![false; COLD_INPUTS.len()],
        inputs: COLD_INPUTS.to_vec(),
        outputs: vec![COLD_OUTPUT],
    };
    ScaledNetwork { network: network.expect("as many weights as before"), scaling }.as_in_file()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_shipped_networks_do_what_they_are_for() {
        let networks = UnksNetworks::shipped();
        // NM-R is F_ref / F where that is below its cap.
        for (reference, force) in [(0.3, 0.6), (0.665, 0.665), (0.665, 1.4), (0.9, 1.8)] {
            let ratio = networks.ratio(reference, force);
            assert!((ratio - reference / force).abs() < 0.06, "{reference} / {force}: {ratio}");
        }
        // More feed makes more force, and more force wanted asks for more feed.
        let with = |network: &ScaledNetwork, last: f64| network.predict(&[-0.4, 0.0, 0.0, last])[0];
        assert!(with(&networks.forward, 0.3) > with(&networks.forward, -0.3) + 0.2);
        assert!(with(&networks.inverse, 0.3) > with(&networks.inverse, -0.3) + 0.2);
    }

    #[test]
    fn an_untrained_inverse_model_asks_for_the_programmed_feed() {
        let cold = UnksNetworks::at_start(UnksStart::Cold, 7);
        assert_ne!(cold, UnksNetworks::at_start(UnksStart::Cold, 8));
        for inputs in [[-1.0, 0.2, -0.3, -0.4], [0.7, 0.0, 0.1, 0.3]] {
            assert!(cold.inverse.predict(&inputs)[0].abs() < 1e-12);
        }
        assert_eq!(cold.reference, UnksNetworks::shipped().reference);
    }

    #[test]
    fn files_of_other_shapes_are_refused_by_name() {
        let [ratio, forward, inverse] = FILES;
        let swapped = UnksNetworks::parse([forward, ratio, inverse]).unwrap_err();
        assert!(swapped.contains("NM-R") && swapped.contains("`sizes`"), "{swapped}");
        let broken = UnksNetworks::parse([ratio, "{}", inverse]).unwrap_err();
        assert!(broken.contains("NM-1"), "{broken}");
    }
}
