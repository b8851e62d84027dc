//! The survivors: for each size of formula the best few, unlike each other. What is large survives beside
//! what is small, so that good parts of both stay.

use serde::{Deserialize, Serialize};

use super::node::Sum;

/// Formulas kept of one size on an island.
const PER_SIZE: usize = 5;
/// Least share by which the error must fall for a larger formula to be on the front.
const WORTH: f64 = 0.999;

/// A fitted formula.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct FittedSum {
    /// The formula.
    pub sum: Sum,
    /// Its size, nodes.
    pub size: usize,
    /// Sum of the squares of its residuals.
    pub left: f64,
    /// Estimated error of prediction, in the target's unit.
    pub error: f64,
}

/// The survivors of one island, by size.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Archive {
    sizes: Vec<Vec<FittedSum>>,
}

impl Archive {
    /// Error below which a formula of this size survives.
    #[must_use]
    pub fn goal(&self, size: usize) -> f64 {
        match self.sizes.get(size) {
            Some(kept) if kept.len() >= PER_SIZE => {
                kept.last().map_or(f64::INFINITY, |last| last.error)
            }
            _ => f64::INFINITY,
        }
    }

    /// The formula of a size with the least error.
    #[must_use]
    pub fn best(&self, size: usize) -> Option<&FittedSum> {
        self.sizes.get(size)?.first()
    }

    /// The formulas of a size, the best first.
    #[must_use]
    pub fn of_size(&self, size: usize) -> &[FittedSum] {
        self.sizes.get(size).map_or(&[], Vec::as_slice)
    }

    /// One more than the largest size.
    #[must_use]
    pub fn sizes(&self) -> usize {
        self.sizes.len()
    }

    /// Takes a formula in where it is among the best of its size and unlike the others.
    pub fn admit(&mut self, candidate: FittedSum) {
        if !candidate.error.is_finite() {
            return;
        }
        if self.sizes.len() <= candidate.size {
            self.sizes.resize(candidate.size + 1, Vec::new());
        }
        let kept = &mut self.sizes[candidate.size];
        let shape = candidate.sum.shape();
        let alike = |other: &FittedSum| {
            other.sum.shape() == shape
                || (other.error - candidate.error).abs() <= 1e-9 * candidate.error
        };
        if let Some(at) = kept.iter().position(alike) {
            if kept[at].error <= candidate.error {
                return;
            }
            kept.remove(at);
        }
        let at = kept.partition_point(|other| other.error <= candidate.error);
        kept.insert(at, candidate);
        kept.truncate(PER_SIZE);
    }

    /// The front: formulas than which no smaller one is as good, the smallest first.
    #[must_use]
    pub fn front(&self) -> Vec<&FittedSum> {
        let mut least = f64::INFINITY;
        let bests = self.sizes.iter().filter_map(|kept| kept.first());
        bests
            .filter(|best| {
                let better = best.error < WORTH * least;
                if better {
                    least = best.error;
                }
                better
            })
            .collect()
    }

    /// All formulas, the smallest first.
    pub fn all(&self) -> impl Iterator<Item = &FittedSum> {
        self.sizes.iter().flatten()
    }

    /// Whether all its formulas read inputs below `inputs` only, and are whole.
    #[must_use]
    pub fn is_sound(&self, inputs: usize) -> bool {
        self.all().all(|candidate| candidate.sum.is_sound(inputs))
    }

    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.all().next().is_none()
    }
}
