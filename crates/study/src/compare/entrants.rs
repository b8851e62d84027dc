//! The entrants of a comparison.

use crate::base::language::text;
use crate::blocks::control::ControllerKind;
use crate::blocks::control::mrac::Adapted;
use crate::run::presets;
use crate::run::scenario::{Scenario, Settings};

/// One entrant: a name and the scenario that it runs, whatever it changes. Seed and recording are
/// the tournament's.
#[derive(Clone, Debug, PartialEq)]
pub struct Entrant {
    /// Its name in tables.
    pub name: String,
    /// What it runs.
    pub scenario: Scenario,
}

/// A way of control: its name, and what it changes in any scenario.
#[derive(Clone, Copy, Debug)]
pub struct Method {
    /// Its id in reports.
    pub id: &'static str,
    /// Its name in tables.
    pub name: &'static str,
    /// Makes settings its own.
    pub apply: fn(&mut Settings),
}

impl Method {
    /// The entrant that runs `base` this way.
    ///
    /// # Panics
    /// Never: no rule joins a controller's settings with others.
    #[must_use]
    pub fn on(&self, base: &Scenario) -> Entrant {
        let scenario = base.with(self.apply).expect("a controller goes with any scenario");
        Entrant { name: self.name.to_owned(), scenario }
    }
}

/// The six methods in the order of Table 1, as shipped.
pub const TABLE_1: [Method; 6] = [
    Method {
        id: "conventional",
        name: text!("Conventional"),
        apply: |s| s.controller.kind = ControllerKind::ConstantFeed,
    },
    Method {
        id: "division",
        name: text!("Division"),
        apply: |s| s.controller.kind = ControllerKind::Division,
    },
    Method {
        id: "proportional",
        name: "P",
        apply: |s| s.controller.kind = ControllerKind::Proportional,
    },
    Method {
        id: "adjustable_pi",
        name: text!("Adjustable PI"),
        apply: |s| s.controller.kind = ControllerKind::AdjustablePi,
    },
    Method { id: "mrac", name: "MRAC", apply: |s| s.controller.kind = ControllerKind::Mrac },
    Method { id: "unks", name: "UNKS", apply: |s| s.controller.kind = ControllerKind::Unks },
];

/// What Table 1 does not have: an entry each. The robustness table takes the first one.
pub const BEYOND: &[Method] = &[
    Method {
        id: "proportional_smith",
        name: text!("P, Smith predictor"),
        apply: |s| {
            s.controller.kind = ControllerKind::Proportional;
            (s.controller.proportional.kp, s.controller.proportional.smith) = (1.6, true);
        },
    },
    Method {
        id: "mrac_one_gain",
        name: text!("MRAC, one gain"),
        apply: |s| {
            s.controller.kind = ControllerKind::Mrac;
            s.controller.mrac.adapted = Adapted::Gain;
        },
    },
    Method {
        id: "preview",
        name: text!("Preview"),
        apply: |s| s.controller.kind = ControllerKind::Preview,
    },
];

/// The controllers of the papers of 2007 and 2013, which set feed and speed by what Ra wants; Table 1 of
/// 2005 does not know them.
pub const ROUGHNESS: &[Method] = &[
    Method { id: "sdnrp", name: "SDNRP", apply: |s| s.controller.kind = ControllerKind::Sdnrp },
    Method {
        id: "tracking",
        name: text!("Tracking"),
        apply: |s| s.controller.kind = ControllerKind::Tracking,
    },
];

/// What the control of a machine tool offers. Its references are those of the scenario; without them AFC is
/// taught in, and cuts as conventional milling does.
pub const SHOP: &[Method] =
    &[Method { id: "afc", name: "AFC", apply: |s| s.controller.kind = ControllerKind::Afc }];

/// A script of the user's own, which stands in the scenario: it takes part where the scenario brings one.
pub const OWN: &[Method] = &[Method {
    id: "script",
    name: text!("Own script"),
    apply: |s| s.controller.kind = ControllerKind::Script,
}];

/// Every way of control that the program brings, in the order of tables.
pub fn methods() -> impl Iterator<Item = &'static Method> {
    TABLE_1.iter().chain(BEYOND).chain(ROUGHNESS).chain(SHOP)
}

/// The same, and a script of one's own after them.
pub fn methods_and_own() -> impl Iterator<Item = &'static Method> {
    methods().chain(OWN)
}

/// Sets a dead time in s that the controllers know.
pub fn set_dead_time(settings: &mut Settings, dead_time_s: f64) {
    (settings.cnc.dead_time_s, settings.belief.dead_time_s) = (dead_time_s, dead_time_s);
}

/// Every method on a scenario.
#[must_use]
pub fn on(base: &Scenario, methods: &[Method]) -> Vec<Entrant> {
    methods.iter().map(|method| method.on(base)).collect()
}

/// Experiment 2 with a programmed feed for every cut, as the plan finds them for the lightest sections.
///
/// # Panics
/// Never: a test loads every preset.
#[must_use]
pub fn experiment_2_per_cut() -> Scenario {
    presets::load("experiment-2-per-cut").expect("presets are tested")
}

/// Experiment 2 of 2005, the part of Table 1.
///
/// # Panics
/// Never: a test loads every preset.
#[must_use]
pub fn experiment_2() -> Scenario {
    presets::load("experiment-2").expect("presets are tested")
}
