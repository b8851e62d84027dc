//! Settings that bring a companion with them, unless it is set together with them: a table, one row a
//! companion.

use super::groups::Settings;
use super::table::param;
use crate::models::genetic::ModelSet;
use crate::models::tool::Tool;

/// A setting that brings another one with it.
pub struct Companion {
    /// The setting that is chosen.
    pub of: &'static str,
    /// What comes with it.
    pub brings: &'static str,
    /// In words.
    pub words: &'static str,
    /// Sets what comes with it.
    set: fn(&mut Settings),
}

/// All companions.
pub const COMPANIONS: &[Companion] = &[
    Companion {
        of: "tool.name",
        brings: "tool.diameter_mm",
        words: "a cutter comes with all other settings of its group",
        set: |s| {
            s.tool = Tool { name: s.tool.name, ..s.tool.name.load().tool };
        },
    },
    Companion {
        of: "plant.model_set",
        brings: "belief.model_set",
        words: "the controller has the models that were built for the plant's",
        set: |s| s.belief.model_set = s.plant.model_set,
    },
    Companion {
        of: "plant.force_model",
        brings: "belief.model_set",
        words: "tooth by tooth the controller has the models identified on it: the papers' formulas \
                know nothing of the milling simulator's cut",
        set: |s| match s.plant.force_model.identified_set() {
            Some(set) => s.belief.model_set = set,
            None if s.belief.model_set == ModelSet::Milling2005 => {
                s.belief.model_set = s.plant.model_set;
            }
            None => {}
        },
    },
    Companion {
        of: "plant.material",
        brings: "plant.hardness_hb",
        words: "a material comes with its hardness",
        set: |s| s.plant.hardness_hb = s.plant.material.hardness_hb(),
    },
    Companion {
        of: "feed_drive.kind",
        brings: "cnc.dead_time_s",
        words: "a feed drive comes with the dead time published with it",
        set: |s| s.cnc.dead_time_s = s.feed_drive.kind.published_dead_time_s(),
    },
];

/// The companion that the setting at `path` brings.
pub(in crate::run) fn companion(path: &str) -> Option<&'static Companion> {
    COMPANIONS.iter().find(|companion| companion.of == path)
}

impl Settings {
    /// The choices of these settings, all else at its default, companions included: what a link
    /// leaves out.
    pub(in crate::run) fn default_for_choices(&self) -> Self {
        let mut base = Self::default();
        for companion in COMPANIONS {
            let param = param(companion.of).expect("a known path");
            let value = self.get_param(param);
            if base.get_param(param) != value {
                // Rules between settings do not matter to a base.
                base.set_param(param, &value).expect("it is allowed here, so it is there");
                (companion.set)(&mut base);
            }
        }
        base
    }

    /// Sets what the setting at `path` brings with it.
    pub(super) fn set_companion(&mut self, path: &str) {
        if let Some(companion) = companion(path) {
            (companion.set)(self);
        }
    }
}
