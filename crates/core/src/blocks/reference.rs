//! The reference block: target roughness to desired force, F_d = K1(Ra_target) (2007 eq. 4),
//! computed once and again when the target moves.

use crate::models::Valued;
use crate::models::genetic::GeneticModels;
use crate::models::part::AIR_FRACTION;

/// Least target roughness, um.
const RA_MIN_UM: f64 = 0.05;

crate::choice! {
    /// What the loop is to hold.
    pub enum Reference {
        /// The force that leaves the target Ra, by the controller's model.
        Ra = "ra", "target Ra";
        /// A force of its own, as in the 2005 system.
        Force = "force", "force";
    }
}

crate::settings! {
    /// The target of the cut.
    pub struct Target {
        /// Target roughness Ra of the finished surface.
        ra_um: f64 = 0.81, [RA_MIN_UM, 4.0], "um", live, "Target Ra";
        /// What the loop is to hold.
        reference: Reference = Reference::Ra, [], "", live, "Reference";
        /// The force to hold where the reference is a force; 665 N is Experiment 2 of 2005.
        force_n: f64 = 665.0, [10.0, 5000.0], "N", live, "Reference force";
        /// Half-width of the tolerance band around the target, in percent of the target.
        tolerance_percent: f64 = 10.0, [1.0, 50.0], "%", live, "Tolerance";
    }
}

/// The force in N that the loop must hold for this target, by the controller's model.
#[must_use]
pub fn desired_force(target: &Target, belief: &GeneticModels) -> Valued {
    match target.reference {
        Reference::Ra => belief.force_from_ra(target.ra_um),
        Reference::Force => Valued::new(target.force_n, true),
    }
}

/// The roughness in um that the loop aims at: the target, or what the reference force leaves by
/// the controller's model; at least the least target, so that deviations stay defined.
#[must_use]
pub fn desired_ra(target: &Target, belief: &GeneticModels) -> f64 {
    match target.reference {
        Reference::Ra => target.ra_um,
        Reference::Force => belief.ra_from_force(target.force_n).value.max(RA_MIN_UM),
    }
}

/// What the loop is to hold, by the controller's models.
#[derive(Clone, Debug)]
pub struct Desired {
    /// The controller's models.
    pub models: GeneticModels,
    /// The force F_d, N.
    pub force: Valued,
    /// The roughness, um.
    pub ra_um: f64,
    air_n: f64,
}

impl Desired {
    /// For a target.
    #[must_use]
    pub fn new(target: &Target, models: GeneticModels) -> Self {
        let force = desired_force(target, &models);
        let ra_um = desired_ra(target, &models);
        Self { models, force, ra_um, air_n: AIR_FRACTION * force.value }
    }

    /// Force below which a tool that goes through cuts with air between them counts as in the air, N.
    #[must_use]
    #[inline]
    pub fn air_n(&self) -> f64 {
        self.air_n
    }
}
