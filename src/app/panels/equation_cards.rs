//! Equation cards: what each box of the block diagram computes, as a table, and the same
//! equations with the values of the moment put in. No number here is a result: all come from the
//! models, the scenario and the recorded row.
//!
//! Formulas are plain text; `_d` or `_{dyn}` marks a subscript and `^2` a superscript.

mod control;
mod cutting;
pub mod formula;
mod laws;
mod live;
mod machine;
mod models;
mod names;
mod neural;
mod overrides;
mod printed;

pub use live::{Live, Moment, live};
pub use names::Names;
pub use printed::Printed;

use crate::run::signals::flag;

/// A box of the block diagram, in signal order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Block {
    /// Target roughness to desired force.
    Reference,
    /// Forces to feed and speed commands.
    Controller,
    /// Limits of the commands.
    Override,
    /// The PLC's queue.
    DeadTime,
    /// Feed command to feed.
    FeedDrive,
    /// Speed command to speed.
    SpindleDrive,
    /// Feed and speed to force.
    Cutting,
    /// The random component of the force.
    Dynamic,
    /// The force sensor.
    Dynamometer,
    /// Force to roughness.
    Surface,
    /// Force with dynamics to roughness.
    SurfaceDynamic,
}

/// A lamp: lit while a flag of the row is set.
#[derive(Clone, Copy, Debug)]
pub struct Lamp {
    /// Bits of the row's state flags.
    pub bits: u32,
    /// Short name beside the lamp; that of a model begins with K, whatever the set.
    label: &'static str,
}

/// What a box is about; what it computes stands in its equations.
#[derive(Clone, Copy, Debug)]
pub struct Card {
    /// The box.
    pub block: Block,
    /// Its name, without that of its models.
    name: &'static str,
    /// Numbers of the models that it computes with.
    models: &'static [u32],
    /// What it is for, in words.
    pub meaning: &'static str,
    /// Ids of the signals that enter or leave it.
    pub signals: &'static [&'static str],
    /// Its lamps.
    pub lamps: &'static [Lamp],
}

const fn lamp(bits: u32, label: &'static str) -> Lamp {
    Lamp { bits, label }
}

/// All cards, in the order of [`Block`].
pub const CARDS: &[Card] = &[
    Card {
        block: Block::Reference,
        name: "Reference",
        models: &[1],
        meaning: "Turns the target roughness into the cutting force that leaves it. The loop \
                  then holds this force: a constant force keeps the finish constant.",
        signals: &["ra_target_um", "force_ref_n"],
        lamps: &[lamp(flag::K1_OUTSIDE, "K1")],
    },
    Card {
        block: Block::Controller,
        name: "Controller",
        models: &[2, 3],
        meaning: "Compares the measured force with the desired one every control period and \
                  asks for feed and spindle speed. The models it computes with are its belief: \
                  they need not be those of the cut.",
        signals: &[
            "force_ref_n",
            "force_measured_n",
            "force_setpoint_n",
            "gain_estimate",
            "feed_override_percent",
            "spindle_override_percent",
        ],
        lamps: &[lamp(flag::K2_OUTSIDE, "K2"), lamp(flag::K3_OUTSIDE, "K3")],
    },
    Card {
        block: Block::Override,
        name: "Override limits",
        models: &[],
        meaning: "The CNC takes commands as percent of the programmed feed (DNCFRO) and speed \
                  (DNCSPO), within limits. What the controller asks beyond them is cut off; the \
                  lamp shows it. A real CNC takes whole percents and moves to a new override at \
                  a rate: both can be switched on.",
        signals: &[
            "feed_override_percent",
            "spindle_override_percent",
            "feed_command_mm_min",
            "spindle_command_rpm",
        ],
        lamps: &[
            lamp(flag::FEED_SATURATED, "feed"),
            lamp(flag::SPEED_SATURATED, "speed"),
            lamp(flag::RATE_LIMITED, "rate"),
        ],
    },
    Card {
        block: Block::DeadTime,
        name: "Dead time",
        models: &[],
        meaning: "The PLC of the machine passes every command on after a fixed time. Each dot \
                  is one command under way; its height shows its size against the others.",
        signals: &["feed_command_mm_min", "spindle_command_rpm"],
        lamps: &[],
    },
    Card {
        block: Block::FeedDrive,
        name: "Feed drive",
        models: &[],
        meaning: "The servo system follows the command with the lag of its transfer function, \
                  computed exactly at every step.",
        signals: &["feed_command_mm_min", "feed_mm_min"],
        lamps: &[],
    },
    Card {
        block: Block::SpindleDrive,
        name: "Spindle drive",
        models: &[],
        meaning: "The spindle follows its command as a first-order lag that cannot change speed \
                  faster than its rate limit.",
        signals: &["spindle_command_rpm", "spindle_rpm"],
        lamps: &[],
    },
    Card {
        block: Block::Cutting,
        name: "Cutting process",
        models: &[4],
        meaning: "The true cut: maximum cutting force from feed and speed, times what the model \
                  does not know: material and hardness, cross-section of the cut, tool wear.",
        signals: &["feed_mm_min", "spindle_rpm", "axial_depth_mm", "force_n"],
        lamps: &[lamp(flag::K4_OUTSIDE, "K4"), lamp(flag::AIR, "air")],
    },
    Card {
        block: Block::Dynamic,
        name: "Dynamic component",
        models: &[],
        meaning: "What a real force adds to the model: band-limited noise, the ripple of the \
                  teeth, slow changes of the material along the path; each with its own seeded \
                  stream.",
        signals: &["force_n", "force_dyn_n"],
        lamps: &[lamp(flag::LOST_CONTACT, "contact")],
    },
    Card {
        block: Block::Dynamometer,
        name: "Dynamometer",
        models: &[],
        meaning: "The force sensor: reads the dynamic force once per control period and adds \
                  its own noise. The controller sees only this.",
        signals: &["force_dyn_n", "force_measured_n"],
        lamps: &[],
    },
    Card {
        block: Block::Surface,
        name: "Surface",
        models: &[5],
        meaning: "The roughness that the force leaves on the part, without machine dynamics. \
                  Identified models invert that of the reference exactly, so that a force held \
                  at its desired value leaves the desired roughness.",
        signals: &["force_n", "ra_um", "ra_target_um"],
        lamps: &[lamp(flag::K5_OUTSIDE, "K5")],
    },
    Card {
        block: Block::SurfaceDynamic,
        name: "Surface",
        models: &[6],
        meaning: "The roughness with machine dynamics: the same equation, fed with the force and \
                  its dynamic component.",
        signals: &["force_dyn_n", "ra_dyn_um", "ra_target_um"],
        lamps: &[lamp(flag::K6_OUTSIDE, "K6")],
    },
];

impl Block {
    /// Its card.
    #[must_use]
    pub fn card(self) -> &'static Card {
        &CARDS[self as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::run::signals::{FLAGS, signal};

    #[test]
    fn cards_stand_in_the_order_of_the_blocks_and_name_known_signals() {
        for (i, card) in CARDS.iter().enumerate() {
            assert_eq!(card.block as usize, i, "{}", card.name);
            assert!(card.signals.iter().all(|id| signal(id).is_some()), "{}", card.name);
        }
    }

    #[test]
    fn every_flag_has_its_lamp() {
        let lamps = || CARDS.iter().flat_map(|card| card.lamps);
        for flag in FLAGS {
            let count = lamps().filter(|lamp| lamp.bits & flag.bit != 0).count();
            assert_eq!(count, 1, "{}", flag.label);
        }
    }
}
