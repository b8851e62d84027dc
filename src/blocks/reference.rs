//! The reference block: target roughness to desired force, F_d = K1(Ra_target) (2007 eq. 4),
//! computed once and again when the target moves.

use crate::base::model::Valued;
use crate::base::model::gp::GpModels;

crate::settings! {
    /// The target of the cut.
    pub struct Target {
        /// Target roughness Ra of the finished surface.
        ra_um: f64 = 0.81, [0.05, 4.0], "um", live, "Target Ra";
        /// Half-width of the tolerance band around the target, in percent of the target.
        tolerance_percent: f64 = 10.0, [1.0, 50.0], "%", live, "Tolerance";
    }
}

/// The force in N that the loop must hold for this target, by the controller's model.
#[must_use]
pub fn desired_force(target: &Target, belief: &GpModels) -> Valued {
    belief.force_from_ra(target.ra_um)
}
