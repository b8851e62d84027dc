//! The wires of the block diagram: which signal runs on each, from where to where, and how it is called.

use super::super::signals::{SignalInfo, signal};
use super::Block;
use super::Block::{
    Controller, Cutting, DeadTime, Dynamic, Dynamometer, FeedDrive, Override, Reference,
    SpindleDrive, Surface, SurfaceDynamic,
};

use crate::base::language::{text, tr};

/// A wire of the diagram.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Wire {
    /// Id of its signal.
    pub signal: &'static str,
    /// Its symbol in formulas: the short name where there is little room.
    pub symbol: &'static str,
    /// Whether it shows what left the dead-time queue, not what entered it.
    pub delayed: bool,
    /// The box that it leaves; `None` where it comes from outside.
    pub from: Option<Block>,
    /// The boxes that it enters; none where it is a result.
    pub to: &'static [Block],
}

const fn wire(
    signal: &'static str,
    symbol: &'static str,
    from: Option<Block>,
    to: &'static [Block],
) -> Wire {
    Wire { signal, symbol, delayed: false, from, to }
}

const fn delayed(signal: &'static str, symbol: &'static str, to: &'static [Block]) -> Wire {
    Wire { signal, symbol, delayed: true, from: Some(DeadTime), to }
}

/// Target roughness into the reference.
pub const TARGET: Wire = wire("ra_target_um", "Ra_{target}", None, &[Reference]);
/// Desired force to the controller.
pub const DESIRED_FORCE: Wire = wire("force_ref_n", "F_d", Some(Reference), &[Controller]);
/// Measured force back to the controller.
pub const MEASURED_FORCE: Wire = wire("force_measured_n", "F_m", Some(Dynamometer), &[Controller]);
/// Feed command in percent.
pub const FEED_OVERRIDE: Wire =
    wire("feed_override_percent", text!("feed"), Some(Controller), &[Override]);
/// Spindle command in percent.
pub const SPINDLE_OVERRIDE: Wire =
    wire("spindle_override_percent", text!("spindle"), Some(Controller), &[Override]);
/// Feed command into the dead time.
pub const FEED_COMMAND: Wire = wire("feed_command_mm_min", "f_c", Some(Override), &[DeadTime]);
/// Spindle command into the dead time.
pub const SPINDLE_COMMAND: Wire = wire("spindle_command_rpm", "n_c", Some(Override), &[DeadTime]);
/// Feed command out of the dead time.
pub const FEED_DELAYED: Wire = delayed("feed_command_mm_min", "f_c", &[FeedDrive]);
/// Spindle command out of the dead time.
pub const SPINDLE_DELAYED: Wire = delayed("spindle_command_rpm", "n_c", &[SpindleDrive]);
/// Actual feed.
pub const FEED: Wire = wire("feed_mm_min", "f_a", Some(FeedDrive), &[Cutting]);
/// Actual spindle speed.
pub const SPINDLE_SPEED: Wire = wire("spindle_rpm", "n_a", Some(SpindleDrive), &[Cutting]);
/// Axial depth of cut at the tool.
pub const AXIAL_DEPTH: Wire = wire("axial_depth_mm", "A_D", None, &[Cutting]);
/// Cutting force.
pub const FORCE: Wire = wire("force_n", "F", Some(Cutting), &[Dynamic, Surface]);
/// Cutting force with its dynamic component.
pub const FORCE_DYNAMIC: Wire =
    wire("force_dyn_n", "F_{dyn}", Some(Dynamic), &[Dynamometer, SurfaceDynamic]);
/// Produced roughness.
pub const RA: Wire = wire("ra_um", "Ra", Some(Surface), &[]);
/// Produced roughness with dynamics.
pub const RA_DYNAMIC: Wire = wire("ra_dyn_um", "Ra_{dyn}", Some(SurfaceDynamic), &[]);

/// All wires, in signal order.
pub const WIRES: [Wire; 16] = [
    TARGET,
    DESIRED_FORCE,
    FEED_OVERRIDE,
    SPINDLE_OVERRIDE,
    FEED_COMMAND,
    SPINDLE_COMMAND,
    FEED_DELAYED,
    SPINDLE_DELAYED,
    FEED,
    SPINDLE_SPEED,
    AXIAL_DEPTH,
    FORCE,
    FORCE_DYNAMIC,
    MEASURED_FORCE,
    RA,
    RA_DYNAMIC,
];

impl Wire {
    /// The table entry of its signal.
    ///
    /// # Panics
    /// Never: a test looks up all wires.
    #[must_use]
    pub fn info(self) -> &'static SignalInfo {
        signal(self.signal).expect("a test looks up all wires")
    }

    /// What its signal is called here.
    #[must_use]
    pub fn name(self) -> String {
        let signal = tr(self.info().label);
        if self.delayed {
            tr!("{signal}, after dead time", signal = signal)
        } else {
            signal.to_owned()
        }
    }

    /// Its symbol in plain text, with a unit of percent and with what the queue did.
    #[must_use]
    pub fn plain_symbol(self) -> String {
        let symbol = tr(self.symbol).replace(['{', '}'], "");
        let unit = if self.info().unit == "%" { " %" } else { "" };
        let symbol = format!("{symbol}{unit}");
        if self.delayed { tr!("{symbol} delayed", symbol = symbol) } else { symbol }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_wire_carries_a_known_signal_and_has_its_own_name() {
        let names: std::collections::BTreeSet<String> =
            WIRES.iter().map(|wire| wire.name()).collect();
        assert_eq!(names.len(), WIRES.len());
    }
}
