//! Settings that bring a companion with them: a material its hardness, a feed drive its published
//! dead time, a model of the plant the controller's model that was built for it.

use super::groups::Settings;
use super::table::param;
use crate::models::genetic::ModelSet;

/// Settings that bring a companion with them.
pub(in crate::run) const COMPANIONED: [&str; 4] =
    ["plant.model_set", "plant.force_model", "plant.material", "feed_drive.kind"];
/// Their companions, in the same order.
pub(in crate::run) const COMPANIONS: [&str; 4] =
    ["belief.model_set", "belief.model_set", "plant.hardness_hb", "cnc.dead_time_s"];

impl Settings {
    /// The choices of these settings, all else at its default, companions included: what a link
    /// leaves out.
    pub(in crate::run) fn default_for_choices(&self) -> Self {
        let mut base = Self::default();
        for path in COMPANIONED {
            let param = param(path).expect("a known path");
            let value = self.get_param(param);
            if base.get_param(param) != value {
                // Rules between settings do not matter to a base.
                base.set_param(param, &value).expect("it is allowed here, so it is there");
                base.set_companion(path);
            }
        }
        base
    }

    /// A material comes with its hardness, a feed drive with its published dead time, a model set
    /// with the controller that was built for it.
    pub(super) fn set_companion(&mut self, path: &str) {
        match path {
            "plant.model_set" => self.belief.model_set = self.plant.model_set,
            // The papers' formulas know nothing of the milling simulator's cut.
            "plant.force_model" => match self.plant.force_model.identified_set() {
                Some(set) => self.belief.model_set = set,
                None if self.belief.model_set == ModelSet::Milling2005 => {
                    self.belief.model_set = self.plant.model_set;
                }
                None => {}
            },
            "plant.material" => self.plant.hardness_hb = self.plant.material.hardness_hb(),
            "feed_drive.kind" => {
                self.cnc.dead_time_s = self.feed_drive.kind.published_dead_time_s();
            }
            _ => {}
        }
    }
}
