//! Where each model of a set holds: the range of its input.
//!
//! An end that the model does not have is infinite.

use std::sync::Arc;

use super::force_formula::{FEED_MIN_MM_MIN, SPEED_MIN_RPM};
use super::sdnrp_2007::{K2_MIN_N, K3_MAX_N, K5_MAX_N};
use super::strategy_2013::{FORCE_RANGE_N, RA_RANGE_UM};
use super::{
    FORCE_REF_MIN_N, FeedLaw, ForceRoughness, GeneticModels, M2_RESTORED_RANGE_N, SpeedLaw,
};
use crate::base::math;
use crate::models::formula_model::FormulaModel;

/// The range of an input of an own formula.
fn own_range(own: &Option<Arc<FormulaModel>>, input: usize) -> Option<[f64; 2]> {
    let range = own.as_ref()?.inputs().get(input)?.range;
    Some([range.low, range.high])
}

impl GeneticModels {
    /// Model 4: feed, mm/min, and speed, 1/min.
    #[must_use]
    pub fn cut_ranges(&self) -> [[f64; 2]; 2] {
        let least = [FEED_MIN_MM_MIN, SPEED_MIN_RPM];
        [0, 1]
            .map(|input| own_range(&self.own.force, input).unwrap_or([least[input], f64::INFINITY]))
    }

    /// Model 1: target roughness, um.
    #[must_use]
    pub fn ra_range_um(&self) -> [f64; 2] {
        if let Some(range) = own_range(&self.own.force_of_ra, 0) {
            return range;
        }
        match self.roughness {
            // 2007 eq. 4 solved for the Ra whose force is the least reference.
            ForceRoughness::K1K5 => {
                let root = 593.0 / (293.0 - FORCE_REF_MIN_N);
                [root * root / 39.37, f64::INFINITY]
            }
            ForceRoughness::M1M5 { .. } => RA_RANGE_UM,
            ForceRoughness::Curve(curve) => [curve.low, curve.high],
        }
    }

    /// Model 2: force that the controller asks for, N; none where the printed law has no fixed end
    /// (M2 holds where its feed is positive and rises).
    #[must_use]
    pub fn feed_range_n(&self) -> Option<[f64; 2]> {
        if let Some(range) = own_range(&self.own.feed, 0) {
            return Some(range);
        }
        match self.feed {
            FeedLaw::K2 => Some([K2_MIN_N, f64::INFINITY]),
            FeedLaw::M2 => None,
            FeedLaw::M2Restored(_) => Some(M2_RESTORED_RANGE_N),
            FeedLaw::Curve(curve) => Some([curve.low, curve.high]),
        }
    }

    /// Model 3: force that the controller asks for, N.
    #[must_use]
    pub fn speed_range_n(&self) -> [f64; 2] {
        if let Some(range) = own_range(&self.own.speed, 0) {
            return range;
        }
        match self.speed {
            SpeedLaw::K3 => [0.0, K3_MAX_N],
            SpeedLaw::Exponential(_, range) => range,
            SpeedLaw::Curve(curve) => [curve.low, curve.high],
        }
    }

    /// Models 5 and 6: force of the cut, N.
    #[must_use]
    pub fn roughness_range_n(&self) -> [f64; 2] {
        if let Some(range) = own_range(&self.own.ra, 0) {
            return range;
        }
        match self.roughness {
            ForceRoughness::K1K5 => [0.0, K5_MAX_N],
            // 2013 eq. 6 turns round where its slope is zero.
            ForceRoughness::M1M5 { leading } => {
                let [low, high] = FORCE_RANGE_N;
                [math::limit(0.0341 / (2.0 * leading), low, high), high]
            }
            ForceRoughness::Curve(curve) => [curve.low, curve.high].map(|ra| curve.at(ra).value),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Calibration, ModelSet};
    use super::*;

    #[test]
    fn a_model_is_marked_exactly_outside_its_range() {
        let sets = ModelSet::ALL.iter();
        for (set, calibration) in
            sets.flat_map(|set| Calibration::ALL.iter().map(|calibration| (*set, *calibration)))
        {
            let models = GeneticModels::new(set, calibration);
            let agree = |name: &str, x: f64, [low, high]: [f64; 2], valid: bool| {
                // At an end itself rounding decides.
                let at_an_end = (x - low).abs() < 1e-6 || (x - high).abs() < 1e-6;
                let inside = x >= low && x <= high;
                assert!(at_an_end || inside == valid, "{set:?} {calibration:?} {name} at {x}");
            };
            for i in 1..400 {
                let (ra_um, force_n) = (f64::from(i) * 0.01, f64::from(i));
                agree("1", ra_um, models.ra_range_um(), models.force_from_ra(ra_um).valid);
                if let Some(range) = models.feed_range_n() {
                    agree("2", force_n, range, models.feed_from_force(force_n).valid);
                }
                agree("3", force_n, models.speed_range_n(), models.speed_from_force(force_n).valid);
                let range = models.roughness_range_n();
                agree("5", force_n, range, models.ra_from_force(force_n).valid);
            }
        }
    }
}
