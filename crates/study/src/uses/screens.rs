//! Which screen offers which setting, and when it greys it.

use super::{Reader, named};
use crate::base::language::tr;
use crate::run::scenario::{Param, Scenario};

steadycut_core::choice! {
    /// A screen of the console, or a window of it, that offers settings.
    pub enum Screen {
        /// The running cut: every setting.
        Console = "console", "Console";
        /// The machined surface and what measures it.
        Workpiece = "workpiece", "Workpiece";
        /// The off-line plan.
        Plan = "plan", "Plan";
        /// The machine, its stability and its tool's life.
        Machine = "machine", "Machine";
        /// The window of the networks that learn.
        Learning = "learning", "Learning";
        /// The search, from any screen: every setting.
        Find = "find", "Find";
    }
}

impl Screen {
    /// Whose use of a setting counts there.
    #[must_use]
    pub fn readers(self) -> &'static [Reader] {
        match self {
            Self::Console => &[Reader::RunTwin, Reader::Run],
            Self::Workpiece => &[Reader::RunProfile],
            Self::Plan => &[Reader::Plan],
            Self::Machine => &[
                Reader::MachineStability,
                Reader::MachineFrf,
                Reader::MachineWear,
                Reader::MachineLife,
                Reader::Run,
            ],
            Self::Learning => &[Reader::Unks, Reader::Run],
            Self::Find => &[
                Reader::RunTwin,
                Reader::Run,
                Reader::RunProfile,
                Reader::Plan,
                Reader::MachineStability,
                Reader::MachineFrf,
                Reader::MachineWear,
                Reader::MachineLife,
                Reader::Unks,
            ],
        }
    }

    /// Whether it offers a setting.
    #[must_use]
    pub fn offers(self, Param { path, group, .. }: &Param) -> bool {
        match self {
            Self::Console | Self::Find => true,
            Self::Workpiece => ["profile.long_mm", "profile.short_um"].contains(&path.as_str()),
            Self::Plan => *group == "plan" || named(PLAN_OFFERS, path),
            Self::Machine => ["machine", "wear", "life"].contains(group),
            Self::Learning => named(LEARNING_OFFERS, path),
        }
    }

    /// Why a setting is greyed there, in the chosen language; none where it can be changed.
    #[must_use]
    pub fn greyed(self, scenario: &Scenario, path: &str) -> Option<String> {
        let mut first = None;
        for reader in self.readers() {
            match reader.unused(scenario, path) {
                Ok(None) | Err(_) => return None,
                Ok(Some(because)) => first = first.or(Some(because)),
            }
        }
        first.map(|because| tr(&because).to_owned())
    }
}

/// What the screen of the plan offers besides the plan's own.
pub const PLAN_OFFERS: &[&str] = &[
    "target.ra_um",
    "target.force_n",
    "workpiece.axial_depth_mm",
    "workpiece.radial_depth_mm",
    "workpiece.length_mm",
    "workpiece.depth_steps",
    "workpiece.radial_steps",
    "plant.material",
    "plant.hardness_hb",
    "plant.wear_factor",
];

/// What the window of the networks offers.
pub const LEARNING_OFFERS: &[&str] = &[
    "controller.unks.forward_rate",
    "controller.unks.inverse_rate",
    "controller.unks.cold_rate",
    "controller.unks.first_weights",
];
