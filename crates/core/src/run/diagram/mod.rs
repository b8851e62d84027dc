//! The block diagram as data: what each box of the loop is, what runs on each wire, which equation
//! and settings stand behind it. The one description: the console's picture and its equation cards,
//! `steadycut list --diagram` and the figure of this crate's documentation are made from it, and its
//! wires carry signals of the [table](super::signals).

mod names;
mod printed;
pub mod text;
pub mod wires;

pub use names::{Names, Using};
pub use wires::{WIRES, Wire};

use super::scenario::{Scenario, table};
use super::signals::flag;
use crate::base::language::text;
use crate::blocks::control::law::Held;

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

/// What a box is about. What enters and leaves it stands in [`WIRES`], what it computes in
/// [`Block::printed`].
#[derive(Clone, Copy, Debug)]
pub struct BlockInfo {
    /// The box.
    pub block: Block,
    /// Its name in JSON.
    pub id: &'static str,
    /// Its name, without that of its models.
    name: &'static str,
    /// Numbers of the models that it computes with.
    models: &'static [u32],
    /// What it is for, in words.
    pub meaning: &'static str,
    /// Ids of signals that it computes or compares with beside those on its wires.
    pub own: &'static [&'static str],
    /// The same where the machine is coupled.
    pub of_machine: &'static [&'static str],
    /// Paths of the settings that it shows.
    pub settings: &'static [&'static str],
    /// Its lamps.
    pub lamps: &'static [Lamp],
}

/// Signals of the table that belong to no box: where and when a row was recorded, and the lamps.
pub const OF_THE_ROW: [&str; 3] = ["time_s", "position_mm", "state_flags"];

const fn lamp(bits: u32, label: &'static str) -> Lamp {
    Lamp { bits, label }
}

