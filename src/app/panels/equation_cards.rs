//! Equation cards: what each box of the block diagram computes, as a table, and the same
//! equations with the values of the moment put in. No number here is a result: all come from the
//! models, the scenario and the recorded row.
//!
//! Formulas are plain text; `_d` or `_{dyn}` marks a subscript and `^2` a superscript.

pub mod formula;
mod live;
mod models;

pub use live::{Live, Moment, live};

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

/// An equation as its source prints it.
#[derive(Clone, Copy, Debug)]
pub struct Printed {
    /// The formula.
    pub formula: &'static str,
    /// Paper and equation number, or why there is none.
    pub source: &'static str,
}

/// A lamp: lit while a flag of the row is set.
#[derive(Clone, Copy, Debug)]
pub struct Lamp {
    /// Bit of the row's state flags.
    pub bit: u32,
    /// Short name beside the lamp.
    pub label: &'static str,
}

/// What a box computes.
#[derive(Clone, Copy, Debug)]
pub struct Card {
    /// The box.
    pub block: Block,
    /// Its name.
    pub title: &'static str,
    /// What it is for, in words.
    pub meaning: &'static str,
    /// Its equations as printed.
    pub printed: &'static [Printed],
    /// Ids of the signals that enter or leave it.
    pub signals: &'static [&'static str],
    /// Its lamps.
    pub lamps: &'static [Lamp],
}

const EQ_8: Printed =
    Printed { formula: "Ra = 0.0254 (593 / (293 - F))^2", source: "SDNRP 2007, eq. 8" };

