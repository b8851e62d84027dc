//! What gives the plant's cutting force, and what follows from the choice for everything around it.

use crate::models::genetic::ModelSet;
use crate::models::neural_force::NeuralKind;
use crate::models::printed::Printed;

crate::choice! {
    /// What gives the plant's cutting force.
    pub enum ForceModel {
        /// The formula of the model set: K4 or M4.
        Formula = "formula", "Formula (K4, M4)";
        /// The 8-15-3 network trained for accuracy.
        Neural = "neural", "Neural network";
        /// The 8-15-3 network with the inputs and learning parameters of the 2013 paper.
        NeuralLiteral = "neural_literal", "Neural network as in the paper";
        /// The mechanistic model of the end mill, tooth by tooth (2005 milling simulator); wants
        /// plant steps of some 30 us.
        Mechanistic = "mechanistic", "Tooth by tooth";
    }
}

/// Longest plant step tooth by tooth, s: some 180 samples for a tooth period of the papers' cut.
const TOOTH_STEP_MAX_S: f64 = 1e-4;

const K4: &[Printed] = &[Printed::new(
    "F = 286.44 - 5.82·10^{-10} n^3 - 8973 ln(0.039 f) / f",
    "SDNRP 2007, eq. 7 (Ck45, A_D 2 mm, R_D 3 mm, sharp tool)",
)];
const M4: &[Printed] = &[Printed::new(
    "F = 265.11 (1 - 2.0·10^{-12} n^3 - (31.32 / f) ln(0.039 f))",
    "Control strategy 2013, eq. 5; the paper then takes its neural network in place of it",
)];
const NETWORK: &[Printed] = &[Printed::new(
    "F_x, F_y, F_z = NN(f, n, R_D, A_D, material, hardness, D, geometry)",
    "Control strategy 2013, section 2.3: 8 inputs, 15 hidden neurons, 3 outputs; its weights were \
     never published",
)];
const TEETH: &[Printed] = &[
    Printed::new(
        "h = [(f_t + X_m) sin φ + Y_m cos φ + Δρ] sin κ",
        "Combined system 2005, Fig. 3 (lost), as ball-end geometry after Lee and Altintas",
    ),
    Printed::new(
        "X_m = G [F_x(t) - F_x(t - T)],  Y_m = G [F_y(t) - F_y(t - T)]",
        "Combined system 2005, eq. 1: compliance with the delay of one tooth period",
    ),
    Printed::new(
        "dF_i = k_i h^{1 - m} db",
        "Kienzle's laws, tangential, radial and axial (constants of published tables, in part chosen)",
    ),
];

impl ForceModel {
    /// The force models that are functions of feed, speed and depth, as published tables need them:
    /// those of which [`Self::is_map`] is true.
    pub const MAPS: [Self; 3] = [Self::Formula, Self::Neural, Self::NeuralLiteral];

    /// Whether the force is simulated instant by instant, with the teeth that make it: it then has
    /// run-out, slices, an angle of the spindle and a force along each axis.
    #[must_use]
    pub fn tooth_by_tooth(self) -> bool {
        match self {
            Self::Formula | Self::Neural | Self::NeuralLiteral => false,
            Self::Mechanistic => true,
        }
    }

    /// Whether the force is a function of feed, speed and engagement that gives the largest force of
    /// a revolution at once.
    #[must_use]
    pub fn is_map(self) -> bool {
        !self.tooth_by_tooth()
    }

    /// Whether the force is the formula of a published model set, K4 or M4: what the tables of the
    /// papers were made with.
    #[must_use]
    pub fn is_formula(self) -> bool {
        match self {
            Self::Formula => true,
            Self::Neural | Self::NeuralLiteral | Self::Mechanistic => false,
        }
    }

    /// The network; `None` for the other force models.
    #[must_use]
    pub fn network(self) -> Option<NeuralKind> {
        match self {
            Self::Formula | Self::Mechanistic => None,
            Self::Neural => Some(NeuralKind::Improved),
            Self::NeuralLiteral => Some(NeuralKind::Literal),
        }
    }

    /// Longest plant step in s with which the force can be simulated; infinite for a map.
    #[must_use]
    pub fn longest_step_s(self) -> f64 {
        match self {
            Self::Formula | Self::Neural | Self::NeuralLiteral => f64::INFINITY,
            Self::Mechanistic => TOOTH_STEP_MAX_S,
        }
    }

    /// The model set that was identified on this very force; `None` where the controller's models are
    /// those of the plant's own set.
    #[must_use]
    pub fn identified_set(self) -> Option<ModelSet> {
        match self {
            Self::Formula | Self::Neural | Self::NeuralLiteral => None,
            Self::Mechanistic => Some(ModelSet::Milling2005),
        }
    }

    /// What it is called beside K1..K6 or M1..M6, where the formula is that of `set`.
    #[must_use]
    pub fn short_name(self, set: ModelSet) -> String {
        match self {
            Self::Formula => format!("{}4", set.letter()),
            // As in the paper of 2013.
            Self::Neural | Self::NeuralLiteral => "NN".to_owned(),
            Self::Mechanistic => "by teeth".to_owned(),
        }
    }

    /// Its equations as printed, where the formula is that of `set`.
    #[must_use]
    pub fn printed(self, set: ModelSet) -> &'static [Printed] {
        match self {
            Self::Formula => match set {
                // Those of the milling simulator have the forms of 2007.
                ModelSet::Sdnrp2007 | ModelSet::Milling2005 => K4,
                ModelSet::Strategy2013 => M4,
            },
            Self::Neural | Self::NeuralLiteral => NETWORK,
            Self::Mechanistic => TEETH,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_maps_are_those_that_say_so() {
        let maps = ForceModel::ALL.iter().copied().filter(|model| model.is_map());
        assert!(maps.eq(ForceModel::MAPS));
    }

    #[test]
    fn what_is_simulated_by_the_teeth_needs_short_steps_and_its_own_models() {
        for model in ForceModel::ALL {
            assert_eq!(model.tooth_by_tooth(), model.longest_step_s().is_finite(), "{model:?}");
            assert_eq!(model.tooth_by_tooth(), model.identified_set().is_some(), "{model:?}");
        }
    }
}
