//! The CNC ([`channel`]): overrides ([`feed_override`]), the dead time of its PLC ([`dead_time`]), overload guard
//! ([`overload`]), feed drive and spindle drive.

pub mod channel;
pub mod dead_time;
pub mod feed_drive;
pub mod feed_override;
pub mod limits;
pub mod overload;
pub mod spindle_drive;
