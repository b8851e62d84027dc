//! What a drive reaches at rest over what it is asked for, as a formula of a user's own: the papers' transfer functions
//! have a gain of 1 there, a worn or badly tuned drive has not. The controllers' models of a drive know nothing of it.

use std::sync::Arc;

use super::formula_model::{FormulaModel, FormulaRole, OwnFormula, role};
use crate::base::math;

role!(
    /// Feed reached at rest over the feed that is asked for.
    FeedReached, "formula_feed_drive", &["mm/min"], "the feed asked for in mm/min", "mm/min",
    r#"{"version":1,"formula":"0.98*f - 2e-5*f^2","output":{"name":"fa","unit":"mm/min"},"inputs":[{"name":"f","unit":"mm/min","low":1,"high":1200}]}"#
);
role!(
    /// Speed reached at rest over the speed that is asked for.
    SpeedReached, "formula_spindle_drive", &["1/min"], "the speed asked for in 1/min", "1/min",
    r#"{"version":1,"formula":"n - 1e-5*n^2","output":{"name":"na","unit":"1/min"},"inputs":[{"name":"n","unit":"1/min","low":10,"high":5000}]}"#
);

/// The curve of a drive, with what it knows of the last command.
#[derive(Clone, Debug, PartialEq)]
pub struct DriveCurve {
    own: Option<Arc<FormulaModel>>,
    known: bool,
}

impl DriveCurve {
    /// The curve of a setting; without a formula what is asked for is reached.
    #[must_use]
    pub fn new<R: FormulaRole>(own: &OwnFormula<R>) -> Self {
        Self { own: own.get().cloned(), known: true }
    }

    /// What is reached at rest; never negative. A drive that is asked for nothing stands, whatever a formula says.
    #[inline]
    pub fn reached(&mut self, command: f64) -> f64 {
        let Some(own) = &self.own else { return command };
        if command == 0.0 {
            self.known = true;
            return 0.0;
        }
        let found = own.at(&[command]);
        self.known = found.valid && found.value >= 0.0;
        math::positive(found.value)
    }

    /// Whether the last command lay within the formula's range.
    #[must_use]
    #[inline]
    pub fn is_known(&self) -> bool {
        self.known
    }
}
