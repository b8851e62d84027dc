//! The CNC: overrides, the dead time of its PLC, feed drive and spindle drive.

pub mod dead_time;
pub mod feed_drive;
pub mod feed_override;
pub mod spindle_drive;
