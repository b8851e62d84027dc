//! Where in the running cut the formula can stand, worked out again only when formula or scenario change.

use crate::app::session::Session;
use crate::base::settings::Value;
use crate::models::formula_model::FormulaModel;
use crate::study::formula_place::FormulaPlace;

/// A place, with the settings that put the formula there or the reason against it.
pub type Fit = (FormulaPlace, Result<Vec<(String, Value)>, String>);

/// See the head of this file.
#[derive(Default)]
pub struct Places {
    /// The model, the count of changes of the scenario, and what fits.
    known: Option<(FormulaModel, u64, Vec<Fit>)>,
}

impl Places {
    /// All places.
    pub fn of(&mut self, model: &FormulaModel, session: &Session) -> &[Fit] {
        let changes = session.changes();
        if self.known.as_ref().is_none_or(|(known, at, _)| known != model || *at != changes) {
            let fit = |place: &FormulaPlace| (*place, place.settings(model, session.scenario()));
            let all = FormulaPlace::ALL.iter().map(fit).collect();
            self.known = Some((model.clone(), changes, all));
        }
        self.known.as_ref().map_or(&[], |(_, _, all)| all)
    }
}
