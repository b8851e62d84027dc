//! Sensing: the force sensors, and what the sound tells of the tool.

pub mod dynamometer;
pub mod peak;
pub mod tool_condition;