/// All boxes, in the order of [`Block`].
pub const BLOCKS: &[BlockInfo] = &[
    BlockInfo {
        block: Block::Reference,
        id: "reference",
        name: text!("Reference"),
        models: &[1],
        meaning: text!(
            "Turns the target roughness into the cutting force that leaves it. The loop \
                  then holds this force: a constant force keeps the finish constant."
        ),
        own: &[],
        of_machine: &[],
        settings: &["belief.model_set", "belief.calibration", "formula.force_of_ra"],
        lamps: &[lamp(flag::K1_OUTSIDE, "K1")],
    },
    BlockInfo {
        block: Block::Controller,
        id: "controller",
        name: text!("Controller"),
        models: &[2, 3],
        meaning: text!(
            "Compares the measured force with the desired one every control period and \
                  asks for feed and spindle speed. The models it computes with are its belief: \
                  they need not be those of the cut."
        ),
        own: &["force_setpoint_n", "gain_estimate"],
        of_machine: &[],
        settings: &["controller.kind", "formula.feed", "formula.speed"],
        lamps: &[
            lamp(flag::K2_OUTSIDE, "K2"),
            lamp(flag::K3_OUTSIDE, "K3"),
            lamp(flag::OVER_LIMIT, text!("limit")),
            lamp(flag::CONTROL_OFF, text!("off")),
        ],
    },
    BlockInfo {
        block: Block::Override,
        id: "override",
        name: text!("Override limits"),
        models: &[],
        meaning: text!(
            "The CNC takes commands as percent of the programmed feed (DNCFRO) and speed \
                  (DNCSPO), within limits. What the controller asks beyond them is cut off; the \
                  lamp shows it. A real CNC takes whole percents and moves to a new override at \
                  a rate: both can be switched on."
        ),
        own: &[],
        of_machine: &[],
        settings: &[
            "cnc.override_min_percent",
            "cnc.override_max_percent",
            "cnc.override_quantised",
            "cnc.override_rate_limited",
            "cnc.override_rate_percent_s",
            "cnc.feed_max_mm_min",
            "cnc.speed_min_rpm",
            "cnc.speed_max_rpm",
        ],
        lamps: &[
            lamp(flag::FEED_SATURATED, text!("feed")),
            lamp(flag::SPEED_SATURATED, text!("speed")),
            lamp(flag::RATE_LIMITED, text!("rate")),
        ],
    },
    BlockInfo {
        block: Block::DeadTime,
        id: "dead_time",
        name: text!("Dead time"),
        models: &[],
        meaning: text!(
            "The PLC of the machine passes every command on after a fixed time. Each dot \
                  is one command under way; its height shows its size against the others."
        ),
        own: &[],
        of_machine: &[],
        settings: &["cnc.dead_time_s", "belief.dead_time_s"],
        lamps: &[],
    },
    BlockInfo {
        block: Block::FeedDrive,
        id: "feed_drive",
        name: text!("Feed drive"),
        models: &[],
        meaning: text!(
            "The servo system follows the command with the lag of its transfer function, \
                  computed exactly at every step."
        ),
        own: &[],
        of_machine: &[],
        settings: &["feed_drive.kind", "feed_drive.curve", "feed_drive.poles", "feed_drive.gain"],
        lamps: &[],
    },
    BlockInfo {
        block: Block::SpindleDrive,
        id: "spindle_drive",
        name: text!("Spindle drive"),
        models: &[],
        meaning: text!(
            "The spindle follows its command as a first-order lag that cannot change speed \
                  faster than its rate limit."
        ),
        own: &[],
        of_machine: &[],
        settings: &[
            "spindle_drive.time_constant_s",
            "spindle_drive.rate_rpm_s",
            "spindle_drive.curve",
            "spindle_drive.poles",
            "spindle_drive.gain",
        ],
        lamps: &[],
    },
    BlockInfo {
        block: Block::Cutting,
        id: "cutting",
        name: text!("Cutting process"),
        models: &[4],
        meaning: text!(
            "The true cut: maximum cutting force from feed and speed, times what the model \
                  does not know: material and hardness, cross-section of the cut, tool wear."
        ),
        own: &["radial_depth_mm", "used_life"],
        of_machine: &[],
        settings: &[
            "plant.material",
            "plant.hardness_hb",
            "plant.wear_factor",
            "plant.calibration",
            "formula.force",
            "formula.material",
            "formula.specific_force",
            "formula.specific_radial_force",
            "formula.specific_axial_force",
        ],
        lamps: &[
            lamp(flag::K4_OUTSIDE, "K4"),
            lamp(flag::TOOTH_BROKEN, text!("tooth")),
            lamp(flag::AIR, text!("air")),
        ],
    },
    BlockInfo {
        block: Block::Dynamic,
        id: "dynamic",
        name: text!("Dynamic component"),
        models: &[],
        meaning: text!(
            "What a real force adds to the model: band-limited noise, the ripple of the \
                  teeth, slow changes of the material along the path; each with its own seeded \
                  stream."
        ),
        own: &[],
        of_machine: &["vibration_um", "sound_mm_s"],
        settings: &["noise.level"],
        lamps: &[lamp(flag::LOST_CONTACT, text!("contact"))],
    },
    BlockInfo {
        block: Block::Dynamometer,
        id: "dynamometer",
        name: text!("Dynamometer"),
        models: &[],
        meaning: text!(
            "The force sensor: reads the dynamic force once per control period and adds \
                  its own noise. The controller sees only this."
        ),
        own: &[],
        of_machine: &[],
        settings: &["noise.level", "noise.sensor_n"],
        lamps: &[],
    },
    BlockInfo {
        block: Block::Surface,
        id: "surface",
        name: text!("Surface"),
        models: &[5],
        meaning: text!(
            "The roughness that the force leaves on the part, without machine dynamics. \
                  Identified models invert that of the reference exactly, so that a force held \
                  at its desired value leaves the desired roughness."
        ),
        own: &["ra_target_um"],
        of_machine: &[],
        settings: &["plant.model_set", "plant.calibration", "formula.ra"],
        lamps: &[lamp(flag::K5_OUTSIDE, "K5")],
    },
    BlockInfo {
        block: Block::SurfaceDynamic,
        id: "surface_dynamic",
        name: text!("Surface"),
        models: &[6],
        meaning: text!(
            "The roughness with machine dynamics: the same equation, fed with the force and \
                  its dynamic component."
        ),
        own: &["ra_target_um"],
        of_machine: &[],
        settings: &["plant.model_set", "plant.calibration", "formula.ra"],
        lamps: &[lamp(flag::K6_OUTSIDE, "K6")],
    },
];