/// All cards, in the order of [`Block`].
pub const CARDS: &[Card] = &[
    Card {
        block: Block::Reference,
        title: "Reference K1",
        meaning: "Turns the target roughness into the cutting force that leaves it. The loop \
                  then holds this force: a constant force keeps the finish constant.",
        printed: &[Printed {
            formula: "F_d = 293 - 593 / √(39.37 Ra)",
            source: "SDNRP 2007, eq. 4",
        }],
        signals: &["ra_target_um", "force_ref_n"],
        lamps: &[Lamp { bit: flag::K1_OUTSIDE, label: "K1" }],
    },
    Card {
        block: Block::Controller,
        title: "Controller K2, K3",
        meaning: "Compares the measured force with the desired one every control period and \
                  asks for feed and spindle speed. The models it computes with are its belief: \
                  they need not be those of the cut.",
        printed: &[
            Printed {
                formula: "F_s = F_d + Kp (F_d - F_m)",
                source: "SDNRP 2007, figures lost: the reading that fits text and Table 3",
            },
            Printed { formula: "f_c = 25.4 (189 - 5926160 / F_s^2)", source: "SDNRP 2007, eq. 5" },
            Printed { formula: "n_c = √(30064193 - 2.28 F_s^3)", source: "SDNRP 2007, eq. 6" },
        ],
        signals: &[
            "force_ref_n",
            "force_measured_n",
            "force_setpoint_n",
            "gain_estimate",
            "feed_override_percent",
            "spindle_override_percent",
        ],
        lamps: &[
            Lamp { bit: flag::K2_OUTSIDE, label: "K2" },
            Lamp { bit: flag::K3_OUTSIDE, label: "K3" },
        ],
    },
    Card {
        block: Block::Override,
        title: "Override limits",
        meaning: "The CNC takes commands as percent of the programmed feed and speed, within \
                  limits. What the controller asks beyond them is cut off; the lamp shows it.",
        printed: &[Printed {
            formula: "f_c = DNCFRO · f_p,  n_c = DNCSPO · n_p,  0..250 %",
            source: "Control strategy 2013, section 2",
        }],
        signals: &[
            "feed_override_percent",
            "spindle_override_percent",
            "feed_command_mm_min",
            "spindle_command_rpm",
        ],
        lamps: &[
            Lamp { bit: flag::FEED_SATURATED, label: "feed" },
            Lamp { bit: flag::SPEED_SATURATED, label: "speed" },
        ],
    },
    Card {
        block: Block::DeadTime,
        title: "Dead time",
        meaning: "The PLC of the machine passes every command on after a fixed time. Each dot \
                  is one command under way; its height shows its size against the others.",
        printed: &[Printed {
            formula: "e^{-0.08 s}",
            source: "SDNRP 2007, eq. 1 to 3 (the text's \"t = 8 s\" is a misprint)",
        }],
        signals: &["feed_command_mm_min", "spindle_command_rpm"],
        lamps: &[],
    },
    Card {
        block: Block::FeedDrive,
        title: "Feed drive",
        meaning: "The servo system follows the command with the lag of its transfer function, \
                  computed exactly at every step.",
        printed: &[Printed {
            formula: "f_a / f_c = 14.0 e^{-0.08 s} / (s + 14.0)",
            source: "SDNRP 2007, eq. 3: the drive that the paper simulates with",
        }],
        signals: &["feed_command_mm_min", "feed_mm_min"],
        lamps: &[],
    },
    Card {
        block: Block::SpindleDrive,
        title: "Spindle drive",
        meaning: "The spindle follows its command as a first-order lag that cannot change speed \
                  faster than its rate limit.",
        printed: &[Printed {
            formula: "n_a' = limit((n_c - n_a) / τ, ± rate)",
            source: "chosen: no paper gives a spindle drive",
        }],
        signals: &["spindle_command_rpm", "spindle_rpm"],
        lamps: &[],
    },
    Card {
        block: Block::Cutting,
        title: "Cutting process K4",
        meaning: "The true cut: maximum cutting force from feed and speed, times what K4 does \
                  not know: material and hardness, cross-section of the cut, tool wear.",
        printed: &[Printed {
            formula: "F = 286.44 - 5.82·10^{-10} n^3 - 8973 ln(0.039 f) / f",
            source: "SDNRP 2007, eq. 7 (Ck45, A_D 2 mm, R_D 3 mm, sharp tool)",
        }],
        signals: &["feed_mm_min", "spindle_rpm", "axial_depth_mm", "force_n"],
        lamps: &[
            Lamp { bit: flag::K4_OUTSIDE, label: "K4" },
            Lamp { bit: flag::AIR, label: "air" },
        ],
    },
    Card {
        block: Block::Dynamic,
        title: "Dynamic component",
        meaning: "What a real force adds to the model: band-limited noise, the ripple of the \
                  teeth, slow changes of the material along the path; each with its own seeded \
                  stream.",
        printed: &[Printed {
            formula: "F_{dyn} = F (1 + level (b(t) + ripple sin θ + w(x)))",
            source: "SDNRP 2007, Fig. 10 (lost): random, sized like measured oscillations; \
                     form chosen",
        }],
        signals: &["force_n", "force_dyn_n"],
        lamps: &[],
    },
    Card {
        block: Block::Dynamometer,
        title: "Dynamometer",
        meaning: "The force sensor: reads the dynamic force once per control period and adds \
                  its own noise. The controller sees only this.",
        printed: &[Printed {
            formula: "F_m = F_{dyn} + sensor noise",
            source: "SDNRP 2007, section 1: Kistler force transducer; noise chosen",
        }],
        signals: &["force_dyn_n", "force_measured_n"],
        lamps: &[],
    },
    Card {
        block: Block::Surface,
        title: "Surface K5",
        meaning: "The roughness that the force leaves on the part, without machine dynamics: \
                  the inverse of K1.",
        printed: &[EQ_8],
        signals: &["force_n", "ra_um", "ra_target_um"],
        lamps: &[Lamp { bit: flag::K5_OUTSIDE, label: "K5" }],
    },
    Card {
        block: Block::SurfaceDynamic,
        title: "Surface K6",
        meaning: "The roughness with machine dynamics: the equation of K5, fed with the force \
                  and its dynamic component.",
        printed: &[EQ_8],
        signals: &["force_dyn_n", "ra_dyn_um", "ra_target_um"],
        lamps: &[Lamp { bit: flag::K6_OUTSIDE, label: "K6" }],
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
            assert_eq!(card.block as usize, i, "{}", card.title);
            assert!(card.signals.iter().all(|id| signal(id).is_some()), "{}", card.title);
        }
    }

    #[test]
    fn every_flag_has_its_lamp() {
        let lamps = || CARDS.iter().flat_map(|card| card.lamps);
        for flag in FLAGS {
            assert_eq!(lamps().filter(|lamp| lamp.bit == flag.bit).count(), 1, "{}", flag.label);
        }
    }
}
