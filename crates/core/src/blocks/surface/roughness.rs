//! Produced roughness: Ra = K5(F) without and Ra_dyn = K6(F_dyn) with the dynamic component of
//! the force; K5 and K6 are the same equation (2007 eq. 8), the exact inverse of K1.

use crate::base::math;
use crate::models::Valued;
use crate::models::genetic::GeneticModels;

/// Produced Ra without and with machine dynamics, um.
#[must_use]
#[inline]
pub fn produced(force_n: f64, force_dyn_n: f64, models: &GeneticModels) -> (Valued, Valued) {
    (models.ra_from_force(force_n), models.ra_from_force(force_dyn_n))
}

/// Ra with machine dynamics from Ra = K5(F) and what the marks of the teeth add to it, um; never
/// below zero.
#[must_use]
#[inline]
pub fn with_marks(ra: Valued, added_um: f64) -> Valued {
    Valued::new(math::positive(ra.value + added_um), ra.valid)
}