impl Block {
    /// Its description.
    #[must_use]
    pub fn info(self) -> &'static BlockInfo {
        &BLOCKS[self as usize]
    }

    /// The wires that enter it, in signal order.
    pub fn inputs(self) -> impl Iterator<Item = Wire> {
        WIRES.into_iter().filter(move |wire| wire.to.contains(&self))
    }

    /// The wires that leave it, in signal order.
    pub fn outputs(self) -> impl Iterator<Item = Wire> {
        WIRES.into_iter().filter(move |wire| wire.from == Some(self))
    }

    /// Paths of the settings to look at: those of its box; of the controller also those of the kind in charge, and
    /// formulas of the models only where its law ends in them.
    pub fn settings(self, scenario: &Scenario) -> impl Iterator<Item = &'static str> {
        let kind = scenario.controller.kind;
        let group = (self == Self::Controller).then(|| kind.group());
        let of_kind = table().iter().filter(move |param| group == Some(param.group));
        let by_models = self != Self::Controller || kind.held() == Held::Roughness;
        let own = self.info().settings.iter().copied();
        let own = own.filter(move |path| by_models || !path.starts_with("formula."));
        // Gains are looked for more often than formulas of one's own, which stand last.
        let (formulas, first): (Vec<_>, Vec<_>) =
            own.partition(|path| path.starts_with("formula."));
        first.into_iter().chain(of_kind.map(|param| param.path.as_str())).chain(formulas)
    }

    /// Ids of the signals to look at: those that enter it, its own, and those that leave it, each once.
    #[must_use]
    pub fn signals(self, scenario: &Scenario) -> Vec<&'static str> {
        let info = self.info();
        let of_machine = if scenario.machine.coupled { info.of_machine } else { &[] };
        let on = |wire: Wire| wire.signal;
        let own = info.own.iter().chain(of_machine).copied();
        let mut signals = Vec::new();
        for id in self.inputs().map(on).chain(own).chain(self.outputs().map(on)) {
            if !signals.contains(&id) {
                signals.push(id);
            }
        }
        signals
    }
}

#[cfg(test)]
mod tests {
    use super::super::scenario::param;
    use super::super::signals::{FLAGS, SIGNALS, signal};
    use super::*;

    #[test]
    fn boxes_stand_in_the_order_of_the_blocks_and_name_known_signals_and_settings() {
        for (i, info) in BLOCKS.iter().enumerate() {
            assert_eq!(info.block as usize, i, "{}", info.name);
            let mut ids = info.own.iter().chain(info.of_machine);
            assert!(ids.all(|id| signal(id).is_some()), "{}", info.name);
            for path in info.settings {
                assert!(param(path).is_ok(), "{}: `{path}` is no setting", info.name);
            }
            assert!(info.block.inputs().next().is_some(), "nothing enters {}", info.name);
            assert!(info.block.outputs().next().is_some(), "nothing leaves {}", info.name);
        }
    }

    #[test]
    fn the_controllers_box_shows_what_the_kind_in_charge_is_tuned_with() {
        let scenario = crate::run::presets::load("table3-5").unwrap();
        let found: Vec<&str> = Block::Controller.settings(&scenario).collect();
        let formulas = ["formula.feed", "formula.speed"];
        assert_eq!(found, [&["controller.kind", "controller.sdnrp.kp"], &formulas[..]].concat());
        let kind = crate::blocks::control::ControllerKind::ConstantFeed;
        let constant = scenario.with(|s| s.controller.kind = kind).unwrap();
        assert!(Block::Controller.settings(&constant).all(|path| !formulas.contains(&path)));
        let found: Vec<&str> = Block::DeadTime.settings(&scenario).collect();
        assert_eq!(found, ["cnc.dead_time_s", "belief.dead_time_s"]);
    }

    #[test]
    fn every_signal_of_the_loop_is_in_the_diagram() {
        let of_boxes = || BLOCKS.iter().flat_map(|info| info.own.iter().chain(info.of_machine));
        for signal in SIGNALS {
            let on_wires = WIRES.iter().any(|wire| wire.signal == signal.id);
            let in_boxes = of_boxes().any(|id| *id == signal.id);
            let of_row = OF_THE_ROW.contains(&signal.id);
            assert!(on_wires || in_boxes || of_row, "`{}` is in no box and on no wire", signal.id);
            assert!(!(of_row && (on_wires || in_boxes)), "`{}` is of the row only", signal.id);
        }
    }

    #[test]
    fn every_flag_has_its_lamp() {
        let lamps = || BLOCKS.iter().flat_map(|info| info.lamps);
        for flag in FLAGS {
            let count = lamps().filter(|lamp| lamp.bits & flag.bit != 0).count();
            assert_eq!(count, 1, "{}", flag.label);
        }
    }
}
