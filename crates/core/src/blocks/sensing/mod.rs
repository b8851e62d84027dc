//! Sensing: the dynamic component of the force and the dynamometer.

pub mod dynamic_force;
pub mod dynamometer;
pub mod field;
pub mod peak;
pub mod tool_condition;
