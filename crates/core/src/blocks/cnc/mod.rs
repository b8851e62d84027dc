//! The CNC: overrides ([`feed_override`]), the dead time of its PLC ([`dead_time`]), feed drive and spindle
//! drive.

pub mod dead_time;
pub mod feed_drive;
pub mod feed_override;
pub mod spindle_drive;
